#include "higherpair/geometry/contour.hpp"
#include "io/boundary_testing.hpp"
#include "support/texts.hpp"

#include <cmath>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace higherpair {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::lines_are;
using ::testing::Not;
using testing::part;

class ProfileBoundaries : public testing::ProfileWithFiles {};

SpanPoint first(const NamedCurve& curve) {
  const SpanPtr& span = curve.boundary->spans().front();
  return span->at(span->range().low);
}

SpanPoint last(const NamedCurve& curve) {
  const SpanPtr& span = curve.boundary->spans().back();
  return span->at(span->range().high);
}

TEST_F(ProfileBoundaries, AnArcRunsCounterClockwiseWithItsMaterialInside) {
  const NamedCurve arc = curve("{ type = \"arc\", center = [3, -4], radius = 11, from = 350, to = 20 }");
  ASSERT_NE(arc.boundary, nullptr);
  EXPECT_EQ(arc.curve.kind, CurveKind::kChain);
  EXPECT_FALSE(arc.boundary->is_closed());
  const Vector2d center(0.003, -0.004);
  EXPECT_LE((first(arc).p_B - center - 0.011 * unit_vector(-kPi / 18)).norm(), 1e-16);
  EXPECT_LE((last(arc).p_B - center - 0.011 * unit_vector(kPi / 9)).norm(), 1e-16);
  EXPECT_NEAR(first(arc).kappa, 1 / 0.011, 1e-11);
  const NamedCurve hollow =
      curve("{ type = \"arc\", center = [3, -4], radius = 11, from = -10, to = 20, side = \"outside\" }");
  EXPECT_NEAR(first(hollow).kappa, -1 / 0.011, 1e-11);
  EXPECT_LE((first(hollow).p_B - last(arc).p_B).norm(), 1e-16);
}

TEST_F(ProfileBoundaries, AnArcOfAWholeTurnIsACircle) {
  const NamedCurve disc = curve("{ type = \"arc\", center = [3, -4], radius = 11, from = 90, to = 450 }");
  EXPECT_EQ(disc.boundary, nullptr);
  EXPECT_EQ(disc.curve.kind, CurveKind::kCircle);
  EXPECT_EQ(disc.curve.side, Side::kInside);
  const NamedCurve ring = curve(
      "{ type = \"arc\", center = [3, -4], radius = 11, from = 0, to = \"1 rev\", side = \"outside\" }");
  EXPECT_EQ(ring.curve.side, Side::kOutside);
  EXPECT_EQ(ring.curve.semi_latus, 0.011);
}

TEST_F(ProfileBoundaries, ASegmentHasItsMaterialOnTheLeft) {
  const NamedCurve face = curve("{ type = \"segment\", from = [1, 2], to = [1, 9] }");
  EXPECT_EQ(first(face).n_B, Vector2d(1, 0));
  EXPECT_EQ(first(face).p_B, Vector2d(0.001, 0.002));
  EXPECT_EQ(last(face).p_B, Vector2d(0.001, 0.009));
  EXPECT_EQ(first(curve("{ type = \"segment\", from = [1, 2], to = [1, 9], material = \"right\" }")).n_B,
            Vector2d(-1, 0));
}

TEST_F(ProfileBoundaries, AChainGoesThroughItsArcsAsItsSegmentsNeed) {
  // The end of a slot: the arc is concave where the material is around it.
  const std::string spans =
      "spans = [{ type = \"segment\", from = [-20, -5], to = [0, -5] }, "
      "{ type = \"arc\", center = [0, 0], radius = 5, from = -90, to = 90 }, "
      "{ type = \"segment\", from = [0, 5], to = [-20, 5] }]";
  const NamedCurve rod = curve("{ type = \"chain\", closed = false, " + spans + " }");
  ASSERT_EQ(rod.boundary->spans().size(), 3U);
  EXPECT_TRUE(rod.boundary->is_convex());
  EXPECT_EQ(rod.boundary->joint_after(0), SpanJoint::kCurvatureJump);
  EXPECT_EQ(rod.boundary->joint_after(2), SpanJoint::kEnd);
  const NamedCurve slot = curve("{ type = \"chain\", closed = false, material = \"right\", " + spans + " }");
  EXPECT_FALSE(slot.boundary->is_convex());
  EXPECT_EQ(first(slot).p_B, Vector2d(-0.02, 0.005));
  EXPECT_EQ(first(slot).n_B, Vector2d(0, -1));
}

