#include <algorithm>
#include <dynamy_elements/contacts/pairs/polyhedra_separation.hpp>

namespace dynamy {
namespace {

/// Error of a separation as a part of the bodies' sizes, with a margin of a hundred.
constexpr double kSeparationRounding = 1e-13;

/// Corners of a body that are outermost along d, up to `same` [m].
class OutermostCorners {
 public:
  OutermostCorners(const Polyhedron& body, const Vec3& d, double same) {
    double along = 0.0;
    outermost(body, d, along);
    for (const Vec3& p : body.corners())
      if (d.dot(p) >= along - same && size_ < kMost) at_[size_++] = &p;
  }
  /// The furthest of them along d, in axes of the body.
  const Vec3& along(const Vec3& d) const {
    std::size_t best = 0;
    double most = -kInfinity;
    for (std::size_t i = 0; i < size_; ++i)
      if (const double x = d.dot(*at_[i]); x > most) most = x, best = i;
    return *at_[best];
  }

 private:
  static constexpr std::size_t kMost = 16;
  std::array<const Vec3*, kMost> at_;
  std::size_t size_ = 0;
};

}  // namespace

PolyhedraSeparation::PolyhedraSeparation(const PlacedPolyhedron& a, const PlacedPolyhedron& b)
    : A_(*a.of), B_(*b.of), C_(a.R.transpose() * b.R), t_(a.R.transpose() * (b.c - a.c)) {
  rounding_ = kSeparationRounding * (A_.radius() + B_.radius() + t_.norm());
  const Vec3 w = t_ + C_ * B_.middle() - A_.middle();
  middle_ = {w, -(C_.transpose() * w)};
}

/// The face that the middle of the other body is furthest from.
int PolyhedraSeparation::furthest() const {
  const int nA = static_cast<int>(A_.faces().size()), nB = static_cast<int>(B_.faces().size());
  const Vec3 b = middle_.a + A_.middle(), a = middle_.b + B_.middle();
  int best = 0;
  double most = -kInfinity;
  for (int i = 0; i < nA; ++i)
    if (const double s = A_.face(i).n.dot(b) - A_.face(i).height; s > most) most = s, best = i;
  for (int i = 0; i < nB; ++i)
    if (const double s = B_.face(i).n.dot(a) - B_.face(i).height; s > most) most = s, best = nA + i;
  return best;
}

/// Separation along the normal of face i of A, or i − n_A of B.
PolyhedraAxis PolyhedraSeparation::axis(int i) {
  const int nA = static_cast<int>(A_.faces().size());
  double along = 0.0;
  if (i < nA) {
    const Polyhedron::Face& f = A_.face(i);
    const int v = outermost(B_, -(C_.transpose() * f.n), along);
    add(t_ + C_ * B_.corner(v) - A_.corner(A_.border(f.first).corner));
    return {f.n.dot(t_) - along - f.height, i, -1, f.n};
  }
  const Polyhedron::Face& f = B_.face(i - nA);
  const Vec3 n = -(C_ * f.n);
  const int v = outermost(A_, n, along);
  add(t_ + C_ * B_.corner(B_.border(f.first).corner) - A_.corner(v));
  return {n.dot(t_) - along - f.height, -1, i - nA, n};
}

/// Is the separation along the normal of a face less than `most` [m]?
bool PolyhedraSeparation::excludes(int face, double most) const {
  const bool ofA = face < static_cast<int>(A_.faces().size());
  const Vec3& n = normal(face);
  if (n.dot(ofA ? middle_.a : middle_.b) < most) return true;
  for (int k = 0; k < size_; ++k) {
    const Witness& w = kept_[static_cast<std::size_t>(k)];
    if (n.dot(ofA ? w.a : w.b) < most) return true;
  }
  return false;
}

PolyhedraAxis PolyhedraSeparation::faces(double reach) {
  const int first = furthest(), all = count();
  PolyhedraAxis start = axis(first);
  if (start.separation > reach) return start;
  double most = start.separation;
  PolyhedraAxis best;
  // Of equal ones the first counts.
  for (int i = 0; i < all && best.separation <= reach; ++i) {
    if (i == first) {
      if (start.separation > best.separation) best = start;
    } else if (!excludes(i, most - rounding_)) {
      const PolyhedraAxis next = axis(i);
      if (next.separation > best.separation) best = next;
      most = std::max(most, best.separation);
    }
  }
  return best;
}

/// Adds pairs of outermost points along n that lie around each other.
void PolyhedraSeparation::addAround(const Vec3& n, double same) {
  const Vec3 n_B = C_.transpose() * n;
  const OutermostCorners ofA(A_, n, same), ofB(B_, -n_B, same);
  const Vec3 x = n.unitOrthogonal(), y = n.cross(x);
  constexpr double kSine = 0.8660254037844386;
  const Vec3 half = 0.5 * x, up = kSine * y;
  const std::array<Vec3, 6> ways{x, half + up, up - half, -x, -half - up, half - up};
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const Vec3& d = ways[k];
    const Vec3 w = t_ + C_ * ofB.along(-(C_.transpose() * d)) - ofA.along(d);
    around_[k] = {w, -(C_.transpose() * w)};
  }
}

