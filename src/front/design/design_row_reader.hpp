#pragma once

#include "design_rows.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// Records the quantities of one candidate, row by row, into DesignRows.
class RowReader {
public:
  RowReader(const DesignSetup& setup, const Mechanism& mechanism, const Plan& plan, DesignRows& rows);

  /// \param assembled  whether the bodies could be positioned
  void take(const std::vector<BodyMotion>& bodies, bool assembled, double driver, RowStatus status);
  /// \param gaps  of each group of the plan, in the last row taken
  void take_gaps(const std::vector<std::optional<double>>& gaps);
  void take_gaps(const std::vector<BodyMotion>& bodies);
  /// \param rows  on which the gap of this group depends; empty: the gap lies between rows
  void take_gap(std::size_t group, double gap, const std::vector<WeightedRow>& rows);
  /// \param limits  number of events on the path that end it
  void finish(int limits);

private:
  void take_transmissions(const std::vector<BodyMotion>& bodies);
  void take_extents(const std::vector<BodyMotion>& bodies);

  const std::vector<DesignQuantity>& quantities_;
  std::vector<const DesignTask::PointPath*> paths_;
  std::vector<const DesignTask::Transmission*> transmissions_;
  const Mechanism& mechanism_;
  const Plan& plan_;
  DesignRows& rows_;
  std::vector<std::size_t> modes_;  // for each group: its index among those with two modes
  double not_good_ = 0;
};

}  // namespace higherpair
