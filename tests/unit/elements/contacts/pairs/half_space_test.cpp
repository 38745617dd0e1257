// Round shapes over half spaces: gap against a search over their surfaces, rows against
// differences, mass properties against quadrature.
#include <dynamy/core/rotation.hpp>
#include <numbers>

#include "unit/elements/contacts/shape_models.hpp"

namespace dynamy {
namespace {

using namespace testing;

/// A surface r(a, b), 0 ≤ a, b ≤ 2π, in axes of the shape.
using SurfaceFormula = std::function<Vec3(double, double)>;

/// Least height n·r over the surface: a grid, then finer and finer ones about its lowest point.
/// Each of the 12 zooms by 10 makes the grid spacing 2π/60 so much smaller; heights are flat at a
/// minimum, so 1e-14 is reached long before.
double lowest(const SurfaceFormula& surface, const Vec3& n) {
  constexpr int kGrid = 60;
  double a0 = 0.0, b0 = 0.0, width = 2.0 * std::numbers::pi, best = 1e300;
  for (int zoom = 0; zoom < 12; ++zoom, width *= 0.1) {
    double a1 = a0, b1 = b0;
    for (int i = 0; i <= kGrid; ++i)
      for (int j = 0; j <= kGrid; ++j) {
        const double a = a0 + width * (i / double(kGrid) - 0.5),
                     b = b0 + width * (j / double(kGrid) - 0.5);
        if (const double h = n.dot(surface(a, b)); h < best) best = h, a1 = a, b1 = b;
      }
    a0 = a1, b0 = b1;
  }
  return best;
}

/// Smallest gap of a body with the shape at random attitudes over z = 0.
template <class S>
void expectGapIsTheLowestPoint(const char* type, const Given& shape,
                               const SurfaceFormula& surface) {
  SCOPED_TRACE(type);
  Model m;
  Given given = shape;
  given.push_back({"material", "steel"});
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  addBody<RigidBody, S>(m, "body", kHeavy, type, given);
  addRule(m, "steel steel");
  const ShapeContacts& element = built(m);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Motion motion(m);
    motion.scatter(seed, 4.0);
    const ContactSet set = motion.contacts(element, 0.0);
    ASSERT_GT(set.size(), 0);
    const double g = *std::min_element(set.g.begin(), set.g.end());
    const Eigen::VectorXd& q = motion.start().q;
    const Mat3 A = rotationMatrix(q.data() + 3);
    const double truth = q[2] + lowest(surface, A.transpose() * Vec3::UnitZ());
    EXPECT_NEAR(g, truth, 1e-13) << "seed " << seed;  // roundings of lengths of 5 m and less
  }
}

SurfaceFormula round(double R, double z) {
  return [=](double a, double) { return Vec3(R * std::cos(a), R * std::sin(a), z); };
}

TEST(HalfSpaceContacts, AreAtTheLowestPointOfRoundShapes) {
  expectGapIsTheLowestPoint<TorusShape>(
      "Torus", {{"radius", 0.7}, {"tube", 0.2}}, [](double a, double b) {
        const double r = 0.7 + 0.2 * std::cos(b);
        return Vec3(r * std::cos(a), r * std::sin(a), 0.2 * std::sin(b));
      });
  expectGapIsTheLowestPoint<EllipsoidShape>(
      "Ellipsoid", {{"semiAxes", {0.7, 0.5, 0.2}}}, [](double a, double b) {
        return Vec3(0.7 * std::cos(a) * std::sin(b), 0.5 * std::sin(a) * std::sin(b),
                    0.2 * std::cos(b));
      });
  expectGapIsTheLowestPoint<CapsuleShape>(
      "Capsule", {{"radius", 0.3}, {"length", 0.8}}, [](double a, double b) {
        const double z = 0.3 * std::cos(b);
        return Vec3(0.3 * std::cos(a) * std::sin(b), 0.3 * std::sin(a) * std::sin(b),
                    z + std::copysign(0.4, z));
      });
  expectGapIsTheLowestPoint<CylinderShape>(
      "Cylinder", {{"radius", 0.3}, {"length", 0.8}},
      [](double a, double b) { return round(0.3, std::cos(b) > 0.0 ? 0.4 : -0.4)(a, b); });
  expectGapIsTheLowestPoint<ConeShape>(
      "Cone", {{"radius", 0.3}, {"length", 0.8}}, [](double a, double b) {
        return std::cos(b) > 0.0 ? Vec3(0.0, 0.0, 0.8) : round(0.3, 0.0)(a, b);
      });
}

template <class S>
void expectShapeFits(const char* type, Given shape, int contacts) {
  SCOPED_TRACE(type);
  Model m;
  addBody<Ground, HalfSpace>(m, "world", kMoving, "HalfSpace",
                             {{"material", "steel"}, {"normal", {0.2, 0.1, 1.0}}});
  shape.push_back({"material", "rubber"});
  shape.push_back({"position", {0.1, 0.05, 0.0}});
  shape.push_back({"euler", {0.9, 0.4, 0.3}});
  addBody<RigidBody, S>(m, "body", kHeavy, type, shape);
  addRule(m, "rubber steel");
  expectRowsFit(m, contacts, 3);
}

TEST(HalfSpaceContacts, OfRoundShapesFit) {
  expectShapeFits<CapsuleShape>("Capsule", {{"radius", 0.3}, {"length", 0.4}}, 2);
  expectShapeFits<CylinderShape>("Cylinder", {{"radius", 0.3}, {"length", 0.4}}, 2);
  expectShapeFits<ConeShape>("Cone", {{"radius", 0.3}, {"length", 0.4}}, 2);
  expectShapeFits<TorusShape>("Torus", {{"radius", 0.3}, {"tube", 0.1}}, 1);
  expectShapeFits<EllipsoidShape>("Ellipsoid", {{"semiAxes", {0.3, 0.2, 0.25}}}, 1);
}

TEST(HalfSpaceContacts, OfSectionsInAPlaneFit) {
  const auto expectSectionFits = [](auto add, int contacts) {
    Model m;
    addBody<Ground, HalfSpace>(m, "world", kMoving, "HalfSpace",
                               {{"material", "steel"}, {"normal", {0.2, 0.0, 1.0}}});
    add(m);
    addRule(m, "steel steel");
    expectRowsFit(m, contacts, 2);
  };
  const GivenValue steel{"material", "steel"}, across{"euler", {0.5 * std::numbers::pi, 0.0, 0.0}};
  const Given round{{"radius", 0.3}, {"length", 0.4}, steel};
  Given wheel = round, circle{{"radius", 0.3}, steel, across};
  wheel.push_back(across);
  // Upright in the plane: ends, the corners of a rectangle, those of a triangle.
  expectSectionFits(
      [&](Model& m) { addBody<PlanarBody, CapsuleShape>(m, "b", kPlanar, "", round); }, 2);
  expectSectionFits(
      [&](Model& m) { addBody<PlanarBody, CylinderShape>(m, "b", kPlanar, "", round); }, 4);
  expectSectionFits([&](Model& m) { addBody<PlanarBody, ConeShape>(m, "b", kPlanar, "", round); },
                    3);
  // Axis along the normal of the plane: circles.
  expectSectionFits(
      [&](Model& m) { addBody<PlanarBody, CapsuleShape>(m, "b", kPlanar, "", wheel); }, 1);
  expectSectionFits(
      [&](Model& m) { addBody<PlanarBody, CylinderShape>(m, "b", kPlanar, "", wheel); }, 1);
  expectSectionFits(
      [&](Model& m) { addBody<PlanarBody, CircleShape>(m, "b", kPlanar, "", circle); }, 1);
  expectSectionFits(
      [&](Model& m) {
        addBody<PlanarBody, EllipsoidShape>(m, "b", kPlanar, "",
                                            {{"semiAxes", {0.3, 0.2, 0.1}}, steel});
      },
      1);
}

TEST(HalfSpaceContacts, OfAFlatDiscAreFourPointsOfItsRim) {
  Model m;
  addBody<Ground, HalfSpace>(m, "world", {}, "HalfSpace", {{"material", "steel"}});
  addBody<RigidBody, CylinderShape>(
      m, "disc", {{"position", {0.0, 0.0, 0.05}}}, "Cylinder",
      {{"radius", 0.4}, {"length", 0.1}, {"mass", 1.0}, {"material", "steel"}});
  addRule(m, "steel steel");
  const ShapeContacts& element = built(m);
  Motion motion(m, 0.0);
  const ContactSet set = motion.contacts(element, 0.0);
  // Four of the lower rim, which touch, and four of the upper one.
  ASSERT_EQ(set.size(), 8);
  Vec3 middle = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(set.g[i], 0.0, 1e-16);
    EXPECT_NEAR(set.places.point[i].head<2>().norm(), 0.4, 1e-15);
    middle += set.places.point[i];
  }
  EXPECT_LT(middle.norm(), 1e-15);
  EXPECT_EQ(element.contactName(contactNumber(set.key[0])), "disc-world.rim0.point0");
  // A little tilt, and the lowest point of the rim is there as well.
  double turn[4] = {1.0, 0.0, 0.0, 0.0};
  rotate(turn, Vec3(0.01, 0.02, 0.0));
  for (int i = 0; i < 4; ++i) motion.start().q[3 + i] = turn[i];
  EXPECT_EQ(motion.contacts(element, 0.0).size(), 10);
}

