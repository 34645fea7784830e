#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/finder.hpp"
#include "random_pair.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

// Two parabolas, back to back: both are unbounded, and the follower turns.
ContactPair parabolas() {
  ContactPair pair;
  pair.curve1 = make_parabola({0.4, 0}, 0.3, kPi).value();
  pair.curve2 = make_parabola({-0.9, 0.2}, 0.2, 0.1).value();
  pair.motion2.p_WO = {2.1, 0.3};
  return pair;
}

TEST(ListedContact, OfTwoParabolasIsTheFirstInTheSenseOfTheMotion) {
  const ContactPair pair = parabolas();
  const CurveContacts list = find_curve_contacts(pair, 0);
  for (const int direction : {1, -1}) {
    const FindResult found = find_contact(pair, 0, 0, direction);
    ASSERT_EQ(found.status, FindStatus::kFound);
    EXPECT_EQ(found.branch, -direction);
    EXPECT_GT(direction * found.at.q, 0);
    EXPECT_LE((found.at.p1_W - found.at.p2_W).norm(), 1e-14 * (1 + found.at.p1_W.norm()));
    for (const CurveContact& each : list.contacts) {
      const bool before = direction * each.q > 0 && direction * each.q < direction * found.at.q - 1e-9;
      EXPECT_FALSE(each.free && before) << each.q;
    }
  }
}

TEST(ListedContact, OfTwoParabolasNearestToAPoseIsTheNearerOfTheTwo) {
  const ContactPair pair = parabolas();
  const double up = find_contact(pair, 0, 0, 1).at.q;
  const double down = find_contact(pair, 0, 0, -1).at.q;
  EXPECT_NEAR(find_nearest_contact(pair, 0, up - 1e-3).at.q, up, 1e-12);
  EXPECT_NEAR(find_nearest_contact(pair, 0, down + 1e-3).at.q, down, 1e-12);
  // Also from a position within the overlap, and from a turn away.
  EXPECT_NEAR(find_nearest_contact(pair, 0, up + 1e-3).at.q, up, 1e-12);
  EXPECT_NEAR(find_nearest_contact(pair, 0, up - 1e-3 + 2 * kPi).at.q, up + 2 * kPi, 1e-12);
}

// Wherever the axes are parallel the curves are tangent at infinity, which does not count as a contact; but
// their vertices may touch there.
TEST(ListedContact, OfTwoParabolasVertexOnVertexIsListed) {
  for (const double turn : {0.0, 0.7, -2.5}) {
    ContactPair pair;
    pair.curve1 = make_parabola({0, 0}, 0.3, kPi).value();
    pair.curve2 = make_parabola({-std::cos(turn), -std::sin(turn)}, 0.2, turn).value();
    pair.motion2.p_WO = {1, 0};
    const CurveContacts list = find_curve_contacts(pair, 0);
    ASSERT_EQ(list.status, ContactsStatus::kComplete);
    int touching = 0;
    for (const CurveContact& each : list.contacts) {
      touching += std::abs(nearest_turn(each.q + turn, 0)) < 1e-12 && each.p_W.norm() < 1e-12 ? 1 : 0;
      EXPECT_LT(each.p_W.norm(), 1e3);
    }
    EXPECT_EQ(touching, 1);
  }
}

TEST(ListedContact, IsRefusedFromAnOverlapWhereTheFollowerIsToMoveToTheFirstTouch) {
  const ContactPair pair = parabolas();
  const double up = find_contact(pair, 0, 0, 1).at.q;
  EXPECT_EQ(find_contact(pair, 0, up + 1e-3, 1).status, FindStatus::kOverlapAtStart);
}

// The free contacts are those of the list of all, however they have been found.
void expect_free_of_all(const testing::RandomPair& random) {
  SCOPED_TRACE(random.text);
  const CurveContacts all = find_curve_contacts(random.pair, random.u);
  CurveContacts free = find_free_contacts(random.pair, random.u);
  ASSERT_EQ(free.status, all.status);
  std::erase_if(free.contacts, [](const CurveContact& each) { return !each.free; });
  std::size_t k = 0;
  for (const CurveContact& each : all.contacts) {
    if (each.free) {
      ASSERT_LT(k, free.contacts.size());
      const CurveContact& same = free.contacts[k++];
      EXPECT_LE(std::abs(same.q - each.q), 1e-12 * (1 + std::abs(each.q)));
      EXPECT_LE((same.p_W - each.p_W).norm(), 1e-9 * (1 + each.p_W.squaredNorm()));
      EXPECT_LE((same.n_W - each.n_W).norm(), 1e-9);
      EXPECT_EQ(same.branch, each.branch);
      EXPECT_EQ(same.at_limit, each.at_limit);
      EXPECT_EQ(same.coincident, each.coincident);
    }
  }
  EXPECT_EQ(k, free.contacts.size());
}

TEST(ListedContact, FreeOnesAreTheSameWithoutTheOthers) {
  for (unsigned number = 0; number < 720; ++number) {
    expect_free_of_all(testing::random_pair(number));
  }
}

TEST(ListedContact, FreeOnesAreTheSameWithoutTheOthersInSingularPositions) {
  for (unsigned number = 0; number < 720; ++number) {
    expect_free_of_all(testing::grid_pair(number));
  }
}

}  // namespace
}  // namespace higherpair
