#pragma once

#include "design_row_reader.hpp"
#include "model_data.hpp"

#include <memory>

namespace higherpair {

/// A candidate's mechanism and order of solution, its drivers, and its profile where measures need it.
struct DesignCandidate {
  std::shared_ptr<const Model::Data> data;
  std::unique_ptr<const Mechanism> mechanism;
  Plan plan;
  DriverSchedule schedule;
};

/// What becomes of the rows behind a limit position.
enum class WhenLost {
  kLookFurther,  ///< those that can be assembled count: how many are missing says how much is wrong
  kGiveUp,       ///< all are missing: closed forms say how much is wrong, and better
};

/// The rows of a candidate by following its motion; with the table that measures need, where there are some.
void follow_rows(const DesignSetup& setup, const DesignCandidate& candidate, int branch, WhenLost when_lost,
                 DesignRows& rows);

}  // namespace higherpair
