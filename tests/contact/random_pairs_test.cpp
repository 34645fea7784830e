#include "random_pairs.hpp"

#include "contact/pair_follower.hpp"
#include "contact_laws.hpp"
#include "differences.hpp"
#include "higherpair/contact/finder.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::ContactLaws;
using testing::RandomCase;
using testing::RandomPairs;

struct Counts {
  int pairs = 0;
  int found = 0;
  int rows = 0;
  int flagged = 0;
  int compared = 0;  // compared with central differences
};

std::string describe(const RandomCase& one) {
  const auto kind = [](const Curve& c) {
    return std::to_string(static_cast<int>(c.kind)) + (c.side == Side::kOutside ? "out" : "in");
  };
  return kind(one.pair.curve1) + (one.pair.motion1.turns ? " turns, " : " slides, ") + kind(one.pair.curve2) +
         (one.pair.motion2.turns ? " turns" : " slides") + ", size " + std::to_string(one.size);
}

double step_of(const RandomCase& one) {
  return (one.pair.motion1.turns ? 1.0 : one.size) * kPi / 90;
}

// A quantity of the track at some distance from its present position.
template <class Of>
auto beside(const FollowedContact& track, const Of& of) {
  return [&track, of](double offset) -> std::optional<double> {
    FollowedContact moved = track;
    if (follow_to(moved, track.at.u + offset).status != TrackStatus::kOk) return std::nullopt;
    return of(moved.at);
  };
}

void expect_rates_are_differences(const RandomCase& one, const FollowedContact& track, Counts& counts) {
  const double h = 0.03 * step_of(one);
  const auto dq = testing::difference(h, beside(track, [](const ContactPosition& at) { return at.q; }));
  const auto d2q = testing::difference(h, beside(track, [](const ContactPosition& at) { return at.dq; }));
  if (!(dq.error < 1e-2 * std::abs(dq.value)) || !(d2q.error < 1e-2 * std::abs(d2q.value))) {
    return;  // near a limit the difference is useless
  }
  ++counts.compared;
  const double q_unit = one.pair.motion2.turns ? 1 : one.size;
  const double u_unit = one.pair.motion1.turns ? 1 : one.size;
  const double rounding = 1e-10 * q_unit / u_unit * (1 + std::abs(track.at.q) / q_unit);
  EXPECT_LE(std::abs(track.at.dq - dq.value), 0.2 * dq.error + rounding + 1e-9 * std::abs(dq.value));
  EXPECT_LE(std::abs(track.at.d2q - d2q.value), 0.2 * d2q.error + 1e-9 * std::abs(d2q.value) +
                                                    1e-9 * std::abs(dq.value) / u_unit + rounding / u_unit);
}

void expect_lawful(const RandomCase& one, const ContactPosition& at) {
  const ContactLaws laws(one.pair, at);
  EXPECT_TRUE(laws.broken.empty()) << std::accumulate(
      laws.broken.begin(), laws.broken.end(), std::string(),
      [](const auto& a, const auto& b) { return a + b + "\n"; });
  EXPECT_TRUE(std::isfinite(at.q) && std::isfinite(at.dq) && std::isfinite(at.d2q) &&
              std::isfinite(at.dphi) && std::isfinite(at.sliding));
}

void run_one(const RandomCase& one, Counts& counts) {
  ++counts.pairs;
  const FindResult found = find_nearest_contact(one.pair, one.u, one.q);
  if (found.status != FindStatus::kFound) {
    return;
  }
  ++counts.found;
  expect_lawful(one, found.at);
  EXPECT_GT(ContactLaws(one.pair, found.at).conforming_, -1e-6L);
  EXPECT_LE(testing::deepest_overlap(one.pair, found.at, one.size), 1e-7 * one.size);
  FollowedContact track = start_track(one.pair, found.at, found.branch);
  for (int k = 1; k <= 60; ++k) {
    ++counts.rows;
    if (follow_to(track, one.u + k * step_of(one)).status != TrackStatus::kOk) {
      ++counts.flagged;
      continue;
    }
    SCOPED_TRACE("row " + std::to_string(k));
    expect_lawful(one, track.at);
    EXPECT_GE(track.branch * track.at.gap_q, 0);
    if (k % 10 == 0) {
      expect_rates_are_differences(one, track, counts);
    }
  }
}

TEST(RandomSeeds, GiveContactsThatObeyTheLawsOrAreFlagged) {
  for (int seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomPairs random(static_cast<unsigned>(seed));
    Counts counts;
    for (int i = 0; i < 400; ++i) {
      const RandomCase one = random.next();
      SCOPED_TRACE("pair " + std::to_string(i) + ": " + describe(one));
      run_one(one, counts);
    }
    RecordProperty("pairs", counts.pairs);
    RecordProperty("found", counts.found);
    RecordProperty("rows", counts.rows);
    RecordProperty("flagged", counts.flagged);
    RecordProperty("compared", counts.compared);
    EXPECT_GT(counts.found, counts.pairs / 3);
    EXPECT_LT(counts.flagged, counts.rows / 2);
    EXPECT_GT(counts.compared, counts.found);
  }
}

// With few rows the result is the same as with many: the same contact, or a lost one.
TEST(RandomSeeds, GiveTheSameInOneLeapAsInManyRows) {
  for (int seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomPairs random(static_cast<unsigned>(seed) + 1000);
    int compared = 0;
    for (int i = 0; i < 400; ++i) {
      const RandomCase one = random.next();
      SCOPED_TRACE("pair " + std::to_string(i) + ": " + describe(one));
      const FindResult found = find_nearest_contact(one.pair, one.u, one.q);
      if (found.status != FindStatus::kFound) continue;
      FollowedContact rows = start_track(one.pair, found.at, found.branch);
      FollowedContact leap = rows;
      bool held = true;
      for (int k = 1; k <= 40 && held; ++k) {
        held = follow_to(rows, one.u + k * step_of(one) / 2).status == TrackStatus::kOk;
      }
      const bool leapt = follow_to(leap, one.u + 20 * step_of(one)).status == TrackStatus::kOk;
      EXPECT_EQ(held, leapt);
      if (held && leapt) {
        const double unit = one.pair.motion2.turns ? 1 : one.size;
        EXPECT_LE(std::abs(rows.at.q - leap.at.q), 1e-9 * (unit + std::abs(rows.at.q)));
        ++compared;
      }
    }
    EXPECT_GT(compared, 100);
  }
}

}  // namespace
}  // namespace higherpair
