/// Two bodies and a ground that moves, in space and in a plane, and what every joint between them
/// has to fulfil.
#pragma once
#include <gtest/gtest.h>
#include <dynamy_elements/bodies/ground.hpp>
#include <dynamy_elements/bodies/planar_body.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>
#include <dynamy_elements/joints/joint.hpp>

#include "unit/elements/motion.hpp"

namespace dynamy::testing {

inline const std::vector<GivenValue> kWorld{{"motion", "0.1*sin(3*t); t^2/4; 0.2*cos(2*t)"},
                                            {"rotation", "0.5*sin(2*t)"},
                                            {"axis", {0.0, 1.0, 0.0}}};

inline void addSpatial(Model& m) {
  m.add<Ground>("world", kWorld);
  m.add<RigidBody>("a",
                   {{"mass", 2.0}, {"inertia", {0.1, 0.2, 0.25}}, {"position", {0.0, 0.0, 1.0}}});
  m.add<RigidBody>("b", {{"mass", 1.0},
                         {"inertia", {0.1, 0.1, 0.1}},
                         {"position", {1.0, 0.2, 1.0}},
                         {"euler", {0.3, 0.2, 0.1}}});
}

inline void addPlanar(Model& m) {
  m.add<Ground>("world", kWorld);
  m.add<PlanarBody>("a", {{"mass", 2.0}, {"inertia", 0.1}, {"position", {0.0, 0.0, 1.0}}});
  m.add<PlanarBody>(
      "b", {{"mass", 1.0}, {"inertia", 0.2}, {"position", {1.0, 0.0, 1.0}}, {"angle", 0.4}});
}

inline std::unique_ptr<GivenFriction> friction() {
  return std::make_unique<GivenFriction>(1.0, 1.0);
}

/// γ against d/dt of the errors (rows without error: friction, at the end), bias against d/dt γ.
inline void expectRowsFit(Model& m, const Joint& joint, int constraintRows, int rows) {
  m.build();
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Motion motion(m);
    motion.scatter(seed);
    const Eigen::VectorXd gdot = fourPoint([&](double s) {
      const std::vector<double> e = joint.errors(motion.at(s));
      return Eigen::VectorXd(
          Eigen::Map<const Eigen::VectorXd>(e.data(), static_cast<Eigen::Index>(e.size())));
    });
    const Eigen::VectorXd gamma = motion.gamma(joint, 0.0);
    ASSERT_EQ(gdot.size(), constraintRows);
    ASSERT_EQ(gamma.size(), rows);
    EXPECT_LT((gamma.head(constraintRows) - gdot).norm(), kTolerance);
    const Eigen::VectorXd gammadot = fourPoint([&](double s) { return motion.gamma(joint, s); });
    // The direction of a distance turns with v/l: a few derivatives more than kTolerance allows.
    EXPECT_LT((motion.bias(joint) - gammadot).norm(), 10.0 * kTolerance);
  }
}

template <class T>
Joint& add(Model& m, const std::vector<GivenValue>& given, bool withFriction = false) {
  Parameters x = Parameters::of<T>("Joint", "joint", given);
  if (withFriction) x.children.push_back({Kind::law, friction()});
  return static_cast<Joint&>(m.add(std::make_unique<T>(x)));
}

}  // namespace dynamy::testing
