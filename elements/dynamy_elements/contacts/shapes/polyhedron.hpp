/// Polyhedron: convex body by its polygons, edges and corners, as contact needs them.
#pragma once
#include <array>
#include <dynamy/core/types.hpp>
#include <vector>

namespace dynamy {

class Polyhedron {
 public:
  /// A polygon, corners counterclockwise from outside; its inside is { n·x ≤ height }.
  struct Face {
    Vec3 n;
    double height = 0.0;  ///< of its plane over the origin [m]
    int first = 0;        ///< its corners, and the borders from each to the next
    int count = 0;
  };
  /// A side of a face, from one corner to the next.
  struct Border {
    int corner = 0, edge = 0;
    Vec3 out;  ///< in the face, away from it
  };
  /// Where two faces meet; n_f × n_g points along e.
  struct Edge {
    int f = 0, g = 0;
    Vec3 middle, e;  ///< [m], unit direction
    double half = 0.0;
  };

  /// From the triangles of a convex hull, three points to each, counterclockwise from outside.
  /// Triangles in one plane are one face.
  explicit Polyhedron(const std::vector<Vec3>& triangles);

  const std::vector<Vec3>& corners() const { return corners_; }
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Edge>& edges() const { return edges_; }
  /// Border i = first … first + count − 1 of a face.
  const Border& border(int i) const { return borders_[static_cast<std::size_t>(i)]; }
  const Vec3& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }
  const Face& face(int i) const { return faces_[static_cast<std::size_t>(i)]; }
  const Edge& edge(int i) const { return edges_[static_cast<std::size_t>(i)]; }
  /// Faces around a corner.
  const std::vector<int>& facesAt(int corner) const {
    return facesAt_[static_cast<std::size_t>(corner)];
  }
  /// Corners at the other ends of its edges.
  const std::vector<int>& neighbours(int corner) const {
    return neighbours_[static_cast<std::size_t>(corner)];
  }
  /// Is p over the face, or at most `beside` [m] next to it?
  bool over(const Face& f, const Vec3& p, double beside) const;
  /// Half of the least width across a face [m].
  double halfWidth() const { return halfWidth_; }

 private:
  void addFace(const Vec3& n, const std::vector<std::array<int, 2>>& sides);
  void findEdges();

  std::vector<Vec3> corners_;
  std::vector<Face> faces_;
  std::vector<Border> borders_;
  std::vector<Edge> edges_;
  std::vector<std::vector<int>> facesAt_, neighbours_;
  double halfWidth_ = 0.0;
};

/// Twelve triangles of the box with these half edge lengths about the origin, three points each.
std::vector<Vec3> boxTriangles(const Vec3& half);

}  // namespace dynamy
