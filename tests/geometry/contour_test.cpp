#include "higherpair/geometry/contour.hpp"

#include "geometry/span_testing.hpp"
#include "higherpair/geometry/spline_span.hpp"

#include <algorithm>

namespace higherpair {
namespace {

using Pieces = std::vector<ContourPiece>;

Pieces polygon(const std::vector<Vector2d>& corners) {
  Pieces pieces;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    pieces.emplace_back(LinePiece{corners[i], corners[(i + 1) % corners.size()]});
  }
  return pieces;
}

const Pieces kRectangle = polygon({{0, 0}, {0.07, 0}, {0.07, 0.03}, {0, 0.03}});

Boundary boundary_of(const Pieces& pieces, bool closed = true) {
  auto boundary = Boundary::make(spans_of(pieces), closed, 1e-9);
  EXPECT_TRUE(boundary.has_value());
  return *boundary;
}

TEST(Contour, GapsAreClosedBetweenNeighbours) {
  const Vector2d a(0, 0), b(0.03, 0), c(0.03, 0.02), near(1e-9, 1e-9);
  Pieces open = {LinePiece{a, b}, LinePiece{b + near, c}};
  close_gaps(open, false);
  EXPECT_EQ(begin_of(open[1]).p_B, b);
  EXPECT_EQ(begin_of(open[0]).p_B, a);
  close_gaps(open, true);
  EXPECT_EQ(begin_of(open[0]).p_B, c);
  Pieces none;
  close_gaps(none, false);
  EXPECT_TRUE(none.empty());
}

TEST(Contour, ArcsRunBothWaysWithTheMaterialOnTheLeft) {
  for (const double sweep : {1.1, -1.1, 2 * kPi, -2 * kPi}) {
    const ContourPiece arc = ArcPiece{{0.01, 0.02}, 0.005, 0.3, sweep};
    const SpanPtr span = span_of(arc);
    const PieceEnd begin = begin_of(arc);
    const PieceEnd end = end_of(arc);
    const SpanPoint first = span->at(span->range().low);
    const SpanPoint last = span->at(span->range().high);
    EXPECT_LE((first.p_B - begin.p_B).norm(), 1e-16);
    EXPECT_LE((last.p_B - end.p_B).norm(), 1e-16);
    EXPECT_LE((perp(first.n_B) - begin.t_B).norm(), 1e-14);
    EXPECT_LE((perp(last.n_B) - end.t_B).norm(), 1e-14);
    EXPECT_NEAR(first.kappa, std::copysign(200, sweep), 1e-10);
    testing::expect_span_laws(*span, 0.005, 1e-6);
    const ContourPiece back = reversed(arc);
    EXPECT_LE((begin_of(back).p_B - end.p_B).norm(), 1e-16);
    EXPECT_LE((begin_of(back).t_B + end.t_B).norm(), 1e-14);
  }
}

TEST(Contour, ItsAreaHasTheSignOfItsWay) {
  EXPECT_NEAR(enclosed_area(kRectangle), 2 * 0.07 * 0.03, 1e-16);
  EXPECT_NEAR(enclosed_area(reversed(kRectangle)), -2 * 0.07 * 0.03, 1e-16);
  const Pieces disc = {ArcPiece{{1, 2}, 0.5, 0.3, 2 * kPi}};
  EXPECT_NEAR(enclosed_area(disc), 2 * kPi * 0.25, 0.02);
  EXPECT_LT(enclosed_area(reversed(disc)), 0);
  EXPECT_NEAR(size_of(disc), std::sqrt(0.5), 1e-2);
}

TEST(Fillet, OfARectangleHasItsCentresOneRadiusFromBothSides) {
  const auto rounded = with_fillets(kRectangle, true, 0.004);
  ASSERT_TRUE(rounded.has_value());
  ASSERT_EQ(rounded->pieces.size(), 8U);
  EXPECT_EQ(rounded->sources, (std::vector<int>{0, 0, 1, 1, 2, 2, 3, 3}));
  const auto& arc = std::get<ArcPiece>(rounded->pieces[1]);
  EXPECT_LE((arc.center - Vector2d(0.066, 0.004)).norm(), 1e-16);
  EXPECT_NEAR(arc.sweep, kPi / 2, 1e-14);
  const Boundary boundary = boundary_of(rounded->pieces);
  EXPECT_EQ(boundary.spans().size(), 8U);  // no corner is left
  EXPECT_TRUE(boundary.is_convex());
  EXPECT_NEAR(enclosed_area(rounded->pieces) / 2, 0.07 * 0.03 - (4 - kPi) * 0.004 * 0.004, 1e-7);
}

TEST(Fillet, OfAConcaveCornerIsHollow) {
  const Pieces angle = polygon({{0, 0}, {0.05, 0}, {0.05, 0.02}, {0.02, 0.02}, {0.02, 0.05}, {0, 0.05}});
  const auto rounded = with_fillets(angle, true, 0.003);
  ASSERT_TRUE(rounded.has_value());
  const auto& hollow = std::get<ArcPiece>(rounded->pieces[5]);
  EXPECT_LT(hollow.sweep, 0);
  EXPECT_LE((hollow.center - Vector2d(0.023, 0.023)).norm(), 1e-16);
  const Boundary boundary = boundary_of(rounded->pieces);
  EXPECT_EQ(boundary.spans().size(), 12U);
  EXPECT_FALSE(boundary.is_convex());
}

// A keyhole: a disc with a straight slot; corners between an arc and lines, and between two arcs.
TEST(Fillet, BetweenArcsAndLinesIsTangentToBoth) {
  const double r = 0.02;
  const double half = 0.006;
  const double low = std::asin(half / r);
  const Pieces keyhole = {ArcPiece{{0, 0}, r, low, 2 * kPi - 2 * low},
                          LinePiece{r * unit_vector(-low), {0.04, -half}},
                          ArcPiece{{0.04, 0.01}, half + 0.01, -kPi / 2, kPi / 4}};
  const auto rounded = with_fillets({keyhole[0], keyhole[1]}, false, 0.002);
  ASSERT_TRUE(rounded.has_value());
  ASSERT_EQ(rounded->pieces.size(), 3U);
  for (std::size_t i = 0; i + 1 < 3; ++i) {
    const PieceEnd end = end_of(rounded->pieces[i]);
    const PieceEnd begin = begin_of(rounded->pieces[i + 1]);
    EXPECT_LE((end.p_B - begin.p_B).norm(), 1e-16);
    EXPECT_LE((end.t_B - begin.t_B).norm(), 1e-13);
  }
  const Pieces lens = {
      ArcPiece{{0, -0.03}, 0.05, std::acos(0.04 / 0.05), kPi - 2 * std::acos(0.04 / 0.05)},
      ArcPiece{{0, 0.03}, 0.05, kPi + std::acos(0.04 / 0.05), kPi - 2 * std::acos(0.04 / 0.05)}};
  const auto round_lens = with_fillets(lens, true, 0.001);
  ASSERT_TRUE(round_lens.has_value());
  const Boundary boundary = boundary_of(round_lens->pieces);
  EXPECT_EQ(boundary.spans().size(), 4U);
  EXPECT_TRUE(boundary.is_convex());
  EXPECT_FALSE(find_self_crossing(boundary));
}

TEST(Fillet, ThatDoesNotFitIsRefusedWithTheCornerAndTheLargestThatDoes) {
  const auto rounded = with_fillets(kRectangle, true, 0.016);
  ASSERT_FALSE(rounded.has_value());
  EXPECT_EQ(rounded.error().kind, FilletFault::Kind::kTooLarge);
  EXPECT_EQ(rounded.error().piece, 1);
  EXPECT_EQ(rounded.error().at_B, Vector2d(0.07, 0.03));
  const double largest = largest_fillet(kRectangle, true, 0.016);
  EXPECT_NEAR(largest, 0.015, 1e-5);
  EXPECT_LE(largest, 0.015);
  const Pieces back = {LinePiece{{0, 0}, {1, 0}}, LinePiece{{1, 0}, {0.2, 0}}};
  EXPECT_EQ(with_fillets(back, false, 0.1).error().kind, FilletFault::Kind::kCusp);
  const auto spline = spline_span({{1, 0}, {1.1, 1}, {1, 2}, {0.5, 3}, {0, 4}, {-1, 5}});
  EXPECT_EQ(with_fillets({LinePiece{{0, 0}, {1, 0}}, *spline}, false, 0.1).error().kind,
            FilletFault::Kind::kOther);
}

TEST(Join, PutsPiecesOfAnyOrderAndSenseIntoContours) {
  Pieces pieces = {LinePiece{{0, 0}, {1, 0}},  LinePiece{{1, 1}, {0, 1}}, LinePiece{{1, 1}, {1, 0}},
                   LinePiece{{5, 5}, {6, 6}},  LinePiece{{0, 0}, {0, 1}}, ArcPiece{{9, 9}, 1, 0, 2 * kPi},
                   LinePiece{{5, 5}, {4, 4.5}}};
  const auto contours = join(pieces, 1e-9);
  ASSERT_TRUE(contours.has_value());
  ASSERT_EQ(contours->size(), 3U);
  EXPECT_TRUE((*contours)[0].closed);
  EXPECT_EQ((*contours)[0].sources, (std::vector<int>{0, 2, 1, 4}));
  EXPECT_NEAR(enclosed_area((*contours)[0].pieces), 2, 1e-15);
  EXPECT_FALSE((*contours)[1].closed);
  EXPECT_EQ((*contours)[1].sources, (std::vector<int>{6, 3}));
  EXPECT_EQ(begin_of((*contours)[1].pieces[0]).p_B, Vector2d(4, 4.5));
  EXPECT_TRUE((*contours)[2].closed);
}

TEST(Join, EndsWithinTheToleranceMeet) {
  Pieces pieces = kRectangle;
  std::get<LinePiece>(pieces[1]).from += Vector2d(3e-6, -4e-6);
  EXPECT_FALSE(join(pieces, 4e-6)->front().closed);
  const auto contours = join(pieces, 6e-6);
  ASSERT_EQ(contours->size(), 1U);
  ASSERT_TRUE(contours->front().closed);
  Pieces joined = contours->front().pieces;
  close_gaps(joined, true);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(end_of(joined[i]).p_B, begin_of(joined[(i + 1) % 4]).p_B);
  }
}

