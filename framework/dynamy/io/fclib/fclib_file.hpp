#pragma once
/// \file
/// Contact problems in the HDF5 layout of FCLIB, the collection of problems of
/// [acary_bremond_huber2018].
///
///   local:   u = W r + q
///   global:  M v = H r + f,  u = Hᵀ v + w;     W = Hᵀ M⁻¹ H,  q = Hᵀ M⁻¹ f + w
///   law:     K_μ* ∋ u_c + μ_c |u_T,c| e_n ⊥ r_c ∈ K_μ      for every contact c
///
/// In the letters of this framework: G = W, c = q, Λ = r, ξ = u. A contact has `dim` rows, the
/// normal first; rolling problems have 5 (n, t1, t2, m1, m2). Plain complementarity problems in the
/// layout /lcp/M, /lcp/q are read as well, with dim = 1.

#include <Eigen/SparseCore>
#include <dynamy/solver/problem/given_problem.hpp>
#include <filesystem>
#include <string>

namespace dynamy {

struct FclibProblem {
  bool global = false;
  int dim = 3;  ///< rows of a contact: 1 (complementarity), 2, 3 or 5 (rolling)
  std::string title, description, mathInfo;
  Eigen::SparseMatrix<double> W;  ///< local form
  Eigen::VectorXd q;              ///< local form
  Eigen::SparseMatrix<double> M, H;
  Eigen::VectorXd f, w;
  Eigen::VectorXd mu;         ///< one a contact; empty for dim = 1
  Eigen::VectorXd muRolling;  ///< one a contact; for dim = 5
  int rows() const { return static_cast<int>(global ? w.size() : q.size()); }
  int contacts() const { return rows() / dim; }
};

/// r, u and, for global problems, v; empty vectors are not written.
struct FclibSolution {
  Eigen::VectorXd r, u, v;
};

/// \throws ModelError `file: error: /place/in/the/file: reason`
FclibProblem readFclib(const std::filesystem::path& file);
/// Matrices as compressed columns. \throws ModelError the file cannot be written
void writeFclib(const std::filesystem::path& file, const FclibProblem& problem,
                const FclibSolution& solution = {});

/// The local form of a global problem; a local problem is returned unchanged. \throws ModelError M
/// is singular
FclibProblem condensed(const FclibProblem& problem);
/// v = M⁻¹ (H r + f). \throws ModelError M is singular
Eigen::VectorXd velocities(const FclibProblem& global, const Eigen::VectorXd& r);

/// A local problem as laws and numbers in the form that the solvers take.
std::unique_ptr<GivenProblem> inclusionProblem(const FclibProblem& local);

}  // namespace dynamy
