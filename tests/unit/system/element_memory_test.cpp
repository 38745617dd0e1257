// Numbers of elements in the state, one after the other.
#include <gtest/gtest.h>

#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/system/element_memory.hpp>

namespace dynamy {
namespace {

class Owner final : public Element {
 public:
  explicit Owner(const Parameters& x) : Element(x) {}
  static void declare(Attributes&) {}
};

TEST(ElementMemory, ReservesNumbersOneAfterTheOther) {
  const Owner a{Parameters::of<Owner>("Latch", "a", {})},
      b{Parameters::of<Owner>("Latch", "b", {})}, c{Parameters::of<Owner>("Latch", "c", {})};
  ElementMemory memory;
  memory.reserve(a, {1.0, 2.0});
  const MemoryHandle ofB = memory.reserve(b, {3.0});
  EXPECT_EQ(ofB.first, 2);
  EXPECT_EQ(ofB.size, 1);
  EXPECT_EQ(memory.of(a).size, 2);
  EXPECT_EQ(memory.of(b).first, 2);
  EXPECT_EQ(memory.of(c).size, 0);
  EXPECT_EQ(memory.start(), (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_THROW(memory.reserve(a, {4.0}), std::logic_error);
}

}  // namespace
}  // namespace dynamy