TEST(Join, MoreThanTwoEndsAreRefused) {
  Pieces pieces = kRectangle;
  pieces.emplace_back(LinePiece{{0.07, 0.03}, {0.1, 0.1}});
  const auto contours = join(pieces, 1e-9);
  ASSERT_FALSE(contours.has_value());
  EXPECT_EQ(contours.error().at_B, Vector2d(0.07, 0.03));
  EXPECT_EQ(contours.error().pieces.size(), 3U);
}

TEST(SelfCrossing, OfAFigureOfEightIsItsMiddle) {
  std::vector<Vector2d> points;
  for (int i = 0; i < 60; ++i) {
    const double u = 2 * kPi * (i + 0.4) / 60;
    points.emplace_back(0.3 + std::sin(u), 0.2 + std::sin(u) * std::cos(u));
  }
  SplineOptions options;
  options.closed = true;
  const Boundary boundary = boundary_of({*spline_span(points, options)});
  const auto crossing = find_self_crossing(boundary);
  ASSERT_TRUE(crossing.has_value());
  EXPECT_LE((crossing->p_B - Vector2d(0.3, 0.2)).norm(), 1e-6);
  EXPECT_LE((boundary.at(crossing->first).p_B - boundary.at(crossing->second).p_B).norm(), 1e-9);
}

