// A shape of a user, known by its support points alone: contacts with all other shapes, mass, faults.
#include <dynamy/core/constants.hpp>
#include <dynamy/core/error.hpp>
#include <dynamy/system/smooth_shape.hpp>

#include <algorithm>
#include <cmath>
#include <dynamy_elements/contacts/shapes/faceted_shapes.hpp>

#include "unit/elements/contacts/shape_models.hpp"

namespace dynamy {
namespace {

using namespace testing;

/// All points within r of an ellipsoid.
class Pebble : public SmoothShape {
 public:
  static void declare(Attributes& a) {
    a.requiredVector("semiAxes", Unit::length, 3, "semi-axes");
    a.optional("radius", Unit::length, 0.0, "r");
    a.choice("fault", {"none", "derivative", "along", "point", "origin"}, "none", "what is wrong");
  }
  explicit Pebble(const Parameters& x)
      : SmoothShape(x),
        D2_(x["semiAxes"].vec3().cwiseAbs2().asDiagonal()),
        r_(x["radius"]),
        fault_(x["fault"].text) {}
  Vec3 point(const Vec3& d) const override {
    const Vec3 x = D2_ * d / std::sqrt(d.dot(D2_ * d)) + r_ * d;
    if (fault_ == "point") return {x.x(), x.y(), 0.5 * x.z()};
    return fault_ == "origin" ? Vec3(x + Vec3(1.0, 0.0, 0.0)) : x;
  }
  Mat3 pointDerivative(const Vec3& d) const override {
    const Vec3 s = D2_ * d;
    const double h2 = d.dot(s);
    const Mat3 H = (D2_ - s * s.transpose() / h2) / std::sqrt(h2) +
                   r_ * (Mat3::Identity() - d * d.transpose());
    if (fault_ == "along") return H + 0.1 * d * d.transpose();
    return fault_ == "derivative" ? Mat3(1.01 * H) : H;
  }

 private:
  Mat3 D2_;
  double r_;
  std::string fault_;
};

const Given kAxes{{"semiAxes", {0.3, 0.2, 0.1}}, {"material", "stone"}};

Given with(Given given, const GivenValue& more) {
  given.push_back(more);
  return given;
}

/// The least gap of a body of shape S with a shape of type Other that stands at the origin.
template <class S, class Other>
double leastGap(const Given& shape, const Given& other, const Given& pose) {
  Model m;
  addBody<Ground, Other>(m, "world", {}, "Other", with(other, {"material", "stone"}));
  Given body{{"mass", 1.0}, {"inertia", {0.1, 0.1, 0.1}}};
  body.insert(body.end(), pose.begin(), pose.end());
  addBody<RigidBody, S>(m, "b", body, "Shape", shape);
  addRule(m, "stone stone");
  const ShapeContacts& element = built(m);
  Motion motion(m);
  const ContactSet set = motion.contacts(element, 0.0);
  return set.size() > 0 ? *std::min_element(set.g.begin(), set.g.begin() + set.size()) : 1e9;
}

/// What is within r of a body is nearer to everything by r (the sum of Minkowski with a ball), and
/// a pebble without a radius is an ellipsoid.
template <class Other>
void expectNearerByItsRadius(const Given& other) {
  const Given around = with(kAxes, {"radius", 0.05}), bare = with(kAxes, {"radius", 0.0});
  for (int k = 0; k < 12; ++k) {
    SCOPED_TRACE(k);
    // Directions of a spiral over the upper half; some 0.4 m apart.
    const double z = 0.05 + 0.9 * k / 12.0, s = std::sqrt(1.0 - z * z), angle = 2.4 * k;
    const Given pose{{"position", {s * std::cos(angle), s * std::sin(angle), z}},
                     {"euler", {0.3 * k, 1.0 - 0.2 * k, 0.5 * k}}};
    const double ellipsoid = leastGap<EllipsoidShape, Other>(kAxes, other, pose);
    ASSERT_LT(ellipsoid, 2.0);
    // Newton's method on the direction ends at 1e-15; gaps of 1 m and axes of 0.3 m round a few
    // times.
    EXPECT_NEAR((leastGap<Pebble, Other>(bare, other, pose)), ellipsoid, 1e-14);
    EXPECT_NEAR((leastGap<Pebble, Other>(around, other, pose)), ellipsoid - 0.05, 1e-14);
  }
}

TEST(SmoothShape, IsNearerToAllOtherShapesByItsRadius) {
  expectNearerByItsRadius<HalfSpace>({});
  expectNearerByItsRadius<Sphere>({{"radius", 0.2}});
  expectNearerByItsRadius<EllipsoidShape>({{"semiAxes", {0.1, 0.25, 0.2}}});
  expectNearerByItsRadius<Box>({{"size", {0.3, 0.2, 0.4}}});
  expectNearerByItsRadius<CylinderShape>({{"radius", 0.2}, {"length", 0.3}});
  expectNearerByItsRadius<ConeShape>({{"radius", 0.2}, {"length", 0.3}});
  expectNearerByItsRadius<CapsuleShape>({{"radius", 0.1}, {"length", 0.3}});
  expectNearerByItsRadius<TorusShape>({{"radius", 0.2}, {"tube", 0.05}});
  expectNearerByItsRadius<Pebble>({{"semiAxes", {0.1, 0.25, 0.2}}, {"radius", 0.0}});
}

TEST(SmoothShape, RowsFitTheMotionOfTwo) {
  Model m;
  addBody<Ground, Pebble>(m, "world", kMoving, "Pebble", with(kAxes, {"radius", 0.05}));
  addBody<RigidBody, Pebble>(m, "b", kHeavy, "Pebble", with(kAxes, {"radius", 0.1}));
  addRule(m, "stone stone");
  expectRowsFit(m, 1, 3);
}

MassProperties massOf(const Given& given) {
  return Pebble(Parameters::of<Pebble>("Pebble", "", given)).massProperties();
}

TEST(SmoothShape, HasTheMassOfAnEllipsoid) {
  const double a = 0.3, b = 0.2, c = 0.1, V = 4.0 / 3.0 * kPi * a * b * c;
  const MassProperties m = massOf(kAxes);
  // Quadrature stops where twice the circles change it by less than 1e-13.
  EXPECT_NEAR(m.volume, V, 1e-12 * V);
  EXPECT_LT(m.centre_B.norm(), 1e-13);
  const Vec3 J = V / 5.0 * Vec3(b * b + c * c, a * a + c * c, a * a + b * b);
  EXPECT_LT((m.inertia_B - Mat3(J.asDiagonal())).norm(), 1e-12 * J.norm());
}

TEST(SmoothShape, HasTheMassOfABallOfBothRadii) {
  const double R = 0.25, V = 4.0 / 3.0 * kPi * R * R * R;
  const MassProperties m = massOf({{"semiAxes", {0.2, 0.2, 0.2}}, {"radius", 0.05}});
  EXPECT_NEAR(m.volume, V, 1e-13 * V);
  EXPECT_LT((m.inertia_B - 0.4 * V * R * R * Mat3::Identity()).norm(), 1e-13 * V * R * R);
}

TEST(SmoothShape, BoundsAndWidthHoldIt) {
  const Pebble pebble(Parameters::of<Pebble>("Pebble", "", with(kAxes, {"radius", 0.05})));
  const SmoothShape::Extent e = pebble.extent();
  EXPECT_GE(e.bound, 0.35);
  EXPECT_LE(e.bound, 1.02 * 0.35);        // directions every 15°: 1/cos 10.6°
  EXPECT_NEAR(e.halfWidth, 0.15, 1e-15);  // along an axis
}

/// An egg about z: h = (b + (a − b) c² + k c³) |d|, c the cosine between d and z. The radii of
/// curvature at its ends ±z are 2b − a ∓ 2k; those of `turned` lie along (1, 2, 2)/3.
class Egg final : public SmoothShape {
 public:
  static void declare(Attributes& a) {
    a.required("taper", Unit::length, "k");
    a.optional("turned", Unit::none, 0.0, "1: about (1, 2, 2)");
  }
  explicit Egg(const Parameters& x)
      : SmoothShape(x),
        k_(x["taper"]),
        axis_(x["turned"] > 0.0 ? Vec3(1.0, 2.0, 2.0) / 3.0 : Vec3(Vec3::UnitZ())) {}
  Vec3 point(const Vec3& d) const override {
    const double c = d.dot(axis_);
    return round(c) * d + (2.0 * kE * c + 3.0 * k_ * c * c) * axis_;
  }
  Mat3 pointDerivative(const Vec3& d) const override {
    const double c = d.dot(axis_);
    const Vec3 t = axis_ - c * d;
    return round(c) * (Mat3::Identity() - d * d.transpose()) +
           (2.0 * kE + 6.0 * k_ * c) * t * t.transpose();
  }

