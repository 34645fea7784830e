#include "cam_profile.hpp"
#include "higherpair/front/contacts.hpp"
#include "support/texts.hpp"

#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Model tangent_cam() {
  return *Model::open(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/tangent_cam.toml");
}

// The roller touches the base circle from above or from below.
TEST(BoundaryLists, HaveTheContactsOfCurvesInParts) {
  const auto branches = branches_of(tangent_cam(), {.certify = true});
  ASSERT_TRUE(branches);
  const ContactReport& touch = branches->contacts.at(0);
  ASSERT_EQ(touch.entries.size(), 2U);
  EXPECT_NEAR(touch.entries[0].position, -30, 1e-12);
  EXPECT_NEAR(touch.entries[1].position, 30, 1e-12);
  for (const ContactEntry& entry : touch.entries) {
    EXPECT_TRUE(entry.opposed);
    EXPECT_TRUE(entry.free);
    EXPECT_FALSE(entry.certified);
  }
  EXPECT_TRUE(contains(touch.certificate, "not decided exactly"));
  EXPECT_TRUE(touch.complete);
  EXPECT_THAT(touch.undecided, IsEmpty());
  EXPECT_EQ(touch.proof, "proven: there are no other contacts of opposed normals");
}

// A square of 40 under a flat face, or a disc in two halves past which a roller of 15 slides.
Model sliding(const std::string& cam, const std::string& tip, double beside) {
  const std::string text = fmt::format(R"(
[bodies.ground]
points.O = [0, 0]
points.G = [{0:.17g}, 0]
[bodies.cam]
points.O = [0, 0]
curves.flank = {1}
[bodies.follower]
pose = {{ x = {0:.17g}, y = 30 }}
points.P = [0, 0]
curves.tip = {2}
[joints]
O     = {{ type = "revolute", between = ["ground.O", "cam.O"] }}
guide = {{ type = "prismatic", between = ["ground.G", "follower.P"], direction = [0, 1] }}
[contacts.touch]
between = ["cam.flank", "follower.tip"]
[driver]
joint = "O"
)",
                                       beside, cam, tip);
  return testing::model_of(text);
}

TEST(BoundaryLists, SayWhereFlatsLieOnEachOther) {
  std::string spans;
  for (const char* side : {"[-20, -20], to = [20, -20]", "[20, -20], to = [20, 20]",
                           "[20, 20], to = [-20, 20]", "[-20, 20], to = [-20, -20]"}) {
    spans += fmt::format("{}{{ type = \"segment\", from = {} }}", spans.empty() ? "" : ", ", side);
  }
  const auto branches = branches_of(sliding("{ type = \"chain\", closed = true, spans = [" + spans + "] }",
                                            "{ type = \"line\", point = [0, 0], normal = [0, -1] }", 0));
  ASSERT_TRUE(branches);
  const ContactReport& touch = branches->contacts.at(0);
  EXPECT_FALSE(touch.complete);
  ASSERT_EQ(touch.undecided.size(), 1U);
  EXPECT_NEAR(touch.undecided[0][0], 20, 1e-9);
  EXPECT_NEAR(touch.undecided[0][1], 20, 1e-9);
  EXPECT_LE(touch.undecided[0][0], 20);
  EXPECT_GE(touch.undecided[0][1], 20);
  EXPECT_EQ(
      touch.proof,
      "not proven to be all: at 20 mm contacts merge or the curves lie on each other, to within rounding");
}

// The samples of such a disc are 3 mm apart and show a single contact only.
TEST(BoundaryLists, HoldContactsThatAreNearerToEachOtherThanTheSamples) {
  const std::string cam = R"({ type = "chain", closed = true, spans = [
    { type = "arc", center = [0, 0], radius = 30, from = 7, to = 187 },
    { type = "arc", center = [0, 0], radius = 30, from = 187, to = 367 }] })";
  for (const double apart : {0.5, 1e-2, 1e-4}) {
    const auto branches = branches_of(sliding(cam, "{ type = \"circle\", center = [0, 0], radius = 15 }",
                                              std::sqrt(45 * 45 - apart * apart / 4)));
    ASSERT_TRUE(branches);
    const ContactReport& touch = branches->contacts.at(0);
    EXPECT_TRUE(touch.complete) << apart;
    ASSERT_EQ(touch.entries.size(), 2U) << apart;
    EXPECT_NEAR(touch.entries[0].position, -apart / 2, 1e-3 * apart);
    EXPECT_NEAR(touch.entries[1].position, apart / 2, 1e-3 * apart);
  }
}

