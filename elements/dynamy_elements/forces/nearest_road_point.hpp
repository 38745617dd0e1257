/// NearestRoadPoint: the point r of a road z = h(x, y) at which a wheel touches it, or comes nearest to
/// it (theory 41.4):
///
///   (r_c − r)·(1, 0, h_x) = 0,   (r_c − r)·(0, 1, h_y) = 0,   r_c = c − R_c (n − (n·a) a)/|n − (n·a) a|
///
/// c, a: centre and axle of the wheel, R_c the radius of its circle, n the normal of the road in r. All
/// solutions at which the distance is least are looked for: below the wheel the first of these equations,
/// along the wheel, changes its sign there from + to −. Of several the deepest is taken. An edge may be
/// as sharp as it likes; a bump narrower than an eighth of the radius may be passed over.
#pragma once
#include <dynamy/core/types.hpp>
#include <functional>

namespace dynamy {

class NearestRoadPoint {
 public:
  struct Height {
    double z = 0.0, zx = 0.0, zy = 0.0;  ///< h and its slopes
  };
  struct Point {
    Vec3 n, r;         ///< normal of the road, upwards, and the point
    double gap = 0.0;  ///< n·(r_c − r) − tube [m]
  };
  /// `height`: at (x, y). All in axes of the road. `circle`: R_c; `tube`: what stands out around it.
  NearestRoadPoint(const Vec3& centre, const Vec3& axle, double circle, double tube,
                   std::function<Height(double, double)> height);
  Point find() const;
  /// From the centre of the wheel to the point of its circle that is lowest along n; zero: it lies on
  /// its side.
  static Vec3 crown(const Vec3& axle, double circle, const Vec3& n);

 private:
  struct Residual {
    Eigen::Vector2d f;
    Point at;
  };
  Residual residual(const Eigen::Vector2d& xy) const;
  Eigen::Vector2d along(double s) const { return middle_ + s * heading_; }
  double slope(double s) const { return heading_.dot(residual(along(s)).f); }
  Residual between(double low, double high) const;
  bool polish(Residual& r) const;
  Point nearestSample() const;

  Vec3 centre_, axle_;
  double circle_, tube_, radius_;
  std::function<Height(double, double)> height_;
  Eigen::Vector2d middle_, heading_;
};

}  // namespace dynamy
