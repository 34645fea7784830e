#pragma once

#include "design_rows.hpp"
#include "higherpair/analysis/pin_linkage.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// Candidates of a linkage of pins: all that is the same for each of them is worked out once, so that a row
/// costs little more than its dyads; and the exact derivatives of what the rows say by the variables.
class PinnedRows {
public:
  /// None where the mechanism is not such, or its numbers are not linear in the variables. \param setup
  /// outlives this
  [[nodiscard]] static std::optional<PinnedRows> of(const DesignSetup& setup);

  /// Works out the rows of the candidate x on a branch, without rates and measures.
  void work_out(std::span<const double> x, int branch, DesignRows& rows);

  /// \name Of the candidate worked out last, one column for each variable
  /// @{
  void add_gap_slopes(std::size_t gap, double factor, Eigen::MatrixXd& J, Eigen::Index row);
  void add_transmission_slopes(std::size_t transmission, double factor, Eigen::MatrixXd& J, Eigen::Index row);
  /// Of DesignRows::points in a row.
  [[nodiscard]] const Eigen::Matrix2Xd& point_slopes(const PointRef& point, std::size_t row);
  /// Of the point where the only driver is at this position.
  [[nodiscard]] const Eigen::Matrix2Xd& point_slopes_at(const PointRef& point, double driver);
  /// @}

private:
  // A position of the drivers: a row, or between two of them where only the reach of dyads is looked at.
  struct Place {
    std::optional<std::size_t> row;
    bool even = false;  // as far from the place before as that is from the one before it
  };
  // Where the gap of a dyad is largest.
  struct Largest {
    double gap = 0;
    std::size_t place = 0;
    bool vertex = false;  // of the parabola through the place and the two before it
  };

  PinnedRows(const DesignSetup& setup, PinLinkage linkage);
  void add_places(const DesignSetup& setup);
  void note_gaps(std::size_t place);
  void note_transmissions(std::size_t row, DesignRows& rows);
  bool go_to(std::size_t place);
  [[nodiscard]] const Eigen::Matrix2Xd& slopes_here(const PointRef& point);

  const DesignSetup* setup_;
  PinLinkage linkage_;
  std::vector<Place> places_;
  std::vector<std::size_t> place_of_row_;
  std::vector<double> positions_;           // of the first driver in the rows
  std::vector<Rotation<double>> turns_;     // of each driver at each place
  std::vector<PointRef> points_;            // of the paths
  std::vector<std::size_t> transmissions_;  // dyad of each constraint on one
  std::vector<double> numbers_;
  int branch_ = 0;
  std::array<std::vector<double>, 2> before_;      // gaps at the two places before; NaN: not known
  std::vector<Largest> largest_;                   // of each dyad
  std::vector<std::optional<std::size_t>> stood_;  // of each row: the place at which its bodies are
  std::vector<std::size_t> least_transmission_;    // of each constraint on one: the place
  Eigen::Matrix2Xd point_slopes_;
};

}  // namespace higherpair
