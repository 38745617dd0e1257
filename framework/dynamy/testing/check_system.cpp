// Checks of one system. All derivatives are taken along the motion s ↦ (t + s, q ⊕ s q̇) with u
// fixed: any curve with the right tangent gives the right first derivative.
#include <fmt/format.h>
#include <dynamy/core/constants.hpp>

#include <Eigen/Cholesky>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/testing/check_element.hpp>
#include <dynamy/testing/difference.hpp>
#include <dynamy/testing/random_motion.hpp>
#include <random>

namespace dynamy {
namespace {

ConstVec in(const Eigen::VectorXd& v) { return {v.data(), v.size()}; }

/// Most frames of one system that are compared.
constexpr int kMostFrames = 8;
constexpr double kUnwritten = std::numeric_limits<double>::quiet_NaN();

template <class F>
testing::Difference scalarDifference(const F& f, double noise = 0.0) {
  return testing::differentiate([&](double s) { return Eigen::VectorXd::Constant(1, f(s)).eval(); },
                                1.0, noise);
}

struct FrameStorage {
  Eigen::VectorXd J;
  Frame f;
};

/// A system in one state, and what it says in states around it.
class SystemSample {
 public:
  explicit SystemSample(const PartialMechanicalSystem& system)
      : system_(system), blocks_(system.blocks()) {}
  double t = 0.0;
  Eigen::VectorXd q, u;

  /// q after the time s with velocity v, from (t, q).
  Eigen::VectorXd moved(const Eigen::VectorXd& v, double s) const {
    Eigen::VectorXd out = q;
    system_.move(t, view(out), in(v), s);
    return out;
  }
  Eigen::VectorXd mass(double at, const Eigen::VectorXd& of) const {
    Eigen::VectorXd M = Eigen::VectorXd::Constant(
        static_cast<Eigen::Index>(blocks_.nu) * blocks_.nu * blocks_.capacity, kUnwritten);
    system_.M(at, in(of), MassBlocks(M.data(), blocks_.nu, blocks_.capacity));
    return M;
  }
  double kineticEnergy(double at, const Eigen::VectorXd& of) const {
    const Eigen::VectorXd M = mass(at, of);
    double T = 0.0;
    for (int b = 0; b < blocks_.capacity; ++b) {
      const Eigen::Index n = blocks_.nu;
      const ConstBlock block(M.data() + b * n * n, n, n);
      T += 0.5 * u.segment(b * n, n).dot(block * u.segment(b * n, n));
    }
    return T;
  }
  Eigen::VectorXd qdot(const Eigen::VectorXd& v) const {
    Eigen::VectorXd out = Eigen::VectorXd::Constant(q.size(), kUnwritten);
    system_.qdot(t, in(q), in(v), view(out));
    return out;
  }
  /// Frame at (t + s, of) with velocities v; the Jacobians hold `fill` before the call.
  FrameStorage frameAt(int id, double s, const Eigen::VectorXd& of, const Eigen::VectorXd& v,
                       double fill = 0.0) const {
    FrameStorage out;
    out.J = Eigen::VectorXd::Constant(6 * static_cast<Eigen::Index>(blocks_.nu), fill);
    new (&out.f.J_S_I) Mat3X(out.J.data(), 3, blocks_.nu);
    new (&out.f.J_R_I) Mat3X(out.J.data() + 3 * blocks_.nu, 3, blocks_.nu);
    out.f.block = 0;
    system_.frame(t + s, in(of), in(v), id, out.f);
    return out;
  }

 private:
  const PartialMechanicalSystem& system_;
  Blocks blocks_;
};

class SystemCheck {
 public:
  SystemCheck(const PartialMechanicalSystem& system, const CheckOptions& options)
      : system_(system),
        options_(options),
        blocks_(system.blocks()),
        random_(options.seed),
        now_(system) {
    name_ = testing::labelOf(system, "system");
    nq_ = blocks_.nq * blocks_.capacity, nu_ = blocks_.nu * blocks_.capacity;
  }

