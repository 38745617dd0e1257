#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/simulation/linear/extrapolated_derivative.hpp>
#include <dynamy/simulation/linear/linearisation.hpp>
#include <dynamy/simulation/linear/state_variation.hpp>
#include <dynamy/simulation/linear/steady_search.hpp>
#include <dynamy/system/announced_signals.hpp>

namespace dynamy {
namespace {

/// How much A may change along the motion, as a share of its largest entry.
constexpr double kConstant = 1e-6;
/// Singular values below this part of the largest entry of A are zero.
constexpr double kZero = 1e-11;

/// A and C at one state, for z without constraints.
struct Derivatives {
  Eigen::MatrixXd A, C;
  double error = 0.0;
};

class Linear {
 public:
  Linear(Model& model, HeldMotion& motion, const Eigen::VectorXd& step)
      : model_(model), motion_(motion), nu_(model.topology().nu()), step_(step) {}

  Derivatives derivatives(const State& x) {
    const MotionSample here = motion_.at(x);
    const Eigen::Index rows = here.gamma.size();
    Derivatives d;
    d.A.setZero(2 * nu_, 2 * nu_), d.C.setZero(2 * rows, 2 * nu_);
    d.A.topRightCorner(nu_, nu_).setIdentity();
    turns(x, d);
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(nu_), y(nu_ + 2 * rows);
    for (Eigen::Index i = 0; i < 2 * nu_; ++i) {
      const Eigen::Index k = i % nu_;
      direction.setZero(), direction[k] = 1.0;
      const auto f = [&](double s) {
        State moved = i < nu_ ? motion_.displaced(x, s * direction) : x;
        if (i >= nu_) moved.u[k] += s;
        const MotionSample m = motion_.at(moved);
        y << m.a, m.gamma, m.position;
        return y;
      };
      const Eigen::VectorXd D =
          extrapolatedDerivative(f, i < nu_ ? step_[k] : SteadySearch::kStep, d.error);
      d.A.col(i).tail(nu_) = D.head(nu_);
      d.C.col(i) = D.tail(2 * rows);
    }
    return d;
  }

 private:
  /// K: (F + dF)(u₀ + w) = d/dt (F δ) solved for δ̇, system by system.
  void turns(const State& x, Derivatives& d) {
    const Topology& t = model_.topology();
    if (t.nq() == 0) return;
    const Eigen::VectorXd qdot = motion_.qdot(x, x.u);
    Eigen::MatrixXd F(t.nq(), nu_), change(t.nq(), nu_);
    Eigen::VectorXd e = Eigen::VectorXd::Zero(nu_);
    for (Eigen::Index k = 0; k < nu_; ++k) {
      e.setZero(), e[k] = 1.0;
      F.col(k) = motion_.rate(x, e);
      const auto along = [&](const Eigen::VectorXd& way, const auto& rate) {
        return extrapolatedDerivative(
            [&](double s) {
              State moved = x;
              moved.q += s * way;
              return Eigen::VectorXd(rate(moved));
            },
            SteadySearch::kStep, d.error);
      };
      change.col(k) = along(F.col(k), [&](const State& y) { return motion_.qdot(y, x.u); }) -
                      along(qdot, [&](const State& y) { return motion_.rate(y, e); });
    }
    for (int i = 0; i < static_cast<int>(model_.systems().size()); ++i) {
      const SystemHandle& s = t.system(i);
      if (s.nu == 0) continue;
      PivotedQr own;
      own.compute(F.block(s.q0, s.u0, s.nq, s.nu));
      d.A.block(s.u0, s.u0, s.nu, s.nu) = own.solve(change.block(s.q0, s.u0, s.nq, s.nu));
    }
  }

