#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <dynamy/simulation/linear/state_variation.hpp>
#include <dynamy/simulation/orbit/branch_tracer.hpp>
#include <dynamy/simulation/orbit/orbit_multipliers.hpp>
#include <limits>
#include <utility>

namespace dynamy {
namespace {

using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double kShortest = 1.0 / 64.0;  ///< step, in units of the longest: then something changed
constexpr double kReach = 1.0;            ///< of corrections, in units of the step
constexpr int kDerivatives = 2;           ///< taken in corrections
constexpr double kGoodPrediction = 0.02;  ///< its error in units of the step
constexpr double kSharp = 0.7;            ///< cosine of a turn in a step that is too long
constexpr int kMostPoints = 10;           ///< in units of those wanted
/// Width of the interval in p that holds a change or an instability, in units of |p|.
constexpr double kLocated = 1e-10;
constexpr int kMostTrials = 40;
constexpr double kClustered = 0.01;  ///< distance of nodes, of that from s
constexpr double kShrinks = 0.3;     ///< a step of secants to the one before, at most
constexpr int kFewest = 3;           ///< such steps before
constexpr double kTells = 1e-6;      ///< changes of a multiplier that tell its slope
constexpr double kCoarse = 1e-5;     ///< of a multiplier: fine differences from here on
constexpr double kNeutral = 1e-7;    ///< moduli this near to 1 may be 1
constexpr double kReal = 1e-9;       ///< smaller imaginary parts are rounding

/// Multipliers that make an orbit unstable.
struct Outside {
  int above = 0, below = 0, pairs = 0;  ///< > 1, < −1, complex
  explicit Outside(const VectorXcd& all) {
    for (const std::complex<double>& m : all) {
      if (std::abs(m) <= 1.0 + kNeutral) continue;
      if (std::abs(m.imag()) > kReal)
        pairs += m.imag() > 0.0 ? 1 : 0;
      else
        ++(m.real() > 0.0 ? above : below);
    }
  }
  int all() const { return above + below + 2 * pairs; }
};

/// The real multiplier nearest to `at`, less it; of none: a complex one's real part.
double nearestReal(const VectorXcd& all, double at) {
  double best = 1e300, out = -at;
  for (const std::complex<double>& m : all) {
    const double apart = std::abs(m - at) + (std::abs(m.imag()) > kReal ? 1.0 : 0.0);
    if (apart < best) best = apart, out = m.real() - at;
  }
  return out;
}

/// |m| − 1 of the complex pair nearest to the unit circle.
double nearestPair(const VectorXcd& all) {
  double best = 1e300, out = -1.0;
  for (const std::complex<double>& m : all) {
    const double off = std::abs(m) - 1.0;
    if (std::abs(m.imag()) > kReal && std::abs(off) < best) best = std::abs(off), out = off;
  }
  return out;
}

/// Up to `count` nodes near s. Of nodes close together, seen from s, one is taken: a polynomial
/// through a cluster says nothing beside it.
std::vector<BranchNode> nodesNear(std::vector<BranchNode> nodes, double s, std::size_t count) {
  std::sort(nodes.begin(), nodes.end(),
            [&](const auto& a, const auto& b) { return std::abs(a.s - s) < std::abs(b.s - s); });
  std::vector<BranchNode> out;
  for (const BranchNode& n : nodes) {
    const bool clustered = std::any_of(out.begin(), out.end(), [&](const BranchNode& o) {
      return std::abs(o.s - n.s) < kClustered * std::abs(n.s - s);
    });
    if (!clustered) out.push_back(n);
    if (out.size() == count) break;
  }
  return out;
}

}  // namespace

VectorXd through(const std::vector<BranchNode>& nodes, double s) {
  VectorXd out = VectorXd::Zero(nodes.front().y.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    double part = 1.0;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (k != i) part *= (s - nodes[k].s) / (nodes[i].s - nodes[k].s);
    out += part * nodes[i].y;
  }
  return out;
}

BranchTracer::BranchTracer(OrbitCurve& curve, int points)
    : curve_(curve),
      longest_(1.0 / points),
      most_(static_cast<std::size_t>(kMostPoints * points)) {}

BranchPoint BranchTracer::result(OrbitPoint& point) {
  BranchPoint out;
  out.p = point.p, out.period = point.orbit.period, out.residual = point.residual;
  out.at = point.orbit.start;
  for (const auto& [name, value] : coordinatesOf(curve_.model(point.p), point.orbit.start))
    out.state.push_back(value);
  out.multipliers = curve_.multipliers(point, false);
  out.zeros = curve_.zeros(point, out.multipliers.size());
  out.stable = out.multipliers.size() == 0 || out.multipliers.cwiseAbs().maxCoeff() < 1.0;
  return out;
}

VectorXd BranchTracer::predicted(double s) const {
  VectorXd out = s * tangent_;
  std::vector<Node> g;
  for (const Node& n : old_)
    if (n.s < -0.2 * s) g.push_back({n.s, (n.y - n.s * tangent_) / (n.s * n.s)});
  if (!g.empty()) out += s * s * through(nodesNear(g, s, 2), s);
  return out;
}

/// The point of the curve near `guess`, in the plane across the tangent, or at a limit of p.
BranchTracer::Tried BranchTracer::attempt(const VectorXd& guess, int derivatives, OrbitPoint& out) {
  VectorXd at = guess, n = tangent_;
  const Eigen::Index last = guess.size() - 1;
  const double p = base_.p + curve_.unit() * guess[last];
  atLimit_ = p <= curve_.low() || p >= curve_.high();
  if (atLimit_) {
    const double limit = p <= curve_.low() ? curve_.low() : curve_.high();
    at *= (limit - base_.p) / (p - base_.p);
    n = VectorXd::Unit(guess.size(), last);
  }
  const OrbitCurve::Effort effort{.reach = kReach * at.norm(), .derivatives = derivatives};
  if (!curve_.solve(base_, at, n, effort, out)) return Tried::failed;
  return sameEvents(out.events, base_.events) ? Tried::good : Tried::changed;
}

void BranchTracer::take(const OrbitPoint& next, const VectorXd& y, const VectorXd& tangent) {
  tangent_ = tangent;
  old_.push_back({0.0, VectorXd::Zero(y.size())});
  if (old_.size() > 3) old_.erase(old_.begin());
  for (Node& n : old_) n.y -= y, n.s = tangent_.dot(n.y);
  base_ = next;
}

void BranchTracer::end(const std::string& text) {
  BranchPoint& last = out_.back();
  if (last.kind.empty()) last.kind = "end";
  last.text += (last.text.empty() ? "" : "; ") + text;
}

std::vector<BranchPoint> BranchTracer::follow(const OrbitPoint& start, double sign) {
  out_.clear(), old_.clear();
  base_ = start;
  multipliers_ = curve_.multipliers(base_, false);
  const Eigen::Index n = base_.byParameter.size();
  tangent_ = curve_.tangent(base_, sign * VectorXd::Unit(n + 1, n));
  double h = 0.25 * longest_;
  if ((sign > 0.0 ? curve_.high() - base_.p : base_.p - curve_.low()) <= 0.0) return {};
  while (step(h)) {
    if (out_.size() < most_) continue;
    end(fmt::format("it goes on: these are {} points", out_.size()));
    break;
  }
  return std::move(out_);
}

/// One step of length h. False: the branch ends.
bool BranchTracer::step(double& h) {
  OrbitPoint next;
  const VectorXd guess = predicted(h);
  Tried tried = attempt(guess, kDerivatives, next);
  const bool limit = atLimit_;
  if (tried == Tried::good && next.P.size() == 0) try {
      curve_.derive(next);
    } catch (const ModelError&) {
      tried = Tried::failed;
    }
  if (tried == Tried::good) {
    const VectorXd y = curve_.between(next, base_);
    const VectorXd tangent = curve_.tangent(next, tangent_);
    if (tangent.dot(tangent_) > kSharp || h <= kShortest * longest_) {
      findInstabilities(next, {tangent_.dot(y), y});
      out_.push_back(result(next));
      multipliers_ = out_.back().multipliers;
      take(next, y, tangent);
      if (limit) end("the range of the parameter ends");
      const double error = (y - guess).norm() / (kGoodPrediction * h);
      h = std::min(longest_, h * std::clamp(1.0 / std::sqrt(error + 1e-9), 0.5, 2.0));
      return !limit;
    }
    tried = Tried::failed;
  }
  if (tried == Tried::failed && h > kShortest * longest_) {
    h *= 0.25;
    return true;
  }
  if (!change(h)) return false;
  h = kShortest * longest_;
  return true;
}

/// Adds the points between the base and `next` where multipliers leave or enter the unit circle.
void BranchTracer::findInstabilities(OrbitPoint& next, const Node& node) {
  const VectorXcd now = curve_.multipliers(next, false);
  const Outside a(multipliers_), b(now);
  std::vector<std::pair<double, BranchPoint>> found;
  const auto add = [&](const std::string& kind, const std::string& text, const Off& off) {
    const double before = off(multipliers_), after = off(now);
    if (!(before * after < 0.0)) return;
    double s = 0.0;
    BranchPoint at = locate(node, off, before, after, s);
    if (at.kind == "lost") return;
    at.kind = kind, at.text = text;
    found.emplace_back(s, std::move(at));
  };
  if ((a.below + b.below) % 2 != 0)
    add("flip", "a multiplier passes -1: the period doubles",
        [](const VectorXcd& m) { return nearestReal(m, -1.0); });
  const bool folds =
      tangent_[tangent_.size() - 1] * curve_.tangent(next, tangent_)[tangent_.size() - 1] < 0.0;
  if ((a.above + b.above) % 2 != 0)
    add(folds ? "fold" : "branching",
        folds ? "a multiplier passes 1: the branch turns back"
              : "a multiplier passes 1: another branch crosses",
        [](const VectorXcd& m) { return nearestReal(m, 1.0); });
  if (a.pairs != b.pairs && a.all() != b.all())
    add("Neimark-Sacker", "a pair of multipliers passes the unit circle: a second frequency",
        nearestPair);
  std::sort(found.begin(), found.end(),
            [](const auto& x, const auto& y) { return x.first < y.first; });
  for (auto& [s, point] : found) out_.push_back(std::move(point));
}

/// The root of `off` between the base and `next`: by false position with the derivatives of the
/// steps, then by secants with fine ones.
BranchPoint BranchTracer::locate(const Node& next, const Off& off, double before, double after,
                                 double& s) {
  std::vector<Node> nodes = old_;
  nodes.push_back({0.0, VectorXd::Zero(next.y.size())});
  nodes.push_back(next);
  double a = 0.0, b = next.s, fa = before, fb = after;
  const double tolerance = kLocated * std::max(std::abs(curve_.low()), std::abs(curve_.high()));
  BranchPoint out;
  out.kind = "lost";
  Node last{b, {}};
  double lastOff = fb, slope = (fb - fa) / (b - a);
  bool fine = false, alike = false;
  int refined = 0;
  double nearest = std::numeric_limits<double>::infinity();
  s = a - fa / slope;
  for (int i = 0; i < kMostTrials; ++i) {
    OrbitPoint at;
    if (attempt(through(nodesNear(nodes, s, 4), s), kDerivatives, at) == Tried::failed) return out;
    try {
      curve_.derive(at);
    } catch (const ModelError&) {
      return out;
    }
    const double f = off(curve_.multipliers(at, fine));
    // Coarse multipliers are too inaccurate for the slope between them and fine ones.
    if (alike && std::abs(f - lastOff) > kTells) slope = (f - lastOff) / (s - last.s);
    alike = fine;
    if (std::none_of(nodes.begin(), nodes.end(), [&](const Node& n) { return n.s == s; }))
      nodes.push_back({s, curve_.between(at, base_)});
    last.s = s, lastOff = f;
    if (fine) {
      const double ds = -f / slope;
      // Steps that no longer shrink are the noise of multipliers.
      const bool noise = ++refined > kFewest && std::abs(ds) > kShrinks * nearest;
      if (std::abs(ds) < nearest) nearest = std::abs(ds), out = result(at);
      if (nearest * curve_.unit() <= tolerance || noise) return out;
      s += ds;
      continue;
    }
    // False position; an end that stays counts half.
    if ((f < 0.0) == (fa < 0.0))
      a = s, fa = f, fb *= 0.5;
    else
      b = s, fb = f, fa *= 0.5;
    fine = std::abs(f) < kCoarse || (b - a) * curve_.unit() < tolerance;
    if (!fine) s = a - fa * (b - a) / (fb - fa);
  }
  return out;
}

}  // namespace dynamy
