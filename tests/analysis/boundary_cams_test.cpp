#include "analysis/run_testing.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/boundaries.hpp"
#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;

constexpr double kMillimetre = 1e-3;

// A cam that turns about the origin and a follower that slides along x or turns about a pivot.
struct CamMechanism {
  Mechanism mechanism;
  int follower_joint = 0;
};

CamMechanism radial(const Boundary& cam, const Curve& follower, double at, double offset = 0) {
  CamMechanism made;
  Mechanism& m = made.mechanism;
  const int cam_body = add_body(m, "cam");
  const int slider = add_body(m, "follower", Vector2d(at, offset));
  const PointRef O = add_point(m, kGround, "O", Vector2d::Zero());
  const int pivot = add_revolute(m, "pivot", O, add_point(m, cam_body, "O", Vector2d::Zero()));
  made.follower_joint = add_prismatic(m, "guide", add_point(m, kGround, "G", Vector2d(0, offset)),
                                      add_point(m, slider, "P", Vector2d::Zero()), Vector2d::UnitX());
  add_contact(m, "touch", add_curve(m, cam_body, "flank", cam), add_curve(m, slider, "roller", follower));
  add_driver(m, pivot);
  use_boundaries(m);
  return made;
}

struct Lift {
  double s = 0, v = 0, a = 0;
};

// Two circles, about O and about a point at `distance` on the x axis, joined by common tangents; sizes [m].
struct TangentCam {
  double base = 20 * kMillimetre, nose = 8 * kMillimetre, distance = 25 * kMillimetre,
         roller = 10 * kMillimetre;

  [[nodiscard]] double tangent() const { return std::acos((base - nose) / distance); }

  [[nodiscard]] Boundary boundary() const {
    const double t = tangent();
    const Vector2d up = unit_vector(t);
    const Vector2d down = unit_vector(-t);
    const Vector2d C(distance, 0);
    std::vector<SpanPtr> spans;
    if (nose > 0) {
      spans.push_back(conic_span(*make_circle(C, nose), -t, t));
    }
    spans.push_back(face_span(C + nose * up, base * up));
    spans.push_back(conic_span(*make_circle(Vector2d::Zero(), base), t, 2 * kPi - t));
    spans.push_back(face_span(base * down, C + nose * down));
    return *Boundary::make(std::move(spans), true, 1e-12);
  }

  // Angles at which the roller passes from the nose to the flank, and from the flank to the base circle.
  [[nodiscard]] double nose_ends() const {
    const Vector2d centre = Vector2d(distance, 0) + (nose + roller) * unit_vector(tangent());
    return angle_of(centre);
  }

  // Motion of the roller's centre over the angle ψ from the nose, at dψ/dt = 1: the tangent cam of textbooks,
  // whose nose is equivalent to a slider-crank.
  [[nodiscard]] Lift lift(double psi) const {
    const double sign = psi < 0 ? -1 : 1;
    const double x = std::abs(psi);
    const double reach = base + roller;
    if (x >= tangent()) {
      return {reach, 0, 0};
    }
    if (x >= nose_ends()) {
      const double theta = tangent() - x;
      const double c = std::cos(theta);
      return {reach / c, -sign * reach * std::sin(theta) / (c * c), reach * (2 - c * c) / (c * c * c)};
    }
    const double rod = nose + roller;
    const double s = distance * std::sin(x);
    const double w = std::sqrt(rod * rod - s * s);
    const double ds = distance * std::cos(x);
    const double dw = -s * ds / w;
    const double d2w = -(ds * ds - s * s + dw * dw) / w;
    return {ds + w, sign * (-s + dw), -ds + d2w};
  }
};

double normalised(double angle) {
  return nearest_turn(angle, 0);
}

