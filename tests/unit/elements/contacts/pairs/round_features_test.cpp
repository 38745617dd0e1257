// Pairs of features of round bodies one by one: where two bodies touch, against the search for their
// largest separation; rates by differences along a motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <dynamy_elements/contacts/pairs/between_discs.hpp>
#include <dynamy_elements/contacts/pairs/capsule_features.hpp>
#include <dynamy_elements/contacts/pairs/disc_features.hpp>
#include <dynamy_elements/contacts/pairs/round_contact.hpp>
#include <dynamy_elements/contacts/pairs/two_discs.hpp>
#include <functional>
#include <unit/elements/contacts/pairs/pair_shapes.hpp>
#include <vector>

namespace dynamy {
namespace {

using testing::Mover;

constexpr unsigned kRoundSeed = 7;
constexpr double kFlatRim = 1e-9;
const Vec3 kHalf(0.5, 0.7, 0.4);

/// The pairs of two bodies at their places, for any round body.
struct RoundPair {
  std::function<FollowedPair(const Frame& A, const Frame& B, int f)> pair;
  std::function<std::vector<int>(const Frame& A, const Frame& B, const Nearness& within)> near;
  std::function<double(const Frame& A, const Frame& B)> separation;
  int count = 0;
};

RoundPair discOnBox(const Polyhedron& box, const testing::DiscSizes& size) {
  const auto disc = [size](const Frame& B) {
    return testing::placedDisc(B, size.half, size.rho, size.r, size.tip);
  };
  RoundPair out;
  out.count = DiscFeatures::count(box);
  out.pair = [&box, disc](const Frame& A, const Frame& B, int f) {
    const PlacedPolyhedron a = testing::placed(A, box);
    const DiscBody b = disc(B);
    return DiscFeatures(a, b, kFlatRim).pair(f);
  };
  out.near = [&box, disc](const Frame& A, const Frame& B, const Nearness& within) {
    const PlacedPolyhedron a = testing::placed(A, box);
    const DiscBody b = disc(B);
    std::vector<int> found;
    DiscFeatures(a, b, kFlatRim).near(within, found);
    return found;
  };
  out.separation = [&box, disc](const Frame& A, const Frame& B) {
    return separation(testing::placed(A, box), disc(B));
  };
  return out;
}

RoundPair twoDiscs(const testing::DiscSizes& a, const testing::DiscSizes& b) {
  RoundPair out;
  out.count = TwoDiscs::kCount;
  out.pair = [a, b](const Frame& A, const Frame& B, int f) {
    const DiscBody of = testing::placedDisc(A, a), on = testing::placedDisc(B, b);
    return TwoDiscs(of, on, kFlatRim).pair(f);
  };
  out.near = [a, b](const Frame& A, const Frame& B, const Nearness& within) {
    const DiscBody of = testing::placedDisc(A, a), on = testing::placedDisc(B, b);
    std::vector<int> found;
    TwoDiscs(of, on, kFlatRim).near(within, found);
    return found;
  };
  out.separation = [a, b](const Frame& A, const Frame& B) {
    return separation(testing::placedDisc(A, a), testing::placedDisc(B, b));
  };
  return out;
}

TouchingShape boxShape() {
  TouchingShape s;
  s.kind = TouchingShape::Kind::box;
  s.half = kHalf, s.thickness = kHalf.minCoeff(), s.bound = kHalf.norm();
  return s;
}

DiscBody rodOf(const Frame& f, const TouchingShape& capsule) {
  return testing::placedDisc(f, capsule.half.z(), 0.0, capsule.thickness);
}

RoundPair capsuleAtBox(const TouchingShape& box, const Polyhedron& faces,
                       const TouchingShape& rod) {
  RoundPair out;
  out.count = CapsuleFeatures::count(box);
  out.pair = [&](const Frame& A, const Frame& B, int f) {
    return CapsuleFeatures(A, box, B, rod).pair(f);
  };
  out.near = [&](const Frame& A, const Frame& B, const Nearness& within) {
    std::vector<int> found;
    CapsuleFeatures(A, box, B, rod).near(within, found);
    return found;
  };
  // A capsule is a disc without a radius: this search knows nothing of its features.
  out.separation = [&](const Frame& A, const Frame& B) {
    return separation(testing::placed(A, faces), rodOf(B, rod));
  };
  return out;
}

RoundPair twoRods(const TouchingShape& a, const TouchingShape& b) {
  static const Vec3 space = Vec3::Zero();
  RoundPair out;
  out.count = kCapsules;
  out.pair = [&](const Frame& A, const Frame& B, int f) {
    return TwoCapsules(A, a, B, b, space).pair(f);
  };
  out.near = [&](const Frame& A, const Frame& B, const Nearness& within) {
    std::vector<int> found;
    TwoCapsules(A, a, B, b, space).near(within, found);
    return found;
  };
  out.separation = [&](const Frame& A, const Frame& B) {
    return separation(rodOf(A, a), rodOf(B, b));
  };
  return out;
}

/// B is moved towards A until they touch. One of the pairs that are noted is present there and tells
/// it, and none that is present tells an overlap.
void expectToTouch(const RoundPair& of, const char* what) {
  testing::Random random(kRoundSeed);
  int touched = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Frame A = testing::inSpace(random, Vec3::Zero()).frame;
    const Mover b = testing::inSpace(random, Vec3::Zero());
    const Vec3 way = random.vec().normalized();
    const auto moved = [&](double distance) {
      Frame B = b.frame;
      B.r_OS_I = distance * way;
      return B;
    };
    double inside = 0.2, apart = 3.0;
    if (!(of.separation(A, moved(inside)) < 0.0)) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (inside + apart);
      (of.separation(A, moved(middle)) < 0.0 ? inside : apart) = middle;
    }
    const Frame B = moved(apart);
    double least = 1e300;
    for (const int f : of.near(A, B, {1e-3, 0.0}))
      if (const FollowedPair pair = of.pair(A, B, f); pair.presence > 0.0)
        least = std::min(least, pair.at.g);
    // The separation is found to 1e-15 of sizes of 1 m; its rate along the way is 0.1 at least,
    // and pairs end 1e-7 of the size beyond their features, where gaps differ by the square.
    EXPECT_NEAR(least, 0.0, 1e-12) << what << ' ' << trial;
    ++touched;
  }
  EXPECT_GT(touched, 200) << what;
}

