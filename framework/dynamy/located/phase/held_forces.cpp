#include <dynamy/located/phase/held_forces.hpp>

namespace dynamy {
namespace {

/// With so many forces, and more than this factor times the velocities, A has a low rank and is
/// inverted as a product of tall matrices: 2160 forces on 600 velocities in 0.4 s instead of 5.6 s.
constexpr Eigen::Index kManyForces = 256;
constexpr double kPerVelocity = 1.5;

}  // namespace

void ForceDirections::find(const std::vector<Held>& held, const HeldRows& rows) {
  const int n = rows.size();
  P.setZero(n, n), p0.setZero(n), kept.clear();
  for (std::size_t i = 0; i < held.size(); ++i) add(held[i], rows, i);
}

/// The force of this row is the next unknown.
void ForceDirections::hold(int row) {
  P(row, unknowns()) = 1.0;
  kept.push_back(row);
}

void ForceDirections::add(const Held& h, const HeldRows& rows, std::size_t i) {
  const ForceSet& set = rows.set(i);
  const int first = rows.row0(i), d = rows.dim(i);
  if (h.first == 0) normal = unknowns();
  if (!h.slips) {
    for (int r = 0; r < d; ++r) hold(first + r);
    return;
  }
  const int tangent = rows.slip0(i), k = rows.slipRows(i);
  const bool pressed = tangent > first;
  if (pressed) hold(first);
  // Direction of slip: γ_T of the stage; in one tangent, and while a slip starts, the decided one.
  const double* gamma = rows.gamma().data();
  const double speed = set.speed(k, gamma + tangent);
  const bool decided = k > 1 && (h.starts || !(speed > Held::kLeastSlip));
  const double* t = decided ? h.direction.data() : k > 1 ? gamma + tangent : &h.sign;
  if (set.form == ForceSet::Form::reservoir) {
    double force[kMostRows];
    set.set->support({d, 1.0, gamma + first, nullptr}, k, t, force);
    for (int r = 0; r < k; ++r) P(tangent + r, normal) = -force[r];
    return;
  }
  const double length = k > 1 ? ConstVec(t, k).norm() : 1.0;
  for (int r = 0; r < k; ++r) {
    const double e = t[r] / length;
    if (pressed || set.form == ForceSet::Form::disc)
      P(tangent + r, normal) = -set.upper * e;
    else
      p0[tangent + r] = e > 0.0 ? set.lower * e : -set.upper * e;
  }
}

/// λ = p₀ + P π₀ and u̇ = M⁻¹(h + W λ), with π₀ of the last decision.
void HeldForces::begin(const std::vector<Held>& held, const HeldRows& rows, const Evaluation& e) {
  a_.resize(e.h.size());
  e.mass.applyInverse(view(e.h), view(a_));
  const Eigen::Index m = directions_.unknowns();
  lambda_ = directions_.p0;
  pi_.resize(m);
  std::size_t of = 0;
  for (Eigen::Index k = 0; k < m; ++k) {
    const int row = directions_.kept[static_cast<std::size_t>(k)];
    while (row >= rows.row0(of + 1)) ++of;
    pi_[k] = held[of].lambda[static_cast<std::size_t>(row - rows.row0(of))];
  }
  lambda_.noalias() += directions_.P.leftCols(m) * pi_;
  a_.noalias() += rows.MInvW() * lambda_;
}

/// M⁻¹W P; each of its columns combines only few columns of M⁻¹W.
void HeldForces::multiplyByP(const Eigen::MatrixXd& MInvW) {
  const Eigen::MatrixXd& P = directions_.P;
  const Eigen::Index m = directions_.unknowns();
  MInvWP_.setZero(MInvW.rows(), m);
  for (Eigen::Index k = 0; k < m; ++k)
    for (Eigen::Index row = 0; row < P.rows(); ++row)
      if (P(row, k) != 0.0) MInvWP_.col(k) += P(row, k) * MInvW.col(row);
}

void HeldForces::assemble(const std::vector<Held>& held, const HeldRows& rows,
                          const AccelerationRows& constraint) {
  const std::vector<int>& kept = directions_.kept;
  const Eigen::MatrixXd& R = constraint.R;
  const Eigen::Index m = directions_.unknowns();
  A_.resize(m, m), rhs_.resize(m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const int row = kept[static_cast<std::size_t>(k)];
    rhs_[k] = -(R.col(row).dot(a_) + constraint.r[row]);
    if (&constraint != &rows.present()) {  // elsewhere contacts may act on other velocities
      A_.row(k).noalias() = R.col(row).transpose() * MInvWP_;
      continue;
    }
    A_.row(k).setZero();
    for (const HeldRows::Moved& p : rows.moved(row))
      A_.row(k).noalias() +=
          R.col(row).segment(p.u0, p.nu).transpose() * MInvWP_.middleRows(p.u0, p.nu);
  }
  // Redundant forces are smallest in units of what each contact carries: a contact that presses
  // hard takes more of them.
  scale_.resize(m);
  std::size_t of = 0;
  for (Eigen::Index k = 0; k < m; ++k) {
    while (kept[static_cast<std::size_t>(k)] >= rows.row0(of + 1)) ++of;
    scale_[k] = held[of].weight;
    A_.col(k) *= scale_[k];
  }
}

void HeldForces::solve(const std::vector<Held>& held, const HeldRows& rows, const Evaluation& e,
                       const AccelerationRows& constraint) {
  directions_.find(held, rows);
  begin(held, rows, e);
  redundant_ = false;
  const Eigen::Index m = directions_.unknowns();
  if (m == 0) return;
  multiplyByP(rows.MInvW());
  assemble(held, rows, constraint);
  if (m >= kManyForces && static_cast<double>(m) > kPerVelocity * static_cast<double>(a_.size())) {
    product_.compute(constraint.R(Eigen::all, directions_.kept).transpose(),
                     scale_.asDiagonal() * MInvWP_.transpose());
    redundant_ = product_.rank() < m;
    product_.solve(rhs_, pi_);
  } else {
    inverse_.compute(A_);
    redundant_ = inverse_.rank() < m;
    inverse_.solve(rhs_, pi_);
  }
  pi_.array() *= scale_.array();
  a_.noalias() += MInvWP_ * pi_;
  lambda_.noalias() += directions_.P.leftCols(m) * pi_;
}

}  // namespace dynamy
