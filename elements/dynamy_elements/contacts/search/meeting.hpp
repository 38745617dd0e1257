/// Which contact two kinds of shapes make: the table of pairs.
#pragma once
#include <array>
#include <cstdint>
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>
#include <limits>

namespace dynamy {

enum class Meeting : std::uint8_t {
  never,          ///< half spaces do not meet, points neither
  missing,        ///< not implemented
  overHalfSpace,  ///< features of B over the half space A
  balls,
  ballOnBox,  ///< B on A
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
  discOnPolyhedron,    ///< a cylinder, torus or cone, or on a box
  discOnMesh,          ///< or a height field
  discs                ///< cylinders, cones and tori with each other, with capsules and balls
};

/// Of A with B, A of the kind that comes later in TouchingShape::Kind or of the same.
Meeting meeting(const TouchingShape& A, const TouchingShape& B, bool inPlane);

/// All that the functions of this page, and friction along a grain, ask of a shape: what two shapes do
/// holds for all pairs of shapes with their traits.
using Traits = std::array<std::uint64_t, 15>;
Traits traits(const TouchingShape& s);

/// How many contacts two shapes may make, numbered from 0.
std::uint64_t featuresOf(Meeting meets, const TouchingShape& A, const TouchingShape& B);

/// How many of these, the last ones, are pairs of features that are followed one by one.
std::uint64_t followedOf(Meeting meets, const TouchingShape& A, const TouchingShape& B);

/// Name of contact number f of the two; empty: there is only one.
std::string featureName(Meeting meets, const TouchingShape& A, const TouchingShape& B,
                        std::uint64_t f);

}  // namespace dynamy
