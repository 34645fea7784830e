#include "program_testing.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <sys/wait.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace {

using higherpair::testing::contains;
using higherpair::testing::shipped_profile;
using ::testing::StartsWith;

struct MapAnswer {
  std::string text;  ///< standard output and error
  int code = 0;
};

MapAnswer map_of(const std::string& arguments) {
  const std::string command = std::string(HIGHERPAIR_PROGRAM) + " map " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  MapAnswer answer;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
    answer.text += static_cast<char>(c);
  }
  answer.code = WEXITSTATUS(pclose(pipe));
  return answer;
}

nlohmann::json json_of(const std::string& arguments) {
  const MapAnswer answer = map_of(arguments + " --json -");
  EXPECT_EQ(answer.code, 0) << answer.text;
  return nlohmann::json::parse(answer.text);
}

TEST(Map, EndsTheBranchOfAMechanismThatLocksUpAtItsLimit) {
  const auto json = json_of(shipped_profile("lock_up.toml"));
  const nlohmann::json& contact = json.at("contacts").at(0);
  EXPECT_TRUE(contact.at("complete").get<bool>());
  const nlohmann::json& own = contact.at("own");
  const nlohmann::json& branch = contact.at("branches").at(own.at("branch").get<std::size_t>() - 1);
  // |O2 - C1| = 75 mm, as `analyze` reports it.
  EXPECT_NEAR(branch.at("begin").at("driver").get<double>(), -65.83442067466342, 1e-12);
  EXPECT_NEAR(branch.at("end").at("driver").get<double>(), 65.83442067466342, 1e-12);
  EXPECT_EQ(branch.at("end").at("type"), "fold");
  EXPECT_EQ(branch.at("end").at("other"), own.at("neighbour").at("branch"));
  EXPECT_EQ(own.at("nearest").at("distance"), 0.0);
  EXPECT_EQ(own.at("driver"), 0.0);
}

// A disc about its own pivot does not move its follower; any apparent motion is rounding.
TEST(Map, OfAFollowerAtRestHasNoTurningPoints) {
  const auto json =
      json_of(shipped_profile("flat_faced_translating.toml") + " --set bodies.cam.curves.disc.center=[0,0]");
  const nlohmann::json& branches = json.at("contacts").at(0).at("branches");
  EXPECT_FALSE(branches.empty());
  for (const nlohmann::json& branch : branches) {
    EXPECT_EQ(branch.at("extremes").size(), 0U);
  }
}

// A fold has a single coordinate, whichever turn the follower's pose is in.
TEST(Map, GivesAFoldTheCoordinateOfItsBranches) {
  for (const char* turns : {"-325", "35", "395"}) {
    const auto json = json_of(shipped_profile("lock_up.toml") + " --set bodies.follower.pose.angle=" + turns);
    const nlohmann::json& contact = json.at("contacts").at(0);
    int folds = 0;
    for (const nlohmann::json& event : contact.at("events")) {
      const nlohmann::json& first =
          contact.at("branches").at(event.at("branches").at(0).get<std::size_t>() - 1);
      int there = 0;
      for (const char* end : {"begin", "end"}) {
        const bool same =
            std::abs(first.at(end).at("driver").get<double>() - event.at("driver").get<double>()) < 1e-9;
        there += same ? 1 : 0;
        if (same) {
          EXPECT_NEAR(first.at(end).at("position").get<double>(), event.at("position").get<double>(), 1e-9);
        }
      }
      EXPECT_EQ(there, 1);
      ++folds;
    }
    EXPECT_GE(folds, 2) << turns;
  }
}

TEST(Map, HoldsTheFlatFacedFollowersClosedForm) {
  const auto json = json_of(shipped_profile("flat_faced_translating.toml") + " --samples 13");
  ASSERT_EQ(json.at("rows").size(), 26U);
  EXPECT_EQ(json.at("columns").size(), json.at("rows").at(0).size());
  for (const auto& row : json.at("rows")) {
    // Eccentricity 8, radius 20.
    const double lift = 8 * std::sin(row.at(2).get<double>() * std::acos(-1) / 180);
    EXPECT_NEAR(row.at(3).get<double>(), lift + (row.at(7).get<bool>() ? 20 : -20), 1e-12);
  }
}

