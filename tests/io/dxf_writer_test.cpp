#include "higherpair/io/dxf_writer.hpp"

#include "io/boundary_testing.hpp"
#include "support/texts.hpp"

#include <array>
#include <cmath>
#include <sstream>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::contains;
using ::testing::ElementsAre;

// Codes and values, one pair per line.
std::vector<std::string> pairs_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> pairs;
  std::string code, value;
  while (std::getline(stream, code) && std::getline(stream, value)) {
    pairs.push_back(fmt::format("{} {}", std::stoi(code), value));
  }
  return pairs;
}

const ArcPolyline kSlot = {
    {{{0.031, -0.0127}, 1}, {{0.031, 0.0127}, 0}, {{-0.031, 0.0127}, 1}, {{-0.031, -0.0127}, 0}}, true};

TEST(DxfWriter, WritesPolylinesWithBulgesInReleaseTwelve) {
  EXPECT_THAT(pairs_of(dxf_text({{"cam-slot", kSlot}}, Unit::kMillimetre)),
              ElementsAre("0 SECTION", "2 HEADER", "9 $ACADVER", "1 AC1009", "9 $INSUNITS", "70 4",
                          "9 $MEASUREMENT", "70 1", "9 $EXTMIN", "10 -43.7", "20 -12.7", "30 0.0",
                          "9 $EXTMAX", "10 43.7", "20 12.7", "30 0.0", "0 ENDSEC",                         //
                          "0 SECTION", "2 TABLES", "0 TABLE", "2 LAYER", "70 1", "0 LAYER", "2 cam-slot",  //
                          "70 0", "62 7", "6 CONTINUOUS", "0 ENDTAB", "0 ENDSEC",                          //
                          "0 SECTION", "2 ENTITIES", "0 POLYLINE", "8 cam-slot", "66 1",                   //
                          "10 0.0", "20 0.0", "30 0.0", "70 1",                                            //
                          "0 VERTEX", "8 cam-slot", "10 31.0", "20 -12.7", "30 0.0", "42 1.0",             //
                          "0 VERTEX", "8 cam-slot", "10 31.0", "20 12.7", "30 0.0",                        //
                          "0 VERTEX", "8 cam-slot", "10 -31.0", "20 12.7", "30 0.0", "42 1.0",             //
                          "0 VERTEX", "8 cam-slot", "10 -31.0", "20 -12.7", "30 0.0", "0 SEQEND",          //
                          "8 cam-slot", "0 ENDSEC", "0 EOF"));
}

// Arcs of radius 10 mm about the origin, either way round: which of the circle's extremes lie within them?
TEST(DxfWriter, HasTheExtentsOfItsArcs) {
  const struct {
    double from, to;  // [deg]
    std::array<double, 4> extents;
  } cases[] = {{50, 130, {-6.427876096865393, 7.660444431189780, 6.427876096865394, 10}},
               {100, 110, {-3.420201433256687, 9.396926207859083, -1.736481776669303, 9.848077530122081}},
               {-60, 200, {-10, -8.660254037844386, 10, 10}},
               {80, 100.0001, {-1.736498964, 9.848074499, 1.736481777, 10}}};
  const auto at = [](double degrees) { return Vector2d(0.01 * unit_vector(degrees * kPi / 180)); };
  for (const auto& one : cases) {
    const double bulge = std::tan((one.to - one.from) * kPi / 720);
    for (const bool back : {false, true}) {
      const ArcVertex first = {at(back ? one.to : one.from), back ? -bulge : bulge};
      const auto pairs =
          pairs_of(dxf_text({{"a", {{first, {at(back ? one.from : one.to), 0}}, false}}}, Unit::kMillimetre));
      const auto number = [&](std::size_t i) { return std::stod(pairs[i].substr(3)); };
      const std::array found = {number(9), number(10), number(13), number(14)};
      for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], one.extents[i], 2e-9) << one.from << ' ' << i;
    }
  }
}

TEST(DxfWriter, SaysInWhichUnitItsNumbersAre) {
  const struct {
    Unit unit;
    const char* insunits;
    const char* measurement;
    const char* x;
  } cases[] = {{Unit::kInch, "70 1", "70 0", "10 10.0"},
               {Unit::kFoot, "70 2", "70 0", "10 0.8333333333333334"},
               {Unit::kMillimetre, "70 4", "70 1", "10 254.0"},
               {Unit::kCentimetre, "70 5", "70 1", "10 25.4"},
               {Unit::kMetre, "70 6", "70 1", "10 0.254"},
               {Unit::kKilometre, "70 7", "70 1", "10 0.000254"},
               {Unit::kMicrometre, "70 13", "70 1", "10 254000.0"}};
  for (const auto& one : cases) {
    const auto pairs = pairs_of(dxf_text({{"a", {{{{0, 0}, 0}, {{0.254, 0}, 0}}, false}}}, one.unit));
    EXPECT_EQ(pairs[5], one.insunits);
    EXPECT_EQ(pairs[7], one.measurement);
    EXPECT_THAT(pairs, ::testing::Contains(one.x));
  }
}