TEST_F(ProfileBoundaries, AClosedChainMayRunEitherWay) {
  const std::string type = "{ type = \"chain\", ";
  const std::string left =
      "spans = [{ type = \"segment\", from = [0, 0], to = [7, 0] }, { type = \"segment\", from = [7, 0], to "
      "= "
      "[7, 3] }, { type = \"segment\", from = [7, 3], to = [0, 0] }]";
  const std::string right =
      "spans = [{ type = \"segment\", from = [0, 0], to = [7, 3] }, { type = \"segment\", from = [7, 3], to "
      "= "
      "[7, 0] }, { type = \"segment\", from = [7, 0], to = [0, 0] }]";
  for (const std::string& spans : {left, right}) {
    const NamedCurve plate = curve(type + spans + " }");
    EXPECT_TRUE(plate.boundary->is_closed());
    EXPECT_TRUE(plate.boundary->is_convex());
    EXPECT_EQ(plate.boundary->spans().size(), 6U);  // three corners
    const NamedCurve hole = curve(type + "side = \"outside\", " + spans + " }");
    EXPECT_FALSE(hole.boundary->is_convex());
    EXPECT_EQ(hole.boundary->joint_after(0), SpanJoint::kNotch);
  }
}

TEST_F(ProfileBoundaries, AFilletRoundsTheCornersOfAChain) {
  const NamedCurve plate = curve(
      "{ type = \"chain\", fillet = 0.5, spans = [{ type = \"segment\", from = [0, 0], to = [7, 0] }, "
      "{ type = \"segment\", from = [7, 0], to = [7, 3] }, { type = \"segment\", from = [7, 3], to = [0, 0] "
      "}] }");
  EXPECT_EQ(plate.boundary->spans().size(), 6U);
  double most = 0;
  for (const auto& sample : plate.boundary->samples()) most = std::max(most, sample.point.kappa);
  EXPECT_NEAR(most, 2000, 1e-8);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(plate.boundary->joint_after(i), SpanJoint::kCurvatureJump);
}

std::string circle_points(int count, double radius, int decimals) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double u = 2 * kPi * i / count;
    text +=
        fmt::format("[{:.{}f}, {:.{}f}], ", radius * std::cos(u), decimals, radius * std::sin(u), decimals);
  }
  return "[" + text + "]";
}

TEST_F(ProfileBoundaries, ASplineGoesThroughItsPoints) {
  const NamedCurve disc = curve("{ type = \"spline\", points = " + circle_points(36, 20, 12) + " }");
  EXPECT_TRUE(disc.boundary->is_closed());
  EXPECT_TRUE(disc.boundary->is_convex());
  EXPECT_EQ(disc.boundary->spans().size(), 1U);
  EXPECT_EQ(disc.boundary->joint_after(0), SpanJoint::kSmooth);
  EXPECT_NEAR(first(disc).kappa, 50, 1e-4);
  const NamedCurve hole =
      curve("{ type = \"spline\", side = \"outside\", points = " + circle_points(36, 20, 12) + " }");
  EXPECT_NEAR(first(hole).kappa, -50, 1e-4);
  const NamedCurve open = curve(
      "{ type = \"spline\", closed = false, first_tangent = 0, degree = 3, parameter = \"centripetal\", "
      "points = "
      "[[0, 0], [5, 1], [9, 4], [11, 9]] }");
  EXPECT_FALSE(open.boundary->is_closed());
  EXPECT_LE((first(open).n_B - Vector2d(0, -1)).norm(), 1e-12);
}

TEST_F(ProfileBoundaries, ASplineMayComeFromAFileInItsOwnUnits) {
  std::string rows = "# a disc\r\nn; y[in]; x\r\n";
  for (int i = 0; i < 40; ++i) {
    const double u = 2 * kPi * i / 40;
    rows += fmt::format("{}; {:.15g}; {:.15g}\r\n", i, 2 * std::sin(u), 5.08 * std::cos(u));
  }
  write("points.csv", "\xEF\xBB\xBF" + rows);
  const NamedCurve disc = curve("{ type = \"spline\", file = \"points.csv\", units = \"cm\" }");
  EXPECT_NEAR(first(disc).kappa, 1 / 0.0508, 1e-4);
  write("plain.txt", "0 0\n1\t0.5\n 2 2\n\n3 4\n4 +7\n5 1e1\n");
  const auto profile = read_curve("{ type = \"spline\", closed = false, file = \"plain.txt\" }");
  ASSERT_TRUE(profile);
  EXPECT_LE((last(profile->mechanism.bodies[1].curves[0]).p_B - Vector2d(0.005, 0.01)).norm(), 1e-16);
  EXPECT_THAT(profile->files, ElementsAre((folder_ / "plain.txt").string()));
}

TEST_F(ProfileBoundaries, AnInvoluteIsGivenByItsBaseCircleOrItsTooth) {
  const NamedCurve flank = curve(
      "{ type = \"involute\", center = [1, 2], base_radius = 30, start = 10, hand = \"right\", roll = [10, "
      "40] }");
  EXPECT_NEAR(first(flank).kappa, 1 / (0.03 * kPi / 18), 1e-9);
  const NamedCurve tooth = curve(
      "{ type = \"involute\", center = [0, 0], module = 2, teeth = 20, pressure_angle = 20, tooth = 90 }");
  const double r_tip = 0.002 * 11;
  EXPECT_NEAR(first(tooth).p_B.norm(), r_tip, 1e-16);  // a left flank runs inwards
  EXPECT_LT(first(tooth).n_B.x(), 0);
  EXPECT_LT(
      first(curve("{ type = \"involute\", center = [0, 0], base_radius = 30, roll = [10, 40], material = "
                  "\"right\" }"))
          .kappa,
      0);
}

