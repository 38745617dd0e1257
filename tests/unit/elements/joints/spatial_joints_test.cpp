// Universal, cylindrical and planar joints, screws: rows against differences of the position
// errors.
#include <gtest/gtest.h>

#include <dynamy_elements/joints/joints.hpp>
#include <dynamy_elements/joints/spatial_joints.hpp>

#include "joint_models.hpp"

namespace dynamy {
namespace {

using testing::add;
using testing::addPlanar;
using testing::addSpatial;
using testing::expectRowsFit;
using testing::Motion;

class SpatialJointRows : public ::testing::TestWithParam<const char*> {
 protected:
  std::vector<GivenValue> given(std::vector<GivenValue> more = {}) const {
    more.push_back({"between", GetParam()});
    more.push_back({"at", {0.4, 0.0, 1.1}});
    more.push_back({"axis", {0.2, 1.0, 0.3}});
    return more;
  }
  Model space_;
  void SetUp() override { addSpatial(space_); }
};

TEST_P(SpatialJointRows, OfAUniversalFit) {
  expectRowsFit(space_, add<Universal>(space_, given({{"axisB", {1.0, -0.2, 0.0}}})), 4, 4);
}

TEST_P(SpatialJointRows, OfACylindricalFit) {
  expectRowsFit(space_, add<Cylindrical>(space_, given()), 4, 4);
}

TEST_P(SpatialJointRows, OfAScrewFit) {
  expectRowsFit(space_, add<Screw>(space_, given({{"pitch", 0.9}}), true), 5, 6);
}

TEST_P(SpatialJointRows, OfALeftHandedScrewFit) {
  expectRowsFit(space_, add<Screw>(space_, given({{"pitch", -0.7}})), 5, 5);
}

TEST_P(SpatialJointRows, OfAPlaneFit) {
  expectRowsFit(space_, add<PlanarJoint>(space_, given(), true), 3, 5);
}

INSTANTIATE_TEST_SUITE_P(Between, SpatialJointRows, ::testing::Values("world b", "b world", "a b"),
                         [](const auto& between) {
                           std::string name = between.param;
                           name.erase(name.find(' '), 1);
                           return name;
                         });

TEST(SpatialJoints, AreForBodiesInSpace) {
  const std::vector<GivenValue> between{{"between", "a b"}, {"axis", {0.0, 0.0, 1.0}}};
  const auto refused = [&](auto&& addTo) {
    Model m;
    addPlanar(m);
    addTo(m);
    EXPECT_THROW(m.build(), ModelError);
  };
  refused([&](Model& m) { m.add<Cylindrical>("joint", between); });
  refused([&](Model& m) { m.add<PlanarJoint>("joint", between); });
  refused([&](Model& m) {
    m.add<Screw>("joint", {{"between", "a b"}, {"axis", {0.0, 0.0, 1.0}}, {"pitch", 0.1}});
  });
}

TEST(SpatialJoints, AUniversalRefusesAxesThatAreNotPerpendicular) {
  Model m;
  addSpatial(m);
  m.add<Universal>("joint",
                   {{"between", "a b"}, {"axis", {0.0, 0.0, 1.0}}, {"axisB", {0.0, 1.0, 0.1}}});
  EXPECT_THROW(m.build(), ModelError);
}

/// Signals of the first contact element at a motion's start, and their rates by differences.
class Measured {
 public:
  explicit Measured(Model& m) : model_(&m), motion_(m) {
    m.contacts().at(0)->describe(description_);
  }
  double value(const std::string& name, double s) {
    SignalView v;
    v.kinematics = &motion_.at(s);
    for (const Signal& signal : description_.signals)
      if (signal.name == name) return signal.value(v);
    ADD_FAILURE() << "no signal " << name;
    return 0.0;
  }
  void expectRate(const std::string& name, const std::string& rate) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      motion_.scatter(seed, 0.5);
      const Eigen::VectorXd difference = testing::fourPoint(
          [&](double s) { return Eigen::VectorXd::Constant(1, value(name, s)); });
      EXPECT_NEAR(value(rate, 0.0), difference[0], 10.0 * testing::kTolerance) << name;
    }
  }

 private:
  Model* model_;
  Motion motion_;
  Description description_;
};

TEST(SpatialJoints, CoordinatesAndTheirRatesBelongTogether) {
  const auto expectAll = [](auto&& addTo,
                            const std::vector<std::pair<const char*, const char*>>& names) {
    Model m;
    addSpatial(m);
    addTo(m);
    m.build();
    Measured measured(m);
    for (const auto& [name, rate] : names) measured.expectRate(name, rate);
  };
  const GivenValue between("between", "a b"), axis("axis", {0.2, 1.0, 0.3});
  expectAll([&](Model& m) { add<Revolute>(m, {between, axis}); }, {{"angle", "rate"}});
  expectAll([&](Model& m) { add<Prismatic>(m, {between, axis}); }, {{"displacement", "rate"}});
  expectAll(
      [&](Model& m) {
        add<Universal>(m, {between, axis, {"axisB", {1.0, -0.2, 0.0}}});
      },
      {{"alpha", "alphaRate"}, {"beta", "betaRate"}});
  expectAll(
      [&](Model& m) {
        add<Cylindrical>(m, {between, axis});
      },
      {{"displacement", "speed"}, {"angle", "rate"}});
  expectAll(
      [&](Model& m) {
        add<PlanarJoint>(m, {between, axis});
      },
      {{"x", "xRate"}, {"y", "yRate"}, {"angle", "rate"}});
}

}  // namespace
}  // namespace dynamy
