#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>
#include <dynamy_elements/contacts/pairs/smooth_search.hpp>

namespace dynamy {
namespace {

/// One feature over a mesh.
class SmoothOverMesh {
 public:
  SmoothOverMesh(const Frame& A, const Surface& mesh, const smooth::Placed& B, double reach,
                 OnSurfaceContacts& out)
      : A_(A), mesh_(mesh), B_(B), reach_(reach), out_(out) {}

  int contacts() {
    Eigen::AlignedBox3d box;
    for (int k = 0; k < 3; ++k)
      for (const double side : {-1.0, 1.0}) box.extend(inA(B_.point(side * A_.A_IK.col(k))));
    const Vec3 around = Vec3::Constant(reach_);
    box = {box.min() - around, box.max() + around};
    mesh_.forFacesNear(box, [&](int number) { face(number); });
    mesh_.forFacesNear(box, [&](int number) {
      const Surface::Face& f = mesh_.faces()[static_cast<std::size_t>(number)];
      for (const int i : f.edge)
        if (i >= 0) edge(i);
      for (const int i : f.corner)
        if (i >= 0) corner(i);
    });
    return size_;
  }

 private:
  Vec3 inA(const Vec3& p) const { return A_.A_IK.transpose() * (p - A_.r_OS_I); }
  Vec3 placed(int point) const { return A_.r_OS_I + A_.A_IK * mesh_.at(point); }
  int faces() const { return static_cast<int>(mesh_.faces().size()); }
  void take(int id, const ContactPoint& at) {
    if (std::abs(at.g) <= reach_ && size_ < kMostOnSurface)
      out_[static_cast<std::size_t>(size_++)] = {id, at};
  }

  void face(int number) {
    const Surface::Face& f = mesh_.faces()[static_cast<std::size_t>(number)];
    const ContactPoint at = smooth::overPlane(A_, A_.A_IK * f.n, placed(f.v[0]), B_);
    const Vec3 p = inA(at.P);
    const double beside = kOnBorder * (mesh_.at(f.v[1]) - mesh_.at(f.v[0])).norm();
    if (!mesh_.isOver(f, p, beside)) return;
    // Coplanar faces would both touch on their common edge; one contact is kept.
    for (int i = 0; i < size_; ++i)
      if ((out_[static_cast<std::size_t>(i)].at.d[0] - at.d[0]).squaredNorm() < 1e-18) return;
    take(number, at);
  }
  void edge(int i) {
    const Vec3 a = placed(mesh_.edge(i).a), b = placed(mesh_.edge(i).b), o = 0.5 * (a + b);
    const Vec3 e = (b - a).normalized();
    const ContactPoint at = smooth::onPoint(A_, o, B_, &e);
    if (mesh_.inWedge(i, A_.A_IK.transpose() * at.d[0]) &&
        std::abs(e.dot(at.P - o)) <= 0.5 * (1.0 + kOnBorder) * (b - a).norm())
      take(faces() + i, at);
  }
  void corner(int i) {
    const ContactPoint at = smooth::onPoint(A_, placed(mesh_.corner(i).v), B_, nullptr);
    if (mesh_.inCone(i, A_.A_IK.transpose() * at.d[0])) take(faces() + mesh_.edges() + i, at);
  }

  const Frame& A_;
  const Surface& mesh_;
  const smooth::Placed& B_;
  double reach_;
  OnSurfaceContacts& out_;
  int size_ = 0;
};

}  // namespace

int smoothOnMesh(const Frame& A, const Surface& mesh, const Frame& B, const SupportFeature& feature,
                 double reach, OnSurfaceContacts& out) {
  const smooth::Placed b{B, feature};
  return SmoothOverMesh(A, mesh, b, reach, out).contacts();
}

}  // namespace dynamy
