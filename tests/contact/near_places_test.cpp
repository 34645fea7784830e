#include "higherpair/contact/near_places.hpp"

#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/geometry/edges.hpp"
#include "higherpair/geometry/gear_outline.hpp"
#include "higherpair/geometry/spline_span.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

// A closed curve with concave parts, r = 0.031 (1 + 0.13 cos 5 t), as a spline.
Boundary wavy_cam() {
  std::vector<Vector2d> points;
  for (int i = 0; i < 120; ++i) {
    const double t = 2 * kPi * i / 120;
    points.push_back(0.031 * (1 + 0.13 * std::cos(5 * t)) * unit_vector(t));
  }
  SplineOptions options;
  options.closed = true;
  return *Boundary::make({*spline_span(points, options)}, true, 1e-9);
}

// The local minima of f over a closed boundary, on a fine grid, at points where the boundary faces the object
// that f is about.
template <class F, class Faces>
std::vector<double> least_values(const Boundary& boundary, const F& f, const Faces& faces) {
  constexpr int kCount = 20000;
  const Bounds range = boundary.spans().front()->range();
  std::vector<double> values;
  std::vector<SpanPoint> points;
  for (int i = 0; i < kCount; ++i) {
    points.push_back(boundary.spans().front()->at(range.low + range.width() * i / kCount));
    values.push_back(f(points.back()));
  }
  std::vector<double> least;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double before = values[(i + kCount - 1) % kCount];
    const double after = values[(i + 1) % kCount];
    if (values[i] <= before && values[i] < after && faces(points[i])) {
      const double bend = before - 2 * values[i] + after;  // by the parabola through the three values
      least.push_back(values[i] - (after - before) * (after - before) / (8 * bend));
    }
  }
  std::sort(least.begin(), least.end());
  return least;
}

std::vector<double> gaps_of(const std::vector<NearPlace>& places) {
  std::vector<double> gaps;
  for (const NearPlace& place : places) {
    gaps.push_back(place.at.gap());
  }
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

// Compares the values within reach. A value too close to the reach could count to either side and fails the
// test.
void expect_same(const std::vector<double>& found, const std::vector<double>& expected, double reach) {
  std::vector<double> near;
  for (const double value : expected) {
    ASSERT_GT(std::abs(std::abs(value) - reach), 1e-9) << "another seed";
    if (std::abs(value) < reach) {
      near.push_back(value);
    }
  }
  ASSERT_EQ(found.size(), near.size());
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_NEAR(found[i], near[i], 1e-11);
  }
}

TEST(NearPlaces, OfARollerAreTheLeastDistancesOfItsCentreFromTheCam) {
  const Boundary cam = wavy_cam();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1, 1);
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    const double radius = 0.0037 * (1.2 + share(random));
    const Boundary roller = boundary_of(*make_circle(Vector2d(0.0071, -0.0029), radius), 1);
    const Pose<double> X_WC{Rotation<double>::from_angle(4 * share(random)), Vector2d(0.3, -0.1)};
    const Vector2d center_C =
        (0.0355 + 0.3 * radius + 0.008 * (1 + share(random))) * unit_vector(4 * share(random));
    const Rotation<double> turned = Rotation<double>::from_angle(4 * share(random));
    const Pose<double> X_WR{turned, X_WC * center_C - turned * Vector2d(0.0071, -0.0029)};
    const double reach = 0.0083;
    const auto expected = least_values(
        cam, [&](const SpanPoint& point) { return (point.p_B - center_C).norm() - radius; },
        [&](const SpanPoint& point) { return point.n_B.dot(center_C - point.p_B) > 0; });
    expect_same(gaps_of(near_places(cam, X_WC, roller, X_WR, reach)), expected, reach);
    expect_same(gaps_of(near_places(roller, X_WR, cam, X_WC, reach)), expected, reach);
    seen += static_cast<int>(near_places(cam, X_WC, roller, X_WR, reach).size());
  }
  EXPECT_GT(seen, 100);
}

