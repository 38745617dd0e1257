#include <algorithm>
#include <dynamy/located/phase/implicit_step.hpp>
#include <dynamy/located/phase/radau_method.hpp>

namespace dynamy {
namespace {

/// Work of a real and a complex factorisation of n unknowns, 10/3 n³, in evaluations of some 400 n.
constexpr double kFactorise = 1.0 / 120.0;
/// Iterations of Newton's method in a step without difficulties.
constexpr int kUsual = 4;

/// Work of an implicit step, in evaluations: Jacobian, factorisations, iterations.
double workOf(Eigen::Index unknowns, int iterations, bool jacobian) {
  const auto n = static_cast<double>(unknowns);
  return (jacobian ? n : 0.0) + kFactorise * n * n + 3.0 * iterations;
}

}  // namespace

double ImplicitStep::work() const {
  return workOf(yNew_.size(), radau_.iterations(), radau_.tookJacobian());
}

double ImplicitStep::usualWork(Eigen::Index unknowns) { return workOf(unknowns, kUsual, true); }

void ImplicitStep::prepare(const Topology& topology, const ErrorNorm& norm) {
  const Eigen::Index nq = topology.nq(), nu = topology.nu();
  Eigen::VectorXd scale(nq + nu);
  for (Eigen::Index i = 0; i < nq; ++i)
    scale[i] = 1.0 / (norm.tolerance() * norm.position(i, 1.0, 0.0));
  for (Eigen::Index i = 0; i < nu; ++i)
    scale[nq + i] = 1.0 / (norm.tolerance() * norm.velocity(i, 1.0, 0.0));
  radau_.prepare(scale, norm.tolerance());
}

RadauStep::Field ImplicitStep::field(MechanicalSystem& s, FrozenPhase& phase) {
  const Topology& topology = *s.parts().topology;
  const Eigen::Index nq = topology.nq(), nu = topology.nu();
  return [&s, &phase, nq, nu, this](double t, const Eigen::VectorXd& y, int i, Eigen::VectorXd& f) {
    stage_.t = t, stage_.q = y.head(nq), stage_.u = y.tail(nu);
    s.evaluate(stage_, phase.request.ofStage());
    if (!phase.accelerate(s.slot(1), stage_.u, a_)) return false;
    configurationRate(*s.parts().topology, stage_, qdot_);
    f.resize(nq + nu);
    f << qdot_, a_;
    if (i < 0) return true;
    stageLambda_[static_cast<std::size_t>(i)] = phase.lambda();
    stagePower_[static_cast<std::size_t>(i)] = phase.power();
    return true;
  };
}

Eigen::VectorXd ImplicitStep::kept() const {
  // The memory of elements changes with every step, and the Jacobian with it: none is kept then.
  const RadauStep::Place* place = radau_.kept();
  if (place == nullptr || stage_.memory.size() > 0) return {};
  Eigen::VectorXd out(1 + 2 * place->y.size());
  out << place->t, place->y, place->f;
  return out;
}

void ImplicitStep::keep(MechanicalSystem& s, FrozenPhase& phase, const State& x,
                        const Eigen::VectorXd& place) {
  forget();
  if (place.size() == 0) return;
  const Eigen::Index n = (place.size() - 1) / 2;
  stage_.memory = x.memory;
  if (!radau_.keep(field(s, phase), {place[0], place.segment(1, n), place.tail(n)})) forget();
}

bool ImplicitStep::take(MechanicalSystem& s, FrozenPhase& phase, const PhasePoint& from, double h,
                        State& to) {
  h_ = h, t0_ = from.x.t, stage_.memory = from.x.memory;
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
    const double weight = h * radauMethod().weights[i];
    impulse_ += weight * stageLambda_[i];
    for (std::size_t k = 0; k < works_.size(); ++k) works_[k] += weight * stagePower_[i][k];
  }
  error_ = radau_.error(field);
  to.t = from.x.t + h, to.q = radau_.end().head(nq), to.u = radau_.end().tail(nu);
  return true;
}

double ImplicitStep::mostGrowth() const {
  // Where Newton's method is slow, or has just failed, a longer step would only fail.
  constexpr int kSlow = 5;
  if (failed_) return 1.0;
  return radau_.iterations() > kSlow ? 1.2 : SmoothMethod::mostGrowth();
}

void ImplicitStep::dense(double theta, State& out) const {
  Eigen::VectorXd y;
  radau_.dense(theta, y);
  const Eigen::Index nq = y.size() - a_.size();
  out.q = y.head(nq), out.u = y.tail(a_.size()), out.t = t0_ + theta * h_;
}

}  // namespace dynamy