TEST_F(ProfileBoundaries, AnOffsetIsOfAnyOtherCurveOfTheBody) {
  const auto profile = read_curve(
      "{ type = \"offset\", of = \"d\", by = 2 }\n"
      "d = { type = \"offset\", of = \"plate\", by = 1 }\n"
      "plate = { type = \"chain\", spans = [{ type = \"segment\", from = [0, 0], to = [7, 0] }, "
      "{ type = \"segment\", from = [7, 0], to = [7, 3] }, { type = \"segment\", from = [7, 3], to = [0, 0] "
      "}] }\n"
      "disc = { type = \"circle\", center = [1, 2], radius = 5 }\n"
      "larger = { type = \"offset\", of = \"disc\", by = 1.5 }\n"
      "ring = { type = \"circle\", center = [1, 2], radius = 5, side = \"outside\" }\n"
      "narrower = { type = \"offset\", of = \"ring\", by = 1.5 }\n"
      "face = { type = \"line\", point = [1, 2], normal = [0, 1] }\n"
      "higher = { type = \"offset\", of = \"face\", by = 1.5 }\n"
      "edge = { type = \"point\", at = [1, 2] }\n"
      "round = { type = \"offset\", of = \"edge\", by = 1.5 }\n"
      "oval = { type = \"ellipse\", center = [1, 2], semi_axes = [5, 3] }\n"
      "around = { type = \"offset\", of = \"oval\", by = 1.5 }\n");
  ASSERT_TRUE(profile) << to_string(profile.error().front());
  const auto& curves = profile->mechanism.bodies[1].curves;
  double least = 1e9;
  double most = 0;
  for (const auto& sample : curves[0].boundary->samples()) {
    least = std::min(least, sample.point.p_B.y());
    most = std::max(most, sample.point.kappa);
  }
  EXPECT_NEAR(least, -0.003, 1e-16);
  EXPECT_NEAR(most, 1 / 0.003, 1e-9);
  EXPECT_NEAR(curves[4].curve.semi_latus, 0.0065, 1e-17);
  EXPECT_NEAR(curves[6].curve.semi_latus, 0.0035, 1e-17);
  EXPECT_EQ(curves[6].curve.side, Side::kOutside);
  EXPECT_LE((curves[8].curve.vertex_B - Vector2d(0.001, 0.0035)).norm(), 1e-17);
  EXPECT_EQ(curves[8].curve.axis_B, Vector2d(0, -1));
  EXPECT_EQ(curves[10].curve.kind, CurveKind::kCircle);
  EXPECT_EQ(curves[12].name, "around");
  EXPECT_NEAR((first(curves[12]).p_B - Vector2d(0.001, 0.002)).norm(), 0.0065, 1e-16);
}

TEST_F(ProfileBoundaries, TheShippedCamsAreWhatTheirCommentsSay) {
  const auto boundary = [](const std::string& name) {
    const auto profile = read_profile_file(HIGHERPAIR_SOURCE_DIR "/profiles/" + name + ".toml");
    EXPECT_TRUE(profile);
    return profile->mechanism.bodies[1].curves[0].boundary;
  };
  const auto four_arc = boundary("four_arc_cam");
  EXPECT_EQ(four_arc->spans().size(), 4U);  // no corner
  EXPECT_TRUE(four_arc->is_convex());
  const auto tangent = boundary("tangent_cam");
  EXPECT_EQ(tangent->spans().size(), 4U);
  EXPECT_TRUE(tangent->is_convex());
  const auto table = boundary("spline_cam");
  EXPECT_TRUE(table->is_convex());
  for (const auto& sample : table->samples()) {
    const double u = angle_of(sample.point.p_B);
    EXPECT_NEAR(sample.point.p_B.norm(), 1e-3 * (24 + 4 * std::cos(u) + 1.5 * std::cos(2 * u)), 1e-12);
  }
}

// --- Messages

