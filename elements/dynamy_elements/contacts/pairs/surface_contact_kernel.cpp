#include <dynamy_elements/contacts/pairs/segments.hpp>
#include <dynamy_elements/contacts/pairs/surface_contact.hpp>

namespace dynamy {
namespace {

/// Sine of the tilt of a corner's edges up to which it belongs to a face that lies on another.
constexpr double kTilted = 0.2;

/// List of the contacts found so far.
class Found {
 public:
  explicit Found(OnSurfaceContacts& out) : out_(out) {}
  NumberedContact* next(int id) {
    if (size_ == kMostOnSurface) return nullptr;
    NumberedContact& c = out_[static_cast<std::size_t>(size_++)];
    c.id = id;
    return &c;
  }
  void take(int id, const ContactPoint& at) {
    if (NumberedContact* c = next(id)) c->at = at;
  }
  int size() const { return size_; }
  const NumberedContact& at(int i) const { return out_[static_cast<std::size_t>(i)]; }

 private:
  OnSurfaceContacts& out_;
  int size_ = 0;
};

}  // namespace

int capsuleFeatures(const Surface& surface) {
  return 2 * surface.features() + surface.edges() + surface.corners();
}

int capsuleOnSurface(const Frame& A, const Surface& surface, const Frame& B,
                     const TouchingShape& capsule, double reach, OnSurfaceContacts& out) {
  Found found(out);
  const int all = surface.features();
  SurfaceContacts ends;
  for (int end = 0; end < 2; ++end) {
    const RoundFeature& ball = capsule.features[static_cast<std::size_t>(end)];
    const int n = surface.contacts(A, B, ball, reach, ends);
    for (int i = 0; i < n; ++i) {
      const SurfaceContact& c = ends[static_cast<std::size_t>(i)];
      found.take(end * all + c.id, c.at);
    }
  }
  // The axis between the ends, in axes of the surface.
  const LineSegment axis = capsuleAxis(B, capsule);
  const double R = capsule.thickness, far = R + reach;
  const auto local = [&](const Vec3& p) { return Vec3(A.A_IK.transpose() * (p - A.r_OS_I)); };
  Eigen::AlignedBox3d box(local(axis.o - axis.half * axis.e));
  box.extend(local(axis.o + axis.half * axis.e));
  const Vec3 around = Vec3::Constant(far);
  box = {box.min() - around, box.max() + around};
  surface.forFacesNear(box, [&](int number) {
    const Surface::Face& f = surface.faces()[static_cast<std::size_t>(number)];
    for (const int i : f.edge) {
      if (i < 0) continue;
      const Vec3 &a = surface.at(surface.edge(i).a), &b = surface.at(surface.edge(i).b);
      const LineSegment edge(A, A.r_OS_I + A.A_IK * (0.5 * (a + b)), A.A_IK * (b - a).normalized(),
                             0.5 * (b - a).norm());
      const SegmentCrossing at(edge, axis);
      if (!at.inside) continue;
      const ContactPoint contact = across(edge, 0.0, axis, R, at);
      if (contact.g <= reach && surface.inWedge(i, A.A_IK.transpose() * contact.d[0]))
        found.take(2 * all + i, contact);
    }
    for (const int i : f.corner) {
      if (i < 0) continue;
      const Vec3 c = A.r_OS_I + A.A_IK * surface.at(surface.corner(i).v);
      if (std::abs(axis.e.dot(c - axis.o)) >= axis.half) continue;
      ContactPoint contact = overSegment(axis, R, c, A.velocity(c - A.r_OS_I), 0.0, Vec3::Zero());
      turnRound(contact);
      if (contact.g <= reach && surface.inCone(i, A.A_IK.transpose() * contact.d[0]))
        found.take(2 * all + surface.edges() + i, contact);
    }
  });
  return found.size();
}

std::uint64_t meshFeatures(const Surface& mesh, const Polyhedron& B) {
  const auto count = [](auto n) { return static_cast<std::uint64_t>(n); };
  return count(B.corners().size()) * mesh.faces().size() + count(mesh.corners()) +
         count(mesh.edges()) * B.edges().size();
}

namespace {

/// Search for the contacts of one polyhedron with a mesh, in axes of the mesh.
class OverMesh {
 public:
  OverMesh(const Frame& A, const Surface& mesh, const PlacedPolyhedron& B, double reach, bool rates,
           OnSurfaceContacts& out)
      : A_(A),
        mesh_(mesh),
        B_(B),
        C_(A.A_IK.transpose() * B.R),
        t_(A.A_IK.transpose() * (B.c - A.r_OS_I)),
        reach_(reach),
        rates_(rates),
        found_(out) {}

