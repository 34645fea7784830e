// Replacing numbers in a profile's text changes nothing else, not even a space.
#include "higherpair/io/profile_document.hpp"
#include "support/texts.hpp"

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;

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

TEST(TextOfADocument, ReplacesANumberWithItsUnit) {
  EXPECT_EQ(changed("[bodies.a]\npoints.A = [\"1 in\", '2 mm'] # \"1 in\"\n",
                    {{"bodies.a.points.A.0", "26"}, {"bodies.a.points.A.1", "3"}}),
            "[bodies.a]\npoints.A = [26, 3] # \"1 in\"\n");
  EXPECT_FALSE(changed("[bodies.a]\nmass = \"1 \\u006Bg\"\n", {{"bodies.a.mass", "2"}}));
  EXPECT_FALSE(changed("[bodies.a]\nmass = \"\"\"1 kg\"\"\"\n", {{"bodies.a.mass", "2"}}));
}

TEST(TextOfADocument, HasNoPlaceForWhatItDoesNotHave) {
  for (const char* path :
       {"bodies.b.points.A.0", "bodies.a.points.A.2", "bodies.a.points.A.x", "bodies.a.points"}) {
    const auto text = changed("[bodies.a]\npoints.A = [1, 2]\n", {{path, "1"}});
    ASSERT_FALSE(text) << path;
    EXPECT_TRUE(contains(text.error(), std::string(path) + ": the text has no such value"));
  }
}

std::string overridden(const std::string& text, const std::vector<std::string>& overrides) {
  return changed(text, {}, overrides).value_or("not written");
}

TEST(TextOfADocument, HasOverridesInTheirPlaces) {
  const std::string text =
      "title = 'A'\n[bodies.a] # first\npoints.A = [1, [2], 3] # A\nmass = \"1 kg\"\nx = { k = 1, s = true "
      "}\n";
  EXPECT_EQ(overridden(text, {"title=B \"C\"", "bodies.a.points.A.0 = 2 in", "bodies.a.mass=0.5",
                              "bodies.a.x.s=false", "bodies.a.points.A.1=7e300"}),
            "title = \"B \\\"C\\\"\"\n[bodies.a] # first\npoints.A = [\"2 in\", 7e+300, 3] # A\nmass = "
            "0.5\nx = { k = 1, s "
            "= false }\n");
  EXPECT_EQ(overridden("[a]\nlist = [ # [ not this\n  1,\n]\nx = 1\n", {"a.list=[3, {k = 'v'}]"}),
            "[a]\nlist = [3, { k = \"v\" }]\nx = 1\n");
}

TEST(TextOfADocument, HasNewKeysOfOverridesBelowTheirHeadings) {
  EXPECT_EQ(overridden("# mine\n[a]\nx = 1\n[a.b]\ny = 2\n", {"a.new=3", "a.b.new=text", "title=T"}),
            "title = \"T\"\n# mine\n[a]\nnew = 3\nx = 1\n[a.b]\nnew = \"text\"\ny = 2\n");
}

TEST(TextOfADocument, HasATableAnewWhereAnOverrideHasNoPlace) {
  EXPECT_EQ(overridden("[a]\nx = 1\n", {"fit.loss=huber"}), "[a]\nx = 1\n\n[fit]\nloss = \"huber\"\n");
  EXPECT_EQ(
      overridden(
          "title = 'T' # kept\n[d]\nn = 3 # not this\n[d.v]\nr = { p = 'a' }\n[[d.o]]\nc = 1\n[[d.o]]\nc = "
          "2\n[z] # kept\nx = [\n  [1, 2],\n]\n",
          {"d.o=[{ c = 5 }]"}),
      "title = 'T' # kept\n[z] # kept\nx = [\n  [1, 2],\n]\n\n[d]\nn = 3\no = [{ c = 5 }]\n\n[d.v]\nr = { p "
      "= "
      "\"a\" }\n");
  EXPECT_EQ(overridden("b.a.x = 1\nc = 2\n[e]\n", {"b.a.y=3"}), "c = 2\n[e]\n\n[b.a]\nx = 1\ny = 3\n");
  EXPECT_EQ(overridden("[a]\nx = [1, 2]", {"a.x.2=3"}), "\n[a]\nx = [1, 2, 3]\n");
}

TEST(TextOfADocument, HasValuesInPlaceOfWhatOverridesSet) {
  EXPECT_EQ(changed("[bodies.a]\nmass = 1\n", {{"bodies.a.mass", "3"}}, {"bodies.a.mass=2"}),
            "[bodies.a]\nmass = 3\n");
  EXPECT_EQ(changed("[bodies.a]\nmass = 1\n", {{"bodies.b.pose", "{ x = 1 }"}, {"bodies.b.mass", "4"}},
                    {"bodies.b.mass=2"}),
            "\n[bodies.a]\nmass = 1\n\n[bodies.b]\npose = { x = 1 }\nmass = 4\n");
}

TEST(TextOfADocument, RefusesAnOverrideThatItCannotWrite) {
  const auto text = changed("[a]\nx = 1\n", {}, {"a.day=2026-01-02"});
  ASSERT_FALSE(text);
  EXPECT_TRUE(contains(text.error(), "a.day=2026-01-02: cannot be written into the text of the profile"));
}

}  // namespace
}  // namespace higherpair