void expect_tangent_cam(const TangentCam& cam, double samples, double from) {
  const CamMechanism made =
      radial(cam.boundary(), *make_circle(Vector2d::Zero(), cam.roller), 60 * kMillimetre);
  auto run = start_run(made.mechanism, {from});
  ASSERT_TRUE(run) << run.error().reason;
  std::vector<double> jumps;
  for (int i = 0; i <= samples; ++i) {
    const double u = from + i * 2 * kPi / samples;
    move_to(*run, {{u, 1, 0}});
    const Lift expected = cam.lift(normalised(-u));
    ASSERT_EQ(run->row.status, RowStatus::kOk) << u;
    const auto motion = joint_motion(run->mechanism(), run->mechanism().joints[1], run->row.bodies);
    EXPECT_NEAR(motion.position, expected.s, 1e-15 + 1e-14 * expected.s) << u;
    EXPECT_NEAR(motion.velocity, -expected.v, 1e-14) << u;
    EXPECT_NEAR(motion.acceleration, expected.a, 1e-12) << u;
    for (const RunEvent& event : run->events) {
      if (event.type == EventType::kCurvatureJump || event.type == EventType::kCorner) {
        jumps.push_back(normalised(-event.driver));
      } else {
        EXPECT_EQ(event.type, EventType::kStrokeEnd) << event.cause;
      }
    }
  }
  const double t = cam.tangent();
  const double n = cam.nose_ends();
  std::sort(jumps.begin(), jumps.end());
  ASSERT_EQ(jumps.size(), 4U);
  EXPECT_NEAR(jumps[0], -t, 1e-12);
  EXPECT_NEAR(jumps[1], -n, 1e-12);
  EXPECT_NEAR(jumps[2], n, 1e-12);
  EXPECT_NEAR(jumps[3], t, 1e-12);
}

TEST(BoundaryCams, ATangentCamLiftsItsRollerAsTheTextbookSays) {
  for (const double samples : {7.0, 53.0, 361.0}) {
    expect_tangent_cam({}, samples, 0.4);
    expect_tangent_cam({}, samples, 3);
  }
}

TEST(BoundaryCams, ANoseOfNoRadiusIsACornerThatTheRollerGoesRound) {
  TangentCam cam;
  cam.nose = 0;
  for (const double samples : {7.0, 53.0, 361.0}) {
    expect_tangent_cam(cam, samples, 0.4);
  }
}

// |x/a|³ + |y/b|³ = 1 by x = a c^{2/3}, …: a user-defined kind of curve in a few lines. Its curvature is 0
// where it meets the axes.
class LameOval final : public Span {
public:
  LameOval(double a, double b) : a_(a), b_(b) {}
  [[nodiscard]] SpanPoint at(double t) const override {
    // As a function of the direction t: r(t) = (|cos/a|³ + |sin/b|³)^(-1/3), and its derivatives.
    const double c = std::cos(t), s = std::sin(t);
    const double A = 1 / (a_ * a_ * a_), B = 1 / (b_ * b_ * b_);
    const double ac = std::abs(c), as = std::abs(s);
    const double g = A * ac * ac * ac + B * as * as * as;
    const double g1 = -3 * A * ac * c * s + 3 * B * as * s * c;
    const double g2 = 3 * A * ac * (2 * s * s - c * c) + 3 * B * as * (2 * c * c - s * s);
    const double g3 = 3 * A * (c < 0 ? -1 : 1) * s * (7 * c * c - 2 * s * s) +
                      3 * B * (s < 0 ? -1 : 1) * c * (2 * c * c - 7 * s * s);
    const double r = std::pow(g, -1 / 3.0);
    const double q1 = -g1 / (3 * g), q2 = -(g2 / g - g1 * g1 / (g * g)) / 3;
    const double q3 = -(g3 / g - 3 * g1 * g2 / (g * g) + 2 * g1 * g1 * g1 / (g * g * g)) / 3;
    // With q = r'/r and its derivatives, from ln r.
    const double r1 = r * q1, r2 = r * (q2 + q1 * q1), r3 = r * (q3 + 3 * q1 * q2 + q1 * q1 * q1);
    const double v2 = r * r + r1 * r1, v = std::sqrt(v2);
    const double m = r * r + 2 * r1 * r1 - r * r2;
    const double kappa = m / (v2 * v);
    const double dm = 3 * r1 * r2 + 2 * r * r1 - r * r3;
    const double dv2 = 2 * r * r1 + 2 * r1 * r2;
    const double dkappa = dm / (v2 * v) - 1.5 * m * dv2 / (v2 * v2 * v);
    const Vector2d e(c, s);
    const Vector2d tangent = (r1 * e + r * perp(e)) / v;
    return {r * e, -perp(tangent), kappa, dkappa / v, v};
  }
  [[nodiscard]] Bounds range() const override { return {0, 2 * kPi}; }
  [[nodiscard]] int parts() const override { return 128; }

private:
  double a_, b_;
};

