#pragma once
/// \file
/// The scene that a replay draws: named frames with one pose each, and shapes fixed to them. It is
/// plain data, filled once from the model. Shapes refer to frames by index and are stored once; a
/// frame of the film holds poses only. Rejected: triangle meshes for all shapes, because a sphere
/// given by its radius stays round.

#include <array>
#include <dynamy/io/files/json_writer.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// A frame K that moves with a body; frame i has pose i in frames.bin.
struct SceneFrame {
  std::string name;   ///< path of the element, e.g. "toy/beak"
  std::string place;  ///< "file:line" of the element that made it; may be empty
};

enum class ShapeKind {
  sphere,     ///< radius
  box,        ///< halfExtents along the local axes
  capsule,    ///< radius, halfLength of the axis along local z, caps outside of it
  cylinder,   ///< radius, halfLength along local z
  circle,     ///< disc of radius in the local x–y plane
  halfspace,  ///< matter below the local x–y plane; local z is the outward normal
  segment,    ///< line through points[0], points[1], …; radius > 0: its thickness is 2 radius
  polygon,    ///< filled area with the corners points[0], …, plane and convex
  ellipsoid,  ///< halfExtents: its semi-axes
  torus,      ///< radius of the circle about the local z, tube
  cone,       ///< radius of the base at local z = 0, halfLength: half of the height of its tip
  mesh,       ///< points and triangles of them, counterclockwise from outside
  link        ///< from points[0] in frame to points[1] in frameEnd: rods, ropes, springs
};

/// A shape in the frame S, fixed to frame K = frames[frame], or to the inertial frame I (frame =
/// -1).
struct SceneShape {
  ShapeKind kind = ShapeKind::sphere;
  std::string name;
  int frame = -1;
  std::array<double, 3> position{0, 0, 0};        ///< r_KS_K [m]
  std::array<double, 4> orientation{1, 0, 0, 0};  ///< unit quaternion w x y z of A_KS
  double radius = 0;                              ///< [m]
  double tube = 0;                                ///< of a torus: radius of its tube [m]
  double halfLength = 0;                          ///< [m]
  std::array<double, 3> halfExtents{0, 0, 0};     ///< [m]
  std::vector<std::array<double, 3>> points{};    ///< in S [m]
  std::vector<std::array<int, 3>> triangles{};    ///< of a mesh: indices of points
  int frameEnd = -1;                              ///< of a link: the frame of points[1]
  std::string colour{};  ///< "#rrggbb"; empty: the viewer chooses one a frame
  std::string style{};   ///< of a link or segment: "", "dashed" or "spring"
};

/// Everything that is drawn, and the view.
struct Scene {
  std::string view;  ///< "xy", "xz", "yz" (axes to the right and up), "iso"; empty: by the motion
  int follow = -1;   ///< frame that the view moves with; −1: the view stands
  std::vector<SceneFrame> frames;
  std::vector<SceneShape> shapes;
};

/// Writes `scene` as one JSON object; members without meaning for a kind are left out.
void write(JsonWriter& json, const Scene& scene);

}  // namespace dynamy
