#include "higherpair/mechanism/group_traits.hpp"

#include <gtest/gtest.h>

namespace higherpair {
namespace {

template <class Kind>
const GroupTraits& traits() {
  Group group;
  group.kind = Kind{};
  return traits_of(group);
}

TEST(GroupTraits, AreThoseOfTheKindThatTheGroupHolds) {
  EXPECT_TRUE(traits<RrrDyad>().two_modes);
  EXPECT_TRUE(traits<CoupledBodies>().coupled);
  EXPECT_FALSE(traits<TouchingBody>().coupled);
  EXPECT_TRUE(traits<GearedBody>().one_branch);
}

TEST(GroupTraits, SayOfNoKindWithOneBranchThatItsBranchesCross) {
  for (const GroupTraits& each : group_traits::kTable) {
    EXPECT_FALSE(each.one_branch && each.can_cross);
    EXPECT_TRUE(!each.two_modes || each.can_cross);
    EXPECT_EQ(each.sine_noise > 0, each.can_cross);
    EXPECT_FALSE(each.limit.empty());
  }
}

TEST(LimitCause, IsTheContactWhereThereIsOne) {
  Group group;
  group.kind = CoupledBodies{};
  EXPECT_EQ(limit_cause(group),
            "the bodies cannot be put together on this branch beyond this position of the driver");
  group.contacts = {0};
  EXPECT_EQ(limit_cause(group),
            "the two bodies cannot be kept in contact on this branch beyond this position of the driver");
}

TEST(PlacingContact, IsThatOfATrackedPairOrATouchingBody) {
  Group group;
  TouchingBody touching;
  touching.contact = 3;
  touching.follower.body = 5;
  group.kind = touching;
  ASSERT_TRUE(placing_contact(group));
  EXPECT_EQ(placing_contact(group)->contact, 3);
  EXPECT_EQ(placing_contact(group)->follower->body, 5);
  TrackedPair tracked;
  tracked.contact = 2;
  group.kind = tracked;
  EXPECT_EQ(placing_contact(group)->contact, 2);
  group.kind = RrrDyad{};
  EXPECT_FALSE(placing_contact(group));
}

}  // namespace
}  // namespace higherpair