TEST(BoundaryLists, AreThoseOfTheMap) {
  const auto map = map_of(tangent_cam());
  ASSERT_TRUE(map);
  std::vector<double> positions;
  for (const MapBranchReport& branch : map->contacts.at(0).branches) {
    for (const MapRow& row : branch.rows) {
      if (branch.opposed && row.driver == map->contacts[0].start) positions.push_back(row.position);
    }
  }
  EXPECT_THAT(positions, ElementsAre(DoubleNear(-30, 1e-12), DoubleNear(30, 1e-12)));
}

TEST(BoundaryLists, WholeGearsHaveNoMap) {
  const auto gears = Model::open(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/gear_teeth.toml");
  ASSERT_TRUE(gears);
  const auto map = map_of(*gears);
  ASSERT_FALSE(map);
  EXPECT_TRUE(contains(to_string(map.error()),
                       "too many parts for a map, more than 10,000 pairs: give each body a curve of "
                       "those alone that may touch, of gears one flank"));
}

TEST(BoundaryLists, OfAMapThatIsStoppedHaveNothing) {
  const std::atomic<bool> stop = true;
  MapSettings settings;
  settings.stop = &stop;
  const Model conic =
      Model::open(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/ellipse_cam_roller.toml").value();
  for (const Model& model : {tangent_cam(), conic}) {
    const auto map = map_of(model, settings);
    ASSERT_TRUE(map);
    EXPECT_TRUE(map->stopped);
    EXPECT_TRUE(map->contacts.empty());
  }
}

// A polygon with rounded corners is on one side of each of its tangents: a point far along the face has its
// foot on the small fillet, which a step by the curvature of a side passes.
TEST(BoundaryLists, AFaceOnARoundedPolygonIsFree) {
  const char* const text = R"(
[bodies.ground]
points.A = [0, 0]
points.B = [60, 0]
[bodies.cam]
points.P = [0, 0]
curves.e = { type = "chain", fillet = 1.5, spans = [
  { type = "segment", from = [-8.6, -4.1], to = [7.7, -11.8] },
  { type = "segment", from = [7.7, -11.8], to = [11.9, 3.4] },
  { type = "segment", from = [11.9, 3.4], to = [-0.3, 11.2] },
  { type = "segment", from = [-0.3, 11.2], to = [-8.6, -4.1] }] }
[bodies.out]
pose = { x = 60, angle = -25.7 }
points.P = [0, 0]
curves.r = { type = "line", point = [-50, 0], normal = -35 }
[joints]
j0 = { type = "revolute", between = ["ground.A", "cam.P"] }
j4 = { type = "revolute", between = ["ground.B", "out.P"] }
[contacts]
k = { between = ["cam.e", "out.r"] }
[driver]
joint = "j0"
)";
  for (int angle = 0; angle < 360; ++angle) {
    const auto branches =
        branches_of(testing::model_of(text, {fmt::format("driver.start={}", angle), "driver.end=400"}));
    ASSERT_TRUE(branches);
    ASSERT_EQ(branches->contacts.at(0).entries.size(), 2U) << angle;
    for (const ContactEntry& entry : branches->contacts.at(0).entries) {
      EXPECT_TRUE(entry.free) << angle;
    }
  }
}

TEST(BoundaryLists, NeedAToleranceAboveZero) {
  for (const double tolerance : {-1.0, 0.0, double(NAN)}) {
    const auto branches = branches_of(tangent_cam(), {false, tolerance});
    ASSERT_FALSE(branches) << tolerance;
    EXPECT_TRUE(contains(to_string(branches.error()), "setting tolerance"));
    MapSettings settings;
    settings.tolerance = tolerance;
    const auto map = map_of(tangent_cam(), settings);
    ASSERT_FALSE(map) << tolerance;
    EXPECT_TRUE(contains(to_string(map.error()), "setting tolerance"));
  }
}

}  // namespace
}  // namespace higherpair
