#include "picture.hpp"

#include <cmath>
#include <dynamy/core/rotation.hpp>
#include <numbers>

#include "motorbike.hpp"

namespace dynamy::motorbike {

/// A shape that takes its geometry from a kind that contacts and replay support.
class Picture::Body final : public Shape {
 public:
  static void declare(Attributes&) {}
  Body(const std::string& name, ShapeGeometry geometry, const std::string& colour,
       const std::string& material, const Vec3& at, const Eigen::Quaterniond& turn)
      : Shape(
            Parameters::of<Body>(shownAs(geometry.type), name, given(colour, material, at, turn))),
        geometry_(std::move(geometry)) {
    geometry_.colour = colour;
  }
  ShapeGeometry geometry() const override { return geometry_; }

 private:
  /// What messages call the shape: tyres alone make contact.
  static const char* shownAs(ShapeType type) {
    return type == ShapeType::torus ? "Torus" : type == ShapeType::sphere ? "Sphere" : "Body";
  }
  static std::vector<GivenValue> given(const std::string& colour, const std::string& material,
                                       const Vec3& at, const Eigen::Quaterniond& turn) {
    std::vector<GivenValue> out{{"colour", colour},
                                {"position", at},
                                {"orientation", {turn.w(), turn.x(), turn.y(), turn.z()}}};
    if (!material.empty()) out.emplace_back("material", material);
    return out;
  }
  ShapeGeometry geometry_;
};

namespace {

constexpr const char* kBlack = "#23272e";
const Eigen::Quaterniond kAboutY = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY());

}  // namespace

Picture::~Picture() = default;

Picture::Body& Picture::add(int frame, std::unique_ptr<Body> shape) {
  all_.push_back({frame, std::move(shape)});
  return *all_.back().shape;
}

void Picture::tube(int frame, const Vec3& a, const Vec3& b, double radius, const char* colour) {
  const Vec3 way = b - a;
  add(frame, std::make_unique<Body>(
                 "", ShapeGeometry{ShapeType::capsule, {radius, way.norm()}, {}, ""}, colour, "",
                 0.5 * (a + b), Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), way)));
}

void Picture::ellipsoid(int frame, const Vec3& at, const Vec3& semiAxes, double pitch,
                        const char* colour) {
  add(frame,
      std::make_unique<Body>(
          "",
          ShapeGeometry{ShapeType::ellipsoid, {semiAxes.x(), semiAxes.y(), semiAxes.z()}, {}, ""},
          colour, "", at, Eigen::Quaterniond(Eigen::AngleAxisd(pitch, Vec3::UnitY()))));
}

void Picture::wheel(int frame, const Wheel& wheel, const std::string& name,
                    const std::string& material, bool bicycle) {
  // The tyre that makes contact.
  const double R = wheel.radius;
  const bool ball = wheel.tube == R, drawn = wheel.tube > 0.0 && !ball;
  const ShapeGeometry tyre =
      ball ? ShapeGeometry{ShapeType::sphere, {R}, {}, ""}
           : ShapeGeometry{ShapeType::torus, {R - wheel.tube, wheel.tube}, {}, ""};
  add(frame, std::make_unique<Body>(name, tyre, drawn ? kBlack : "transparent", material,
                                    Vec3::Zero(), kAboutY));

  // A tyre that is only drawn, if the real one is an edge or a ball; then the spokes.
  const double thick = bicycle ? 0.016 : 0.045, rim = R - 2.0 * thick;
  if (!drawn)
    add(frame,
        std::make_unique<Body>("", ShapeGeometry{ShapeType::torus, {R - thick, thick}, {}, ""},
                               kBlack, "", Vec3::Zero(), kAboutY));
  const int spokes = bicycle ? 12 : 5;
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / spokes;
    const Vec3 way(std::sin(angle), 0.0, std::cos(angle));
    tube(frame, 0.03 * way, rim * way, bicycle ? 0.002 : 0.014, "#b9c0c8");
  }
  const Vec3 axle(0.0, bicycle ? 0.03 : 0.06, 0.0);
  tube(frame, -axle, axle, bicycle ? 0.018 : 0.035, "#8a929c");
  if (!bicycle)  // brake disc
    add(frame,
        std::make_unique<Body>("", ShapeGeometry{ShapeType::cylinder, {0.55 * rim, 0.006}, {}, ""},
                               "#9aa3ad", "", Vec3(0.0, 0.05, 0.0), kAboutY));
}

Picture::Picture(const Geometry& data, const std::string& material, bool isBicycle) {
  wheel(kRearWheelId, data.rear, "rearTyre", material, isBicycle);
  wheel(kFrontWheelId, data.front, "frontTyre", material, isBicycle);
  if (isBicycle)
    bicycle(data);
  else
    motorbike(data);
}