/// γ_N = ġ, and rates of the normal and of the point, of all pairs that are present or nearly so.
void expectRates(const RoundPair& of, const char* what) {
  testing::Random random(kRoundSeed);
  int looked = 0;
  for (int trial = 0; trial < 150; ++trial) {
    const Mover a = testing::inSpace(random, Vec3::Zero()),
                b = testing::inSpace(random, random.vec());
    for (int f = 0; f < of.count; ++f) {
      constexpr double d = 1e-5;
      const FollowedPair before = of.pair(a.after(-d).frame, b.after(-d).frame, f),
                         after = of.pair(a.after(d).frame, b.after(d).frame, f),
                         now = of.pair(a.frame, b.frame, f);
      if (!(std::min({before.presence, now.presence, after.presence}) > 0.0)) continue;
      const Frame A = a.frame, B = b.frame;
      const double rate =
          now.at.d[0].dot(B.velocity(now.at.P - B.r_OS_I) - A.velocity(now.at.P - A.r_OS_I));
      ++looked;
      // Central differences: d² times a third derivative, large only for nearly parallel lines.
      EXPECT_NEAR((after.at.g - before.at.g) / (2.0 * d), rate, 1e-5 * (1.0 + std::abs(rate)))
          << what << ' ' << f;
      EXPECT_LT(((after.at.d[0] - before.at.d[0]) / (2.0 * d) - now.at.ddot[0]).norm(),
                1e-4 * (1.0 + now.at.ddot[0].squaredNorm()))
          << what << ' ' << f;
      EXPECT_LT(((after.at.P - before.at.P) / (2.0 * d) - now.at.Pdot).norm(),
                1e-4 * (1.0 + now.at.Pdot.squaredNorm()))
          << what << ' ' << f;
    }
  }
  EXPECT_GT(looked, 60) << what;
}

void expectBoth(const RoundPair& of, const char* what) {
  expectToTouch(of, what);
  expectRates(of, what);
}

TEST(RoundFeatures, OfDiscsOnABoxTellWhereTheyTouch) {
  const Polyhedron box(boxTriangles(kHalf));
  for (const testing::DiscSizes& size : testing::kDiscs) {
    const std::string what = std::to_string(size.half) + ' ' + std::to_string(size.rho);
    expectBoth(discOnBox(box, size), what.c_str());
  }
}

TEST(RoundFeatures, OfTwoDiscsTellWhereTheyTouch) {
  constexpr testing::DiscSizes kRod{0.5, 0.0, 0.2};
  std::vector<testing::DiscSizes> all(std::begin(testing::kDiscs), std::end(testing::kDiscs));
  all.push_back(kRod);
  for (const testing::DiscSizes& a : all)
    for (const testing::DiscSizes& b : all) {
      const std::string what = std::to_string(a.half) + ' ' + std::to_string(a.rho) + " and " +
                               std::to_string(b.half) + ' ' + std::to_string(b.rho);
      expectBoth(twoDiscs(a, b), what.c_str());
    }
}

TEST(RoundFeatures, OfCapsulesTellWhereTheyTouch) {
  const Polyhedron faces(boxTriangles(kHalf));
  const TouchingShape box = boxShape(), rod = testing::capsule(0.2, 0.5),
                      other = testing::capsule(0.3, 0.4);
  expectBoth(capsuleAtBox(box, faces, rod), "box");
  expectBoth(twoRods(rod, other), "capsules");
}

}  // namespace
}  // namespace dynamy
