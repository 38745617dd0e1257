/// Models of two bodies whose shapes touch, and whether the rows of their contacts fit the motion.
#pragma once
#include <gtest/gtest.h>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy_elements/bodies/ground.hpp>
#include <dynamy_elements/bodies/planar_body.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>
#include <dynamy_elements/contacts/search/shape_contacts.hpp>
#include <dynamy_elements/contacts/shapes/round_shapes.hpp>
#include <dynamy_elements/contacts/shapes/shapes.hpp>

#include "unit/elements/motion.hpp"

namespace dynamy::testing {

using Given = std::vector<GivenValue>;

template <class Body, class S>
void addBody(Model& m, const std::string& name, const Given& body, const std::string& shapeType,
             const Given& shape) {
  m.add(std::make_unique<Body>(
      Parameters::of<Body>("Body", name, body)
          .with(std::make_unique<S>(Parameters::of<S>(shapeType, "", shape)))));
}

inline void addRule(
    Model& m, const char* between,
    std::unique_ptr<SetValuedForceLaw> law = std::make_unique<UnilateralCoulomb>(0.0, 0.0, 0.3)) {
  m.add(std::make_unique<ContactRule>(
      Parameters::of<ContactRule>("Contact", "", {{"between", between}}).with(std::move(law))));
}

inline const Given kMoving{{"motion", "0.1*sin(3*t); 0; 0.2*cos(2*t)"},
                           {"rotation", "0.5*sin(2*t)"},
                           {"axis", {0.0, 1.0, 0.0}}};
inline const Given kHeavy{
    {"mass", 2.0}, {"inertia", {0.1, 0.2, 0.25}}, {"position", {0.1, 0.2, 1.0}}};
inline const Given kPlanar{{"mass", 2.0}, {"inertia", 0.1}, {"position", {0.1, 0.0, 1.0}}};

inline const ShapeContacts& built(Model& m) {
  m.addCompletion(addShapeContacts);
  m.build();
  return static_cast<const ShapeContacts&>(*m.contacts().at(0));
}

/// γ_N against ġ and the bias of all rows against γ̇.
inline void expectRowsFit(Model& m, int contacts, int dim) {
  const ShapeContacts& element = built(m);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Motion motion(m);
    motion.scatter(seed, 0.5);
    const ContactSet set = motion.contacts(element, 0.0);
    ASSERT_EQ(set.size(), contacts);
    const Eigen::VectorXd gamma = motion.gamma(element, 0.0);
    ASSERT_EQ(gamma.size(), contacts * dim);
    const Eigen::VectorXd gdot = fourPoint([&](double s) {
      const ContactSet at = motion.contacts(element, s);
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(at.g.data(), contacts));
    });
    for (int i = 0; i < contacts; ++i) EXPECT_NEAR(gamma[i * dim], gdot[i], kTolerance);
    const Eigen::VectorXd gammadot = fourPoint([&](double s) { return motion.gamma(element, s); });
    // Normals of balls turn with up to v/|r|, which takes a few derivatives beyond kTolerance.
    EXPECT_LT((motion.bias(element) - gammadot).norm(), 10.0 * kTolerance);
  }
}

}  // namespace dynamy::testing
