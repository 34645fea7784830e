#include "cam/law_testing.hpp"
#include "geometry/span_testing.hpp"
#include "higherpair/cam/flank.hpp"

namespace higherpair {
namespace {

OneFreedom pivot_at(const Vector2d& p) {
  OneFreedom freedom;
  freedom.p_WO = p;
  return freedom;
}

OneFreedom slide(const Vector2d& through, double direction) {
  OneFreedom freedom;
  freedom.turns = false;
  freedom.p_WO = through;
  freedom.direction_W = unit_vector(direction);
  return freedom;
}

void expect_flank_bounds(const CamMotion& motion, const Curve& curve, bool outer, unsigned seed) {
  const auto spans = cam_flank(motion, curve, outer);
  ASSERT_TRUE(spans) << seed << ": " << static_cast<int>(spans.error().kind) << " at "
                     << spans.error().coordinate;
  for (const SpanPtr& span : *spans) {
    testing::expect_bounds(*span, ++seed);
  }
}

TEST(FlankBounds, HoldForEveryFollowerAndLaw) {
  unsigned seed = 0;
  for (const LawType type :
       {LawType::kHarmonic, LawType::kCycloidal, LawType::kPolynomial345, LawType::kModifiedTrapezoid}) {
    const auto law = [&](double rise) {
      return testing::law_of(
          {{type, 2.1, rise}, {LawType::kDwell, 0.7}, {type, 2.3, -rise}, {LawType::kDwell, 2 * kPi - 5.1}},
          true);
    };
    const OneFreedom cam = pivot_at({0.3, -0.1});
    const Curve roller = *make_circle({0.1, -0.2}, 0.8);
    const Curve egg = *make_ellipse({0.1, 0}, {1.4, 0.8}, 0.2);
    for (const bool outer : {false, true}) {
      expect_flank_bounds({cam, 1, slide({0.6, 0}, 1.5), 1, 4.5, law(1.2)}, roller, outer, seed += 10);
    }
    expect_flank_bounds({cam, -1, slide({0.2, 0}, kPi / 2), 1, 4.5, law(1.2)}, egg, false, seed += 10);
    expect_flank_bounds({cam, 1, slide({0.2, 0}, kPi / 2), 1, 4.5, law(1.2)}, *make_point({0.1, -0.5}), false,
                        seed += 10);
    expect_flank_bounds({cam, 1, slide({0.2, 0}, kPi / 2), 1, 4.5, law(0.5)}, *make_line({0, 0}, {0.1, -1}),
                        false, seed += 10);
    expect_flank_bounds({cam, 1, pivot_at({8, 0}), 1, 2.6, law(-0.2)}, *make_circle({6, 0}, 0.8), false,
                        seed += 10);
    expect_flank_bounds({slide({0, 0}, 0), 1, slide({0, 0}, kPi / 2), 1, 4.5, law(0.2)}, roller, false,
                        seed += 10);
  }
}

// The law, and with it the flank, may have a shape of its own between any two of its points.
TEST(FlankBounds, HoldForALawThroughPoints) {
  LawDescription description;
  for (int i = 0; i <= 72; ++i) {
    const double x = 2 * kPi * i / 72;
    description.points.emplace_back(x, 0.6 * (1 - std::cos(x)) + 0.01 * std::sin(5 * x));
  }
  description.ends = SplineEnds::kPeriodic;
  description.repeats = true;
  expect_flank_bounds({pivot_at({0, 0}), 1, slide({0.2, 0}, kPi / 2), 1, 4.5, *MotionLaw::make(description)},
                      *make_circle({0, 0}, 0.8), false, 900);
}

}  // namespace
}  // namespace higherpair