  Verdict run() {
    if (blocks_.nq < 0 || blocks_.nu < 0 || blocks_.capacity < 0) {
      fault("blocks() has a negative size");
      return result_;
    }
    start();
    for (int i = 0; i < options_.states && result_; ++i) {
      sample(i);
      checkMass();
      checkForces();
      checkVelocities();
      checkMove();
      if (!result_) break;  // the next checks rely on these
      checkPower();
      checkGravity();
      for (int id = 0; id < std::min(system_.frames(), kMostFrames); ++id) checkFrame(id);
    }
    if (const int more = system_.frames() - kMostFrames; more > 0)
      leftOut(fmt::format("frames {} and later, {} of them: only the first {} are compared",
                          kMostFrames, more, kMostFrames));
    return result_;
  }

 private:
  void fault(const std::string& text) { result_.fault(name_ + ": " + text); }
  void leftOut(const std::string& text) { result_.leftOut(name_ + ": " + text); }
  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  Eigen::VectorXd randomVelocity() {
    Eigen::VectorXd v(nu_);
    for (double& x : v) x = options_.speed * uniform();
    return v;
  }

  void start() {
    qStart_ = Eigen::VectorXd::Constant(nq_, kUnwritten);
    uStart_ = Eigen::VectorXd::Constant(nu_, kUnwritten);
    if (nq_ + nu_ > 0) system_.initialState(view(qStart_), view(uStart_));
    for (int i = 0; i < nq_; ++i)
      if (!std::isfinite(qStart_[i]))
        fault(fmt::format("initialState leaves q[{}] = {}", i, qStart_[i]));
    for (int i = 0; i < nu_; ++i)
      if (!std::isfinite(uStart_[i]))
        fault(fmt::format("initialState leaves u[{}] = {}", i, uStart_[i]));
    now_.t = 0.0, now_.q = qStart_, now_.u = uStart_;
    if (result_) startMass_ = now_.mass(0.0, qStart_);
  }

  /// Takes sample i: the start itself for i = 0, then random states near it.
  void sample(int i) {
    now_.t = 0.0, now_.q = qStart_, now_.u = uStart_;
    if (i == 0) return;
    now_.q = now_.moved(randomVelocity(), options_.reach * std::abs(uniform()));
    system_.normalise(view(now_.q));
    now_.u += randomVelocity();
    now_.t = options_.reach * std::abs(uniform());
  }

  void checkMass();
  void checkForces();
  void checkVelocities();
  void checkMove();
  void checkPower();
  void checkGravity();
  void checkFrame(int id);
  void checkFrameRates(int id, const Frame& f);
  void compare(const char* what, int frame, const Vec3& value, const Vec3& expected,
               double tolerance, const char* expectedText);

  const PartialMechanicalSystem& system_;
  CheckOptions options_;
  Blocks blocks_;
  std::mt19937 random_;
  SystemSample now_;
  std::string name_;
  int nq_ = 0, nu_ = 0;
  Eigen::VectorXd qStart_, uStart_, startMass_;
  Verdict result_;
};

void SystemCheck::checkMass() {
  const Eigen::VectorXd all = now_.mass(now_.t, now_.q);
  const Eigen::Index n = blocks_.nu;
  for (int b = 0; b < blocks_.capacity && result_; ++b) {
    const ConstBlock M(all.data() + b * n * n, n, n);
    const std::string which = blocks_.capacity > 1 ? fmt::format("M of block {}", b) : "M";
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (!std::isfinite(M(i, j)))
          return fault(
              fmt::format("{}[{},{}] = {}: not written or not finite", which, i, j, M(i, j)));
      }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < i; ++j) {
        // Both entries are sums of a few products that |M_ii M_jj| bounds.
        const double tolerance = 16.0 * kEpsilon * std::sqrt(std::abs(M(i, i) * M(j, j)));
        if (!(std::abs(M(i, j) - M(j, i)) <= tolerance))
          return fault(fmt::format("{}[{},{}] = {:.9g} but {}[{},{}] = {:.9g}: not symmetric",
                                   which, i, j, M(i, j), which, j, i, M(j, i)));
      }
    if (n > 0 && Eigen::LLT<Eigen::MatrixXd>(M).info() != Eigen::Success) {
      const double least = symmetricEigenPairs(M).values[0];
      return fault(
          fmt::format("{} is not positive definite: smallest eigenvalue {:.6g}", which, least));
    }
  }
  if (!blocks_.constantMass) return;
  for (Eigen::Index i = 0; i < all.size(); ++i)
    if (all[i] != startMass_[i])
      return fault(
          fmt::format("M[{},{}] = {:.17g} but {:.17g} at the start: blocks() says constantMass",
                      i % (n * n) / n, i % n, all[i], startMass_[i]));
}

