#include <algorithm>
#include <cmath>
#include <dynamy_elements/bodies/grain_exchange.hpp>
#include <limits>

namespace dynamy {
namespace {

/// Most places that are tried for one grain.
constexpr int kTries = 20;
/// Part of a step's length by which rounding may move an instant that still belongs to the step.
constexpr double kRounding = 1e-9;
constexpr double kPassed = 1e-13;  ///< part of the time within which a grain counts as fed

bool inside(const Region& box, const Vec3& c) {
  return (c.array() >= box.low.array()).all() && (c.array() <= box.high.array()).all();
}

Region region(const Parameters& x, const char* name) {
  const Eigen::VectorXd v = x[name].vector();
  Region box{v.head<3>(), v.tail<3>()};
  if ((box.low.array() > box.high.array()).any())
    throw x[name].fault("a lowest coordinate is above the highest", "lowest x y z, highest x y z",
                        0, x[name].text.size());
  return box;
}

}  // namespace

void GrainExchange::declare(Attributes& a) {
  a.optional("feed", Unit::frequency, 0.0, "how many grains come in a second, while any are absent")
      .nonNegative();
  a.vector("feedWithin", Unit::length, 6, "0 0 0 0 0 0",
           "box in which their centres appear: lowest x y z, highest x y z");
  a.add(AttributeType::integer, "present", "-1",
        "how many are there at the start, the lowest numbers; -1: all")
      .min = -1;
  a.vector("takeWithin", Unit::length, 6, "0 0 0 0 0 0",
           "box in which grains are taken away; the feeder brings them again; zeros: none");
}

GrainExchange::GrainExchange(const Parameters& x, std::vector<double> grain)
    : radius_(std::move(grain)),
      present_(x["present"].integer()),
      rate_(x["feed"]),
      feeder_(region(x, "feedWithin")),
      turned_(x["turned"].flag()),
      seed_(static_cast<std::uint64_t>(x["seed"].integer())),
      velocity_(x["velocity"].vec3()) {
  const int all = static_cast<int>(radius_.size());
  if (present_ < 0) present_ = all;
  if (present_ > all)
    throw x["present"].fault("more grains than there are", "at most the count", 0,
                             x["present"].text.size());
  if (!x["takeWithin"].vector().isZero(0.0)) sink_ = region(x, "takeWithin");
}

void GrainExchange::remove(double* q, double* u) const {
  const Vec3 rest = 0.5 * (feeder_.low + feeder_.high);
  std::copy(rest.data(), rest.data() + 3, q);
  std::fill_n(q + 3, 4, 0.0);
  std::fill_n(u, 6, 0.0);
}

bool GrainExchange::isFree(const Vec3& c, double radius, ConstVec q) const {
  for (std::size_t i = 0; i < radius_.size(); ++i) {
    const double* at = q.data() + 7 * i;
    if (absent(at)) continue;
    if ((Eigen::Map<const Vec3>(at) - c).squaredNorm() < std::pow(radius + radius_[i], 2))
      return false;
  }
  return true;
}

void GrainExchange::feed(std::uint64_t number, Vec q, Vec u, bool& changed) const {
  std::size_t i = 0;
  while (i < radius_.size() && !absent(q.data() + 7 * i)) ++i;
  if (i == radius_.size()) return;
  SeededNumbers numbers((seed_ + 1) * 0x9E3779B97F4A7C15u + number);
  for (int trial = 0; trial < kTries; ++trial) {
    Vec3 c;
    for (int k = 0; k < 3; ++k) c[k] = numbers.uniform(feeder_.low[k], feeder_.high[k]);
    double p[4] = {1.0, 0.0, 0.0, 0.0};
    if (turned_) numbers.attitude(p);
    if (!isFree(c, radius_[i], {q.data(), q.size()})) continue;
    std::copy(c.data(), c.data() + 3, q.data() + 7 * i);
    std::copy(p, p + 4, q.data() + 7 * i + 3);
    std::copy(velocity_.data(), velocity_.data() + 3, u.data() + 6 * i);
    changed = true;
    return;
  }
}

double GrainExchange::nextFeed(double t) const {
  if (!(rate_ > 0.0)) return std::numeric_limits<double>::infinity();
  return (std::floor(rate_ * t * (1.0 + kPassed)) + 1.0) / rate_;
}

bool GrainExchange::mayFeed(ConstVec q) const {
  if (sink_ || q.size() == 0) return true;
  std::size_t i = 0;
  while (i < radius_.size() && !absent(q.data() + 7 * i)) ++i;
  return i < radius_.size();
}

bool GrainExchange::renew(double tA, double tE, Vec q, Vec u) const {
  bool changed = false;
  for (std::size_t i = 0; sink_ && i < radius_.size(); ++i) {
    double* at = q.data() + 7 * i;
    if (absent(at) || !inside(*sink_, Eigen::Map<const Vec3>(at))) continue;
    remove(at, u.data() + 6 * i);
    changed = true;
  }
  const double early = kRounding * (tE - tA);
  const auto due = [&](double t) { return static_cast<std::int64_t>(rate_ * (t + early)); };
  for (std::int64_t k = due(tA); k < due(tE); ++k)
    feed(static_cast<std::uint64_t>(k), q, u, changed);
  return changed;
}

}  // namespace dynamy
