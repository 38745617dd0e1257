#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/simulation/linear/linearisation.hpp>
#include <dynamy/simulation/linear/state_variation.hpp>
#include <dynamy/stages/error_norm.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Largest step of the differences, for angles and velocities, and for lengths in units of the
/// scene's length.
constexpr double kStep = 0.1;
constexpr int kLevels = 7;  ///< number of steps, each half of the one before
/// A constraint is redundant if its pivot is below this share of the largest one.
constexpr double kRankOfStates = 1e-9;
/// Largest accelerations of a steady motion, as a share of those by the forces alone.
constexpr double kSteady = 1e-10;
constexpr double kDrift = 1e3;  ///< the same later in the motion, in units of kSteady
/// How much A may change along the motion, as a share of its largest entry.
constexpr double kConstant = 1e-6;
constexpr int kMostSteps = 40;    ///< of Newton's method
constexpr double kLongest = 0.3;  ///< of its steps [m, rad]
/// Singular values below this part of the largest entry of A are zero.
constexpr double kZero = 1e-11;

/// f′(0) of f: double → VectorXd by central differences with the steps h, h/2, h/4 …, extrapolated
/// to zero as a polynomial of h² [Neville]. For each entry the value in the table that differs
/// least from its neighbours is taken; `error` grows to the largest of these differences.
template <class F>
Eigen::VectorXd derivative(const F& f, double h, double& error) {
  std::vector<Eigen::VectorXd> old, row;
  Eigen::VectorXd best, bound;
  for (int level = 0; level < kLevels; ++level, h *= 0.5) {
    row.assign(1, (f(h) - f(-h)) / (2.0 * h));
    if (level == 0) {
      best = row[0];
      bound = Eigen::VectorXd::Constant(best.size(), std::numeric_limits<double>::infinity());
    }
    double power = 1.0;
    for (std::size_t k = 1; k <= old.size(); ++k) {
      power *= 4.0;
      row.push_back(row[k - 1] + (row[k - 1] - old[k - 1]) / (power - 1.0));
      for (Eigen::Index i = 0; i < best.size(); ++i) {
        const double off =
            std::max(std::abs(row[k][i] - row[k - 1][i]), std::abs(row[k][i] - old[k - 1][i]));
        if (off < bound[i]) bound[i] = off, best[i] = row[k][i];
      }
    }
    old = row;
  }
  if (bound.size() > 0) error = std::max(error, bound.maxCoeff());
  return best;
}

/// A and C at one state, for z without constraints.
struct Derivatives {
  Eigen::MatrixXd A, C;
  double error = 0.0;
};

class Linear {
 public:
  Linear(Model& model, HeldMotion& motion)
      : model_(model), motion_(motion), nu_(model.topology().nu()) {
    steps();
  }

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
      const Eigen::VectorXd D = derivative(f, i < nu_ ? step_[k] : kStep, d.error);
      d.A.col(i).tail(nu_) = D.head(nu_);
      d.C.col(i) = D.tail(2 * rows);
    }
    return d;
  }

  /// Newton's method with corrections of least norm for zero accelerations and held constraints, now
  /// and, in the steady motion from here, after each of the `later` times [s]; at rest it changes
  /// positions alone. Returns the length of all corrections.
  double seek(State& x, const std::vector<double>& later) {
    const bool rest = x.u.size() == 0 || x.u.lpNorm<Eigen::Infinity>() == 0.0;
    const Eigen::Index free = rest ? nu_ : 2 * nu_;
    double way = 0.0;
    for (int i = 0; i < kMostSteps; ++i) {
      const Eigen::VectorXd y = residual(x, later);
      const double size = y.size() > 0 ? y.lpNorm<Eigen::Infinity>() : 0.0;
      if (size <= 1e-3 * kSteady * std::max(1.0, motion_.freeAcceleration())) return way;
      PseudoInverse inverse(kRankOfStates);
      inverse.compute(tangent(x, later, free));
      Eigen::VectorXd change;
      inverse.solve(y, change);
      Eigen::VectorXd z = Eigen::VectorXd::Zero(2 * nu_);
      z.head(free) = -change;
      const double length = z.norm(), part = std::min(1.0, kLongest / std::max(length, 1e-300));
      if (part == 1.0 && length < 1e-15) return way;
      x = motion_.displaced(x, part * z.head(nu_));
      x.u += part * z.tail(nu_);
      way += part * length;
    }
    return way;
  }

 private:
  /// Accelerations, velocities and positions of the held rows at x and after the `later` times.
  Eigen::VectorXd residual(const State& x, const std::vector<double>& later) {
    Eigen::VectorXd y;
    const auto append = [&](const MotionSample& m) {
      const Eigen::Index first = y.size(), rows = m.gamma.size();
      y.conservativeResize(first + nu_ + 2 * rows);
      y.tail(nu_ + 2 * rows) << m.a, m.gamma, m.position;
    };
    for (const double tau : later) append(motion_.at(motion_.movedOn(x, tau)));
    append(motion_.at(x));  // last, so that the forces of the motion are those at x
    return y;
  }

  /// ∂residual/∂z for the first `free` ones of z: displacements, velocities.
  Eigen::MatrixXd tangent(const State& x, const std::vector<double>& later, Eigen::Index free) {
    Eigen::MatrixXd J;
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(nu_);
    double error = 0.0;
    for (Eigen::Index i = 0; i < free; ++i) {
      const Eigen::Index k = i % nu_;
      direction.setZero(), direction[k] = 1.0;
      const auto f = [&](double s) {
        State moved = i < nu_ ? motion_.displaced(x, s * direction) : x;
        if (i >= nu_) moved.u[k] += s;
        return residual(moved, later);
      };
      const Eigen::VectorXd D = derivative(f, i < nu_ ? step_[k] : kStep, error);
      if (J.size() == 0) J.resize(D.size(), free);
      J.col(i) = D;
    }
    return J;
  }

  /// Sets the steps of the differences by unit: lengths scale with the scene.
  void steps() {
    Eigen::VectorXd positions;
    unitScales(model_.topology(), std::min(1.0, model_.length()), positions, step_);
    step_ *= kStep;
  }

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
        return derivative(
            [&](double s) {
              State moved = x;
              moved.q += s * way;
              return Eigen::VectorXd(rate(moved));
            },
            kStep, d.error);
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
  Eigen::VectorXd step_;
};

