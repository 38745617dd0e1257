#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/shapes/surface.hpp>
#include <map>
#include <numeric>
#include <set>

namespace dynamy {
namespace {

/// Sine of the angle between faces up to which they count as coplanar.
constexpr double kSamePlane = 1e-9;
/// Part of the extent by which a point beside a face still counts as over it, so that no point
/// falls between two faces.
constexpr double kBesideFace = 1e-12;
/// Depth of a ball's centre below a face, in radii, up to which it has come from above.
constexpr double kOwnSize = 1.5;
/// Most faces of a leaf.
constexpr int kLeaf = 4;

}  // namespace

Surface::Surface(const std::vector<Vec3>& corners, bool closed) : closed_(closed) {
  std::map<std::array<double, 3>, int> known;
  std::vector<int> number;
  for (const Vec3& p : corners) {
    const auto [at, isNew] =
        known.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(points_.size()));
    if (isNew) points_.push_back(p);
    number.push_back(at->second);
  }
  for (std::size_t i = 0; i + 2 < number.size(); i += 3) {
    const std::array<int, 3> t{number[i], number[i + 1], number[i + 2]};
    Face f;
    f.v = t;
    f.n = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).normalized();
    for (std::size_t k = 0; k < 3; ++k)
      f.out[k] = (at(t[(k + 1) % 3]) - at(t[k])).cross(f.n).normalized();
    faces_.push_back(f);
  }
  findEdges();
  findCorners();
  order_.resize(faces_.size());
  std::iota(order_.begin(), order_.end(), 0);
  build(0, static_cast<int>(faces_.size()));
}

