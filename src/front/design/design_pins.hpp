#pragma once

#include "design_rows.hpp"
#include "higherpair/analysis/pin_linkage.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// Computes candidates of a linkage of pins. What is the same for all of them is computed once, so that a row
/// costs little more than its dyads; also gives exact derivatives of the rows by the variables.
class PinnedRows {
public:
  /// None where the mechanism is not such a linkage, or its numbers are not linear in the variables. \param
  /// setup  must outlive this
  [[nodiscard]] static std::optional<PinnedRows> of(const DesignSetup& setup);

  /// Computes the rows of the candidate x on a branch, without rates and measures.
  void work_out(std::span<const double> x, int branch, DesignRows& rows);

  /// \name Derivatives of the last candidate, one column for each variable
  /// @{
  void add_gap_slopes(std::size_t gap, double factor, Eigen::MatrixXd& J, Eigen::Index row);
  void add_transmission_slopes(std::size_t transmission, double factor, Eigen::MatrixXd& J, Eigen::Index row);
  /// Derivatives of DesignRows::points in a row.
  [[nodiscard]] const Eigen::Matrix2Xd& point_slopes(const PointRef& point, std::size_t row);
  /// Derivatives of the point at this position of the only driver.
  [[nodiscard]] const Eigen::Matrix2Xd& point_slopes_at(const PointRef& point, double driver);
  /// @}

private:
  // A position of the drivers: a row, or a place between two rows where only the closure of dyads is checked.
  struct Place {
    std::optional<std::size_t> row;
    bool even = false;  // the step to this place equals the step before it
  };
  // Where the gap of a dyad is largest.
  struct Largest {
    double gap = 0;
    std::size_t place = 0;
    bool vertex = false;  // at the vertex of the parabola through the place and the two before it
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
  std::vector<double> positions_;           // of the first driver in each row
  std::vector<Rotation<double>> turns_;     // rotation of each driver at each place
  std::vector<PointRef> points_;            // of the paths
  std::vector<std::size_t> transmissions_;  // for each transmission constraint: its dyad
  std::vector<double> numbers_;
  int branch_ = 0;
  std::array<std::vector<double>, 2> before_;  // gaps at the two preceding places; NaN: not known
  std::vector<Largest> largest_;               // for each dyad
  std::vector<std::optional<std::size_t>> last_assembled_;  // for each row: last place assembled up to it
  std::vector<std::size_t> least_transmission_;             // for each transmission constraint: the place
  Eigen::Matrix2Xd point_slopes_;
};

}  // namespace higherpair
