#include <gtest/gtest.h>

#include <dynamy/core/suggestion.hpp>
#include <string>
#include <vector>

namespace dynamy {
namespace {

const std::vector<std::string> kAttributes = {"mass", "inertia", "length", "restitution",
                                              "friction"};

TEST(Suggestion, CountsInsertDeleteReplaceAndSwapAsOneError) {
  EXPECT_EQ(typingDistance("mass", "mass"), 0);
  EXPECT_EQ(typingDistance("mas", "mass"), 1);
  EXPECT_EQ(typingDistance("masss", "mass"), 1);
  EXPECT_EQ(typingDistance("mess", "mass"), 1);
  EXPECT_EQ(typingDistance("amss", "mass"), 1);
  EXPECT_EQ(typingDistance("", "mass"), 4);
  EXPECT_EQ(typingDistance("kitten", "sitting"), 3);  // the textbook pair
}

TEST(Suggestion, FindsTheNameThatWasMistyped) {
  EXPECT_EQ(nearest("mas", kAttributes), "mass");
  EXPECT_EQ(nearest("lenght", kAttributes), "length");
  EXPECT_EQ(nearest("Inertia", kAttributes), "inertia");
  EXPECT_EQ(nearest("resitution", kAttributes), "restitution");
}

TEST(Suggestion, IsEmptyIfNothingIsNear) {
  EXPECT_EQ(nearest("colour", kAttributes), "");
  EXPECT_EQ(nearest("x", kAttributes), "");
  EXPECT_EQ(nearest("", kAttributes), "");
  EXPECT_EQ(nearest("mass", std::vector<std::string>{}), "");
}

TEST(Suggestion, DoesNotReplaceOneLetterByAnother) {
  EXPECT_EQ(nearest("x", std::vector<std::string>{"t", "y"}), "");
  EXPECT_EQ(nearest("T", std::vector<std::string>{"y", "t"}), "t");
}

TEST(Suggestion, PrefersTheRightCaseAmongEquallyNearNames) {
  EXPECT_EQ(nearest("Lamda", std::vector<std::string>{"lambda", "Lambda"}), "Lambda");
  EXPECT_EQ(nearest("lamda", std::vector<std::string>{"Lambda", "lambda"}), "lambda");
}

TEST(Suggestion, CompletesAWordThatBeginsExactlyOneName) {
  EXPECT_EQ(nearest("rest", kAttributes), "restitution");
  EXPECT_EQ(nearest("rest", std::vector<std::string>{"restitution", "restLength"}), "");
}

}  // namespace
}  // namespace dynamy
