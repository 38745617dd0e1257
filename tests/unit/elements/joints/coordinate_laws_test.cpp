// Laws, drives and stops in joint coordinates: rows against differences; what is refused.
#include <gtest/gtest.h>

#include <dynamy_elements/joints/coordinate_laws.hpp>
#include <dynamy_elements/joints/joints.hpp>
#include <dynamy_elements/joints/transmissions.hpp>
#include <functional>

#include "joint_models.hpp"

namespace dynamy {
namespace {

using testing::addPlanar;
using testing::addSpatial;
using testing::Motion;

const GivenValue kAngle("coordinate", "angle"), kShift("coordinate", "displacement");
const GivenValue kAxis("axis", {0.2, 1.0, 0.3});

/// γ against d/dt of the position rows, bias against d/dt γ, far from where a hinge holds.
void expectFits(Model& m, bool position = true) {
  m.build();
  const NonSmoothElement& element = *m.contacts().at(0);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Motion motion(m, 0.0);
    motion.scatter(seed, 0.7);
    const auto gap = [&](double s) {
      const ContactSet c = motion.contacts(element, s);
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
          c.position.data(), static_cast<Eigen::Index>(c.position.size())));
    };
    const Eigen::VectorXd gamma = motion.gamma(element, 0.0);
    const double tolerance = 10.0 * testing::kTolerance;
    if (position) {
      EXPECT_LT((gamma - testing::fourPoint(gap)).norm(), tolerance);
    }
    const auto rate = [&](double s) { return motion.gamma(element, s); };
    EXPECT_LT((motion.bias(element) - testing::fourPoint(rate)).norm(), tolerance);
  }
}

class CoordinateLaws : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { addSpatial(space_), addPlanar(plane_); }
  GivenValue between() const { return {"between", GetParam()}; }
  Model space_, plane_;
};

TEST_P(CoordinateLaws, OfAStopFit) {
  space_.add<JointStop>("stop", {between(), kAngle, kAxis, {"lower", -1.0}, {"upper", 2.0}});
  expectFits(space_);
  plane_.add<JointStop>("stop", {between(), kAngle, {"lower", -1.0}});
  expectFits(plane_);
}

TEST_P(CoordinateLaws, OfADriveFit) {
  space_.add<JointDrive>("drive", {between(), kAngle, kAxis, {"motion", "0.3*sin(2*t)+t^2"}});
  expectFits(space_);
  plane_.add<JointDrive>("drive",
                         {between(), kShift, {"axis", {1.0, 0.0, 0.4}}, {"motion", "t^3"}});
  expectFits(plane_);
}

TEST_P(CoordinateLaws, OfAMotorFit) {
  space_.add<JointMotor>("motor",
                         {between(), kShift, kAxis, {"speed", "sin(2*t)"}, {"limit", 2.0}});
  expectFits(space_, false);
}

TEST_P(CoordinateLaws, OfFrictionFit) {
  Parameters x =
      Parameters::of<JointFriction>("JointFriction", "friction", {between(), kAngle, kAxis});
  x.children.push_back({Kind::law, testing::friction()});
  space_.add(std::make_unique<JointFriction>(x));
  expectFits(space_, false);
}

TEST_P(CoordinateLaws, OfAGearFit) {
  space_.add<Gear>("gear", {between(),
                            {"carrier", "a"},
                            {"ratio", -1.5},
                            {"axisA", {0.2, 1.0, 0.3}},
                            {"axisB", {1.0, 0.0, 0.3}}});
  expectFits(space_);
  plane_.add<Gear>("gear", {between(), {"carrier", "world"}, {"ratio", 2.0}});
  expectFits(plane_);
}

TEST_P(CoordinateLaws, OfARackFit) {
  space_.add<RackAndPinion>("rack", {between(),
                                     {"carrier", "a"},
                                     {"radius", 0.4},
                                     {"axis", {0.2, 1.0, 0.3}},
                                     {"direction", {1.0, 0.0, 0.3}}});
  expectFits(space_);
}

TEST_P(CoordinateLaws, OfARopeFit) {
  const GivenValue through("through", std::string("world a ") + GetParam());
  space_.add<Rope>("rope", {through, {"points", {0, 0, 3, 0.1, 0, 0.2, 0, 2, 1, 0.3, 0, 0}}});
  expectFits(space_);
  plane_.add<Rope>("rope", {through, {"points", {0, 0, 3, 0.1, 0, 0.2, 0, 2, 1, 0.3, 0, 0}}});
  expectFits(plane_);
}

