/// Grain: a direction g fixed in one of two shapes that touch, along which friction differs; the
/// first tangent of their contacts is its image in the plane of contact.
///
///   p = g − (n·g) n,   t1 = p/|p|,   t2 = n × t1                                     (theory 9.4)
///   ṗ = ġ − (ṅ·g + n·ġ) n − (n·g) ṅ,   ġ = Ω × g,   ṫ1 = (ṗ − (t1·ṗ) t1)/|p|
///
/// Rejected: a direction in the law or in the rule of two materials. Which of two bodies carries it
/// is no property of a pair, and two shapes of a body may have different ones.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>
#include <dynamy_elements/contacts/search/meeting.hpp>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>
#include <string>

namespace dynamy {

/// Turns the tangents of `at`. A grain that stands on the plane of contact has no image there: the
/// tangents stay what they are.
void alongGrain(ContactPoint& at, const Vec3& grain_I, const Vec3& Omega_I);

/// Whether the friction of a law differs by direction, so that it matters which the tangents are.
bool differsByDirection(const SetValuedForceLaw& law, int rows);

/// Why the law cannot be taken with the grains of two shapes; empty: it can.
struct GrainFault {
  std::string text, hint;
};
GrainFault grainFault(const TouchingShape& a, const TouchingShape& b, Meeting meets,
                      const SetValuedForceLaw& law, int rows);

}  // namespace dynamy
