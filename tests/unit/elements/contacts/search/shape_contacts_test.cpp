// Contacts of shapes: gaps, rows and bias against differences, pairs and their laws.
#include <gtest/gtest.h>
#include <dynamy_elements/bodies/point_mass.hpp>
#include <dynamy_elements/laws/drilling_friction.hpp>

#include "unit/elements/contacts/shape_models.hpp"

namespace dynamy {
namespace {

using namespace testing;

TEST(ShapeContacts, OfABallOnAMovingHalfSpaceFit) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", kMoving, "HalfSpace",
                             {{"material", "steel"}, {"normal", {0.2, 0.1, 1.0}}});
  addBody<RigidBody, Sphere>(
      m, "ball", kHeavy, "Sphere",
      {{"radius", 0.3}, {"material", "rubber"}, {"position", {0.2, 0.1, 0.0}}});
  addRule(m, "rubber steel");
  expectRowsFit(m, 1, 3);
}

TEST(ShapeContacts, OfferASpinRowInSpace) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", kMoving, "HalfSpace", {{"material", "steel"}});
  addBody<RigidBody, Sphere>(
      m, "ball", kHeavy, "Sphere",
      {{"radius", 0.3}, {"material", "rubber"}, {"position", {0.2, 0.1, 0.0}}});
  addRule(m, "rubber steel", std::make_unique<UnilateralDrilling>(0.3, 0.01));
  expectRowsFit(m, 1, 4);
}

TEST(ShapeContacts, RefuseALawWithMoreRowsThanAPlaneOffers) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  addBody<PlanarBody, Sphere>(m, "ball", kPlanar, "Sphere",
                              {{"radius", 0.3}, {"material", "steel"}});
  addRule(m, "steel steel", std::make_unique<UnilateralDrilling>(0.3, 0.01));
  EXPECT_THROW(built(m), ModelError);
}

TEST(ShapeContacts, OfABoxOnAHalfSpaceFit) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", kMoving, "HalfSpace", {{"material", "steel"}});
  addBody<RigidBody, Box>(m, "box", kHeavy, "Box",
                          {{"size", {0.3, 0.4, 0.5}}, {"material", "steel"}});
  addRule(m, "steel steel");
  expectRowsFit(m, 8, 3);
}

TEST(ShapeContacts, OfAPlanarBoxHaveFourCornersAndTwoRows) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", kMoving, "HalfSpace", {{"material", "steel"}});
  addBody<PlanarBody, Box>(m, "box", kPlanar, "Box",
                           {{"size", {0.3, 0.4, 0.5}}, {"material", "steel"}});
  addRule(m, "steel steel");
  expectRowsFit(m, 4, 2);
}

TEST(ShapeContacts, OfTwoBallsFit) {
  Model space, plane;
  const Given ball{{"radius", 1.5}, {"material", "steel"}, {"position", {0.2, 0.0, 0.1}}};
  addBody<RigidBody, Sphere>(space, "a", kHeavy, "Sphere", ball);
  addBody<RigidBody, Sphere>(
      space, "b", {{"mass", 1.0}, {"inertia", {0.1, 0.1, 0.1}}, {"position", {1.5, 0.5, 2.5}}},
      "Sphere", ball);
  addRule(space, "steel steel");
  expectRowsFit(space, 1, 3);
  addBody<PlanarBody, Sphere>(plane, "a", kPlanar, "Sphere", ball);
  addBody<PlanarBody, Sphere>(
      plane, "b", {{"mass", 1.0}, {"inertia", 0.1}, {"position", {1.5, 0.0, 2.5}}}, "Sphere", ball);
  addRule(plane, "steel steel");
  expectRowsFit(plane, 1, 2);
}

/// A large ball about `at`, so that it is near wherever it is scattered, and a box of 2 × 3 × 4 m
/// about the origin.
void expectBallOnBoxFits(const Vec3& at) {
  SCOPED_TRACE(at.transpose());
  Model m;
  addBody<RigidBody, Sphere>(
      m, "ball", {{"mass", 1.0}, {"inertia", {0.1, 0.1, 0.1}}, {"position", {at[0], at[1], at[2]}}},
      "Sphere", {{"radius", 3.0}, {"material", "steel"}, {"position", {0.05, 0.0, 0.1}}});
  addBody<RigidBody, Box>(
      m, "box", {{"mass", 2.0}, {"inertia", {0.1, 0.2, 0.25}}}, "Box",
      {{"size", {2.0, 3.0, 4.0}}, {"material", "steel"}, {"position", {0.1, 0.0, 0.0}}});
  addRule(m, "steel steel");
  expectRowsFit(m, 1, 3);
}

