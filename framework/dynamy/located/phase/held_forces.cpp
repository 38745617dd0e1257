#include <dynamy/core/decompositions.hpp>
#include <dynamy/located/phase/held_forces.hpp>

namespace dynamy {
namespace {

/// With so many forces, and more than this factor times the velocities, A has a low rank and is
/// inverted as a product of tall matrices: 2160 forces on 600 velocities in 0.4 s instead of 5.6 s.
constexpr Eigen::Index kManyForces = 256;
constexpr double kPerVelocity = 1.5;
constexpr double kRedundant = 1e-10;  ///< of the largest pivot

}  // namespace

void ForceDirections::find(const std::vector<Held>& held, const HeldRows& rows) {
  p0.setZero(rows.size()), kept.clear(), entries.clear();
  for (std::size_t i = 0; i < held.size(); ++i) add(held[i], rows, i);
}

Eigen::MatrixXd ForceDirections::P() const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(p0.size(), unknowns());
  for (Eigen::Index k = 0; k < unknowns(); ++k) out(kept[static_cast<std::size_t>(k)], k) = 1.0;
  for (const Entry& e : entries) out(e.row, e.unknown) = e.value;
  return out;
}

void ForceDirections::addForces(const Eigen::VectorXd& pi, Eigen::VectorXd& lambda) const {
  for (Eigen::Index k = 0; k < unknowns(); ++k) lambda[kept[static_cast<std::size_t>(k)]] += pi[k];
  for (const Entry& e : entries) lambda[e.row] += e.value * pi[e.unknown];
}

