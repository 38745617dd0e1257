// Features of a shape, from its geometry in its own axes, and its sections in planes of motion.
#include <algorithm>
#include <cmath>
#include <dynamy/system/shape_pair.hpp>
#include <dynamy/system/smooth_shape.hpp>
#include <dynamy_elements/contacts/shapes/surface.hpp>
#include <dynamy_elements/contacts/shapes/touching_shape.hpp>
#include <limits>

namespace dynamy {
namespace {

using ShapeTouch = TouchingShape::Kind;

/// Fills the features of one shape, from its geometry in its own axes.
class Features {
 public:
  Features(TouchingShape& out, const Vec3& plane_B) : out_(out), shape_(*out.shape) {
    const double most = plane_B.cwiseAbs().maxCoeff(&along_);
    // The normal counts as along an axis of the shape up to the rounding of an orientation.
    inSpace_ = plane_B.isZero(0.0);
    if (most < 1.0 - 1e-12) along_ = -1;
  }
  bool inSpace() const { return inSpace_; }
  /// Axis of the shape along the normal of the plane of motion, −1: none.
  int along() const { return along_; }
  bool inPlaneAcross(int axis) const { return along_ >= 0 && along_ != axis; }

  void ball(const Vec3& c_B, double radius, std::string name = {}) {
    SupportFeature f;
    f.c_K = shape_.r_SB_K() + shape_.A_KB() * c_B, f.radius = radius, f.name = std::move(name);
    out_.features.push_back(std::move(f));
  }
  /// Circle about the z axis at the height z, with four of its points that touch when it lies flat.
  void rim(double z, double rho, double tube, const std::string& name) {
    const Vec3 axis_K = shape_.A_KB().col(2);
    SupportFeature f;
    f.kind = SupportFeature::Kind::rim;
    f.c_K = shape_.r_SB_K() + z * axis_K, f.radius = tube, f.axis_K = axis_K, f.rho = rho;
    f.name = name;
    out_.features.push_back(f);
    for (int i = 0; i < 4; ++i) {
      const double side = i < 2 ? rho : -rho;
      ball(i % 2 == 0 ? Vec3(side, 0.0, z) : Vec3(0.0, side, z), tube,
           name + ".point" + std::to_string(i));
      SupportFeature& point = out_.features.back();
      point.flatOnly = true, point.axis_K = axis_K, point.rho = rho;
    }
  }
  /// Corners of the section with the plane of motion, for `points` in the shape's
  /// axes. Points with a coordinate above zero along the plane's normal are left out,
  /// the others moved into the plane.
  void corners(const std::vector<Vec3>& points) {
    for (Vec3 point : points) {
      if (along_ >= 0 && point[along_] > 0.0) continue;
      if (along_ >= 0) point[along_] = 0.0;
      ball(point, 0.0, "corner" + std::to_string(out_.features.size()));
    }
  }

