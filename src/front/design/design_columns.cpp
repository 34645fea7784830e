#include "design_columns.hpp"

#include "front/columns/measure_series.hpp"
#include "higherpair/io/column_dimension.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "numeric/eigen_index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr std::array kOfJoints = {".position", ".velocity", ".acceleration"};  // angle, omega and alpha

std::optional<std::size_t> quantity_of(const std::string& name, const std::string& owner, bool is_body) {
  for (std::size_t k = 0; k < kMotionEndings.size(); ++k) {
    if (!is_body && MotionEnding::is_of_angle(k)) continue;
    if (name == fmt::format("{}.{}", owner, kMotionEndings[k].name)) return k;
  }
  return std::nullopt;
}

// The rotation of the second body of a revolute joint relative to the first one. Driven joints have no
// columns of their own.
std::optional<BodyColumn> joint_column(const Mechanism& mechanism, const std::string& name) {
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const Joint& joint = mechanism.joints[j];
    if (joint.type != JointType::kRevolute || is_driven(mechanism, static_cast<int>(j))) continue;
    for (std::size_t k = 0; k < kOfJoints.size(); ++k) {
      if (name != joint.name + kOfJoints[k]) continue;
      return BodyColumn{static_cast<std::size_t>(joint.second.body), std::nullopt, 3 * k + 2, 1,
                        static_cast<std::size_t>(joint.first.body)};
    }
  }
  return std::nullopt;
}

// Derivatives of the position, velocity and acceleration of a point.
std::array<Vector2d, 3> point_slopes(const BodyMotion& body, const BodyMotion& change, const Vector2d& p_B,
                                     const Vector2d& p_B_slope) {
  const Vector2d r = body.X_WB.R_WB * p_B;
  const Vector2d r_slope = change.theta * perp(r) + body.X_WB.R_WB * p_B_slope;
  return {change.X_WB.p_WB + r_slope, change.v_WB + change.omega * perp(r) + body.omega * perp(r_slope),
          change.a_WB + change.alpha * perp(r) + body.alpha * perp(r_slope) -
              2 * body.omega * change.omega * r - body.omega * body.omega * r_slope};
}

std::optional<std::size_t> extreme_row(std::span<const double> values, double sign) {
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isnan(values[k]) && (!best || sign * values[k] > sign * values[*best])) best = k;
  }
  return best;
}

}  // namespace

std::optional<BodyColumn> body_column(const Mechanism& mechanism, const Units& units,
                                      const std::string& name) {
  const auto scaled = [&](BodyColumn column) {
    column.scale = from_si(dimension_of(column), units).apply(1);
    return column;
  };
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    if (const auto quantity = quantity_of(name, body.name, true)) {
      return scaled({b, std::nullopt, *quantity});
    }
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const auto quantity = quantity_of(name, body.name + "." + body.points[p].name, false);
      if (quantity) return scaled({b, p, *quantity});
    }
  }
  const auto joint = joint_column(mechanism, name);
  return joint ? std::optional(scaled(*joint)) : std::nullopt;
}

const Dimension& dimension_of(const BodyColumn& column) {
  return kMotionEndings[column.quantity].dimension;
}

int order_of(const BodyColumn& column) {
  return static_cast<int>(column.quantity / 3);
}

double column_slope(const BodyColumn& column, const Run& run, const Mechanism& derivative,
                    const RowSensitivity& of_row) {
  const BodyMotion& change = of_row.bodies[column.body];
  const auto k = static_cast<std::size_t>(order_of(column));
  if (MotionEnding::is_of_angle(column.quantity)) {
    const BodyMotion& minus = of_row.bodies[column.minus];
    return column.scale * (std::array{change.theta, change.omega, change.alpha}[k] -
                           std::array{minus.theta, minus.omega, minus.alpha}[k]);
  }
  Vector2d p_B = Vector2d::Zero(), p_B_slope = p_B;
  if (column.point) {
    p_B = run.mechanism().bodies[column.body].points[*column.point].p_B;
    p_B_slope = derivative.bodies[column.body].points[*column.point].p_B;
  }
  const auto slopes = point_slopes(run.row.bodies[column.body], change, p_B, p_B_slope);
  return column.scale * slopes[k](eigen_index(column.quantity % 3));
}

std::vector<WeightedRow> rows_of(const Measure& measure, std::span<const double> values,
                                 std::span<const double> places) {
  std::vector<WeightedRow> rows;
  const auto add = [&](std::optional<std::size_t> row, double weight) {
    if (row && !std::isnan(values[*row])) rows.push_back({*row, weight});
  };
  const auto highest = extreme_row(values, 1), lowest = extreme_row(values, -1);
  const auto defined = static_cast<double>(
      std::count_if(values.begin(), values.end(), [](double value) { return !std::isnan(value); }));
  switch (measure.of) {
    case MeasureKind::kMax:
      add(highest, 1);
      break;
    case MeasureKind::kMin:
      add(lowest, 1);
      break;
    case MeasureKind::kMaxAbs:
      if (highest && std::abs(values[*highest]) >= std::abs(values[*lowest])) {
        add(highest, values[*highest] < 0 ? -1 : 1);
      } else {
        add(lowest, -1);
      }
      break;
    case MeasureKind::kRange:
      add(highest, 1);
      add(lowest, -1);
      break;
    case MeasureKind::kFirst:
      add(0, 1);
      break;
    case MeasureKind::kLast:
      add(values.size() - 1, 1);
      break;
    case MeasureKind::kAt:
      add(rows_at(std::span(&measure.at, 1), places).front(), 1);
      break;
    case MeasureKind::kMean:
      for (std::size_t k = 0; k < values.size(); ++k) add(k, 1 / defined);
      break;
    case MeasureKind::kRms: {
      double sum = 0;
      for (const double value : values) sum += std::isnan(value) ? 0 : value * value;
      const double rms = std::sqrt(sum / defined);
      for (std::size_t k = 0; k < values.size() && rms > 0; ++k) add(k, values[k] / (defined * rms));
      break;
    }
  }
  return rows;
}

std::vector<double> places_of(const DriverSchedule& schedule) {
  std::vector<double> places;
  for (std::int64_t k = 0; k < schedule.size(); ++k) places.push_back(schedule.state(k).profile.position);
  return places;
}

std::vector<std::optional<std::size_t>> rows_at(std::span<const double> positions,
                                                std::span<const double> places) {
  std::map<double, std::size_t> first_there;
  for (std::size_t k = 0; k < places.size(); ++k) first_there.try_emplace(first_there.end(), places[k], k);
  std::vector<std::optional<std::size_t>> rows(positions.size());
  if (places.empty()) return rows;
  const double span = std::prev(first_there.end())->first - first_there.begin()->first;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double at = positions[i];
    const auto above = first_there.lower_bound(at);
    const auto off = [&](const auto& row) { return std::pair(std::abs(row.first - at), row.second); };
    auto nearest = above == first_there.end() ? off(*std::prev(above)) : off(*above);
    if (above != first_there.begin()) nearest = std::min(nearest, off(*std::prev(above)));
    if (is_there(nearest.first, at, span)) rows[i] = nearest.second;
  }
  return rows;
}

}  // namespace higherpair
