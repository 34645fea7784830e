#include "higherpair/io/profile_reader.hpp"
#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::crank_profile;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kCamProfile;
using testing::lines_are;
using testing::messages;
using testing::part;
using testing::read;

TEST(Override, ReplacesAValueOfTheFile) {
  const Profile profile = read(kCamProfile, {"driver.samples=721", "bodies.cam.curves.disc.radius = \"1 in\"",
                                             "units.force=kN", "title=plain words"});
  EXPECT_EQ(profile.programs[0].samples, 721);
  EXPECT_EQ(profile.mechanism.bodies[1].curves[0].curve.semi_latus, 0.0254);
  EXPECT_EQ(profile.mechanism.loads[0].force, Vector2d(0, -12'000));
  EXPECT_EQ(profile.mechanism.title, "plain words");
}

TEST(Override, ReplacesItemsOfListsByNumber) {
  const Profile profile =
      read(kCamProfile, {"bodies.ground.points.O2.0=90", "contacts.touch.between.1=follower.roller"});
  EXPECT_EQ(profile.mechanism.bodies[0].points[1].p_B, Vector2d(0.09, 0));
}

TEST(Override, AppendsTheNextItemOfAList) {
  const Profile profile = read(crank_profile("positions = [1]\n"), {"driver.positions.1=5"});
  EXPECT_EQ(profile.programs[0].positions, (std::vector<double>{1, 5}));
}

TEST(Override, AddsKeysAndTablesBehindThoseOfTheFile) {
  const Profile profile =
      read(kCamProfile, {"bodies.aaa.points.P=[1, 2]", "bodies.aaa.pose.x=3", "description=\"x\"",
                         "extra.more.of.it=true", "loads.zero={ body = \"cam\", torque = 1 }"});
  ASSERT_EQ(profile.mechanism.bodies.size(), 4U);
  EXPECT_EQ(profile.mechanism.bodies[3].name, "aaa");
  EXPECT_EQ(profile.mechanism.bodies[3].points[0].p_B, Vector2d(0.001, 0.002));
  EXPECT_EQ(profile.mechanism.bodies[3].guess_p_WB.x(), 0.003);
  EXPECT_EQ(profile.mechanism.description, "x");
  EXPECT_EQ(profile.mechanism.loads[2].name, "zero");
}

TEST(Override, TheLastOneOfAKeyCounts) {
  EXPECT_EQ(read(kCamProfile, {"driver.end=10", "driver.end=20"}).programs[0].end, 20);
}

TEST(Override, ValuesThatAreNoTomlAreStrings) {
  EXPECT_EQ(read(kCamProfile, {"title=a = b"}).mechanism.title, "a = b");
  EXPECT_EQ(read(kCamProfile, {"title="}).mechanism.title, "");
  EXPECT_EQ(read(kCamProfile, {"title=one\ntwo = 2"}).mechanism.title, "one\ntwo = 2");
  EXPECT_EQ(read(kCamProfile, {"title=1\ntwo = 2"}).mechanism.title, "1\ntwo = 2");
}

TEST(Override, IsAText) {
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"title=N\xfcrnberg"}),
                        {part("is not UTF-8, as all texts of a profile are")}));
  EXPECT_EQ(read(kCamProfile, {"title=Nürnberg"}).mechanism.title, "Nürnberg");
}

TEST(Override, IsThePlaceOfItsMistakes) {
  EXPECT_TRUE(
      lines_are(messages(kCamProfile, {"driver.samples=0"}),
                {"override driver.samples=0: driver.samples = 0: must be an integer from 1 to 2^53"}));
  EXPECT_TRUE(lines_are(
      messages(kCamProfile, {"bodies.cam.curves.disc.radius=-12"}),
      {"override bodies.cam.curves.disc.radius=-12: bodies.cam.curves.disc.radius = -12 mm: must be > 0"}));
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"driver.speed=3"}),
                        {"override driver.speed=3: driver.speed: unknown key; did you mean `velocity`?"}));
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"driver.qqqqqq=3"}),
                        {part("override driver.qqqqqq=3: driver.qqqqqq: unknown key; there are joint, ")}));
}

TEST(Override, MistakesComeBehindThoseOfTheFile) {
  EXPECT_TRUE(lines_are(messages(crank_profile("samples = 0\n"), {"bodies.crank.pose.x=x", "driver.end=y"}),
                        {part("test.toml:12:11: driver.samples"), part("override bodies.crank.pose.x=x: "),
                         part("override driver.end=y: ")}));
}

// A misspelt name makes a table of its own, which then lacks most keys: that is not what is wrong.
TEST(Override, OfATableThatIsNotThereNamesTheNearest) {
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"bodies.cam.curves.disk.radius=3"}),
                        {"override bodies.cam.curves.disk.radius=3: there is no `disk` in bodies.cam.curves; "
                         "did you mean `disc`?"}));
  EXPECT_TRUE(
      lines_are(messages(kCamProfile, {"bodies.cma.curves.disc.radius=3"}),
                {"override bodies.cma.curves.disc.radius=3: there is no `cma` in bodies; did you mean "
                 "`cam`?"}));
  // A new table may have a name near to another one.
  EXPECT_EQ(read(kCamProfile, {"bodies.can.points.O=[0, 0]"}).mechanism.bodies.back().name, "can");
}

TEST(Override, OfAMisspeltKeyGetsTheNearest) {
  EXPECT_THAT(messages(kCamProfile, {"driver.stepp=3"}),
              ElementsAre(::testing::AllOf(HasSubstr("driver.stepp: unknown key; did you mean"),
                                           HasSubstr("`time_step`"))));
}

TEST(Override, APathThatLeadsNowhereIsExplained) {
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"nothing"}),
                        {"override nothing: expected PATH=VALUE, such as driver.samples=721"}));
  EXPECT_TRUE(
      lines_are(messages(kCamProfile, {"driver.samples=1,000"}),
                {part("expected an integer, found a string: a decimal number is written with a point: "
                      "1.000; if thousands are meant, write 1000")}));
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"driver.joint.x=3"}),
                        {"override driver.joint.x=3: there is no `x` in \"cam_pivot\", which is a string"}));
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"bodies.ground.points.O1.3=3"}),
                        {part("`3` is no item of a list of 2 (the first one is 0)")}));
  EXPECT_THAT(messages(kCamProfile, {"bodies.ground.points.O1.2=20"}),
              ElementsAre(::testing::AllOf(
                  HasSubstr("override bodies.ground.points.O1.2=20: bodies.ground.points.O1 = ["),
                  ::testing::EndsWith("expected a list of 2 numbers, found 3"))));
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"bodies.ground.points.O3.0=3"}),
                        {part("there is no `O3` in bodies.ground.points; did you mean `O1`")}));
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"bodies.ground.0=3"}),
                        {part("there is no list that `0` could be an item of")}));
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"bodies.ground.points.O1.x=3"}), {part("`x` is no item")}));
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"driver..end=3"}), {part("`` is no name")}));
  EXPECT_TRUE(lines_are(messages(kCamProfile, {"=3"}), {part("`` is no name")}));
}

}  // namespace
}  // namespace higherpair