TEST(Map, AsCsvHasAHeadWithUnitsAndOneRowASample) {
  const MapAnswer answer = map_of(shipped_profile("flat_faced_translating.toml") + " --samples 5 --csv -");
  EXPECT_EQ(answer.code, 0);
  EXPECT_THAT(
      answer.text,
      StartsWith("contact,branch,driver[deg],position[mm],x[mm],y[mm],normal[deg],opposed,free\ntouch,1,0,"));
  EXPECT_EQ(std::count(answer.text.begin(), answer.text.end(), '\n'), 11);
}

TEST(Map, TakesAsManyRowsAsTheProfile) {
  const auto json = json_of(shipped_profile("flat_faced_translating.toml") + " --set driver.samples=9");
  EXPECT_EQ(json.at("rows").size(), 18U);
}

TEST(Map, AsTextSaysWhichBranchTheMechanismIsOn) {
  const MapAnswer answer = map_of(shipped_profile("lock_up.toml"));
  EXPECT_EQ(answer.code, 0);
  EXPECT_TRUE(contains(answer.text, "contact touch: 6 branches, cam_pivot from 0 to 360 deg"));
  EXPECT_TRUE(contains(answer.text, "* the mechanism is on branch"));
  EXPECT_TRUE(
      contains(answer.text, "the driver can go back by 65.8344206747 deg and on by 65.8344206747 deg"));
}

TEST(Map, OfAChainHasEveryContactOverItsOwnKnownBody) {
  const auto json = json_of(shipped_profile("cam_chain.toml") + " --samples 7");
  ASSERT_EQ(json.at("contacts").size(), 2U);
  EXPECT_EQ(json.at("contacts").at(0).at("driver").at("joint"), "cam_pivot");
  EXPECT_EQ(json.at("contacts").at(1).at("driver").at("joint"), "arm_pivot");
  // The second contact's driver is at the position to which the first contact has moved it.
  EXPECT_EQ(json.at("contacts").at(1).at("own").at("driver"),
            json.at("contacts").at(0).at("own").at("position"));
}

TEST(Map, MarksTheSecondContactsOfAnOvalInARing) {
  const auto json = json_of(shipped_profile("oval_in_ring.toml"));
  const nlohmann::json& contact = json.at("contacts").at(0);
  const auto own = contact.at("own").at("branch").get<std::size_t>();
  const nlohmann::json& marks = contact.at("branches").at(own - 1).at("second_contacts");
  ASSERT_EQ(marks.size(), 2U);
  // The event second_contact of `analyze`.
  EXPECT_NEAR(marks.at(1).at("driver").get<double>(), 99.39339667515178, 1e-11);
}

// On the mechanism's own branch the position is the lift of the law, and the follower's turning points are
// the law's.
TEST(Map, OfACamOfAMotionLawFollowsTheLaw) {
  const auto json = json_of(shipped_profile("four_arc_cam.toml") + " --samples 9");
  const nlohmann::json& contact = json.at("contacts").at(0);
  EXPECT_TRUE(contact.at("complete").get<bool>());
  const auto own = contact.at("own").at("branch").get<std::size_t>();
  const nlohmann::json& branch = contact.at("branches").at(own - 1);
  EXPECT_EQ(branch.at("end").at("type"), "closed");
  ASSERT_EQ(branch.at("extremes").size(), 2U);
  EXPECT_NEAR(branch.at("extremes").at(1).at("driver").get<double>(), 90, 1e-11);
  EXPECT_NEAR(branch.at("extremes").at(1).at("position").get<double>(), 32, 1e-12);
  // At 45 degrees the flank is touched: 38 - 18 sin 45.
  const auto row = std::find_if(
      json.at("rows").begin(), json.at("rows").end(),
      [&](const nlohmann::json& one) { return one.at(1).get<std::size_t>() == own && one.at(2) == 45.0; });
  ASSERT_NE(row, json.at("rows").end());
  EXPECT_NEAR(row->at(3).get<double>(), 38 - 18 * std::sqrt(0.5), 1e-12);
}