TEST_F(ProfileBoundaries, WrongNumbersOfArcsAndSegmentsAreRefused) {
  EXPECT_TRUE(lines_are(messages_of("{ type = \"arc\", center = [0, 0], radius = -5, from = 0, to = 90 }"),
                        {"test.toml:13:47: bodies.crank.curves.c.radius = -5 mm: must be > 0"}));
  EXPECT_TRUE(
      lines_are(messages_of("{ type = \"arc\", center = [0, 0], radius = 1e-310, from = 0, to = 360 }"),
                {part("c.radius = 1e-310: has numbers too large or too small to compute with")}));
  EXPECT_TRUE(lines_are(messages_of("{ type = \"arc\", center = [0, 0], radius = 5, from = 30, to = 30 }"),
                        {"test.toml:13:66: bodies.crank.curves.c.to = 30: an arc goes counter-clockwise from "
                         "`from` to `to`: 0 deg from here to there"}));
  EXPECT_TRUE(lines_are(messages_of("{ type = \"arc\", center = [0, 0], radius = 5, from = 0, to = 361 }"),
                        {part("more than a turn from here to there")}));
  for (const std::string ends : {"0, to = -360", "360, to = 0", "90, to = -270", "0, to = -720"}) {
    EXPECT_TRUE(
        lines_are(messages_of("{ type = \"arc\", center = [0, 0], radius = 5, from = " + ends + " }"),
                  {part("whole turns clockwise from here to there; for a whole circle exchange the two")}))
        << ends;
  }
  EXPECT_TRUE(lines_are(messages_of("{ type = \"arc\", center = [0, 0], radius = 5, from = 0, to = 1e-12 }"),
                        {part("0 deg from here to there")}));
  EXPECT_TRUE(lines_are(
      messages_of("{ type = \"arc\", center = [0, 0], radius = 5, from = 0, to = 90, material = \"left\" }"),
      {part("c.material = \"left\": this curve has its material inside or outside: `side`")}));
  EXPECT_TRUE(
      lines_are(messages_of("{ type = \"segment\", from = [1, 2], to = [1, 2] }"),
                {"test.toml:13:45: bodies.crank.curves.c.to = [1, 2]: is where it begins: a segment has "
                 "two different ends"}));
  EXPECT_TRUE(lines_are(
      messages_of("{ type = \"segment\", from = [1, 2], to = [1, 3], side = \"inside\", lenght = 2 }"),
      {part("c.side = \"inside\": an open curve has its material on the left or right of its "
            "direction: `material`"),
       part("c.lenght: unknown key")}));
}

TEST_F(ProfileBoundaries, GapsOfChainsAreRefusedWithBothEnds) {
  EXPECT_TRUE(lines_are(
      messages_of(
          "{ type = \"chain\", closed = false, spans = [{ type = \"segment\", from = [0, 0], to = [7, 0] }, "
          "{ type = \"segment\", from = [7, 0.2], to = [7, 3] }] }"),
      {"test.toml:13:5: bodies.crank.curves.c: spans.0 ends at (7, 0) and spans.1 begins at (7, 0.2), "
       "0.2 mm away; ends within `tolerance` (3.80789e-05 mm) meet"}));
  EXPECT_TRUE(lines_are(
      messages_of("{ type = \"chain\", spans = [{ type = \"segment\", from = [0, 0], to = [7, 0] }, "
                  "{ type = \"segment\", from = [7, 0], to = [7, 3] }] }"),
      {part("spans.1 ends at (7, 3) and spans.0 begins at (0, 0), 7.61577 mm away: it does not "
            "close (closed = false is open)")}));
  EXPECT_THAT(
      messages_of(
          "{ type = \"chain\", closed = false, tolerance = 0.3, spans = [{ type = \"segment\", from = [0, "
          "0], to = [7, 0] }, { type = \"segment\", from = [7, 0.2], to = [7, 3] }] }"),
      IsEmpty());
}

TEST_F(ProfileBoundaries, MistakesInChainsNameTheSpan) {
  EXPECT_TRUE(
      lines_are(messages_of("{ type = \"chain\", spans = [] }"),
                {"test.toml:13:31: bodies.crank.curves.c.spans = []: expected a list of spans, [{ type = "
                 "\"arc\", … }, …]"}));
  EXPECT_TRUE(
      lines_are(messages_of("{ type = \"chain\" }"), {part("c.spans is missing: expected a list of spans")}));
  EXPECT_TRUE(lines_are(messages_of("{ type = \"chain\", spans = [3] }"),
                        {part("c.spans.0 = 3: expected a span (a table), found an integer")}));
  EXPECT_TRUE(
      lines_are(messages_of("{ type = \"chain\", spans = [{ type = \"circle\" }] }"),
                {part("c.spans.0.type = \"circle\": expected one of arc, segment, spline, involute")}));
  EXPECT_TRUE(lines_are(
      messages_of(
          "{ type = \"chain\", closed = false, spans = [{ type = \"segment\", from = [0, 0], to = [1, "
          "0], side = \"inside\" }] }"),
      {part("belongs to the chain as a whole, not to one of its spans")}));
}