void SystemCheck::checkForces() {
  Eigen::VectorXd h = Eigen::VectorXd::Constant(nu_, kUnwritten), nonPotential = h;
  system_.h(now_.t, in(now_.q), in(now_.u), view(h));
  system_.nonPotentialForce(now_.t, in(now_.q), in(now_.u), view(nonPotential));
  for (int i = 0; i < nu_; ++i) {
    if (!std::isfinite(h[i])) fault(fmt::format("h[{}] = {}: not written or not finite", i, h[i]));
    if (!std::isfinite(nonPotential[i]))
      fault(
          fmt::format("nonPotentialForce[{}] = {}: not written or not finite", i, nonPotential[i]));
  }
}

void SystemCheck::checkVelocities() {
  // Affine: q̇(a u₁ + (1−a) u₂) = a q̇(u₁) + (1−a) q̇(u₂).
  constexpr double a = -1.5;
  const Eigen::VectorXd u1 = now_.u, u2 = randomVelocity(), u3 = a * u1 + (1.0 - a) * u2;
  const Eigen::VectorXd q1 = now_.qdot(u1), q2 = now_.qdot(u2), q3 = now_.qdot(u3);
  // Tolerance: some 10 roundings of numbers as large as the three rates and their velocities.
  double size = 0.0;
  for (const Eigen::VectorXd* x : {&q1, &q2, &q3, &u1, &u2})
    if (x->size() > 0) size = std::max(size, x->lpNorm<Eigen::Infinity>());
  for (int i = 0; i < nq_; ++i) {
    const double expected = a * q1[i] + (1.0 - a) * q2[i];
    if (!(std::abs(q3[i] - expected) <= 64.0 * kEpsilon * size))
      fault(fmt::format(
          "qdot[{}] = {:.9g} at a mean of two velocities, expected {:.9g}: not affine in u", i,
          q3[i], expected));
  }
}

void SystemCheck::checkMove() {
  const Eigen::VectorXd rate = now_.qdot(now_.u);
  const testing::Difference D =
      testing::differentiate([&](double s) { return now_.moved(now_.u, s); });
  for (int i = 0; i < nq_; ++i)
    if (!(std::abs(D.value[i] - rate[i]) <= D.error))
      fault(fmt::format("move changes q[{}] at the rate {:.9g}, qdot says {:.9g}", i, D.value[i],
                        rate[i]));
  // The result of move lies on the manifold already: normalise may change it by rounding only.
  const Eigen::VectorXd q = now_.moved(now_.u, options_.reach);
  Eigen::VectorXd same = q;
  system_.normalise(view(same));
  for (int i = 0; i < nq_; ++i)
    if (!(std::abs(same[i] - q[i]) <= 64.0 * kEpsilon * std::max(1.0, std::abs(q[i]))))
      fault(fmt::format("normalise changes q[{}] from {:.17g} to {:.17g} right after move", i, q[i],
                        same[i]));
}

