// BranchTracer where the switches of the motion change, or where no orbit is found.
#include <algorithm>
#include <cmath>
#include <dynamy/simulation/orbit/branch_tracer.hpp>
#include <utility>

namespace dynamy {
namespace {

using Eigen::VectorXd;

constexpr double kChangeLocated = 1e-10;  ///< width of the interval that holds a change, of |p|
constexpr std::size_t kGoodNodes = 3;     ///< predict so well that their motion has the switches
/// How far from a change an orbit with other switches is sought, in units of the longest step.
constexpr double kBeyond[] = {1.0 / 256.0, 1.0 / 64.0, 1.0 / 16.0};
/// An interval that shrinks towards a place within it is no change: the curve goes on from there.
constexpr double kProgress = 0.01;
constexpr double kKink = 0.3;  ///< change of DP, of its size
constexpr double kFar = 2.0;   ///< reach of this search, in units of that

/// The derivatives of two orbits with the same events differ: an impact slips or sticks otherwise.
bool isKink(const OrbitPoint& a, const OrbitPoint& b) {
  return (a.P - b.P).norm() > kKink * std::max(1.0, b.P.norm());
}

}  // namespace

/// Finds the place between the base and `reached` up to which the orbit has its switches, and goes
/// on from there if there is an orbit with others. False: the branch ends.
bool BranchTracer::change(double reached) {
  const double width =
      kChangeLocated * std::max(std::abs(curve_.low()), std::abs(curve_.high())) / curve_.unit();
  double low = 0.0, high = reached;
  OrbitPoint lower = base_, next;
  std::vector<Node> nodes{{0.0, VectorXd::Zero(tangent_.size())}};
  std::string why;
  const auto guess = [&](double s) -> VectorXd {
    if (nodes.size() < kGoodNodes) return predicted(s);
    return through(std::vector<Node>(nodes.end() - kGoodNodes, nodes.end()), s);
  };
  while (high - low > width) {
    const double s = 0.5 * (low + high);
    const VectorXd at = guess(s);
    const bool known = nodes.size() >= kGoodNodes && curve_.probe(base_, at, next) &&
                       !sameEvents(next.events, base_.events);
    const Tried tried = known ? Tried::changed : attempt(at, 1, next);
    if (tried == Tried::good) {
      low = s, lower = std::move(next), next = OrbitPoint();
      nodes.push_back({s, curve_.between(lower, base_)});
      continue;
    }
    high = s;
    why = tried == Tried::failed ? curve_.why() : "";
  }
  OrbitPoint beyond;
  std::vector<OrbitEvent> others;
  if (curve_.probe(base_, guess(high), beyond)) others = beyond.events;
  if (lower.P.size() == 0) try {
      curve_.derive(lower);
    } catch (const ModelError&) {
      lower.P = base_.P, lower.byParameter = base_.byParameter;  // from the last point before
    }
  const VectorXd y = curve_.between(lower, base_);
  const bool crossed = cross(lower, low, beyond);
  if (crossed) others = beyond.events;
  out_.push_back(result(lower));
  const bool changes = !others.empty() && !sameEvents(others, lower.events);
  if (changes) {
    const EventChange c = changeOf(curve_.model(lower.p), lower.events, others);
    out_.back().kind = c.kind, out_.back().text = c.text;
  }
  const bool kink = !changes && (crossed || isKink(lower, base_));
  if (kink)
    out_.back().kind = "kink",
    out_.back().text = "right before, an impact begins to slip or to stick otherwise";
  if (crossed) {
    const VectorXd along = curve_.between(beyond, lower);
    curve_.multipliers(beyond, true);
    out_.push_back(result(beyond));
    restart(std::move(beyond), along);
    return true;
  }
  if (!changes && low > kProgress * reached) {
    restart(std::move(lower), y);
    return true;
  }
  end(changes ? "no orbit is found beyond" : why);
  base_ = std::move(lower);
  return false;
}

/// Goes on from a point, without those before, which are on another part of the curve.
void BranchTracer::restart(OrbitPoint point, const VectorXd& along) {
  base_ = std::move(point);
  multipliers_ = out_.back().multipliers;
  old_.clear();
  tangent_ = curve_.tangent(base_, along);
}

/// Looks for an orbit with other switches, or another derivative, near the last one, on the curve of
/// such orbits: it goes on beyond s, or turns back there.
bool BranchTracer::cross(const OrbitPoint& lower, double s, OrbitPoint& out) {
  const VectorXd y = curve_.between(lower, base_);
  const auto differs = [&](const OrbitPoint& other) {
    return !sameEvents(other.events, lower.events) || isKink(other, lower);
  };
  for (const double part : kBeyond) try {
      const double ds = part * longest_;
      OrbitPoint there;
      if (!curve_.probe(base_, predicted(s + ds), there)) continue;
      curve_.derive(there);
      if (!differs(there)) continue;
      const VectorXd tangent = curve_.tangent(there, tangent_);
      for (const double sign : {1.0, -1.0}) {
        if (!curve_.solve(base_, y + sign * ds * tangent, tangent,
                          {.reach = kFar * ds, .fresh = true}, out))
          continue;
        // With the same events it has to be beyond: back there is the branch itself.
        if (sameEvents(out.events, lower.events) &&
            !(curve_.between(out, lower).dot(tangent_) > 0.0))
          continue;
        curve_.derive(out);
        if (differs(out)) return true;
      }
    } catch (const ModelError&) {
      continue;
    }
  return false;
}

}  // namespace dynamy
