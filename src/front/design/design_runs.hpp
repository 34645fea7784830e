#pragma once

#include "design_row_reader.hpp"
#include "front/model_data.hpp"

#include <memory>

namespace higherpair {

/// A candidate's mechanism, order of solution and drivers; also its profile where measures need it.
struct DesignCandidate {
  std::shared_ptr<const Model::Data> data;
  std::unique_ptr<const Mechanism> mechanism;
  Plan plan;
  DriverSchedule schedule;
};

/// What happens to the rows beyond a limit position.
enum class WhenLost {
  kLookFurther,  ///< rows that can be assembled count: the number of missing ones measures the violation
  kGiveUp,       ///< all count as missing: closed forms give a better measure of the violation
};

/// Computes the rows of a candidate by following its motion, with the table that measures need, if any.
void follow_rows(const DesignSetup& setup, const DesignCandidate& candidate, int branch, WhenLost when_lost,
                 DesignRows& rows);

}  // namespace higherpair