void Picture::motorbike(const Geometry& data) {
  const double w = data.wheelbase, R = data.rear.radius;
  const Vec3 axis = data.steerAxis(), foot = data.steerFoot();
  const auto head = [&](double height) { return Vec3(foot + height / axis.z() * axis); };
  const char* const paint = "#c1272d";
  const char* const dark = "#2b3038";
  const char* const metal = "#8a929c";

  // Frame: swing arm, engine, tank, seat, tail, exhaust.
  for (const double side : {-1.0, 1.0})
    tube(kFrameId, Vec3(0.0, 0.1 * side, R), Vec3(0.4 * w, 0.1 * side, 0.38), 0.025, metal);
  tube(kFrameId, Vec3(0.4 * w, 0.0, 0.38), head(0.78), 0.04, dark);
  ellipsoid(kFrameId, Vec3(0.5 * w, 0.0, 0.42), Vec3(0.24, 0.16, 0.19), -0.3, metal);
  ellipsoid(kFrameId, Vec3(0.56 * w, 0.0, 0.42), Vec3(0.09, 0.19, 0.09), 0.0, dark);
  ellipsoid(kFrameId, Vec3(0.56 * w, 0.0, 0.83), Vec3(0.26, 0.15, 0.13), 0.12, paint);
  ellipsoid(kFrameId, Vec3(0.27 * w, 0.0, 0.78), Vec3(0.27, 0.13, 0.055), -0.08, dark);
  ellipsoid(kFrameId, Vec3(0.02 * w, 0.0, 0.84), Vec3(0.2, 0.09, 0.05), 0.25, paint);
  tube(kFrameId, Vec3(0.45 * w, -0.15, 0.3), Vec3(-0.05 * w, -0.17, 0.42), 0.045, metal);

  // Rider.
  const char* const suit = "#31517d";
  const Vec3 hip(0.27 * w, 0.0, 0.9), neck(0.5 * w, 0.0, 1.36);
  tube(kFrameId, hip, neck - Vec3(0.02, 0.0, 0.06), 0.135, suit);
  ellipsoid(kFrameId, neck + Vec3(0.07, 0.0, 0.15), Vec3(0.145, 0.125, 0.14), 0.0, "#e8e4d8");
  ellipsoid(kFrameId, neck + Vec3(0.14, 0.0, 0.15), Vec3(0.085, 0.1, 0.055), 0.0, dark);
  const Vec3 grip = head(0.98) + Vec3(-0.1, 0.0, 0.0);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 out(0.0, side, 0.0), knee(0.52 * w, 0.21 * side, 0.74),
        heel(0.36 * w, 0.19 * side, 0.36);
    tube(kFrameId, hip + 0.1 * out, knee, 0.075, suit), tube(kFrameId, knee, heel, 0.06, suit);
    tube(kFrameId, heel, heel + Vec3(0.17, 0.0, -0.03), 0.045, dark);
    const Vec3 elbow(0.61 * w, 0.31 * side, 1.08);
    tube(kFrameId, neck + 0.17 * out + Vec3(-0.03, 0.0, -0.08), elbow, 0.055, suit);
    tube(kFrameId, elbow, grip + 0.3 * out, 0.045, suit);
  }

  // Fork: legs, mudguard, handlebar, lamp. Its frame is at the foot of the steering axis.
  const Vec3 hub = data.front.r_OS - foot;
  for (const double side : {-1.0, 1.0}) {
    const Vec3 out(0.0, 0.095 * side, 0.0);
    tube(kForkId, hub + out, hub + out + 0.62 * axis, 0.026, metal);
    tube(kForkId, head(0.98) - foot, grip - foot + Vec3(0.0, 0.33 * side, 0.0), 0.016, dark);
  }
  tube(kForkId, hub + 0.62 * axis + Vec3(0.0, -0.095, 0.0),
       hub + 0.62 * axis + Vec3(0.0, 0.095, 0.0), 0.028, dark);
  tube(kForkId, hub + 0.6 * axis, head(0.98) - foot, 0.03, dark);
  ellipsoid(kForkId, head(0.86) - foot + Vec3(0.13, 0.0, 0.0), Vec3(0.09, 0.1, 0.1), 0.0,
            "#f3e9b5");
  ellipsoid(kForkId, hub + 0.36 * axis, Vec3(0.17, 0.06, 0.03), -0.4, paint);
}

void Picture::bicycle(const Geometry& data) {
  const double w = data.wheelbase, R = data.rear.radius;
  const Vec3 axis = data.steerAxis(), foot = data.steerFoot();
  const auto head = [&](double height) { return Vec3(foot + height / axis.z() * axis); };
  const char* const paint = "#1f6f54";
  const Vec3 hub(0.0, 0.0, R), crank(0.42 * w, 0.0, 0.28), seat(0.24 * w, 0.0, 0.85);
  tube(kFrameId, crank, head(0.68), 0.02, paint), tube(kFrameId, crank, seat, 0.018, paint);
  tube(kFrameId, crank + 0.72 * (seat - crank), head(0.8), 0.018, paint);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 out(0.0, 0.04 * side, 0.0);
    tube(kFrameId, hub + out, crank + 0.5 * out, 0.01, paint);
    tube(kFrameId, hub + out, crank + 0.7 * (seat - crank) + 0.4 * out, 0.01, paint);
    tube(kForkId, data.front.r_OS - foot + out, data.front.r_OS - foot + 0.42 * axis + out, 0.011,
         "#8a929c");
    tube(kForkId, head(0.92) - foot, head(0.92) - foot + Vec3(0.0, 0.26 * side, 0.0), 0.012,
         "#2b3038");
  }
  tube(kForkId, data.front.r_OS - foot + 0.42 * axis, head(0.92) - foot, 0.017, "#8a929c");
  ellipsoid(kFrameId, seat + Vec3(0.02, 0.0, 0.03), Vec3(0.13, 0.07, 0.03), 0.0, "#2b3038");
}

void Picture::describe(Description& d) const {
  for (const Placed& placed : all_) d.shape(*placed.shape, placed.frame);
}

}  // namespace dynamy::motorbike