TEST(BoundaryCams, AKindOfCurveIsOneClass) {
  const Boundary oval =
      *Boundary::make({std::make_shared<LameOval>(30 * kMillimetre, 18 * kMillimetre)}, true, 1e-12);
  for (const double offset : {0.0, 6 * kMillimetre}) {
    const CamMechanism made =
        radial(oval, *make_circle(Vector2d::Zero(), 9 * kMillimetre), 60 * kMillimetre, offset);
    auto run = start_run(made.mechanism, {0.3});
    ASSERT_TRUE(run) << run.error().reason;
    const auto joint_at = [&](double u) {
      move_to(*run, {{u, 1, 0}});
      EXPECT_EQ(run->row.status, RowStatus::kOk) << u;
      return joint_motion(run->mechanism(), run->mechanism().joints[1], run->row.bodies);
    };
    constexpr double h = 1e-3;
    for (int i = 0; i < 100; ++i) {
      const double u = 0.35 + i * 2 * kPi / 97;
      const auto before = joint_at(u - h);
      const auto here = joint_at(u);
      const ContactMotion touch = run->row.contacts[0];
      const auto after = joint_at(u + h);
      EXPECT_NEAR(here.velocity, (after.position - before.position) / (2 * h), 1e-6) << u;
      EXPECT_NEAR(here.acceleration, (after.velocity - before.velocity) / (2 * h), 2e-5) << u;
      EXPECT_LT((touch.at.p1_W - touch.at.p2_W).norm(), 1e-15);
      // Every other point of the oval is farther from the roller's centre.
      const Vector2d centre(here.position, offset);
      for (const Boundary::Sample& sample : oval.samples()) {
        EXPECT_GE((Rotation<double>::from_angle(u) * sample.point.p_B - centre).norm(),
                  9 * kMillimetre - 1e-12);
      }
    }
  }
}

TEST(BoundaryCams, AWholeConicAsABoundaryMovesAsTheConicDoes) {
  const Curve ellipse =
      *make_ellipse(Vector2d(3 * kMillimetre, 1 * kMillimetre), {30 * kMillimetre, 12 * kMillimetre}, 0.4);
  const Curve roller = *make_circle(Vector2d::Zero(), 9 * kMillimetre);
  const CamMechanism made = radial(boundary_of(ellipse, 1), roller, 60 * kMillimetre, 2 * kMillimetre);
  Mechanism whole = made.mechanism;
  whole.contacts[0].by_boundary = false;
  whole.contacts[0].first.curve = 0;
  whole.contacts[0].second.curve = 0;
  whole.bodies[1].curves = {{"flank", ellipse}};
  whole.bodies[2].curves = {{"roller", roller}};
  auto by_boundary = start_run(made.mechanism, {0});
  auto by_conic = start_run(whole, {0});
  ASSERT_TRUE(by_boundary) << by_boundary.error().reason;
  ASSERT_TRUE(by_conic) << by_conic.error().reason;
  for (int i = 0; i <= 200; ++i) {
    move_to(*by_boundary, {{i * 0.05, 1, 0}});
    move_to(*by_conic, {{i * 0.05, 1, 0}});
    ASSERT_EQ(by_boundary->row.status, RowStatus::kOk);
    const BodyMotion& a = by_boundary->row.bodies[2];
    const BodyMotion& b = by_conic->row.bodies[2];
    EXPECT_LT((a.X_WB.p_WB - b.X_WB.p_WB).norm(), 1e-15);
    EXPECT_LT((a.v_WB - b.v_WB).norm(), 1e-14);
    EXPECT_LT((a.a_WB - b.a_WB).norm(), 1e-12);
    EXPECT_NEAR(by_boundary->row.contacts[0].at.rho1, by_conic->row.contacts[0].at.rho1, 1e-13);
  }
}