INSTANTIATE_TEST_SUITE_P(Between, CoordinateLaws, ::testing::Values("world b", "b world", "a b"),
                         [](const auto& between) {
                           std::string name = between.param;
                           name.erase(name.find(' '), 1);
                           return name;
                         });

/// What build() or the making of the element says.
std::string refusal(const std::function<void(Model&)>& addTo) {
  Model m;
  addSpatial(m);
  try {
    addTo(m);
    m.build();
  } catch (const ModelError& error) {
    return error.what();
  }
  return {};
}

TEST(CoordinateLawsRefuse, WhatCannotBe) {
  const GivenValue between("between", "a b");
  const auto expect = [](const std::string& said, const char* part) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  expect(refusal([&](Model& m) { m.add<JointStop>("s", {between, kAxis}); }), "neither lower nor");
  expect(refusal([&](Model& m) {
           m.add<JointStop>("s", {between, kAxis, {"lower", 1.0}, {"upper", 0.0}});
         }),
         "lies above");
  expect(refusal([&](Model& m) {
           m.add<JointStop>("s", {between, kAxis, {"lower", 0.5}});
         }),
         "beyond the stops");
  expect(refusal([&](Model& m) {
           m.add<JointStop>("s", {between, {"lower", -0.5}});
         }),
         "needs an axis");
  expect(refusal([&](Model& m) {
           m.add<JointStop>("s", {between, kAxis, {"reference", {0.4, 2.0, 0.6}}, {"lower", -0.5}});
         }),
         "along the axis");
  expect(refusal([&](Model& m) {
           m.add<JointDrive>("d", {between, kAxis, {"motion", "cos(t)"}});
         }),
         "begins at 1");
  const auto withFriction = [&](Model& m) {
    Parameters x = Parameters::of<JointStop>("JointStop", "s", {between, kAxis, {"lower", -0.5}});
    x.children.push_back({Kind::law, std::make_unique<UnilateralCoulomb>(0.0, 0.0, 0.3)});
    m.add(std::make_unique<JointStop>(x));
  };
  expect(refusal(withFriction), "no direction in which the friction of its law could act");
}

TEST(CouplingsRefuse, WhatCannotBe) {
  const auto expect = [](const std::string& said, const char* part) {
    EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  expect(refusal([](Model& m) {
           m.add<Gear>("g", {{"between", "a b"}, {"carrier", "world"}, {"ratio", 2.0}});
         }),
         "axis of A is missing");
  expect(refusal([](Model& m) {
           m.add<Gear>("g", {{"between", "a"}, {"carrier", "world"}, {"ratio", 2.0}});
         }),
         "two frames are needed");
  expect(refusal([](Model& m) { m.add<Rope>("r", {{"through", "world world"}}); }), "coincide");
  expect(refusal([](Model& m) {
           m.add<Rope>("r", {{"through", "world world"}, {"points", {0, 0, 0, 0, 0, 1}}});
         }),
         "move as given");
  expect(refusal([](Model& m) {
           m.add<Rope>("r", {{"through", "a b"}, {"points", {0, 0, 0}}});
         }),
         "6 numbers are needed");
  // A slack rope may begin at its hook.
  const auto slack = [](Model& m) {
    Parameters x = Parameters::of<Rope>(
        "Rope", "r", {{"through", "a b"}, {"points", {0, 0, 0, 0, 0, 0}}, {"length", 2.0}});
    x.children.push_back({Kind::law, std::make_unique<UnilateralCoulomb>(0.0, 0.0, 0.3)});
    m.add(std::make_unique<Rope>(x));
  };
  expect(refusal(slack), "no direction in which the friction of the law could act");
}

TEST(JointAngle, CountsWholeTurns) {
  Model m;
  m.add<Ground>("world", {});
  m.add<PlanarBody>("wheel",
                    {{"mass", 1.0}, {"inertia", 0.1}, {"plane", "xy"}, {"angularVelocity", 5.0}});
  m.add<JointStop>("stop", {{"between", "world wheel"}, {"upper", 100.0}, {"start", 7.0}});
  m.build();
  State x = m.initialState();
  Kinematics k;
  k.resize(m.topology());
  const auto& stop = *m.contacts().at(0);
  for (int i = 0; i < 40; ++i) {
    // More than a turn at once.
    m.systems()[1]->move(x.t, view(x.q), view(std::as_const(x.u)), 2.0);
    x.t += 2.0;
    const State& at = x;
    k.evaluate(m.topology(), x.t, view(at.q), view(at.u), view(at.memory));
    stop.remember(k, view(x.memory));
    EXPECT_NEAR(x.memory[0], 7.0 + 10.0 * (i + 1), 1e-12 * (i + 1));  // rounding of each turn
  }
}

}  // namespace
}  // namespace dynamy
