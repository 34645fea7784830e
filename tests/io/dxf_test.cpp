#include "higherpair/geometry/contour.hpp"
#include "io/boundary_testing.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <sstream>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair {
namespace {

using ::testing::AllOf;
using testing::contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::lines_are;
using testing::part;

// Puts each word on a line of its own.
std::string in_lines(const std::string& words) {
  std::istringstream stream(words);
  std::string text;
  for (std::string word; stream >> word;) text += word + "\n";
  return text;
}

// A drawing with these entities; without a header "0 LINE" is on line 5.
std::string drawing(const std::string& entities, const std::string& header = "") {
  return in_lines((header.empty() ? "" : "0 SECTION 2 HEADER " + header + " 0 ENDSEC ") +
                  "0 SECTION 2 ENTITIES " + entities + " 0 ENDSEC 0 EOF");
}

std::string line(double x, double y, double to_x, double to_y, const std::string& layer = "0") {
  return fmt::format("0 LINE 8 {} 10 {} 20 {} 30 0 11 {} 21 {} 31 0 ", layer, x, y, to_x, to_y);
}

// A triangle with one side in the opposite direction.
const std::string kTriangle = line(0, 0, 7, 0) + line(7, 3, 7, 0) + line(7, 3, 0, 0);

class Dxf : public testing::ProfileWithFiles {
protected:
  [[nodiscard]] NamedCurve of(const std::string& entities, const std::string& keys = "",
                              const std::string& header = "") const {
    write("d.dxf", drawing(entities, header));
    return curve("{ type = \"dxf\", file = \"d.dxf\"" + keys + " }");
  }

