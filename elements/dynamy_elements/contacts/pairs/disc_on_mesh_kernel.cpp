#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>
#include <dynamy_elements/contacts/pairs/disc_arc.hpp>
#include <dynamy_elements/contacts/pairs/disc_on_mesh.hpp>

namespace dynamy {
namespace {

/// Crossings nearer to each other than this part of a rim's radius are one.
constexpr double kSamePlace = 1e-6;
/// Rounding of a normal: the one of a cap that lies flat on an edge is at the border of those of its
/// rim.
constexpr double kBorder = 1e-9;

/// One round body over a mesh, in the world.
class DiscOverMesh {
 public:
  DiscOverMesh(const Frame& A, const Surface& mesh, const DiscBody& B, double reach,
               OnSurfaceContacts& out)
      : A_(A), mesh_(mesh), B_(B), reach_(reach), out_(out) {}

  int contacts() {
    // The extent of B along each axis of the mesh: a cone reaches further on one side of its middle.
    Vec3 least, most;
    for (int k = 0; k < 3; ++k) {
      const Vec3 d = A_.A_IK.col(k);
      const double origin = d.dot(A_.r_OS_I);
      least[k] = -B_.support(-d) - origin - reach_, most[k] = B_.support(d) - origin + reach_;
    }
    const Eigen::AlignedBox3d box(least, most);
    mesh_.forFacesNear(box, [&](int i) { face(i); });
    mesh_.forFacesNear(box, [&](int number) {
      const Surface::Face& f = mesh_.faces()[static_cast<std::size_t>(number)];
      for (const int i : f.corner)
        if (i >= 0) corner(i);
      for (const int i : f.edge)
        if (i >= 0) edge(i);
    });
    return size_;
  }

 private:
  Vec3 placed(int point) const { return A_.r_OS_I + A_.A_IK * mesh_.at(point); }
  Vec3 inA(const Vec3& p) const { return A_.A_IK.transpose() * (p - A_.r_OS_I); }
  int faces() const { return static_cast<int>(mesh_.faces().size()); }

  bool near(double g) const { return std::abs(g) <= reach_; }
  void take(int id, const ContactPoint& at) {
    // Coplanar faces meet B at one place on their common edge, and the faces at an edge do, too.
    for (int i = 0; i < size_; ++i) {
      const NumberedContact& c = out_[static_cast<std::size_t>(i)];
      if ((c.at.P - at.P).norm() <= kSamePlace * B_.thickness() &&
          (c.at.d[0] - at.d[0]).squaredNorm() < 1e-18)
        return;
    }
    if (size_ < kMostOnSurface) out_[static_cast<std::size_t>(size_++)] = {id, at};
  }

  void face(int number) {
    const Surface::Face& f = mesh_.faces()[static_cast<std::size_t>(number)];
    const Vec3 n = A_.A_IK * f.n, d = -n;
    const double height = n.dot(placed(f.v[0]));
    // All of B is too high over the face, or too deep below it.
    if (-B_.support(d) - height > reach_ || B_.support(n) - height < -reach_) return;
    const PlacedFace on(A_, n, placed(f.v[0]), 0.0, A_.A_IK * f.out[0], 1.0, true);
    const auto over = [&](const Vec3& p_I) { return mesh_.isOver(f, inA(p_I), 0.0); };
    const DiscBody::Part part = B_.part(d);
    const int facing = B_.rimAlong(d);
    for (int rim = 0; rim < B_.rims(); ++rim) {
      if ((part != DiscBody::Part::side && rim != facing) || !B_.touches(d, rim)) continue;
      ContactPoint at;
      on.contact(*B_.frame, B_.c, at);
      wander(B_, rim, at);
      at.g = n.dot(at.P) - height;
      if (near(at.g) && over(at.P)) take(rim * faces() + number, at);
    }
    for (int k = 0; k < (part == DiscBody::Part::cap ? 4 : 0); ++k) {
      const Vec3 p = B_.point(facing, k) + B_.r * d;
      ContactPoint at;
      on.contact(*B_.frame, p, at);
      at.Pdot += B_.r * (B_.frame->Omega_I.cross(n) - at.ddot[0]);
      if (near(at.g) && over(p)) take((2 + 4 * facing + k) * faces() + number, at);
    }
  }

  /// Adds a contact whose normal points from B to the mesh, with the normal reversed.
  void fromB(int id, int number, ContactPoint at) {
    for (const int k : {0, 1}) at.d[k] = -at.d[k], at.ddot[k] = -at.ddot[k];
    if (near(at.g) && mesh_.inCone(number, A_.A_IK.transpose() * at.d[0])) take(id, at);
  }
  void corner(int i) {
    const Vec3 v = placed(mesh_.corner(i).v), way = v - B_.c;
    const double z = way.dot(B_.a), side = z < 0.0 ? -1.0 : 1.0;
    const double out = B_.acrossAxis(way).norm();
    const int id = 10 * faces() + i;
    if (B_.tip) return cornerOnCone(id, i, v);
    const bool above = std::abs(z) > B_.half;
    // The corner is over a cap, or inside and nearest to a cap.
    if (out <= B_.rho && (above || std::abs(z) - B_.half > out - B_.rho)) {
      const PlacedFace cap(*B_.frame, side * B_.a, B_.c, B_.half + B_.r, B_.x, 1.0, true);
      ContactPoint at;
      cap.contact(A_, v, at);
      fromB(id, i, at);
    } else if (!above && out > 0.0) {
      fromB(id, i, pointOnCurve(B_.axis(), A_, v, 0.0, B_.acrossAxis(way).normalized()));
    } else if (above) {
      fromB(id, i, pointOnCurve(B_.rim(z > 0.0 ? B_.rims() - 1 : 0, way), A_, v, 0.0, way));
    }
  }