void ForceDirections::add(const Held& h, const HeldRows& rows, std::size_t i) {
  const ForceSet& set = rows.set(i);
  const int first = rows.row0(i), d = rows.dim(i);
  if (h.first == 0) normal = unknowns();
  if (!h.slips) {
    for (int r = 0; r < d; ++r) kept.push_back(first + r);
    return;
  }
  const int tangent = rows.slip0(i), k = rows.slipRows(i);
  const bool pressed = tangent > first;
  if (pressed) kept.push_back(first);
  // Direction of slip: γ_T of the stage; in one tangent, and while a slip starts, the decided one.
  const double* gamma = rows.gamma().data();
  const double speed = set.speed(k, gamma + tangent);
  const bool decided = k > 1 && (h.starts || !(speed > Held::kLeastSlip));
  const double* t = decided ? h.direction.data() : k > 1 ? gamma + tangent : &h.sign;
  if (set.form == ForceSet::Form::reservoir) {
    double force[kMostRows];
    set.set->support({d, 1.0, gamma + first}, k, t, force);
    for (int r = 0; r < k; ++r) entries.push_back({tangent + r, normal, -force[r]});
    return;
  }
  const double length = k > 1 ? ConstVec(t, k).norm() : 1.0;
  for (int r = 0; r < k; ++r) {
    const double e = t[r] / length;
    if (pressed || set.form == ForceSet::Form::disc)
      entries.push_back({tangent + r, normal, -set.upper * e});
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
  directions_.addForces(pi_, lambda_);
  rows.addForces(lambda_, a_);
}

/// M⁻¹W P. All rows of a contact act on the same mass blocks.
void HeldForces::multiplyByP(const HeldRows& rows) {
  const Eigen::MatrixXd& MInvW = rows.MInvW();
  const std::vector<int>& kept = directions_.kept;
  const Eigen::Index m = directions_.unknowns();
  if (m >= kManyForces)
    MInvWP_.setZero(MInvW.rows(), m);
  else
    MInvWP_.resize(MInvW.rows(), m);
  for (Eigen::Index k = 0; k < m; ++k)
    for (const HeldRows::Moved& p : rows.moved(kept[static_cast<std::size_t>(k)]))
      MInvWP_.col(k).segment(p.u0, p.nu) =
          MInvW.col(kept[static_cast<std::size_t>(k)]).segment(p.u0, p.nu);
  for (const ForceDirections::Entry& e : directions_.entries)
    for (const HeldRows::Moved& p : rows.moved(e.row))
      MInvWP_.col(e.unknown).segment(p.u0, p.nu) += e.value * MInvW.col(e.row).segment(p.u0, p.nu);
}

/// A of rows at another position, where contacts may act on other velocities.
void HeldForces::decomposeElsewhere(const HeldRows& rows, const AccelerationRows& constraint) {
  const std::vector<int>& kept = directions_.kept;
  const Eigen::Index m = directions_.unknowns();
  A_.setZero(m, m);
  for (Eigen::Index k = 0; k < m; ++k)
    for (Eigen::Index j = 0; j < m; ++j)
      for (const HeldRows::Moved& p : rows.moved(kept[static_cast<std::size_t>(j)]))
        A_(k, j) += constraint.R.col(kept[static_cast<std::size_t>(k)])
                        .segment(p.u0, p.nu)
                        .dot(MInvWP_.col(j).segment(p.u0, p.nu));
  A_ *= scale_.asDiagonal();
  inverse_.compute(A_, implied_);
}

/// A of the present rows.
void HeldForces::decompose(const HeldRows& rows) {
  const std::vector<int>& kept = directions_.kept;
  touching_.list(rows, kept);
  touching_.group(group_);
  inverse_.begin(group_);
  const Eigen::MatrixXd& W = rows.W();
  for (int j = 0; j < static_cast<int>(kept.size()); ++j)
    for (const HeldRows::Moved& p : rows.moved(kept[static_cast<std::size_t>(j)]))
      touching_.forEach(p.block, [&](int k) {
        inverse_.at(k, j) += scale_[j] * W.col(kept[static_cast<std::size_t>(k)])
                                             .segment(p.u0, p.nu)
                                             .dot(MInvWP_.col(j).segment(p.u0, p.nu));
      });
  inverse_.compute(implied_);
}

void HeldForces::findRightSide(const std::vector<Held>& held, const HeldRows& rows,
                               const AccelerationRows& constraint) {
  const bool present = &constraint == &rows.present();
  const Eigen::Index m = directions_.unknowns();
  rhs_.resize(m), scale_.resize(m), implied_.resize(static_cast<std::size_t>(m));
  std::size_t of = 0;
  for (Eigen::Index k = 0; k < m; ++k) {
    const int row = directions_.kept[static_cast<std::size_t>(k)];
    while (row >= rows.row0(of + 1)) ++of;
    rhs_[k] =
        -((present ? rows.along(row, a_) : constraint.R.col(row).dot(a_)) + constraint.r[row]);
    // Redundant forces are smallest in units of what each contact carries: a contact that presses
    // hard takes more of them.
    scale_[k] = held[of].weight;
    implied_[static_cast<std::size_t>(k)] =
        (held[of].implied >> (row - rows.row0(of)) & 1) != 0 ? 1 : 0;
  }
}

void HeldForces::solve(const std::vector<Held>& held, const HeldRows& rows, const Evaluation& e,
                       const AccelerationRows& constraint) {
  directions_.find(held, rows);
  begin(held, rows, e);
  redundant_ = false;
  const Eigen::Index m = directions_.unknowns();
  if (m == 0) return;
  multiplyByP(rows);
  findRightSide(held, rows, constraint);
  if (m >= kManyForces && static_cast<double>(m) > kPerVelocity * static_cast<double>(a_.size())) {
    product_.compute(constraint.R(Eigen::all, directions_.kept).transpose(),
                     scale_.asDiagonal() * MInvWP_.transpose());
    redundant_ = product_.rank() < m;
    product_.solve(rhs_, pi_);
    cubes += static_cast<double>(m * a_.size() * a_.size());
  } else {
    if (&constraint == &rows.present())
      decompose(rows);
    else
      decomposeElsewhere(rows, constraint);
    inverse_.solve(rhs_, pi_);
    redundant_ = inverse_.rank() < m;
    cubes += inverse_.cubes();
  }
  pi_.array() *= scale_.array();
  for (Eigen::Index k = 0; k < m; ++k)
    for (const HeldRows::Moved& p : rows.moved(directions_.kept[static_cast<std::size_t>(k)]))
      a_.segment(p.u0, p.nu) += pi_[k] * MInvWP_.col(k).segment(p.u0, p.nu);
  directions_.addForces(pi_, lambda_);
}

Eigen::MatrixXd HeldForces::open() const {
  const Eigen::Index m = directions_.unknowns();
  if (m == 0 || m >= kManyForces) return Eigen::MatrixXd(lambda_.size(), 0);
  // Rows of light and heavy bodies count alike.
  const Eigen::MatrixXd A = inverse_.matrix();
  Eigen::VectorXd row = A.rowwise().norm(), column = A.colwise().norm();
  for (Eigen::VectorXd* x : {&row, &column})
    for (double& v : *x) v = v > 0.0 ? 1.0 / v : 0.0;
  const Eigen::MatrixXd Z = nullSpace(row.asDiagonal() * A * column.asDiagonal(), kRedundant);
  return directions_.P() * (scale_.cwiseProduct(column)).asDiagonal() * Z;
}

void HeldForces::findImplied(std::vector<Held>& held, const HeldRows& rows) {
  for (Held& h : held) h.implied = 0;
  const Eigen::Index m = directions_.unknowns();
  if (!redundant_ || m >= kManyForces) return;
  implied_.assign(static_cast<std::size_t>(m), 0);
  inverse_.findImplied(implied_);
  std::size_t of = 0;
  for (std::size_t k = 0; k < implied_.size(); ++k) {
    const int row = directions_.kept[k];
    while (row >= rows.row0(of + 1)) ++of;
    if (implied_[k] != 0) held[of].implied |= 1 << (row - rows.row0(of));
  }
}

}  // namespace dynamy
