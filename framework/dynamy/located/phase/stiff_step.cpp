// SmoothStep: implicit steps, and the choice between them and explicit steps.
#include <algorithm>
#include <cmath>
#include <dynamy/located/phase/smooth_step.hpp>

namespace dynamy {
namespace {

// A motion is stiff if h |λ| is above this bound of stability for kManySteps steps, without kOthers
// steps below it in a row [hairer_wanner1996, IV.2].
constexpr double kBound5 = 3.25, kBound8 = 6.1;
constexpr int kManySteps = 15, kOthers = 6;
/// At tight tolerances steps are shorter: the fast part is accurate, not only stable. A damped fast
/// part draws both states of a step together, along its own direction. Such a step counts as a part
/// of a step at the bound, so that a trial in vain costs no more than a tenth.
constexpr double kDamped = 0.8, kAlong = 0.9, kStiffPart = 0.1;
/// An implicit step with h |λ| below this could be taken explicitly, too.
constexpr double kSmallStep = 2.0;
constexpr double kMostGrowth = 6.0;
constexpr int kSomeSteps = 10;  ///< such implicit steps before explicit ones take over
/// Implicit steps after which their work is compared with that of explicit steps: they may have
/// grown 1296 times by then. The explicit steps before must have cost at least as much as such a
/// trial, and four times as much after each trial that failed.
constexpr int kTrial = 4;
constexpr double kCostlierThanExplicit = 4.0;
/// Work of a real and a complex factorisation of n unknowns, 10/3 n³, in evaluations of some 400 n.
constexpr double kFactorise = 1.0 / 120.0;
/// Iterations of Newton's method in a step without difficulties.
constexpr int kUsual = 4;

/// −cos of the angle between a difference of states and that of their rates, in units of the
/// tolerance: 1 where all of it decays at one rate.
double decay(const ErrorNorm& norm, const PhasePoint& to, const State& stage,
             const Eigen::Ref<const Eigen::VectorXd>& qdot,
             const Eigen::Ref<const Eigen::VectorXd>& a) {
  double dot = 0.0, states = 0.0, rates = 0.0;
  const auto add = [&](double unit, double y, double f) {
    dot += unit * unit * y * f, states += unit * unit * y * y, rates += unit * unit * f * f;
  };
  for (Eigen::Index i = 0; i < to.x.q.size(); ++i)
    add(norm.position(i, 1.0, 0.0), to.x.q[i] - stage.q[i], to.qdot[i] - qdot[i]);
  for (Eigen::Index i = 0; i < to.x.u.size(); ++i)
    add(norm.velocity(i, 1.0, 0.0), to.x.u[i] - stage.u[i], to.a[i] - a[i]);
  return states > 0.0 && rates > 0.0 ? -dot / std::sqrt(states * rates) : 0.0;
}

}  // namespace

void SmoothStep::implicit(bool wanted, const MechanicalSystem& s, const ErrorNorm& norm) {
  implicit_ = wanted, stiff_ = other_ = tried_ = 0.0;
  forgetJacobian();
  if (!wanted) return;
  const Topology& topology = *s.parts().topology;
  const Eigen::Index nq = topology.nq(), nu = topology.nu();
  Eigen::VectorXd scale(nq + nu);
  for (Eigen::Index i = 0; i < nq; ++i)
    scale[i] = 1.0 / (norm.tolerance() * norm.position(i, 1.0, 0.0));
  for (Eigen::Index i = 0; i < nu; ++i)
    scale[nq + i] = 1.0 / (norm.tolerance() * norm.velocity(i, 1.0, 0.0));
  radau_.prepare(scale, norm.tolerance());
}

RadauStep::Field SmoothStep::field(MechanicalSystem& s, FrozenPhase& phase) {
  const Eigen::Index nq = Q_.rows(), nu = U_.rows();
  return [&s, &phase, nq, nu, this](double t, const Eigen::VectorXd& y, int i, Eigen::VectorXd& f) {
    stage_.t = t, stage_.q = y.head(nq), stage_.u = y.tail(nu);
    s.evaluate(stage_, 1);
    Eigen::VectorXd& a = denseU_[7];
    if (!phase.accelerate(s.slot(1), stage_.u, a)) return false;
    configurationRate(*s.parts().topology, stage_, denseQ_[7]);
    f.resize(nq + nu);
    f << denseQ_[7], a;
    if (i < 0) return true;
    stageLambda_[static_cast<std::size_t>(i)] = phase.lambda();
    stagePower_[static_cast<std::size_t>(i)] = phase.power();
    return true;
  };
}

Eigen::VectorXd SmoothStep::kept() const {
  // The memory of elements changes with every step, and the Jacobian with it: none is kept then.
  const RadauStep::Place* place = radau_.kept();
  if (!implicit_ || place == nullptr || stage_.memory.size() > 0) return {};
  Eigen::VectorXd out(1 + 2 * place->y.size());
  out << place->t, place->y, place->f;
  return out;
}

void SmoothStep::keep(MechanicalSystem& s, FrozenPhase& phase, const State& x,
                      const Eigen::VectorXd& place) {
  forgetJacobian();
  if (place.size() == 0) return;
  const Eigen::Index n = (place.size() - 1) / 2;
  stage_.memory = x.memory;
  if (!radau_.keep(field(s, phase), {place[0], place.segment(1, n), place.tail(n)}))
    forgetJacobian();
}

bool SmoothStep::takeImplicit(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from,
                              double h, State& to) {
  const Eigen::Index nq = from.x.q.size(), nu = from.x.u.size();
  const RadauStep::Field field = this->field(s, phase);
  yNew_.resize(nq + nu), fNew_.resize(nq + nu);
  yNew_ << from.x.q, from.x.u;
  fNew_ << from.qdot, from.a;
  // The same forces at the same state have the same Jacobian, unless slips start: their directions
  // change.
  const bool same = y_.size() > 0 && y_ == yNew_ && f_ == fNew_;
  const bool starts = std::any_of(phase.held.begin(), phase.held.end(),
                                  [](const Held& held) { return held.starts; });
  if (!same && (starts || from.x.memory.size() > 0)) radau_.forget();
  y_ = yNew_, f_ = fNew_;
  Eigen::VectorXd second = Eigen::VectorXd::Zero(nq + nu);
  second.head(nq) = from.qddot;
  if (!same) failed_ = false;
  if (!radau_.take(field, from.x.t, y_, f_, second, h, same)) {
    failed_ = true;
    return false;
  }
  impulse_.setZero(from.lambda.size()), works_ = {};
  for (std::size_t i = 0; i < stageLambda_.size(); ++i) {
    const double weight = h * RadauStep::weight(static_cast<int>(i));
    impulse_ += weight * stageLambda_[i];
    for (std::size_t k = 0; k < works_.size(); ++k) works_[k] += weight * stagePower_[i][k];
  }
  radauError_ = radau_.error(field);
  to.t = from.x.t + h, to.q = radau_.end().head(nq), to.u = radau_.end().tail(nu);
  return finish(s, to);
}

/// Work of an implicit step, in evaluations: Jacobian, factorisations, iterations.
double SmoothStep::implicitWork(Eigen::Index unknowns, int iterations, bool jacobian) const {
  const auto n = static_cast<double>(unknowns);
  return (jacobian ? n : 0.0) + kFactorise * n * n + 3.0 * iterations;
}

double SmoothStep::mostGrowth() const {
  // Where Newton's method is slow, or has just failed, a longer step would only fail.
  constexpr int kSlow = 5;
  if (!tookImplicit_) return kMostGrowth;
  return failed_ ? 1.0 : radau_.iterations() > kSlow ? 1.2 : kMostGrowth;
}

double SmoothStep::stretch(const ErrorNorm& norm, const Eigen::VectorXd& dq,
                           const Eigen::VectorXd& du) const {
  double size = 0.0;
  for (Eigen::Index i = 0; i < dq.size(); ++i) size = std::max(size, norm.position(i, dq[i], 0.0));
  for (Eigen::Index i = 0; i < du.size(); ++i) size = std::max(size, norm.velocity(i, du[i], 0.0));
  return size;
}

bool SmoothStep::outgrown(const ErrorNorm& norm, const PhasePoint& to) {
  if (tookHalf_) return false;
  double product = 0.0, bound = kSmallStep;
  bool damped = false;
  const Eigen::Index unknowns = to.x.q.size() + to.x.u.size();
  double steps = kSomeSteps;
  if (tookImplicit_) {
    if (++tried_ >= kTrial &&
        implicitWork(unknowns, radau_.iterations(), radau_.tookJacobian()) > rate_ * h_) {
      patience_ *= kCostlierThanExplicit;
      return true;
    }
    product = h_ * radau_.fastest();
  } else {
    // The last stage and the result, two states at the end of the step, differ by the stiff part.
    const int last = table_->stages - 1;
    if (table_->nodes[last] != 1.0) return false;
    const double states = stretch(norm, to.x.q - stage_.q, to.x.u - stage_.u);
    const double rates = stretch(norm, to.qdot - Q_.col(last), to.a - U_.col(last));
    if (states > 0.0) product = h_ * rates / states;
    damped = product > kDamped && decay(norm, to, stage_, Q_.col(last), U_.col(last)) > kAlong;
    bound = table_->order >= 8 ? kBound8 : kBound5;
    rate_ = table_->stages / h_;
    steps = patience_ * std::max<double>(kManySteps, kTrial * implicitWork(unknowns, kUsual, true) /
                                                         table_->stages);
  }
  if (tookImplicit_ != (product > bound)) {
    other_ = 0.0;
    return ++stiff_ >= steps;
  }
  if (damped) {
    other_ = 0.0;
    return (stiff_ += kStiffPart) >= steps;
  }
  if (++other_ >= kOthers || tookImplicit_) stiff_ = 0.0;
  return false;
}

}  // namespace dynamy