// A convex polygon whose corners are rounded.
struct RoundedPolygon {
  std::vector<Vector2d> centres;  // centres of the roundings, anticlockwise
  double radius = 0;

  [[nodiscard]] std::size_t next(std::size_t i) const { return (i + 1) % centres.size(); }
  // Direction of the outward normal of the side after the i-th corner.
  [[nodiscard]] double normal(std::size_t i) const {
    return angle_of(-perp(Vector2d(centres[next(i)] - centres[i])));
  }

  [[nodiscard]] Boundary boundary() const {
    std::vector<SpanPtr> spans;
    for (std::size_t i = 0; i < centres.size(); ++i) {
      const double from = normal((i + centres.size() - 1) % centres.size());
      const double to = normal(i);
      const Vector2d out = radius * unit_vector(to);
      spans.push_back(conic_span(*make_circle(centres[i], radius), from, to > from ? to : to + 2 * kPi));
      spans.push_back(face_span(centres[i] + out, centres[next(i)] + out));
    }
    return *Boundary::make(std::move(spans), true, 1e-12);
  }

  // Largest x of the polygon when it has turned by u.
  [[nodiscard]] double reach(double u) const {
    double farthest = 0;
    for (const Vector2d& centre : centres) {
      farthest = std::max(farthest, (Rotation<double>::from_angle(u) * centre).x() + radius);
    }
    return farthest;
  }
};

// Each side in turn lies flat on the tappet, and the contact continues at its other end.
TEST(BoundaryCams, ASideThatLiesFlatOnATappetIsGoneOverWhateverTheRows) {
  RoundedPolygon polygon;
  polygon.radius = 3.1 * kMillimetre;
  for (const double at : {0.3, 1.4, 2.9, 3.8, 5.5}) {
    polygon.centres.emplace_back(20 * kMillimetre * unit_vector(at) + Vector2d(2, -1) * kMillimetre);
  }
  std::vector<double> sides;
  for (std::size_t i = 0; i < polygon.centres.size(); ++i) {
    sides.push_back(polygon.normal(i));
  }
  const Curve face = *make_line(Vector2d::Zero(), Vector2d(-1, 0));
  const CamMechanism made = radial(polygon.boundary(), face, 40 * kMillimetre);
  for (const int rows : {2, 3, 5, 7, 61, 601}) {
    for (const double sense : {1.0, -1.0}) {
      auto run = start_run(made.mechanism, {0.1});
      ASSERT_TRUE(run) << run.error().reason;
      std::size_t flats = 0;
      for (int k = 1; k <= rows; ++k) {
        const double u = 0.1 + sense * k * 2 * kPi / rows;
        move_to(*run, {{u, 1, 0}});
        ASSERT_EQ(run->row.status, RowStatus::kOk) << rows << " rows, at " << u;
        EXPECT_NEAR(run->row.bodies[2].X_WB.p_WB.x(), polygon.reach(u), 1e-14) << rows << " rows, at " << u;
        for (const RunEvent& event : run->events) {
          EXPECT_NE(event.type, EventType::kLimitPosition) << rows << " rows, at " << event.driver;
          if (event.type != EventType::kSecondContact) {
            continue;
          }
          ++flats;
          EXPECT_TRUE(std::any_of(
              sides.begin(), sides.end(),
              [&](double normal) { return std::abs(nearest_turn(event.driver + normal, 0)) < 1e-12; }))
              << rows << " rows, at " << event.driver;
        }
      }
      EXPECT_EQ(flats, sides.size()) << rows << " rows";
    }
  }
}

