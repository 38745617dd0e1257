/// PackedContacts: an inclusion problem laid out for sweeps over rigid bodies.      (theory 4.14)
///
///   M_b⁻¹ = S_b S_bᵀ,   v' = Sᵀ W Λ,   W' = WS:      ξ = c + A v'_a + B v'_b,   v'_a += Aᵀ ΔΛ
///
/// With v' in place of v = M⁻¹WΛ one matrix per body serves both products. Eight contacts that
/// share no body form a batch; the same number of all eight is stored in a row of eight, so that a
/// step over a batch is plain arithmetic on rows. A contact goes into a batch if it touches one or
/// two mass blocks of at most six velocities and its law is Λ_N ≥ 0 or Coulomb's cone. All other
/// contacts stay apart and are solved one by one, with the same velocities. A contact side without
/// a body refers to a block that never moves.
///
/// Rejected: contacts one after the other with loops over their segments (twelve times the time per
/// contact), single precision (no gain if the numbers are in the cache).
#pragma once
#include <cstdint>
#include <dynamy/solver/local/local_solution.hpp>
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

inline constexpr int kLanes = 8;  ///< contacts of a batch
using Lanes = double[kLanes];     ///< one number of each contact of a batch

/// Eight contacts of at most three rows N, T, S. Unused lanes are zero.
struct alignas(64) PackedBatch {
  Lanes a[18], b[18];  ///< AᵀT row after row: six numbers of N, six of T, six of S
  Lanes c[3];          ///< [m/s]
  Lanes dT, dS;        ///< G_TN, G_SN  [1/kg]
  Lanes rN, rT, mu;    ///< 1/G_NN, 1/λ_max(G_TT) [kg]
  Lanes rho;           ///< step of the natural map, 1/λ(G_ii) [kg]
  Lanes Lambda[3];     ///< [N s]
  Lanes last[3];       ///< Λ of the previous sweep
  std::int32_t bodyA[kLanes], bodyB[kLanes];  ///< where v' of the bodies is
  std::int32_t row[kLanes], dim[kLanes];      ///< in the problem; dim 0: unused lane
};

/// v' of a mass block, or eight numbers of v' of a larger block.
struct alignas(64) PackedVelocity {
  double v[kLanes] = {};
};

/// Largest |e|²/ρ², |e|², |Λ|² over contacts, e the natural map.
struct PackedMeasure {
  double velocity2 = 0.0, force2 = 0.0, Lambda2 = 0.0;
};

class PackedContacts {
 public:
  /// Packs the contacts; those that carry nothing in Λ come into batches of their own. False: the
  /// problem has no bodies, or a mass without inverse; nothing is prepared.
  bool prepare(const InclusionProblem& problem, const double* Lambda);
  /// Loads Λ and computes v' from it; the last change of both is forgotten.
  void load(const double* Lambda);
  void store(double* Lambda) const;
  /// Makes one sweep from Λ + β (Λ − Λ_last), with v' extrapolated likewise. The result
  /// Σ w (Λ̃ − Λ⁺)·(Λ⁺ − Λ) is positive if the extrapolation leads uphill. Without `all`, batches
  /// that carry nothing are passed over.
  double sweep(const InclusionProblem& problem, double beta, bool all);
  /// Recomputes v' from Λ and evaluates the natural maps of all contacts.
  PackedMeasure measure(const InclusionProblem& problem);
  /// max_i ρ_i [kg], from which the floor of E_f follows.
  double largestRho() const { return largestRho_; }
  int batches() const { return static_cast<int>(batches_.size()); }
  /// Contacts that are solved one by one.
  int apart() const { return static_cast<int>(apart_.size()); }

 private:
  struct ApartSegment {
    int slot, nu;
    std::ptrdiff_t w;  ///< its dim × nu numbers in apartW_
  };
  struct Apart {
    int contact, row, dim, segment0, segments;
    double rho;
  };
  bool scaleBlocks(const InclusionProblem& problem);
  /// Computes a row of W' of a segment from the row `w` of W.
  void scaleRow(const Segment& segment, const double* w, double* out) const;
  bool inBatch(const InclusionProblem& problem, int i, const SimpleSet& set) const;
  void batch(const InclusionProblem& problem, int i, const SimpleSet& set);
  void fillLane(const InclusionProblem& problem, int i, const SimpleSet& set, PackedBatch& batch,
                int lane);
  PackedBatch& openBatch(int slotA, int slotB, int& lane);
  void close(int open);
  void setApart(const InclusionProblem& problem, int i);
  /// Recomputes v' from Λ.
  void renew();
  double sweepApart(const InclusionProblem& problem, double beta);
  void apartVelocity(const Apart& contact, double* gamma) const;
  void apartImpulse(const Apart& contact, const double* delta);

  std::vector<PackedBatch> batches_, open_;
  std::vector<int> openLanes_;  ///< used lanes of the open batches
  std::vector<PackedVelocity> v_, vLast_;
  std::vector<int> slot_;               ///< mass block → its first v', −1: untouched
  std::vector<std::uint32_t> inOpen_;   ///< v' → open batches that move it
  std::vector<std::ptrdiff_t> scale0_;  ///< mass block → its S
  std::vector<double> scale_;           ///< diagonal, or lower triangle row after row
  std::vector<Apart> apart_;
  std::vector<ApartSegment> apartSegment_;
  std::vector<double> apartW_, apartLambda_, apartLast_, apartR_, apartAll_;
  LocalSolutions local_;  ///< closed forms of the contacts apart
  const MassMatrix* mass_ = nullptr;
  double largestRho_ = 0.0;
};

}  // namespace dynamy
