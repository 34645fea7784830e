#pragma once

#include "design_rows.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// Takes down what the rows of one candidate say, row by row.
class RowReader {
public:
  RowReader(const DesignSetup& setup, const Mechanism& mechanism, const Plan& plan, DesignRows& rows);

  /// \param there  whether the bodies could be placed
  void take(const std::vector<BodyMotion>& bodies, bool there, double driver, RowStatus status);
  /// \param gaps  of each group of the plan, in the row that was taken last
  void take_gaps(const std::vector<std::optional<double>>& gaps);
  void take_gaps(const std::vector<BodyMotion>& bodies);
  /// \param rows  that the gap of this group depends on; empty: others
  void take_gap(std::size_t group, double gap, const std::vector<WeightedRow>& rows);
  /// \param limits  events on the path that end it
  void finish(int limits);

private:
  void take_transmissions(const std::vector<BodyMotion>& bodies);
  void take_extents(const std::vector<BodyMotion>& bodies);

  const DesignSetup& setup_;
  const Mechanism& mechanism_;
  const Plan& plan_;
  DesignRows& rows_;
  std::vector<std::size_t> modes_;  // of each group: which one of those with two modes
  double not_good_ = 0;
};

}  // namespace higherpair