void Surface::findEdges() {
  std::map<std::pair<int, int>, std::pair<int, int>> sides;  // directed edge: face, its side
  for (std::size_t i = 0; i < faces_.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      sides[{faces_[i].v[k], faces_[i].v[(k + 1) % 3]}] = {static_cast<int>(i),
                                                           static_cast<int>(k)};
  for (const auto& [ends, here] : sides) {
    const auto there = sides.find({ends.second, ends.first});
    const bool border = there == sides.end();
    if (!border && ends.second < ends.first) continue;  // the edge is handled from its other side
    Edge e{ends.first,  ends.second,
           here.first,  border ? -1 : there->second.first,
           here.second, border ? -1 : there->second.second};
    Face& f = faces_[static_cast<std::size_t>(e.f)];
    // The edge stands out only if the neighbour face descends on its other side.
    if (!border) {
      Face& g = faces_[static_cast<std::size_t>(e.g)];
      const double descends = g.n.dot(f.out[static_cast<std::size_t>(e.sideF)]);
      if (descends < -kSamePlane)
        f.rises[static_cast<std::size_t>(e.sideF)] = e.g,
        g.rises[static_cast<std::size_t>(e.sideG)] = e.f;
      if (descends <= kSamePlane) continue;
    }
    f.edge[static_cast<std::size_t>(e.sideF)] = static_cast<int>(edges_.size());
    edges_.push_back(e);
  }
}

/// Finds the corners at which two or more edges stand out that do not form one line.
void Surface::findCorners() {
  std::map<int, std::set<int>> neighbours;
  std::map<int, std::vector<int>> facesOf;
  std::map<int, std::vector<Vec3>> standOut;  // directions of the edges
  for (std::size_t i = 0; i < faces_.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = faces_[i].v[k];
      neighbours[v].insert(faces_[i].v[(k + 1) % 3]);
      neighbours[v].insert(faces_[i].v[(k + 2) % 3]);
      facesOf[v].push_back(static_cast<int>(i));
    }
  for (const Edge& e : edges_) {
    const Vec3 along = (at(e.b) - at(e.a)).normalized();
    standOut[e.a].push_back(along), standOut[e.b].emplace_back(-along);
  }
  for (const auto& [v, others] : neighbours) {
    const std::vector<Vec3>& out = standOut[v];
    const bool oneLine =
        out.size() == 2 && out[0].dot(out[1]) < 0.0 && out[0].cross(out[1]).norm() <= kSamePlane;
    if (out.size() < 2 || oneLine) continue;
    Corner c{v, {others.begin(), others.end()}, facesOf[v]};
    Face& face = faces_[static_cast<std::size_t>(c.faces.front())];
    for (std::size_t k = 0; k < 3; ++k)
      if (face.v[k] == v) face.corner[k] = static_cast<int>(corners_.size());
    corners_.push_back(std::move(c));
  }
}

/// Builds a node of the tree; it is halved at the median along the longest side of its box.
int Surface::build(int first, int count) {
  const auto begin = order_.begin() + first;
  const int node = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Eigen::AlignedBox3d box;
  for (int i = 0; i < count; ++i)
    for (const int v : faces_[static_cast<std::size_t>(begin[i])].v) box.extend(at(v));
  nodes_.back().box = box;
  if (count <= kLeaf) {
    nodes_.back().first = first, nodes_.back().count = count;
    return node;
  }
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle = [&](int f) {
    const Face& face = faces_[static_cast<std::size_t>(f)];
    return at(face.v[0])[axis] + at(face.v[1])[axis] + at(face.v[2])[axis];
  };
  std::nth_element(begin, begin + count / 2, begin + count,
                   [&](int a, int b) { return std::pair(middle(a), a) < std::pair(middle(b), b); });
  build(first, count / 2);
  const int right = build(first + count / 2, count - count / 2);
  nodes_[static_cast<std::size_t>(node)].right = right;
  return node;
}

std::string Surface::featureName(int id) const {
  const int faces = static_cast<int>(faces_.size()), edges = static_cast<int>(edges_.size());
  if (id < faces) return "face" + std::to_string(id);
  if (id < faces + edges) return "edge" + std::to_string(id - faces);
  return "corner" + std::to_string(id - faces - edges);
}

/// Search for the contacts of one ball, with its centre and velocity in axes of the surface.
struct Surface::Query {
  const Frame &A, &B;
  const RoundFeature& ball;
  Vec3 c, c_I, v_I;  ///< centre in the surface's axes, in the world; its velocity
  double reach;
  SurfaceContacts& out;
  int count = 0;
  int deepest = -1;  ///< face of a convex body over which c is least deep
  double height = -1e300;

  void take(int id, double distance, const Vec3& n_I, const Vec3& ndot_I) {
    for (int i = 0; i < count; ++i)  // two faces of one plane on their common edge
      if ((out[static_cast<std::size_t>(i)].at.d[0] - n_I).squaredNorm() < 1e-18) return;
    if (count == kMostSurfaceContacts) return;
    SurfaceContact& contact = out[static_cast<std::size_t>(count++)];
    contact.id = id;
    contact.at.g = distance - ball.radius;
    setDirections(contact.at, n_I, ndot_I, Vec3::Zero());
    contact.at.P = c_I - ball.radius * n_I, contact.at.Pdot = v_I - ball.radius * ndot_I;
  }
  /// Takes the contact with the point p of the surface; the part of the
  /// distance along e is left out.
  void takeFrom(int id, const Vec3& p, const Vec3& e) {
    const Vec3 d = A.A_IK * (c - p), e_I = A.A_IK * e;
    const double distance = d.norm();
    if (!(distance > 0.0)) return;
    const Vec3 n = d / distance, foot = c_I - d;
    const Vec3 w = v_I - A.velocity(foot - A.r_OS_I);
    const double along = w.dot(e_I) + d.dot(A.Omega_I.cross(e_I));
    const Vec3 ddot = w - along * e_I;
    take(id, distance, n, (ddot - n.dot(ddot) * n) / distance);
  }
};

int Surface::contacts(const Frame& A, const Frame& B, const RoundFeature& ball, double reach,
                      SurfaceContacts& out) const {
  const Vec3 rho = B.A_IK * ball.c_K, c_I = B.r_OS_I + rho;
  const Vec3 c = A.A_IK.transpose() * (c_I - A.r_OS_I);
  Query q{A, B, ball, c, c_I, B.velocity(rho), ball.radius + reach, out};
  const double far = q.reach;
  int stack[kDeepestBranch], top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const int at = stack[--top];
    const Node& node = nodes_[static_cast<std::size_t>(at)];
    // A point inside of a convex body may be far from all of its faces.
    if (!closed_ && node.box.squaredExteriorDistance(c) > far * far) continue;
    if (node.right < 0) {
      for (int i = 0; i < node.count; ++i)
        lookAt(order_[static_cast<std::size_t>(node.first + i)], q);
    } else if (top + 2 <= kDeepestBranch) {
      stack[top++] = node.right, stack[top++] = at + 1;
    }
  }
  if (closed_ && q.deepest >= 0 && q.height <= 0.0) {  // inside
    const Vec3 n = A.A_IK * faces_[static_cast<std::size_t>(q.deepest)].n;
    q.count = 0;
    q.take(q.deepest, q.height, n, A.Omega_I.cross(n));
  }
  return q.count;
}

