#pragma once

#include "analysis/mechanism_builder.hpp"
#include "higherpair/analysis/dyad_chain.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

// Compares the rows of a chain with those of a run.

namespace higherpair::testing {

inline constexpr std::array kOfBodies = {
    ChainColumn::Quantity::kX,  ChainColumn::Quantity::kY,  ChainColumn::Quantity::kAngle,
    ChainColumn::Quantity::kVx, ChainColumn::Quantity::kVy, ChainColumn::Quantity::kOmega,
    ChainColumn::Quantity::kAx, ChainColumn::Quantity::kAy, ChainColumn::Quantity::kAlpha};

inline std::vector<DriverMotion> turn(double start, double way, std::size_t rows) {
  std::vector<DriverMotion> drivers;
  for (std::size_t k = 0; k < rows; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(rows - 1);
    drivers.push_back({start + way * share, 1.7 - share, 0.6});
  }
  return drivers;
}

inline std::vector<ChainColumn> all_columns(const Mechanism& mechanism) {
  std::vector<ChainColumn> columns;
  for (int body = 1; body < static_cast<int>(mechanism.bodies.size()); ++body) {
    for (const ChainColumn::Quantity quantity : kOfBodies) {
      columns.push_back({body, std::nullopt, quantity});
    }
    columns.push_back({body, 0, ChainColumn::Quantity::kX});
    columns.push_back({body, 0, ChainColumn::Quantity::kVy});
    columns.push_back({body, 0, ChainColumn::Quantity::kAx});
  }
  return columns;
}

inline double number_of(const ChainColumn& column, const Mechanism& mechanism, const MotionRow& row) {
  const auto body = static_cast<std::size_t>(column.item);
  const Vector2d p_B = column.point ? mechanism.bodies[body].points[*column.point].p_B : Vector2d(0, 0);
  const PointMotion point = point_motion(row.bodies[body], p_B);
  switch (column.quantity) {
    case ChainColumn::Quantity::kX:
      return point.p_W.x();
    case ChainColumn::Quantity::kY:
      return point.p_W.y();
    case ChainColumn::Quantity::kAngle:
      return row.bodies[body].theta;
    case ChainColumn::Quantity::kVx:
      return point.v_W.x();
    case ChainColumn::Quantity::kVy:
      return point.v_W.y();
    case ChainColumn::Quantity::kOmega:
      return row.bodies[body].omega;
    case ChainColumn::Quantity::kAx:
      return point.a_W.x();
    case ChainColumn::Quantity::kAy:
      return point.a_W.y();
    case ChainColumn::Quantity::kAlpha:
      return row.bodies[body].alpha;
    default:
      return NAN;  // not a column of a body
  }
}

// Tolerance of a column: positions relative to the mechanism's size, rates relative to the fastest motion.
// Allows for rounding magnified three times by the inverse of the smallest sine (0.02).
inline double precision_of(ChainColumn::Quantity quantity, const MotionRow& row, double size) {
  using Q = ChainColumn::Quantity;
  double fastest = 1;
  for (const BodyMotion& body : row.bodies) {
    fastest = std::max({fastest, std::abs(body.omega), body.v_WB.norm() / size});
  }
  const bool turning = quantity == Q::kAngle || quantity == Q::kOmega || quantity == Q::kAlpha;
  const double unit = turning ? 1 : size;
  return quantity >= Q::kAx   ? 1e-8 * unit * fastest * fastest
         : quantity >= Q::kVx ? 1e-10 * unit * fastest
                              : 1e-12 * unit;
}

enum class Outcome { kNoChain, kNotProven, kProven };

// Compares a chain with a run, row by row. The chain must not have missed anything that the run finds on the
// way.
inline Outcome compare(const Mechanism& mechanism, const std::vector<DriverMotion>& rows) {
  const auto plan = make_plan(mechanism);
  const auto columns = all_columns(mechanism);
  auto chain = plan ? DyadChain::of(mechanism, *plan, rows, columns) : std::nullopt;
  if (!chain) {
    return Outcome::kNoChain;
  }
  if (!chain->solve(mechanism)) {
    return Outcome::kNotProven;
  }
  auto run = start_run(make_run_model(mechanism, *plan), {rows.front().position});
  EXPECT_TRUE(run.has_value());
  for (std::size_t k = 0; run && k < rows.size(); ++k) {
    move_to(*run, {rows[k]});
    EXPECT_EQ(run->row.status, RowStatus::kOk) << "row " << k;
    for (const RunEvent& event : run->events) {
      EXPECT_EQ(event.type, EventType::kStrokeEnd) << "row " << k << ": " << event.cause;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double expected = number_of(columns[i], mechanism, run->row);
      EXPECT_LE(std::abs(chain->values(i)[k] - expected),
                precision_of(columns[i].quantity, run->row, plan->size))
          << "row " << k << " of column " << i << ", body " << columns[i].item;
    }
    if (::testing::Test::HasFailure()) {
      return Outcome::kProven;
    }
  }
  return Outcome::kProven;
}

}  // namespace higherpair::testing