TEST(DxfWriter, GivesEachOutlineItsLayerAndCirclesTheirType) {
  const double b = std::tan(kPi / 8);
  const ArcPolyline circle = {{{{0.03, 0.01}, b}, {{0.01, 0.03}, b}, {{-0.01, 0.01}, b}, {{0.01, -0.01}, b}},
                              true};
  const std::string text =
      dxf_text({{"ground-with_a_name_that_is_too_long_for_R12", kSlot}, {"b", circle}}, Unit::kMillimetre);
  const auto pairs = pairs_of(text);
  EXPECT_THAT(pairs,
              ::testing::IsSupersetOf({"2 ground-with_a_name_that_is_too_", "2 b", "0 CIRCLE", "8 b"}));
  EXPECT_FALSE(contains(text, "long"));
  const auto at = std::find(pairs.begin(), pairs.end(), "0 CIRCLE") - pairs.begin();
  const auto number = [&](std::ptrdiff_t i) { return std::stod(pairs[at + i].substr(3)); };
  EXPECT_NEAR(number(2), 10, 1e-14);
  EXPECT_NEAR(number(3), 10, 1e-14);
  EXPECT_NEAR(number(5), 20, 1e-14);
  // Three quarters of a circle are not a circle, nor are four arcs of two circles.
  ArcPolyline open = circle;
  open.closed = false;
  EXPECT_FALSE(contains(dxf_text({{"b", open}}, Unit::kMillimetre), "CIRCLE"));
  ArcPolyline two = circle;
  two.vertices[0].p_B.x() += 1e-6;
  EXPECT_FALSE(contains(dxf_text({{"b", two}}, Unit::kMillimetre), "CIRCLE"));
}

TEST(DxfWriter, NumbersLayersThatWouldBeAlike) {
  const std::string same(31, 'x');
  const auto pairs = pairs_of(dxf_text(
      {{same + "-a", kSlot}, {same + "-b", kSlot}, {same + "-c", kSlot}, {"b", kSlot}}, Unit::kMillimetre));
  const std::string cut = same.substr(2);
  EXPECT_THAT(pairs, ::testing::IsSupersetOf({"2 " + same, "2 " + cut + "-2", "2 " + cut + "-3", "8 " + same,
                                              "8 " + cut + "-2", "8 " + cut + "-3"}));
}

class WrittenDxf : public testing::ProfileWithFiles {};

TEST_F(WrittenDxf, IsReadBackAsItWas) {
  for (const Unit unit : {Unit::kMillimetre, Unit::kInch, Unit::kMetre}) {
    write("slot.dxf", dxf_text({{"other", {{{{1, 1}, 1}, {{1, 2}, 1}}, true}}, {"slot", kSlot}}, unit));
    const NamedCurve read = curve("{ type = \"dxf\", file = \"slot.dxf\", layer = \"slot\" }");
    ASSERT_TRUE(read.boundary);
    EXPECT_EQ(read.boundary->spans().size(), 4U);
    EXPECT_NEAR(read.boundary->size(), std::hypot(0.031 + 0.0127, 0.0127), 1e-15);
    for (const Boundary::Sample& sample : read.boundary->samples()) {
      const Vector2d p = sample.point.p_B;
      const double beyond = std::max(std::abs(p.x()) - 0.031, 0.0);
      EXPECT_NEAR(std::hypot(beyond, p.y()), 0.0127, 1e-16);
    }
  }
}

TEST_F(WrittenDxf, LayersWithLongNamesAreReadBackOneByOne) {
  const std::string name(40, 'x');
  ArcPolyline moved = kSlot;
  for (ArcVertex& vertex : moved.vertices) vertex.p_B.y() += 0.1;
  write("two.dxf", dxf_text({{name + "1", kSlot}, {name + "2", moved}}, Unit::kMillimetre));
  const std::string second = name.substr(0, 29) + "-2";
  const NamedCurve read = curve("{ type = \"dxf\", file = \"two.dxf\", layer = \"" + second + "\" }");
  ASSERT_TRUE(read.boundary);
  EXPECT_NEAR(read.boundary->middle_B().y(), 0.1, 1e-12);
}

}  // namespace
}  // namespace higherpair
