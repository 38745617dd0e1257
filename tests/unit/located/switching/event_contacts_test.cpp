// Which contacts take part in an event: a sledge on a floor.
#include <gtest/gtest.h>

#include <dynamy/located/switching/event_contacts.hpp>

#include "unit/located/switching/sledge_event.hpp"

namespace dynamy {
namespace {

using fixture::SledgeEvent, fixture::SledgeScene;
using Keys = std::vector<ContactKey>;

/// Keys of the contacts that take part with gap g and velocity v of the gap.
Keys taking(double g, double v, bool held) {
  SledgeScene s({0.0, g}, {0.0, v}, SledgeScene::pull(0.0), 0.5);
  const SledgeEvent e(s);
  ContactProbe probe;
  probe.prepare(*s.system, s.x);
  std::vector<Held> statuses(held ? 1 : 0);
  if (held) statuses[0].key = s.key();
  EventContacts contacts;
  EXPECT_TRUE(contacts.find(probe, statuses, kNoContact, e.at));
  return contacts.keys();
}

TEST(EventContacts, AreThoseThatTouchAndDoNotSeparate) {
  const Keys one = {contactKey(0, 0)};
  EXPECT_EQ(taking(0.0, -3.0, false), one);
  EXPECT_EQ(taking(0.0, 0.0, false), one);
  EXPECT_TRUE(taking(0.0, 1e-3, false).empty());
  EXPECT_TRUE(taking(1e-6, -3.0, false).empty());
}

TEST(EventContacts, IncludeThoseThatAreHeld) {
  EXPECT_EQ(taking(1e-6, 1e-3, true), Keys{contactKey(0, 0)});
}

}  // namespace
}  // namespace dynamy