  [[nodiscard]] std::vector<std::string> messages_about(const std::string& text,
                                                        const std::string& keys = "") const {
    write("d.dxf", text);
    return messages_of("{ type = \"dxf\", file = \"d.dxf\"" + keys + " }");
  }
};

double left_area(const NamedCurve& curve) {
  std::vector<ContourPiece> pieces;
  for (const SpanPtr& span : curve.boundary->spans()) {
    if (!span->is_corner()) pieces.emplace_back(span);
  }
  return enclosed_area(pieces) / 2;
}

TEST_F(Dxf, LinesInAnyOrderAndSenseAreAContour) {
  const NamedCurve triangle = of(kTriangle);
  EXPECT_TRUE(triangle.boundary->is_closed());
  EXPECT_TRUE(triangle.boundary->is_convex());
  EXPECT_NEAR(left_area(triangle), 10.5e-6, 1e-18);
  EXPECT_NEAR(left_area(of(kTriangle, ", side = \"outside\"")), -10.5e-6, 1e-18);
}

TEST_F(Dxf, UnitsAreThoseOfTheHeaderUnlessStated) {
  EXPECT_NEAR(left_area(of(kTriangle, "", "9 $ACADVER 1 AC1015 9 $INSUNITS 70 1")), 10.5 * 0.0254 * 0.0254,
              1e-15);
  EXPECT_NEAR(left_area(of(kTriangle, "", "9 $INSUNITS 70 5")), 10.5e-4, 1e-16);
  EXPECT_NEAR(left_area(of(kTriangle, "", "9 $INSUNITS 70 0")), 10.5e-6, 1e-18);
  EXPECT_NEAR(left_area(of(kTriangle, ", units = \"m\"", "9 $INSUNITS 70 4")), 10.5, 1e-12);
}

TEST_F(Dxf, ACircleKeepsItsClosedForms) {
  const NamedCurve disc = of("0 CIRCLE 8 a 10 3 20 -4 30 0 40 11");
  EXPECT_EQ(disc.boundary, nullptr);
  EXPECT_EQ(disc.curve.kind, CurveKind::kCircle);
  EXPECT_EQ(disc.curve.semi_latus, 0.011);
  EXPECT_TRUE(center(disc.curve).isApprox(Vector2d(0.003, -0.004), 1e-15));
  EXPECT_EQ(of("0 CIRCLE 8 a 10 3 20 -4 40 11", ", side = \"outside\"").curve.side, Side::kOutside);
  for (const char* end : {"6.283185307179586", "6.28318530717959"}) {  // rounded to more than a turn
    const NamedCurve oval = of(fmt::format("0 ELLIPSE 8 a 10 3 20 -4 11 5 21 0 40 0.6 41 0 42 {}", end));
    EXPECT_EQ(oval.curve.kind, CurveKind::kEllipse);
    EXPECT_NEAR(semi_axes(oval.curve)[1], 0.003, 1e-17);
  }
}

TEST_F(Dxf, ArcsGoCounterClockwiseAndSeenFromBelowClockwise) {
  // Half a disc of radius 5 about (2, 1), above or below its diameter.
  const std::string diameter = line(-3, 1, 7, 1);
  const NamedCurve above = of(diameter + "0 ARC 8 0 10 2 20 1 40 5 50 0 51 180");
  EXPECT_NEAR(left_area(above), kPi * 12.5e-6, 1e-7);
  EXPECT_EQ(above.boundary->spans().size(), 4U);
  const NamedCurve below = of(diameter + "0 ARC 8 0 10 2 20 1 40 5 50 180 51 360");
  const NamedCurve mirrored = of(diameter + "0 ARC 8 0 10 -2 20 1 40 5 50 180 51 0 210 0 220 0 230 -1");
  for (const NamedCurve& half : {below, mirrored}) {
    double least = 0;
    for (const auto& sample : half.boundary->samples()) least = std::min(least, sample.point.p_B.y());
    EXPECT_NEAR(least, -0.004, 1e-5);
  }
}

TEST_F(Dxf, EllipsesHaveEnds) {
  // A quarter of x²/25 + y²/9 = 1, moved to (1, 2) and rotated by 90 degrees, with two straight sides.
  const NamedCurve quarter =
      of(line(1, 2, 1, 7) + line(-2, 2, 1, 2) +
         "0 ELLIPSE 8 0 10 1 20 2 11 0 21 5 40 0.6 41 0 42 1.5707963267948966 210 0 220 0 230 1");
  EXPECT_TRUE(quarter.boundary->is_closed());
  EXPECT_NEAR(left_area(quarter), kPi / 4 * 15e-6, 1e-7);
  const NamedCurve below =
      of(line(1, 2, 1, 7) + line(4, 2, 1, 2) +
         "0 ELLIPSE 8 0 10 1 20 2 11 0 21 5 40 0.6 41 0 42 1.5707963267948966 210 0 220 0 230 -1");
  EXPECT_NEAR(left_area(below), kPi / 4 * 15e-6, 1e-7);
}

TEST_F(Dxf, PolylinesHaveBulges) {
  // A slot 20 long and 10 wide with round ends; a bulge of 1 is half a circle.
  const std::string old_slot =
      "0 POLYLINE 8 0 66 1 70 1 0 VERTEX 8 0 10 0 20 -5 0 VERTEX 8 0 10 20 20 -5 42 1 "
      "0 VERTEX 8 0 10 20 20 5 0 VERTEX 8 0 10 0 20 5 42 1 0 SEQEND 8 0";
  const std::string slot =
      "0 LWPOLYLINE 8 0 90 4 70 1 43 0 10 0 20 -5 10 20 20 -5 42 1 10 20 20 5 10 0 20 5 42 1";
  // One fitted by a spline keeps the vertices of the frame that controls it, which are not on the line.
  const std::string fitted =
      testing::replaced(old_slot, "0 SEQEND", "0 VERTEX 8 0 10 50 20 50 70 16 0 SEQEND");
  for (const std::string& entity : {slot, old_slot, fitted}) {
    const NamedCurve curve = of(entity);
    ASSERT_NE(curve.boundary, nullptr);
    EXPECT_EQ(curve.boundary->spans().size(), 4U);
    EXPECT_TRUE(curve.boundary->is_convex());
    EXPECT_NEAR(left_area(curve), (200 + kPi * 25) * 1e-6, 4e-7);
    EXPECT_NEAR(curve.boundary->spans()[1]->at(curve.boundary->spans()[1]->range().low).kappa, 200, 1e-9);
  }
  const NamedCurve lens = of("0 LWPOLYLINE 8 0 90 2 70 1 10 0 20 0 42 -0.3 10 20 20 0 42 -0.3");
  EXPECT_TRUE(lens.boundary->is_convex());
}

TEST_F(Dxf, SplinesMayBeRational) {
  const NamedCurve disc =
      of("0 SPLINE 8 0 70 4 71 2 72 8 73 5 40 0 40 0 40 0 40 1 40 1 40 2 40 2 40 2 "
         "10 4 20 0 41 1 10 4 20 4 41 0.7071067811865476 10 0 20 4 41 1 10 -4 20 4 41 0.7071067811865476 "
         "10 -4 20 0 41 1 " +
         line(-4, 0, 4, 0));
  EXPECT_NEAR(left_area(disc), kPi * 8e-6, 3e-7);
  for (const auto& sample : disc.boundary->samples()) {
    if (sample.point.kappa != 0) {
      EXPECT_NEAR(sample.point.kappa, 250, 1e-9);
    }
  }
  const NamedCurve cubic = of(
      "0 SPLINE 8 0 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 10 1 20 3 10 4 20 3 10 5 20 0 " +
      line(5, 0, 0, 0));
  EXPECT_NEAR(left_area(cubic), 8.1e-6, 3e-7);
}

TEST_F(Dxf, TheLayerOrTheNearestContourIsTaken) {
  const std::string two = kTriangle + "0 CIRCLE 8 bore 10 50 20 0 40 2 ";
  EXPECT_EQ(of(two, ", layer = \"bore\"").curve.kind, CurveKind::kCircle);
  EXPECT_NEAR(left_area(of(two, ", layer = \"0\"")), 10.5e-6, 1e-18);
  EXPECT_EQ(of(two, ", near = [45, 1]").curve.kind, CurveKind::kCircle);
  EXPECT_NEAR(left_area(of(two, ", near = [20, 0]")), 10.5e-6, 1e-18);
  EXPECT_TRUE(
      lines_are(messages_about(drawing(two)),
                {"test.toml:13:5: bodies.crank.curves.c: the drawing has 2 contours, from (0, 0) (line 6), "
                 "(52, 0) (line 54); say which one with `layer` (0, bore) or `near = [x, y]`"}));
  EXPECT_TRUE(lines_are(messages_about(drawing(two), ", layer = \"cam\""),
                        {part("c.layer = \"cam\": no line or curve is on this layer; there are 0, bore")}));
}

TEST_F(Dxf, WhatIsNoCurveIsLeftOut) {
  const NamedCurve triangle =
      of("999 comment 0 TEXT 8 0 10 0 20 0 40 2 1 words 0 POINT 8 0 10 1 20 1 " + line(3, 3, 3, 3) +
         kTriangle + "0 LINE 67 1 8 0 10 99 20 99 11 98 21 98 0 HATCH 8 0 10 0 20 0 ");
  EXPECT_NEAR(left_area(triangle), 10.5e-6, 1e-18);
}

TEST_F(Dxf, ReadsLinesEndedByCarriageReturnsToo) {
  std::string text = drawing(kTriangle);
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\r\n");
  write("d.dxf", "999\r\nby hand\r\n" + text);
  EXPECT_NEAR(left_area(curve("{ type = \"dxf\", file = \"d.dxf\" }")), 10.5e-6, 1e-18);
}

TEST_F(Dxf, ContoursThatDoNotCloseAreRefusedWithTheirEnds) {
  EXPECT_TRUE(
      lines_are(messages_about(drawing(line(0, 0, 7, 0) + line(7, 0, 7, 3) + line(7, 3, 0, 0.01))),
                {"test.toml:13:28: bodies.crank.curves.c.file = \"d.dxf\": line 38: the contour does not "
                 "close: nothing goes on at (0, "
                 "0.01) (line 38), and it begins at (0, 0) (line 6), 0.01 mm away; ends within `tolerance` "
                 "(3.80789e-05 mm) meet"}));
  EXPECT_THAT(messages_about(drawing(line(0, 0, 7, 0) + line(7, 0, 7, 3) + line(7, 3, 0, 0.01)),
                             ", tolerance = 0.02"),
              IsEmpty());
  EXPECT_THAT(
      messages_about(drawing(kTriangle + line(7, 0, 9, 9))),
      ElementsAre(AllOf(HasSubstr("line 6: "), HasSubstr("more than two ends meet at (7, 0) (lines 6, 22, "
                                                         "54): a contour goes on in one way only"))));
}

TEST_F(Dxf, SmallGapsAreNamedWithWhatJoinsThem) {
  const std::string square = line(-20, -20, 20.0123, -20) + line(20, -20, 20.0123, 20) +
                             line(20, 20, -19.9877, 20) + line(-20, 20, -19.9877, -20);
  EXPECT_THAT(
      messages_about(drawing(square)),
      ElementsAre(AllOf(HasSubstr("the drawing has 4 contours, from "),
                        HasSubstr(" are 0.0123 mm apart: a `tolerance` above that joins them; else say "
                                  "which one with `near = [x, y]`"))));
  EXPECT_THAT(messages_about(drawing(square), ", near = [-20, 0]"),
              ElementsAre(AllOf(HasSubstr("the contour does not close"),
                                HasSubstr(" are 0.0123 mm apart: a `tolerance` above that joins them"))));
  EXPECT_THAT(messages_about(drawing(square), ", tolerance = 0.02"), IsEmpty());
}

TEST_F(Dxf, SlightCornersAreNotedWithTheDrawingAndTheEntity) {
  write("d.dxf",
        drawing("0 POLYLINE 8 0 66 1 70 1 0 VERTEX 8 0 10 0 20 0 0 VERTEX 8 0 10 7 20 0 0 VERTEX 8 0 10 14 "
                "20 0.01 0 VERTEX 8 0 10 7 20 9 0 SEQEND 8 0 "));
  EXPECT_TRUE(lines_are(
      notes_of("{ type = \"dxf\", file = \"d.dxf\" }"),
      {"test.toml:13:5: bodies.crank.curves.c: two parts of the POLYLINE on line 6 of d.dxf meet in "
       "a corner of 0.082 deg at (7, 0): if the joint is to be smooth, give more digits"}));
}

TEST_F(Dxf, MalformedFilesAreRefusedWithTheLine) {
  const auto first = [&](const std::string& text) {
    const auto messages = messages_about(text);
    return messages.empty() ? std::string("read") : messages.front();
  };
  const std::string where = "test.toml:13:28: bodies.crank.curves.c.file = \"d.dxf\": line ";
  EXPECT_EQ(first(""), where + "1: a drawing begins with the group 0 SECTION: is this an ASCII DXF?");
  EXPECT_TRUE(contains(first("hello\nworld\n"), where + "1: a group code is a whole number up to 1071, "
                                                        "found \"hello\""));
  EXPECT_TRUE(contains(first("AutoCAD Binary DXF\r\n"), "this is a binary DXF: save the drawing as ASCII"));
  EXPECT_TRUE(contains(first("AC1015......"), "this is a DWG: save the drawing as ASCII DXF"));
  for (const std::string& wide : {std::string("\xff\xfe"
                                              "0\0\n\0",
                                              6),
                                  std::string("\xfe\xff\0000\0\n", 6), std::string("0\0\n\0S\0", 6)}) {
    EXPECT_TRUE(
        contains(first(wide), where + "1: this is in UTF-16 or UTF-32: save the drawing as ASCII DXF"));
  }
  EXPECT_TRUE(
      contains(first(in_lines("0 SECTION 2 HEADER 0 ENDSEC 0 EOF")), "the drawing has no section ENTITIES"));
  EXPECT_TRUE(contains(first(in_lines("0 SECTION 2 ENTITIES " + kTriangle)),
                       where + "52: the drawing ends without EOF: is it cut off?"));
  EXPECT_TRUE(contains(first(in_lines("0 SECTION 2 ENTITIES 0 LINE 8")), where + "7: the file ends behind a "
                                                                                 "group code"));
  EXPECT_TRUE(contains(first(in_lines("0 SECTION 2 ENTITIES " + kTriangle + "0 EOF")), "has no ENDSEC"));
  EXPECT_TRUE(contains(first(drawing("0 LINE 8 0 10 zero 20 0 11 1 21 1")),
                       where + "10: \"zero\" is not a number (group 10 of LINE)"));
  EXPECT_TRUE(contains(first(drawing("0 LINE 8 0 10 0 20 0 11 1")), where + "6: LINE has no second point "
                                                                            "(group 21)"));
  EXPECT_TRUE(contains(first(drawing("0 CIRCLE 8 0 10 +-5 20 0 40 1")), "\"+-5\" is not a number"));
  for (const char* flags : {"-1", "1e30", "0.5"}) {
    EXPECT_TRUE(
        contains(first(drawing(fmt::format("0 LWPOLYLINE 8 0 90 2 70 {} 10 0 20 0 10 2 20 0", flags))),
                 "LWPOLYLINE has flags (group 70) that are not an integer from 0 to 65535"));
  }
  EXPECT_TRUE(
      contains(first(drawing("0 CIRCLE 8 0 10 0 20 0 40 -1")), "CIRCLE has a radius that is not > 0"));
  EXPECT_TRUE(contains(first(drawing("0 ARC 8 0 10 0 20 0 40 1 50 0")), "ARC has no end angle (group 51)"));
  EXPECT_TRUE(contains(first(drawing("0 ARC 8 0 10 0 20 0 40 1 50 0 51 9 220 1 230 0")),
                       "ARC does not lie in the plane of the drawing"));
  EXPECT_TRUE(contains(first(drawing("0 ELLIPSE 8 0 10 0 20 0 11 1 21 0 40 0")),
                       "ELLIPSE has axes that are not > 0"));
  EXPECT_TRUE(contains(first(drawing("0 LWPOLYLINE 8 0 90 3 70 1 10 0 20 0 10 1 20 1")),
                       "LWPOLYLINE announces 3 vertices and has 2: is it damaged?"));
  EXPECT_TRUE(
      contains(first(drawing("0 POLYLINE 8 0 70 8 0 SEQEND")), "POLYLINE is a polyline or mesh in space"));
  EXPECT_TRUE(contains(first(drawing("0 POLYLINE 8 0 70 1 0 VERTEX 8 0 20 1 0 SEQEND")),
                       where + "12: VERTEX has no place (group 10)"));
  const auto spline = [&](const std::string& rest) { return first(drawing("0 SPLINE 8 0 " + rest)); };
  EXPECT_TRUE(contains(spline("10 0 20 0"), "SPLINE has no degree (group 71)"));
  EXPECT_TRUE(contains(spline("71 9 10 0 20 0"), "SPLINE has the degree 9: 1 to 7 are read"));
  EXPECT_TRUE(
      contains(spline("71 3 11 0 21 0 11 5 21 5"), "has points that it goes through and no control points"));
  EXPECT_TRUE(contains(spline("71 3 10 0 20 0"), "has 1 control points: its degree takes at least 4"));
  EXPECT_TRUE(contains(spline("71 1 10 0 20 0 10 1 20 0 40 0 40 1"),
                       "has 2 knots where 2 control points and degree 1 "
                       "take 4"));
  EXPECT_TRUE(contains(spline("71 1 10 0 20 0 10 1 20 0 40 0 40 2 40 1 40 3"), "has knots that fall"));
  EXPECT_TRUE(contains(spline("71 1 10 0 20 0 10 1 20 0 41 1 40 0 40 0 40 1 40 1"),
                       "has 1 weights for 2 control "
                       "points"));
  EXPECT_TRUE(contains(spline("71 1 10 0 20 0 10 1 20 0 41 1 41 0 40 0 40 0 40 1 40 1"),
                       "has a weight that is not > 0"));
  EXPECT_TRUE(contains(first(drawing(kTriangle, "9 $INSUNITS 70 17")),
                       "$INSUNITS = 17 is no unit of profiles: say what its numbers are in with `units`"));
  EXPECT_TRUE(
      contains(first(drawing("0 INSERT 8 0 2 cam 10 0 20 0")),
               "no lines or curves here, but INSERT on line 6, which is not read: take it apart (explode)"));
  EXPECT_TRUE(contains(first(drawing("0 TEXT 8 0")), "the drawing has no lines or curves here"));
  EXPECT_TRUE(
      lines_are(messages_of("{ type = \"dxf\" }"), {part("c.file is missing: expected the name of a DXF "
                                                         "file")}));
  EXPECT_TRUE(lines_are(messages_of("{ type = \"dxf\", file = \"no.dxf\" }"),
                        {part("c.file = \"no.dxf\": cannot be opened")}));
}

TEST_F(Dxf, NumbersOutOfRangeAreRefusedWithTheLine) {
  const auto expect = [&](const std::string& entities, const std::string& message,
                          const std::string& keys = "") {
    EXPECT_TRUE(lines_are(messages_about(drawing(entities), keys), {part(message)})) << entities;
  };
  const std::string wide = "\"1e308\" is too large, numbers go up to 1e50 in SI units (group ";
  expect("0 CIRCLE 8 0 10 0 20 0 40 1e308", "line 14: " + wide + "40 of CIRCLE)");
  expect("0 ARC 8 0 10 0 20 0 40 1e308 50 0 51 90", "line 14: " + wide + "40 of ARC)");
  expect("0 ARC 8 0 10 0 20 0 40 1 50 0 51 1e308", "line 18: " + wide + "51 of ARC)");
  expect("0 LWPOLYLINE 8 0 90 2 70 0 10 -1e307 20 0 10 2 20 0", "line 14: \"-1e307\" is too large");
  expect("0 CIRCLE 8 0 10 1e307 20 0 40 1", "\"1e307\" is too large", ", units = \"km\"");
  expect("0 CIRCLE 8 0 10 1e48 20 0 40 1", "\"1e48\" is too large", ", units = \"km\"");
  const std::string tiny = " has an arc too small to compute with: are the units right?";
  expect("0 CIRCLE 8 0 10 0 20 0 40 1e-310", "line 6: CIRCLE" + tiny);
  expect("0 ARC 8 0 10 0 20 0 40 1e-310 50 0 51 90", "line 6: ARC" + tiny);
  expect("0 LWPOLYLINE 8 0 90 2 70 1 10 0 20 0 42 1 10 1e-200 20 0 42 1", "line 6: LWPOLYLINE" + tiny);
  EXPECT_NEAR(of("0 CIRCLE 8 0 10 0 20 0 40 1e52").curve.semi_latus / 1e49, 1, 1e-15);
  EXPECT_EQ(of("0 CIRCLE 8 0 10 1e-320 20 1e-320 40 11").curve.semi_latus, 0.011);
}

// Between ends 100 mm apart: an arc that is as good as straight is a line, whatever its radius would be.
TEST_F(Dxf, SlightBulgesAreLines) {
  const auto spans_with = [&](const std::string& bulge) {
    const NamedCurve curve =
        of(fmt::format("0 LWPOLYLINE 8 0 90 3 70 1 10 0 20 0 42 {} 10 100 20 0 10 50 20 70", bulge));
    EXPECT_NEAR(left_area(curve), 3500e-6, 1e-7) << bulge;
    return curve.boundary->spans();
  };
  for (const char* bulge : {"1e-160", "-1e-160", "9e-9", "-9e-9"}) {
    EXPECT_EQ(spans_with(bulge).front()->range().width(), spans_with("0").front()->range().width()) << bulge;
  }
  EXPECT_NE(spans_with("1.1e-8").front()->range().width(), spans_with("0").front()->range().width());
}

// One comparison per entity and layer would take minutes.
TEST_F(Dxf, ManyLayersAreToldApartInALittleTime) {
  std::string entities;
  for (int i = 0; i < 100000; ++i) entities += fmt::format("0 INSERT 8 L{} ", i);
  EXPECT_EQ(of(entities + kTriangle, ", layer = \"0\"").boundary->spans().size(),
            of(kTriangle).boundary->spans().size());
}

TEST_F(Dxf, TenThousandEntitiesAreOneContour) {
  std::string entities;
  const int count = 10000;
  const auto at = [&](int i) {
    const double u = 2 * kPi * i / count;
    const double r = 50 + 3 * std::cos(3 * u);
    return Vector2d(r * std::cos(u), r * std::sin(u));
  };
  for (int i = 0; i < count; ++i) {
    const Vector2d a = at(i);
    const Vector2d b = at((i + 1) % count);
    entities += line(a.x(), a.y(), b.x(), b.y());
  }
  const NamedCurve curve = of(entities);
  EXPECT_TRUE(curve.boundary->is_closed());
  EXPECT_NEAR(left_area(curve) / (kPi * (2500 + 4.5) * 1e-6), 1, 1e-5);
}

// A belt about two discs: their outer tangents touch at the angles ±half.
struct Belt {
  Vector2d nose = {22.86, 0};
  double base_radius = 25.4, nose_radius = 8.89;