// The pin is in a slot from 180 - 360/8 to 180 + 360/8 degrees, and leaves it where the slot ends.
TEST(Map, OfAGenevaWheelEndsWhereThePinLeavesItsSlots) {
  const auto json = json_of(shipped_profile("geneva_four_slots.toml") + " --samples 9");
  const nlohmann::json& branches = json.at("contacts").at(0).at("branches");
  ASSERT_EQ(branches.size(), 4U);
  for (const nlohmann::json& branch : branches) {
    EXPECT_EQ(branch.at("begin").at("type"), "end");
    EXPECT_NEAR(branch.at("begin").at("driver").get<double>(), 135, 1e-9);
    EXPECT_NEAR(branch.at("end").at("driver").get<double>(), 225, 1e-9);
  }
}

TEST(Map, OfACamWhoseRollerTurnsAboutItsOwnCentreSaysWhyThereIsNone) {
  const MapAnswer answer = map_of(
      shipped_profile("spline_cam.toml") +
      " --set bodies.follower.curves.roller.center='[0,0]' --set bodies.follower.curves.roller.radius=45");
  EXPECT_EQ(answer.code, 3);
  EXPECT_TRUE(contains(answer.text, "joint does not change their distance"));
}

TEST(Map, IsRefusedWhereNoContactHasOne) {
  const MapAnswer rolling = map_of(shipped_profile("rolling_ellipses.toml"));
  EXPECT_EQ(rolling.code, 3);
  EXPECT_TRUE(contains(rolling.text, "contacts.roll: it rolls"));
  const MapAnswer linkage = map_of(shipped_profile("four_bar.toml"));
  EXPECT_EQ(linkage.code, 3);
  EXPECT_TRUE(contains(linkage.text, "the mechanism has no contact to map"));
  const MapAnswer coupled = map_of(shipped_profile("roller_body.toml"));
  EXPECT_EQ(coupled.code, 3);
  EXPECT_TRUE(contains(coupled.text, "solved together"));
}

TEST(Map, SaysWhyADistanceThatNeverChangesHasNone) {
  const MapAnswer answer =
      map_of(shipped_profile("lock_up.toml") + " --set bodies.follower.curves.disc.center='[0,0]' --json -");
  EXPECT_EQ(answer.code, 3);
  EXPECT_TRUE(contains(answer.text, "joint does not change their distance"));
}

TEST(Map, OfAMechanismThatCannotStartIsDrawnAllTheSame) {
  const MapAnswer answer =
      map_of(shipped_profile("lock_up.toml") + " --set driver.start=180 --csv /dev/null");
  EXPECT_EQ(answer.code, 0);
  EXPECT_TRUE(contains(answer.text, "the mechanism is on no branch"));
  EXPECT_EQ(map_of(shipped_profile("lock_up.toml") + " --set driver.start=180 --csv /dev/null --quiet").text,
            "");
}

TEST(Map, RefusesWrongOptionsAndFiles) {
  EXPECT_EQ(map_of(shipped_profile("lock_up.toml") + " --samples 1").code, 2);
  EXPECT_EQ(map_of(shipped_profile("lock_up.toml") + " --tolerance -1").code, 2);
  EXPECT_EQ(map_of(shipped_profile("lock_up.toml") + " --tolerance nan").code, 2);
  EXPECT_EQ(map_of("no_such_file.toml").code, 2);
  EXPECT_EQ(map_of(shipped_profile("lock_up.toml") + " --csv /no/such/folder/map.csv").code, 1);
  EXPECT_EQ(map_of(shipped_profile("lock_up.toml") + " --csv /dev/full").code, 1);
}

}  // namespace
