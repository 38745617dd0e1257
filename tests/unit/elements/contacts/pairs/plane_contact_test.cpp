// Contact in a plane: polygons against distances over all pairs of corners and edges, contours
// against dense samples and closed forms, rates against differences.
#include <dynamy_elements/contacts/pairs/polygon_contact.hpp>
#include <dynamy_elements/contacts/shapes/contour.hpp>
#include <dynamy_elements/contacts/shapes/contour_shape.hpp>

#include <cmath>
#include <numbers>

#include "unit/elements/contacts/pairs/pair_shapes.hpp"
#include "unit/elements/contacts/shape_models.hpp"

namespace dynamy {
namespace {

using namespace testing;

/// Corners on a circle at random angles, counterclockwise about the plane's normal.
std::vector<Vec3> randomPolygon(Random& random, int n) {
  std::vector<double> angles;
  for (int i = 0; i < n; ++i) angles.push_back(std::numbers::pi * random.number());
  std::sort(angles.begin(), angles.end());
  const Vec3 x = Vec3::UnitX(), y = kPlane.cross(x);
  std::vector<Vec3> out;
  for (const double a : angles) out.emplace_back(std::cos(a) * x + std::sin(a) * y);
  return out;
}

double toSegment(const Vec3& c, const Vec3& a, const Vec3& b, bool* inside) {
  const double t = (c - a).dot(b - a) / (b - a).squaredNorm();
  *inside = t > 0.0 && t < 1.0;
  return (a + std::clamp(t, 0.0, 1.0) * (b - a) - c).norm();
}

/// Least distance of corners of one from edges of the other; `onEdge`: it is not of two corners.
double brute(const PlacedPolygon& A, const PlacedPolygon& B, bool* onEdge) {
  double least = kInfinity;
  for (const auto& [p, q] : {std::pair{&A, &B}, std::pair{&B, &A}})
    for (int i = 0; i < p->size(); ++i)
      for (int k = 0; k < q->size(); ++k) {
        bool inside = false;
        const double d = toSegment(p->corner(i), q->corner(k), q->corner(k + 1), &inside);
        if (d < least) least = d, *onEdge = inside;
      }
  return least;
}

TEST(PolygonContact, IsTheirDistanceAndHasTheRatesOfTheMotion) {
  Random random(21);
  int met = 0, compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Vec3> a = randomPolygon(random, 5), b = randomPolygon(random, 7);
    const Mover A = inPlane(random, Vec3::Zero());
    const double turn = 3.0 * random.number();
    const Mover B = inPlane(random, 2.1 * Vec3(std::cos(turn), 0.0, std::sin(turn)));
    const auto pair = [&](const Frame& fA, const Frame& fB) {
      PolygonContacts out;
      const int n = betweenPolygons({&fA, &a, kPlane}, {&fB, &b, kPlane}, 10.0, true, out);
      return std::vector<NumberedContact>(out.begin(), out.begin() + n);
    };
    const PlacedPolygon pa{&A.frame, &a, kPlane}, pb{&B.frame, &b, kPlane};
    compared += expectRatesFit(A, B, pair);
    if (separation(pa, pb) < 0.0) continue;
    bool onEdge = false;
    const double truth = brute(pa, pb, &onEdge);
    double least = kInfinity;
    for (const NumberedContact& c : pair(A.frame, B.frame)) least = std::min(least, c.at.g);
    EXPECT_GT(least, truth - 1e-5);  // features nearer than 1e-6 are one
    if (!onEdge) continue;
    ++met;
    EXPECT_NEAR(least, truth, 1e-14) << "trial " << trial << ", seed 21";
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(compared, 100);
}

TEST(PolygonContact, OfCornersThatMeetIsThereWhileTheyAreApart) {
  // As OfParallelEdgesThatMeetIsThereWhileTheyAreApart of bodies in space. From 2θ = 45° on other
  // sides face each other.
  const Vec3 x = Vec3::UnitX(), y = kPlane.cross(x);
  const std::vector<Vec3> brick = {-0.2 * x - 0.1 * y, 0.2 * x - 0.1 * y, 0.2 * x + 0.1 * y,
                                   -0.2 * x + 0.1 * y};
  for (const double theta : {0.02, 0.2, 0.35})
    for (const double delta : {-1e-6, 1e-12, 1e-9, 1e-6, 1e-2}) {
      const double front = 0.2 * std::cos(theta) + 0.1 * std::sin(theta) + delta / 2.0;
      const Mover A(-front * x, turned(theta * kPlane)), B(front * x, turned(-theta * kPlane));
      PolygonContacts found;
      const int n = betweenPolygons({&A.frame, &brick, kPlane}, {&B.frame, &brick, kPlane},
                                    kInfinity, false, found);
      const double least = leastGap({found.data(), static_cast<std::size_t>(n)});
      if (delta > 1e-3)
        EXPECT_GT(least, 1.01 * delta) << theta;
      else  // up to rounding of positions of 0.4 m
        EXPECT_NEAR(least, delta * std::cos(theta), 1e-15) << theta << ' ' << delta;
    }
}

TEST(PolygonContact, OfTwoEdgesIsWhatTheyShare) {
  const std::vector<Vec3> square{{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
  const Mover A(Vec3::Zero(), Mat3::Identity());
  for (const double shift : {0.0, 0.5, -1.5, 1e-12}) {
    const Mover B(Vec3(shift, 0.0, 2.01), Mat3::Identity());
    PolygonContacts out;
    ASSERT_EQ(
        betweenPolygons({&A.frame, &square, kPlane}, {&B.frame, &square, kPlane}, 1.0, true, out),
        2);
    const double x0 = std::min(out[0].at.P.x(), out[1].at.P.x()),
                 x1 = std::max(out[0].at.P.x(), out[1].at.P.x());
    // The overlap of [−1, 1] and [s − 1, s + 1], up to what is one feature.
    EXPECT_NEAR(x0, std::max(-1.0, shift - 1.0), 1e-5);
    EXPECT_NEAR(x1, std::min(1.0, shift + 1.0), 1e-5);
    EXPECT_NEAR(out[0].at.g, 0.01, 1e-14);
    EXPECT_NEAR(out[0].at.d[0].z(), 1.0, 1e-15);
  }
}

TEST(PolygonContact, OfACircleIsItsDistance) {
  Random random(22);
  int compared = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const std::vector<Vec3> a = randomPolygon(random, 6);
    const Mover A = inPlane(random, Vec3::Zero());
    const Mover B = inPlane(random, 1.5 * Vec3(random.number(), 0.0, random.number()));
    const RoundFeature ball{Vec3(0.1, 0.0, 0.2), 0.3};
    const PlacedPolygon pa{&A.frame, &a, kPlane};
    const ContactPoint at = ballOnPolygon(pa, B.frame, ball);
    const Vec3 c = B.frame.r_OS_I + B.frame.A_IK * ball.c_K;
    double truth = kInfinity, height = -kInfinity;
    for (int i = 0; i < pa.size(); ++i) {
      bool inside = false;
      truth = std::min(truth, toSegment(c, pa.corner(i), pa.corner(i + 1), &inside));
      height = std::max(height, pa.normal(i).dot(c - pa.corner(i)));
    }
    EXPECT_NEAR(at.g, (height < 0.0 ? -truth : truth) - 0.3, 1e-14) << "seed 22, " << trial;
    // Beside a corner the direction turns with the speed over the distance.
    if (truth < 0.05) continue;
    compared += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      return std::vector<NumberedContact>{{0, ballOnPolygon({&fA, &a, kPlane}, fB, ball)}};
    });
  }
  EXPECT_GT(compared, 100);
}

/// An ellipse, r = a b/√(b² cos² + a² sin²), and a curve that goes in.
Contour ellipse(double a, double b, int n = 720) {
  std::vector<double> r;
  for (int i = 0; i < n; ++i) {
    const double phi = 2.0 * std::numbers::pi * i / n;
    r.push_back(a * b / std::hypot(b * std::cos(phi), a * std::sin(phi)));
  }
  return Contour(std::move(r));
}
Contour clover() {
  std::vector<double> r;
  for (int i = 0; i < 720; ++i) r.push_back(1.0 + 0.3 * std::cos(std::numbers::pi * i / 120.0));
  return Contour(std::move(r));
}

TEST(Contour, OfAnEllipseHasItsSupportAndCurvature) {
  const Contour e = ellipse(2.0, 1.0);
  EXPECT_TRUE(e.convex());
  EXPECT_FALSE(clover().convex());
  for (int i = 0; i < 100; ++i) {
    const double theta = 0.0628 * i, c = std::cos(theta), s = std::sin(theta);
    const Contour::Point p = e.furthest({c, s});
    const double h = std::hypot(2.0 * c, s);
    // Errors of a spline of degree 5 with h = 2π/720, sixth derivative up to 15 500: 61/46080 h⁶ of
    // it in place, 9e-12, and h⁴/720 of it in r″, 1.3e-7, times ρ² ≤ 16 in ρ.
    EXPECT_NEAR(p.x.dot(Contour::Vec2(c, s)), h, 9e-12);
    EXPECT_LT((p.n - Contour::Vec2(c, s)).norm(), 1e-12);
    EXPECT_NEAR(1.0 / p.curvature, 4.0 / (h * h * h), 2e-6);  // ρ = a² b²/h³
  }
}

TEST(Contour, NearestPointIsThatOfDenseSamples) {
  Random random(23);
  for (const Contour& contour : {ellipse(2.0, 1.0), clover()})
    for (int trial = 0; trial < 20; ++trial) {
      const Contour::Vec2 c(2.5 * random.number(), 2.5 * random.number());
      double least = kInfinity;
      for (int i = 0; i < 40000; ++i)
        least = std::min(least, (contour.at(std::numbers::pi * i / 20000.0).x - c).norm());
      // Samples are 6e-4 apart, which is (3e-4)²/2 in distance over the least distance.
      const double found = (contour.nearest(c).x - c).norm();
      EXPECT_LE(found, least + 1e-12);
      EXPECT_NEAR(found, least, 1e-7 / std::max(least, 0.01)) << "seed 23, " << trial;
    }
}

TEST(Contour, OfARollerHasTheRatesOfTheMotion) {
  Random random(24);
  int compared = 0;
  for (const Contour& contour : {ellipse(2.0, 1.0), clover()}) {
    SupportFeature feature;
    feature.kind = SupportFeature::Kind::contour, feature.contour = &contour;
    feature.square_K << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    feature.c_K = Vec3(0.1, 0.0, 0.05);
    for (int trial = 0; trial < 100; ++trial) {
      const double turn = 3.0 * random.number();
      const Mover A = inPlane(random, Vec3::Zero());
      const Mover B = inPlane(random, 2.5 * Vec3(std::cos(turn), 0.0, std::sin(turn)));
      const auto pair = [&](const Frame& fA, const Frame& fB) {
        return std::vector<NumberedContact>{
            {0, ballOnContour(fA, feature, fB, {Vec3(0.0, 0.0, 0.1), 0.2}, kPlane)}};
      };
      // Where the distance is near the radius of a hollow the foot runs or jumps.
      if (pair(A.frame, B.frame)[0].at.Pdot.norm() > 5.0) continue;
      compared += expectRatesFit(A, B, pair);
    }
  }
  EXPECT_GT(compared, 100) << "seed 24";
}

TEST(Contour, OfACircleBesideItsMiddleIsThatCircle) {
  // Errors of the spline with h = 2π/720 and r⁗ up to 0.1: 1.5e-12 in place; 3e-9 in slope, and
  // as much times the radius in the point; r⁗ h²/12 = 6e-7 in r″, 2e-6 in the radius of curvature,
  // times the square of speeds of about 2.
  ContactSet set[2];
  Eigen::VectorXd gamma[2], bias[2];
  for (unsigned seed = 1; seed <= 5; ++seed) {
    for (const int i : {0, 1}) {
      Model m;
      addBody<Ground, HalfSpace>(m, "world", kMoving, "HalfSpace", {{"material", "steel"}});
      const GivenValue upright{"euler", {0.5 * std::numbers::pi, 0.0, 0.0}};
      if (i == 0) {
        addBody<PlanarBody, ContourShape>(m, "cam", kPlanar, "Contour",
                                          {{"r", "0.05*cos(phi) + sqrt(0.09 - (0.05*sin(phi))^2)"},
                                           upright,
                                           {"material", "steel"}});
      } else {
        addBody<PlanarBody, CircleShape>(
            m, "cam", kPlanar, "Circle",
            {{"radius", 0.3}, upright, {"position", {0.05, 0.0, 0.0}}, {"material", "steel"}});
      }
      addRule(m, "steel steel");
      const ShapeContacts& element = built(m);
      Motion motion(m);
      motion.scatter(seed, 0.5);
      set[i] = motion.contacts(element, 0.0);
      gamma[i] = motion.gamma(element, 0.0), bias[i] = motion.bias(element);
    }
    ASSERT_EQ(set[0].size(), 1);
    ASSERT_EQ(set[1].size(), 1);
    EXPECT_NEAR(set[0].g[0], set[1].g[0], 1e-11) << seed;
    EXPECT_LT((gamma[0] - gamma[1]).norm(), 1e-8) << seed;
    EXPECT_LT((bias[0] - bias[1]).norm(), 1e-5) << seed;
  }
}

TEST(PolygonContact, OfATrapezoidOnABoxAreItsTwoCorners) {
  Model m;
  addBody<PlanarBody, Box>(m, "box", kPlanar, "Box",
                           {{"size", {3.0, 0.4, 3.0}}, {"material", "steel"}});
  addBody<PlanarBody, PolygonShape>(
      m, "stone", {{"mass", 1.0}, {"inertia", 0.2}, {"position", {0.0, 0.0, 4.51}}}, "Polygon",
      {{"points", "-1 0 -2  1 0 -2  0.5 0 2  -0.5 0 2"}, {"material", "steel"}});
  addRule(m, "steel steel");
  const ShapeContacts& element = built(m);
  Motion motion(m, 0.0);
  const ContactSet set = motion.contacts(element, 0.0);
  ASSERT_EQ(set.size(), 2);
  for (const double g : set.g) EXPECT_NEAR(g, 0.01, 1e-14);  // 4.51 − 1 − 1.5 − 2
}

TEST(PolygonContact, OfOneThatGoesInIsRefused) {
  Model m;
  addBody<PlanarBody, Box>(m, "box", kPlanar, "Box",
                           {{"size", {3.0, 0.4, 3.0}}, {"material", "steel"}});
  addBody<PlanarBody, PolygonShape>(
      m, "stone", {{"mass", 1.0}, {"inertia", 0.2}, {"position", {0.0, 0.0, 6.0}}}, "Polygon",
      {{"points", "-2 0 -2  2 0 -2  0 0 -1  -1 0 2"}, {"material", "steel"}});
  addRule(m, "steel steel");
  EXPECT_THROW(built(m), ModelError);
}

TEST(ShapeContacts, OfACircleOnALineIsItsDistanceFromASegment) {
  Model m;
  addBody<Ground, LineShape>(m, "world", {}, "Line",
                             {{"points", "-1 0 0  2 0 1"}, {"material", "steel"}});
  addBody<PlanarBody, Sphere>(m, "wheel", kPlanar, "Sphere",
                              {{"radius", 0.3}, {"material", "steel"}});
  addRule(m, "steel steel");
  const ShapeContacts& element = built(m);
  Random random(25);
  Motion motion(m, 0.0);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3 c(2.0 * random.number(), 0.0, 2.0 * random.number());
    motion.start().q.head<2>() << c.x(), c.z();
    bool inside = false;
    const ContactSet set = motion.contacts(element, 0.0);
    if (set.size() == 0) continue;
    EXPECT_NEAR(set.g[0], toSegment(c, {-1, 0, 0}, {2, 0, 1}, &inside) - 0.3, 1e-14);
  }
}

}  // namespace
}  // namespace dynamy
