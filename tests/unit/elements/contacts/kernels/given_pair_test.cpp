// Pairs that a shape of a plug-in brings: a hollow ball on half spaces and around balls.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/simulation/run/simulation.hpp>
#include <dynamy/system/shape_pair.hpp>
#include <dynamy/testing/check_element.hpp>
#include <dynamy_elements/bodies/grains.hpp>
#include <limits>

#include "unit/elements/contacts/shape_models.hpp"

namespace dynamy {
namespace {

using namespace testing;

class HollowBall final : public Shape {
 public:
  static const ShapeFamily family;
  static void declare(Attributes& a) {
    a.required("radius", Unit::length, "of the hollow").positive();
    a.required("wall", Unit::length, "thickness of the wall").positive();
  }
  explicit HollowBall(const Parameters& x) : Shape(x), r_(x["radius"]), R_(r_ + x["wall"]) {}
  double inside() const { return r_; }
  double outside() const { return R_; }
  OwnContact ownContact() const override { return {&family, R_, 0.5 * (R_ - r_)}; }
  ShapeGeometry geometry() const override { return {ShapeType::sphere, {R_}, {}, colour()}; }

 private:
  double r_, R_;
};

PairContact onHalfSpace(const ShapeAt& a, const ShapeAt& b, int) {
  const double R = static_cast<const HollowBall&>(b.shape).outside();
  PairContact out;
  out.g = a.n.dot(b.c - a.c) - R;
  out.n = a.n, out.ndot = a.frame.Omega_I.cross(a.n);
  out.P = b.c - R * out.n, out.Pdot = b.v() - R * out.ndot;
  return out;
}

PairContact aroundBall(const ShapeAt& a, const ShapeAt& b, int) {
  const Vec3 d = a.c - b.c, ddot = a.v() - b.v();
  const double length = d.norm();
  PairContact out;
  out.g = static_cast<const HollowBall&>(b.shape).inside() - a.radius - length;
  if (length > 0.0) out.n = d / length, out.ndot = (ddot - out.n.dot(ddot) * out.n) / length;
  out.P = a.c + a.radius * out.n, out.Pdot = a.v() + a.radius * out.ndot;
  return out;
}

const ShapeFamily HollowBall::family{
    "HollowBall", {{&ShapeFamily::halfSpace, onHalfSpace}, {&ShapeFamily::ball, aroundBall}}};

const Given kHollow{{"radius", 0.5}, {"wall", 0.02}, {"mass", 3.0}, {"material", "steel"}};

TEST(GivenPair, OnAMovingHalfSpaceFits) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", kMoving, "HalfSpace",
                             {{"material", "steel"}, {"normal", {0.2, 0.1, 1.0}}});
  Given shape = kHollow;
  shape.emplace_back("position", Vec3(0.2, 0.1, 0.0));
  shape.erase(shape.begin() + 2);  // the body's own mass
  addBody<RigidBody, HollowBall>(m, "hollow", kHeavy, "HollowBall", shape);
  addRule(m, "steel steel");
  expectRowsFit(m, 1, 3);
}

TEST(GivenPair, AroundABallFitsInEitherOrder) {
  for (const bool ballFirst : {false, true}) {
    SCOPED_TRACE(ballFirst);
    Model m;
    const auto ball = [&] {
      addBody<RigidBody, Sphere>(
          m, "ball", kHeavy, "Sphere",
          {{"radius", 0.1}, {"material", "steel"}, {"position", {0.05, 0.1, 0.2}}});
    };
    if (ballFirst) ball();
    addBody<Ground, HollowBall>(m, "hollow", kMoving, "HollowBall",
                                {{"radius", 2.5}, {"wall", 0.1}, {"material", "steel"}});
    if (!ballFirst) ball();
    addRule(m, "steel steel");
    expectRowsFit(m, 1, 3);
  }
}

