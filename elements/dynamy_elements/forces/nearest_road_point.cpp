#include <algorithm>
#include <cmath>
#include <dynamy_elements/forces/nearest_road_point.hpp>
#include <optional>
#include <utility>

namespace dynamy {
namespace {

/// Cosine of the camber below which the wheel lies on its side and has no contact.
constexpr double kOnItsSide = 1e-6;
/// Places along the wheel at which the road is looked at, on each side of its middle.
constexpr int kPlaces = 9;
/// Steps between two of them, and their end, over the radius.
constexpr int kMostHalvings = 60;
constexpr double kBracketed = 1e-6;
/// Newton steps from there, and the distance along the road to which the point is found, over the
/// radius: the slope there, and so the force, is off by as much.
constexpr int kMostSteps = 20;
constexpr double kFound = 1e-13;
/// Distance for differences of slopes, over the radius; they lead the search and leave no trace.
constexpr double kBeside = 1e-6;

}  // namespace

NearestRoadPoint::NearestRoadPoint(const Vec3& centre, const Vec3& axle, double circle, double tube,
                                   std::function<Height(double, double)> height)
    : centre_(centre),
      axle_(axle),
      circle_(circle),
      tube_(tube),
      radius_(circle + tube),
      height_(std::move(height)),
      middle_(centre.head<2>()) {
  const Eigen::Vector2d across(axle.y(), -axle.x());
  heading_ =
      across.norm() > kOnItsSide ? Eigen::Vector2d(across.normalized()) : Eigen::Vector2d(1.0, 0.0);
}

Vec3 NearestRoadPoint::crown(const Vec3& axle, double circle, const Vec3& n) {
  const double sine = axle.dot(n);
  const double cosine = (axle - sine * n).norm();
  if (cosine < kOnItsSide) return Vec3::Zero();
  return -circle / cosine * (n - sine * axle);
}

NearestRoadPoint::Residual NearestRoadPoint::residual(const Eigen::Vector2d& xy) const {
  const Height h = height_(xy[0], xy[1]);
  Residual out;
  out.at.n = Vec3(-h.zx, -h.zy, 1.0).normalized(), out.at.r = Vec3(xy[0], xy[1], h.z);
  const Vec3 way = centre_ + crown(axle_, circle_, out.at.n) - out.at.r;
  out.f = {way.x() + h.zx * way.z(), way.y() + h.zy * way.z()};
  out.at.gap = out.at.n.dot(way) - tube_;
  return out;
}

/// The root between two places by the Illinois method.
NearestRoadPoint::Residual NearestRoadPoint::between(double low, double high) const {
  double fLow = slope(low), fHigh = slope(high);
  for (int i = 0; i < kMostHalvings && high - low > kBracketed * radius_; ++i) {
    // Where the slope jumps, as at an edge, the secant creeps: every third step halves.
    const double secant = (low * fHigh - high * fLow) / (fHigh - fLow),
                 s = i % 3 == 2 || !(secant > low && secant < high) ? 0.5 * (low + high) : secant,
                 f = slope(s);
    if (f == 0.0) return residual(along(s));
    if (f > 0.0)
      low = s, fLow = f, fHigh *= 0.5;
    else
      high = s, fHigh = f, fLow *= 0.5;
  }
  return residual(along(0.5 * (low + high)));
}

/// Newton's method in both directions of the road. False: it leads away from where it begins.
bool NearestRoadPoint::polish(Residual& r) const {
  const Eigen::Vector2d from = r.at.r.head<2>();
  Eigen::Vector2d at = from;
  for (int i = 0; i < kMostSteps; ++i) {
    r = residual(at);
    if (!(r.f.cwiseAbs().maxCoeff() > kFound * radius_)) return (at - from).norm() < radius_;
    Eigen::Matrix2d J;
    for (int j = 0; j < 2; ++j)
      J.col(j) = (residual(at + kBeside * radius_ * Eigen::Vector2d::Unit(j)).f - r.f) /
                 (kBeside * radius_);
    const Eigen::Vector2d step = J.fullPivLu().solve(r.f);
    at -= step * std::min(1.0, radius_ / std::max(step.norm(), kFound));
  }
  r = residual(at);
  constexpr double kAlmost = 1e-9;  // rounding of steep roads
  return r.f.cwiseAbs().maxCoeff() <= kAlmost * radius_ && (at - from).norm() < radius_;
}

/// No place of the road touches the wheel: the nearest of some, at its distance.
NearestRoadPoint::Point NearestRoadPoint::nearestSample() const {
  Point out;
  double least = std::numeric_limits<double>::infinity();
  for (int k = -kPlaces; k <= kPlaces; ++k) {
    const Point p = residual(along(radius_ * k / (kPlaces - 1))).at;
    const Vec3 way = centre_ - p.r, flat = way - way.dot(axle_) * axle_;
    const Vec3 rim = centre_ - circle_ / std::max(flat.norm(), kOnItsSide * radius_) * flat;
    const double distance = (rim - p.r).norm();
    if (!(distance < least)) continue;
    least = distance;
    out = {distance > 0.0 ? Vec3((rim - p.r) / distance) : p.n, p.r, distance - tube_};
  }
  return out;
}

NearestRoadPoint::Point NearestRoadPoint::find() const {
  std::optional<Point> deepest;
  const double step = radius_ / (kPlaces - 1);
  double before = slope(-kPlaces * step);
  for (int k = 1 - kPlaces; k <= kPlaces; ++k) {
    const double f = slope(k * step);
    if (before > 0.0 && f <= 0.0) {
      Residual found = between((k - 1) * step, k * step);
      const Point onLine = found.at;
      if (!polish(found)) found.at = onLine;
      if (!deepest || found.at.gap < deepest->gap) deepest = found.at;
    }
    before = f;
  }
  return deepest ? *deepest : nearestSample();
}

}  // namespace dynamy