/// Volume, centre and inertia by adding up cells of a cube of half edge a; `inside` tells which.
template <class S>
void expectMassIsOfTheVolume(const char* type, const Given& given, double a,
                             const std::function<bool(const Vec3&)>& inside) {
  SCOPED_TRACE(type);
  constexpr int n = 120;
  double V = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  const double cell = 2.0 * a / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vec3 r = cell * Vec3(i + 0.5, j + 0.5, k + 0.5) - Vec3::Constant(a);
        if (inside(r)) V += 1.0, first += r, second += r * r.transpose();
      }
  const double cube = cell * cell * cell;
  V *= cube, first *= cube / V, second *= cube;
  const Mat3 J = second.trace() * Mat3::Identity() - second -
                 V * (first.squaredNorm() * Mat3::Identity() - first * first.transpose());
  const S shape(Parameters::of<S>(type, "", given));
  const MassProperties mass = shape.massProperties();
  // The boundary passes through about 3/n of the cells and errs by half of one at most, mostly
  // evenly to both sides: 2e-3 is a fifth of that.
  EXPECT_NEAR(mass.volume / V, 1.0, 2e-3);
  EXPECT_LT((mass.centre_B - first).norm(), 2e-3 * a);
  EXPECT_LT((mass.inertia_B - J).norm() / J.norm(), 4e-3);
}

TEST(RoundShapes, HaveTheMassOfTheirVolume) {
  expectMassIsOfTheVolume<ConeShape>(
      "Cone", {{"radius", 0.5}, {"length", 0.9}}, 1.0,
      [](const Vec3& r) { return r.z() > 0.0 && r.head<2>().norm() < 0.5 * (1.0 - r.z() / 0.9); });
  expectMassIsOfTheVolume<TorusShape>(
      "Torus", {{"radius", 0.6}, {"tube", 0.3}}, 1.0,
      [](const Vec3& r) { return std::hypot(r.head<2>().norm() - 0.6, r.z()) < 0.3; });
  expectMassIsOfTheVolume<EllipsoidShape>(
      "Ellipsoid", {{"semiAxes", {0.9, 0.6, 0.3}}}, 1.0,
      [](const Vec3& r) { return r.cwiseQuotient(Vec3(0.9, 0.6, 0.3)).norm() < 1.0; });
}

}  // namespace
}  // namespace dynamy
