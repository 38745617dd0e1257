#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/simulation/orbit/orbit.hpp>
#include <dynamy/simulation/orbit/orbit_multipliers.hpp>

namespace dynamy {
namespace {

constexpr double kTolerance = 1e-12;  ///< of runs
constexpr int kMostNewton = 40;       ///< of Newton's method
constexpr int kDampings = 8;          ///< of one of its steps
/// Steps of Newton's method this small, in units of the ranges, keep the switches of the motion.
constexpr double kSameSwitches = 1e-3;
constexpr double kRankOfMap = 1e-8;  ///< of DP − 1
/// Singular values of the scaled DP below are zero: central differences of fourth order leave
/// 1e-10.
constexpr double kMapNoise = 1e-8, kMostNoise = 1e-6;
/// A residual that no longer shrinks is accepted below this.
constexpr double kSettled = 1e-9;
/// The runs that tell the errors: factors on tolerance and differences.
constexpr double kCoarser = 10.0, kWiderDelta = 3.0;
/// The second period may differ from the first by this.
constexpr double kPeriodic = 1e-6;

class Search {
 public:
  Search(ReturnMap& map, double residual) : map_(map), wanted_(residual) {}

  /// Newton's method from a state on the section.
  void solve(const State& start) {
    now_ = map_.from(start);
    derive();
    away_ = size(miss(now_));
    while (size(miss(now_)) > wanted_) {
      if (newton_ == kMostNewton)
        throw ModelError(fmt::format("no orbit found: after {} steps of Newton's method the motion "
                                     "still misses its start by {:.2g} of its size",
                                     newton_, size(miss(now_))),
                         "start nearer to the orbit");
      const double before = size(miss(now_));
      const bool moved = step();
      const double after = size(miss(now_));
      if (!moved || (before < kSettled && after > 0.5 * before)) {
        if (after < kSettled) break;
        throw ModelError(
            fmt::format(
                "no orbit found: {:.2g} of its size away from its start, no step of Newton's "
                "method comes nearer",
                after),
            "start nearer to the orbit, or change a parameter in smaller steps");
      }
      derive();
    }
  }
  const Return& at() const { return now_; }
  int newton() const { return newton_; }
  double away() const { return away_; }
  double residual() const { return size(miss(now_)); }
  const std::vector<Eigen::Index>& active() const { return active_; }

  /// P(x) ⊖ x without ignorable coordinates, over their ranges.
  Eigen::VectorXd miss(const Return& r) const {
    const Eigen::VectorXd z = map_.variation().between(r.end, r.start);
    Eigen::VectorXd out(static_cast<Eigen::Index>(active_.size()));
    for (std::size_t i = 0; i < active_.size(); ++i)
      out[static_cast<Eigen::Index>(i)] = z[active_[i]] / now_.range[active_[i]];
    return out;
  }
  static double size(const Eigen::VectorXd& v) {
    return v.size() > 0 ? v.lpNorm<Eigen::Infinity>() : 0.0;
  }
  /// The scaled DP of active coordinates.
  Eigen::MatrixXd scaled(const Eigen::MatrixXd& P) const {
    return scaledMap(P, active_, now_.range);
  }

 private:
  void derive() {
    const ReturnDerivative d = map_.derivative(now_);
    active_ = activeChanges(now_, d);
    Eigen::MatrixXd J = scaled(d.P);
    J.diagonal().array() -= 1.0;
    inverse_.compute(J);
  }

  /// One damped step: the next step, by the same derivative, has to be shorter.
  bool step() {
    const Eigen::VectorXd whole = -inverse_.solve(miss(now_));
    double part = 1.0;
    for (int i = 0; i < kDampings; ++i, part *= 0.5) {
      Eigen::VectorXd z = Eigen::VectorXd::Zero(map_.variation().size());
      for (std::size_t k = 0; k < active_.size(); ++k)
        z[active_[k]] = part * whole[static_cast<Eigen::Index>(k)] * now_.range[active_[k]];
      const State x = map_.variation().added(now_.start, z);
      Return next;
      try {
        if (size(whole) > kSameSwitches || !map_.like(now_, x, next)) next = map_.from(x, &now_);
      } catch (const ModelError&) {
        if (i + 1 == kDampings) throw;
        continue;
      }
      const Eigen::VectorXd after = inverse_.solve(miss(next));
      if (!(after.norm() <= (1.0 - 0.25 * part) * whole.norm()) && size(miss(next)) > wanted_)
        continue;
      now_ = std::move(next);
      ++newton_;
      return true;
    }
    return false;
  }

