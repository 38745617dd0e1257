// Checks of a force law at random arguments. With p = prox(z) and −ξ = R⁻¹(z − p) the pair (p, ξ)
// is a solution of −ξ ∈ N_C(p) by construction, so it must have all properties of solutions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/testing/check_element.hpp>
#include <dynamy/testing/difference.hpp>
#include <random>

namespace dynamy {
namespace {

/// Tolerance of a projection: ten times 1e-13 of the argument, to which laws may iterate it.
constexpr double kProjection = 1e-12;

class LawCheck {
 public:
  LawCheck(const SetValuedForceLaw& law, int dim, const CheckOptions& options)
      : law_(law), dim_(dim), options_(options), random_(options.seed) {
    name_ = law.type().empty() ? "law" : law.type();
  }

  Verdict run() {
    if (dim_ < 1 || dim_ > kMostRows) {
      fault("1 to 8 rows are possible");
      return result_;
    }
    if (law_.dim(dim_) != dim_)
      fault(fmt::format("dim({}) = {}: it does not accept its own rows", dim_, law_.dim(dim_)));
    for (int a = 0; a < dim_ && result_;) {
      const int b = law_.groupEnd(a, dim_);
      if (b <= a || b > dim_) fault(fmt::format("groupEnd({}, {}) = {}", a, dim_, b));
      a = b;
    }
    for (int i = 0; i < 40 * options_.states && result_; ++i) {
      sample(i);
      checkProjection();
      checkSolution();
      checkExpansion();
      checkStatus();
      checkDerivative();
      checkSimpleSet();
      checkScale();
    }
    return result_;
  }

 private:
  using Rows = Eigen::VectorXd;
  void fault(const std::string& text) { result_.fault(name_ + ": " + text); }
  double uniform() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  Rows random(double size) {
    Rows x(dim_);
    for (double& v : x) v = size * uniform();
    return x;
  }
  /// Random r, positive and equal in each group of rows.
  Rows steps() {
    Rows r(dim_);
    for (int a = 0; a < dim_;) {
      const int b = law_.groupEnd(a, dim_);
      const double value = std::exp(2.0 * uniform());
      for (; a < b; ++a) r[a] = value;
    }
    return r;
  }
  LawInput input() const {
    return {.dim = dim_, .dt = dt_, .gammaA = gammaA_.data(), .scale = scaled_};
  }
  /// prox_C(z) in the metric diag(r)⁻¹.
  Rows prox(const Rows& r, const Rows& z) const {
    Rows out = z;
    const Rows zero = Rows::Zero(dim_);
    law_.prox(input(), r.data(), zero.data(), out.data());
    return out;
  }
  Rows naturalMap(double rho, const Rows& xi, const Rows& Lambda) const {
    Rows e(dim_);
    law_.naturalMap(input(), rho, xi.data(), Lambda.data(), e.data());
    return e;
  }
  static std::string text(const Rows& x) {
    std::string out = "(";
    for (int i = 0; i < x.size(); ++i) out += fmt::format("{}{:.6g}", i ? ", " : "", x[i]);
    return out + ")";
  }

  void sample(int i) {
    // Small, middle and large arguments relative to the size of the set; dt = 0: pure impact.
    const double size = i % 3 == 0 ? 0.05 : (i % 3 == 1 ? 1.0 : 20.0);
    dt_ = i % 7 == 6 ? 0.0 : 1.0;
    gammaA_ = random(1.0);
    r_ = steps();
    z_ = random(size);
    if (law_.rowKind(0) == RowKind::normal && i % 4 != 0) z_[0] = std::abs(z_[0]);
    p_ = prox(r_, z_);
    xi_ = (p_ - z_).cwiseQuotient(r_);
    scale_ = z_.norm() + p_.norm();
  }

  void checkProjection();
  void checkSolution();
  void checkExpansion();
  void checkStatus();
  void checkDerivative();
  void checkSimpleSet();
  void checkScale();
  Rows ofSimpleSet(const SimpleSet& set, const Rows& z) const;

