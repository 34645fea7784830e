#include "higherpair/io/derivative_table.hpp"

#include <cmath>

#include <fmt/format.h>

namespace higherpair {
namespace {

Dimension per_time(Dimension dimension, int order) {
  for (int k = 0; k < order; ++k) {
    dimension = dimension / dimension::kTime;
  }
  return dimension;
}

}  // namespace

DerivativeTable::DerivativeTable(const Profile& profile, int order)
    : mechanism_(&profile.mechanism), order_(order) {
  for (int k = 3; k <= order; ++k) {
    linear_.push_back(from_si(per_time(dimension::kLength, k), profile.units));
    angular_.push_back(from_si(per_time(dimension::kAngle, k), profile.units));
  }
  for (std::size_t i = 1; i < mechanism_->bodies.size(); ++i) {
    const Body& body = mechanism_->bodies[i];
    for (int k = 3; k <= order; ++k) {
      const std::string linear = unit_text(per_time(dimension::kLength, k), profile.units);
      const std::string angular = unit_text(per_time(dimension::kAngle, k), profile.units);
      columns_.push_back({fmt::format("{}.d{}x", body.name, k), linear});
      columns_.push_back({fmt::format("{}.d{}y", body.name, k), linear});
      columns_.push_back({fmt::format("{}.d{}angle", body.name, k), angular});
      for (const NamedPoint& point : body.points) {
        columns_.push_back({fmt::format("{}.{}.d{}x", body.name, point.name, k), linear});
        columns_.push_back({fmt::format("{}.{}.d{}y", body.name, point.name, k), linear});
      }
    }
  }
}

void DerivativeTable::number(const Scaling& scale, double value) {
  const double scaled = scale.apply(value);
  if (std::isfinite(scaled)) {
    cells_.emplace_back(scaled);
  } else {
    cells_.emplace_back();
  }
}

const std::vector<Cell>& DerivativeTable::behind(const std::vector<Cell>& cells, const Run& run,
                                                 const std::vector<DriverMotion>& drivers) {
  cells_ = cells;
  const auto bodies = derivatives_of(run, drivers, order_);
  if (!bodies) {
    cells_.resize(cells.size() + columns_.size());
    return cells_;
  }
  for (std::size_t i = 1; i < bodies->size(); ++i) {
    const BodyDerivatives& body = (*bodies)[i];
    for (int k = 3; k <= order_; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const Scaling& linear = linear_[at - 3];
      number(linear, body.p_WB[at].x());
      number(linear, body.p_WB[at].y());
      number(angular_[at - 3], body.theta[at]);
      for (const NamedPoint& point : mechanism_->bodies[i].points) {
        const Vector2d derivative = point_derivative(body, point.p_B, k);
        number(linear, derivative.x());
        number(linear, derivative.y());
      }
    }
  }
  return cells_;
}

}  // namespace higherpair