  Model& model_;
  HeldMotion& motion_;
  Eigen::Index nu_;
  const Eigen::VectorXd& step_;
};

void expectPermitted(const std::vector<HeldMotion::Contact>& contacts) {
  double force = 1.0;
  for (const HeldMotion::Contact& c : contacts)
    for (const double l : c.lambda) force = std::max(force, std::abs(l));
  for (const HeldMotion::Contact& c : contacts)
    if (c.margin < -1e-9 * force)
      throw ModelError(
          fmt::format("{} does not permit the steady motion: its force is {:.3g} N beyond its law",
                      c.name, -c.margin),
          "the contact would have to pull, or to stick beyond its friction");
}

/// Throws ModelError unless, later in the motion, the accelerations are still zero and the linear
/// equations the same.
void expectSteady(HeldMotion& motion, Linear& linear, const State& x, const Derivatives& d,
                  double allowed) {
  const double size = d.A.size() > 0 ? d.A.cwiseAbs().maxCoeff() : 0.0;
  for (const double tau : SteadySearch::laterTimes(x)) {
    const State later = motion.movedOn(x, tau);
    const double a = maxAbs(motion.at(later).a);
    const double change = (linear.derivatives(later).A - d.A).cwiseAbs().maxCoeff();
    if (a <= SteadySearch::kDrift * allowed && change <= kConstant * size) continue;
    throw ModelError(
        fmt::format("the motion is not steady: {:.3g} s later its accelerations are {:.3g} and the "
                    "linear equations have changed by {:.3g}",
                    tau, a, change),
        "eigenvalues need equations that stay the same along the motion: take coordinates that do "
        "not turn with a wheel");
  }
}

}  // namespace

int Linearisation::growing() const {
  return static_cast<int>(
      std::count_if(eigenvalues.begin(), eigenvalues.end(),
                    [this](const std::complex<double>& z) { return z.real() > noise; }));
}

std::vector<std::string> samplingElements(const Model& model) {
  const std::string ending = "." + std::string(kNextSample);
  std::vector<std::string> out;
  for (const NamedSignal& s : model.signals())
    if (s.name.ends_with(ending)) out.push_back(s.name.substr(0, s.name.size() - ending.size()));
  return out;
}

Linearisation linearise(Model& model, const State& from, const LinearisationOptions& options) {
  HeldMotion motion(model, from, options.near * model.length(),
                    options.near * std::max(1.0, maxAbs(from.u)));
  SteadySearch search(model, motion);
  Linear linear(model, motion, search.steps());
  Linearisation out;
  out.sampled = samplingElements(model);
  out.at = from;
  if (options.seek) out.moved = search.seek(out.at);

  const MotionSample here = motion.at(out.at);
  motion.shareWidely();
  out.contacts = motion.contacts();
  const double allowed = search.allowed();
  out.residual = maxAbs(here.a);
  if (!(out.residual <= allowed))
    throw ModelError(
        fmt::format("no steady motion found: accelerations up to {:.3g} remain", out.residual),
        "give a start nearer to it, or switch off what drives it");
  expectPermitted(out.contacts);
  const Derivatives d = linear.derivatives(out.at);
  expectSteady(motion, linear, out.at, d, allowed);

  out.names = StateVariation(model).names();
  out.basis = nullSpace(d.C, SteadySearch::kRankOfStates);
  out.A = out.basis.transpose() * d.A * out.basis;
  out.error = d.error;
  if (d.C.rows() > 0 && out.basis.cols() > 0)
    out.leak = (d.C * d.A * out.basis).cwiseAbs().maxCoeff();
  Eigen::MatrixXcd vectors;
  out.noise = std::max(kZero * (d.A.size() > 0 ? d.A.cwiseAbs().maxCoeff() : 0.0), 10.0 * d.error);
  out.zeros = nonzeroEigenvalues(out.A, out.noise, out.eigenvalues, vectors);
  out.modes = out.basis * vectors;
  const Eigen::Index nu = model.topology().nu();
  for (Eigen::Index k = 0; k < out.modes.cols(); ++k) {
    Eigen::Index most = 0;
    out.modes.col(k).tail(nu).cwiseAbs().maxCoeff(&most);
    const std::complex<double> unit = out.modes(nu + most, k);
    out.modes.col(k) /= unit;
  }
  return out;
}

}  // namespace dynamy
