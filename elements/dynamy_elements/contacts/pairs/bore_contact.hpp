/// Contacts inside of a bore: the wall r = R of a hole about the axis a, |z| ≤ half its length.
///
///   ball, centre c      g = R − |c⊥| − r                      c⊥: across the axis, from the axis
///                       beyond an end: from its edge, a circle of radius R
///   cylinder            at each end of the common length: its rim on the wall, or the edge of the
///                       bore on its side, whichever ends first
///
/// A rim or edge is a circle x(φ) = c + ρ (cos φ e₁ + sin φ e₂). It touches where its distance from
/// the axis of the other one is extreme,
///
///   y·x′ = 0,   y = (I − a aᵀ)(x − o):   largest for a rim in a bore, g = R − |y|,
///                                        least for an edge around a cylinder, g = |y| − r
///
/// With e₁ across both axes this is the point of an ellipse that is furthest from, or nearest to, a
/// point. A cylinder that lies across a bore touches with two points of each rim.
#pragma once
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

/// Most contacts of a cylinder in a bore. Numbers: 0, 1 at the end of the bore at −z, +z; 2, 3 the
/// second points of rims there.
inline constexpr int kMostBoreContacts = 4;
using BoreContacts = std::array<NumberedContact, kMostBoreContacts>;

/// Contact of a round feature of B with the wall of the bore A. In a plane of motion (normal
/// `plane`) the bore has no ends. False: the ball is outside, where the bore is not.
bool ballInBore(const Frame& A, const TouchingShape& bore, const Frame& B, const RoundFeature& ball,
                const Vec3& plane, ContactPoint& out);
/// Contacts of the cylinder of B in the bore A, in space; returns how many.
int cylinderInBore(const Frame& A, const TouchingShape& bore, const Frame& B,
                   const TouchingShape& cylinder, BoreContacts& out);

}  // namespace dynamy
