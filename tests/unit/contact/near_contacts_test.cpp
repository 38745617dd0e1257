#include <gtest/gtest.h>

#include <dynamy/contact/near_contacts.hpp>

namespace dynamy {
namespace {

TEST(NearContacts, SelectsKeysByRangesOfElements) {
  NearContacts near;
  near.add(2, 10, 20);
  near.addAll(1);
  near.add(2, 4, 5);
  near.order();
  EXPECT_TRUE(near.some());
  for (const ContactKey key : {contactKey(1, 0), contactKey(1, 1ull << 39), contactKey(2, 4),
                               contactKey(2, 10), contactKey(2, 19)})
    EXPECT_TRUE(near.has(key)) << key.value;
  for (const ContactKey key : {contactKey(0, 7), contactKey(2, 3), contactKey(2, 5),
                               contactKey(2, 9), contactKey(2, 20), contactKey(3, 0)})
    EXPECT_FALSE(near.has(key)) << key.value;
  const std::vector<ContactKey> all{contactKey(0, 3), contactKey(1, 8),  contactKey(2, 3),
                                    contactKey(2, 4), contactKey(2, 12), contactKey(3, 1)};
  std::vector<ContactKey> out;
  near.select(all, out);
  EXPECT_EQ(out, (std::vector<ContactKey>{contactKey(1, 8), contactKey(2, 4), contactKey(2, 12)}));
  std::vector<std::uint64_t> firsts;
  near.forEach(2, [&](std::uint64_t first) { firsts.push_back(first); });
  EXPECT_EQ(firsts, (std::vector<std::uint64_t>{4, 10}));
  near.clear();
  near.order();
  EXPECT_FALSE(near.some());
  EXPECT_FALSE(near.has(contactKey(1, 0)));
}

}  // namespace
}  // namespace dynamy
