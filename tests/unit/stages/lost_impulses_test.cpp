#include <gtest/gtest.h>

#include <dynamy/contact/contact_sink.hpp>
#include <dynamy/law/standard_laws.hpp>
#include <dynamy/stages/lost_impulses.hpp>
#include <utility>

namespace dynamy {
namespace {

const UnilateralCoulomb kLaw(0.0, 0.0, 0.5);

/// A contact of body 0 and body `other` at x on a line; `turned`: its tangents by a right angle.
struct OnLine {
  std::uint64_t key;
  int other;
  double x;
  bool turned = false;
};

struct LineContacts {
  explicit LineContacts(const std::vector<OnLine>& all) {
    set.clear();
    for (const OnLine& c : all) {
      ContactSink sink(set, {});
      auto rows = sink.add(c.key, 0.0, kLaw, 3);
      rows.segment(BlockPlace{0, 0, 6}).setZero();
      rows.segment(BlockPlace{c.other, 6 * c.other, 6}).setZero();
      const Vec3 n = Vec3::UnitZ(), t = c.turned ? Vec3::UnitY() : Vec3::UnitX();
      rows.place(Vec3(c.x, 0.0, 0.0), n, t, n.cross(t));
    }
  }
  ContactSet set;
};

/// The starts of `now` after a step with percussions `Lambda` of `old`, in a step twice as long.
Eigen::VectorXd handedOn(const std::vector<OnLine>& old, Eigen::VectorXd Lambda,
                         const std::vector<OnLine>& now, Eigen::VectorXd start) {
  const LineContacts before(old), after(now);
  Eigen::VectorXd places;
  LostImpulses::remember(before.set, view(std::as_const(Lambda)), places);
  const RememberedImpulses impulses{.key = before.set.key,
                                    .first = before.set.row0,
                                    .Lambda = {Lambda.data(), Lambda.data() + Lambda.size()},
                                    .dt = 1.0};
  LostImpulses().handOn(impulses, view(std::as_const(places)), after.set, 2.0, view(start));
  return start;
}

Eigen::VectorXd vectorOf(std::initializer_list<double> x) {
  return Eigen::Map<const Eigen::VectorXd>(x.begin(), static_cast<Eigen::Index>(x.size()));
}

TEST(LostImpulses, GoToTheNearestNewContactOfTheSameBodies) {
  // 5 stays; 6 at x = 1 and 7 at x = 2 get other names.
  EXPECT_EQ(handedOn({{5, 1, 0.0}, {6, 1, 1.0}, {7, 1, 2.0}},
                     vectorOf({1.0, 0.0, 0.0, 2.0, 0.1, 0.2, 3.0, 0.3, 0.4}),
                     {{5, 1, 0.0}, {41, 1, 2.01}, {40, 1, 0.99}},
                     vectorOf({2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0})),
            vectorOf({2.0, 0.0, 0.0, 6.0, 0.6, 0.8, 4.0, 0.2, 0.4}));
}

TEST(LostImpulses, NeverGoToOtherBodies) {
  EXPECT_EQ(
      handedOn({{6, 1, 1.0}}, vectorOf({2.0, 0.0, 0.0}), {{40, 2, 1.0}}, vectorOf({0.0, 0.0, 0.0})),
      vectorOf({0.0, 0.0, 0.0}));
}

TEST(LostImpulses, KeepTheirDirectionsInSpace) {
  // Along t1 = e_x before; now t1 = e_y, t2 = −e_x.
  EXPECT_EQ(handedOn({{6, 1, 1.0}}, vectorOf({2.0, 0.5, 0.25}), {{40, 1, 1.0, true}},
                     vectorOf({0.0, 0.0, 0.0})),
            vectorOf({4.0, 0.5, -1.0}));
}

TEST(LostImpulses, AreAddedWhereNoNewContactIsLeft) {
  // 6 is gone and nothing new came: what stays between these bodies carries all.
  EXPECT_EQ(handedOn({{5, 1, 0.0}, {6, 1, 1.0}}, vectorOf({1.0, 0.0, 0.0, 2.0, 0.0, 0.0}),
                     {{5, 1, 0.0}}, vectorOf({2.0, 0.0, 0.0})),
            vectorOf({6.0, 0.0, 0.0}));
}

TEST(LostImpulses, ArePassedOnWithoutContacts) {
  EXPECT_EQ(handedOn({}, vectorOf({}), {{5, 1, 0.0}}, vectorOf({1.0, 0.0, 0.0})),
            vectorOf({1.0, 0.0, 0.0}));
  EXPECT_EQ(handedOn({{5, 1, 0.0}}, vectorOf({1.0, 0.0, 0.0}), {}, vectorOf({})).size(), 0);
}

}  // namespace
}  // namespace dynamy
