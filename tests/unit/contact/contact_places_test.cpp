// Places of contacts keep one entry per contact; features are forgotten with the contacts.
#include <gtest/gtest.h>

#include <dynamy/contact/contact_set.hpp>
#include <limits>

namespace dynamy {
namespace {

TEST(ContactPlaces, AddsContactsWithoutAPlaceAndThoseOfAnotherSet) {
  ContactPlaces from, to;
  from.add(), from.add();
  EXPECT_TRUE(from.normal[1].isZero(0.0));
  from.point[1] = {1.0, 2.0, 3.0}, from.normal[1] = Vec3::UnitZ();
  from.t1[1] = Vec3::UnitX(), from.t2[1] = Vec3::UnitY();
  to.add(from, 1);
  ASSERT_EQ(to.point.size(), 1u);
  EXPECT_EQ(to.point[0], Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(to.normal[0], Vec3::UnitZ());
  EXPECT_EQ(to.t1[0], Vec3::UnitX());
  EXPECT_EQ(to.t2[0], Vec3::UnitY());
  to.clear();
  EXPECT_TRUE(to.point.empty() && to.normal.empty() && to.t1.empty() && to.t2.empty());
}

TEST(FollowedFeatures, AreForgottenWithTheContacts) {
  ContactSet set;
  set.features.noted.push_back({7}), set.features.presence.push_back(FollowedFeatures::kAlways);
  set.features.comeAndGo = true, set.features.overlap = 0.1;
  set.clear();
  EXPECT_TRUE(set.features.noted.empty() && set.features.presence.empty());
  EXPECT_FALSE(set.features.comeAndGo);
  EXPECT_EQ(set.features.overlap, -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace dynamy
