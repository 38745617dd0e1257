/// Contacts of a shape that a plug-in brings. The shape names its family; the family names the
/// function that finds the contact with each other family.
///
///   g       gap of a and b, below 0 where they overlap
///   n       unit normal from a to b at the contact
///   P       point of contact:   ġ = n·(v_b(P) − v_a(P)),   v: velocities of body points
///   ṅ, Ṗ    rates of n and P, from which a scheme that works to a tolerance finds g̈
///
/// One function serves fixed steps, steps to a tolerance, which follow g, and fast bodies, whose g
/// is watched along their path. The gap must move with the bodies without jumps. Pairs exist for
/// bodies in space.
///
/// Rejected: families as numbers or words in a registry. The object is its own name, and a model
/// made in C++ has the same pairs as one from a file.
#pragma once
#include <dynamy/system/frame.hpp>
#include <dynamy/system/shape.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// One contact of the shapes a and b.
struct PairContact {
  double g = 0.0;                                 ///< [m]
  Vec3 n = Vec3::UnitZ(), P = Vec3::Zero();       ///< P [m]
  Vec3 ndot = Vec3::Zero(), Pdot = Vec3::Zero();  ///< [1/s], [m/s]
};

/// A shape at its place; all components in I.
struct ShapeAt {
  const Shape& shape;
  const Frame& frame;     ///< that carries it
  Vec3 c = Vec3::Zero();  ///< origin of the shape's axes [m]; of a half space: in its plane
  Vec3 n = Vec3::Zero();  ///< of a half space: its outward unit normal
  double radius = 0.0;    ///< of a ball [m]

  /// Velocity of c [m/s].
  Vec3 v() const { return frame.velocity(c - frame.r_OS_I); }
  /// Axes of the shape in I: column k is the direction of its axis k.
  Mat3 axes() const { return frame.A_IK * shape.A_KB(); }
};

struct ShapeFamily;

/// How the shapes of a family touch those of another.
struct ShapePair {
  const ShapeFamily* other;  ///< a; borrowed
  /// Contact number `feature` of `a`, a shape of `other`, with `b`, a shape of the family that
  /// names this pair. Called at every instant: it neither throws nor allocates.
  PairContact (*contact)(const ShapeAt& a, const ShapeAt& b, int feature);
  int contacts = 1;  ///< how many contacts two such shapes have, ≥ 1
};

/// Shapes that touch others in the same way. Two families are the same if they are one object; it
/// lives as long as its library. Of two families, one names their pair: a model in which both do
/// is refused with a ModelError.
struct ShapeFamily {
  std::string name;  ///< for messages
  std::vector<ShapePair> pairs;

  static const ShapeFamily halfSpace;
  static const ShapeFamily ball;  ///< spheres, and points with radius 0
};

}  // namespace dynamy
