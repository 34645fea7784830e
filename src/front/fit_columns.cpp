#include "fit_columns.hpp"

#include "higherpair/io/coordinate.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace higherpair {
namespace {

// Endings of column names for positions, velocities and accelerations.
constexpr std::array<std::array<std::string_view, 3>, 3> kMeasuredEndings = {
    {{"x", "y", "angle"}, {"vx", "vy", "omega"}, {"ax", "ay", "alpha"}}};
constexpr std::array<std::string_view, 3> kOfJoints = {"position", "velocity", "acceleration"};

struct Part {
  int axis = 0;
  int order = 0;
};

std::optional<Part> part_of(std::string_view ending) {
  for (std::size_t order = 0; order < 3; ++order) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (kMeasuredEndings[order][axis] == ending)
        return Part{static_cast<int>(axis), static_cast<int>(order)};
    }
  }
  return std::nullopt;
}

double scale_of(const Part& part, const Units& units) {
  const Dimension of = coordinate_dimension(part.axis == 2);
  return from_si({.length = of.length, .time = -part.order, .angle = of.angle}, units).apply(1);
}

// d/dp of the position, velocity or acceleration of the point p_B of a body: p + r, v + ω t, a + α t - ω² r,
// where r is the vector from the body's origin to the point in ground and t is r turned by 90 degrees.
Vector2d point_derivative(const BodyMotion& body, const BodyMotion& by, const Vector2d& p_B,
                          const Vector2d& p_B_by, int order) {
  const Vector2d r = body.X_WB.R_WB * p_B;
  const Vector2d dr = by.theta * perp(r) + body.X_WB.R_WB * p_B_by;
  switch (order) {
    case 0:
      return by.X_WB.p_WB + dr;
    case 1:
      return by.v_WB + by.omega * perp(r) + body.omega * perp(dr);
    default:
      return by.a_WB + by.alpha * perp(r) + body.alpha * perp(dr) - 2 * body.omega * by.omega * r -
             body.omega * body.omega * dr;
  }
}

double angle_part(const BodyMotion& motion, int order) {
  return order == 0 ? motion.theta : order == 1 ? motion.omega : motion.alpha;
}

}  // namespace

bool driver_turns(const Mechanism& mechanism, std::size_t driver) {
  return has_angle(driven_joint(mechanism, driver).type);
}

FitColumns::FitColumns(const Mechanism& mechanism, const FitData& data) {
  const Units& units = data.model.units();
  for (std::size_t c = 0; c < data.columns.size(); ++c) {
    const std::string& name = data.columns[c].name;
    const std::size_t before = motions_.size();
    for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
      const Body& body = mechanism.bodies[b];
      if (!name.starts_with(body.name + ".")) continue;
      const std::string rest = name.substr(body.name.size() + 1);
      if (const auto part = part_of(rest)) {
        motions_.push_back({c, b, 0, -1, part->axis, part->order, scale_of(*part, units)});
      }
      for (std::size_t p = 0; p < body.points.size(); ++p) {
        if (!rest.starts_with(body.points[p].name + ".")) continue;
        const auto part = part_of(std::string_view(rest).substr(body.points[p].name.size() + 1));
        if (part && part->axis < 2) {
          motions_.push_back({c, b, 0, static_cast<int>(p), part->axis, part->order, scale_of(*part, units)});
        }
      }
    }
    for (const Joint& joint : mechanism.joints) {
      for (std::size_t order = 0; order < 3 && joint.type == JointType::kRevolute; ++order) {
        if (name != joint.name + "." + std::string(kOfJoints[order])) continue;
        const Part part{2, static_cast<int>(order)};
        motions_.push_back({c, static_cast<std::size_t>(joint.second.body),
                            static_cast<std::size_t>(joint.first.body), -1, 2, part.order,
                            scale_of(part, units)});
      }
    }
    // An ambiguous name is left to the others, which are computed from the table.
    if (motions_.size() != before + 1) {
      motions_.resize(before);
      others_.push_back(c);
    }
  }
}

RatesAsked FitColumns::rates() const {
  const bool positions =
      others_.empty() &&
      std::all_of(motions_.begin(), motions_.end(), [](const Motion& motion) { return motion.order == 0; });
  return positions ? RatesAsked::kNone : RatesAsked::kAll;
}

void FitColumns::derivatives(const Run& run, const Mechanism& derivative, const RowSensitivity& of_row,
                             Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> out) const {
  for (const Motion& motion : motions_) {
    const BodyMotion& body = run.row.bodies[motion.body];
    const BodyMotion& by = of_row.bodies[motion.body];
    double value = 0;
    if (motion.axis == 2) {
      value = angle_part(by, motion.order) - angle_part(of_row.bodies[motion.minus], motion.order);
    } else {
      const auto point_in = [&](const Mechanism& mechanism) -> Vector2d {
        return motion.point < 0 ? Vector2d(Vector2d::Zero())
                                : mechanism.bodies[motion.body].points[motion.point].p_B;
      };
      value = point_derivative(body, by, point_in(run.mechanism()), point_in(derivative),
                               motion.order)(motion.axis);
    }
    out(static_cast<Eigen::Index>(motion.column)) = motion.scale * value;
  }
}

}  // namespace higherpair
