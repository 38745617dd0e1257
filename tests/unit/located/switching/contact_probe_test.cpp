// Gaps and relative velocities without masses and forces: a sledge over a floor.
#include <gtest/gtest.h>

#include <dynamy/located/switching/contact_probe.hpp>

#include "unit/located/sledge.hpp"

namespace dynamy {
namespace {

using fixture::SledgeScene;

struct Probe {
  explicit Probe(const SledgeScene& s) { probe.prepare(*s.system, s.x); }
  ContactProbe probe;
};

TEST(ContactProbe, SeesOpenContacts) {
  const SledgeScene s({0.0, 0.25}, {2.0, -3.0}, SledgeScene::pull(0.0), 0.5);
  Probe p(s);
  ASSERT_TRUE(p.probe.look(s.x));
  const ContactGaps& gaps = p.probe.gaps();
  ASSERT_EQ(gaps.size(), 1);
  EXPECT_EQ(gaps.key(0), s.key());
  EXPECT_EQ(gaps.gap(0), 0.25);
  EXPECT_EQ(gaps.gamma(0), -3.0);
  EXPECT_EQ(gaps.gamma(0, 1), 2.0);
  EXPECT_EQ(gaps.find(s.key()), 0);
  EXPECT_EQ(gaps.find(s.key(3)), -1);
}

TEST(ContactProbe, LooksAtOneContactAlone) {
  const SledgeScene s({0.0, 0.25}, {2.0, -3.0}, SledgeScene::pull(0.0), 0.5, 0.0, 2);
  Probe p(s);
  ASSERT_TRUE(p.probe.look(s.x));
  PhasePoint from, to;
  from.x = s.x;
  from.x.q[1] = 0.5, from.x.u[1] = 1.0;
  from.qdot = from.x.u, from.a = from.qddot = 0.0 * from.x.u;
  to = from, to.x.t = 1.0;
  QuinticPath path;
  path.through(*s.system, from, to);
  State x;
  ASSERT_TRUE(p.probe.lookAt(path, 0.0, x, 1));
  EXPECT_EQ(p.probe.gaps().gap(0), 0.25);
  EXPECT_EQ(p.probe.gaps().gap(1), 0.5);
  EXPECT_EQ(p.probe.gaps().gamma(0), -3.0);
  EXPECT_EQ(p.probe.gaps().gamma(1), 1.0);
}

TEST(ContactProbe, GathersNothingWhereContactsStay) {
  const SledgeScene s({0.0, 0.25}, {0.0, 0.0}, SledgeScene::pull(0.0), 0.5);
  Probe p(s);
  EXPECT_FALSE(p.probe.gathers());
  EXPECT_TRUE(p.probe.gather(s.x, {}));
  EXPECT_EQ(p.probe.noted().unreported(), kNoContact);
}

}  // namespace
}  // namespace dynamy