  [[nodiscard]] double half() const { return std::acos((base_radius - nose_radius) / nose.norm()); }
  [[nodiscard]] double turned() const { return angle_of(nose); }
  [[nodiscard]] double support(const Vector2d& n) const {
    return std::max(base_radius, nose.dot(n) + nose_radius);
  }
  [[nodiscard]] Vector2d end(bool of_nose, double sense) const {
    const Vector2d n = unit_vector(turned() + sense * half());
    return of_nose ? Vector2d(nose + nose_radius * n) : Vector2d(base_radius * n);
  }

  [[nodiscard]] std::string as_polyline(int decimals, int bulges) const {
    std::string text = "0 LWPOLYLINE 8 0 90 4 70 1 ";
    const auto add = [&](const Vector2d& p, double sweep) {
      text += fmt::format("10 {:.{}f} 20 {:.{}f} 42 {:.{}f} ", p.x(), decimals, p.y(), decimals,
                          std::tan(sweep / 4), bulges);
    };
    add(end(true, -1), 2 * half());
    add(end(true, 1), 0);
    add(end(false, 1), 2 * kPi - 2 * half());
    add(end(false, -1), 0);
    return text;
  }

  [[nodiscard]] std::string as_arcs_and_lines(int decimals) const {
    const auto arc = [&](const Vector2d& center, double radius, double from, double to) {
      return fmt::format("0 ARC 8 0 10 {1:.{0}f} 20 {2:.{0}f} 40 {3:.{0}f} 50 {4:.{0}f} 51 {5:.{0}f} ",
                         decimals, center.x(), center.y(), radius, std::fmod(from * 180 / kPi + 360, 360),
                         std::fmod(to * 180 / kPi + 360, 360));
    };
    const auto side = [&](double sense) {
      const Vector2d a = end(true, sense), b = end(false, sense);
      return fmt::format("0 LINE 8 0 10 {1:.{0}f} 20 {2:.{0}f} 11 {3:.{0}f} 21 {4:.{0}f} ", decimals, a.x(),
                         a.y(), b.x(), b.y());
    };
    return arc(nose, nose_radius, turned() - half(), turned() + half()) + side(1) +
           arc(Vector2d::Zero(), base_radius, turned() + half(), turned() - half()) + side(-1);
  }
};

// All joints are smooth, and the outline is the belt to within a few steps of the last decimal.
void expect_belt(const NamedCurve& curve, const Belt& belt, double step) {
  ASSERT_NE(curve.boundary, nullptr);
  const Boundary& boundary = *curve.boundary;
  ASSERT_EQ(boundary.spans().size(), 4U) << step;
  for (int i = 0; i < 4; ++i) {
    const Span &span = *boundary.spans()[i], &next = *boundary.spans()[(i + 1) % 4];
    const SpanPoint end = span.at(span.range().high), begin = next.at(next.range().low);
    EXPECT_NEAR(cross(end.n_B, begin.n_B), 0, 1e-14) << step;
    EXPECT_NEAR((end.p_B - begin.p_B).norm(), 0, 1e-16 + 1e-12 * step) << step;
    for (int k = 0; k <= 8; ++k) {
      const SpanPoint point = span.at(span.range().low + span.range().width() * k / 8);
      EXPECT_NEAR(1e3 * point.p_B.dot(point.n_B), belt.support(point.n_B), 5 * step);
    }
  }
}

TEST_F(Dxf, RoundedArcsMeetLinesSmoothly) {
  for (const double turn : {0.0, 0.7, 2.9, -1.3}) {
    Belt belt;
    belt.nose = belt.nose.norm() * unit_vector(turn);
    for (const int decimals : {3, 4, 6, 8, 10}) {
      const double step = std::pow(10, -decimals);
      expect_belt(of(belt.as_polyline(decimals, decimals)), belt, 60 * step);  // a bulge of 2.5, on 25.4 mm
      expect_belt(of(belt.as_polyline(decimals, decimals + 3)), belt, step);
      expect_belt(of(belt.as_arcs_and_lines(decimals)), belt, step);
    }
  }
}

// Entities that are no part of the contour say nothing about its numbers: axes and circles of a program that
// writes all digits, on another layer or on the same one.
TEST_F(Dxf, OtherEntitiesDoNotCountForItsRounding) {
  const Belt belt;
  const std::string contour = belt.as_arcs_and_lines(6);
  const std::string bore = "0 CIRCLE 8 {} 10 0.1234567890123456 20 0 40 3.3333333333333335 ";
  const std::string axis = "0 LINE 8 axes 10 -40.123456789012345 20 0 11 40.123456789012345 21 0 ";
  expect_belt(of(contour + fmt::format(fmt::runtime(bore), "axes") + axis, ", layer = \"0\""), belt, 1e-6);
  expect_belt(of(contour + fmt::format(fmt::runtime(bore), "0"), ", near = [32, 0]"), belt, 1e-6);
}

// The centre of an arc is as drawn: a base circle about the pivot stays a dwell.
TEST_F(Dxf, CirclesOfArcsAreAsDrawn) {
  const NamedCurve curve = of(Belt{}.as_arcs_and_lines(5));
  int at_base = 0;
  for (const SpanPtr& span : curve.boundary->spans()) {
    const SpanPoint middle = span->at((span->range().low + span->range().high) / 2);
    if (middle.kappa == 0 || 1 / middle.kappa < 0.02) continue;
    ++at_base;
    for (const double t : {span->range().low, span->range().high}) {
      EXPECT_NEAR(span->at(t).p_B.norm(), 25.4e-3, 1e-17);
    }
  }
  EXPECT_EQ(at_base, 1);
}

TEST_F(Dxf, CornersLargerThanRoundingStay) {
  const NamedCurve half =
      of("0 LWPOLYLINE 90 2 70 1 10 -10.000000 20 0.000000 10 10.000000 20 0.000000 42 1.000000 ");
  EXPECT_EQ(half.boundary->spans().size(), 4U);  // with two corners
  // Two half discs joined by lines, one of which is inclined by 0.02 degrees.
  const double rise = 30 * std::sin(0.02 * kPi / 180);
  const NamedCurve slot =
      of(fmt::format("0 LWPOLYLINE 90 4 70 1 10 0.000000 20 0.000000 10 30.000000 20 {:.6f} 42 1.000000 "
                     "10 30.000000 20 20.000000 10 0.000000 20 20.000000 42 1.000000 ",
                     -rise));
  EXPECT_EQ(slot.boundary->spans().size(), 5U);  // with a corner, and a notch
}

// Chords of a circle: their corners are 0.036 degrees, and the last of 4 decimals turns chords by as much.
TEST_F(Dxf, LinesMeetInCornersHoweverTheyAreRounded) {
  std::string text = "0 LWPOLYLINE 90 1000 70 1 ";
  for (int k = 0; k < 1000; ++k) {
    const Vector2d p = 20 * unit_vector(2 * kPi * k / 1000);
    text += fmt::format("10 {:.6f} 20 {:.6f} ", p.x(), p.y());
  }
  const NamedCurve curve = of(text);
  EXPECT_EQ(curve.boundary->spans().size(), 2000U);
}

}  // namespace
}  // namespace higherpair