TEST_F(ProfileBoundaries, FilletsThatDoNotFitAreRefusedWithTheLargestThatDoes) {
  const std::string sides =
      "{ type = \"segment\", from = [0, 0], to = [7, 0] }, { type = \"segment\", from = [7, 0], to = [7, 3] "
      "}, "
      "{ type = \"segment\", from = [7, 3], to = [0, 3] }, { type = \"segment\", from = [0, 3], to = [0, 0] "
      "}] }";
  EXPECT_TRUE(
      lines_are(messages_of("{ type = \"chain\", fillet = 1.6, spans = [" + sides),
                {"test.toml:13:32: bodies.crank.curves.c.fillet = 1.6: is too large for the corner at (7, 3) "
                 "between spans.1 and spans.2; up to 1.5 mm fits everywhere"}));
  EXPECT_TRUE(lines_are(messages_of("{ type = \"chain\", fillet = -1, spans = [" + sides),
                        {part("c.fillet = -1 mm: must be >= 0")}));
  EXPECT_TRUE(lines_are(
      messages_of(
          "{ type = \"chain\", closed = false, fillet = 1, spans = [{ type = \"segment\", from = [0, 0], "
          "to = [7, 0] }, { type = \"segment\", from = [7, 0], to = [2, 0] }] }"),
      {part("the curve reverses its direction, there is no rounding the corner at (7, 0)")}));
  EXPECT_TRUE(lines_are(
      messages_of(
          "{ type = \"chain\", closed = false, fillet = 1, spans = [{ type = \"segment\", from = [0, 0], "
          "to = [7, 0] }, { type = \"spline\", degree = 3, points = [[7, 0], [7, 2], [6, 3], [3, 4]] }] }"),
      {part("rounds corners between segments and arcs only: not the corner at (7, 0)")}));
}

TEST_F(ProfileBoundaries, SlightCornersAreNoted) {
  EXPECT_TRUE(lines_are(
      notes_of(
          "{ type = \"chain\", closed = false, spans = [{ type = \"segment\", from = [0, 0], to = [7, 0] }, "
          "{ type = \"segment\", from = [7, 0], to = [14, 0.01] }] }"),
      {"test.toml:13:5: bodies.crank.curves.c: spans.0 and spans.1 meet in a corner of 0.082 deg at (7, "
       "0): if the joint is to be smooth, give more digits, or leave it to `fillet`"}));
}

// At their joints the spans of a rounded pentagon are parallel to within rounding.
TEST_F(ProfileBoundaries, ParallelSpansAtAJointDoNotCross) {
  EXPECT_THAT(messages_of(R"({ type = "chain", spans = [
    { type = "arc", center = [14.652119973774047, -0.770338176078857], radius = 7.521869292568327, from = 67.74889939719692, to = 135.34009081745992 },
    { type = "segment", from = [9.301878455663438, 4.516762480459452], to = [-2.212017500286215, -7.134637441830136] },
    { type = "arc", center = [1.8928123981323388, -11.191024200716287], radius = 5.77095330362478, from = 135.34009081745992, to = 207.09617731700652 },
    { type = "segment", from = [-3.244739514040612, -13.819609824649017], to = [1.225146789153753, -22.555970822398876] },
    { type = "arc", center = [5.982640437488241, -20.121838842081022], radius = 5.344038202665575, from = -152.90382268299345, to = -101.16258906849225 },
    { type = "segment", from = [4.948067768366682, -25.36477730289246], to = [18.004105963815878, -27.941084536895048] },
    { type = "arc", center = [19.26170392745831, -21.567913343983577], radius = 6.496065246925576, from = -101.16258906849225, to = -27.471972102236105 },
    { type = "segment", from = [25.02525080176716, -24.564643415237725], to = [31.497180140622064, -12.117320091220726] },
    { type = "arc", center = [22.02686906409778, -7.193274775712671], radius = 10.673940891503726, from = -27.471972102236126, to = 67.74889939719694 },
    { type = "segment", from = [26.06873179390447, 2.6858122179682216], to = [17.50039911089285, 6.191401808403191] },
  ] })"),
              IsEmpty());
}

TEST_F(ProfileBoundaries, ACurveThatCrossesItselfIsRefusedWithThePlace) {
  EXPECT_TRUE(lines_are(
      messages_of(
          "{ type = \"chain\", spans = [{ type = \"segment\", from = [0, 0], to = [2, 2] }, { type = "
          "\"segment\", from = [2, 2], to = [2, 0] }, { type = \"segment\", from = [2, 0], to = [0, 2] }, "
          "{ type = \"segment\", from = [0, 2], to = [0, 0] }] }"),
      {"test.toml:13:5: bodies.crank.curves.c: crosses itself at (1, 1), where spans.0 and spans.2 "
       "meet: a boundary does not"}));
  std::string points;
  for (int i = 0; i < 24; ++i) {
    const double u = 2 * kPi * (i + 0.5) / 24;
    points += fmt::format("[{}, {}], ", 30 * std::sin(u), 10 * std::sin(2 * u));
  }
  EXPECT_THAT(messages_of("{ type = \"spline\", points = [" + points + "] }"),
              ElementsAre(AllOf(HasSubstr("crosses itself at ("), HasSubstr("behind points.11"),
                                HasSubstr("behind points.23"), HasSubstr("are the points in their order?"))));
}

