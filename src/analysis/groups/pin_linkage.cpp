#include "higherpair/analysis/pin_linkage.hpp"

#include "higherpair/analysis/branch_run.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/mechanism/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// For each body with points, the index of its first point's x among the mechanism's numbers.
std::vector<std::size_t> first_point_numbers(const Mechanism& mechanism) {
  std::vector<const double*> order;
  for_each_number(mechanism, [&](const double& number) { order.push_back(&number); });
  std::vector<std::size_t> firsts;
  for (const Body& body : mechanism.bodies) {
    const double* const x = body.points.empty() ? nullptr : body.points.front().p_B.data();
    firsts.push_back(static_cast<std::size_t>(std::find(order.begin(), order.end(), x) - order.begin()));
  }
  return firsts;
}

}  // namespace

std::optional<PinLinkage> PinLinkage::of(const Mechanism& mechanism, const Plan& plan) {
  const bool pins = std::all_of(mechanism.joints.begin(), mechanism.joints.end(),
                                [](const Joint& joint) { return joint.type == JointType::kRevolute; });
  if (!pins || !mechanism.contacts.empty() || plan.surplus > 0) {
    return std::nullopt;
  }
  PinLinkage linkage;
  linkage.point_numbers_ = first_point_numbers(mechanism);
  for (const Group& group : plan.groups) {
    if (!linkage.add(mechanism, group)) return std::nullopt;
  }
  for (const BodyMotion& body : posed_bodies(mechanism)) {
    linkage.posed_.push_back(body.X_WB);
  }
  linkage.poses_ = linkage.posed_;
  linkage.pose_slopes_.resize(linkage.poses_.size());
  linkage.set_numbers(numbers_of(mechanism));
  return linkage;
}

bool PinLinkage::add(const Mechanism& mechanism, const Group& group) {
  if (const auto* dyad = std::get_if<RrrDyad>(&group.kind)) {
    return add_dyad(mechanism, group, *dyad);
  }
  const auto* driven = std::get_if<DrivenBody>(&group.kind);
  if (driven == nullptr) {
    return false;
  }
  const Joint& joint = driven_joint(mechanism, static_cast<std::size_t>(driven->driver));
  steps_.push_back({false, driven_.size()});
  driven_.push_back(
      {driven->carried.body, driven->driver, joint.second.body == driven->carried.body ? 1. : -1.,
       end_of(end_off(joint, driven->carried.body)), end_of(end_on(joint, driven->carried.body))});
  return true;
}

bool PinLinkage::add_dyad(const Mechanism& mechanism, const Group& group, const RrrDyad& dyad) {
  if (group.joints.size() != 3) {
    return false;
  }
  Dyad added;
  added.link_a = dyad.link_a;
  added.link_b = dyad.link_b;
  added.pin_C = dyad.pin_C;
  int found = 0;
  for (const int index : group.joints) {
    const Joint& joint = mechanism.joints[index];
    const bool at_a = has_end_on(joint, dyad.link_a);
    const bool at_b = has_end_on(joint, dyad.link_b);
    if (at_a && at_b) {
      added.a_C = end_of(end_on(joint, dyad.link_a));
      added.b_C = end_of(end_on(joint, dyad.link_b));
      found |= 1;
    } else if (at_a) {
      added.a_A = end_of(end_on(joint, dyad.link_a));
      added.A = end_of(end_off(joint, dyad.link_a));
      found |= 2;
    } else if (at_b) {
      added.b_B = end_of(end_on(joint, dyad.link_b));
      added.B = end_of(end_off(joint, dyad.link_b));
      found |= 4;
    }
  }
  steps_.push_back({true, dyads_.size()});
  dyads_.push_back(std::move(added));
  return found == 7;
}

void PinLinkage::set_numbers(std::span<const double> numbers) {
  numbers_.assign(numbers.begin(), numbers.end());
  poses_ = posed_;
  for (Dyad& dyad : dyads_) {
    dyad.along_a = in_body(dyad.a_C) - in_body(dyad.a_A);
    dyad.along_b = in_body(dyad.b_C) - in_body(dyad.b_B);
    dyad.a = dyad.along_a.norm();
    dyad.b = dyad.along_b.norm();
  }
}