  ReturnMap& map_;
  double wanted_;
  Return now_;
  std::vector<Eigen::Index> active_;
  PseudoInverse inverse_{kRankOfMap};
  int newton_ = 0;
  double away_ = 0.0;
};

/// Throws if the second period differs from the first: the model depends on time in another way.
void expectPeriodic(ReturnMap& map, const Search& search, double growth) {
  Return second = search.at();
  second.start = search.at().end;
  second.end = map.after(search.at());
  const Eigen::VectorXd change = search.miss(second) - search.miss(search.at());
  if (Search::size(change) <= kPeriodic * std::max(1.0, growth * growth)) return;
  throw ModelError(fmt::format("the second period differs from the first by {:.2g} of the motion's "
                               "size: the model depends on time with another period",
                               Search::size(change)),
                   "give the period of what drives it");
}

}  // namespace

double Orbit::largest() const {
  return multipliers.size() > 0 ? multipliers.cwiseAbs().maxCoeff() : 0.0;
}

Orbit orbit(Model& model, const OrbitRequest& request, const State* start) {
  Orbit out;
  out.section = request.section;
  out.tolerance = request.tolerance > 0.0 ? request.tolerance : kTolerance;
  ReturnMap map(model, request.section, out.tolerance);
  Search search(map, request.residual);
  search.solve(start != nullptr ? *start : map.start());
  const Return& r = search.at();
  const int halves = map.halves();
  out.period = halves * r.period, out.residual = search.residual(), out.newton = search.newton();
  out.away = search.away(), out.at = r.start;
  for (const MotionSequence::Step& s : r.sequence.steps)
    out.switches += halves * s.switches, out.impacts += s.impacts.empty() ? 0 : halves;

  // The same from less accurate runs and wider differences tells the errors.
  ReturnMap rough(model, request.section, kCoarser * out.tolerance);
  Search again(rough, request.residual);
  again.solve(r.start);
  out.periodError = std::abs(halves * again.at().period - out.period);

  const Eigen::MatrixXd P = search.scaled(map.derivative(r, {.fine = 1.0}).P);
  const Eigen::MatrixXd other =
      search.scaled(rough.derivative(again.at(), {.fine = kWiderDelta}).P);
  const double size = P.size() > 0 ? P.cwiseAbs().maxCoeff() : 0.0;
  const double error = P.size() > 0 ? (P - other).cwiseAbs().maxCoeff() : 0.0;
  const double unit = std::max(1.0, size);
  const double noise = std::clamp(3.0 * error, kMapNoise * unit, kMostNoise * unit);
  const Eigen::VectorXcd ofReturn = multipliersOf(P, noise);
  out.multipliers = ofOrbit(ofReturn, halves);
  if (halves > 1) out.half = ofReturn;
  const Eigen::VectorXcd others = ofOrbit(multipliersOf(other, noise), halves);
  for (Eigen::Index i = 0; i < out.multipliers.size(); ++i)
    out.multiplierError = std::max(
        out.multiplierError, std::abs(out.multipliers[i] - (i < others.size() ? others[i] : 0.0)));
  out.zeros =
      static_cast<int>(search.active().size() - static_cast<std::size_t>(out.multipliers.size())) -
      (request.section.signal.empty() ? 0 : 1) - heldByJoints(model, r.start);
  expectPeriodic(map, search, out.largest());

  const std::vector<std::string> names = map.variation().names();
  const Eigen::VectorXd z = map.variation().between(r.end, r.start);
  out.state = coordinatesOf(model, r.start);
  for (Eigen::Index i = 0; i < z.size(); ++i)
    if (std::find(search.active().begin(), search.active().end(), i) == search.active().end())
      out.shift.emplace_back(names[static_cast<std::size_t>(i)], halves * z[i]);

  return out;
}

}  // namespace dynamy