 private:
  TouchingShape& out_;
  const Shape& shape_;
  int along_ = -1;
  bool inSpace_ = true;
};

void sphere(Features& f, double radius, TouchingShape& out) {
  out.kind = ShapeTouch::ball;
  out.thickness = radius > 0.0 ? radius : std::numeric_limits<double>::infinity();
  f.ball(Vec3::Zero(), radius);
}

void capsule(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  const double R = g.size[0], half = 0.5 * g.size[1];
  if (!f.inSpace() && f.along() < 0) return;
  out.thickness = R;
  if (f.along() == 2) {
    out.kind = ShapeTouch::ball, out.bound = R;
    f.ball(Vec3::Zero(), R);
    return;
  }
  out.kind = ShapeTouch::capsule, out.half = {R, R, half};
  f.ball({0.0, 0.0, -half}, R, "end0"), f.ball({0.0, 0.0, half}, R, "end1");
}

void cylinder(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  const double R = g.size[0], half = 0.5 * g.size[1];
  if (!f.inSpace() && f.along() < 0) return;
  if (f.along() == 2) {
    out.kind = ShapeTouch::ball, out.bound = out.thickness = R;
    f.ball(Vec3::Zero(), R);
    return;
  }
  out.kind = ShapeTouch::other, out.thickness = std::min(R, half);
  if (f.inSpace()) {
    out.kind = ShapeTouch::cylinder, out.half = {R, R, half};
    f.rim(-half, R, 0.0, "rim0"), f.rim(half, R, 0.0, "rim1");
    return;
  }
  out.kind = ShapeTouch::section;
  const int across = 1 - f.along();  // x or y
  for (int i = 0; i < 4; ++i) {
    Vec3 corner(0.0, 0.0, i & 2 ? half : -half);
    corner[across] = i & 1 ? R : -R;
    f.ball(corner, 0.0, "corner" + std::to_string(i));
  }
}

void cone(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  const double R = g.size[0], length = g.size[1];
  if (!f.inSpace() && f.along() < 0) return;
  if (f.along() == 2) {
    out.kind = ShapeTouch::ball, out.bound = out.thickness = R;
    f.ball(Vec3::Zero(), R);
    return;
  }
  out.kind = ShapeTouch::cone, out.half = {R, R, 0.5 * length};
  out.thickness = 0.5 * R * length / std::hypot(R, length);
  if (f.inSpace()) {
    f.rim(0.0, R, 0.0, "rim");
  } else {
    out.kind = ShapeTouch::section;
    const int across = 1 - f.along();
    f.ball(-R * Vec3::Unit(across), 0.0, "corner0"), f.ball(R * Vec3::Unit(across), 0.0, "corner1");
  }
  f.ball({0.0, 0.0, length}, 0.0, "tip");
}

void torus(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  const double R = g.size[0], tube = g.size[1];
  if (!f.inSpace() && f.along() < 0) return;
  out.thickness = tube;
  if (f.along() == 2) {
    out.kind = ShapeTouch::ball;
    f.ball(Vec3::Zero(), R + tube);
    return;
  }
  out.kind = ShapeTouch::other;
  if (f.inSpace()) {
    out.kind = ShapeTouch::torus;
    f.rim(0.0, R, tube, "rim");
    return;
  }
  const int across = 1 - f.along();
  f.ball(-R * Vec3::Unit(across), tube, "tube0"), f.ball(R * Vec3::Unit(across), tube, "tube1");
}

void ellipsoid(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  if (!f.inSpace() && f.along() < 0) return;
  const Vec3 semi(g.size[0], g.size[1], g.size[2]);
  const Mat3& A = out.shape->A_KB();
  out.kind = ShapeTouch::smooth, out.thickness = semi.minCoeff();
  f.ball(Vec3::Zero(), 0.0);
  SupportFeature& feature = out.features.back();
  feature.kind = SupportFeature::Kind::ellipsoid;
  feature.square_K = A * semi.cwiseAbs2().asDiagonal() * A.transpose();
}

/// A smooth shape has no features in a plane of motion: its section
/// would be needed, not its shadow.
void addSmooth(Features& f, const SmoothShape& shape, TouchingShape& out) {
  const SmoothShape::Extent extent = shape.extent();
  out.bound = extent.bound, out.thickness = extent.halfWidth;
  if (!f.inSpace()) return;
  shape.requireConsistent();
  out.kind = ShapeTouch::smooth;
  f.ball(Vec3::Zero(), 0.0);
  SupportFeature& feature = out.features.back();
  feature.kind = SupportFeature::Kind::smooth;
  feature.square_K = shape.A_KB(), feature.smooth = &shape;
}

/// Half of the least width of a convex body across one of its faces. It may be less where edges
/// face each other, but never less than the radius of the largest ball inside.
double halfWidth(const ShapeGeometry& g) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 2 < g.points.size(); i += 3) {
    const auto at = [&](std::size_t k) { return g.points[i + k]; };
    const Vec3 n = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    double deepest = 0.0;
    for (const Vec3& p : g.points) deepest = std::max(deepest, n.dot(at(0) - p));
    least = std::min(least, 0.5 * deepest);
  }
  return least;
}

