#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/simulation/orbit/orbit_curve.hpp>
#include <dynamy/simulation/orbit/orbit_multipliers.hpp>
#include <utility>

namespace dynamy {
namespace {

constexpr std::size_t kMaps = 8;  ///< kept, of values of the parameter
constexpr int kMostCorrections = 12;
constexpr double kSlow = 0.2;  ///< of a residual to the last: derivatives are taken anew
constexpr double kCurveSettled =
    1e-9;  ///< a residual that no longer shrinks is accepted below this
constexpr double kParameterDelta = 3e-8;  ///< of p, for forward differences
constexpr double kLessParameter = 0.2;    ///< factor on it where the switches differ
constexpr int kParameterAttempts = 6;
/// Singular values of DP below are zero, by forward differences, by those of fourth order.
constexpr double kCoarseNoise = 1e-5, kFineNoise = 1e-7;

}  // namespace

struct OrbitCurve::Entry {
  Entry(const OrbitMaker& make, double value, double tolerance)
      : p(value), model(make(value, section)), map(model, section, tolerance) {}
  double p;
  OrbitSection section;
  Model model;
  ReturnMap map;
};

OrbitCurve::OrbitCurve(OrbitMaker make, double low, double high, double tolerance, double residual)
    : make_(std::move(make)), low_(low), high_(high), tolerance_(tolerance), residual_(residual) {}
OrbitCurve::~OrbitCurve() = default;

ReturnMap& OrbitCurve::at(double p) {
  const auto found =
      std::find_if(maps_.begin(), maps_.end(), [&](const auto& e) { return e->p == p; });
  if (found != maps_.end()) {
    std::rotate(found, found + 1, maps_.end());
    return maps_.back()->map;
  }
  if (maps_.size() == kMaps) {
    cycles_ += maps_.front()->map.cycles();
    maps_.erase(maps_.begin());
  }
  maps_.push_back(std::make_unique<Entry>(make_, p, tolerance_));
  return maps_.back()->map;
}

const Model& OrbitCurve::model(double p) {
  at(p);
  return maps_.back()->model;
}

long OrbitCurve::cycles() const {
  long out = cycles_;
  for (const auto& e : maps_) out += e->map.cycles();
  return out;
}

OrbitPoint OrbitCurve::start(double p, const State& x) {
  OrbitPoint out;
  out.p = p;
  ReturnMap& map = at(p);
  out.orbit = map.from(x);
  active_ = activeChanges(out.orbit, map.derivative(out.orbit));
  range_ = out.orbit.range;
  held_ = heldByJoints(maps_.back()->model, x);
  out.events = eventsOf(out.orbit.sequence);
  out.residual = miss(out).lpNorm<Eigen::Infinity>();
  derive(out);
  multipliers(out, true);
  return out;
}

Eigen::VectorXd OrbitCurve::between(const OrbitPoint& b, const OrbitPoint& a) {
  const auto n = static_cast<Eigen::Index>(active_.size());
  const Eigen::VectorXd z = at(a.p).variation().between(b.orbit.start, a.orbit.start);
  Eigen::VectorXd y(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index k = active_[static_cast<std::size_t>(i)];
    y[i] = z[k] / range_[k];
  }
  y[n] = (b.p - a.p) / unit();
  return y;
}

/// P ⊖ x without ignorable coordinates, over the ranges.
Eigen::VectorXd OrbitCurve::miss(const OrbitPoint& point) {
  const Eigen::VectorXd z = at(point.p).variation().between(point.orbit.end, point.orbit.start);
  Eigen::VectorXd out(static_cast<Eigen::Index>(active_.size()));
  for (std::size_t i = 0; i < active_.size(); ++i)
    out[static_cast<Eigen::Index>(i)] = z[active_[i]] / range_[active_[i]];
  return out;
}

/// The return from the state y away; `like`: with its steps, if the switches are the same.
bool OrbitCurve::evaluate(const OrbitPoint& from, const Eigen::VectorXd& y, const Return* like,
                          OrbitPoint& out) try {
  out = {};
  out.p = from.p + unit() * y[y.size() - 1];
  const double rounding = 1e-12 * unit();
  if (out.p < low_ - rounding || out.p > high_ + rounding) {
    why_ = "no orbit within the range of the parameter";
    return false;
  }
  if (out.p < low_ + rounding) out.p = low_;
  if (out.p > high_ - rounding) out.p = high_;
  ReturnMap& map = at(out.p);
  Eigen::VectorXd z = Eigen::VectorXd::Zero(map.variation().size());
  for (std::size_t i = 0; i < active_.size(); ++i)
    z[active_[i]] = y[static_cast<Eigen::Index>(i)] * range_[active_[i]];
  const State x = map.variation().added(from.orbit.start, z);
  if (like == nullptr || !map.like(*like, x, out.orbit)) out.orbit = map.from(x, &from.orbit);
  out.events = eventsOf(out.orbit.sequence);
  out.residual = miss(out).lpNorm<Eigen::Infinity>();
  return true;
} catch (const ModelError& e) {
  why_ = e.diagnostics().front().text;
  return false;
}

void OrbitCurve::derive(OrbitPoint& point) {
  ReturnMap& map = at(point.p);
  const ReturnDerivative d = map.derivative(point.orbit, {.forward = true});
  point.orbit.rate = d.rate;
  point.P = scaledMap(d.P, active_, range_);
  double delta = kParameterDelta * unit();
  if (point.p + delta > high_) delta = -delta;
  for (int tries = 0;; ++tries, delta *= kLessParameter) try {
      const Eigen::VectorXd by =
          map.byParameter(point.orbit, d, at(point.p + delta), delta / unit());
      point.byParameter.resize(static_cast<Eigen::Index>(active_.size()));
      for (std::size_t i = 0; i < active_.size(); ++i)
        point.byParameter[static_cast<Eigen::Index>(i)] = by[active_[i]] / range_[active_[i]];
      return;
    } catch (const ModelError&) {
      if (tries + 1 == kParameterAttempts) throw;
    }
}

Eigen::MatrixXd OrbitCurve::jacobian(const OrbitPoint& point, const Eigen::VectorXd& n) const {
  const auto m = static_cast<Eigen::Index>(active_.size());
  Eigen::MatrixXd J(m + 1, m + 1);
  J.topLeftCorner(m, m) = point.P;
  J.topLeftCorner(m, m).diagonal().array() -= 1.0;
  J.topRightCorner(m, 1) = point.byParameter;
  J.row(m) = n.transpose();
  return J;
}

bool OrbitCurve::solve(const OrbitPoint& from, const Eigen::VectorXd& guess,
                       const Eigen::VectorXd& n, const Effort& effort, OrbitPoint& out) try {
  why_ = "no orbit: corrections do not converge";
  Eigen::VectorXd y = guess;
  if (!evaluate(from, y, nullptr, out)) return false;
  PivotedQr qr;
  if (!effort.fresh) qr.compute(jacobian(from, n));
  int derived = 0;
  double before = 0.0;
  for (int k = 0; out.residual > residual_; ++k) {
    const bool slow = k > 0 && out.residual > kSlow * before;
    if ((slow && derived == effort.derivatives) || k == kMostCorrections)
      return out.residual < kCurveSettled;
    if (slow || (k == 0 && effort.fresh)) {
      derive(out), ++derived;
      qr.compute(jacobian(out, n));
    }
    Eigen::VectorXd b(n.size());
    b.head(n.size() - 1) = -miss(out);
    b[n.size() - 1] = n.dot(guess - y);
    y += qr.solve(b);
    if (!((y - guess).norm() <= effort.reach)) {
      why_ = "no orbit nearby";
      return false;
    }
    before = out.residual;
    const Return like = std::move(out.orbit);
    if (!evaluate(from, y, &like, out)) return false;
  }
  return true;
} catch (const ModelError& e) {
  why_ = e.diagnostics().front().text;
  return false;
}

bool OrbitCurve::probe(const OrbitPoint& from, const Eigen::VectorXd& guess, OrbitPoint& out) {
  return evaluate(from, guess, nullptr, out);
}

Eigen::VectorXcd OrbitCurve::multipliers(OrbitPoint& point, bool fine) {
  if (fine)
    point.P = scaledMap(at(point.p).derivative(point.orbit, {.fine = 1.0}).P, active_, range_);
  const double noise = (fine ? kFineNoise : kCoarseNoise) * std::max(1.0, point.P.norm());
  Eigen::VectorXcd out = multipliersOf(point.P, noise);
  if (fine) nonzero_ = out.size();
  return out.head(std::min(nonzero_, out.size()));
}

int OrbitCurve::zeros(const OrbitPoint& point, Eigen::Index others) {
  const bool signal = !at(point.p).section().signal.empty();
  return static_cast<int>(static_cast<Eigen::Index>(active_.size()) - others) - (signal ? 1 : 0) -
         held_;
}

Eigen::VectorXd OrbitCurve::tangent(const OrbitPoint& point, const Eigen::VectorXd& along) const {
  PivotedQr qr;
  qr.compute(jacobian(point, along));
  Eigen::VectorXd b = Eigen::VectorXd::Zero(along.size());
  b[along.size() - 1] = 1.0;
  return Eigen::VectorXd(qr.solve(b)).normalized();
}

}  // namespace dynamy
