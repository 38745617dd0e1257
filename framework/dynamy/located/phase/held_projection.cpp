#include <dynamy/located/phase/held_projection.hpp>

namespace dynamy {

bool HeldProjection::solve(const HeldRows& rows, const Eigen::VectorXd& error,
                           Eigen::VectorXd& delta) {
  const auto m = static_cast<Eigen::Index>(kept_.size());
  const Eigen::MatrixXd &W = rows.W(), &MInvW = rows.MInvW();
  rhs_.resize(m);
  bool off = false;
  for (Eigen::Index k = 0; k < m; ++k) {
    rhs_[k] = -error[kept_[static_cast<std::size_t>(k)]];
    off = off || rhs_[k] != 0.0;
  }
  delta.setZero(W.rows());
  if (!off) return false;
  G_.setZero(m, m);
  touching_.list(rows, kept_);
  for (Eigen::Index j = 0; j < m; ++j) {
    const int row = kept_[static_cast<std::size_t>(j)];
    for (const HeldRows::Moved& p : rows.moved(row))
      touching_.forEach(p.block, [&](int k) {
        G_(k, j) += W.col(kept_[static_cast<std::size_t>(k)])
                        .segment(p.u0, p.nu)
                        .dot(MInvW.col(row).segment(p.u0, p.nu));
      });
  }
  inverse_.compute(G_);
  inverse_.solve(rhs_, Lambda_);
  for (Eigen::Index k = 0; k < m; ++k) {
    const int row = kept_[static_cast<std::size_t>(k)];
    for (const HeldRows::Moved& p : rows.moved(row))
      delta.segment(p.u0, p.nu) += Lambda_[k] * MInvW.col(row).segment(p.u0, p.nu);
  }
  return true;
}

bool HeldProjection::positions(const std::vector<Held>& held, const HeldRows& rows,
                               const Evaluation& e, Eigen::VectorXd& delta) {
  kept_.clear();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const SetValuedForceLaw& law = *e.contacts.law[static_cast<std::size_t>(rows.contact(i))];
    const int dim = rows.dim(i);
    const bool inNotch = !held[i].slips && hasNotch(law, dim);
    for (int r = 0; r < dim; ++r)
      if (!yields(law.rowKind(held[i].first + r)) || inNotch) kept_.push_back(rows.row0(i) + r);
  }
  return solve(rows, rows.position(), delta);
}

bool HeldProjection::velocities(const std::vector<Held>& held, const HeldRows& rows,
                                const Evaluation& e, Eigen::VectorXd& delta) {
  kept_.clear();
  for (std::size_t i = 0; i < held.size(); ++i) {
    const SetValuedForceLaw& law = *e.contacts.law[static_cast<std::size_t>(rows.contact(i))];
    for (int r = 0; r < rows.dim(i); ++r)
      if (!held[i].slips || law.rowKind(held[i].first + r) == RowKind::normal)
        kept_.push_back(rows.row0(i) + r);
  }
  return solve(rows, rows.gamma(), delta);
}

}  // namespace dynamy
