#include "higherpair/geometry/gear_outline.hpp"

#include <cassert>
#include <cmath>

namespace higherpair {
namespace {

SpanPtr arc_about(const Vector2d& center, double radius, double from, double to) {
  return conic_span(*make_circle(center, radius), from, to);
}

}  // namespace

double half_angle_at_roll(const InvoluteTooth& tooth, double roll) {
  return half_angle_at_base(tooth) - (roll - std::atan(roll));
}

std::vector<SpanPtr> gear_outline(const GearShape& gear) {
  const InvoluteTooth& tooth = gear.tooth;
  const double base = base_radius(tooth);
  const Bounds roll = {roll_at_root(tooth), roll_at_tip(tooth)};
  const double tip = base * std::hypot(1, roll.high);
  const double root = tooth.module * (tooth.teeth / 2 - gear.dedendum + tooth.profile_shift);
  const double at_tip = half_angle_at_roll(tooth, roll.high);
  const double at_root = half_angle_at_roll(tooth, roll.low);
  const double pitch = 2 * kPi / tooth.teeth;
  assert(root > 0 && roll.low > 0 && roll.width() > 0 && at_tip > 0 && at_root < pitch / 2);
  std::vector<SpanPtr> spans;
  for (int i = 0; i < static_cast<int>(tooth.teeth); ++i) {
    const double middle = gear.angle + i * pitch;
    const auto flank = [&](Hand hand) {
      const double start = middle + (hand == Hand::kLeft ? 1 : -1) * half_angle_at_base(tooth);
      return involute_span({gear.center_B, base, start, hand, roll});
    };
    const SpanPtr right = flank(Hand::kRight);
    const SpanPtr left = flank(Hand::kLeft);
    const auto on_root = [&](double angle) { return Vector2d(gear.center_B + root * unit_vector(angle)); };
    spans.push_back(face_span(on_root(middle - at_root), right->at(right->range().low).p_B));
    spans.push_back(right);
    spans.push_back(arc_about(gear.center_B, tip, middle - at_tip, middle + at_tip));
    spans.push_back(left);
    spans.push_back(face_span(left->at(left->range().high).p_B, on_root(middle + at_root)));
    spans.push_back(arc_about(gear.center_B, root, middle + at_root, middle + pitch - at_root));
  }
  return spans;
}

}  // namespace higherpair
