#include "higherpair/front/branches.hpp"
#include "higherpair/front/map.hpp"

#include <atomic>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Model tangent_cam() {
  return *Model::open(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/tangent_cam.toml");
}

// The roller rests on the base circle, from above or from below.
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
  EXPECT_THAT(touch.certificate, HasSubstr("not decided exactly"));
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
  EXPECT_THAT(to_string(map.error()),
              HasSubstr("too many parts for a map, more than 10,000 pairs: give each body a curve of "
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

}  // namespace
}  // namespace higherpair