void surface(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  if (!f.inSpace()) return;
  out.kind = ShapeTouch::surface, out.thickness = std::numeric_limits<double>::infinity();
  if (g.type != ShapeType::polyhedron) return;
  out.kind = ShapeTouch::polyhedron;
  out.thickness = halfWidth(g);
  f.corners(Surface(g.points, true).points());
}

void contour(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  out.thickness = std::numeric_limits<double>::infinity();
  for (const Vec3& p : g.points) out.thickness = std::min(out.thickness, p.norm());
  if (f.along() != 2) return;
  out.kind = ShapeTouch::contour;
  f.ball(Vec3::Zero(), 0.0);
  out.features.back().kind = SupportFeature::Kind::contour;
  out.features.back().square_K = out.shape->A_KB();
}

/// A line of two points, which touches as a capsule without a radius.
void line(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  if (g.points.size() != 2 || (!f.inSpace() && f.along() < 0)) return;
  const Vec3 way = g.points[1] - g.points[0];
  const double half = 0.5 * way.norm();
  if (!(half > 0.0) || (!f.inSpace() && std::abs(way[f.along()]) > 1e-12 * half)) return;
  out.kind = ShapeTouch::capsule, out.bound = half, out.half = {0.0, 0.0, half};
  f.ball(g.points[0], 0.0, "end0"), f.ball(g.points[1], 0.0, "end1");
  const Mat3 turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), way).toRotationMatrix();
  out.p_K += out.A_KB * (0.5 * (g.points[0] + g.points[1])), out.A_KB = out.A_KB * turn;
}

/// A polygon that lies in the plane of motion.
void polygon(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  out.thickness = std::numeric_limits<double>::infinity();
  if (f.along() < 0) return;
  const auto outside = [&](const Vec3& p) {
    return std::abs((p - g.points[0])[f.along()]) > 1e-12 * out.bound;
  };
  if (std::any_of(g.points.begin(), g.points.end(), outside)) return;
  out.kind = ShapeTouch::polygon;
  for (std::size_t i = 0; i < g.points.size(); ++i)
    f.ball(g.points[i], 0.0, "corner" + std::to_string(i));
}

void circle(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  out.thickness = g.size[0];
  if (f.along() == 2) out.kind = ShapeTouch::ball, f.ball(Vec3::Zero(), g.size[0]);
}

void box(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  out.kind = ShapeTouch::box;
  f.corners(g.points);
  out.half = 0.5 * Vec3(g.size[0], g.size[1], g.size[2]);
  out.thickness = out.half.minCoeff();
}

void halfSpace(const ShapeGeometry& g, TouchingShape& out) {
  out.kind = ShapeTouch::halfSpace;
  out.n_K = out.A_KB * g.points[0];
  out.thickness = std::numeric_limits<double>::infinity();
}

/// In a plane across its axis a bore is a circle; in space it needs a length.
void bore(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  const double R = g.size[0], half = 0.5 * g.size[1];
  if (!f.inSpace()) out.bound = R;
  out.half = {R, R, half};
  out.thickness = std::numeric_limits<double>::infinity();
  if (f.inSpace() ? half > 0.0 : f.along() == 2) out.kind = ShapeTouch::bore;
}

void addFeatures(Features& f, const ShapeGeometry& g, TouchingShape& out) {
  switch (g.type) {
    case ShapeType::sphere:
    case ShapeType::point:
      sphere(f, g.type == ShapeType::sphere ? g.size[0] : 0.0, out);
      break;
    case ShapeType::circle:
      circle(f, g, out);
      break;
    case ShapeType::box:
      box(f, g, out);
      break;
    case ShapeType::halfSpace:
      halfSpace(g, out);
      break;
    case ShapeType::capsule:
      capsule(f, g, out);
      break;
    case ShapeType::cylinder:
      cylinder(f, g, out);
      break;
    case ShapeType::cone:
      cone(f, g, out);
      break;
    case ShapeType::torus:
      torus(f, g, out);
      break;
    case ShapeType::polyhedron:
    case ShapeType::mesh:
      surface(f, g, out);
      break;
    case ShapeType::ellipsoid:
      ellipsoid(f, g, out);
      break;
    case ShapeType::contour:
      contour(f, g, out);
      break;
    case ShapeType::line:
      line(f, g, out);
      break;
    case ShapeType::polygon:
      polygon(f, g, out);
      break;
    case ShapeType::bore:
      bore(f, g, out);
      break;
  }
}

