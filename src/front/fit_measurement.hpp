#pragma once

#include "fit_motion.hpp"

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// The place in a vector of Eigen.
[[nodiscard]] inline Eigen::Index place(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

/// The numbers that a fit looks for: the variables of the profile, then what is not known of the measurement.
struct FitUnknown {
  enum class Kind { kVariable, kWhere, kOffset, kPlaceX, kPlaceY, kTurn, kScale };
  Kind kind = Kind::kVariable;
  std::size_t index = 0;  ///< of DesignTask::variables, FitData::where, columns or frames
  std::string name;
  std::string unit;
};

/// How a motion shows in what was measured:
///     measured = t + s R(φ) (x, y)   of a point in a frame of its own,
///     measured = value + offset      of a column whose zero is not known.
/// x are the values of all unknowns, in their order.
class FitMeasurement {
public:
  /// \param data  outlives this
  explicit FitMeasurement(const FitData& data);

  /// The variables of the profile, unknown zeros of drivers or of time, then those of columns and frames.
  [[nodiscard]] const std::vector<FitUnknown>& unknowns() const { return unknowns_; }
  [[nodiscard]] std::vector<double> variables_in(const Eigen::VectorXd& x) const;
  /// One for each of FitData::where; 0 where it is known.
  [[nodiscard]] std::vector<double> offsets_in(const Eigen::VectorXd& x) const;

  /// Makes of a motion what is measured of it.
  void show(const Eigen::VectorXd& x, FitTable& table) const;
  /// The same of a change of the motion: frames turn and scale it, places and offsets have no part in it.
  [[nodiscard]] FitTable change_shown(const Eigen::VectorXd& x, FitTable change) const;
  /// Derivative of what is shown by an unknown that the motion does not depend on. \param table  the motion
  [[nodiscard]] FitTable derivative(const Eigen::VectorXd& x, const FitTable& table,
                                    const FitUnknown& unknown) const;

  /// Sets frames and offsets in x so that the motion shows nearest to what was measured.
  void place_nearest(const FitTable& table, Eigen::VectorXd& x) const;

private:
  void add(FitUnknown::Kind kind, std::size_t index, std::string name, std::string unit);
  [[nodiscard]] std::optional<double> at(const Eigen::VectorXd& x, FitUnknown::Kind kind,
                                         std::size_t index) const;
  void place_frames(const FitTable& table, Eigen::VectorXd& x) const;
  void place_offsets(const FitTable& table, Eigen::VectorXd& x) const;

  const FitData& data_;
  std::vector<FitUnknown> unknowns_;
};

}  // namespace higherpair
