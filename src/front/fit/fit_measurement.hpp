#pragma once

#include "fit_motion.hpp"
#include "numeric/eigen_index.hpp"

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// An unknown of a fit: first the variables of the profile, then the unknowns of the measurement.
struct FitUnknown {
  enum class Kind { kVariable, kWhere, kOffset, kPlaceX, kPlaceY, kTurn, kScale };
  Kind kind = Kind::kVariable;
  std::size_t index = 0;  ///< in DesignTask::variables, FitData::where, columns or frames
  std::string name;
  std::string unit;
};

/// How a motion appears in the measured data:
///     measured = t + s R(φ) (x, y)   for a point in a frame of its own,
///     measured = value + offset      for a column whose zero is not known.
/// x denotes the values of all unknowns, in their order.
class FitMeasurement {
public:
  /// \param data  must outlive this
  explicit FitMeasurement(const FitData& data);

  /// The variables of the profile, unknown zeros of drivers or of time, then those of columns and frames.
  [[nodiscard]] const std::vector<FitUnknown>& unknowns() const { return unknowns_; }
  [[nodiscard]] std::vector<double> variables_in(const Eigen::VectorXd& x) const;
  /// One for each of FitData::where; 0 where its zero is known.
  [[nodiscard]] std::vector<double> offsets_in(const Eigen::VectorXd& x) const;

  /// Converts a motion to what is measured of it, in place.
  void show(const Eigen::VectorXd& x, FitTable& table) const;
  /// The same for a change of the motion: frames turn and scale it; positions of frames and offsets have no
  /// effect.
  [[nodiscard]] FitTable change_shown(const Eigen::VectorXd& x, FitTable change) const;
  /// Derivative of the measured values by an unknown that does not affect the motion. \param table  the
  /// motion
  [[nodiscard]] FitTable derivative(const Eigen::VectorXd& x, const FitTable& table,
                                    const FitUnknown& unknown) const;

  /// Sets frames and offsets in x so that the motion is nearest to the measured data.
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