  int contacts() {
    const Polyhedron& body = *B_.of;
    Eigen::AlignedBox3d box;
    for (const Vec3& p : body.corners()) box.extend(t_ + C_ * p);
    const Vec3 around = Vec3::Constant(reach_);
    box = {box.min() - around, box.max() + around};
    mesh_.forFacesNear(box, [&](int number) {
      const Surface::Face& f = mesh_.faces()[static_cast<std::size_t>(number)];
      const int corners = static_cast<int>(body.corners().size());
      for (int v = 0; v < corners; ++v) cornerOverFace(v, number, f);
    });
    mesh_.forFacesNear(box, [&](int number) {
      const Surface::Face& f = mesh_.faces()[static_cast<std::size_t>(number)];
      for (const int i : f.corner)
        if (i >= 0) cornerOfMesh(i);
      for (const int i : f.edge)
        if (i >= 0 && box.intersects(boxOf(mesh_.edge(i)))) edge(i);
    });
    return found_.size();
  }

 private:
  Eigen::AlignedBox3d boxOf(const Surface::Edge& e) const {
    Eigen::AlignedBox3d box(mesh_.at(e.a));
    return box.extend(mesh_.at(e.b));
  }

  void cornerOverFace(int v, int number, const Surface::Face& f) {
    const Vec3 p = t_ + C_ * B_.of->corner(v);
    const double g = f.n.dot(p - mesh_.at(f.v[0]));
    if (std::abs(g) > reach_) return;
    const double beside = kOnBorder * (mesh_.at(f.v[1]) - mesh_.at(f.v[0])).norm();
    if (!mesh_.isOver(f, p, beside)) return;
    // All edges of the corner must rise from the face, up to the tilt of
    // a face that lies on another.
    const Vec3 n = C_.transpose() * f.n;
    for (const int u : B_.of->neighbours(v)) {
      const Vec3 way = B_.of->corner(u) - B_.of->corner(v);
      if (n.dot(way) < -kTilted * way.norm()) return;
    }
    const Vec3 n_I = A_.A_IK * f.n;
    for (int i = 0; i < found_.size(); ++i)  // coplanar faces on their common edge
      if (found_.at(i).id / faces() == v && (found_.at(i).at.d[0] - n_I).squaredNorm() < 1e-18)
        return;
    if (NumberedContact* c = found_.next(v * faces() + number))
      PlacedFace(A_, n_I, A_.r_OS_I + A_.A_IK * mesh_.at(f.v[0]), 0.0, A_.A_IK * f.out[0], 1.0,
                 rates_)
          .contact(*B_.frame, B_.vertex(v), c->at);
  }