 private:
  static constexpr double kB = 0.022, kE = 0.008;  // b, a − b with a = 30 mm
  double round(double c) const { return kB - kE * c * c - 2.0 * k_ * c * c * c; }
  double k_;
  Vec3 axis_;
};

TEST(SmoothShape, RefusesAHollowAtAnEndOfAnAxisAndBetweenTheAxes) {
  // The radius at the tip is 0.022 + … = 2b − a − 2k = 14 mm − 2k.
  const auto said = [](double taper, double turned) -> std::string {
    try {
      Egg(Parameters::of<Egg>("Egg", "", {{"taper", taper}, {"turned", turned}}))
          .requireConsistent();
    } catch (const ModelError& e) {
      return e.what();
    }
    return {};
  };
  for (const double turned : {0.0, 1.0}) {
    EXPECT_EQ(said(0.00695, turned), "");  // 0.1 mm
    for (const double taper : {0.00705, -0.00705, 0.009})
      EXPECT_NE(said(taper, turned).find("the surface is hollow there"), std::string::npos)
          << taper << ' ' << said(taper, turned);
  }
  EXPECT_NE(said(0.009, 0.0).find("d = 0 0 1: a radius of curvature is -0.004 m"),
            std::string::npos)
      << said(0.009, 0.0);
}

TEST(SmoothShape, TellsWhatDoesNotFit) {
  const auto said = [](const char* fault) -> std::string {
    try {
      massOf(with(kAxes, {"fault", fault}));
    } catch (const ModelError& e) {
      return e.what();
    }
    return {};
  };
  EXPECT_EQ(said("none"), "");
  EXPECT_NE(said("derivative").find("pointDerivative is not the derivative of point"),
            std::string::npos)
      << said("derivative");
  EXPECT_NE(said("along").find("changes along d"), std::string::npos) << said("along");
  EXPECT_NE(said("point").find("another point lies further along it"), std::string::npos)
      << said("point");
  EXPECT_NE(said("origin").find("the origin of the shape's axes lies outside of it"),
            std::string::npos)
      << said("origin");
}

}  // namespace
}  // namespace dynamy
