/// SharedForces: forces of redundant rows that stay away from all bounds (theory 50.1b).
///
///   λ(z) = λ⁰ + N z,   maximise  Σ_i log Q_i(λ) − ½ Σ_r (λ_r/λ_max)²
///   Q = L² − |λ_T|²  with the bound L on the size of λ_T,   or Q = L of a force with a bound
///
/// The columns of N change no row that is held. The maximum, the analytic centre of the forces that
/// the statuses permit, depends neither on λ⁰ nor on the order of contacts.
#pragma once
#include <dynamy/located/phase/held_rows.hpp>

namespace dynamy {

class SharedForces {
 public:
  /// Begins with the changes N of forces (rows × any number) that are open.
  void open(const std::vector<Held>& held, const HeldRows& rows, const Eigen::MatrixXd& N);
  /// True: the force of held[i], or its bound, depends on how rows share.
  bool shares(std::size_t i) const { return shares_[i] != 0; }
  /// Changes `lambda` to the centre. False: no forces within all bounds were found.
  bool centre(const std::vector<Held>& held, const HeldRows& rows, Eigen::VectorXd& lambda);

 private:
  /// |λ_T| ≤ L, L = factor λ_normal + constant; each part is the value at λ⁰ and its changes by z.
  struct Bound {
    double constant = 0.0;
    Eigen::VectorXd normal;   ///< dL/dz
    Eigen::VectorXd size;     ///< λ_T at λ⁰; empty: L ≥ 0 alone
    Eigen::MatrixXd tangent;  ///< dλ_T/dz
  };
  void find(const std::vector<Held>& held, const HeldRows& rows, const Eigen::VectorXd& lambda);
  double outside(const Eigen::VectorXd& z) const;
  double value(const Eigen::VectorXd& z, double shift) const;
  void derivatives(const Eigen::VectorXd& z, double shift, Eigen::VectorXd& gradient,
                   Eigen::MatrixXd& hessian) const;
  bool climb(double shift, Eigen::VectorXd& z) const;
  Eigen::MatrixXd N_, scaled_;
  Eigen::VectorXd forces_;  // λ⁰/λ_max
  std::vector<char> shares_;
  std::vector<Bound> bounds_;
};

}  // namespace dynamy