  const SetValuedForceLaw& law_;
  int dim_;
  CheckOptions options_;
  std::mt19937 random_;
  std::string name_;
  double dt_ = 1.0, scaled_ = 1.0, scale_ = 0.0;
  Rows gammaA_, r_, z_, p_, xi_;
  Verdict result_;
};

void LawCheck::checkProjection() {
  if (!p_.allFinite()) return fault(fmt::format("prox{} = {} is not finite", text(z_), text(p_)));
  const double tolerance = kProjection * scale_;
  if (const Rows again = prox(r_, p_); !((again - p_).norm() <= tolerance))
    fault(fmt::format("prox is not idempotent: {} -> {} -> {}", text(z_), text(p_), text(again)));
  const Rows e = naturalMap(1.0, Rows::Zero(dim_), p_);
  if (!(e.norm() <= tolerance))
    fault(fmt::format("the result {} of prox is not in C: naturalMap at xi = 0 is {}", text(p_),
                      text(e)));
  // prox(Λ − r ξ) depends on the argument alone.
  Rows split = p_;
  law_.prox(input(), r_.data(), xi_.data(), split.data());
  if (!((split - p_).norm() <= tolerance))
    fault(fmt::format("prox(Lambda - r xi) = {}, but {} at the same argument", text(split),
                      text(p_)));
}

void LawCheck::checkSolution() {
  // With another r', errors of ξ, of size |z|/r, are multiplied by r'.
  const Rows other = steps();
  const double ratio = std::max(1.0, other.cwiseQuotient(r_).maxCoeff());
  const double tolerance = 4.0 * kProjection * scale_ * ratio;
  Rows same = p_;
  law_.prox(input(), other.data(), xi_.data(), same.data());
  if (!((same - p_).norm() <= tolerance))
    fault(fmt::format(
        "Lambda = {}, xi = {} solves Lambda = prox(Lambda - r xi) with r = {}, not with {}: off by "
        "{:.2g}",
        text(p_), text(xi_), text(r_), text(other), (same - p_).norm()));
  const double rho = other[0],
               worst = 4.0 * kProjection * scale_ * std::max(1.0, rho / r_.minCoeff());
  const Rows e = naturalMap(rho, xi_, p_);
  if (!(e.norm() <= worst))
    fault(fmt::format("naturalMap = {} at the solution Lambda = {}, xi = {}", text(e), text(p_),
                      text(xi_)));
  // 0 ∈ C and −ξ ∈ N_C(Λ) give −ξ·(0 − Λ) ≤ 0.
  const bool zeroInC = naturalMap(1.0, Rows::Zero(dim_), Rows::Zero(dim_)).norm() == 0.0;
  if (zeroInC &&
      !(p_.dot(xi_) <= tolerance * xi_.norm() + kProjection * scale_ * scale_ / r_.minCoeff()))
    fault(fmt::format("Lambda·xi = {:.6g} > 0 at Lambda = {}, xi = {}: the law feeds energy",
                      p_.dot(xi_), text(p_), text(xi_)));
}

void LawCheck::checkExpansion() {
  // A set that grows with the normal force is a convex set of the other rows if z_N is equal.
  Rows z = z_ + random(0.5 * z_.norm());
  const bool reservoir = dim_ > 1 && law_.rowKind(0) == RowKind::normal;
  if (reservoir) z[0] = z_[0];
  const Rows inverse = r_.cwiseInverse(), p = prox(r_, z), dp = p - p_, dz = z - z_;
  const double after = dp.dot(inverse.cwiseProduct(dp)), before = dz.dot(inverse.cwiseProduct(dz));
  if (!(after <= before + 4.0 * kProjection * scale_ * scale_ * inverse.maxCoeff()))
    fault(fmt::format("prox expands: {} and {} go to {} and {} (r = {})", text(z_), text(z),
                      text(p_), text(p), text(r_)));
}

void LawCheck::checkStatus() {
  const Status status = law_.status(input(), z_.data());
  const bool normal = law_.rowKind(0) == RowKind::normal;
  const int first = normal ? 1 : 0;
  if (normal && dim_ >= 1 && (status == Status::separating) != (p_[0] == 0.0) && law_.unilateral())
    fault(fmt::format("status of {} is {}, but Lambda_N = {:.6g}", text(z_), statusText(status),
                      p_[0]));
  if (first >= dim_ || (status != Status::stick && status != Status::slip)) return;
  // A point outside stays outside in every metric.
  const double change = (p_ - z_).tail(dim_ - first).norm();
  if (status == Status::stick && !(change <= kProjection * scale_))
    fault(fmt::format("status of {} is stick, but prox moves it to {}", text(z_), text(p_)));
  if (status == Status::slip && !(change > 0.0))
    fault(fmt::format("status of {} is slip, but prox leaves it", text(z_)));
}

void LawCheck::checkDerivative() {
  const double rho = r_[0];
  const Rows Lambda = random(z_.norm() / std::sqrt(dim_)), xi = (Lambda - z_) / rho;
  RowMatrix A(dim_, dim_), B(dim_, dim_);
  if (!law_.proxDerivative(input(), rho, xi.data(), Lambda.data(), A.data(), B.data())) return;
  const Rows equal = Rows::Constant(dim_, rho);
  const double size = std::max(z_.norm(), 1e-3);
  for (int j = 0; j < dim_; ++j) {
    const auto F = [&](double dLambda, double dXi) {
      Rows L = Lambda, x = xi, out;
      L[j] += dLambda, x[j] += dXi;
      out = L;
      law_.prox(input(), equal.data(), x.data(), out.data());
      return Rows(L - out);
    };
    const double noise = kProjection * size;
    const testing::Difference dA =
        testing::differentiate([&](double s) { return F(s, 0.0); }, 0.1 * size, noise / 30);
    const testing::Difference dB =
        testing::differentiate([&](double s) { return F(0.0, s); }, 0.1 * size / rho, noise / 30);
    // Near a kink the two step lengths of the difference disagree: nothing can be stated there.
    if (dA.error > 1e-4 || dB.error > 1e-4 * rho) continue;
    for (int i = 0; i < dim_; ++i) {
      if (!(std::abs(A(i, j) - dA.value[i]) <= dA.error))
        fault(fmt::format("proxDerivative: A[{},{}] = {:.9g}, difference {:.9g} at z = {}", i, j,
                          A(i, j), dA.value[i], text(z_)));
      if (!(std::abs(B(i, j) - dB.value[i]) <= dB.error))
        fault(fmt::format("proxDerivative: B[{},{}] = {:.9g}, difference {:.9g} at z = {}", i, j,
                          B(i, j), dB.value[i], text(z_)));
    }
  }
}

/// Projection of z onto a simple set, with one r for all rows.
LawCheck::Rows LawCheck::ofSimpleSet(const SimpleSet& set, const Rows& z) const {
  Rows out = z;
  const auto shrink = [](Eigen::Ref<Rows> x, double radius) {
    const double length = x.norm();
    if (length > radius) x *= std::max(radius, 0.0) / length;
  };
  if (set.shape == SimpleSet::Shape::interval)
    out[0] = std::min(std::max(z[0], set.lower), set.upper);
  else if (set.shape == SimpleSet::Shape::ball)
    shrink(out, set.upper);
  else if (set.shape == SimpleSet::Shape::friction)
    out[0] = std::max(z[0], 0.0), shrink(out.tail(dim_ - 1), set.upper * out[0]);
  return out;
}

/// Solvers and runs to a tolerance take simpleSet(), others prox(): both are one law.
void LawCheck::checkSimpleSet() {
  const SimpleSet set = law_.simpleSet(input());
  if (set.shape == SimpleSet::Shape::other) return;
  if (set.shape == SimpleSet::Shape::interval && dim_ != 1)
    return fault(fmt::format("simpleSet: an interval has one row, not {}", dim_));
  const Rows equal = Rows::Constant(dim_, r_[0]);
  const Rows p = prox(equal, z_), expected = ofSimpleSet(set, z_);
  if (!((p - expected).norm() <= kProjection * scale_))
    fault(fmt::format(
        "simpleSet and prox are two laws: of {} the set gives {}, prox {} (gammaA = {})", text(z_),
        text(expected), text(p), text(gammaA_)));
}

/// The set of twice the scale is twice the set; of a unilateral law the normal force is not scaled.
void LawCheck::checkScale() {
  if (!law_.scales() || law_.unilateral()) return;
  constexpr double kTwice = 2.0;
  scaled_ = kTwice;
  const Rows p = prox(r_, kTwice * z_);
  scaled_ = 1.0;
  if (!((p - kTwice * p_).norm() <= kTwice * kProjection * scale_))
    fault(fmt::format("scales() is true, but with LawInput::scale = 2 prox{} is {}, not {}",
                      text(kTwice * z_), text(p), text(kTwice * p_)));
}

}  // namespace

Verdict checkLaw(const SetValuedForceLaw& law, int dim, const CheckOptions& options) {
  return LawCheck(law, dim, options).run();
}

}  // namespace dynamy
