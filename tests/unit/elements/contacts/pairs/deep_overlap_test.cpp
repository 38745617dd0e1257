// Bodies that lie deep in each other, against points that are found in both of them.
#include <dynamy_elements/contacts/pairs/between_discs.hpp>
#include <dynamy_elements/contacts/pairs/smooth_contact.hpp>

#include <cmath>

#include "unit/elements/contacts/pairs/pair_shapes.hpp"

namespace dynamy {
namespace {

using namespace testing;

/// A body with its frame in the middle: round, an ellipsoid or a box.
struct HeldBody {
  enum class Kind : std::uint8_t { round, ellipsoid, box } kind;
  double half = 0.0, rho = 0.0, r = 0.0;  ///< of a round one
  bool tip = false;
  Vec3 axes = Vec3::Ones();  ///< semi-axes, half edges
};
constexpr auto kRoundKind = HeldBody::Kind::round;

std::vector<HeldBody> bodies() {
  return {{kRoundKind, 0.25, 0.25},
          {kRoundKind, 0.25, 0.25, 0.0, true},
          {kRoundKind, 0.25, 0.0, 0.25},
          {kRoundKind, 0.0, 0.4, 0.1},
          {kRoundKind, 0.05, 0.4},
          {kRoundKind, 0.1, 0.5, 0.0, true},
          {kRoundKind, 0.6, 0.1, 0.0, true},
          {kRoundKind, 0.7, 0.1},
          {HeldBody::Kind::ellipsoid, 0, 0, 0, false, {0.3, 0.2, 0.15}},
          {HeldBody::Kind::box, 0, 0, 0, false, {0.25, 0.35, 0.15}}};
}

DiscBody disc(const Frame& f, const HeldBody& b) {
  return placedDisc(f, b.half, b.rho, b.r, b.tip);
}

/// Is a ball of the radius δ about p, in axes of the body, inside of it?
bool holds(const HeldBody& b, const Vec3& p, double delta) {
  const double out = p.head<2>().norm(), z = p.z();
  switch (b.kind) {
    case HeldBody::Kind::
        ellipsoid:  // that shrunk about its centre, and a ball, add up to less than it
      return p.cwiseQuotient(b.axes).norm() <= 1.0 - delta / b.axes.minCoeff();
    case HeldBody::Kind::box:
      return (p.cwiseAbs() - b.axes).maxCoeff() <= -delta;
    default:
      break;
  }
  if (b.tip) {  // base and side
    const double side = (out - b.rho) * 2.0 * b.half + (z + b.half) * b.rho;
    return z + b.half >= delta && side / std::hypot(2.0 * b.half, b.rho) <= -delta;
  }
  const double beside = std::max(out - b.rho, 0.0), over = std::max(std::abs(z) - b.half, 0.0);
  if (b.r > 0.0) return std::hypot(beside, over) <= b.r - delta;
  return out <= b.rho - delta && std::abs(z) <= b.half - delta;
}

/// The largest δ in steps of 0.02 of which a ball is in both, −1: none.
double heldBall(const HeldBody& a, const HeldBody& b, const Mover& A, const Mover& B) {
  double most = -1.0;
  constexpr int kPoints = 12;
  for (int i = -kPoints; i <= kPoints; ++i)
    for (int j = -kPoints; j <= kPoints; ++j)
      for (int k = -kPoints; k <= kPoints; ++k) {
        const Vec3 p = 0.7 / kPoints * Vec3(i, j, k),
                   q = B.frame.A_IK.transpose() *
                       (A.frame.A_IK * p + A.frame.r_OS_I - B.frame.r_OS_I);
        for (double d = std::max(most + 0.02, 0.02); holds(a, p, d) && holds(b, q, d); d += 0.02)
          most = d;
      }
  return most;
}

double support(const HeldBody& b, const Frame& f, const Vec3& n) {
  const Vec3 d = f.A_IK.transpose() * n;
  if (b.kind == HeldBody::Kind::ellipsoid) return n.dot(f.r_OS_I) + b.axes.cwiseProduct(d).norm();
  if (b.kind == HeldBody::Kind::box) return n.dot(f.r_OS_I) + b.axes.dot(d.cwiseAbs());
  const double out = b.rho * d.head<2>().norm();
  if (b.tip) return n.dot(f.r_OS_I) + std::max(b.half * d.z(), out - b.half * d.z());
  return n.dot(f.r_OS_I) + b.half * std::abs(d.z()) + out + b.r;
}

/// Their contacts, normals from A to B.
std::vector<NumberedContact> contacts(const HeldBody& a, const HeldBody& b, const Frame& A,
                                      const Frame& B) {
  DiscContacts out;
  const auto some = [&](int n) {
    return std::vector<NumberedContact>(out.begin(), out.begin() + n);
  };
  if (a.kind == kRoundKind && b.kind == kRoundKind)
    return some(betweenDiscs(disc(A, a), disc(B, b), kInfinity, -1.0, true, out));
  if (a.kind == kRoundKind) return {{0, smoothOnDisc(disc(A, a), B, ellipsoid(b.axes))}};
  const Polyhedron box(boxTriangles(a.axes));
  if (b.kind == kRoundKind)
    return some(discOnPolyhedron(placed(A, box), disc(B, b), kInfinity, -1.0, true, out));
  return {{0, smoothOnPolyhedron(placed(A, box), B, ellipsoid(b.axes))}};
}

/// Round ones on all, boxes on round ones and ellipsoids.
bool meet(const HeldBody& a, const HeldBody& b) {
  return (a.kind == kRoundKind && b.kind != HeldBody::Kind::box) ||
         (a.kind == HeldBody::Kind::box && b.kind != HeldBody::Kind::box);
}

TEST(DeepOverlap, IsNeverToldAsLessThanABallThatBothHold) {
  constexpr unsigned kSeed = 61;
  Random r(kSeed);
  const std::vector<HeldBody> all = bodies();
  int met = 0;
  for (const HeldBody& a : all)
    for (const HeldBody& b : all)
      for (int trial = 0; trial < (meet(a, b) ? 12 : 0); ++trial) {
        const Mover A(Vec3::Zero(), turned(2.0 * r.vec()), r.vec(), r.vec());
        const Mover B(0.4 * (1.0 + r.number()) * r.vec().normalized(), turned(2.0 * r.vec()),
                      r.vec(), r.vec());
        const double ball = heldBall(a, b, A, B);
        if (ball < 0.0) continue;
        SCOPED_TRACE("bodies " + std::to_string(&a - all.data()) + " and " +
                     std::to_string(&b - all.data()) + ", trial " + std::to_string(trial) +
                     ", seed " + std::to_string(kSeed));
        ++met;
        const auto found = contacts(a, b, A.frame, B.frame);
        ASSERT_FALSE(found.empty());
        const ContactPoint& at =
            std::min_element(found.begin(), found.end(), [](const auto& c, const auto& d) {
              return c.at.g < d.at.g;
            })->at;
        // Along each direction both reach over the ball. Rounding of lengths of 1.
        EXPECT_LE(at.g, -2.0 * ball + 1e-12);
        // It is the way along its normal that takes them out of each other; features nearer than
        // 1e-6 are one.
        const Vec3& n = at.d[0];
        EXPECT_NEAR(at.g, -support(b, B.frame, -n) - support(a, A.frame, n), 2e-6);
        EXPECT_NEAR(n.norm(), 1.0, 1e-12);
        EXPECT_NEAR(n.dot(at.d[1]), 0.0, 1e-12);
        EXPECT_TRUE(at.Pdot.allFinite());
        for (const Vec3& rate : at.ddot) EXPECT_TRUE(rate.allFinite());
      }
  EXPECT_GT(met, 400);
}

}  // namespace
}  // namespace dynamy