void SystemCheck::checkPower() {
  // A system that is driven through t (q̇ at u = 0, M or V at fixed q) exchanges power with its
  // drive. No function states this power, so that it cannot be checked.
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(nu_);
  const char* const driven = "the balance of power: M, V or qdot at rest depend on time";
  if (nq_ > 0 && now_.qdot(zero).lpNorm<Eigen::Infinity>() > 0.0) return leftOut(driven);
  const double V = system_.potentialEnergy(now_.t, in(now_.q)), later = now_.t + 0.37;
  if (system_.potentialEnergy(later, in(now_.q)) != V ||
      now_.mass(later, now_.q) != now_.mass(now_.t, now_.q))
    return leftOut(driven);
  const auto along = [&](double s) { return now_.moved(now_.u, s); };
  const testing::Difference Vdot =
      scalarDifference([&](double s) { return system_.potentialEnergy(now_.t + s, in(along(s))); });
  const testing::Difference Tdot =
      scalarDifference([&](double s) { return now_.kineticEnergy(now_.t + s, along(s)); });
  Eigen::VectorXd h(nu_), nonPotential(nu_);
  system_.h(now_.t, in(now_.q), in(now_.u), view(h));
  system_.nonPotentialForce(now_.t, in(now_.q), in(now_.u), view(nonPotential));
  const double power = h.dot(now_.u) + Tdot.value[0] + Vdot.value[0],
               stated = nonPotential.dot(now_.u);
  // Terms that cancel: a billionth of them.
  const double rounding =
      64.0 * kEpsilon *
          (h.cwiseAbs().dot(now_.u.cwiseAbs()) + nonPotential.cwiseAbs().dot(now_.u.cwiseAbs())) +
      1e-9 * (std::abs(Tdot.value[0]) + std::abs(Vdot.value[0]));
  if (!(std::abs(power - stated) <= Vdot.error + Tdot.error + rounding))
    fault(fmt::format(
        "h·u + ½uᵀṀu + dV/dt = {:.9g} W, but nonPotentialForce·u = {:.9g} W (h·u = {:.9g}, "
        "½uᵀṀu = {:.9g}, dV/dt = {:.9g}): h, M, potentialEnergy and nonPotentialForce do not fit",
        power, stated, h.dot(now_.u), Tdot.value[0], Vdot.value[0]));
}

void SystemCheck::checkGravity() {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(nu_);
  const char* const driven = "the power of gravity: its potential or qdot at rest depend on time";
  if (nq_ > 0 && now_.qdot(zero).lpNorm<Eigen::Infinity>() > 0.0) return leftOut(driven);
  const Vec3 g_I(uniform(), uniform(), uniform());
  Eigen::VectorXd h = Eigen::VectorXd::Constant(nu_, kUnwritten), scratch(nu_);
  const double V = system_.gravity(now_.t, in(now_.q), g_I, view(h));
  if (system_.gravity(now_.t + 0.37, in(now_.q), g_I, view(scratch)) != V) return leftOut(driven);
  // The parts of V along the three axes may cancel, but the rounding of each part remains.
  double parts = 0.0;
  for (int i = 0; i < 3; ++i)
    parts += std::abs(system_.gravity(now_.t, in(now_.q), g_I[i] * Vec3::Unit(i), view(scratch)));
  const testing::Difference Vdot = scalarDifference(
      [&](double s) {
        return system_.gravity(now_.t + s, in(now_.moved(now_.u, s)), g_I, view(scratch));
      },
      kEpsilon * parts);
  const double rounding = 64.0 * kEpsilon * h.cwiseAbs().dot(now_.u.cwiseAbs());
  if (!(std::abs(h.dot(now_.u) + Vdot.value[0]) <= Vdot.error + rounding))
    fault(fmt::format("gravity writes a force of power {:.9g} W, its potential falls by {:.9g} W",
                      h.dot(now_.u), -Vdot.value[0]));
}

void SystemCheck::compare(const char* what, int frame, const Vec3& value, const Vec3& expected,
                          double tolerance, const char* expectedText) {
  for (int k = 0; k < 3; ++k)
    if (!(std::abs(value[k] - expected[k]) <= tolerance))
      return fault(fmt::format("frame {}: {}[{}] = {:.9g}, but {} = {:.9g}", frame, what, k,
                               value[k], expectedText, expected[k]));
}

