#include <algorithm>
#include <cmath>
#include <dynamy/core/constants.hpp>
#include <dynamy_elements/forces/rope_way.hpp>

namespace dynamy {
namespace {

constexpr double kNoWrap = 1e-9;  ///< an angle of wrap below is zero [rad]

/// How well the rope passes the circles at the sides that are wanted: each adds its direction along
/// the side; one that lies on that side adds less the longer its arc is.
double score(const RopeWay& way, const std::vector<RopeCircle>& circles,
             const std::vector<Vec3>& sides) {
  const int last = static_cast<int>(circles.size()) - 1;
  double sum = 0.0;
  for (int i = 0; i <= last; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!(circles[k].radius > 0.0)) continue;
    if (i == 0 || i == last) {
      sum += way.contact(i, i == 0 ? 0 : last - 1).dot(sides[k]);
      continue;
    }
    const double theta = way.wrap(i), half = 0.5 * circles[k].sense * theta;
    const Vec3 n = way.contact(i, i - 1);
    const double along = (std::cos(half) * n + std::sin(half) * way.axis().cross(n)).dot(sides[k]);
    sum += along > 0.0 ? 2.0 - theta / kTwoPi : along;
  }
  return sum;
}

}  // namespace

RopeWay::RopeWay(const Vec3& axis_I, std::span<const RopeCircle> circles)
    : axis_I_(axis_I), count_(static_cast<int>(circles.size())) {
  std::copy(circles.begin(), circles.end(), circles_.begin());
  for (std::size_t i = 0; i + 1 < circles.size(); ++i) {
    const RopeCircle &from = circles_[i], &to = circles_[i + 1];
    RopeStrand s;
    s.e = to.centre_I - from.centre_I;
    s.aside = axis_I_.dot(s.e);
    s.rho = to.sense * to.radius - from.sense * from.radius;
    const Vec3 d = s.e - s.aside * axis_I_;
    s.inPlane = std::sqrt(std::max(d.squaredNorm() - s.rho * s.rho, 0.0));
    const Vec3 along = s.inPlane * d - s.rho * axis_I_.cross(d);
    s.t = along.norm() > 0.0 ? Vec3(along.normalized()) : Vec3(axis_I_.unitOrthogonal());
    s.across = axis_I_.cross(s.t);
    // Between two points the axis means nothing.
    const bool round = from.radius > 0.0 || to.radius > 0.0;
    s.length = round && !(s.inPlane > 0.0) ? 0.0 : std::hypot(s.inPlane, s.aside);
    s.v = s.length > 0.0 ? Vec3((s.inPlane * s.t + s.aside * axis_I_) / s.length) : s.t;
    strands_[i] = s;
  }
}

Vec3 RopeWay::contact(int i, int j) const {
  return -circles_[static_cast<std::size_t>(i)].sense * strand(j).across;
}

double RopeWay::wrap(int i) const {
  const Vec3 &in = strand(i - 1).t, &out = strand(i).t;
  const double sense = circles_[static_cast<std::size_t>(i)].sense;
  const double theta = std::atan2(sense * axis_I_.dot(in.cross(out)), in.dot(out));
  return theta < -kNoWrap ? theta + kTwoPi : theta;
}

void chooseSenses(const Vec3& axis_I, std::vector<RopeCircle>& circles,
                  const std::vector<Vec3>& sides) {
  std::vector<std::size_t> round;
  for (std::size_t i = 0; i < circles.size(); ++i)
    if (circles[i].radius > 0.0) round.push_back(i);
  std::vector<RopeCircle> best = circles;
  double most = -1e9;
  for (unsigned choice = 0; choice < (1U << round.size()); ++choice) {
    for (std::size_t k = 0; k < round.size(); ++k)
      circles[round[k]].sense = (choice >> k & 1U) != 0U ? -1.0 : 1.0;
    const double value = score(RopeWay(axis_I, circles), circles, sides);
    if (value > most) most = value, best = circles;
  }
  circles = best;
}

}  // namespace dynamy
