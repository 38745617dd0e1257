#include <algorithm>
#include <dynamy/located/step/last_step.hpp>
#include <dynamy/stages/projection.hpp>

namespace dynamy {

void LastStep::keep(const PhasePoint& from, const PhaseMotion& motion) {
  from_ = from, phase_ = motion.phase;
}

bool LastStep::interpolate(MechanicalSystem& s, PhaseMotion& motion, const State& a, const State& b,
                           double theta, State& out) {
  if (from_.x.t != a.t || enteredAt_ != a.q) return false;
  if (!motion.step.denseReady()) motion.step.prepareDense(s, phase_, from_, end_);
  const double t = a.t + theta * (b.t - a.t);
  out.memory = theta < 1.0 ? a.memory : b.memory;
  const SmoothMethod& method = motion.step.last();
  method.dense(std::clamp((t - from_.x.t) / method.length(), 0.0, 1.5), out);
  out.t = t;
  return true;
}

void LastStep::towards(const MechanicalSystem& s, const State& a, const Eigen::VectorXd& u,
                       double h, double theta, State& out) {
  out.q = a.q, out.u = a.u + theta * (u - a.u), out.memory = a.memory;
  s.move(out, 0.5 * (a.u + out.u), theta * h);
  out.t = a.t + theta * h;
}

void LastStep::close(MechanicalSystem& s, State& x) {
  if (phase_.held.empty()) return;
  FrozenPhase& phase = asked_ = phase_;
  const Evaluation& e = s.evaluate(x, phase.request.in(1));
  if (!phase.read(e, x.u) || !projection_.positions(phase.held, phase.rows(), e, delta_)) return;
  const double t = x.t;
  delta_ /= kDisplacementTime;
  s.move(x, delta_, kDisplacementTime);
  x.t = t;
}

bool LastStep::contactsAt(MechanicalSystem& s, const PhaseMotion& motion, const State& at,
                          bool after, ContactInstant& out) {
  FrozenPhase& phase = asked_ = after ? motion.phase : phase_;
  const Evaluation& e = s.evaluate(at, phase.request.in(1));
  if (!phase.accelerate(e, at.u, a_)) return false;
  const ContactSet& c = e.contacts;
  out.contacts = &c;
  out.lambda.setZero(c.rows()), out.gamma.resize(c.rows());
  c.gamma(view(at.u), view(out.gamma));
  const HeldRows& rows = phase.rows();
  for (std::size_t i = 0; i < phase.held.size(); ++i) {
    const int row0 = c.row0[static_cast<std::size_t>(rows.contact(i))];
    out.lambda.segment(row0 + phase.held[i].first, rows.dim(i)) =
        phase.lambda().segment(rows.row0(i), rows.dim(i));
  }
  return true;
}

}  // namespace dynamy
