#include "contact/pair_follower.hpp"
#include "contact/random_pair.hpp"
#include "higherpair/contact/contact_map.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::follower_difference;
using testing::mapped_pair;
using testing::random_pair;
using testing::RandomPair;

constexpr double kStart = -3;
constexpr double kEnd = 3;

MapRange range_of(const RandomPair& random) {
  MapRange range;
  range.start = random.pair.motion1.turns ? random.u : kStart;
  range.end = kEnd;
  range.samples = 61;
  return range;
}

void expect_all_contacts(const ContactMap& map, double u) {
  const CurveContacts list = find_curve_contacts(map.pair, u);
  const std::vector<MapContact> mapped = contacts_at(map, u);
  EXPECT_EQ(mapped.size(), list.contacts.size()) << "u = " << u;
  for (const CurveContact& contact : list.contacts) {
    const auto same = std::count_if(mapped.begin(), mapped.end(), [&](const MapContact& at) {
      return map.branches[at.branch].opposed == contact.opposed && at.point.free == contact.free &&
             follower_difference(map.pair, at.point.q, contact.q) <= 1e-9 &&
             (at.point.n_W - contact.n_W).norm() <= 1e-7;
    });
    EXPECT_EQ(same, 1) << "u = " << u << ", q = " << contact.q;
  }
}

TEST(RandomMaps, HoldEveryContactAtAnyDriverPosition) {
  for (unsigned number = 0; number < 108; ++number) {
    const RandomPair random = mapped_pair(number);
    SCOPED_TRACE(random.text);
    const ContactMap map = map_contacts(random.pair, range_of(random));
    ASSERT_EQ(map.status, MapStatus::kOk);
    EXPECT_TRUE(map.complete);
    std::mt19937 generator(number);
    for (int i = 0; i < 2; ++i) {
      expect_all_contacts(map, std::uniform_real_distribution<double>(kStart, kEnd)(generator));
    }
  }
}

TEST(RandomMap, FoldsAreTheLimitPositionsThatATrackRunsInto) {
  int compared = 0;
  for (unsigned number = 0; number < 36; ++number) {
    const RandomPair random = mapped_pair(number);
    SCOPED_TRACE(random.text);
    const ContactMap map = map_contacts(random.pair, range_of(random));
    for (const MapBranch& branch : map.branches) {
      if (!branch.opposed || branch.end.type != MapEndType::kFold || branch.points.size() < 4) {
        continue;
      }
      const MapPoint& from = *(branch.points.end() - 4);
      const int sense = from.n_W.dot(velocity_per_q(map.pair.motion2, from.p_W)) > 0 ? 1 : -1;
      const ContactResult at = solve_contact(map.pair, from.u, from.q, from.n_W, sense);
      ASSERT_EQ(at.status, ContactStatus::kOk);
      FollowedContact track = start_track(map.pair, at.at, sense);
      const TrackResult result = follow_to(track, branch.end.u + (branch.end.u - from.u) / 2);
      if (result.limit && std::abs(result.limit->u - branch.end.u) < 1e-6) {
        ++compared;
        EXPECT_NEAR(result.limit->u, branch.end.u, 1e-12 * (1 + std::abs(branch.end.u)));
        EXPECT_LE(follower_difference(map.pair, result.limit->q, branch.end.q), 1e-11);
      }
    }
  }
  EXPECT_GE(compared, 15);
}

ContactPair mirrored(ContactPair pair) {
  const auto flip = [](Vector2d& v) { v.y() = -v.y(); };
  for (Curve* curve : {&pair.curve1, &pair.curve2}) {
    flip(curve->vertex_B);
    flip(curve->axis_B);
  }
  for (OneFreedom* motion : {&pair.motion1, &pair.motion2}) {
    flip(motion->p_WO);
    flip(motion->p_BO);
    flip(motion->direction_W);
    motion->theta = -motion->theta;
    motion->R_WB = motion->R_WB.inverse();
  }
  return pair;
}

TEST(RandomMap, OfAMirroredPairIsItsMirrorImage) {
  for (unsigned number = 0; number < 36; number += 5) {
    const RandomPair random = random_pair(number);
    SCOPED_TRACE(random.text);
    MapRange range = range_of(random);
    range.samples = 13;
    const ContactMap map = map_contacts(random.pair, range);
    range.start = -range.start;
    const ContactMap mirror = map_contacts(mirrored(random.pair), range);
    EXPECT_EQ(map.branches.size(), mirror.branches.size());
    ASSERT_EQ(map.events.size(), mirror.events.size());
    for (const MapEvent& event : map.events) {
      const auto image =
          std::count_if(mirror.events.begin(), mirror.events.end(), [&](const MapEvent& other) {
            const double q = random.pair.motion2.turns ? -event.at.q : event.at.q;
            return std::abs(nearest_turn(event.at.u + other.at.u, 0)) <= 1e-12 &&
                   follower_difference(map.pair, other.at.q, q) <= 1e-11;
          });
      EXPECT_EQ(image, 1);
    }
  }
}

TEST(RandomMap, DoesNotDependOnTheUnitOfLength) {
  for (unsigned number = 0; number < 36; number += 7) {
    const RandomPair random = random_pair(number);
    MapRange range = range_of(random);
    range.samples = 13;
    const ContactMap map = map_contacts(random.pair, range);
    for (const double scale : {1e-6, 1e6}) {
      SCOPED_TRACE(random.text + ", scale " + std::to_string(scale));
      const ContactMap copy = map_contacts(testing::scaled(random.pair, scale), range);
      EXPECT_TRUE(copy.complete);
      EXPECT_EQ(map.branches.size(), copy.branches.size());
      ASSERT_EQ(map.events.size(), copy.events.size());
      for (std::size_t i = 0; i < map.events.size(); ++i) {
        EXPECT_NEAR(copy.events[i].at.u, map.events[i].at.u, 1e-12);
      }
    }
  }
}

TEST(RandomMap, CountsTwoContactsMoreOnOneSideOfEveryFold) {
  int folds = 0;
  for (unsigned number = 0; number < 36; number += 3) {
    const RandomPair random = random_pair(number);
    SCOPED_TRACE(random.text);
    const ContactMap map = map_contacts(random.pair, range_of(random));
    for (const MapEvent& event : map.events) {
      const auto count = [&](double u) {
        return static_cast<int>(find_curve_contacts(map.pair, u).contacts.size());
      };
      const auto crowded = [&](const MapEvent& other) {
        return &other != &event && std::abs(nearest_turn(other.at.u - event.at.u, 0)) < 1e-3;
      };
      if (event.at.type == CriticalType::kCrossing ||
          std::any_of(map.events.begin(), map.events.end(), crowded)) {
        continue;
      }
      // Near a cusp the two are separated only by the power 3/2 of the distance.
      const double beside = event.at.type == CriticalType::kConforming ? 1e-4 : 1e-6;
      EXPECT_EQ(std::abs(count(event.at.u + beside) - count(event.at.u - beside)), 2) << event.at.u;
      ++folds;
    }
  }
  EXPECT_GT(folds, 12);
}

}  // namespace
}  // namespace higherpair