PolyhedraAxis PolyhedraSeparation::edges(const PolyhedraAxis& face, double least, double same) {
  PolyhedraAxis best;
  best.separation = least;
  addAround(face.n, same);
  Excluded outA(A_, least - rounding_), outB(B_, least - rounding_);
  const auto by = [&](const Witness& w) { outA.by(w.a), outB.by(w.b); };
  by(middle_);
  for (int k = 0; k < size_; ++k) by(kept_[static_cast<std::size_t>(k)]);
  for (const Witness& w : around_) by(w);

  const int nA = static_cast<int>(A_.edges().size()), nB = static_cast<int>(B_.edges().size());
  constexpr int kTogether = 512;
  std::array<int, kTogether> left;
  for (int from = 0; from < nA; from += kTogether) {
    int n = 0;
    for (int i = from; i < std::min(nA, from + kTogether); ++i)
      if (!outA.edge(A_.edge(i))) left[static_cast<std::size_t>(n++)] = i;
    for (int j = 0; n > 0 && j < nB; ++j)
      if (!outB.edge(B_.edge(j))) edgesOn(j, {left.data(), static_cast<std::size_t>(n)}, best);
  }
  return best;
}

/// Edge j of B with some edges of A.
void PolyhedraSeparation::edgesOn(int j, std::span<const int> ofA, PolyhedraAxis& best) const {
  const Polyhedron::Edge& b = B_.edge(j);
  const Vec3 eB = C_ * b.e, oB = t_ + C_ * b.middle;
  const Vec3 c = -(C_ * B_.face(b.f).n), d = -(C_ * B_.face(b.g).n);
  for (const int i : ofA) {
    const Polyhedron::Edge& a = A_.edge(i);
    // The arcs of the normals cross: the ends of each are on both sides of the other, and they
    // lie on one half of the sphere.
    const double ca = c.dot(a.e), da = d.dot(a.e);
    if (ca * da >= 0.0) continue;
    const double ab = A_.face(a.f).n.dot(eB), bb = A_.face(a.g).n.dot(eB);
    if (ab * bb >= 0.0 || ca * bb <= 0.0) continue;
    const Vec3 cross = a.e.cross(eB);
    const double square = cross.squaredNorm();
    if (square < kCross * kCross) continue;
    const double sign = cross.dot(A_.face(a.f).n + A_.face(a.g).n) < 0.0 ? -1.0 : 1.0;
    const double s = sign * cross.dot(oB - a.middle) / std::sqrt(square);
    if (s > best.separation) best = {s, i, j, sign / std::sqrt(square) * cross};
  }
}

}  // namespace dynamy
