/// The axis of largest separation of two polyhedra: the normal of a face, or e_A × e_B of two
/// edges.
///
/// Faces and edges that a pair of points excludes are passed over (support_witnesses.hpp). The
/// search begins at the face that the middle of the other body is furthest from, and each axis that
/// is tried gives a pair of points: the outermost ones along it. Around the best face the corners
/// that are outermost along its normal exclude the edges; where bodies lie on each other, all of
/// them.
#pragma once
#include <array>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/contacts/pairs/polyhedron_contact.hpp>
#include <dynamy_elements/contacts/pairs/support_witnesses.hpp>
#include <span>

namespace dynamy {

/// Largest separation among axes of one kind [m], and the axis: face i of A, face j of B, or edges
/// i and j.
struct PolyhedraAxis {
  double separation = -kInfinity;
  int i = -1, j = -1;
  Vec3 n = Vec3::UnitZ();  ///< from A to B, in axes of A
};

/// Separations in axes of A: C = R_Aᵀ R_B, t = R_Aᵀ (c_B − c_A).
class PolyhedraSeparation {
 public:
  PolyhedraSeparation(const PlacedPolyhedron& a, const PlacedPolyhedron& b);
  /// Separation along face normals; the search ends once it exceeds `reach` [m].
  PolyhedraAxis faces(double reach);
  /// Pairs of edges whose cross product is a face normal of A − B and separates by more than
  /// `least`, at least by that of `face`, the result of faces(). `same`: see kSameFeature.
  PolyhedraAxis edges(const PolyhedraAxis& face, double least, double same);

  const Mat3& C() const { return C_; }
  const Vec3& t() const { return t_; }

 private:
  struct Witness {
    Vec3 a, b;  ///< from A's point to B's in axes of A, from B's to A's in axes of B
  };
  int count() const { return static_cast<int>(A_.faces().size() + B_.faces().size()); }
  const Vec3& normal(int i) const {
    const int nA = static_cast<int>(A_.faces().size());
    return i < nA ? A_.face(i).n : B_.face(i - nA).n;
  }
  void add(const Vec3& w) { add(Witness{w, -(C_.transpose() * w)}); }
  void add(const Witness& w) {
    kept_[static_cast<std::size_t>(next_)] = w;
    next_ = (next_ + 1) % kKept, size_ = std::min(size_ + 1, kKept);
  }
  int furthest() const;
  PolyhedraAxis axis(int face);
  bool excludes(int face, double most) const;
  void addAround(const Vec3& n, double same);
  void edgesOn(int j, std::span<const int> ofA, PolyhedraAxis& best) const;

  static constexpr int kKept = 6;
  const Polyhedron &A_, &B_;
  Mat3 C_;
  Vec3 t_;
  double rounding_;  ///< of separations, with a margin [m]
  Witness middle_;
  std::array<Witness, kKept> kept_;
  std::array<Witness, 6> around_;
  int size_ = 0, next_ = 0;
};

}  // namespace dynamy