// As drawings have them: parts of one boundary are much shorter than those of the other.
TEST(NearPlaces, DoNotDependOnHowManyArcsACircleIsDividedInto) {
  const Boundary cam = wavy_cam();
  constexpr int kArcs = 180;
  const Curve circle = *make_circle(Vector2d(0.0071, -0.0029), 0.0043);
  std::vector<SpanPtr> arcs;
  for (int k = 0; k < kArcs; ++k) {
    arcs.push_back(conic_span(circle, 2 * kPi * k / kArcs, 2 * kPi * (k + 1) / kArcs));
  }
  const Boundary whole = boundary_of(circle, 1);
  const Boundary divided = *Boundary::make(arcs, true, 1e-9);
  const double reach = 0.0083;
  std::size_t seen = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose<double> X_WC{Rotation<double>::from_angle(0.17 * i), Vector2d(0.3, -0.1)};
    const Pose<double> X_WR{Rotation<double>::from_angle(-0.29 * i),
                            Vector2d(0.3, -0.1) + (0.037 + 1.3e-5 * i) * unit_vector(0.7 * i)};
    const std::vector<double> expected = gaps_of(near_places(cam, X_WC, whole, X_WR, reach));
    expect_same(gaps_of(near_places(cam, X_WC, divided, X_WR, reach)), expected, reach);
    expect_same(gaps_of(near_places(divided, X_WR, cam, X_WC, reach)), expected, reach);
    seen += expected.size();
  }
  EXPECT_GT(seen, 100U);
}

TEST(NearPlaces, OfAFlatFaceAreTheTopsOfTheCam) {
  const Boundary cam = wavy_cam();
  const Boundary face = boundary_of(*make_line(Vector2d(0, 0.043), Vector2d(0, -1)), 1);
  for (int i = 0; i < 100; ++i) {
    const Pose<double> X_WC{Rotation<double>::from_angle(0.0613 * i), Vector2d::Zero()};
    const double reach = 0.0231;
    const auto expected = least_values(
        cam, [&](const SpanPoint& point) { return 0.043 - (X_WC * point.p_B).y(); },
        [&](const SpanPoint& point) { return (X_WC.R_WB * point.n_B).y() > 0; });
    expect_same(gaps_of(near_places(cam, X_WC, face, {}, reach)), expected, reach);
  }
}

TEST(NearPlaces, AreFollowedWhileTheBodiesMove) {
  const Boundary cam = wavy_cam();
  const Boundary roller = boundary_of(*make_circle(Vector2d::Zero(), 0.011), 1);
  const auto X_WR = [](double x) { return Pose<double>{{}, Vector2d(0.041 - 0.02 * x, 0.003)}; };
  const auto X_WC = [](double x) { return Pose<double>{Rotation<double>::from_angle(x), Vector2d::Zero()}; };
  auto places = near_places(cam, X_WC(0), roller, X_WR(0), 0.02);
  ASSERT_FALSE(places.empty());
  for (double x = 0.02; x < 0.3; x += 0.02) {
    const auto all = gaps_of(near_places(cam, X_WC(x), roller, X_WR(x), 1));
    for (NearPlace& place : places) {
      const auto moved = moved_place(cam, X_WC(x), roller, X_WR(x), place);
      ASSERT_TRUE(moved);
      const double gap = moved->at.gap();
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](double g) { return std::abs(g - gap) < 1e-13; }));
      place = *moved;
    }
  }
}

TEST(NearPlaces, AnEndOfAFaceIsOverTheOtherBody) {
  const Boundary face =
      *Boundary::make({face_span(Vector2d(0.013, 0.029), Vector2d(0.002, 0.029))}, false, 0);
  const Boundary disc = boundary_of(*make_circle(Vector2d::Zero(), 0.031), 1);
  const auto places = near_places(face, {}, disc, {}, 0.004);
  // The face is part of a chord, with one end outside the disc; the side of the disc that it faces is not
  // opposite to it.
  ASSERT_EQ(places.size(), 2U);
  for (const NearPlace& place : places) {
    EXPECT_EQ(place.end, 1);
    const Vector2d end = face.at(place.place1).p_B;
    EXPECT_NEAR(place.at.gap(), end.norm() - 0.031, 1e-15);
    EXPECT_NEAR((place.at.n_W + end.normalized()).norm(), 0, 1e-12);
  }
  const auto exchanged = near_places(disc, {}, face, {}, 0.004);
  ASSERT_EQ(exchanged.size(), 2U);
  EXPECT_EQ(exchanged[0].end, 2);
}

// Two gears of module 2 mm whose teeth are thinner by these backlashes, with a tooth of the first in the
// middle of a space of the second.
struct Mesh {
  static constexpr int kTeeth1 = 20, kTeeth2 = 40;
  static constexpr double kModule = 0.002, kPressureAngle = 20 * kPi / 180;
  static constexpr double kBacklash1 = 0.00005, kBacklash2 = 0.00003;

