/// Grain: a direction g fixed in one of two touching shapes, along which friction differs. The
/// first tangent of their contacts is the projection of g onto the plane of contact.
///
///   p = g − (n·g) n,   t1 = p/|p|,   t2 = n × t1                                     (theory 9.4)
///   ṗ = ġ − (ṅ·g + n·ġ) n − (n·g) ṅ,   ġ = Ω × g,   ṫ1 = (ṗ − (t1·ṗ) t1)/|p|
///
/// Rejected: a direction in the law or in the rule of two materials. Which of two
/// bodies carries the grain is not a property of a pair of materials, and two shapes of
/// a body may have different grains.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>
#include <string>

namespace dynamy {

/// Turns the tangents of `at` along the grain. They are kept if the grain is normal to the plane of
/// contact, where it has no projection.
void alongGrain(ContactPoint& at, const Vec3& grain_I, const Vec3& Omega_I);

/// Does the friction of a law depend on the direction of sliding, so that
/// the choice of tangents matters?
bool differsByDirection(const SetValuedForceLaw& law, int rows);

/// Why a law cannot be used with the grains of two shapes; an empty text means that it can.
struct GrainFault {
  std::string text, hint;
};
GrainFault grainFault(const TouchingShape& a, const TouchingShape& b, const SetValuedForceLaw& law,
                      int rows);

}  // namespace dynamy
