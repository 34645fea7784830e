// Replacing numbers in a profile's text changes nothing else, not even a space.
#include "higherpair/io/profile_document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using NewValue = ProfileDocument::NewValue;

tl::expected<std::string, std::string> changed(const std::string& text, const std::vector<NewValue>& values,
                                               const std::vector<std::string>& overrides = {}) {
  auto document = ProfileDocument::parse(text, "test.toml");
  EXPECT_TRUE(document) << to_string(document.error().front());
  document = document->with(overrides);
  return document->text_with(values);
}

TEST(TextOfADocument, KeepsCommentsSpacesAndLineEnds) {
  const std::string text =
      "# Länge in mm\r\n[bodies.crank]\r\n  points.A = [ 2,\t-0.5 ]   # pin: 2, -0.5\r\n\r\n"
      "curves.c = { type = \"circle\", center = [1e1, +3], radius = 1_000 }\r\n";
  EXPECT_EQ(changed(text, {{"bodies.crank.points.A.1", "7.25"},
                           {"bodies.crank.curves.c.center.0", "11"},
                           {"bodies.crank.curves.c.radius", "999"},
                           {"bodies.crank.points.A.0", "3"}}),
            "# Länge in mm\r\n[bodies.crank]\r\n  points.A = [ 3,\t7.25 ]   # pin: 2, -0.5\r\n\r\n"
            "curves.c = { type = \"circle\", center = [11, +3], radius = 999 }\r\n");
}

TEST(TextOfADocument, CountsCharactersNotBytes) {
  EXPECT_EQ(changed("\xEF\xBB\xBF[a]\nx = { name = \"größer ≥ 3\", v = 4 } # ≥\n", {{"a.x.v", "5"}}),
            "\xEF\xBB\xBF[a]\nx = { name = \"größer ≥ 3\", v = 5 } # ≥\n");
}

TEST(TextOfADocument, ReplacesAPoseOrAddsOne) {
  const std::string pose = "{ x = 1, y = 2, angle = 3 }";
  EXPECT_EQ(changed("[bodies.a]\npose = { x = 9, angle = \"1 rad\" } # here\nmass = 1\n",
                    {{"bodies.a.pose", pose}}),
            "[bodies.a]\npose = { x = 1, y = 2, angle = 3 } # here\nmass = 1\n");
  EXPECT_EQ(changed("[bodies.a] # first\npoints.A = [0, 0]\n[bodies.b]\nmass = 1\n",
                    {{"bodies.a.pose", pose}, {"bodies.b.pose", pose}}),
            "[bodies.a] # first\npose = { x = 1, y = 2, angle = 3 }\npoints.A = [0, 0]\n[bodies.b]\n"
            "pose = { x = 1, y = 2, angle = 3 }\nmass = 1\n");
}

TEST(TextOfADocument, HasNoPlaceForWhatItDoesNotHave) {
  for (const char* path :
       {"bodies.b.points.A.0", "bodies.a.points.A.2", "bodies.a.points.A.x", "bodies.a.name"}) {
    const auto text = changed("[bodies.a]\npoints.A = [1, 2]\nname = \"x\"\n", {{path, "1"}});
    ASSERT_FALSE(text) << path;
    EXPECT_THAT(text.error(), ::testing::HasSubstr(std::string(path) + ": the text has no such value"));
  }
  // Nor has a body that was added by an override a heading there.
  EXPECT_FALSE(changed("[bodies.a]\nmass = 1\n", {{"bodies.b.pose", "{ x = 1 }"}}, {"bodies.b.mass=2"}));
  // A value that was set by an override is not in the text.
  EXPECT_FALSE(changed("[bodies.a]\nmass = 1\n", {{"bodies.a.mass", "3"}}, {"bodies.a.mass=2"}));
}

}  // namespace
}  // namespace higherpair
