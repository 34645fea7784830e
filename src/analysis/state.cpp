#include "higherpair/analysis/state.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {

bool have_same_poses(const State& a, const State& b, double size, double near) {
  const auto same = [&](const BodyMotion& one, const BodyMotion& other) {
    const Pose<double>& at = one.X_WB;
    const Pose<double>& there = other.X_WB;
    const double turned = std::abs(at.R_WB.cos - there.R_WB.cos) + std::abs(at.R_WB.sin - there.R_WB.sin);
    return turned <= near && (at.p_WB - there.p_WB).norm() <= near * size;
  };
  return std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(), same);
}

}  // namespace higherpair