  Boundary first = gear(kTeeth1, kBacklash1, 0), second = gear(kTeeth2, kBacklash2, kPi + kPi / kTeeth2);

  static Boundary gear(int teeth, double backlash, double angle) {
    GearShape shape;
    shape.tooth = {kModule, static_cast<double>(teeth), kPressureAngle, 0, backlash};
    shape.angle = angle;
    return *Boundary::make(gear_outline(shape), true, 1e-12);
  }
  static Pose<double> X_W1(double turn) { return {Rotation<double>::from_angle(turn), Vector2d::Zero()}; }
  static Pose<double> X_W2(double turn) {
    return {Rotation<double>::from_angle(-turn * kTeeth1 / kTeeth2),
            Vector2d(kModule * (kTeeth1 + kTeeth2) / 2, 0)};
  }
};

// Along both lines of action the flanks are half of both backlashes apart, measured at the base circles. The
// average number of flank pairs on either side is the contact ratio, 1.635185964, plus the gap divided by the
// base pitch: the length between the tips along the line of action is longer by the gap.
TEST(NearPlaces, OfTwoGearsAreTheFlanksOnTheirLinesOfAction) {
  const Mesh mesh;
  const double gap = (Mesh::kBacklash1 + Mesh::kBacklash2) / 2 * std::cos(Mesh::kPressureAngle);
  constexpr int kCount = 200;
  int seen = 0;
  for (int i = 0; i < kCount; ++i) {
    const double turn = 1.7 + 2 * kPi / Mesh::kTeeth1 * (i + 0.5) / kCount;
    const auto places = near_places(mesh.first, Mesh::X_W1(turn), mesh.second, Mesh::X_W2(turn), 1.5 * gap);
    for (const NearPlace& place : places) {
      const bool flanks = place.at.rho1 != 0 && place.at.rho2 != 0;
      if (flanks) {
        EXPECT_NEAR(place.at.gap(), gap, 1e-15);
        const double lean = std::abs(place.at.n_W.x()) - std::sin(Mesh::kPressureAngle);
        EXPECT_NEAR(lean, 0, 1e-11);
        ++seen;
      }
    }
  }
  const double base_pitch = kPi * Mesh::kModule * std::cos(Mesh::kPressureAngle);
  EXPECT_NEAR(seen / (2.0 * kCount), 1.635185964 + gap / base_pitch, 1.0 / kCount);
}

// The same places are found wherever the numbering of the outline begins.
TEST(NearPlaces, OfTwoGearsDoNotDependOnWhichTeethMesh) {
  const Mesh mesh;
  const double pitch = 2 * kPi / Mesh::kTeeth1;
  const auto gaps = [&](double turn, double reach) {
    return gaps_of(near_places(mesh.first, Mesh::X_W1(turn), mesh.second, Mesh::X_W2(turn), reach));
  };
  const auto expected = gaps(0.0413, 0.0031);
  EXPECT_GT(expected.size(), 6U);
  for (const int tooth : {1, 7, 13, 19, 33}) {
    const auto found = gaps(0.0413 + tooth * pitch, 0.0031);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k], expected[k], 1e-12);
    }
  }
}

// When the gears are turned into each other, every pair of flanks that meets on the line of action has the
// same depth: the arc of the base circle less the gap. Turned by less than the gap they are free.
TEST(DeepestPenetration, OfTwoGearsIsAlongTheirLineOfAction) {
  const Mesh mesh;
  const double gap = (Mesh::kBacklash1 + Mesh::kBacklash2) / 2 * std::cos(Mesh::kPressureAngle);
  const double base_radius = Mesh::kModule * Mesh::kTeeth2 / 2 * std::cos(Mesh::kPressureAngle);
  for (const double turn : {0.037, 0.61, 2.93}) {
    for (const double way : {-3.1 * gap, -0.93 * gap, 0.0, 0.97 * gap, 2.3 * gap}) {
      Pose<double> X_W2 = Mesh::X_W2(turn);
      X_W2.R_WB = X_W2.R_WB * Rotation<double>::from_angle(way / base_radius);
      const double depth = deepest_penetration(mesh.first, Mesh::X_W1(turn), mesh.second, X_W2, 1e-9);
      EXPECT_NEAR(depth, std::max(0.0, std::abs(way) - gap), 1e-13) << turn << " " << way;
    }
  }
}