TEST_F(ProfileBoundaries, SplinesSayWhichPointIsWrong) {
  const auto spline = [&](const std::string& rest) {
    return messages_of("{ type = \"spline\", " + rest + " }");
  };
  EXPECT_TRUE(lines_are(spline("closed = false"),
                        {part("c.points is missing: expected [[x, y], …] (or a `file` with them)")}));
  EXPECT_TRUE(
      lines_are(spline("points = [[0, 0], [1, 0], [1, 1]]"),
                {"test.toml:13:5: bodies.crank.curves.c: 3 points are too few: degree 5 takes at least 6, "
                 "`degree = 3` at least 4"}));
  EXPECT_TRUE(
      lines_are(spline("points = [[0, 0], [1, 0], [1, 0], [2, 1], [1, 2], [0, 1]]"),
                {"test.toml:13:42: bodies.crank.curves.c: points.1 and points.2 are the same point (1, 0): "
                 "leave one out (of a corner make a chain of several splines)"}));
  EXPECT_TRUE(lines_are(spline("points = [[0, 0], [2, 0], [1, 0.1], [3, 0], [4, 1], [2, 3]]"),
                        {"test.toml:13:42: bodies.crank.curves.c: the curve reverses its direction at "
                         "points.1, (2, 0): are the "
                         "points in their order along the curve?"}));
  EXPECT_THAT(
      spline("points = [[0, 0], [1, 0], [2, 0.2], [3, 0.6], [4, 1.2], [5, 2], [6, 3]]"),
      ElementsAre(AllOf(HasSubstr("does not close: from points.6, (6, 3), back to points.0, (0, 0), it is "
                                  "6.7082 mm, 4.74 times the largest step; points are missing, or closed = "
                                  "false"))));
  EXPECT_TRUE(lines_are(spline("points = [[0, 0], [1, \"2 kg\"]]"), {part("c.points.1.1 = \"2 kg\"")}));
  EXPECT_TRUE(
      lines_are(spline("points = 3"), {part("c.points = 3: expected a list of points, [[x, y], …]")}));
  const std::string square = "points = [[0, 0], [2, 0], [4, 1], [5, 3], [4, 5], [1, 4]]";
  EXPECT_THAT(spline(square), IsEmpty());
  EXPECT_TRUE(lines_are(spline("degree = 4, " + square),
                        {part("c.degree = 4: expected 3 or 5: with 5 the curvature is smooth")}));
  EXPECT_TRUE(lines_are(spline("smoothing = -1, " + square), {part("c.smoothing = -1 mm: must be >= 0")}));
  EXPECT_TRUE(
      lines_are(spline("parameter = \"chord\", " + square), {part("expected one of arc, centripetal")}));
  EXPECT_TRUE(lines_are(spline("first_tangent = 3, " + square), {part("a closed spline has no ends")}));
  EXPECT_TRUE(lines_are(spline("closed = false, smoothing = 1, last_tangent = 3, " + square),
                        {part("holds for a spline through its points: without `smoothing`")}));
  EXPECT_TRUE(lines_are(spline("units = \"mm\", " + square), {part("is that of a file")}));
  EXPECT_TRUE(
      lines_are(spline("file = \"p.csv\", " + square), {part("the points are given already by `points`")}));
}

