/// Meeting: the table of the kinds of contact that two kinds of shapes can have.
#pragma once
#include <array>
#include <cstdint>
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>
#include <limits>

namespace dynamy {

enum class Meeting : std::uint8_t {
  never,          ///< two half spaces, or two points
  missing,        ///< not implemented
  overHalfSpace,  ///< features of B over the half space A
  balls,
  ballOnBox,  ///< ball B on box A
  ballOnCapsule,
  ballOnCylinder,
  ballOnCone,
  capsules,
  capsuleOnBox,
  ballOnSurface,  ///< of a polyhedron, mesh or height field
  capsuleOnSurface,
  boxes,
  polyhedra,         ///< one of them may be a box
  polyhedronOnMesh,  ///< or a box on a mesh
  polygons,          ///< and sections with corners, in a plane
  ballOnPolygon,
  capsuleOnPolygon,
  smoothInPlane,    ///< ellipses with each other and with circles
  smoothOnPolygon,  ///< ellipse
  capsuleOnSmooth,  ///< on an ellipse
  ballOnContour,
  smooth,              ///< ellipsoids with each other and with balls
  smoothOnPolyhedron,  ///< or on a box
  smoothOnDisc,        ///< A on B, a cylinder, cone, torus or capsule
  smoothOnMesh,        ///< or a height field
  discOnPolyhedron,    ///< a cylinder, torus or cone; also on a box
  discOnMesh,          ///< or a height field
  discs                ///< cylinders, cones and tori with each other, with capsules and balls
};

/// Kind of contact of A with B. The kind of A comes later in
/// TouchingShape::Kind, or both are equal.
Meeting meeting(const TouchingShape& A, const TouchingShape& B, bool inPlane);

/// All properties of a shape on which the functions of this file and friction along a grain depend.
/// A contact rule found for two shapes holds for all pairs of shapes with the same traits.
using Traits = std::array<std::uint64_t, 15>;
Traits traits(const TouchingShape& s);

/// How many contacts two shapes may make, numbered from 0.
std::uint64_t featuresOf(Meeting meets, const TouchingShape& A, const TouchingShape& B);

/// How many of the contacts of two shapes, the last ones, are pairs of
/// features followed one by one.
std::uint64_t followedOf(Meeting meets, const TouchingShape& A, const TouchingShape& B);

/// Name of contact number f of two shapes; empty if it is their only contact.
std::string featureName(Meeting meets, const TouchingShape& A, const TouchingShape& B,
                        std::uint64_t f);

}  // namespace dynamy
