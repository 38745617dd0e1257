// The list of contacts that are held.
#include <gtest/gtest.h>

#include <dynamy/contact/contact_set.hpp>
#include <dynamy/located/phase/held.hpp>

namespace dynamy {
namespace {

Held part(int element, std::uint64_t id, int first = 0) {
  Held h;
  h.key = contactKey(element, id), h.first = first;
  return h;
}

TEST(Held, IsFoundByItsContactOrItsPart) {
  const std::vector<Held> held = {part(2, 7), part(2, 7, 3), part(1, 4)};
  EXPECT_EQ(findHeld(held, contactKey(2, 7)), &held[0]);
  EXPECT_EQ(findHeld(held, HeldKey{contactKey(2, 7), 3}), &held[1]);
  EXPECT_EQ(findHeld(held, contactKey(2, 8)), nullptr);
  EXPECT_EQ(findHeld(held, HeldKey{contactKey(1, 4), 3}), nullptr);
}

TEST(Held, HasOneKeyForAllPartsOfAContact) {
  std::vector<ContactKey> keys;
  heldKeys({part(2, 7), part(2, 7, 3), part(1, 4)}, keys);
  EXPECT_EQ(keys, (std::vector<ContactKey>{contactKey(1, 4), contactKey(2, 7)}));
}

TEST(Held, NamesTheElementOfItsContact) { EXPECT_EQ(elementOf(contactKey(5, 1234567)), 5); }

}  // namespace
}  // namespace dynamy