TEST_F(ProfileBoundaries, FilesOfPointsSayTheirLine) {
  const auto file = [&](const std::string& text, const std::string& rest = "") {
    write("p.csv", text);
    return messages_of("{ type = \"spline\", file = \"p.csv\"" + rest + " }");
  };
  const std::string where = "test.toml:13:31: bodies.crank.curves.c.file = \"p.csv\": ";
  EXPECT_TRUE(lines_are(
      messages_of("{ type = \"spline\", file = \"no.csv\" }"),
      {"test.toml:13:31: bodies.crank.curves.c.file = \"no.csv\": cannot be opened: No such file or "
       "directory"}));
  EXPECT_TRUE(lines_are(file("0, 0\n1, 0\n2, x\n3\n"),
                        {where + "line 3: `x` is no number", where + "line 4: expected 2 columns, found 1"}));
  EXPECT_TRUE(
      lines_are(file("0,5; 0\n"),
                {where + "line 1: `0,5` is no number: a decimal number is written with a point: 0.5"}));
  EXPECT_TRUE(lines_are(file("1 000; 0\n"),
                        {where + "line 1: `1 000` is no number: write 1000: no separator of thousands"}));
  EXPECT_TRUE(lines_are(file("0\u00a0; 0\n1, 0\n"), {where + "line 2: expected 2 columns, found 1"}));
  EXPECT_TRUE(lines_are(file("0,5,1,5\n"), {part("decimals are written with a point")}));
  EXPECT_TRUE(lines_are(file("n, a, b\n1, 2, 3\n"), {part("line 1: expected two columns, x and y")}));
  EXPECT_TRUE(lines_are(file("x[kg], y\n1, 2\n"), {part("line 1: x[kg]: kg is a mass, expected a length")}));
  EXPECT_TRUE(
      lines_are(file("x;y\nmm;mm\n1;2\n"),
                {where + "line 2: `mm` is no number: units follow the names in the first line, x[mm]"}));
  EXPECT_TRUE(lines_are(file("x,y\n1 GPa,2\n3[GPa],4\n"), {part("`1 GPa` is no number"), part("no number")}));
  EXPECT_TRUE(
      lines_are(file("x;y\n[GPa];mm\n1;2\n"), {part("units follow the names in the first line, x[GPa]")}));
  EXPECT_TRUE(lines_are(file(",x,y\n0,1,2\n1,x,4\n"), {where + "line 3: `x` is no number"}));
  EXPECT_TRUE(lines_are(file("+-5,1\n"), {part("`+-5` is no number")}));
  EXPECT_TRUE(lines_are(file("driver,a.x,a.y,b.x,b.y\n0,1,2,3,4\n"),
                        {where + "line 1: several columns may be x: a.x, b.x; leave one of them"}));
  EXPECT_TRUE(lines_are(file("1e60 2\n"), {part("line 1: 1e+60 is too large")}));
  EXPECT_TRUE(lines_are(file("1 nan\n"), {part("`nan` is no number")}));
  EXPECT_TRUE(lines_are(file(""), {where + "has no points"}));
  EXPECT_TRUE(lines_are(file("1 2\n", ", units = \"kg\""),
                        {part("c.units = \"kg\": expected a unit of length: m, cm, mm, um, km, in, ft")}));
  EXPECT_TRUE(lines_are(file("0 0\n1 0\n2 1\n2 1\n1 2\n0 1\n"),
                        {part("c: line 3 and line 4 are the same point (2, 1)")}));
}

TEST_F(ProfileBoundaries, TheNoiseOfARoundedTableIsNoted) {
  const auto text = [&](int decimals, const std::string& rest) {
    return notes_of("{ type = \"spline\", points = " + circle_points(720, 20, decimals) + rest + " }");
  };
  EXPECT_THAT(text(9, ""), IsEmpty());
  EXPECT_TRUE(
      lines_are(text(3, ""),
                {"test.toml:13:5: bodies.crank.curves.c: points rounded to 0.001 mm, 0.175 mm apart, put "
                 "noise of up to 0.11 1/mm into a curvature of 0.058 1/mm, and as large a part into "
                 "accelerations; `smoothing = 0.001` takes most of it away (`rounding` says how exact they "
                 "are)"}));
  EXPECT_THAT(text(3, ", smoothing = 0.001"), IsEmpty());
  EXPECT_THAT(text(3, ", rounding = 1e-9"), IsEmpty());
  EXPECT_TRUE(lines_are(text(9, ", rounding = \"1 um\""), {part("points rounded to 0.001 mm")}));
}

TEST_F(ProfileBoundaries, InvolutesAreHeldToTheirBaseCircle) {
  const auto involute = [&](const std::string& rest) {
    return messages_of("{ type = \"involute\", center = [0, 0], " + rest + " }");
  };
  EXPECT_TRUE(
      lines_are(involute("roll = [10, 40]"),
                {part("c.base_radius is missing: expected the radius of the base circle (or module and "
                      "teeth)")}));
  EXPECT_TRUE(lines_are(involute("base_radius = 3"), {part("c.roll is missing: expected [from, to]")}));
  EXPECT_TRUE(lines_are(involute("base_radius = 3, roll = [0, 40]"),
                        {part("c.roll = [0, 40]: must begin above 0: on the base circle the involute has a "
                              "cusp")}));
  EXPECT_TRUE(
      lines_are(involute("base_radius = 3, roll = [50, 40]"), {part("must end above where it begins")}));
  EXPECT_TRUE(lines_are(involute("base_radius = 3, roll = [5, 40], teeth = 20"),
                        {part("c.teeth = 20: goes with `module`, in place of `base_radius`")}));
  EXPECT_TRUE(lines_are(involute("module = 2"), {part("c.teeth is missing")}));
  EXPECT_TRUE(lines_are(involute("module = 2, teeth = 2"), {part("must be at least 3")}));
  EXPECT_TRUE(lines_are(involute("module = 2, teeth = 20, pressure_angle = 70"),
                        {part("must be above 0 and below 60 deg")}));
  EXPECT_TRUE(lines_are(involute("module = 2, teeth = 20, base_radius = 3"), {part("leave it out")}));
  EXPECT_TRUE(lines_are(involute("module = 2, teeth = 20, start = 3"), {part("follows from `tooth`")}));
  EXPECT_THAT(involute("module = 2, teeth = 12"),
              ElementsAre(AllOf(HasSubstr("(undercut, below 17.0973 teeth"),
                                HasSubstr("a `profile_shift` of 0.2982 at least, or give the part"))));
  EXPECT_THAT(involute("module = 2, teeth = 12, profile_shift = 0.2982"), IsEmpty());
  EXPECT_TRUE(lines_are(involute("module = 2, teeth = 20, backlash = -0.1"), {part("must be >= 0")}));
  EXPECT_TRUE(lines_are(involute("base_radius = 3, roll = [5, 40], backlash = 0.1"),
                        {part("c.backlash = 0.1: goes with `module`")}));
  EXPECT_THAT(involute("module = 2, teeth = 12, roll = [5, 30]"), IsEmpty());
}

