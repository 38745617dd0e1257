#include <cmath>
#include <dynamy/system/smooth_shape.hpp>
#include <dynamy_elements/contacts/shapes/contour.hpp>
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>

namespace dynamy {
namespace {

/// Sine of the tilt of a circle below which points of it that are fixed in the body touch as well.
constexpr double kFlat = 0.1;
/// Sine of the tilt below which a circle has no lowest point: its
/// direction is known to 1e-16/1e-12 rad.
constexpr double kLevelFace = 1e-12;

/// d without its part along the axis a.
Vec3 across(const Vec3& d, const Vec3& a) { return d - a.dot(d) * a; }

Contour::Vec2 inPlane(const SupportFeature& f, const Vec3& d) {
  return (f.square_K.transpose() * d).head<2>();
}

}  // namespace

double SupportFeature::support(const Vec3& d) const {
  if (kind == Kind::contour || kind == Kind::smooth) return d.dot(point(d));
  const double centre = d.dot(c_K);
  if (kind == Kind::rim) return centre + rho * across(d, axis_K).norm() + radius;
  if (kind == Kind::ellipsoid) return centre + std::sqrt(d.dot(square_K * d));
  return centre + radius;
}

Vec3 SupportFeature::point(const Vec3& d) const {
  if (kind == Kind::contour)
    return c_K + square_K.leftCols<2>() * contour->furthest(inPlane(*this, d)).x;
  if (kind == Kind::rim) return c_K + rho * unitAcross(d, axis_K) + radius * d;
  if (kind == Kind::ellipsoid) return c_K + square_K * d / std::sqrt(d.dot(square_K * d));
  if (kind == Kind::smooth) return c_K + square_K * smooth->point(square_K.transpose() * d);
  return c_K + radius * d;
}

Mat3 SupportFeature::pointDerivative(const Vec3& d) const {
  if (kind == Kind::contour) {
    const Contour::Point at = contour->furthest(inPlane(*this, d));
    const Vec3 t = square_K.leftCols<2>() * at.t;
    return t * t.transpose() / at.curvature;
  }
  if (kind == Kind::ellipsoid) {
    const Vec3 s = square_K * d;
    const double h2 = d.dot(s);
    return (square_K - s * s.transpose() / h2) / std::sqrt(h2);
  }
  if (kind == Kind::smooth)
    return square_K * smooth->pointDerivative(square_K.transpose() * d) * square_K.transpose();
  Mat3 H = radius * (Mat3::Identity() - d * d.transpose());
  if (kind == Kind::rim) {
    const Vec3 v = across(d, axis_K), e = unitAcross(v, axis_K);
    H += rho / v.norm() * (Mat3::Identity() - axis_K * axis_K.transpose() - e * e.transpose());
  }
  return H;
}

double SupportFeature::lift(const Vec3& d) const { return rho * across(d, axis_K).norm(); }

bool SupportFeature::touches(const Vec3& d) const {
  if (kind == Kind::rim) return across(d, axis_K).squaredNorm() > kLevelFace * kLevelFace;
  return !flatOnly || across(d, axis_K).squaredNorm() < kFlat * kFlat;
}

}  // namespace dynamy