bool Surface::inWedge(int i, const Vec3& way) const {
  const Edge& e = edge(i);
  const Face &first = faces_[static_cast<std::size_t>(e.f)],
             &second = faces_[static_cast<std::size_t>(e.g < 0 ? e.f : e.g)];
  const double least = -kOnBorder * way.norm();
  return way.dot(first.out[static_cast<std::size_t>(e.sideF)]) > least &&
         (e.g < 0 ? way.dot(first.n) > 0.0
                  : way.dot(second.out[static_cast<std::size_t>(e.sideG)]) > least);
}

bool Surface::inCone(int i, const Vec3& way) const {
  const Corner& c = corner(i);
  for (const int other : c.others) {
    const Vec3 side = at(other) - at(c.v);
    if (way.dot(side) > kOnBorder * way.norm() * side.norm()) return false;
  }
  return std::any_of(c.faces.begin(), c.faces.end(), [&](int face) {
    return way.dot(faces_[static_cast<std::size_t>(face)].n) > 0.0;
  });
}

bool Surface::isOver(const Face& f, const Vec3& p, double beside) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (f.out[k].dot(p - at(f.v[k])) <= beside) continue;
    if (f.rises[k] < 0 || f.n.dot(p - at(f.v[0])) >= 0.0) return false;
    const Face& other = faces_[static_cast<std::size_t>(f.rises[k])];
    if (other.n.dot(p - at(other.v[0])) >= 0.0) return false;
    const int from = f.v[k], to = f.v[(k + 1) % 3];
    for (std::size_t j = 0; j < 3; ++j)
      if ((other.v[j] != to || other.v[(j + 1) % 3] != from) &&
          other.out[j].dot(p - at(other.v[j])) > beside)
        return false;
  }
  return true;
}

void Surface::lookAt(int number, Query& q) const {
  const Face& f = faces_[static_cast<std::size_t>(number)];
  const double height = f.n.dot(q.c - at(f.v[0]));
  if (closed_ && height > q.height) q.height = height, q.deepest = number;
  const double beside = kBesideFace * (at(f.v[1]) - at(f.v[0])).norm();
  const bool over = isOver(f, q.c, beside);
  // A mesh has one side: a ball deeper than its own size counts as on the other side, however far
  // gaps are asked for.
  const double deepest = closed_ ? 0.0 : -std::min(q.reach, kOwnSize * q.ball.radius);
  if (over && height <= q.reach && height >= deepest) {
    const Vec3 n = q.A.A_IK * f.n;
    q.take(number, height, n, q.A.Omega_I.cross(n));
  }
  const int faces = static_cast<int>(faces_.size()), edges = static_cast<int>(edges_.size());
  for (const int number2 : f.edge) {
    if (number2 < 0) continue;
    const Edge& e = edges_[static_cast<std::size_t>(number2)];
    const Vec3 a = at(e.a), along = (at(e.b) - a).normalized(), d = q.c - a;
    const double s = along.dot(d);
    if (s <= 0.0 || s >= (at(e.b) - a).norm()) continue;
    const Vec3 way = d - s * along;
    if (way.squaredNorm() > q.reach * q.reach) continue;
    if (inWedge(number2, way)) q.takeFrom(faces + number2, a + s * along, along);
  }
  for (const int number2 : f.corner) {
    if (number2 < 0) continue;
    const Corner& c = corners_[static_cast<std::size_t>(number2)];
    const Vec3 d = q.c - at(c.v);
    if (d.squaredNorm() > q.reach * q.reach) continue;
    if (inCone(number2, d)) q.takeFrom(faces + edges + number2, at(c.v), Vec3::Zero());
  }
}

}  // namespace dynamy