void PinLinkage::set_branch(int branch) {
  poses_ = posed_;
  for (std::size_t k = 0; k < dyads_.size(); ++k) {
    dyads_[k].sigma = mode_on(branch, k);
  }
}

bool PinLinkage::place(std::span<const Rotation<double>> drivers) {
  known_ = placed_ = 0;
  for (const Step& step : steps_) {
    if (!step.is_dyad) {
      place(driven_[step.index], drivers);
    } else {
      ++known_;
      if (!place(dyads_[step.index])) return false;
    }
    ++placed_;
  }
  return true;
}

void PinLinkage::place(const Driven& driven, std::span<const Rotation<double>> drivers) {
  const Rotation<double>& turn = drivers[driven.driver];
  Pose<double>& X_WB = poses_[driven.body];
  X_WB.R_WB = pose(driven.known.body).R_WB * Rotation<double>{turn.cos, driven.sense * turn.sin};
  X_WB.p_WB = in_ground(driven.known) - X_WB.R_WB * in_body(driven.own);
}

// From A, C is d/2 + (a² - b²)/2d along the vector D from A to B, and √((a+b)² - d²)√(d² - (a-b)²)/2d across
// it.
bool PinLinkage::place(Dyad& dyad) {
  dyad.A_W = in_ground(dyad.A);
  dyad.B_W = in_ground(dyad.B);
  const Vector2d D_W = dyad.B_W - dyad.A_W;
  const double d2 = D_W.squaredNorm();
  const double d = std::sqrt(d2);
  const double sum = dyad.a + dyad.b;
  const double difference = dyad.a - dyad.b;
  dyad.gap = std::max(d - sum, std::abs(difference) - d);
  if (!(dyad.gap <= 0) || d2 == 0 || dyad.a == 0 || dyad.b == 0) {
    return false;
  }
  const double area = std::sqrt((sum - d) * (sum + d) * ((d - difference) * (d + difference)));
  const double half = 0.5 / d2;
  const Vector2d r_a = half * ((d2 + difference * sum) * D_W + dyad.sigma * area * perp(D_W));
  const Vector2d r_b = r_a - D_W;
  dyad.C_W = dyad.A_W + r_a;
  const auto pose_link = [&](int link, const Vector2d& r, const Vector2d& along, double length,
                             const Vector2d& pin_W, const End& pin) {
    Pose<double>& X_WB = poses_[link];
    const double scale = 1 / (length * length);
    X_WB.R_WB = {along.dot(r) * scale, cross(along, r) * scale};
    X_WB.p_WB = pin_W - X_WB.R_WB * in_body(pin);
  };
  pose_link(dyad.link_a, r_a, dyad.along_a, dyad.a, dyad.A_W, dyad.a_A);
  pose_link(dyad.link_b, r_b, dyad.along_b, dyad.b, dyad.B_W, dyad.b_B);
  return true;
}

std::optional<std::size_t> PinLinkage::dyad_at(int joint) const {
  const auto found =
      std::find_if(dyads_.begin(), dyads_.end(), [&](const Dyad& dyad) { return dyad.pin_C == joint; });
  return found == dyads_.end() ? std::nullopt
                               : std::optional(static_cast<std::size_t>(found - dyads_.begin()));
}

double PinLinkage::transmission(std::size_t index) const {
  const Dyad& dyad = dyads_[index];
  return cross(Vector2d(dyad.A_W - dyad.C_W), Vector2d(dyad.B_W - dyad.C_W)) / (dyad.a * dyad.b);
}

Vector2d PinLinkage::slope_of(const End& end) const {
  const PoseSlope& slope = pose_slopes_[end.body];
  const Rotation<double>& R_WB = pose(end.body).R_WB;
  return slope.p_W + slope.theta * perp(R_WB * in_body(end)) + R_WB * slope_in_body(end);
}

