// Pairs of features that are noted before they touch, and whether elements report them.
#include <gtest/gtest.h>

#include <dynamy/located/switching/noted_contacts.hpp>

namespace dynamy {
namespace {

using Keys = std::vector<ContactKey>;

ContactKey key(std::uint64_t id) { return contactKey(1, id); }

ContactSet noting(Keys keys, double overlap = 0.0) {
  ContactSet c;
  c.features.noted = std::move(keys), c.features.overlap = overlap;
  return c;
}

ContactSet reporting(Keys keys) {
  ContactSet c;
  c.key = std::move(keys);
  return c;
}

Keys read(NotedContacts& noted, const ContactSet& c, const Keys& followed) {
  const auto unknown = noted.read(c, followed);
  return {unknown.begin(), unknown.end()};
}

TEST(NotedContacts, AreLearntOnce) {
  NotedContacts noted;
  EXPECT_EQ(read(noted, noting({key(5), key(2)}), {}), (Keys{key(2), key(5)}));
  noted.learn(reporting({key(2), key(5)}));
  EXPECT_TRUE(read(noted, noting({key(5)}), {}).empty());
  EXPECT_EQ(noted.unreported(), kNoContact);
}

TEST(NotedContacts, NameTheFirstThatNoElementReports) {
  NotedContacts noted;
  read(noted, noting({key(5), key(2), key(3)}), {});
  noted.learn(reporting({key(2)}));
  EXPECT_EQ(noted.unreported(), key(5));
  read(noted, noting({key(2)}), {});
  EXPECT_EQ(noted.unreported(), kNoContact);  // the others are no longer near
}

TEST(NotedContacts, AreFreshUntilTheyAreFollowed) {
  NotedContacts noted;
  read(noted, noting({key(2)}, 0.5), {});
  EXPECT_TRUE(noted.fresh());
  EXPECT_EQ(noted.overlap(), 0.5);
  read(noted, noting({key(2)}), {key(2), key(3)});
  EXPECT_FALSE(noted.fresh());
}

}  // namespace
}  // namespace dynamy
