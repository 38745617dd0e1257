// What a diagnosis says of problems whose peculiarity is known: Painlevé's rod, a wedge, a table,
// over-constrained joints, arches.
#include <gtest/gtest.h>

#include <cmath>
#include <dynamy/solver/automatic.hpp>
#include <dynamy/solver/diagnosis/diagnosis.hpp>

#include "unit/solver/planar_scene.hpp"

namespace dynamy {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using fixture::PlanarScene;

struct Asked {
  SolveReport report;
  VectorXd Lambda;
  Diagnosis diagnosis;
};

Asked ask(const InclusionProblem& p, DiagnosisOptions options = {}) {
  Asked out;
  Automatic solver({.tolerance = options.tolerance});
  out.Lambda.setZero(p.rows());
  out.report = solver.solve(p, view(out.Lambda));
  out.diagnosis = diagnose(p, {out.Lambda.data(), out.Lambda.size()}, out.report, solver, options);
  return out;
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Homogeneous slender rod of length 2 at the angle θ, its lower tip on the ground:
/// G_NN = 1 + 3 cos²θ, G_NT = 3 sinθ cosθ.
PlanarScene rod(const SetValuedForceLaw& law, double tangent) {
  const double theta = std::atan(tangent);
  PlanarScene scene({{1.0, 1.0 / 3.0, {0.0, 0.0}}});
  scene.contact(law, 0, -1, {std::cos(theta), -std::sin(theta)}, Vector2d::UnitY());
  return scene;
}

TEST(Diagnosis, NamesPainlevesRodJustAboveFourThirds) {
  // The first angle at which it can happen is tan θ = 2, at μ = 4/3 [published].
  for (const double mu : {1.33, 4.0 / 3.0 + 1e-3}) {
    const UnilateralCoulomb law(0.0, 0.0, mu);
    PlanarScene scene = rod(law, 2.0);
    DiagnosisOptions options;
    options.name = [](int) { return "the tip"; };
    const Asked a = ask(scene.pose(Vector2d(-1.0, 0.5)), options);
    const Finding* f = a.diagnosis.find(FindingKind::painleve);
    EXPECT_EQ(f != nullptr, mu > 4.0 / 3.0) << mu;
    if (!f) continue;
    EXPECT_NEAR(f->value, 0.75 * mu, 1e-12);  // μ 3 sin cos/(1 + 3 cos²)
    EXPECT_EQ(f->contacts, std::vector<int>{0});
    EXPECT_TRUE(says(f->text, "Painleve's paradox is possible at the tip")) << f->text;
  }
}

TEST(Diagnosis, FindsTheSolutionsOfPainlevesRod) {
  const UnilateralCoulomb law(0.0, 0.0, 2.0);
  PlanarScene scene = rod(law, 2.0);
  // Leaving slowly and sliding so that friction presses: it may leave, or catch.
  for (const double normal : {0.1, -0.1}) {
    const Asked a = ask(scene.pose(Vector2d(normal, -1.0)));
    const Asked b = ask(scene.pose(Vector2d(normal, 1.0)));
    for (const Asked* x : {&a, &b}) EXPECT_NE(x->diagnosis.find(FindingKind::painleve), nullptr);
    const Finding* f = b.diagnosis.find(FindingKind::severalSolutions);
    ASSERT_EQ(f != nullptr, normal > 0.0) << normal;
    if (!f) continue;
    EXPECT_TRUE(says(f->text, "opens")) << f->text;
    EXPECT_TRUE(says(f->text, "sticks")) << f->text;
    EXPECT_EQ(a.diagnosis.find(FindingKind::severalSolutions), nullptr);
  }
}

TEST(Diagnosis, NamesTheContactsOfAJam) {
  // A disc between two walls that enclose 2·15°: forces along the line between the contacts are in
  // both friction cones if tan 15° < μ.
  for (const double mu : {0.25, 0.3}) {
    const UnilateralCoulomb law(0.0, 0.0, mu);
    const double angle = 15.0 * std::acos(-1.0) / 180.0;
    PlanarScene scene({{1.0, 0.5, {0.0, 0.0}}, {1.0, 1.0, {10.0, 0.0}}});
    const Vector2d n(std::cos(angle), std::sin(angle));
    scene.contact(law, 1, -1, {10.0, -1.0}, Vector2d::UnitY());  // has nothing to do with it
    scene.contact(law, 0, -1, -n, n);
    scene.contact(law, 0, -1, {n.x(), -n.y()}, {-n.x(), n.y()});
    const Asked a = ask(scene.fall(0.0, -0.01));
    const Finding* f = a.diagnosis.find(FindingKind::jam);
    ASSERT_EQ(f != nullptr, mu > std::tan(angle)) << mu;
    if (!f) continue;
    EXPECT_EQ(f->contacts.size(), 2U);
    EXPECT_TRUE(says(f->text, "Jam: contact 1 and contact 2 can hold each other")) << f->text;
  }
}

TEST(Diagnosis, SaysThatASqueezedBodyHasNoSolution) {
  const Unilateral law;
  PlanarScene scene({{1.0, 1.0, {0.0, 0.0}}});
  scene.contact(law, 0, -1, {-1.0, 0.0}, Vector2d::UnitX());
  scene.contact(law, 0, -1, {1.0, 0.0}, -Vector2d::UnitX());
  const Asked a = ask(scene.pose(Vector2d(-1.0, -0.5)));  // both walls move inward
  EXPECT_FALSE(a.report.ok());
  // Of a body of 1 kg and walls of 1 m/s; percussions of 1e16 N s would leave smaller residuals, by rounding.
  EXPECT_LT(a.Lambda.cwiseAbs().maxCoeff(), 1e12);
  ASSERT_GE(a.diagnosis.findings.size(), 2U);
  EXPECT_EQ(a.diagnosis.findings[0].kind, FindingKind::unsolved);
  EXPECT_TRUE(says(a.diagnosis.findings[0].text, "Tried: sweeps (")) << a.diagnosis.text();
  const Finding* f = a.diagnosis.find(FindingKind::contradiction);
  ASSERT_NE(f, nullptr);
  EXPECT_TRUE(says(f->text, "squeezed")) << f->text;
  EXPECT_EQ(f->contacts.size(), 2U);
  EXPECT_TRUE(says(a.diagnosis.text(), "Proven by pivoting: no forces")) << a.diagnosis.text();
}

TEST(Diagnosis, CountsTheForcesOfATableThatAreNotUnique) {
  const UnilateralCoulomb law(0.0, 0.0, 0.5);
  fixture::Inclusion table({MatrixXd::Identity(6, 6)});
  for (int leg = 0; leg < 4; ++leg) {
    const double x = (leg & 1) ? 0.5 : -0.5, y = (leg & 2) ? 0.4 : -0.4, z = -0.7;
    MatrixXd Wt(3, 6);  // rows z, x, y at the foot
    Wt << 0, 0, 1, y, -x, 0, 1, 0, 0, 0, z, -y, 0, 1, 0, -z, 0, x;
    table.contact(law, Wt);
  }
  VectorXd c = VectorXd::Zero(12);
  for (int leg = 0; leg < 4; ++leg) c[3 * leg] = -9.81e-3;
  const Asked a = ask(table.pose(c));
  EXPECT_TRUE(a.report.ok());
  EXPECT_EQ(a.diagnosis.rank, 6);
  EXPECT_EQ(a.diagnosis.rows, 12);
  EXPECT_EQ(a.diagnosis.freedom, 6);  // it rests: every foot's force lies inside of its cone
  EXPECT_EQ(a.diagnosis.find(FindingKind::jam), nullptr) << "legs cannot press against each other";
  const Finding* f = a.diagnosis.find(FindingKind::forcesNotUnique);
  ASSERT_NE(f, nullptr);
  EXPECT_TRUE(says(f->text, "rank 6 of 12 rows")) << f->text;
}

/// Three equal parallel links of length 1, a beam over all of them: one link is too many.
PlanarScene overConstrained() {
  PlanarScene scene({{1.0, 0.1, {0.0, 0.5}},
                     {1.0, 0.1, {1.0, 0.5}},
                     {1.0, 0.1, {2.0, 0.5}},
                     {2.0, 0.5, {1.0, 1.0}}});
  for (int link = 0; link < 3; ++link) {
    scene.joint(link, -1, {static_cast<double>(link), 0.0});
    scene.joint(3, link, {static_cast<double>(link), 1.0});
  }
  return scene;
}

TEST(Diagnosis, NamesRedundantJoints) {
  PlanarScene scene = overConstrained();
  const Asked a = ask(scene.fall(0.3, -1.0));
  EXPECT_TRUE(a.report.ok());
  EXPECT_EQ(a.diagnosis.rank, 11);
  const Finding* f = a.diagnosis.find(FindingKind::redundantJoints);
  ASSERT_NE(f, nullptr);
  EXPECT_TRUE(says(f->text, "Over-constrained: 1 of 12 joint equations")) << f->text;
  EXPECT_EQ(f->contacts.size(), 6U);
  EXPECT_EQ(a.diagnosis.find(FindingKind::contradiction), nullptr);
}

TEST(Diagnosis, NamesJointsThatContradictEachOther) {
  PlanarScene scene = overConstrained();
  VectorXd c = VectorXd::Zero(12);
  c[1] = 0.1;  // one foot is pushed upward
  const Asked a = ask(scene.pose(c));
  EXPECT_FALSE(a.report.ok());
  const Finding* f = a.diagnosis.find(FindingKind::contradiction);
  ASSERT_NE(f, nullptr) << a.diagnosis.text();
  EXPECT_TRUE(says(f->text, "No motion fulfils all joints")) << f->text;
}

/// Stones between abutments, each joint a face of height 1 with two corners; centres of the faces
/// on a circle around (0, −radius) at angles ±span/2.
PlanarScene arch(const SetValuedForceLaw& law, int stones, double radius, double span) {
  const auto ray = [](double angle) { return Vector2d(std::sin(angle), std::cos(angle)); };
  const Vector2d centre(0.0, -radius);
  std::vector<fixture::PlanarBody> bodies;
  for (int k = 0; k < stones; ++k)
    bodies.push_back({1.0, 0.2, centre + radius * ray(span * ((k + 0.5) / stones - 0.5))});
  PlanarScene scene(bodies);
  for (int k = 0; k <= stones; ++k) {
    const double angle = span * (static_cast<double>(k) / stones - 0.5);
    const Vector2d normal(std::cos(angle), -std::sin(angle));
    for (const double height : {-0.5, 0.5}) {
      const Vector2d corner = centre + (radius + height) * ray(angle);
      if (k < stones)
        scene.contact(law, k, k - 1, corner, normal);
      else
        scene.contact(law, k - 1, -1, corner, -normal);
    }
  }
  return scene;
}

TEST(Diagnosis, TellsAFlatArchThatJamsFromARoundOneThatDoesNot) {
  const UnilateralCoulomb law(0.0, 0.0, 0.7);
  // Flat: the rise of the face centres, 20 (1 − cos 0.15) = 0.22, is less than a face: a straight
  // line of thrust fits in. Round: a half circle of radius 4.
  PlanarScene flat = arch(law, 3, 20.0, 0.3), round = arch(law, 7, 4.0, 3.0);
  const Asked a = ask(flat.fall(0.0, -0.01)), b = ask(round.fall(0.0, -0.01));
  EXPECT_NE(a.diagnosis.find(FindingKind::jam), nullptr) << a.diagnosis.text();
  EXPECT_EQ(b.diagnosis.find(FindingKind::jam), nullptr) << b.diagnosis.text();
  EXPECT_TRUE(b.report.ok()) << b.diagnosis.text();
  EXPECT_NE(b.diagnosis.find(FindingKind::forcesNotUnique), nullptr) << b.diagnosis.text();
}

TEST(Diagnosis, SaysNothingOfARegularProblem) {
  std::mt19937 random(5);
  const UnilateralCoulomb law(0.0, 0.0, 0.3);
  fixture::Inclusion scene({fixture::randomMass(random, 12)});
  for (int i = 0; i < 3; ++i) scene.contact(law, fixture::randomMatrix(random, 3, 12));
  VectorXd c = fixture::randomMatrix(random, 9, 1);
  for (int i = 0; i < 3; ++i) c[3 * i] = -1.0;
  const Asked a = ask(scene.pose(c));
  EXPECT_TRUE(a.report.ok());
  EXPECT_TRUE(a.diagnosis.findings.empty()) << a.diagnosis.text();
  EXPECT_EQ(a.diagnosis.rank, a.diagnosis.rows);
}

TEST(Diagnosis, LeavesLargeProblemsAlone) {
  const Unilateral law;
  fixture::Inclusion scene({MatrixXd::Identity(3, 3)});
  for (int i = 0; i < 5; ++i) scene.contact(law, MatrixXd::Ones(1, 3));
  DiagnosisOptions options;
  options.maxRows = 4;
  const Asked a = ask(scene.pose(-VectorXd::Ones(5)), options);
  EXPECT_NE(a.diagnosis.find(FindingKind::tooLarge), nullptr);
  EXPECT_EQ(a.diagnosis.rank, -1);
}

}  // namespace
}  // namespace dynamy
