#include "higherpair/linkage/prp_dyad.hpp"
#include "higherpair/linkage/rpr_dyad.hpp"
#include "linkage/four_bar_motion.hpp"
#include "linkage/inverted_slider_crank.hpp"
#include "linkage/linkage_testing.hpp"
#include "linkage/scotch_yoke.hpp"
#include "linkage/slider_crank.hpp"

namespace higherpair::testing {

/// A plain pack of three configurations with just what scalar.hpp requires of a scalar, found by
/// argument-dependent lookup.
struct Pack {
  std::array<double, 3> lane{};
  Pack() = default;
  explicit Pack(double value) { lane.fill(value); }
};

struct Mask {
  std::array<bool, 3> lane{};
};

template <class F>
Pack each(const F& f) {
  Pack result;
  for (std::size_t i = 0; i < 3; ++i) result.lane[i] = f(i);
  return result;
}
template <class F>
Mask each_mask(const F& f) {
  Mask result;
  for (std::size_t i = 0; i < 3; ++i) result.lane[i] = f(i);
  return result;
}

// NOLINTBEGIN(bugprone-macro-parentheses)
#define PACK_OPERATOR(op)                                               \
  Pack operator op(const Pack& a, const Pack& b) {                      \
    return each([&](std::size_t i) { return a.lane[i] op b.lane[i]; }); \
  }
#define PACK_COMPARISON(op)                                                  \
  Mask operator op(const Pack& a, const Pack& b) {                           \
    return each_mask([&](std::size_t i) { return a.lane[i] op b.lane[i]; }); \
  }
// NOLINTEND(bugprone-macro-parentheses)
PACK_OPERATOR(+)
PACK_OPERATOR(-)
PACK_OPERATOR(*)
PACK_OPERATOR(/)
PACK_COMPARISON(<)
PACK_COMPARISON(>)
PACK_COMPARISON(<=)
PACK_COMPARISON(>=)
PACK_COMPARISON(==)

Pack operator-(const Pack& a) {
  return each([&](std::size_t i) { return -a.lane[i]; });
}
Pack sqrt(const Pack& a) {
  return each([&](std::size_t i) { return std::sqrt(a.lane[i]); });
}
Pack abs(const Pack& a) {
  return each([&](std::size_t i) { return std::abs(a.lane[i]); });
}
Pack copysign(const Pack& a, const Pack& b) {
  return each([&](std::size_t i) { return std::copysign(a.lane[i], b.lane[i]); });
}
Pack max(const Pack& a, const Pack& b) {
  return each([&](std::size_t i) { return std::max(a.lane[i], b.lane[i]); });
}
Pack select(const Mask& mask, const Pack& a, const Pack& b) {
  return each([&](std::size_t i) { return mask.lane[i] ? a.lane[i] : b.lane[i]; });
}

}  // namespace higherpair::testing

