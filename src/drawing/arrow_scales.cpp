#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "sketch.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace higherpair {
namespace {

constexpr double kLongestArrow = 14;        // [units]
constexpr double kLongestTurn = 1.5 * kPi;  // largest angle of the arc of a torque
constexpr double kTipMargin = 1;            // beyond the tip of an arrow [units]

// The scale by which the longest arrow of all rows has the length `longest`. Where a few rows are out of
// proportion, as near a limit position, it is four times the median of the rows that has this length, and
// those arrows are longer.
double scale_for(std::vector<double> of_rows, double longest) {
  std::erase_if(of_rows, [](double size) { return !(size > 0); });
  if (of_rows.empty()) {
    return 0;
  }
  const auto middle = of_rows.begin() + static_cast<std::ptrdiff_t>(of_rows.size() / 2);
  std::nth_element(of_rows.begin(), middle, of_rows.end());
  const double typical = *middle;
  const double largest = *std::max_element(of_rows.begin(), of_rows.end());
  return longest / (typical > kOutOfProportion * largest ? std::min(largest, 4 * typical) : largest);
}

void extend(Box& box, const Vector2d& p, double margin) {
  box = box.joined({(p.array() - margin).matrix(), (p.array() + margin).matrix()});
}

Box& room_of(Role role, Scene& scene) {
  for (Scene::Room& room : scene.rooms) {
    if (room.role == role) return room.box;
  }
  return scene.rooms.emplace_back(Scene::Room{role, scene.view}).box;
}

}  // namespace

void add_arrow_rooms(Scene& scene) {
  const double longest = kLongestArrow * scene.unit, margin = kTipMargin * scene.unit;
  for (const Shape& shape : scene.moving) {
    const std::vector<double>& n = shape.numbers;
    if (n.empty() || shape.role == Role::kCenter || shape.role == Role::kDriver) continue;  // within the view
    if (shape.kind == Shape::Kind::kArrow) {
      const Vector2d from(n[0], n[1]), arrow = Vector2d(n[2], n[3]) - from;
      extend(room_of(shape.role, scene), from + arrow * std::min(1.0, longest / arrow.norm()), margin);
    } else if (shape.role == Role::kForce) {  // the arc of a torque
      for (std::size_t i = 0; i + 1 < n.size(); i += 2) {
        extend(room_of(shape.role, scene), {n[i], n[i + 1]}, margin);
      }
    }
  }
}

void set_arrow_scales(const Sketch& sketch, Scene& scene) {
  std::vector<double> velocities, accelerations;
  for (const MotionRow* row : sketch.rows) {
    double fastest = 0, hardest = 0;
    for (std::size_t i = 1; i < row->bodies.size(); ++i) {
      if (!row->all_rates && !row->has_rates[i]) {
        continue;
      }
      for (const NamedPoint& point : sketch.mechanism.bodies[i].points) {
        const PointMotion motion = point_motion(row->bodies[i], point.p_B);
        fastest = std::max(fastest, motion.v_W.norm());
        hardest = std::max(hardest, motion.a_W.norm());
      }
    }
    velocities.push_back(fastest);
    accelerations.push_back(hardest);
  }
  const double longest = kLongestArrow * scene.unit / kMillimetresPerMetre;
  scene.velocity_scale = scale_for(std::move(velocities), longest);
  scene.acceleration_scale = scale_for(std::move(accelerations), longest);
}

void set_force_scales(const Mechanism& mechanism, const std::vector<Reactions>& reactions, Scene& scene) {
  std::vector<double> forces, torques;
  for (const Reactions& row : reactions) {
    const LargestForces largest = largest_forces(mechanism, row);
    forces.push_back(largest.force);
    torques.push_back(largest.torque);
  }
  scene.force_scale = scale_for(std::move(forces), kLongestArrow * scene.unit);
  scene.torque_scale = scale_for(std::move(torques), kLongestTurn);
}

}  // namespace higherpair
