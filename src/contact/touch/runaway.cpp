#include "contact_points.hpp"
#include "higherpair/contact/critical_positions.hpp"

#include <cmath>

namespace higherpair {

std::vector<Opening> openings_of(const Curve& curve) {
  if (is_line(curve)) {
    return {{perp(curve.axis_B), true, curve.vertex_B}};
  }
  if (!is_conic(curve) || curve.q > 0) {
    return {};
  }
  if (curve.q == 0) {
    return {{curve.axis_B, false, Vector2d::Zero()}};
  }
  const auto [a, b] = semi_axes(curve);
  std::vector<Opening> openings;
  for (const double sign : {1.0, -1.0}) {
    const Vector2d direction = a * curve.axis_B + sign * b * perp(curve.axis_B);
    openings.push_back({direction.normalized(), true, center(curve)});
  }
  return openings;
}

namespace {

// Both bodies turn, two asymptotes coincide: N·(O2 - O1) = b1 ∓ b2, b_i the distance of the line from O_i.
void add_turning(const ContactPair& pair, const Opening& one, const Opening& two,
                 std::vector<double>& found) {
  const Vector2d N1_B = perp(one.direction_B);
  const Vector2d between_W = pair.motion2.p_WO - pair.motion1.p_WO;
  const double b1 = (one.point_B - pair.motion1.p_BO).dot(N1_B);
  const double b2 = (two.point_B - pair.motion2.p_BO).dot(perp(two.direction_B));
  for (const double sense : {1.0, -1.0}) {
    const double cosine = (b1 - sense * b2) / between_W.norm();
    if (std::abs(cosine) <= 1) {
      for (const double sign : {1.0, -1.0}) {
        found.push_back(angle_of(between_W) + sign * std::acos(cosine) - angle_of(N1_B));
      }
    }
  }
}

// The driver slides: N·(p1 + u d1 - O2) = ± b2.
void add_sliding(const ContactPair& pair, const Opening& one, const Opening& two,
                 std::vector<double>& found) {
  const Vector2d N_W = pair.motion1.R_WB * perp(one.direction_B);
  const double speed = N_W.dot(pair.motion1.direction_W);
  const double b1 = N_W.dot(pose_at(pair.motion1, 0) * one.point_B - pair.motion2.p_WO);
  const double b2 = (two.point_B - pair.motion2.p_BO).dot(perp(two.direction_B));
  for (const double sense : {1.0, -1.0}) {
    if (speed != 0) {
      found.push_back((sense * b2 - b1) / speed);
    }
  }
}

// The driver turns until its opening is parallel to a fixed direction, in either sense.
void add_parallel(const Opening& one, const Vector2d& direction_W, std::vector<double>& found) {
  const double u = angle_of(direction_W) - angle_of(one.direction_B);
  found.push_back(u);
  found.push_back(u + kPi);
}

}  // namespace

std::vector<double> runaway_positions(const ContactPair& pair) {
  std::vector<double> found;
  const bool lines = is_line(pair.curve1) && is_line(pair.curve2);
  const std::vector<Opening> second = openings_of(pair.curve2);
  const bool turns1 = pair.motion1.turns;
  const bool turns2 = pair.motion2.turns;
  for (const Opening& one : openings_of(pair.curve1)) {
    if (turns1 && !turns2) {
      add_parallel(one, pair.motion2.direction_W, found);
    }
    for (const Opening& two : second) {
      if (turns1 && !turns2) {
        add_parallel(one, pair.motion2.R_WB * two.direction_B, found);
      } else if (one.has_asymptote && two.has_asymptote && !lines && turns2) {
        turns1 ? add_turning(pair, one, two, found) : add_sliding(pair, one, two, found);
      }
    }
  }
  return found;
}

}  // namespace higherpair
