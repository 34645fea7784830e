#pragma once

#include "higherpair/cam/flank.hpp"
#include "higherpair/geometry/expansion.hpp"

#include <algorithm>
#include <cstddef>

namespace higherpair {

/// The follower's motion relative to the cam, as series of N powers of the cam's joint coordinate.
/// \tparam C  double, or an interval
template <class C, int N>
struct RelativeMotion {
  using Series = PowerSeries<C, N>;
  Rotation<Series> R;  ///< from the follower's frame to the cam's
  Vector2<Series> p;   ///< origin of the follower's frame in the cam's
  Vector2<Series> w;   ///< its velocity, in the follower's frame
  Series omega;
};

/// \param s  the law at `joint`
template <class C, int N>
[[nodiscard]] RelativeMotion<C, N> relative_motion(const CamMotion& motion,
                                                   const PowerSeries<C, N + 1>& joint,
                                                   const PowerSeries<C, N + 1>& s) {
  using Series = PowerSeries<C, N>;
  using Longer = PowerSeries<C, N + 1>;
  const auto shortened = [](const Longer& x) {
    Series y;
    std::copy_n(x.c.begin(), y.c.size(), y.c.begin());
    return y;
  };
  const auto derivative = [](const Longer& x) {
    Series y;
    for (std::size_t k = 0; k < y.c.size(); ++k) {
      y.c[k] = static_cast<double>(k + 1) * x.c[k + 1];
    }
    return y;
  };
  const auto constant = [](const Vector2d& v) { return Vector2<Longer>(Longer(v.x()), Longer(v.y())); };
  const auto pose_of = [&](const OneFreedom& freedom, const Longer& q) {
    if (freedom.turns) {
      const auto R = Rotation<Longer>::from_angle(q);
      return Pose<Longer>{R, constant(freedom.p_WO) - R * constant(freedom.p_BO)};
    }
    const Rotation<Longer> R{Longer(freedom.R_WB.cos), Longer(freedom.R_WB.sin)};
    return Pose<Longer>{
        R, constant(freedom.p_WO - freedom.R_WB * freedom.p_BO) + q * constant(freedom.direction_W)};
  };
  const Pose<Longer> cam = pose_of(motion.cam, motion.cam_sign * joint);
  const Longer q = motion.follower_sign * (motion.follower_rest + s);
  const Pose<Longer> follower = pose_of(motion.follower, q);
  const auto [R, p] = cam.inverse_times(follower);
  RelativeMotion<C, N> relative;
  relative.R = {shortened(R.cos), shortened(R.sin)};
  relative.p = {shortened(p.x()), shortened(p.y())};
  relative.w = relative.R.inverse() * Vector2<Series>(derivative(p.x()), derivative(p.y()));
  relative.omega = Series(0.0);
  if (motion.follower.turns) {
    relative.omega += derivative(q);
  }
  if (motion.cam.turns) {
    relative.omega -= Series(motion.cam_sign);
  }
  return relative;
}

}  // namespace higherpair
