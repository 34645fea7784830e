// The mobilities in a textbook's chapter. Its drawings are not available, so each mechanism of n bodies and
// the given joints is composed anew from cranks, dyads, followers and rollers.
#include "drawn_mechanism.hpp"
#include "higherpair/mechanism/analyse_mobility.hpp"

#include <cmath>
#include <fstream>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace higherpair {
namespace {

using nlohmann::json;

json entries(const std::string& key) {
  std::ifstream file(HIGHERPAIR_TEST_DATA "/textbook.json");
  return json::parse(file).at(key);
}

// Number of parts of each kind: a crank adds one freedom, a follower on a contact and a dyad none, a roller
// on a lever an idle one; a link on two ground pins removes one.
struct Parts {
  int cranks = 0;
  int dyads = 0;
  int followers = 0;
  int rollers = 0;
  int fixed_links = 0;

  [[nodiscard]] bool possible() const { return cranks >= 0 && dyads >= 0; }
};

Parts parts_of(int n, int j1, int j2, int rollers) {
  Parts parts;
  parts.rollers = rollers;
  parts.followers = j2 - rollers;
  const int bodies = n - 1 - parts.followers - 2 * rollers;
  const int joints = j1 - parts.followers - 2 * rollers;
  // bodies = cranks + 2 dyads, joints = cranks + 3 dyads.
  parts.dyads = joints - bodies;
  parts.cranks = bodies - 2 * parts.dyads;
  if (parts.cranks == -1) {
    parts = {0, parts.dyads - 1, parts.followers, rollers, 1};
  }
  return parts;
}

// Positions of which no three are in line and no lines are parallel.
Vector2d place(int k) {
  return {0.11 * k + 0.013 * std::sin(3.1 * k), 0.05 * std::sin(1.7 * k + 0.4)};
}

DrawnMechanism draw(const Parts& parts) {
  DrawnMechanism drawn;
  int k = 0;
  int last = 0;
  Vector2d end = Vector2d::Zero();
  const auto crank = [&](const std::string& name) {
    last = drawn.crank(name, place(++k));
    end = place(k) + Vector2d(0.021, 0.063);
    drawn.drive(static_cast<int>(drawn.mechanism.joints.size()) - 1, name);
  };
  for (int i = 0; i < parts.cranks; ++i) {
    crank(fmt::format("crank{}", i));
  }
  for (int i = 0; i < parts.fixed_links; ++i) {
    last = drawn.crank(fmt::format("fixed{}", i), place(++k));
    drawn.pin(0, last, place(++k) + Vector2d(0, 0.037));
    end = place(k) + Vector2d(0.017, 0.059);
  }
  for (int i = 0; i < parts.dyads; ++i) {
    const Vector2d B = place(++k);
    const Vector2d C = B + Vector2d(-0.029, 0.083);
    last = 1 + drawn.dyad(fmt::format("dyad{}", i), last, end, 0, B, C);
    end = 0.4 * B + 0.6 * C;
  }
  for (int i = 0; i < parts.followers + parts.rollers; ++i) {
    const bool rolls = i >= parts.followers;
    if (rolls) {
      // The lever of the roller.
      ++k;
    }
    const Vector2d O = place(++k);
    const int lever = drawn.crank(fmt::format("lever{}", i), O);
    const Vector2d M = O + Vector2d(0.013, 0.071);
    int follower = lever;
    if (rolls) {
      follower = drawn.body(fmt::format("roller{}", i));
      drawn.pin(lever, follower, M);
    }
    // Two discs that touch between their centres; the lower one is fixed to an earlier body.
    const Vector2d below = M + Vector2d(-0.061, 0.011);
    const double distance = (M - below).norm();
    drawn.touch(last, *make_circle(below, 0.6 * distance), follower, *make_circle(M, 0.4 * distance));
  }
  return drawn;
}

int known(const json& entry, const char* key, int otherwise) {
  return entry.contains(key) && entry.at(key).is_number() ? entry.at(key).get<int>() : otherwise;
}

TEST(TextbookMobility, OfEveryCountThatCanBeDrawnIsFoundByCountAndRank) {
  int drawn_ones = 0;
  for (const json& entry : entries("mobility_003")) {
    const std::string label = entry.at("label").get<std::string>();
    const int n = entry.at("n").get<int>();
    int j1 = known(entry, "j1", 0);
    int j2 = known(entry, "j2", 0);
    if (entry.contains("j")) {
      j2 = entry.at("sf").get<int>() - entry.at("j").get<int>();
      j1 = entry.at("j").get<int>() - j2;
    }
    // The exceptions have tests of their own; rules for a single pin and sums of other entries are not
    // mechanisms.
    if (j1 == 0 || entry.contains("true_mobility") || label.find("discs") != std::string::npos) {
      continue;
    }
    const int idle = known(entry, "idle", 0);
    const Parts parts = parts_of(n, j1, j2, idle);
    if (!parts.possible()) {
      continue;
    }
    ++drawn_ones;
    const DrawnMechanism drawn = draw(parts);
    const Mobility mobility = analyse_mobility(drawn.mechanism);
    EXPECT_EQ(mobility.count.bodies, n) << label;
    EXPECT_EQ(mobility.count.joints(), j1 + j2) << label;
    EXPECT_EQ(mobility.count.mobility(), entry.at("M").get<int>()) << label;
    ASSERT_TRUE(mobility.assembled) << label;
    EXPECT_EQ(mobility.freedom, std::max(0, entry.at("M").get<int>())) << label;
    EXPECT_EQ(mobility.idle.size(), static_cast<std::size_t>(idle)) << label;
    EXPECT_EQ(mobility.conditions - mobility.rank, parts.fixed_links) << label;
    EXPECT_FALSE(mobility.singular) << label;
    EXPECT_TRUE(mobility.drivers_fit()) << label;
  }
  // All but the pin rule, the sum, the exceptions, and the first example, whose printed joints leave a body
  // unconnected.
  EXPECT_EQ(drawn_ones, 31);
}

TEST(TextbookMobility, OfTheParallelFiveLinkIsOneAgainstTheCount) {
  const json exception = entries("mobility_exceptions_003").at(0);
  DrawnMechanism drawn;
  const Vector2d arm(0.031, 0.067);
  const int coupler = drawn.body("coupler");
  int driven = 0;
  for (const double x : {0.0, 0.113, 0.171}) {
    const int crank = drawn.crank("crank", Vector2d(x, 0));
    driven = static_cast<int>(drawn.mechanism.joints.size()) - 1;
    drawn.pin(crank, coupler, Vector2d(x, 0) + arm);
  }
  drawn.drive(driven);
  const Mobility mobility = analyse_mobility(drawn.mechanism);
  EXPECT_EQ(mobility.count.bodies, exception.at("n").get<int>());
  EXPECT_EQ(mobility.count.joints(), exception.at("j1").get<int>());
  EXPECT_EQ(mobility.count.mobility(), exception.at("kutzbach").get<int>());
  EXPECT_EQ(mobility.freedom, exception.at("true").get<int>());
  EXPECT_FALSE(mobility.singular);
  EXPECT_TRUE(mobility.drivers_fit());
  ASSERT_EQ(mobility.redundancies.size(), 1U);
  EXPECT_EQ(mobility.redundancies.front().cause, RedundancyCause::kParallelCranks);
  EXPECT_EQ(mobility.redundancies.front().bodies.size(), 3U);
}

DrawnMechanism two_discs(bool rolling) {
  DrawnMechanism drawn;
  const Vector2d O2(0.09, 0.02);
  const int disc1 = drawn.crank("disc1", Vector2d::Zero());
  const int disc2 = drawn.crank("disc2", O2);
  drawn.touch(disc1, *make_circle(Vector2d::Zero(), 0.3 * O2.norm()), disc2,
              *make_circle(O2, 0.7 * O2.norm()), rolling);
  drawn.drive(0);
  return drawn;
}

TEST(TextbookMobility, OfDiscsThatRollBetweenFixedPivotsIsOneAgainstTheCount) {
  const json exception = entries("mobility_exceptions_003").at(1);
  const Mobility mobility = analyse_mobility(two_discs(true).mechanism);
  EXPECT_EQ(mobility.count.joints(), exception.at("j1").get<int>());
  EXPECT_EQ(mobility.count.mobility(), exception.at("kutzbach").get<int>());
  EXPECT_EQ(mobility.freedom, exception.at("true").get<int>());
  EXPECT_TRUE(mobility.drivers_fit());
  ASSERT_EQ(mobility.redundancies.size(), 1U);
  EXPECT_EQ(mobility.redundancies.front().cause, RedundancyCause::kRollingOnPivots);
}

TEST(TextbookMobility, OfDiscsThatSlideBetweenFixedPivotsIsTwoAgainstTheCount) {
  const json exception = entries("mobility_exceptions_003").at(2);
  const Mobility mobility = analyse_mobility(two_discs(false).mechanism);
  EXPECT_EQ(mobility.count.joints(), exception.at("j1").get<int>() + exception.at("j2").get<int>());
  EXPECT_EQ(mobility.count.mobility(), exception.at("kutzbach").get<int>());
  EXPECT_EQ(mobility.freedom, exception.at("true").get<int>());
  ASSERT_EQ(mobility.redundancies.size(), 1U);
  EXPECT_EQ(mobility.redundancies.front().cause, RedundancyCause::kSlidingOnPivots);
  // The disc that is not driven is idle: nothing else depends on it.
  ASSERT_EQ(mobility.idle.size(), 1U);
  EXPECT_EQ(mobility.idle.front().body, 2);
  EXPECT_TRUE(mobility.drivers_fit());
}

}  // namespace
}  // namespace higherpair