TEST_F(ProfileBoundaries, GearsAreHeldToWhatARackLeavesOfThem) {
  const auto gear = [&](const std::string& rest) { return messages_of("{ type = \"gear\", " + rest + " }"); };
  EXPECT_THAT(gear("center = [0, 0], module = 2, teeth = 20"), IsEmpty());
  EXPECT_TRUE(lines_are(gear("module = 2, teeth = 20"), {part("c.center is missing")}));
  EXPECT_TRUE(lines_are(gear("center = [0, 0], teeth = 20"), {part("c.module is missing")}));
  EXPECT_TRUE(lines_are(gear("center = [0, 0], module = 2, teeth = 999999999"),
                        {part("c.teeth = 999999999: must be at most 1000")}));
  EXPECT_TRUE(lines_are(gear("center = [0, 0], module = 2"), {part("c.teeth is missing")}));
  EXPECT_TRUE(lines_are(gear("center = [0, 0], module = 2, teeth = 20, roll = [5, 30]"),
                        {part("c.roll: unknown key")}));
  EXPECT_THAT(gear("center = [0, 0], module = 2, teeth = 12"),
              ElementsAre(AllOf(HasSubstr("a `profile_shift` of 0.2982 at least"), Not(HasSubstr("roll")))));
  EXPECT_TRUE(lines_are(gear("center = [0, 0], module = 2, teeth = 9, profile_shift = 0.95"),
                        {part("the teeth are pointed")}));
  EXPECT_TRUE(lines_are(gear("center = [0, 0], module = 2, teeth = 30, backlash = 3"),
                        {part("the teeth are pointed")}));
}

TEST_F(ProfileBoundaries, OffsetsThatThereAreNotAreRefused) {
  const std::string plate =
      "plate = { type = \"chain\", spans = [{ type = \"segment\", from = [0, 0], to = [7, 0] }, "
      "{ type = \"segment\", from = [7, 0], to = [7, 3] }, { type = \"segment\", from = [7, 3], to = [0, 0] "
      "}] }\n";
  const auto offset = [&](const std::string& rest, const std::string& more = "") {
    return messages_of("{ type = \"offset\", " + rest + " }\n" + more);
  };
  EXPECT_TRUE(lines_are(offset("by = 3"), {part("c.of is missing: expected the name of another curve")}));
  EXPECT_TRUE(lines_are(offset("of = \"plat\", by = 3", plate),
                        {part("c.of = \"plat\": body `crank` has no curve `plat`; did you mean `plate`?")}));
  EXPECT_TRUE(lines_are(offset("of = \"plate\"", plate), {part("c.by is missing: expected a distance")}));
  EXPECT_TRUE(
      lines_are(offset("of = \"plate\", by = -1", plate),
                {part("c.by = -1: the corner at (7, 0) would be cut off: round it first, with a `fillet` "
                      "larger than this")}));
  EXPECT_TRUE(lines_are(offset("of = \"plate\", by = 1, side = \"inside\"", plate),
                        {part("an offset has its material where the other curve has it")}));
  EXPECT_TRUE(lines_are(offset("of = \"c\", by = 1"), {part("an offset cannot be of itself")}));
  EXPECT_TRUE(lines_are(offset("of = \"d\", by = 1", "d = { type = \"offset\", of = \"c\", by = 1 }\n"),
                        {part("cannot be of itself"), part("cannot be of itself")}));
  EXPECT_TRUE(
      lines_are(offset("of = \"d\", by = -6", "d = { type = \"circle\", center = [0, 0], radius = 5 }\n"),
                {part("c.by = -6: leaves nothing of this curve")}));
  EXPECT_TRUE(lines_are(
      offset("of = \"d\", by = 1", "d = { type = \"parabola\", vertex = [0, 0], focal_length = 5 }\n"),
      {part("a parabola or hyperbola has no ends")}));
  EXPECT_TRUE(lines_are(
      offset("of = \"d\", by = -2", "d = { type = \"ellipse\", center = [0, 0], semi_axes = [5, 3] }\n"),
      {part("the curve bends too sharply at ")}));
  EXPECT_TRUE(
      lines_are(offset("of = \"d\", by = 1", "d = { type = \"circle\", center = [0, 0], radius = -5 }\n"),
                {part("d.radius")}));
}

}  // namespace
}  // namespace higherpair
