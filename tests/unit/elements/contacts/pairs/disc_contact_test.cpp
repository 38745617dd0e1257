// Cylinders, tori and cones on boxes and polyhedra against dense samples of directions, and
// differences.
#include <dynamy_elements/contacts/pairs/between_discs.hpp>
#include <dynamy_elements/contacts/pairs/cone_side.hpp>

#include <cmath>

#include "unit/elements/contacts/pairs/pair_shapes.hpp"

namespace dynamy {
namespace {

using namespace testing;

/// The largest of f over directions on a grid, finer around the best: no f is larger than its true
/// maximum, so that a value which f takes, and which is not below this one, is the maximum.
double separatedInSpace(const std::function<double(const Vec3&)>& f) {
  Vec3 best = Vec3::UnitZ();
  double most = -kInfinity;
  const auto take = [&](const Vec3& n) {
    if (const double s = f(n); s > most) most = s, best = n;
  };
  constexpr int kGrid = 40000;
  for (int i = 0; i < kGrid; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kGrid, angle = 2.399963229728653 * i;
    take({std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle), z});
  }
  for (double width = 0.03; width > 1e-13; width *= 0.5) {
    const Vec3 c = best, x = c.unitOrthogonal(), y = c.cross(x);
    for (int i = -10; i <= 10; ++i)
      for (int j = -10; j <= 10; ++j)
        take((c + width / 10.0 * i * x + width / 10.0 * j * y).normalized());
  }
  return most;
}

double support(const Frame& f, const Polyhedron& body, const Vec3& n) {
  double most = -kInfinity;
  for (const Vec3& p : body.corners()) most = std::max(most, n.dot(f.r_OS_I + f.A_IK * p));
  return most;
}

/// How far p is outside of a round body.
double beyond(const DiscBody& b, const Vec3& p) {
  const double z = b.a.dot(p - b.c), out = b.acrossAxis(p - b.c).norm();
  if (b.tip) {
    // Half of its section: from the base's middle to the rim and on to the tip.
    using Vec2 = Eigen::Vector2d;
    const Vec2 at(out, z), base(0.0, -b.half), rim(b.rho, -b.half), top(0.0, b.half);
    const auto toSegment = [&](const Vec2& from, const Vec2& to) {
      const double s = std::clamp((at - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
      return (at - from - s * (to - from)).norm();
    };
    const double least = std::min(toSegment(base, rim), toSegment(rim, top));
    const bool inside = z > -b.half && (out - b.rho) * 2.0 * b.half + (z + b.half) * b.rho < 0.0;
    return inside ? -least : least;
  }
  return std::hypot(std::max(std::abs(z) - b.half, 0.0), std::max(out - b.rho, 0.0)) - b.r;
}

const ContactPoint& deepest(const DiscContacts& found, int n) {
  return std::min_element(found.begin(), found.begin() + n,
                          [](const auto& a, const auto& b) { return a.at.g < b.at.g; })
      ->at;
}

constexpr int kKinds = 6;
constexpr int kTrials = 420;

constexpr DiscSizes kRound[] = {{0.5, 0.3, 0.0}, {0.05, 0.4, 0.0}, {0.0, 0.4, 0.1},
                                {0.7, 0.1, 0.0}, {0.4, 0.0, 0.2},  {0.0, 0.0, 0.3}};
/// With cones: slender and blunt ones first.
constexpr DiscSizes kWithCones[] = {
    {0.4, 0.3, 0.0, true}, {0.1, 0.5, 0.0, true}, {0.6, 0.1, 0.0, true}, {0.5, 0.3, 0.0},
    {0.05, 0.4, 0.0},      {0.0, 0.4, 0.1},       {0.4, 0.0, 0.2}};

TEST(DiscContact, SeparationFromAPolyhedronIsTheLargestOfAllDirections) {
  Random r(51);
  int apart = 0, overlapping = 0, exact = 0;
  for (int trial = 0; trial < 240; ++trial) {
    const Polyhedron body =
        trial % 2 ? Polyhedron(r.hull(10)) : Polyhedron(boxTriangles({0.6, 0.4, 0.3}));
    const DiscSizes& s = kDiscs[trial / 2 % kKinds];
    const Mover A = inSpace(r, Vec3::Zero());
    const Mover B = inSpace(r, (0.7 + 0.5 * (1.0 + r.number())) * r.vec().normalized());
    const DiscBody b = placedDisc(B.frame, s.half, s.rho, s.r, s.tip);
    const auto f = [&](const Vec3& n) { return -b.support(-n) - support(A.frame, body, n); };
    const double truth = separatedInSpace(f);
    if (truth < -0.05) continue;
    (truth > 0.0 ? apart : overlapping)++;
    // f is one of its values, and none of the others is larger. Lengths of 1 are rounded.
    const double g = separation(placed(A.frame, body), b);
    EXPECT_GT(g, truth - 1e-14) << "trial " << trial << ", seed 51";
    DiscContacts found;
    const int n = discOnPolyhedron(placed(A.frame, body), b, kInfinity, -1.0, true, found);
    ASSERT_GT(n, 0) << trial;
    const ContactPoint& at = deepest(found, n);
    // Features nearer than 1e-6 of a body are one.
    EXPECT_NEAR(at.g, g, 1e-6) << "trial " << trial << ", seed 51";
    EXPECT_NEAR(f(at.d[0]), at.g, 1e-6) << "trial " << trial << ", seed 51";
    exact += std::abs(at.g - g) < 1e-13 && std::abs(f(at.d[0]) - at.g) < 1e-13;
    if (g < 0.0) continue;
    // Points of both, as far from each other as is told: no distance is larger than that.
    const bool onB = beyond(b, at.P) < 1e-13;
    EXPECT_LT(beyond(b, onB ? at.P : Vec3(at.P + at.g * at.d[0])), 1e-13) << "trial " << trial;
    const Vec3 pA = onB ? Vec3(at.P - at.g * at.d[0]) : at.P;
    const Vec3 p = A.frame.A_IK.transpose() * (pA - A.frame.r_OS_I);
    for (const Polyhedron::Face& face : body.faces())
      EXPECT_LT(face.n.dot(p) - face.height, 1e-6) << "trial " << trial << ", seed 51";
  }
  EXPECT_GT(apart, 30);
  EXPECT_GT(exact, apart);
  EXPECT_GT(overlapping, 3);
}

TEST(DiscContact, RatesOnAPolyhedronAreThoseOfTheMotion) {
  Random r(52);
  int compared = 0, of[kKinds] = {};
  for (int trial = 0; trial < 700; ++trial) {
    const Polyhedron body =
        trial % 2 ? Polyhedron(r.hull(10)) : Polyhedron(boxTriangles({0.6, 0.4, 0.3}));
    const DiscSizes& s = kDiscs[trial / 2 % kKinds];
    const Mover A = inSpace(r, Vec3::Zero()),
                B = inSpace(r, (0.9 + 0.3 * r.number()) * r.vec().normalized());
    // Deeper inside no two features may look at each other.
    if (separation(placed(A.frame, body), placedDisc(B.frame, s.half, s.rho, s.r, s.tip)) < -0.05)
      continue;
    const int fit = expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      DiscContacts out;
      const int n = discOnPolyhedron(placed(fA, body), placedDisc(fB, s.half, s.rho, s.r, s.tip),
                                     kInfinity, -1.0, true, out);
      return std::vector<NumberedContact>(out.begin(), out.begin() + n);
    });
    compared += fit, of[trial / 2 % kKinds] += fit;
  }
  EXPECT_GT(compared, 300) << "seed 52";
  for (const int n : of) EXPECT_GT(n, 50);
}

TEST(DiscContact, OfAnUprightBodyIsOfTheRimThatStands) {
  // Either way up, tilted so little that both rims are lowest at one place seen from above.
  const Polyhedron body(boxTriangles({0.6, 0.4, 0.3}));
  const Mover A(Vec3::Zero(), Mat3::Identity());
  for (const int rim : {0, 1})
    for (const double tilt : {0.0, 1e-11, 1e-7, 1e-3, 0.05}) {
      const double c = std::cos(tilt), s = std::sin(tilt);
      const Mat3 up = rim == 0 ? Mat3(Mat3::Identity()) : Mat3(Vec3(1.0, -1.0, -1.0).asDiagonal());
      const Mover B({0.0, 0.0, 0.3 + 0.2 * c + 0.1 * s}, turned(Vec3(0.0, tilt, 0.0)) * up);
      DiscContacts found;
      const int n = discOnPolyhedron(placed(A.frame, body), placedDisc(B.frame, 0.2, 0.1, 0.0),
                                     kInfinity, -1.0, true, found);
      ASSERT_GT(n, 1);
      for (int k = 0; k < n; ++k) {
        const int id = found[static_cast<std::size_t>(k)].id;
        EXPECT_EQ(id < 2 ? id : (id - 2) / 4, rim) << "tilt " << tilt << ", contact " << id;
      }
      // Rounding of lengths of 1; the lowest point of a rim is in its plane however it was found.
      EXPECT_NEAR(deepest(found, n).g, 0.0, 1e-15) << "tilt " << tilt;
    }
}

TEST(ConeContact, OfABallIsItsDistanceAndHasTheRatesOfTheMotion) {
  Random r(55);
  int seen[2] = {};
  for (int trial = 0; trial < 400; ++trial) {
    const DiscSizes& s = kDiscs[4 + trial % 2];
    const Mover A = inSpace(r, Vec3::Zero()), B = inSpace(r, (trial % 4 < 2 ? 0.8 : 0.3) * r.vec());
    SupportFeature ball;
    ball.c_K = 0.1 * r.vec(), ball.radius = 0.05 * (1.0 + r.number());
    const Vec3 c = B.frame.r_OS_I + B.frame.A_IK * ball.c_K;
    const DiscBody cone = placedDisc(A.frame, s.half, s.rho, s.r, true);
    // Rounding of lengths of 1.
    EXPECT_NEAR(ballOnCone(cone, B.frame, ball).g, beyond(cone, c) - ball.radius, 1e-14)
        << "trial " << trial << ", seed 55";
    ++seen[beyond(cone, c) < 0.0 ? 0 : 1];
    expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      const DiscBody at = placedDisc(fA, s.half, s.rho, s.r, true);
      return std::vector<NumberedContact>{{0, ballOnCone(at, fB, ball)}};
    });
  }
  EXPECT_GT(seen[0], 10);
  EXPECT_GT(seen[1], 200);
}

