/// Bounds of the separation of two convex bodies from above, by a few pairs of their points.
///
///   f(n) = min n·(x_B − x_A) ≤ n·w,   w = x_B − x_A of any point of A and any point of B
///
/// The search for the largest f looks at the normals of faces, edges and corners. If one w shows
/// that f ≤ b for all faces that meet in an edge or corner, then for every direction between their
/// normals, too: n = Σ α_i n_i with α_i ≥ 0 and c Σ α_i ≤ |n| = 1 ≤ Σ α_i gives n·w ≤ Σ α_i min(b,
/// c b) ≤ b. What such a w excludes cannot be the largest, hence the result is that of a search
/// over everything, to the last bit, and depends on no step before.
#pragma once
#include <array>
#include <cstdint>
#include <dynamy_elements/contacts/shapes/polyhedron.hpp>

namespace dynamy {

/// For each face of a body, a bit for each w that bounds f along the face's normal.
class Excluded {
 public:
  /// `most`: f need not exceed it [m].
  Excluded(const Polyhedron& body, double most)
      : body_(body),
        small_(body.faces().size() <= kMostFaces),
        least_(most > 0.0 ? body.together() * most : most) {
    if (small_) std::fill_n(by_.begin(), body.faces().size(), 0);
  }
  /// `w`: in axes of the body, from its point to that of the other body.
  void by(const Vec3& w) {
    if (!small_) return;
    const Polyhedron::Columns& n = body_.normalColumns();
    const double *x = n.x.data(), *y = n.y.data(), *z = n.z.data();
    const double wx = w.x(), wy = w.y(), wz = w.z(), least = least_;
    const std::uint64_t bit = std::uint64_t{1} << count_++;
    std::uint64_t* out = by_.data();
    const std::size_t faces = n.size();
    for (std::size_t i = 0; i < faces; ++i)
      out[i] |= x[i] * wx + y[i] * wy + z[i] * wz <= least ? bit : 0;
  }
  bool edge(const Polyhedron::Edge& e) const { return small_ && (of(e.f) & of(e.g)) != 0; }
  bool corner(int i) const {
    if (!small_) return false;
    std::uint64_t all = ~std::uint64_t{0};
    for (const int f : body_.facesAt(i)) all &= of(f);
    return all != 0;
  }

 private:
  /// Bodies with more faces are searched as a whole.
  static constexpr std::size_t kMostFaces = 256;
  std::uint64_t of(int face) const { return by_[static_cast<std::size_t>(face)]; }

  const Polyhedron& body_;
  bool small_;
  double least_;
  int count_ = 0;
  std::array<std::uint64_t, kMostFaces> by_;
};

}  // namespace dynamy
