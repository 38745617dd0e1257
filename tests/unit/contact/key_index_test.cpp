// Keys are found where a search through the list finds them.
#include <dynamy/contact/key_index.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace dynamy {
namespace {

TEST(KeyIndex, FindsWhatASearchFinds) {
  std::mt19937 random(7);
  KeyIndex index;
  EXPECT_EQ(index.find({3}), -1);
  for (const int n : {0, 1, 5, 1000, 40}) {  // also after a longer list
    std::vector<ContactKey> keys;
    for (int i = 0; i < n; ++i) keys.push_back({(std::uint64_t{1} << 40) | (random() % 5000)});
    index.build(keys);
    for (std::uint64_t k = 0; k < 5000; ++k) {
      const ContactKey key{(std::uint64_t{1} << 40) | k};
      const auto at = std::find(keys.begin(), keys.end(), key);
      EXPECT_EQ(index.find(key), at == keys.end() ? -1 : static_cast<int>(at - keys.begin()));
    }
  }
}

}  // namespace
}  // namespace dynamy
