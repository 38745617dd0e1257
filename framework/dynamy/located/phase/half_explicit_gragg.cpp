#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/half_explicit_gragg.hpp>

namespace dynamy {

void HalfExplicitGragg::rate(const MechanicalSystem& s, const State& x) {
  if (plain_)
    qdot_ = x.u;
  else
    configurationRate(*s.parts().topology, x, qdot_);
}

bool HalfExplicitGragg::column(MechanicalSystem& s, FrozenPhase& phase, const State& from, int n) {
  const double h = h_ / n;
  Eigen::VectorXd& T = T_[static_cast<std::size_t>(n / 2 - 1)];
  T.setZero(nq_ + nu_ + rows_ + 5);
  past_ = from, now_ = from;
  for (int k = 0; k < n; ++k) {
    const double tau = k == 0 ? h : 2.0 * h;
    if (k > 0) s.evaluate(now_, stages_);
    const Evaluation& e = s.slot(k == 0 ? 0 : 1);
    rate(s, now_);
    next_.t = from.t + (k + 1) * h;
    next_.q = past_.q + tau * qdot_;
    next_.u = now_.u;
    next_.memory = from.memory;
    if (!phase.advance(e, now_.u, look_.at(s, next_, phase.request.in(0).held), past_.u, tau, a_))
      return false;
    next_.u = past_.u + tau * a_;
    if (k % 2 == 1) {  // impulse and works from one even sub-step to the next
      T.segment(nq_ + nu_, rows_) += tau * phase.lambda();
      for (std::size_t w = 0; w < 5; ++w)
        T[nq_ + nu_ + rows_ + static_cast<Eigen::Index>(w)] += tau * phase.power()[w];
    }
    std::swap(past_, now_), std::swap(now_, next_);
  }
  T.head(nq_) = now_.q, T.segment(nq_, nu_) = now_.u;
  return true;
}

bool HalfExplicitGragg::take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& start,
                             double h, State& to) {
  const State& from = start.x;
  const int columns = columns_;
  h_ = h, t0_ = from.t, nq_ = from.q.size(), nu_ = from.u.size();
  // A slip that starts has the direction of γ̇_T, which needs the bias.
  EvaluationRequest first = phase.request.in(0);
  stages_ = phase.request.ofStage();
  first.bias = stages_.bias =
      std::any_of(phase.held.begin(), phase.held.end(), [](const Held& x) { return x.starts; });
  s.evaluate(from, first);
  rows_ = countRows(phase.held, s.slot(0));
  bool good = true;
  for (int j = 1; good && j <= columns; ++j) good = column(s, phase, from, 2 * j);
  if (!good) return false;
  // Aitken's and Neville's scheme; T_[j] holds T_{j,l} after l passes over the columns below it.
  for (int l = 1; l < columns; ++l) {
    if (l == columns - 1) error_ = T_[static_cast<std::size_t>(columns - 1)];
    for (int j = columns - 1; j >= l; --j) {
      const auto at = static_cast<std::size_t>(j);
      const double ratio = static_cast<double>(j + 1) / (j + 1 - l);
      T_[at] += (T_[at] - T_[at - 1]) / (ratio * ratio - 1.0);
    }
  }
  if (columns == 1) {  // error estimate: difference to Euler's rule
    error_.setZero(best().size());
    rate(s, from);
    error_.head(nq_) = from.q + h * qdot_, error_.segment(nq_, nu_) = from.u;
  }
  error_ = best() - error_;
  to.t = from.t + h, to.q = best().head(nq_), to.u = best().segment(nq_, nu_);
  impulse_ = best().segment(nq_ + nu_, rows_);
  std::copy_n(best().data() + nq_ + nu_ + rows_, works_.size(), works_.begin());
  return true;
}

double HalfExplicitGragg::error(const ErrorNorm& norm, const State& from, const State& to) {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < nq_; ++i)
    worst = std::max(worst,
                     norm.position(i, error_[i], std::max(std::abs(from.q[i]), std::abs(to.q[i]))));
  for (Eigen::Index i = 0; i < nu_; ++i)
    worst = std::max(
        worst, norm.velocity(i, error_[nq_ + i], std::max(std::abs(from.u[i]), std::abs(to.u[i]))));
  return worst;
}

bool HalfExplicitGragg::prepareDense(MechanicalSystem& s, FrozenPhase&, const PhasePoint& from,
                                     const PhasePoint& to) {
  through_.through(s, from, to);
  return true;
}

}  // namespace dynamy
