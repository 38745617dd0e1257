/// Linearisation: small disturbances of a steady motion, and their eigenvalues (theory 41.1).
///
///   q = q₀(t) ⊕ F δ,  u = u₀ + w,  u₀ constant,  z = (δ, w):      ż = A z,   C z = 0
///
///   A = ⎡ K       I     ⎤     C = ⎡ ∂γ/∂δ   Wᵀ ⎤  rows that are held    z = B y, columns of B
///       ⎣ ∂u̇/∂δ  ∂u̇/∂w ⎦         ⎣ ∂g/∂δ   0  ⎦  their positions       orthonormal, CB = 0
///
///   ẏ = Bᵀ A B y
///
/// K is the effect that rotations of the frame have on δ (zero where q̇ = u). u̇ comes from the
/// equations of motion with all constraints on acceleration level, so that C z stays zero by
/// itself. Derivatives are difference quotients, extrapolated to step zero. Coordinates on which
/// the equations do not depend (position, heading, angle of a wheel) give eigenvalues that are
/// exactly zero, often in Jordan blocks. These are split off first, because the other eigenvalues
/// would lose half of their digits otherwise. Rejected: eliminating constraints by hand, which
/// needs independent coordinates; and eigenvalues of the pencil (A, E) with multipliers as
/// unknowns, some of which are infinite.
#pragma once
#include <dynamy/simulation/linear/held_motion.hpp>

namespace dynamy {

struct LinearisationOptions {
  /// How near the given state is to the steady motion, as a share. Gaps up to this share of the
  /// scene's length count as closed; slips up to this share of the fastest velocity, or of 1 m/s,
  /// count as sticking.
  double near = 1e-6;
  /// True: searches for a steady motion near the given state; false: that state must be one.
  bool seek = true;
};

struct Linearisation {
  State at;                        ///< the steady motion
  double moved = 0.0;              ///< its distance from the given state, |(δ, w)|
  double residual = 0.0;           ///< largest |u̇| left [m/s², rad/s²]
  std::vector<std::string> names;  ///< of z: first δ, then w
  Eigen::MatrixXd basis;           ///< B, 2 nu × n
  Eigen::MatrixXd A;               ///< BᵀAB, n × n
  double error = 0.0;              ///< estimate of the largest error of an entry of A
  double leak = 0.0;               ///< largest entry of C A B: 0 but for errors
  double noise = 0.0;              ///< singular values and real parts up to this are zero [1/s]
  int zeros = 0;                   ///< eigenvalues that are zero, not among those below
  Eigen::VectorXcd eigenvalues;    ///< by growing real part [1/s]
  Eigen::MatrixXcd modes;          ///< z of each, largest |w| 1, 2 nu × eigenvalues
  std::vector<HeldMotion::Contact> contacts;
  /// Elements that sample the motion, whose outputs are held at their values at the motion: loops that
  /// they close are not in A.
  std::vector<std::string> sampled;
  int growing() const;  ///< eigenvalues with a positive real part
};

/// Names of the elements of a model that sample its motion at instants of their own.
std::vector<std::string> samplingElements(const Model& model);

/// Throws ModelError if no steady motion is found, if a contact does not permit its force, or if
/// the linear equations change along the motion.
Linearisation linearise(Model& model, const State& from, const LinearisationOptions& options = {});

/// Nonzero eigenvalues of A by growing real part, and their eigenvectors; singular values below
/// `noise` are zero. Returns how many eigenvalues are zero.
int nonzeroEigenvalues(const Eigen::MatrixXd& A, double noise, Eigen::VectorXcd& values,
                       Eigen::MatrixXcd& vectors);

}  // namespace dynamy
