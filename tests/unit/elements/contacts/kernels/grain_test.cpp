// Tangents along a grain: rows and bias against differences, what is refused.
#include <gtest/gtest.h>

#include <dynamy_elements/laws/orthotropic_friction.hpp>

#include "unit/elements/contacts/shape_models.hpp"

namespace dynamy {
namespace {

using namespace testing;

const GivenValue kGrain("grain", {0.6, 0.2, -0.3});

std::unique_ptr<SetValuedForceLaw> orthotropic() {
  return std::make_unique<UnilateralOrthotropic>(0.0, 0.0, 0.1, 0.3, 0.4);
}

void addBallOnPlane(Model& m, Given ball, Given plane) {
  plane.emplace_back("material", "steel");
  ball.emplace_back("material", "rubber");
  ball.emplace_back("radius", 0.3);
  addBody<Ground, HalfSpace>(m, "world", kMoving, "HalfSpace", plane);
  addBody<RigidBody, Sphere>(m, "ball", kHeavy, "Sphere", ball);
  addRule(m, "rubber steel", orthotropic());
}

TEST(Grain, OfEitherShapeHasRowsThatFit) {
  const GivenValue euler("euler", {0.3, 0.2, 0.1}), tilted("normal", {0.2, 0.1, 1.0});
  Model ofBall, ofPlane;
  addBallOnPlane(ofBall, {kGrain, euler}, {tilted});
  expectRowsFit(ofBall, 1, 3);
  addBallOnPlane(ofPlane, {}, {kGrain, euler, tilted});
  expectRowsFit(ofPlane, 1, 3);
}

TEST(Grain, OfTwoBallsHasRowsThatFit) {
  Model m;
  const Given ball{{"radius", 1.5}, {"material", "steel"}, {"position", {0.2, 0.0, 0.1}}};
  Given sawn = ball;
  sawn.push_back(kGrain);
  addBody<RigidBody, Sphere>(m, "a", kHeavy, "Sphere", ball);
  addBody<RigidBody, Sphere>(
      m, "b", {{"mass", 1.0}, {"inertia", {0.1, 0.1, 0.1}}, {"position", {1.5, 0.5, 2.5}}},
      "Sphere", sawn);
  addRule(m, "steel steel", orthotropic());
  expectRowsFit(m, 1, 3);
}

std::string refusal(Model& m) {
  try {
    built(m);
  } catch (const ModelError& error) {
    return error.what();
  }
  return "no error";
}

void expectRefusal(Model& m, const std::string& part) {
  const std::string said = refusal(m);
  EXPECT_NE(said.find(part), std::string::npos) << said;
}

TEST(Grain, OfBothShapesIsRefused) {
  Model m;
  addBallOnPlane(m, {kGrain}, {kGrain});
  expectRefusal(m, "both shapes have a grain");
}

TEST(Grain, IsNeededWhereNoShapeSaysADirection) {
  Model m;
  const Given ball{{"radius", 1.5}, {"material", "steel"}};
  addBody<RigidBody, Sphere>(m, "a", kHeavy, "Sphere", ball);
  addBody<RigidBody, Sphere>(m, "b", kHeavy, "Sphere", ball);
  addRule(m, "steel steel", orthotropic());
  expectRefusal(m, "neither shape says by which");
}

TEST(Grain, InAPlaneIsRefused) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  addBody<PlanarBody, Sphere>(m, "ball", kPlanar, "Sphere",
                              {{"radius", 0.3}, {"material", "rubber"}, kGrain});
  addRule(m, "rubber steel", orthotropic());
  expectRefusal(m, "which no grain can choose");
}

TEST(Grain, DoesNothingToALawThatIsTheSameInAllDirections) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}, kGrain});
  addBody<RigidBody, Sphere>(m, "ball", kHeavy, "Sphere",
                             {{"radius", 0.3}, {"material", "rubber"}, kGrain});
  addRule(m, "rubber steel");
  EXPECT_EQ(refusal(m), "no error");
}

}  // namespace
}  // namespace dynamy