Vector2d PinLinkage::fixed_slope(int link, const End& from, const End& to) const {
  return pose(link).R_WB * Vector2d(slope_in_body(to) - slope_in_body(from));
}

void PinLinkage::differentiate(std::span<const double> slopes) {
  slopes_.assign(slopes.begin(), slopes.end());
  std::fill(pose_slopes_.begin(), pose_slopes_.end(), PoseSlope());
  for (std::size_t k = 0; k < placed_; ++k) {
    steps_[k].is_dyad ? differentiate(dyads_[steps_[k].index]) : differentiate(driven_[steps_[k].index]);
  }
}

void PinLinkage::differentiate(const Driven& driven) {
  PoseSlope& slope = pose_slopes_[driven.body];
  const Rotation<double>& R_WB = pose(driven.body).R_WB;
  slope.theta = pose_slopes_[driven.known.body].theta;
  slope.p_W = slope_of(driven.known) - slope.theta * perp(R_WB * in_body(driven.own)) -
              R_WB * slope_in_body(driven.own);
}

void PinLinkage::differentiate(const Dyad& dyad) {
  const Vector2d A = slope_of(dyad.A);
  const Vector2d B = slope_of(dyad.B);
  const Vector2d r_a = dyad.C_W - dyad.A_W;
  const Vector2d r_b = dyad.C_W - dyad.B_W;
  const Vector2d h =
      B + fixed_slope(dyad.link_b, dyad.b_B, dyad.b_C) - A - fixed_slope(dyad.link_a, dyad.a_A, dyad.a_C);
  const double determinant = cross(r_a, r_b);
  const double inverse = determinant == 0 ? 0 : 1 / determinant;
  const auto set = [&](int link, double theta, const Vector2d& pin_slope, const End& pin) {
    const Rotation<double>& R_WB = pose(link).R_WB;
    pose_slopes_[link] = {pin_slope - theta * perp(R_WB * in_body(pin)) - R_WB * slope_in_body(pin), theta};
  };
  set(dyad.link_a, h.dot(r_b) * inverse, A, dyad.a_A);
  set(dyad.link_b, h.dot(r_a) * inverse, B, dyad.b_B);
}

double PinLinkage::gap_slope(std::size_t index) const {
  const Dyad& dyad = dyads_[index];
  const Vector2d D_W = dyad.B_W - dyad.A_W;
  const double d = D_W.norm();
  const double apart = d == 0 ? 0 : D_W.dot(slope_of(dyad.B) - slope_of(dyad.A)) / d;
  const auto length = [&](const Vector2d& along, double size, const End& from, const End& to) {
    return size == 0 ? 0 : along.dot(slope_in_body(to) - slope_in_body(from)) / size;
  };
  const double a = length(dyad.along_a, dyad.a, dyad.a_A, dyad.a_C);
  const double b = length(dyad.along_b, dyad.b, dyad.b_B, dyad.b_C);
  const bool stretched = d - (dyad.a + dyad.b) >= std::abs(dyad.a - dyad.b) - d;
  return stretched ? apart - (a + b) : (dyad.a > dyad.b ? a - b : b - a) - apart;
}

// From the change of the angle between both links: the turn of each body plus that of the link within it.
double PinLinkage::transmission_slope(std::size_t index) const {
  const Dyad& dyad = dyads_[index];
  const auto turning = [&](int link, const Vector2d& along, double size, const End& from, const End& to) {
    return pose_slopes_[link].theta +
           cross(along, Vector2d(slope_in_body(to) - slope_in_body(from))) / (size * size);
  };
  const double cosine = Vector2d(dyad.A_W - dyad.C_W).dot(Vector2d(dyad.B_W - dyad.C_W)) / (dyad.a * dyad.b);
  return cosine * (turning(dyad.link_b, dyad.along_b, dyad.b, dyad.b_B, dyad.b_C) -
                   turning(dyad.link_a, dyad.along_a, dyad.a, dyad.a_A, dyad.a_C));
}

}  // namespace higherpair