// A square of 40 about the cam's axis and a roller of 5 on the x axis. From 30 the roller is moved in to 25;
// from within the square there is no first touch.
TEST(BoundaryCams, AreNotReachedFromAPoseThatOverlaps) {
  const Boundary square =
      *Boundary::make({face_span({0.02, -0.02}, {0.02, 0.02}), face_span({0.02, 0.02}, {-0.02, 0.02}),
                       face_span({-0.02, 0.02}, {-0.02, -0.02}), face_span({-0.02, -0.02}, {0.02, -0.02})},
                      true, 1e-12);
  const auto started_from = [&](double at, Approach approach) {
    CamMechanism made = radial(square, *make_circle(Vector2d::Zero(), 5 * kMillimetre), at);
    made.mechanism.contacts.front().approach = approach;
    return start_run(made.mechanism, {0});
  };
  const auto apart = started_from(0.03, Approach::kNegative);
  ASSERT_TRUE(apart) << apart.error().reason;
  EXPECT_NEAR(apart->at.state.bodies.back().X_WB.p_WB.x(), 0.025, 1e-15);
  for (const Approach approach : {Approach::kNegative, Approach::kPositive}) {
    const auto within = started_from(0.021, approach);
    ASSERT_FALSE(within);
    EXPECT_TRUE(contains(within.error().reason, "overlap at the first driver position"));
  }
  EXPECT_TRUE(started_from(0.021, Approach::kNearest));
}

// The roller is posed where the base circle carries it, which rounding puts on either side of the contact.
TEST(BoundaryCams, StartFromAPoseAtTheContactWhateverTheSenseOfApproach) {
  for (const char* approach : {"+", "-"}) {
    for (int at = 185; at < 355; ++at) {
      const testing::RunTable motion = testing::analyze(
          testing::shipped("four_arc_cam", {"bodies.follower.pose.y=20", fmt::format("driver.start={}", at),
                                            fmt::format("driver.end={}", at + 1), "driver.samples=2",
                                            fmt::format("contacts.touch.approach=\"{}\"", approach)}));
      ASSERT_EQ(motion.failure(), "") << approach << at;
      EXPECT_NEAR(motion.value(0, "follower.y"), 20, 1e-13) << approach << at;
    }
  }
}

// A trolley on two wheels of 20, pulled along a rail of any length.
TEST(BoundaryCams, AStraightRailCarriesWheelsWhereverItEnds) {
  for (const double half : {200.0, 400.0, 20000.0}) {
    Mechanism m;
    const int trolley = add_body(m, "trolley", Vector2d(-0.15, 0.02));
    const int pull = add_body(m, "pull", Vector2d(-0.15, 0.02));
    const PointRef O = add_point(m, kGround, "O", Vector2d::Zero());
    const PointRef P = add_point(m, pull, "P", Vector2d::Zero());
    const int guide = add_prismatic(m, "guide", O, P, Vector2d::UnitX());
    add_slot(m, "hitch", P, add_point(m, trolley, "P", Vector2d::Zero()), Vector2d::UnitY());
    const Vector2d end(half * kMillimetre, 0);
    const CurveRef rail = add_curve(m, kGround, "rail", *Boundary::make({face_span(end, -end)}, false, 0));
    for (const double x : {-0.05, 0.05}) {
      add_contact(m, x < 0 ? "rear" : "front", rail,
                  add_curve(m, trolley, x < 0 ? "rear" : "front", *make_circle(Vector2d(x, 0), 0.02)));
    }
    add_driver(m, guide);
    use_boundaries(m);
    auto run = start_run(m, {-0.11});
    ASSERT_TRUE(run) << half << run.error().reason;
    for (int k = 0; k <= 12; ++k) {
      const double x = -0.11 + 0.017 * k;
      move_to(*run, {{x, 1, 0}});
      ASSERT_EQ(run->row.status, RowStatus::kOk) << half << " " << x;
      const BodyMotion& body = run->row.bodies[trolley];
      EXPECT_NEAR((body.X_WB.p_WB - Vector2d(x, 0.02)).norm(), 0, 1e-15) << half << " " << x;
      EXPECT_NEAR(body.theta, 0, 1e-14) << half << " " << x;
    }
  }
}

