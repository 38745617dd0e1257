/// Surface: triangles with their edges and corners, and where a ball touches them.
///
///   face     g = n·(c − p) − R             c over the triangle
///   edge     g = |c − p| − R               c in the wedge between the faces' normals
///   corner   g = |c − p| − R               c in the cone of the normals around it
///
/// These are the local minima of the distance, so that a ball rolling over a flat part meets the
/// edges between its triangles nowhere, and one in a valley two faces. Edges between faces in one
/// plane and those that go in are none. Faces are found by a tree of boxes, made once: the surface
/// is fixed in its frame.
#pragma once
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

/// Numbers: faces, then edges, then corners.
using SurfaceContact = NumberedContact;
inline constexpr int kMostSurfaceContacts = 12;
using SurfaceContacts = std::array<SurfaceContact, kMostSurfaceContacts>;

class Surface {
 public:
  /// Triangles, three corners to each, in axes of the frame that carries them; corners at the same
  /// place are one. `closed`: of a convex body, inside of which the nearest face counts.
  Surface(const std::vector<Vec3>& corners, bool closed);
  const std::vector<Vec3>& points() const { return points_; }
  int features() const { return static_cast<int>(faces_.size() + edges_.size() + corners_.size()); }
  /// Name of contact `id`.
  std::string featureName(int id) const;
  /// Contacts of the ball of B with gaps up to `reach`; returns how many, the first
  /// kMostSurfaceContacts at most.
  int contacts(const Frame& A, const Frame& B, const RoundFeature& ball, double reach,
               SurfaceContacts& out) const;

  struct Face {
    std::array<int, 3> v;
    Vec3 n;
    std::array<Vec3, 3> out;  ///< in the face, out of it across the edge from v[i]
    std::array<int, 3> edge{-1, -1, -1}, corner{-1, -1, -1};  ///< those it looks after
  };
  struct Edge {
    int a, b, f, g;  ///< corners, faces; g −1: none
    int sideF, sideG;
  };
  struct Corner {
    int v;
    std::vector<int> others, faces;  ///< at the other ends of its edges
  };
  const std::vector<Face>& faces() const { return faces_; }
  const Edge& edge(int i) const { return edges_[static_cast<std::size_t>(i)]; }
  const Corner& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }
  int edges() const { return static_cast<int>(edges_.size()); }
  int corners() const { return static_cast<int>(corners_.size()); }
  const Vec3& at(int i) const { return points_[static_cast<std::size_t>(i)]; }
  /// Is `way`, from edge i to somewhere, in the wedge between the normals of its faces?
  bool inWedge(int i, const Vec3& way) const;
  /// Is `way` in the cone of the normals around corner i?
  bool inCone(int i, const Vec3& way) const;
  /// Calls f for the number of every face in whose box, or that of its neighbours in the tree,
  /// `box` reaches.
  template <class F>
  void forFacesNear(const Eigen::AlignedBox3d& box, F&& f) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0, count = 0;  ///< faces of a leaf
    int right = -1;            ///< the left one follows
  };
  struct Query;
  void findEdges();
  void findCorners();
  int build(int first, int count);
  void lookAt(int face, Query& q) const;

  std::vector<Vec3> points_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;      ///< that stand out
  std::vector<Corner> corners_;  ///< that stand out
  std::vector<int> order_;       ///< of the faces, as the leaves have them
  std::vector<Node> nodes_;
  bool closed_;
};

/// Deepest branch of the tree that is followed.
inline constexpr int kDeepestBranch = 64;

template <class F>
void Surface::forFacesNear(const Eigen::AlignedBox3d& box, F&& f) const {
  int stack[kDeepestBranch], top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const int number = stack[--top];
    const Node& node = nodes_[static_cast<std::size_t>(number)];
    if (!node.box.intersects(box)) continue;
    if (node.right < 0) {
      for (int i = 0; i < node.count; ++i) f(order_[static_cast<std::size_t>(node.first + i)]);
    } else if (top + 2 <= kDeepestBranch) {
      stack[top++] = node.right, stack[top++] = number + 1;
    }
  }
}

}  // namespace dynamy