  /// Contact of a corner of the mesh with the nearest face of B, if its
  /// normal points out of the mesh.
  void cornerOfMesh(int i) {
    const Vec3 p = C_.transpose() * (mesh_.at(mesh_.corner(i).v) - t_);
    const Polyhedron& body = *B_.of;
    double height = -1e300;
    int nearest = 0;
    for (std::size_t f = 0; f < body.faces().size(); ++f)
      if (const double h = body.faces()[f].n.dot(p) - body.faces()[f].height; h > height)
        height = h, nearest = static_cast<int>(f);
    if (std::abs(height) > reach_) return;
    const Polyhedron::Face& face = body.face(nearest);
    if (!body.over(face, p, kOnBorder * body.halfWidth()) || !mesh_.inCone(i, -(C_ * face.n)))
      return;
    if (NumberedContact* c = found_.next(ofCorners() + i))
      B_.face(nearest, -1.0, rates_)
          .contact(A_, A_.r_OS_I + A_.A_IK * mesh_.at(mesh_.corner(i).v), c->at);
  }

  void edge(int i) {
    const Surface::Edge& e = mesh_.edge(i);
    const Vec3 along = mesh_.at(e.b) - mesh_.at(e.a);
    const PlacedEdge a{0.5 * (mesh_.at(e.a) + mesh_.at(e.b)), along.normalized(),
                       0.5 * along.norm()};
    const int n = static_cast<int>(B_.of->edges().size());
    for (int j = 0; j < n; ++j) {
      const Polyhedron::Edge& f = B_.of->edge(j);
      const PlacedEdge b{t_ + C_ * f.middle, C_ * f.e, f.half};
      const EdgeCrossing at(a, b);
      if (at.parallel || beyond(at.s, a.half) || beyond(at.t, b.half)) continue;
      // The normal that points out of the mesh, and into B.
      const Vec3 towards = mesh_.inWedge(i, at.n) ? at.n : Vec3(-at.n);
      if (!mesh_.inWedge(i, towards) || std::abs(towards.dot(at.PB - at.PA)) > reach_) continue;
      const Vec3 &nf = B_.of->face(f.f).n, &ng = B_.of->face(f.g).n;
      const Vec3 inB = -(C_.transpose() * towards);
      if (std::min(nf.cross(inB).dot(f.e), inB.cross(ng).dot(f.e)) < -kOnBorder) continue;
      if (NumberedContact* c = found_.next(ofEdges() + i * n + j)) {
        const PlacedEdge placed{A_.r_OS_I + A_.A_IK * a.o, A_.A_IK * a.e, a.half};
        const PlacedEdge other = B_.edge(j);
        c->at = edgeOnEdge(A_, placed, *B_.frame, other, EdgeCrossing(placed, other),
                           A_.A_IK * towards);
      }
    }
  }

  static bool beyond(double s, double half) { return std::abs(s) > (1.0 + kOnBorder) * half; }
  int faces() const { return static_cast<int>(mesh_.faces().size()); }
  int ofCorners() const { return static_cast<int>(B_.of->corners().size()) * faces(); }
  int ofEdges() const { return ofCorners() + mesh_.corners(); }

  const Frame& A_;
  const Surface& mesh_;
  const PlacedPolyhedron& B_;
  Mat3 C_;
  Vec3 t_;
  double reach_;
  bool rates_;
  Found found_;
};

}  // namespace

void levelled(const Frame& A, std::span<NumberedContact> contacts) {
  const auto lowest = std::min_element(
      contacts.begin(), contacts.end(),
      [](const NumberedContact& a, const NumberedContact& b) { return a.at.g < b.at.g; });
  if (lowest == contacts.end()) return;
  const ContactPoint at = lowest->at;
  for (NumberedContact& c : contacts)
    if ((c.at.d[0] - at.d[0]).squaredNorm() < 1e-18)
      intoPlane(at.d[0], A.Omega_I.cross(at.d[0]), at, c.at);
}

int polyhedronOnMesh(const Frame& A, const Surface& mesh, const PlacedPolyhedron& B, double reach,
                     bool rates, OnSurfaceContacts& out) {
  const int n = OverMesh(A, mesh, B, reach, rates, out).contacts();
  levelled(A, {out.data(), static_cast<std::size_t>(n)});
  return n;
}

}  // namespace dynamy