// The face of a follower is a line, which is followed up to the power of two from 10 times the size of the
// mechanism on; how many contacts there are besides does not matter.
TEST(BoundaryCams, EqualFollowersOnOneShoeLoseItTogether) {
  constexpr double r = 0.01, slope = 0.01;
  Mechanism m;
  const int shoe = add_body(m, "shoe");
  const int rail = add_prismatic(m, "rail", add_point(m, kGround, "O", Vector2d::Zero()),
                                 add_point(m, shoe, "O", Vector2d::Zero()), Vector2d::UnitX());
  const PointRef G = add_point(m, kGround, "G", Vector2d(0, 0.03));
  const CurveRef disc = add_curve(m, shoe, "disc", *make_circle({0, 0}, r));
  for (const char* name : {"a", "b", "c"}) {
    const int follower = add_body(m, name, Vector2d(0, r));
    add_prismatic(m, name, G, add_point(m, follower, "F", Vector2d::Zero()), Vector2d::UnitY());
    add_contact(m, name, disc, add_curve(m, follower, "face", *make_line({0, 0}, {slope, -1})));
    m.contacts.back().keep = Keep::kGap;
  }
  add_driver(m, rail);
  const double reach = std::exp2(std::ceil(std::log2(10 * size_of(m))));
  use_boundaries(m);
  auto run = start_run(m, {0});
  ASSERT_TRUE(run) << run.error().reason;
  move_to(*run, {{2 * reach, 1, 0}});
  // With F at the height r length - slope x, the foot of the disc's centre on the face is this far from F.
  const double length = std::hypot(1, slope);
  std::vector<double> lost;
  for (const RunEvent& event : run->events) {
    if (event.type == EventType::kRelease) {
      lost.push_back(event.driver);
    }
  }
  ASSERT_EQ(lost.size(), 3U);
  for (const double x : lost) {
    EXPECT_NEAR((x - slope * (r * length - slope * x)) / length, reach, 1e-12);
  }
}

// A disc of two arcs in a yoke with two parallel faces: y = r + e sin θ, from a pose that is 5 off.
TEST(BoundaryCams, APlateInAYokeOfTwoFacesMovesItsFaces) {
  constexpr double e = 0.01, r = 0.026;
  Mechanism m;
  const int cam = add_body(m, "cam");
  const int yoke = add_body(m, "yoke", Vector2d(0, 0.036));
  const PointRef O = add_point(m, kGround, "O", Vector2d::Zero());
  const int pivot = add_revolute(m, "pivot", O, add_point(m, cam, "O", Vector2d::Zero()));
  add_prismatic(m, "guide", O, add_point(m, yoke, "P", Vector2d::Zero()), Vector2d::UnitY());
  const Curve disc = *make_circle(Vector2d(e, 0), r);
  const CurveRef plate =
      add_curve(m, cam, "plate",
                *Boundary::make({conic_span(disc, 0, kPi), conic_span(disc, kPi, 2 * kPi)}, true, 1e-12));
  add_contact(m, "above", plate, add_curve(m, yoke, "above", *make_line({0, 0}, {0, -1})));
  add_contact(m, "below", plate, add_curve(m, yoke, "below", *make_line({0, -2 * r}, {0, 1})));
  add_driver(m, pivot);
  use_boundaries(m);
  for (const double from : {0.17, 2.0, 4.1}) {
    auto run = start_run(m, {from});
    ASSERT_TRUE(run) << from << run.error().reason;
    for (int k = 0; k <= 36; ++k) {
      const double u = from + k * kPi / 18;
      move_to(*run, {{u, 1, 0}});
      ASSERT_EQ(run->row.status, RowStatus::kOk) << u;
      const BodyMotion& body = run->row.bodies[yoke];
      EXPECT_NEAR(body.X_WB.p_WB.y(), r + e * std::sin(u), 1e-15) << u;
      EXPECT_NEAR(body.v_WB.y(), e * std::cos(u), 1e-15) << u;
      EXPECT_NEAR(body.a_WB.y(), -e * std::sin(u), 1e-14) << u;
    }
  }
}

}  // namespace
}  // namespace higherpair