// The crossing may be at the beginning of the spline, on one of its samples, or at a vertex of both branches.
TEST(SelfCrossing, IsFoundWhereTheWayBeginsOrHasACorner) {
  for (const int first : {0, 7, 10, 20}) {
    std::vector<Vector2d> points;
    for (int i = 0; i < 40; ++i) {
      const double u = 2 * kPi * (first + i) / 40;
      points.emplace_back(0.04 * std::sin(u), 0.02 * std::sin(2 * u));
    }
    SplineOptions options;
    options.closed = true;
    const auto crossing = find_self_crossing(boundary_of({*spline_span(points, options)}));
    ASSERT_TRUE(crossing.has_value()) << first;
    EXPECT_LE(crossing->p_B.norm(), 1e-9) << first;
  }
  const auto pinched =
      find_self_crossing(boundary_of(polygon({{0, 0}, {2, -1}, {2, 1}, {0, 0}, {-2, 1}, {-2, -1}})));
  ASSERT_TRUE(pinched.has_value());
  EXPECT_LE(pinched->p_B.norm(), 1e-15);
}

TEST(SelfCrossing, IsFoundBetweenLinesAndArcsAndNowhereElse) {
  EXPECT_FALSE(find_self_crossing(boundary_of(kRectangle)));
  EXPECT_FALSE(find_self_crossing(boundary_of({ArcPiece{{1, 2}, 0.5, 0.3, 2 * kPi}})));
  const auto bow = find_self_crossing(boundary_of(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})));
  ASSERT_TRUE(bow.has_value());
  EXPECT_LE((bow->p_B - Vector2d(1, 1)).norm(), 1e-15);
  // A hairpin whose sides come within a thousandth of its length does not cross itself.
  EXPECT_FALSE(find_self_crossing(
      boundary_of({LinePiece{{0, 0.0005}, {-1, 0.0005}}, ArcPiece{{-1, 0}, 0.0005, kPi / 2, kPi},
                   LinePiece{{-1, -0.0005}, {0, -0.0005}}, ArcPiece{{0, 0}, 0.0005, -kPi / 2, kPi}})));
}