  /// Contact of a corner with the nearest of side, base and rim of a cone;
  /// the tip meets edges and faces.
  void cornerOnCone(int id, int number, const Vec3& v) {
    RoundFeature point;
    point.c_K = inA(v);
    fromB(id, number, ballOnCone(B_, A_, point));
  }

  void edge(int i) {
    const Surface::Edge& e = mesh_.edge(i);
    const Vec3 a = placed(e.a), b = placed(e.b);
    const double half = 0.5 * (b - a).norm();
    const BodyCurve line = BodyCurve::line(A_, 0.5 * (a + b), (b - a).normalized(), 0.0);
    // Direction out of the mesh, between the normals of the faces of the edge.
    const Surface::Face& first = mesh_.faces()[static_cast<std::size_t>(e.f)];
    const Vec3 &f = first.n, g = e.g < 0 ? f : mesh_.faces()[static_cast<std::size_t>(e.g)].n;
    const Vec3 m = A_.A_IK * (f + g).normalized();
    const auto on = [&](const BodyCurve& at) {
      return std::abs(line.t.dot(at.x - line.x)) <= half;
    };
    const auto counts = [&](const ContactPoint& at) {
      return near(at.g) && mesh_.inWedge(i, A_.A_IK.transpose() * at.d[0]);
    };
    const int ofSide = 10 * faces() + mesh_.corners(), ofRims = ofSide + mesh_.edges() + 4 * i;
    if (B_.tip) {
      double s = 0.0, along = 0.0;
      ContactPoint at;
      // Both lines of the side whose normals are across the edge.
      for (const Vec3& towards : {Vec3(-m), m})
        if (lineOnSide(B_, A_, line.x, line.t, towards, s, along, at) && std::abs(along) <= half &&
            s >= 0.0 && s <= B_.slant() && counts(at))
          take(ofSide + i, at);
      if (std::abs(line.t.dot(B_.middle(1) - line.x)) <= half) {
        at = pointOnCurve(line, *B_.frame, B_.middle(1), 0.0, m);
        if (B_.fromSide(-at.d[0]) >= 0.0 && counts(at)) take(ofRims + 2, at);
      }
    } else if (B_.half > 0.0) {
      BodyCurve own = line, axis = B_.axis();
      if (toClosest(own, axis) && on(own) && std::abs(B_.a.dot(axis.x - B_.c)) <= B_.half)
        if (const ContactPoint at = curveOnCurve(own, axis, m); counts(at)) take(ofSide + i, at);
    }
    const auto onRim = [&](int rim, const BodyCurve& start) {
      BodyCurve own = line, at = start;
      own.go(line.t.dot(at.x - line.x));
      if (!toClosest(own, at) || !on(own)) return;
      const ContactPoint c = curveOnCurve(own, at, m);
      // The normal must point out of the rim: away from the axis, and from the other rim.
      const Vec3 d = -c.d[0];
      const bool out = d.dot(at.x - at.c) >= -kBorder * at.rho &&
                       (B_.half == 0.0 || B_.fromSide(d) * (rim == 1 ? 1.0 : -1.0) >= -kBorder);
      if (out && counts(c)) take(ofRims + 2 * rim + (line.t.dot(at.x - at.c) > 0.0 ? 1 : 0), c);
    };
    // The edge touches a rim where it crosses it under a cap, and where B is furthest among the
    // normals of the edge.
    for (int rim = 0; rim < (B_.tip ? 1 : B_.rims()); ++rim) {
      BodyCurve crossing[2];
      const int n = B_.crossings(rim, line.x, line.t, m, crossing);
      for (int k = 0; k < n; ++k) onRim(rim, crossing[k]);
    }
    const Vec3 n0 = A_.A_IK * f;
    const Vec3 nE =
        e.g < 0 ? Vec3(A_.A_IK * first.out[static_cast<std::size_t>(e.sideF)]) : Vec3(A_.A_IK * g);
    const Vec3 across = (nE - n0.dot(nE) * n0).normalized();
    const DiscArc arc{B_, n0, across, B_.c - line.x};
    arc.tops(std::atan2(across.dot(nE), n0.dot(nE)), -kInfinity, [&](const Vec3& n, double) {
      const int rim = B_.rimAlong(-n);
      if (B_.radius(rim) > 0.0 && B_.touches(n)) onRim(rim, B_.rim(rim, -n));
    });
  }

  const Frame& A_;
  const Surface& mesh_;
  const DiscBody& B_;
  double reach_;
  OnSurfaceContacts& out_;
  int size_ = 0;
};

}  // namespace

std::uint64_t discOnMeshFeatures(const Surface& mesh) {
  return 10 * mesh.faces().size() + static_cast<std::uint64_t>(mesh.corners()) +
         5 * static_cast<std::uint64_t>(mesh.edges());
}

int discOnMesh(const Frame& A, const Surface& mesh, const DiscBody& B, double reach,
               OnSurfaceContacts& out) {
  const int n = DiscOverMesh(A, mesh, B, reach, out).contacts();
  levelled(A, {out.data(), static_cast<std::size_t>(n)});
  return n;
}

}  // namespace dynamy