TEST(NearestPlaces, FaceEachOtherAsWellAsAnySamples) {
  const Mesh mesh;
  const Boundary cam = wavy_cam();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1, 1);
  for (int i = 0; i < 20; ++i) {
    const Pose<double> X_W1{Rotation<double>::from_angle(3 * share(random)), Vector2d(0.1, -0.2)};
    const Pose<double> X_W2{Rotation<double>::from_angle(3 * share(random)),
                            Vector2d(0.1 + 0.06 * share(random), -0.2 + 0.06 * share(random))};
    const double scale = std::max(cam.size(), mesh.first.size());
    const auto measure = [&](const SpanPoint& one, const SpanPoint& two) {
      return std::hypot((X_W1 * one.p_B - X_W2 * two.p_B).norm(),
                        scale * (X_W1.R_WB * one.n_B + X_W2.R_WB * two.n_B).norm());
    };
    double least = INFINITY;
    for (const auto& one : cam.samples()) {
      for (const auto& two : mesh.first.samples()) {
        least = std::min(least, measure(one.point, two.point));
      }
    }
    const auto [place1, place2] = nearest_places(cam, X_W1, mesh.first, X_W2);
    // Between samples they are the nearest of straight lines, which differ from the curves by about 1 %.
    EXPECT_LE(measure(cam.at(place1), mesh.first.at(place2)), least + 0.005 * scale);
  }
}

TEST(NearestPlaces, OnAFaceAreWhereTheOtherBodyIsNearestHoweverFarAwayTheFaceEnds) {
  const Vector2d center(0.031, -0.012);
  const double radius = 0.0127;
  const Boundary disc = boundary_of(*make_circle(center, radius), 1);
  const Pose<double> X_W1{Rotation<double>::from_angle(0.4), Vector2d(0.1, -0.2)};
  const Pose<double> X_W2{Rotation<double>::from_angle(2.1), Vector2d(0.14, -0.21)};
  const Vector2d at = X_W1.R_WB.inverse() * (X_W2 * center - X_W1.p_WB);
  for (const double end : {0.06, 0.7, 30.0, 4000.0}) {
    // The material is below the face, whose t points along -x.
    const Boundary face = *Boundary::make({face_span(Vector2d(end, 0.003), Vector2d(-end, 0.003))}, false, 0);
    const auto [place1, place2] = nearest_places(face, X_W1, disc, X_W2);
    EXPECT_NEAR(face.at(place1).p_B.x(), at.x(), 0.01 * radius) << end;
    EXPECT_NEAR(disc.at(place2).n_B.dot(X_W2.R_WB.inverse() * (X_W1.R_WB * Vector2d(0, -1))), 1, 0.002)
        << end;
    const auto swapped = nearest_places(disc, X_W2, face, X_W1);
    EXPECT_NEAR(face.at(swapped[1]).p_B.x(), at.x(), 0.01 * radius) << end;
  }
}

TEST(NearPlaces, AnEdgeIsTouchedAtACommonNormalWhereItsNormalsFaceTheOtherBody) {
  // The face points downwards and ends at (0.013, 0.029); the normals of the edge there turn on until they
  // point along x.
  const Boundary face =
      with_edges(*Boundary::make({face_span(Vector2d(0.002, 0.029), Vector2d(0.013, 0.029))}, false, 0));
  const auto place_over = [&](const Vector2d& to_center) {
    const Boundary disc = boundary_of(*make_circle(Vector2d(0.013, 0.029) + to_center, 0.0047), 1);
    const auto places = near_places(face, {}, disc, {}, 0.004);
    EXPECT_EQ(places.size(), 1U);
    EXPECT_TRUE(is_edge(face, places.at(0).place1.span));
    EXPECT_NEAR(places[0].at.gap(), to_center.norm() - 0.0047, 1e-15);
    EXPECT_NEAR((places[0].at.n_W - to_center.normalized()).norm(), 0, 1e-12);
    return places[0];
  };
  EXPECT_EQ(place_over({0.004, -0.006}).end, 0);
  EXPECT_EQ(place_over({0.0031, -0.0031}).end, 0);
  EXPECT_EQ(place_over({0.004, 0.003}).end, 1);
}

}  // namespace
}  // namespace higherpair