/// A ball with the upward velocity `vz` inside of a hollow ball on a floor; z of both at `until`.
std::pair<double, double> heights(double vz, double until, double step, double tolerance) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "felt"}});
  addBody<RigidBody, HollowBall>(
      m, "hollow", {{"position", {0.0, 0.0, 0.52}}, {"inertia", {1.0, 1.0, 1.0}}, {"mass", 3.0}},
      "HollowBall", {{"radius", 0.5}, {"wall", 0.02}, {"material", "steel"}});
  addBody<RigidBody, Sphere>(m, "ball",
                             {{"position", {0.0, 0.0, 0.32}}, {"velocity", {0.0, 0.0, vz}}},
                             "Sphere", {{"radius", 0.1}, {"mass", 1.0}, {"material", "steel"}});
  addRule(m, "steel steel", std::make_unique<UnilateralCoulomb>(0.5, 0.0, 0.3));
  addRule(m, "steel felt", std::make_unique<UnilateralCoulomb>(0.0, 0.0, 0.3));
  built(m);
  m.simulation.until = until;
  if (step > 0.0) m.askStep(step);
  if (tolerance > 0.0) m.askTolerance(tolerance);
  Simulation simulation(m);
  EXPECT_EQ(simulation.run().ended, RunReport::Ended::finished);
  const State& x = simulation.state();
  const int hollow = m.topology().system(1).q0, ball = m.topology().system(2).q0;
  return {x.q[ball + 2], x.q[hollow + 2]};
}

// No gravity: the ball flies 0.2 m down with 2 m/s and comes back with 1 m/s, since the floor keeps
// the hollow ball: z = 0.12 + (t − 0.1) at t.
TEST(GivenPair, BouncesWithFixedStepsAndWithATolerance) {
  // A step of 1 ms meets the wall within it: error 2 · 1e-3 · (2 + 1) m at most.
  const auto [fixedBall, fixedHollow] = heights(-2.0, 0.3, 1e-3, 0.0);
  EXPECT_NEAR(fixedBall, 0.32, 6e-3);
  EXPECT_NEAR(fixedHollow, 0.52, 1e-12);
  const auto [ball, hollow] = heights(-2.0, 0.3, 0.0, 1e-8);
  EXPECT_NEAR(ball, 0.32, 1e-7);  // ten tolerances
  EXPECT_NEAR(hollow, 0.52, 1e-7);
}

/// A bowl on a still ground with one mistake.
template <int mistake>
class WrongBowl final : public Shape {
 public:
  static const ShapeFamily family;
  static void declare(Attributes&) {}
  explicit WrongBowl(const Parameters& x) : Shape(x) {}
  OwnContact ownContact() const override { return {&family, 1.0, 0.1}; }
  ShapeGeometry geometry() const override { return {ShapeType::sphere, {1.0}, {}, colour()}; }
};

template <int mistake>
PairContact inWrongBowl(const ShapeAt& a, const ShapeAt& b, int) {
  const Vec3 d = a.c - b.c, ddot = a.v() - b.v();
  const double length = d.norm(), rho = (mistake == 3 ? 1.5 : 1.0) * a.radius;
  PairContact out;
  out.g = 1.0 - a.radius - length;
  out.n = (mistake == 1 ? -1.0 : mistake == 2 ? 1.1 : 1.0) * d / length;
  out.ndot = (ddot - d.dot(ddot) / d.squaredNorm() * d) / (mistake == 5 ? -length : length);
  out.P = a.c + rho * d / length;
  out.Pdot = a.v() + (mistake == 4 ? 0.0 : a.radius) * out.ndot;
  return out;
}

template <int mistake>
const ShapeFamily WrongBowl<mistake>::family{"Bowl", {{&ShapeFamily::ball, inWrongBowl<mistake>}}};

template <int mistake>
Verdict checkBowl() {
  Model m;
  addBody<Ground, WrongBowl<mistake>>(m, "world", {}, "Bowl", {{"material", "steel"}});
  addBody<RigidBody, Sphere>(m, "ball",
                             {{"position", {0.1, 0.2, -0.3}},
                              {"velocity", {0.3, 0.9, -1.0}},
                              {"angularVelocity", {3.0, 4.0, 5.0}}},
                             "Sphere", {{"radius", 0.1}, {"mass", 1.0}, {"material", "steel"}});
  addRule(m, "steel steel");
  built(m);
  return checkModel(m);
}

