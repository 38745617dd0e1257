// Bodies: frames against differences of their positions, masses of shapes against slices.
#include <gtest/gtest.h>
#include <dynamy/core/rotation.hpp>
#include <dynamy_elements/bodies/ground.hpp>
#include <dynamy_elements/bodies/planar_body.hpp>
#include <dynamy_elements/bodies/point_mass.hpp>
#include <dynamy_elements/bodies/rigid_body.hpp>
#include <dynamy_elements/contacts/shapes/round_shapes.hpp>
#include <dynamy_elements/contacts/shapes/shapes.hpp>

#include <numbers>
#include <utility>

#include "unit/elements/motion.hpp"

namespace dynamy {
namespace {

using testing::fourPoint;
using testing::kTolerance;
using testing::Motion;

std::unique_ptr<NamedFrame> tip() {
  return std::make_unique<NamedFrame>(Parameters::of<NamedFrame>(
      "Frame", "tip", {{"position", {0.3, -0.2, 0.5}}, {"euler", {0.4, 0.3, -0.9}}}));
}

template <class T>
void addWithTip(Model& m, const std::string& name, const std::vector<GivenValue>& given) {
  m.add(std::make_unique<T>(Parameters::of<T>(name, name, given).with(tip())));
}

/// All frames of one system against differences.
void expectFramesFit(Model& m, unsigned seed) {
  m.build();
  SCOPED_TRACE("seed " + std::to_string(seed));
  Topology& topology = m.topology();
  std::vector<FrameHandle> frames;
  for (int id = 0; id < m.systems()[0]->frames(); ++id)
    frames.push_back(topology.frame(topology.system(0), id));
  Motion motion(m);
  motion.scatter(seed);
  for (const FrameHandle handle : frames) {
    const Frame f = motion.at(0.0).frame(handle);
    const Eigen::VectorXd u = motion.start().u;
    const Vec3 v = fourPoint([&](double s) { return motion.at(s).frame(handle).r_OS_I; });
    EXPECT_LT((v - f.v_S_I).norm(), kTolerance);
    motion.at(0.0);
    const Frame& g = motion.at(0.0).frame(handle);
    EXPECT_LT((g.J_S_I * u + g.nu_S_I - g.v_S_I).norm(), 1e-13);  // a dozen roundings
    EXPECT_LT((g.J_R_I * u + g.nu_R_I - g.Omega_I).norm(), 1e-13);
    const Eigen::VectorXd Adot = fourPoint([&](double s) {
      const Mat3 A = motion.at(s).frame(handle).A_IK;
      return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(A.data(), 9));
    });
    const Mat3 OmegaA = skew(f.Omega_I) * f.A_IK;
    EXPECT_LT((Adot - Eigen::Map<const Eigen::VectorXd>(OmegaA.data(), 9)).norm(), kTolerance);
    const Vec3 a = fourPoint([&](double s) { return motion.at(s).frame(handle).v_S_I; });
    const Vec3 alpha = fourPoint([&](double s) { return motion.at(s).frame(handle).Omega_I; });
    EXPECT_LT((a - f.bias_S_I).norm(), kTolerance);
    EXPECT_LT((alpha - f.bias_R_I).norm(), kTolerance);
  }
}

/// The signals of the frame "tip" of one body against the frame that kinematics give.
void expectSignalsOfTip(Model& m, const std::string& body, const std::string& moving) {
  m.build();
  Motion motion(m);
  motion.scatter(7);
  const FrameHandle handle = m.topology().frame(m.topology().system(0), 1);
  const Frame f = motion.at(0.0).frame(handle);
  const State& x = motion.start();
  const SignalView view{.q = dynamy::view(x.q), .u = dynamy::view(x.u)};
  for (const char axis : moving)
    for (const bool rate : {false, true}) {
      const NamedSignal* s = m.signal(body + ".tip." + (rate ? "v" : "") + axis);
      ASSERT_NE(s, nullptr) << body << axis;
      // A dozen roundings of numbers below 10.
      EXPECT_NEAR(s->signal.value(view), (rate ? f.v_S_I : f.r_OS_I)[axis - 'x'], 2e-14);
    }
}

TEST(NamedFrame, HasPositionAndVelocityAsSignals) {
  Model rigid, planar, point;
  Parameters x = Parameters::of<RigidBody>("RigidBody", "body", {{"euler", {0.2, 0.1, 0.3}}});
  auto shape = std::make_unique<Box>(Parameters::of<Box>(
      "Box", "", {{"size", {0.1, 0.2, 0.3}}, {"mass", 1.0}, {"position", {0.4, 0.1, -0.2}}}));
  rigid.add(std::make_unique<RigidBody>(std::move(x).with(std::move(shape)).with(tip())));
  expectSignalsOfTip(rigid, "body", "xyz");
  addWithTip<PlanarBody>(planar, "plate", {{"mass", 2.0}, {"inertia", 0.1}});
  expectSignalsOfTip(planar, "plate", "xz");
  addWithTip<PointMass>(point, "mass", {{"mass", 2.0}, {"plane", "xy"}});
  expectSignalsOfTip(point, "mass", "xy");
}

TEST(RigidBody, HasFramesThatFitTheirDifferences) {
  Model m;
  addWithTip<RigidBody>(m, "body", {{"mass", 2.0}, {"inertia", {0.1, 0.2, 0.25}}});
  expectFramesFit(m, 1);
}

TEST(RigidBody, HasFramesThatFitAlsoWithItsCentreOfMassElsewhere) {
  Model m;
  Parameters x = Parameters::of<RigidBody>("RigidBody", "body", {{"euler", {0.2, 0.1, 0.3}}});
  auto shape = std::make_unique<Box>(Parameters::of<Box>(
      "Box", "", {{"size", {0.1, 0.2, 0.3}}, {"mass", 1.0}, {"position", {0.4, 0.1, -0.2}}}));
  m.add(std::make_unique<RigidBody>(std::move(x).with(std::move(shape)).with(tip())));
  expectFramesFit(m, 2);
}

TEST(PlanarBody, HasFramesThatFitTheirDifferences) {
  for (const char* plane : {"xz", "xy", "yz"}) {
    Model m;
    addWithTip<PlanarBody>(m, "body", {{"mass", 2.0}, {"inertia", 0.1}, {"plane", plane}});
    expectFramesFit(m, 3);
  }
}

TEST(PointMass, HasFramesThatFitTheirDifferences) {
  for (const char* plane : {"none", "xz", "xy", "yz"}) {
    Model m;
    addWithTip<PointMass>(m, "body",
                          {{"mass", 2.0}, {"plane", plane}, {"position", {1.0, 2.0, 3.0}}});
    expectFramesFit(m, 4);
  }
}

TEST(Ground, MovesAsItsFormulasSay) {
  Model m;
  addWithTip<Ground>(m, "table",
                     {{"motion", "0.1*sin(3*t); t^2; cos(2*t)"},
                      {"rotation", "0.5*sin(2*t)"},
                      {"axis", {1.0, 2.0, 0.5}},
                      {"euler", {0.1, 0.2, 0.3}}});
  expectFramesFit(m, 5);
}

TEST(PlanarBody, TurnsItsFirstAxisTowardsTheSecond) {
  Model m;
  m.add<PlanarBody>("body", {{"mass", 1.0}, {"inertia", 1.0}, {"angle", 0.5 * std::numbers::pi}});
  m.build();
  const FrameHandle f = m.topology().frame(m.topology().system(0), 0);
  Motion motion(m);
  // x of the body points to z; rounding of a cosine.
  EXPECT_LT((motion.at(0.0).frame(f).A_IK.col(0) - Vec3::UnitZ()).norm(), 1e-15);
}

TEST(RigidBody, HasGyroscopicForcesWithoutPower) {
  const auto body = std::make_unique<RigidBody>(
      Parameters::of<RigidBody>("RigidBody", "b", {{"mass", 2.0}, {"inertia", {0.1, 0.2, 0.25}}}));
  Eigen::VectorXd q(7), u(6), h(6);
  q << 0, 0, 0, 1, 0, 0, 0;
  u << 1, 2, 3, -2, 0.5, 3;
  body->h(0.0, view(std::as_const(q)), view(std::as_const(u)), view(h));
  EXPECT_NEAR(h.dot(u), 0.0, 1e-15);  // products of size 2 cancel
  // Euler's equations: −Ω × JΩ, first component (J2 − J3) Ω2 Ω3 = −0.05 · 1.5.
  EXPECT_NEAR(h[3], -0.075, 1e-15);
}

TEST(RigidBody, TakesMassAndCentreFromItsShapes) {
  // Two boxes side by side are one box of double length.
  const auto half = [](double x) {
    return std::make_unique<Box>(Parameters::of<Box>(
        "Box", "", {{"size", {0.5, 0.2, 0.3}}, {"density", 1000.0}, {"position", {x, 0.0, 0.0}}}));
  };
  const RigidBody two(
      Parameters::of<RigidBody>("RigidBody", "b", {}).with(half(0.75)).with(half(1.25)));
  const Box whole(Parameters::of<Box>("Box", "", {{"size", {1.0, 0.2, 0.3}}}));
  Eigen::VectorXd q(7), u(6), data(36);
  two.initialState(view(q), view(u));
  two.M(0.0, view(std::as_const(q)), MassBlocks(data.data(), 6, 1));
  EXPECT_NEAR(q[0], 1.0, 1e-15);
  EXPECT_NEAR(data[0], 60.0, 1e-12);  // 1000 · 0.06 to rounding
  const Eigen::Map<RowMatrix> M(data.data(), 6, 6);
  const Mat3 J = M.bottomRightCorner<3, 3>(), expected = 1000.0 * whole.massProperties().inertia_B;
  EXPECT_LT((J - expected).norm(), 1e-13);  // numbers of size 5
}

TEST(RigidBody, RefusesImpossibleMasses) {
  EXPECT_THROW(RigidBody(Parameters::of<RigidBody>("RigidBody", "b", {})), ModelError);
  EXPECT_THROW(RigidBody(Parameters::of<RigidBody>("RigidBody", "b", {{"mass", 1.0}})), ModelError);
  EXPECT_THROW(RigidBody(Parameters::of<RigidBody>("RigidBody", "b",
                                                   {{"mass", 1.0}, {"inertia", {1.0, 1.0, 3.0}}})),
               ModelError);
  EXPECT_THROW(RigidBody(Parameters::of<RigidBody>("RigidBody", "b",
                                                   {{"mass", 1.0}, {"inertia", {1.0, 1.0}}})),
               ModelError);
}

template <class T>
std::string refusal(const std::vector<GivenValue>& given) {
  try {
    T body(Parameters::of<T>("Body", "b", given));
  } catch (const ModelError& e) {
    return e.diagnostics().at(0).text;
  }
  return "none";
}

/// "none", or why a body of point masses of 0.1, 0.2, … kg at `places` is refused.
template <class T>
std::string refusalOfPoints(const std::vector<Vec3>& places) {
  Parameters x = Parameters::of<T>("Body", "b", {});
  double m = 0.0;
  for (const Vec3& r : places)
    x.children.push_back({Kind::shape, std::make_unique<PointShape>(Parameters::of<PointShape>(
                                           "Point", "", {{"position", r}, {"mass", m += 0.1}}))});
  try {
    const T body(std::move(x));
  } catch (const ModelError& e) {
    return e.diagnostics().at(0).text;
  }
  return "none";
}
constexpr const char* kNoInertia = "the body's shapes have mass but no inertia";

TEST(RigidBody, RefusesPointsOnALineInAnyDirection) {
  // Rounding gives the moment about the line either sign; the motion about it would be rounding.
  for (int i = 0; i < 200; ++i) {
    const Vec3 d(std::sin(1.0 + i), std::sin(2.0 + 3.0 * i), std::sin(5.0 * i)), r(0.1, -0.7, i);
    EXPECT_EQ(refusalOfPoints<RigidBody>({d, -d}), kNoInertia) << i;
    EXPECT_EQ(refusalOfPoints<RigidBody>({r + d, r - 0.3 * d, r + 0.7 * d}), kNoInertia) << i;
  }
  EXPECT_EQ(refusalOfPoints<RigidBody>({{0.1, 0.1, 1}, {0.1, 0.1, 2}, {0.1, 0.1, 4}}), kNoInertia);
  EXPECT_EQ(refusal<RigidBody>({{"mass", 1.0}, {"inertia", "2 2 2 -1 -1 -1"}}),
            "inertia=\"2 2 2 -1 -1 -1\": the inertia is not positive");
}

TEST(RigidBody, TakesThinAndTinyBodiesWhoseInertiaIsToldByTheirNumbers) {
  // 1 µm beside 1 m: a moment of 1e-12 of the largest, and a grain of 1e-120 kg m².
  EXPECT_EQ(refusalOfPoints<RigidBody>({{0.6, 0, 0.8}, {-0.6, 0, -0.8}, {1e-6, 1e-6, 0}}), "none");
  EXPECT_EQ(refusal<RigidBody>({{"mass", 1e-100}, {"inertia", "1e-120 1e-120 1e-120"}}), "none");
  EXPECT_EQ(refusal<RigidBody>({{"mass", 1.0}, {"inertia", "1e-20 1 1"}}), "none");
  Parameters tiny = Parameters::of<RigidBody>("RigidBody", "b", {});
  tiny.children.push_back({Kind::shape, std::make_unique<Sphere>(Parameters::of<Sphere>(
                                            "Sphere", "", {{"radius", 1e-10}, {"mass", 1e-100}}))});
  EXPECT_NO_THROW(RigidBody(std::move(tiny)));
}

TEST(PlanarBody, RefusesPointsAtOnePlace) {
  for (int i = 0; i < 50; ++i) {
    const Vec3 r(std::sin(1.0 + i), 0.0, std::sin(3.0 * i));
    EXPECT_EQ(refusalOfPoints<PlanarBody>({r, r, r}), kNoInertia) << i;
  }
}

template <class T>
class BodyWithMass : public ::testing::Test {};
using BodiesWithMass = ::testing::Types<RigidBody, PlanarBody>;
TYPED_TEST_SUITE(BodyWithMass, BodiesWithMass);

TYPED_TEST(BodyWithMass, SaysWhatIsMissing) {
  const std::string J = std::is_same_v<TypeParam, RigidBody> ? "1 1 1" : "1";
  EXPECT_EQ(refusal<TypeParam>({}), "the body has no mass");
  EXPECT_EQ(refusal<TypeParam>({{"mass", 1.0}}), "the body has a mass but no inertia");
  EXPECT_EQ(refusal<TypeParam>({{"inertia", J}}),
            "inertia=\"" + J + "\": an inertia needs a mass beside it");
  EXPECT_EQ(refusal<TypeParam>({{"mass", 1.0}, {"inertia", J}}), "none");
}

TEST(PlanarBody, RefusesVelocitiesOutOfItsPlane) {
  EXPECT_THROW(
      PlanarBody(Parameters::of<PlanarBody>(
          "PlanarBody", "b", {{"mass", 1.0}, {"inertia", 1.0}, {"velocity", {0.0, 1.0, 0.0}}})),
      ModelError);
}

// ---- shapes ------------------------------------------------------------------------------------

/// Solids of revolution from discs of radius rho(z): V = ∫ π ρ², J_z = ∫ π ρ⁴/2, J_x = ∫ π ρ⁴/4 +
/// π ρ² z².
MassProperties slices(const std::function<double(double)>& rho, double halfLength) {
  constexpr int n = 200000;
  MassProperties out;
  const double dz = 2.0 * halfLength / n;
  for (int i = 0; i < n; ++i) {
    const double z = -halfLength + (i + 0.5) * dz, r2 = rho(z) * rho(z);
    const double disc = std::numbers::pi * r2 * dz;
    out.volume += disc;
    out.inertia_B(2, 2) += 0.5 * disc * r2;
    out.inertia_B(0, 0) += disc * (0.25 * r2 + z * z);
  }
  out.inertia_B(1, 1) = out.inertia_B(0, 0);
  return out;
}

void expectEqual(const MassProperties& a, const MassProperties& b) {
  // Midpoint rule with 2e5 slices of smooth ρ²: relative error 1/(24 n²) times a few, and sums of
  // 2e5 terms to 1e-13.
  EXPECT_NEAR(a.volume / b.volume, 1.0, 1e-9);
  EXPECT_LT((a.inertia_B - b.inertia_B).norm() / b.inertia_B.norm(), 1e-9);
}

TEST(Shapes, HaveTheVolumeAndInertiaOfTheirSlices) {
  const double R = 0.3, l = 0.7;
  const Sphere sphere(Parameters::of<Sphere>("Sphere", "", {{"radius", R}}));
  expectEqual(sphere.massProperties(),
              slices([=](double z) { return std::sqrt(R * R - z * z); }, R));
  const CylinderShape cylinder(
      Parameters::of<CylinderShape>("Cylinder", "", {{"radius", R}, {"length", l}}));
  expectEqual(cylinder.massProperties(), slices([=](double) { return R; }, 0.5 * l));
  const CapsuleShape capsule(
      Parameters::of<CapsuleShape>("Capsule", "", {{"radius", R}, {"length", l}}));
  expectEqual(capsule.massProperties(), slices(
                                            [=](double z) {
                                              const double over =
                                                  std::max(std::abs(z) - 0.5 * l, 0.0);
                                              return std::sqrt(R * R - over * over);
                                            },
                                            0.5 * l + R));
}

TEST(Shapes, ATubeIsACylinderWithoutAnother) {
  const auto mass = [](double radius, double bore) {
    return CylinderShape(Parameters::of<CylinderShape>(
                             "Cylinder", "", {{"radius", radius}, {"length", 0.7}, {"bore", bore}}))
        .massProperties();
  };
  const MassProperties tube = mass(0.3, 0.2), whole = mass(0.3, 0.0), hole = mass(0.2, 0.0);
  // A few roundings of numbers below 1.
  EXPECT_NEAR(tube.volume, whole.volume - hole.volume, 1e-16);
  EXPECT_LT((tube.inertia_B - whole.inertia_B + hole.inertia_B).norm(), 1e-16);
  EXPECT_THROW(mass(0.2, 0.2), ModelError);
}

TEST(Shapes, RefuseMassAndDensityTogether) {
  EXPECT_THROW(Sphere(Parameters::of<Sphere>("Sphere", "",
                                             {{"radius", 1.0}, {"mass", 1.0}, {"density", 1.0}})),
               ModelError);
}

TEST(Shapes, RefuseTwoOrientations) {
  EXPECT_THROW(
      Sphere(Parameters::of<Sphere>(
          "Sphere", "",
          {{"radius", 1.0}, {"orientation", {1.0, 0.0, 0.0, 0.0}}, {"euler", {0.1, 0.0, 0.0}}})),
      ModelError);
}

TEST(Orientation, TurnsAboutTheFixedAxesOneAfterTheOther) {
  const double a = 0.3, b = -0.5, c = 0.8;
  const Sphere s(Parameters::of<Sphere>("Sphere", "", {{"radius", 1.0}, {"euler", {a, b, c}}}));
  Mat3 X, Y, Z;
  X << 1, 0, 0, 0, std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a);
  Y << std::cos(b), 0, std::sin(b), 0, 1, 0, -std::sin(b), 0, std::cos(b);
  Z << std::cos(c), -std::sin(c), 0, std::sin(c), std::cos(c), 0, 0, 0, 1;
  EXPECT_LT((s.A_KB() - Z * Y * X).norm(), 1e-15 * 10);  // ten roundings of numbers below 1
}

}  // namespace
}  // namespace dynamy
