/// Which contacts can close on a path, and what the search for switches saves by it.
#include <gtest/gtest.h>

#include <dynamy/located/switching/contact_probe.hpp>
#include <dynamy/located/switching/path_contacts.hpp>
#include <random>
#include <reference/scene.hpp>

namespace dynamy::reference {
namespace {

constexpr int kBodies = 12;

/// Bodies of all kinds, no two touching, over a floor and beside a wall that moves.
std::string crowd() {
  const char* shapes[] = {R"(Sphere radius="0.2")",
                          R"(Box size="0.3 0.2 0.4")",
                          R"(Capsule radius="0.1" length="0.3")",
                          R"(Cylinder radius="0.15" length="0.3")",
                          R"(Cone radius="0.2" length="0.3")",
                          R"(Ellipsoid semiAxes="0.2 0.1 0.15")"};
  std::string text = R"(<dynamy version="1"><systems>)";
  for (int i = 0; i < kBodies; ++i)
    text += "<RigidBody name=\"b" + std::to_string(i) + "\" position=\"" + std::to_string(i % 3) +
            " " + std::to_string(i / 3 % 2) + " " + std::to_string(0.6 + i / 6) + "\"><" +
            shapes[i % 6] + R"( mass="1" material="a"/></RigidBody>)";
  return text + R"(<Ground name="floor"><HalfSpace material="a"/></Ground>
    <Ground name="wall" motion="-1 + 0.3*t; 0; 0"><HalfSpace normal="1 0 0" material="a"/></Ground>
    </systems><elements><Contact between="a a"><Unilateral/></Contact></elements>
    <simulation until="1" step="1"/></dynamy>)";
}

class Paths {
 public:
  Paths() : scene_("crowd", {.text = crowd()}) {
    near_.prepare(scene_.system().parts());
    kinematics_.resize(*scene_.system().parts().topology);
  }
  /// Straight motion with random speeds, and random angular velocities, from a random place.
  void scatter(unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> number;
    p_.x = scene_.state();
    for (Eigen::Index i = 0; i < p_.x.u.size(); ++i) p_.x.u[i] = 2.0 * number(random);
    p_.a.setZero(p_.x.u.size());
  }
  PathContacts& near() { return near_; }
  const PhasePoint& start() const { return p_; }
  /// Keys of contacts that overlap at the time t of the motion.
  std::vector<ContactKey> closedAt(double t) {
    State x = p_.x;
    scene_.system().move(x, p_.x.u, t);
    x.t = t;
    return closed(x);
  }
  /// The end of a motion of `time` [s] with accelerations of up to about `most` [m/s²], which jump
  /// at the start.
  PhasePoint pushed(double time, double most, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> number(0.0, most);
    PhasePoint end = p_;
    for (Eigen::Index i = 0; i < end.a.size(); ++i) end.a[i] = number(random);
    const Eigen::VectorXd mean = p_.x.u + 0.5 * time * end.a;
    scene_.system().move(end.x, mean, time);
    end.x.t = time, end.x.u = p_.x.u + time * end.a;
    for (PhasePoint* p : {&p_, &end}) {
      configurationRate(*scene_.system().parts().topology, p->x, p->qdot);
      p->qddot.setZero(p->qdot.size());
    }
    return end;
  }
  const MechanicalSystem& system() { return scene_.system(); }
  std::vector<ContactKey> closed(const State& x) {
    kinematics_.evaluate(*scene_.system().parts().topology, x.t, view(std::as_const(x.q)),
                         view(std::as_const(x.u)), view(std::as_const(x.memory)));
    ContactSet found;
    found.clear();
    ContactSink sink(found, {});
    reportContacts(scene_.system().parts(), kinematics_, sink);
    return found.key;
  }
  int pairs() const { return kBodies * (kBodies - 1) / 2 + 2 * kBodies; }

