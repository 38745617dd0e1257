/// Polyhedron: a convex body given by its polygonal faces, edges and corners, for contact.
#pragma once
#include <array>
#include <dynamy/core/types.hpp>
#include <vector>

namespace dynamy {

class Polyhedron {
 public:
  /// A polygonal face, corners counterclockwise seen from outside; the body is in { n·x ≤ height }.
  struct Face {
    Vec3 n;
    double height = 0.0;  ///< height of its plane over the origin [m]
    int first = 0;        ///< index of its first border
    int count = 0;
  };
  /// A side of a face, from one corner to the next.
  struct Border {
    int corner = 0, edge = 0;
    Vec3 out;  ///< in the plane of the face, pointing out of it
  };
  /// An edge, where the faces f and g meet; n_f × n_g points along e.
  struct Edge {
    int f = 0, g = 0;
    Vec3 middle, e;  ///< [m], unit direction
    double half = 0.0;
  };

  /// The same vectors with an array for each coordinate: their products with one vector are
  /// computed side by side.
  struct Columns {
    std::vector<double> x, y, z;
    void add(const Vec3& v) { x.push_back(v.x()), y.push_back(v.y()), z.push_back(v.z()); }
    std::size_t size() const { return x.size(); }
  };

  /// Builds it from the triangles of a convex hull, three points per triangle, counterclockwise
  /// seen from outside. Triangles in one plane are merged into one face.
  explicit Polyhedron(const std::vector<Vec3>& triangles);

  const std::vector<Vec3>& corners() const { return corners_; }
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Edge>& edges() const { return edges_; }
  /// Border i; the borders of a face are i = first … first + count − 1.
  const Border& border(int i) const { return borders_[static_cast<std::size_t>(i)]; }
  const Vec3& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }
  const Face& face(int i) const { return faces_[static_cast<std::size_t>(i)]; }
  const Edge& edge(int i) const { return edges_[static_cast<std::size_t>(i)]; }
  /// The faces that meet in a corner.
  const std::vector<int>& facesAt(int corner) const {
    return facesAt_[static_cast<std::size_t>(corner)];
  }
  /// The corners at the other ends of the edges that meet in a corner.
  const std::vector<int>& neighbours(int corner) const {
    return neighbours_[static_cast<std::size_t>(corner)];
  }
  /// Is p over the face f, or at most `beside` [m] outside of its borders?
  bool over(const Face& f, const Vec3& p, double beside) const;
  /// Half of the least width across a face [m].
  double halfWidth() const { return halfWidth_; }
  const Vec3& middle() const { return middle_; }  ///< mean of the corners, inside the body
  const Columns& cornerColumns() const { return cornerColumns_; }
  const Columns& normalColumns() const { return normalColumns_; }
  /// Largest distance of a corner from the origin [m].
  double radius() const { return radius_; }
  /// Where faces meet in an edge or corner, every direction between their normals is a sum of parts
  /// α_i n_i, α_i ≥ 0, of a length of at least this times Σ α_i; 0: no such bound.
  double together() const { return together_; }

 private:
  void addFace(const Vec3& n, const std::vector<std::array<int, 2>>& sides);
  void findEdges();
  void measure();

  std::vector<Vec3> corners_;
  std::vector<Face> faces_;
  std::vector<Border> borders_;
  std::vector<Edge> edges_;
  std::vector<std::vector<int>> facesAt_, neighbours_;
  Columns cornerColumns_, normalColumns_;
  Vec3 middle_ = Vec3::Zero();
  double halfWidth_ = 0.0, radius_ = 0.0, together_ = 1.0;
};

/// Twelve triangles of the box with these half edge lengths about the origin, three points each.
std::vector<Vec3> boxTriangles(const Vec3& half);

}  // namespace dynamy