namespace higherpair {
namespace {

using namespace higherpair::testing;

// Lanes: an ordinary position, a change point, and one that cannot be assembled.
constexpr std::array<double, 3> kTheta{0.7, 0.0, 0.2};

Rotation<Pack> directions() {
  return {each([](std::size_t i) { return std::cos(kTheta[i]); }),
          each([](std::size_t i) { return std::sin(kTheta[i]); })};
}

Pack pack(double a, double b, double c) {
  Pack result;
  result.lane = {a, b, c};
  return result;
}

/// Each lane is the same as a scalar computation, up to the rounding that a fused multiply-add may change.
void expect_lane(const Pack& value, std::size_t lane, double expected) {
  EXPECT_TRUE(std::isfinite(value.lane[lane])) << "lane " << lane;
  EXPECT_AT_MOST(relative_error(value.lane[lane], expected), 1e-14) << "lane " << lane;
}

TEST(Pack, FourBarKernelRunsOnSeveralConfigurationsAtOnce) {
  const Pack r1 = pack(7, 3.1, 7), r2 = pack(2, 1.7, 2), r3 = pack(6, 3.1, 2.1), r4 = pack(5, 1.7, 1.2);
  const auto loop = make_four_bar_loop(r1, r2, r3, r4);
  const auto position = four_bar_position(loop, directions(), Pack(1));
  const auto rates = four_bar_rates(loop, position, directions(), Pack(1.3), Pack(-0.7));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto one_loop = make_four_bar_loop(r1.lane[i], r2.lane[i], r3.lane[i], r4.lane[i]);
    const auto u2 = Rotation<double>::from_angle(kTheta[i]);
    const auto one = four_bar_position(one_loop, u2, 1.0);
    const auto one_rates = four_bar_rates(one_loop, one, u2, 1.3, -0.7);
    expect_lane(position.reach.slack(), i, one.reach.slack());
    expect_lane(position.links.u_a.cos, i, one.links.u_a.cos);
    expect_lane(position.links.u_b.sin, i, one.links.u_b.sin);
    expect_lane(rates.omega_a, i, one_rates.omega_a);
    expect_lane(rates.alpha_b, i, one_rates.alpha_b);
  }
  EXPECT_EQ(status_of(position.reach.slack().lane[0], position.reach.noise.lane[0]), LinkageStatus::kOk);
  EXPECT_EQ(status_of(position.reach.slack().lane[1], position.reach.noise.lane[1]),
            LinkageStatus::kSingular);
  EXPECT_EQ(status_of(position.reach.slack().lane[2], position.reach.noise.lane[2]),
            LinkageStatus::kNotAssemblable);
}

TEST(Pack, SlidingKernelsRunOnSeveralConfigurationsAtOnce) {
  const auto rrp = make_rrp_loop(pack(2, 2, 5), pack(5, 3, 2), pack(0.75, 0, -6.5));
  const auto arm = rrp_position(rrp, directions(), Pack(-1));
  const auto arm_rates = rrp_rates(rrp, arm, directions(), Pack(1.3), Pack(-0.7));
  const auto one_rrp = make_rrp_loop(2.0, 5.0, 0.75);
  const auto u2 = Rotation<double>::from_angle(kTheta[0]);
  const auto one_arm = rrp_position(one_rrp, u2, -1.0);
  expect_lane(arm.along, 0, one_arm.along);
  expect_lane(arm_rates.along_ddot, 0, rrp_rates(one_rrp, one_arm, u2, 1.3, -0.7).along_ddot);
  EXPECT_EQ(status_of(arm.reach.slack().lane[2], arm.reach.noise.lane[2]), LinkageStatus::kNotAssemblable);

  const auto slider_loop = make_slider_loop(Pack(2), Pack(5), Pack(0.75));
  const auto slider = slider_position(slider_loop, pack(5.1, 4.2, 9), Pack(1));
  const auto slider_rate = slider_rates(slider_loop, slider, Pack(1.3), Pack(-0.7));
  const auto one_loop = make_slider_loop(2.0, 5.0, 0.75);
  const auto one_slider = slider_position(one_loop, 4.2, 1.0);
  expect_lane(slider_rate.alpha_b, 1, slider_rates(one_loop, one_slider, 1.3, -0.7).alpha_b);

  const auto slot_loop = make_slot_loop(pack(2, 1.9, 1), pack(5, 1.9, 2), pack(0.75, 0, 4));
  const auto slot = slot_position(slot_loop, directions(), Pack(1));
  const auto slot_rate = slot_rates(slot_loop, slot, directions(), Pack(1.3), Pack(-0.7));
  const auto one_slot_loop = make_slot_loop(2.0, 5.0, 0.75);
  const auto one_slot = slot_position(one_slot_loop, u2, 1.0);
  expect_lane(slot.u.sin, 0, one_slot.u.sin);
  expect_lane(slot_rate.s_ddot, 0, slot_rates(one_slot_loop, one_slot, u2, 1.3, -0.7).s_ddot);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(std::isfinite(arm_rates.alpha_leg.lane[i]));
    EXPECT_TRUE(std::isfinite(slider_rate.alpha_a.lane[i]));
    EXPECT_TRUE(std::isfinite(slot_rate.alpha.lane[i]));
  }

  const Rotation<Pack> straight{Pack(0), Pack(1)};
  const auto yoke = yoke_driven_position(Pack(1.7), straight, pack(0.3, 1.7, 2), Pack(1));
  const auto yoke_rate = yoke_driven_rates(Pack(1.7), straight, yoke, Pack(1.3), Pack(-0.7));
  expect_lane(yoke.r3, 0, std::sqrt(1.7 * 1.7 - 0.09));
  expect_lane(yoke_rate.r3_dot, 0, -0.3 * 1.3 / std::sqrt(1.7 * 1.7 - 0.09));
  EXPECT_TRUE(std::isfinite(yoke_rate.alpha2.lane[1]) && std::isfinite(yoke_rate.alpha2.lane[2]));
}

TEST(Pack, KernelsBetweenMovingEndsRunOnSeveralConfigurationsAtOnce) {
  const Vector2<Pack> D(pack(0.9, 0.6, 0.3), pack(0.4, 0.8, 0.1)), D_dot(Pack(1.1), Pack(-0.3));
  const Vector2<Pack> D_ddot(Pack(0.2), Pack(0.8));
  const auto reach = rpr_reach(D, Pack(-0.4), Pack(1));
  const auto position = rpr_position(D, Pack(-0.4), reach, Pack(-1));
  const auto rates = rpr_rates(position, Pack(-0.4), D_dot, D_ddot);
  const auto split = split_along(directions(), {Pack(0.6), Pack(0.8)}, D);
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector2d D_i(D.x().lane[i], D.y().lane[i]), v(1.1, -0.3), a(0.2, 0.8);
    const auto one_reach = rpr_reach(D_i, -0.4, 1.0);
    const auto one = rpr_position(D_i, -0.4, one_reach, -1.0);
    expect_lane(position.u.sin, i, one.u.sin);
    expect_lane(rates.s_ddot, i, rpr_rates(one, -0.4, v, a).s_ddot);
    const auto one_split = split_along(Rotation<double>::from_angle(kTheta[i]), {0.6, 0.8}, D_i);
    expect_lane(split.s1, i, one_split.s1);
    expect_lane(split.s2, i, one_split.s2);
  }
  EXPECT_EQ(status_of(reach.slack().lane[2], reach.noise.lane[2]), LinkageStatus::kNotAssemblable);
  EXPECT_TRUE(std::isfinite(rates.alpha.lane[2]));
}

}  // namespace
}  // namespace higherpair
