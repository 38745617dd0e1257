/// Surface: triangles with their edges and corners, and the contacts of a ball with them.
///
///   face     g = n·(c − p) − R             c over the triangle
///   edge     g = |c − p| − R               c in the wedge between the faces' normals
///   corner   g = |c − p| − R               c in the cone of the normals around it
///
/// These are the local minima of the distance. Hence a ball that rolls over a flat part does not
/// meet the edges between its triangles, and a ball in a valley touches two faces. Edges between
/// coplanar faces and concave edges are no features. Faces are found by a tree of bounding boxes,
/// which is built once, since the surface is fixed in its frame.
#pragma once
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>

namespace dynamy {

/// Contact of a ball with a surface, numbered: faces, then edges, then corners.
using SurfaceContact = NumberedContact;
inline constexpr int kMostSurfaceContacts = 12;
using SurfaceContacts = std::array<SurfaceContact, kMostSurfaceContacts>;

class Surface {
 public:
  /// `corners`: three per triangle, in axes of the frame that carries the surface; corners at the
  /// same place are merged. `closed`: the triangles enclose a convex body, inside of which the
  /// nearest face counts.
  Surface(const std::vector<Vec3>& corners, bool closed);
  const std::vector<Vec3>& points() const { return points_; }
  int features() const { return static_cast<int>(faces_.size() + edges_.size() + corners_.size()); }
  /// Name of contact `id`.
  std::string featureName(int id) const;
  /// Finds the contacts of the ball of B with gaps up to `reach` [m]; returns their number. At most
  /// the first kMostSurfaceContacts are kept.
  int contacts(const Frame& A, const Frame& B, const RoundFeature& ball, double reach,
               SurfaceContacts& out) const;

  struct Face {
    std::array<int, 3> v;
    Vec3 n;
    std::array<Vec3, 3> out;  ///< in the plane of the face, outward across the edge from v[i]
    std::array<int, 3> edge{-1, -1, -1}, corner{-1, -1, -1};  ///< assigned to it
    std::array<int, 3> rises{-1, -1, -1};  ///< neighbour that rises across the edge from v[i]
  };
  struct Edge {
    int a, b, f, g;  ///< corners a, b, faces f, g; g = −1: border of the surface
    int sideF, sideG;
  };
  struct Corner {
    int v;
    std::vector<int> others, faces;  ///< `others`: corners at the far ends of its edges
  };
  const std::vector<Face>& faces() const { return faces_; }
  const Edge& edge(int i) const { return edges_[static_cast<std::size_t>(i)]; }
  const Corner& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }
  int edges() const { return static_cast<int>(edges_.size()); }
  int corners() const { return static_cast<int>(corners_.size()); }
  const Vec3& at(int i) const { return points_[static_cast<std::size_t>(i)]; }
  /// Is p over the face, or up to `beside` beside it [m]? Below a valley p is over both faces that it
  /// lies below, although its nearest points on their planes are beyond the edge: over the one, and
  /// beside the other across their edge only.
  bool isOver(const Face& f, const Vec3& p, double beside) const;
  /// Is `way`, a vector from edge i to some point, in the wedge between the normals of its faces?
  bool inWedge(int i, const Vec3& way) const;
  /// Is `way`, a vector from corner i to some point, in the cone of the normals around it?
  bool inCone(int i, const Vec3& way) const;
  /// Calls f with the number of every face in a leaf of the tree whose
  /// bounding box intersects `box`.
  template <class F>
  void forFacesNear(const Eigen::AlignedBox3d& box, F&& f) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    int first = 0, count = 0;  ///< faces of a leaf, in `order_`
    int right = -1;            ///< right child, −1: leaf; the left child is the next node
  };
  struct Query;
  void findEdges();
  void findCorners();
  int build(int first, int count);
  void lookAt(int face, Query& q) const;

  std::vector<Vec3> points_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;      ///< convex edges and borders
  std::vector<Corner> corners_;  ///< corners that stand out
  std::vector<int> order_;       ///< face numbers in the order of the leaves
  std::vector<Node> nodes_;
  bool closed_;
};

/// Capacity of the stack of nodes; deeper branches of the tree are not followed.
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