void SystemCheck::checkFrame(int id) {
  const FrameStorage here = now_.frameAt(id, 0.0, now_.q, now_.u);
  const Frame& f = here.f;
  if (f.absent) return;  // of a grain that has not come yet
  const bool moving = blocks_.nu > 0 && f.block >= 0;
  if (moving && f.block >= blocks_.capacity)
    return fault(
        fmt::format("frame {}: block = {}, the system has {}", id, f.block, blocks_.capacity));
  // v = J u + ν, Ω = J_R u + ν_R: sums of nu products.
  const Eigen::VectorXd u =
      moving ? now_.u.segment(f.block * blocks_.nu, blocks_.nu).eval() : Eigen::VectorXd();
  const Mat3X &JS = f.J_S_I, &JR = f.J_R_I;
  Vec3 v = f.nu_S_I, Omega = f.nu_R_I;
  double sizeV = v.norm() + f.v_S_I.norm(), sizeR = Omega.norm() + f.Omega_I.norm();
  if (moving) {
    v += JS * u, Omega += JR * u;
    sizeV += JS.norm() * u.norm(), sizeR += JR.norm() * u.norm();
  }
  compare("v_S_I", id, f.v_S_I, v, 64.0 * kEpsilon * sizeV, "J_S u + nu_S");
  compare("Omega_I", id, f.Omega_I, Omega, 64.0 * kEpsilon * sizeR, "J_R u + nu_R");
  if (!((f.A_IK.transpose() * f.A_IK - Mat3::Identity()).norm() <= 64.0 * kEpsilon * 3.0) ||
      !(f.A_IK.determinant() > 0.0))
    fault(fmt::format("frame {}: A_IK is not a rotation (det {:.9g})", id, f.A_IK.determinant()));
  // The workspace is not cleared between evaluations: a second call must give the same frame.
  FrameStorage again = now_.frameAt(id, 0.1, now_.moved(now_.u, 0.1), now_.u);
  system_.frame(now_.t, in(now_.q), in(now_.u), id, again.f);
  if (again.J != here.J || again.f.r_OS_I != f.r_OS_I || again.f.v_S_I != f.v_S_I)
    fault(fmt::format(
        "frame {}: the second call gives other values than the first (adds instead of assigns?)",
        id));
  checkFrameRates(id, f);
}

void SystemCheck::checkFrameRates(int id, const Frame& f) {
  // r, A (column after column), v, Ω along the motion.
  const auto pose = [&](double s) {
    const FrameStorage at = now_.frameAt(id, s, now_.moved(now_.u, s), now_.u);
    Eigen::VectorXd x(12);
    x << at.f.r_OS_I, at.f.A_IK.col(0), at.f.A_IK.col(1), at.f.A_IK.col(2);
    return x;
  };
  const testing::Difference D = testing::differentiate(pose);
  // A mark on a belt jumps back to its beginning: across the jump no difference is a rate.
  for (int k = 0; k < 3; ++k)
    if (const double off = std::abs(f.v_S_I[k] - D.value[k]);
        off > D.error && !testing::contradicts(pose, k, f.v_S_I[k], off))
      return leftOut(fmt::format("frame {}: its rates, since it jumps near the start", id));
  compare("v_S_I", id, f.v_S_I, D.value.head<3>(), D.error, "dr_OS/dt");
  const char* column[3] = {"dA_IK/dt, column 0", "dA_IK/dt, column 1", "dA_IK/dt, column 2"};
  for (int k = 0; k < 3; ++k)
    compare("(Omega x A_IK)", id, f.Omega_I.cross(f.A_IK.col(k)), D.value.segment<3>(3 + 3 * k),
            D.error, column[k]);
  const testing::Difference a = testing::differentiate([&](double s) {
    const FrameStorage at = now_.frameAt(id, s, now_.moved(now_.u, s), now_.u);
    Eigen::VectorXd x(6);
    x << at.f.v_S_I, at.f.Omega_I;
    return x;
  });
  compare("bias_S_I", id, f.bias_S_I, a.value.head<3>(), a.error, "dv_S/dt at fixed u");
  compare("bias_R_I", id, f.bias_R_I, a.value.tail<3>(), a.error, "dOmega/dt at fixed u");
}

}  // namespace

Verdict checkSystem(const PartialMechanicalSystem& system, const CheckOptions& options) {
  return SystemCheck(system, options).run();
}

}  // namespace dynamy