TEST(GivenPair, ChecksAllEntriesAlsoOnAStillGround) {
  const Verdict right = checkBowl<0>();
  EXPECT_TRUE(right) << right;
  EXPECT_TRUE(right.uncompared().empty()) << right.uncompared()[0];
  for (const Verdict& wrong :
       {checkBowl<1>(), checkBowl<2>(), checkBowl<3>(), checkBowl<4>(), checkBowl<5>()}) {
    EXPECT_FALSE(wrong);
    EXPECT_EQ(wrong.message().find("ball-world: "), 0u) << wrong;  // names the pair
  }
}

TEST(GivenPair, KeepsAFastBallInside) {
  // In a step of 10 ms the ball moves 2 m, through a wall of 0.02 m.
  const auto [ball, hollow] = heights(-200.0, 0.05, 1e-2, 0.0);
  // Its middle is at most 0.4 m from that of the hollow, and a tenth of the wall.
  EXPECT_LT(std::abs(ball - hollow), 0.4 + 2e-3);
}

/// A shape whose ownContact() is given.
class Sized final : public Shape {
 public:
  static const ShapeFamily family;
  static void declare(Attributes& a) {
    a.required("bound", Unit::length, "of its ball; 0: endless");
  }
  explicit Sized(const Parameters& x) : Shape(x), bound_(x["bound"]) {}
  OwnContact ownContact() const override {
    return {&family, bound_ > 0.0 ? bound_ : std::numeric_limits<double>::infinity(), 0.1};
  }
  ShapeGeometry geometry() const override { return {ShapeType::sphere, {1.0}, {}, colour()}; }

 private:
  double bound_;
};
const ShapeFamily Sized::family{"Sized", {{&ShapeFamily::ball, onHalfSpace}}};

template <class Other>
std::string refusalBeside(double bound, const std::string& type, const Given& other) {
  Model m;
  addBody<Ground, Sized>(m, "world", {}, "Egg", {{"bound", bound}, {"material", "steel"}});
  addBody<RigidBody, Other>(m, "body", kHeavy, type, other);
  addRule(m, "steel steel");
  try {
    built(m);
  } catch (const ModelError& e) {
    return e.what();
  }
  return {};
}

TEST(GivenPair, RefusalsNameTheSizeAndWhatTheFamilyTouches) {
  const auto has = [](const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
  };
  const Given ball{{"radius", 0.1}, {"material", "steel"}};
  const std::string endless = refusalBeside<Sphere>(0.0, "Sphere", ball);
  EXPECT_TRUE(has(endless, "<Egg>: ownContact() gives the bound inf m")) << endless;
  EXPECT_TRUE(has(endless, "a finite bound above 0")) << endless;
  EXPECT_EQ(refusalBeside<Sphere>(1.0, "Sphere", ball), "");
  const std::string box =
      refusalBeside<Box>(1.0, "Box", {{"size", {1.0, 1.0, 1.0}}, {"material", "steel"}});
  EXPECT_TRUE(has(box, "a Box") && has(box, "an Egg") && has(box, "is not available")) << box;
  EXPECT_TRUE(has(box, "an Egg touches balls")) << box;
  EXPECT_FALSE(has(box, "with all")) << box;
}

TEST(GivenPair, IsRefusedInAPlaneAndForManySizes) {
  Model flat;
  addBody<Ground, HalfSpace>(flat, "world", {}, "HalfSpace", {{"material", "steel"}});
  addBody<PlanarBody, HollowBall>(flat, "hollow", kPlanar, "HollowBall",
                                  {{"radius", 0.5}, {"wall", 0.02}, {"material", "steel"}});
  addRule(flat, "steel steel");
  EXPECT_THROW(built(flat), ModelError);
  EXPECT_THROW(
      Grains(Parameters::of<Grains>("Grains", "", {{"count", 2.0}, {"within", {0, 0, 0, 9, 9, 9}}})
                 .with(std::make_unique<HollowBall>(
                     Parameters::of<HollowBall>("HollowBall", "", kHollow)))),
      ModelError);
}

}  // namespace
}  // namespace dynamy