/// Orthonormal columns that C maps to zero.
Eigen::MatrixXd nullSpace(const Eigen::MatrixXd& C) {
  const Eigen::Index n = C.cols();
  if (C.rows() == 0) return Eigen::MatrixXd::Identity(n, n);
  PivotedQr qr(kRankOfStates);
  qr.compute(C.transpose());
  const Eigen::MatrixXd Q = qr.Q();
  return Q.rightCols(n - qr.rank());
}

double largest(const Eigen::VectorXd& a) {
  return a.size() > 0 ? a.lpNorm<Eigen::Infinity>() : 0.0;
}

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

/// Instants [s] at which a motion from x has to be steady: after some turn or way. Empty at rest.
std::vector<double> laterTimes(const State& x) {
  const double fastest = largest(x.u);
  if (fastest == 0.0) return {};
  return {0.7 / fastest, 1.9 / fastest};
}

double allowedAcceleration(const HeldMotion& motion) {
  return kSteady * std::max(1.0, motion.freeAcceleration());
}

bool staysSteady(HeldMotion& motion, const State& x, const std::vector<double>& later) {
  return std::all_of(later.begin(), later.end(), [&](double tau) {
    return largest(motion.at(motion.movedOn(x, tau)).a) <= kDrift * allowedAcceleration(motion);
  });
}

/// Throws ModelError unless, later in the motion, the accelerations are still zero and the linear
/// equations the same.
void expectSteady(HeldMotion& motion, Linear& linear, const State& x, const Derivatives& d,
                  double allowed) {
  const double size = d.A.size() > 0 ? d.A.cwiseAbs().maxCoeff() : 0.0;
  for (const double tau : laterTimes(x)) {
    const State later = motion.movedOn(x, tau);
    const double a = largest(motion.at(later).a);
    const double change = (linear.derivatives(later).A - d.A).cwiseAbs().maxCoeff();
    if (a <= kDrift * allowed && change <= kConstant * size) continue;
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

Linearisation linearise(Model& model, const State& from, const LinearisationOptions& options) {
  HeldMotion motion(model, from, options.near * model.length(),
                    options.near * std::max(1.0, largest(from.u)));
  Linear linear(model, motion);
  Linearisation out;
  out.at = from;
  if (options.seek) {
    out.moved = linear.seek(out.at, {});
    // A moving damper may carry a force now and none later: then the motion is to be steady later, too.
    const std::vector<double> later = laterTimes(out.at);
    if (!staysSteady(motion, out.at, later)) out.moved += linear.seek(out.at, later);
  }

  const MotionSample here = motion.at(out.at);
  out.contacts = motion.contacts();
  const double allowed = allowedAcceleration(motion);
  out.residual = largest(here.a);
  if (!(out.residual <= allowed))
    throw ModelError(
        fmt::format("no steady motion found: accelerations up to {:.3g} remain", out.residual),
        "give a start nearer to it, or switch off what drives it");
  expectPermitted(out.contacts);
  const Derivatives d = linear.derivatives(out.at);
  expectSteady(motion, linear, out.at, d, allowed);

  out.names = StateVariation(model).names();
  out.basis = nullSpace(d.C);
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
