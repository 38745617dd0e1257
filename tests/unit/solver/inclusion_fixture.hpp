// Inclusion problems by hand: mass blocks and rows of Wᵀ as plain matrices.
#pragma once
#include <Eigen/Eigenvalues>
#include <dynamy/contact/contact_sink.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/solver/problem/inclusion_solver.hpp>
#include <memory>
#include <random>
#include <vector>

namespace dynamy::fixture {

/// One mass block with a given constant M.
class MassBlock final : public PartialMechanicalSystem {
 public:
  explicit MassBlock(Eigen::MatrixXd M) : M_(std::move(M)) {}
  Blocks blocks() const override {
    const int n = static_cast<int>(M_.rows());
    return {.nq = n, .nu = n, .constantMass = true};
  }
  void initialState(Vec q, Vec u) const override { q.setZero(), u.setZero(); }
  void M(double, ConstVec, MassBlocks M) const override { M[0] = M_; }
  void h(double, ConstVec, ConstVec, Vec h) const override { h.setZero(); }

 private:
  Eigen::MatrixXd M_;
};

class Inclusion {
 public:
  explicit Inclusion(const std::vector<Eigen::MatrixXd>& masses) {
    std::vector<const PartialMechanicalSystem*> all;
    for (const Eigen::MatrixXd& M : masses) {
      systems_.push_back(std::make_unique<MassBlock>(M));
      all.push_back(systems_.back().get());
    }
    topology_ = std::make_unique<Topology>(all);
    mass.resize(*topology_);
    const Eigen::VectorXd q = Eigen::VectorXd::Zero(topology_->nq());
    mass.evaluate(*topology_, 0.0, view(q));
    contacts.clear();
  }
  /// G = SSᵀ: one block of mass 1, one contact a row of S.
  Inclusion(const Eigen::MatrixXd& S, const SetValuedForceLaw& law)
      : Inclusion(std::vector<Eigen::MatrixXd>{Eigen::MatrixXd::Identity(S.cols(), S.cols())}) {
    for (Eigen::Index i = 0; i < S.rows(); ++i) contact(law, S.row(i));
  }
  Inclusion(const Inclusion&) = delete;
  Inclusion& operator=(const Inclusion&) = delete;
  /// Adds a contact with rows Wt (dim × nu of all); blocks with zeros only get no segment.
  void contact(const SetValuedForceLaw& law, const Eigen::MatrixXd& Wt) {
    ContactSink sink(contacts, {});
    auto rows = sink.add(contacts.key.size(), 0.0, law, static_cast<int>(Wt.rows()));
    for (int b = 0; b < mass.blocks(); ++b) {
      const Eigen::MatrixXd part = Wt.middleCols(mass.u0(b), mass.nu(b));
      if (part.isZero(0.0)) continue;
      rows.segment(BlockPlace{b, mass.u0(b), mass.nu(b)}) = part;
    }
  }
  /// ξ = GΛ + c with γ^A = 0, u_ref = max|c|.
  InclusionProblem& pose(const Eigen::VectorXd& c, double dt = 1.0,
                         Delassus::Form form = Delassus::Form::automatic) {
    G.assemble(contacts, mass, form);
    problem.G = &G, problem.contacts = &contacts, problem.dt = dt;
    problem.c.assign(c.data(), c.data() + c.size());
    problem.gammaFree = problem.c;
    problem.gammaA.assign(problem.c.size(), 0.0);
    problem.cNoise.clear();
    problem.uRef = c.size() > 0 && !c.isZero(0.0) ? c.lpNorm<Eigen::Infinity>() : 1.0;
    return problem;
  }
  Eigen::MatrixXd dense() {
    Eigen::MatrixXd out(G.rows(), G.rows());
    for (int j = 0; j < G.rows(); ++j) {
      const Eigen::VectorXd e = Eigen::VectorXd::Unit(G.rows(), j);
      G.apply(e.data(), out.col(j).data());
    }
    return out;
  }

  MassMatrix mass;
  ContactSet contacts;
  Delassus G;
  InclusionProblem problem;

 private:
  std::vector<std::unique_ptr<MassBlock>> systems_;
  std::unique_ptr<Topology> topology_;
};

/// Symmetric root of a symmetric positive semidefinite matrix.
inline Eigen::MatrixXd symmetricRoot(const Eigen::MatrixXd& G) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(G);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
         eigen.eigenvectors().transpose();
}

inline Eigen::MatrixXd randomMatrix(std::mt19937& random, int rows, int cols) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd A(rows, cols);
  for (double& x : A.reshaped()) x = normal(random);
  return A;
}
inline Eigen::MatrixXd randomMass(std::mt19937& random, int n) {
  const Eigen::MatrixXd A = randomMatrix(random, n, n);
  return A * A.transpose() + 0.2 * Eigen::MatrixXd::Identity(n, n);
}

}  // namespace dynamy::fixture