/// A shape whose plug-in computes its contacts, in space.
void own(Features& f, const Shape& shape, const OwnContact& given, TouchingShape& out) {
  if (!(given.bound > 0.0 && std::isfinite(given.bound) && given.thickness >= 0.0))
    throw ModelError(Diagnostic{
        .place = shape.place(),
        .element = shape.type() + (shape.name().empty() ? "" : " name=\"" + shape.name() + "\""),
        .text = "ownContact() gives the bound " + numberText(given.bound) +
                " m and the thickness " + numberText(given.thickness) + " m",
        .hint = "contact needs a finite bound above 0 and a thickness of at least 0"});
  out.bound = given.bound, out.thickness = given.thickness;
  if (f.inSpace()) out.kind = ShapeTouch::own, out.family = given.family;
}

/// Orders the corners of a section about the normal, by their angles.
void orderCorners(TouchingShape& out, const Vec3& plane_K) {
  Vec3 middle = Vec3::Zero();
  for (const SupportFeature& f : out.features) {
    if (f.kind != SupportFeature::Kind::ball || f.radius > 0.0) return;
    middle += f.c_K / static_cast<double>(out.features.size());
  }
  std::vector<Vec3>& corners = out.polygon_K;
  for (const SupportFeature& f : out.features) corners.push_back(f.c_K);
  const Vec3 x = plane_K.unitOrthogonal(), y = plane_K.cross(x);
  const auto angle = [&](const Vec3& p) {
    return std::atan2(y.dot(p - middle), x.dot(p - middle));
  };
  // The corners of a polygon may be given in either sense.
  const auto at = [&](std::size_t i) { return corners[i % corners.size()]; };
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += plane_K.dot((at(i) - middle).cross(at(i + 1) - middle));
  if (out.kind != ShapeTouch::polygon) {
    std::sort(corners.begin(), corners.end(),
              [&](const Vec3& a, const Vec3& b) { return angle(a) < angle(b); });
  } else if (area < 0.0) {
    std::reverse(corners.begin(), corners.end());
  }
  double halfWidth = std::numeric_limits<double>::infinity();
  bool convex = corners.size() > 2;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 n = (at(i + 1) - at(i)).cross(plane_K).normalized();
    double lowest = 0.0;
    for (const Vec3& p : corners) {
      convex = convex && n.dot(p - at(i)) < 1e-12 * out.bound;
      lowest = std::min(lowest, n.dot(p - at(i)));
    }
    halfWidth = std::min(halfWidth, -0.5 * lowest);
  }
  if (!convex) corners.clear();
  if (out.kind == ShapeTouch::polygon) out.thickness = halfWidth;
}

}  // namespace

TouchingShape touchingShape(const ShapeInstance& instance, const Vec3& plane_K) {
  const Shape& shape = *instance.shape;
  const ShapeGeometry g = shape.geometry();
  TouchingShape out;
  out.shape = instance.shape, out.frame = instance.frame, out.system = instance.system;
  out.p_K = shape.r_SB_K(), out.A_KB = shape.A_KB(), out.grain_K = out.A_KB * shape.grain_B();
  Features f(out, shape.A_KB().transpose() * plane_K);
  if (const SmoothShape* given = shape.smooth()) {
    addSmooth(f, *given, out);
    return out;
  }
  if (const OwnContact given = shape.ownContact(); given.family) {
    own(f, shape, given, out);
    return out;
  }
  // Near shapes are found by it, also in space where a line or a polygon does not touch.
  out.bound = boundOf(g);
  addFeatures(f, g, out);
  const bool section = out.kind == ShapeTouch::polygon || out.kind == ShapeTouch::section ||
                       out.kind == ShapeTouch::box;
  if (section && !f.inSpace() && f.along() >= 0) orderCorners(out, plane_K);
  return out;
}

}  // namespace dynamy