 private:
  Scene scene_;
  PathContacts near_;
  Kinematics kinematics_;
  PhasePoint p_;
};

TEST(PathContacts, NoContactClosesThatWasLeftOut) {
  Paths paths;
  int closed = 0, left = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    paths.scatter(seed);
    for (const double time : {0.03, 0.1, 0.3}) {
      const NearContacts* near = paths.near().ahead(paths.start(), time, 1e-6);
      ASSERT_NE(near, nullptr);
      EXPECT_TRUE(paths.near().narrowed());
      for (int k = 1; k <= 30; ++k)
        for (const ContactKey key : paths.closedAt(time * k / 30.0)) {
          EXPECT_TRUE(near->has(key)) << "seed " << seed << ", " << time << " s, " << key.value;
          ++closed;
        }
      if (time < 0.05) {
        int followed = 0;
        near->forEach(0, [&](std::uint64_t) { ++followed; });
        left += paths.pairs() - followed;
      }
    }
  }
  EXPECT_GT(closed, 1000);
  // Bodies are 1 m apart and reach 0.25 m; with 6 m/s times 0.03 s most pairs stay apart.
  EXPECT_GT(left, 40 * paths.pairs() / 2);
}

TEST(PathContacts, PathsThatGoElsewhereAreFoundAgain) {
  // Predicted with the accelerations at the start, which are zero; the path itself turns aside.
  Paths paths;
  int found = 0, stayed = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    paths.scatter(seed);
    const double time = 0.2, aside = seed % 4 == 0 ? 1e-3 : 4.0;
    ASSERT_NE(paths.near().ahead(paths.start(), time, 1e-6), nullptr);
    const PhasePoint end = paths.pushed(time, aside, seed);
    QuinticPath path;
    path.through(paths.system(), paths.start(), end);
    if (paths.near().cover(path)) {
      ++stayed;
      continue;
    }
    const NearContacts* near = paths.near().along();
    ASSERT_NE(near, nullptr);
    State x;
    for (int k = 1; k <= 30; ++k) {
      path.at(k / 30.0, x);
      for (const ContactKey key : paths.closed(x)) {
        EXPECT_TRUE(near->has(key)) << "seed " << seed << ", " << key.value;
        ++found;
      }
    }
  }
  EXPECT_GE(stayed, 8);
  EXPECT_GT(found, 100);
}

TEST(PathContacts, AContactThatIsLookedAtAloneIsTheOneAmongAll) {
  Paths paths;
  paths.scatter(7);
  const PhasePoint end = paths.pushed(0.2, 4.0, 7);
  QuinticPath path;
  path.through(paths.system(), paths.start(), end);
  ContactProbe probe;
  probe.prepare(paths.system(), paths.start().x);
  State whole, part;
  for (const double theta : {0.0, 0.3, 1.0}) {
    path.at(theta, whole);
    ASSERT_TRUE(probe.look(whole));
    const ContactGaps all = probe.gaps();
    ASSERT_GT(all.size(), kBodies);
    ASSERT_TRUE(probe.look(paths.start().x));
    for (int i = 0; i < all.size(); ++i) {
      ASSERT_TRUE(probe.lookAt(path, theta, part, i));
      EXPECT_EQ(probe.gaps().gap(i), all.gap(i)) << i;  // bit by bit: the same operations
      EXPECT_EQ(probe.gaps().gamma(i), all.gamma(i)) << i;
      EXPECT_EQ(probe.gaps().presence(i), all.presence(i)) << i;
    }
  }
  EXPECT_LT(probe.looks.whole, 12);
}

TEST(PathContacts, SpeedsWithoutAFiniteValueLeaveNothingOut) {
  Paths paths;
  paths.scatter(1);
  PhasePoint p = paths.start();
  p.a[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(paths.near().ahead(p, 0.1, 0.0), nullptr);
  EXPECT_FALSE(paths.near().narrowed());
}

}  // namespace
}  // namespace dynamy::reference