TEST(ShapeContacts, OfABallOnABoxFit) {
  // Over a face, beside an edge, beside a corner, and with the centre inside.
  for (const Vec3& at :
       {Vec3(0.0, 0.2, 4.6), Vec3(0.3, 4.0, 4.5), Vec3(3.0, 3.5, 4.0), Vec3(0.1, 0.0, 1.2)})
    expectBallOnBoxFits(at);
  Model m;
  addBody<PlanarBody, Sphere>(m, "ball",
                              {{"mass", 1.0}, {"inertia", 0.1}, {"position", {3.5, 0.0, 4.0}}},
                              "Sphere", {{"radius", 3.0}, {"material", "steel"}});
  addBody<PlanarBody, Box>(m, "box", {{"mass", 2.0}, {"inertia", 0.1}}, "Box",
                           {{"size", {2.0, 0.1, 4.0}}, {"material", "steel"}});
  addRule(m, "steel steel");
  expectRowsFit(m, 1, 2);
}

TEST(ShapeContacts, OfABallOnABoxHaveTheGapOfTheNearestPoint) {
  // Outside: distance of the point from the box. Inside: depth below the nearest face.
  Model m;
  addBody<RigidBody, Sphere>(m, "ball", {}, "Sphere",
                             {{"radius", 0.25}, {"mass", 1.0}, {"material", "steel"}});
  addBody<Ground, Box>(m, "box", {}, "Box", {{"size", {1.0, 1.4, 0.6}}, {"material", "steel"}});
  addRule(m, "steel steel");
  const ShapeContacts& element = built(m);
  const Vec3 half(0.5, 0.7, 0.3);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Motion motion(m, 0.0);
  int seen = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Vec3 c(uniform(random), 1.2 * uniform(random), 0.7 * uniform(random));
    motion.start().q.head<3>() = c;
    const ContactSet set = motion.contacts(element, 0.0);
    const Vec3 outside = (c.cwiseAbs() - half).cwiseMax(0.0);
    const double truth = outside.isZero(0.0) ? (c.cwiseAbs() - half).maxCoeff() : outside.norm();
    if (set.size() == 0) {
      EXPECT_GT(truth - 0.25, 0.5 * (0.25 + 0.3)) << c.transpose();
      continue;
    }
    ++seen;
    EXPECT_NEAR(set.g[0], truth - 0.25, 1e-15) << c.transpose();
  }
  EXPECT_GT(seen, 200) << "seed 5";
}

TEST(ShapeContacts, SeeNoSlipOfARollingBall) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  addBody<RigidBody, Sphere>(m, "ball",
                             {{"position", {0.0, 0.0, 0.5}},
                              {"velocity", {2.0, 0.0, 0.0}},
                              {"angularVelocity", {0.0, 4.0, 0.0}}},
                             "Sphere", {{"radius", 0.5}, {"mass", 1.0}, {"material", "steel"}});
  addRule(m, "steel steel");
  const ShapeContacts& element = built(m);
  Motion motion(m, 0.0);
  EXPECT_LT(motion.gamma(element, 0.0).norm(), 1e-15);  // v = Ω R, one rounding
  EXPECT_LT(motion.gamma(element, 0.2).norm(), 1e-14);  // a few more after turning
  EXPECT_EQ(motion.contacts(element, 0.0).g[0], 0.0);
}

TEST(ShapeContacts, SlideTowardsTheFirstTangentInAPlane) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  addBody<PlanarBody, PointShape>(m, "p",
                                  {{"mass", 1.0}, {"inertia", 1.0}, {"velocity", {2.0, 0.0, -1.0}}},
                                  "Point", {{"material", "steel"}});
  addRule(m, "steel steel");
  const ShapeContacts& element = built(m);
  Motion motion(m, 0.0);
  const Eigen::VectorXd gamma = motion.gamma(element, 0.0);
  EXPECT_EQ(gamma[0], -1.0);
  EXPECT_EQ(gamma[1], 2.0);
}