TEST(DiscContact, SeparationOfRoundBodiesIsTheLargestOfAllDirections) {
  Random r(53);
  int apart = 0, overlapping = 0, exact = 0;
  for (int trial = 0; trial < 240; ++trial) {
    const DiscSizes &sA = kRound[trial % 4], &sB = kRound[trial / 4 % 6];
    // Anywhere, with parallel axes, and on each other with a small tilt.
    const Mover A = inSpace(r, Vec3::Zero());
    const Vec3 way = (0.4 + 0.6 * (1.0 + r.number())) * r.vec().normalized();
    Mover B = inSpace(r, way);
    if (trial % 5 == 0) B.frame.A_IK = A.frame.A_IK;
    if (trial % 5 == 1) {
      B.frame.A_IK = A.frame.A_IK * turned(0.01 * r.vec());
      B.frame.r_OS_I = A.frame.A_IK * Vec3(0.3 * r.number(), 0.3 * r.number(),
                                           sA.half + sA.r + sB.half + sB.r + 0.01 * r.number());
    }
    const DiscBody a = placedDisc(A.frame, sA.half, sA.rho, sA.r),
                   b = placedDisc(B.frame, sB.half, sB.rho, sB.r);
    const auto f = [&](const Vec3& n) { return -b.support(-n) - a.support(n); };
    const double truth = separatedInSpace(f);
    if (truth < -0.05) continue;
    (truth > 0.0 ? apart : overlapping)++;
    const double g = separation(a, b);
    EXPECT_GT(g, truth - 1e-14) << "trial " << trial << ", seed 53";
    DiscContacts found;
    const int n = betweenDiscs(a, b, kInfinity, -1.0, true, found);
    ASSERT_GT(n, 0) << trial;
    const ContactPoint& at = deepest(found, n);
    EXPECT_NEAR(at.g, g, 1e-6) << "trial " << trial << ", seed 53"
                               << " id " << found[0].id << " n " << n;
    EXPECT_NEAR(f(at.d[0]), at.g, 1e-6) << "trial " << trial << ", seed 53";
    exact += std::abs(at.g - g) < 1e-13 && std::abs(f(at.d[0]) - at.g) < 1e-13;
    if (g < 0.0) continue;
    // P is on one of them, and what lies opposite on the other.
    const bool onB = beyond(b, at.P) < 1e-13;
    EXPECT_LT(beyond(b, onB ? at.P : Vec3(at.P + at.g * at.d[0])), 1e-6) << "trial " << trial;
    EXPECT_LT(beyond(a, onB ? Vec3(at.P - at.g * at.d[0]) : at.P), 1e-6) << "trial " << trial;
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(overlapping, 10);
  EXPECT_GT(exact, (apart + overlapping) * 9 / 10);
}

/// Two bodies of which one at least is a cone: anywhere; with parallel axes, either way up; nearly
/// upright on the other; and side on side.
struct WithCone {
  DiscSizes sA, sB;
  Mover A, B;
  WithCone(Random& r, int trial)
      : sA(kWithCones[trial % 3]),
        sB(kWithCones[trial / 3 % 7]),
        A(inSpace(r, Vec3::Zero())),
        B(inSpace(r, (0.4 + 0.6 * (1.0 + r.number())) * r.vec().normalized())) {
    const Mat3& axes = A.frame.A_IK;
    const Mat3 upside = Vec3(1.0, -1.0, -1.0).asDiagonal();
    if (trial % 5 == 0) B.frame.A_IK = trial % 2 == 0 ? axes : Mat3(axes * upside);
    if (trial % 5 == 1) {
      B.frame.A_IK = axes * turned(0.01 * r.vec()) * upside;
      B.frame.r_OS_I =
          axes * Vec3(0.3 * r.number(), 0.3 * r.number(), -sA.half - sB.half - sB.r - 0.01);
      if (trial % 2 == 0) B.frame.A_IK = B.frame.A_IK * upside;
    }
    if (trial % 5 == 2) {
      // The axes so that a line of one side lies on one of the other, and a little turned.
      const double b = (sA.tip ? std::atan2(sA.rho, 2.0 * sA.half) : 0.0) +
                       (sB.tip ? std::atan2(sB.rho, 2.0 * sB.half) : 0.0);
      B.frame.A_IK = axes * turned(Vec3(0.0, b, 0.0)) * turned(0.3 * r.vec()) * upside;
      B.frame.r_OS_I =
          axes * Vec3(sA.rho + sB.rho + sB.r + 0.1 * r.number(), 0.0, 0.2 * r.number());
    }
  }
  DiscBody a(const Frame& f) const { return placedDisc(f, sA.half, sA.rho, sA.r, sA.tip); }
  DiscBody b(const Frame& f) const { return placedDisc(f, sB.half, sB.rho, sB.r, sB.tip); }
};

TEST(ConeContact, SeparationFromRoundBodiesIsTheLargestOfAllDirections) {
  Random r(56);
  int apart = 0, overlapping = 0, exact = 0, sameNumber = 0, seen[4] = {};
  for (int trial = 0; trial < kTrials; ++trial) {
    const WithCone pair(r, trial);
    const DiscBody a = pair.a(pair.A.frame), b = pair.b(pair.B.frame);
    const auto f = [&](const Vec3& n) { return -b.support(-n) - a.support(n); };
    const double truth = separatedInSpace(f);
    if (truth < -0.05) continue;
    (truth > 0.0 ? apart : overlapping)++;
    const double g = separation(a, b);
    EXPECT_GT(g, truth - 1e-14) << "trial " << trial << ", seed 56";
    // In either order.
    EXPECT_NEAR(separation(b, a), g, 1e-14) << "trial " << trial << ", seed 56";
    DiscContacts found;
    const int n = betweenDiscs(a, b, kInfinity, -1.0, true, found);
    ASSERT_GT(n, 0) << trial;
    const ContactPoint& at = deepest(found, n);
    // The other way round the same contacts, with opposite normals.
    DiscContacts turned;
    const int m = betweenDiscs(b, a, kInfinity, -1.0, true, turned);
    sameNumber += m == n;
    EXPECT_NEAR(deepest(turned, m).g, at.g, 1e-6) << "trial " << trial << ", seed 56";
    EXPECT_LT((deepest(turned, m).d[0] + at.d[0]).norm(), 1e-6) << "trial " << trial << ", seed 56";
    EXPECT_NEAR(at.g, g, 1e-6) << "trial " << trial << ", seed 56 id " << found[0].id << " n " << n;
    EXPECT_NEAR(f(at.d[0]), at.g, 1e-6) << "trial " << trial << ", seed 56";
    const bool isExact = std::abs(at.g - g) < 1e-13 && std::abs(f(at.d[0]) - at.g) < 1e-13;
    exact += isExact;
    for (int c = 0; c < n; ++c) {
      const int id = found[static_cast<std::size_t>(c)].id;
      ++seen[id < kSides ? 0 : id == kSides ? 1 : id < kRimPairs ? 2 : 3];
    }
    if (g < 0.0) continue;
    // P is on one of them, and what lies opposite on the other.
    const bool onB = beyond(b, at.P) < 1e-13;
    EXPECT_LT(beyond(b, onB ? at.P : Vec3(at.P + at.g * at.d[0])), 1e-6) << "trial " << trial;
    EXPECT_LT(beyond(a, onB ? Vec3(at.P - at.g * at.d[0]) : at.P), 1e-6) << "trial " << trial;
  }
  EXPECT_GT(apart, kTrials / 3);
  EXPECT_GT(overlapping, kTrials / 20);
  EXPECT_GT(exact, (apart + overlapping) * 9 / 10);
  EXPECT_GT(sameNumber, (apart + overlapping) * 9 / 10);
  // Over caps, sides on sides, rims and tips on sides, rims and tips on each other.
  for (const int n : seen) EXPECT_GT(n, kTrials / 30);
}

TEST(ConeContact, RatesOnRoundBodiesAreThoseOfTheMotion) {
  Random r(57);
  int compared = 0, of[4] = {};
  for (int trial = 0; trial < 900; ++trial) {
    const WithCone pair(r, trial);
    // Deeper inside no two features may look at each other.
    if (separation(pair.a(pair.A.frame), pair.b(pair.B.frame)) < -0.05) continue;
    int id = 0;
    const int fit = expectRatesFit(pair.A, pair.B, [&](const Frame& fA, const Frame& fB) {
      DiscContacts out;
      const int n = betweenDiscs(pair.a(fA), pair.b(fB), kInfinity, -1.0, true, out);
      id = out[0].id;
      return std::vector<NumberedContact>(out.begin(), out.begin() + n);
    });
    compared += fit, of[id < kSides ? 0 : id == kSides ? 1 : id < kRimPairs ? 2 : 3] += fit;
  }
  EXPECT_GT(compared, 900) << "seed 57";
  for (const int n : of) EXPECT_GT(n, 50);
}

TEST(DiscContact, RatesOfRoundBodiesAreThoseOfTheMotion) {
  Random r(54);
  int compared = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const DiscSizes &sA = kRound[trial % 4], &sB = kRound[trial / 4 % 6];
    const Mover A = inSpace(r, Vec3::Zero());
    Mover B = inSpace(r, 1.2 * r.vec().normalized());
    if (trial % 3 == 1) {
      B.frame.A_IK = A.frame.A_IK * turned(0.01 * r.vec());
      B.frame.r_OS_I = A.frame.A_IK * Vec3(0.3 * r.number(), 0.3 * r.number(),
                                           sA.half + sA.r + sB.half + sB.r + 0.01 * r.number());
    }
    compared += expectRatesFit(A, B, [&](const Frame& fA, const Frame& fB) {
      DiscContacts out;
      const int n = betweenDiscs(placedDisc(fA, sA.half, sA.rho, sA.r),
                                 placedDisc(fB, sB.half, sB.rho, sB.r), kInfinity, -1.0, true, out);
      return std::vector<NumberedContact>(out.begin(), out.begin() + n);
    });
  }
  EXPECT_GT(compared, 600) << "seed 54";
}

}  // namespace
}  // namespace dynamy