TEST(Offset, OfARoundedRectangleIsALargerOne) {
  const auto rounded = with_fillets(kRectangle, true, 0.004);
  const auto spans = offset_spans(boundary_of(rounded->pieces), 0.003);
  ASSERT_TRUE(spans.has_value());
  const auto boundary = Boundary::make(*spans, true, 1e-12);
  ASSERT_TRUE(boundary.has_value());
  EXPECT_TRUE(boundary->is_convex());
  EXPECT_NEAR(boundary->spans()[1]->at(boundary->spans()[1]->range().low).kappa, 1 / 0.007, 1e-9);
}

TEST(Offset, OfCornersHasArcs) {
  const Boundary rectangle = boundary_of(kRectangle);
  const auto outer = offset_spans(rectangle, 0.002);
  ASSERT_TRUE(outer.has_value());
  const auto boundary = Boundary::make(*outer, true, 1e-12);
  ASSERT_TRUE(boundary.has_value());
  EXPECT_EQ(boundary->spans().size(), 8U);
  const auto inner = offset_spans(rectangle, -0.002);
  ASSERT_FALSE(inner.has_value());
  EXPECT_EQ(inner.error().kind, OffsetFault::Kind::kCorner);
  // The ring around the rectangle: the corners of the rectangle are its notches.
  const Boundary hole = boundary_of(reversed(kRectangle));
  EXPECT_EQ(offset_spans(hole, 0.002).error().kind, OffsetFault::Kind::kCorner);
  const auto hollow = offset_spans(hole, -0.002);
  ASSERT_TRUE(hollow.has_value());
  EXPECT_EQ(Boundary::make(*hollow, true, 1e-12)->spans().size(), 8U);
}

// Offsetting a rounded plate inwards by its rounding radius gives a plate with corners.
TEST(Offset, ByTheRadiusOfItsArcsHasCornersInTheirPlace) {
  const std::vector<ContourPiece> plate = {LinePiece{{0, 0}, {0.03, 0}}, LinePiece{{0.03, 0}, {0.03, 0.02}},
                                           LinePiece{{0.03, 0.02}, {0, 0.02}}, LinePiece{{0, 0.02}, {0, 0}}};
  const auto rounded = Boundary::make(spans_of(with_fillets(plate, true, 0.0047)->pieces), true, 1e-9);
  ASSERT_TRUE(rounded);
  const auto spans = offset_spans(*rounded, -0.0047);
  ASSERT_TRUE(spans);
  const auto smaller = Boundary::make(*spans, true, 1e-9);
  ASSERT_TRUE(smaller);
  EXPECT_EQ(smaller->spans().size(), 8U);  // with the corners
  EXPECT_TRUE(smaller->is_convex());
  EXPECT_NEAR(smaller->size(), std::hypot(0.03 - 0.0094, 0.02 - 0.0094) / 2, 1e-15);
}

TEST(Offset, HasACuspWhereTheCurveBendsTooSharply) {
  const Boundary hole = boundary_of(reversed(Pieces{ArcPiece{{0, 0}, 0.01, 0, 2 * kPi}}));
  EXPECT_TRUE(offset_spans(hole, 0.0099).has_value());
  const auto fault = offset_spans(hole, 0.011);
  ASSERT_FALSE(fault.has_value());
  EXPECT_EQ(fault.error().kind, OffsetFault::Kind::kCusp);
  EXPECT_NEAR(fault.error().limit, 0.01, 1e-12);
}

}  // namespace
}  // namespace higherpair