TEST(ShapeContacts, DemandALawForMaterialsThatCanTouch) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  addBody<RigidBody, Sphere>(m, "ball", kHeavy, "Sphere",
                             {{"radius", 0.3}, {"material", "rubber"}});
  m.addCompletion(addShapeContacts);
  try {
    m.build();
    FAIL() << "no error";
  } catch (const ModelError& error) {
    const Diagnostic& d = error.diagnostics().at(0);
    EXPECT_EQ(d.text, "no law for contact of the materials \"steel\" and \"rubber\"");
    EXPECT_EQ(d.hint,
              "add <Contact between=\"steel rubber\">…</Contact>, or <NoContact between=\"steel "
              "rubber\"/>");
    EXPECT_EQ(d.notes.size(), 1u);
  }
}

TEST(ShapeContacts, RefuseBoxesThatAPlaneOfMotionCutsAtAnAngle) {
  Model m;
  const Given turned{{"size", {0.3, 0.4, 0.5}}, {"euler", {0.3, 0.0, 0.3}}, {"material", "steel"}};
  addBody<PlanarBody, Box>(m, "a", kPlanar, "Box", turned);
  addBody<PlanarBody, Box>(m, "b", kPlanar, "Box", turned);
  addRule(m, "steel steel");
  EXPECT_THROW(built(m), ModelError);
}

TEST(ShapeContacts, LeaveOutPairsThatAreSwitchedOff) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  addBody<RigidBody, Sphere>(m, "ball", kHeavy, "Sphere",
                             {{"radius", 0.3}, {"material", "rubber"}});
  m.add(std::make_unique<NoContactRule>(
      Parameters::of<NoContactRule>("NoContact", "", {{"between", "steel rubber"}})));
  EXPECT_EQ(built(m).pairs(), 0);
}

TEST(ShapeContacts, RefuseASecondRuleForTheSameMaterials) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  addRule(m, "steel rubber");
  addRule(m, "rubber steel");
  m.addCompletion(addShapeContacts);
  EXPECT_THROW(m.build(), ModelError);
}

TEST(ShapeContacts, SayWhichPairIsNotAvailable) {
  Model m;
  addBody<PlanarBody, TorusShape>(m, "a", kPlanar, "Torus",
                                  {{"radius", 0.3}, {"tube", 0.1}, {"material", "steel"}});
  addBody<PlanarBody, ConeShape>(m, "b", kPlanar, "Cone",
                                 {{"radius", 0.3}, {"length", 0.4}, {"material", "steel"}});
  addRule(m, "steel steel");
  m.addCompletion(addShapeContacts);
  EXPECT_THROW(m.build(), ModelError);
}

TEST(ShapeContacts, NameTheirSignalsAfterBodyAndFloor) {
  Model m;
  m.add(std::make_unique<Ground>(Parameters::of<Ground>("Ground", "world", {})
                                     .with(std::make_unique<HalfSpace>(Parameters::of<HalfSpace>(
                                         "HalfSpace", "floor", {{"material", "steel"}})))));
  addBody<RigidBody, Sphere>(m, "ball", kHeavy, "Sphere", {{"radius", 0.3}, {"material", "steel"}});
  addRule(m, "steel steel");
  built(m);
  EXPECT_NE(m.signal("ball-floor.lambda_N"), nullptr);
  EXPECT_NE(m.signal("contacts.count"), nullptr);
}

TEST(ShapeContacts, ThatAreNamedAloneComeInTheOrderOfAll) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  for (const double x : {0.0, 0.5, 1.0, 1.5})
    addBody<RigidBody, Sphere>(
        m, "ball" + std::to_string(x),
        {{"mass", 1.0}, {"inertia", {0.1, 0.1, 0.1}}, {"position", {x, 0.1 * x, 0.3}}}, "Sphere",
        {{"radius", 0.25}, {"material", "steel"}});
  addRule(m, "steel steel");
  const ShapeContacts& element = built(m);
  Motion motion(m);
  const auto report = [&](std::span<const ContactKey> keys, bool alone) {
    ContactSet set;
    set.clear();
    ContactRequest request;
    request.refresh = request.follow = true, request.frozen = keys, request.alone = alone;
    ContactSink sink(set, request);
    element.contacts(motion.at(0.0), sink);
    return set;
  };
  const std::vector<ContactKey> all = report({}, false).candidateKey;
  ASSERT_EQ(all.size(), 4u + 6u);
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      std::vector<ContactKey> wanted{std::min(all[i], all[j]), std::max(all[i], all[j])};
      const ContactSet set = report(wanted, true);
      EXPECT_EQ(set.candidateKey, (std::vector<ContactKey>{all[i], all[j]}));
      EXPECT_EQ(set.key, set.candidateKey);
    }
}

}  // namespace
}  // namespace dynamy
