#pragma once

#include "front/columns/path_columns.hpp"
#include "higherpair/analysis/displaced.hpp"
#include "higherpair/analysis/sensitivity.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/front/sensitivity.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// A number of a profile, with its dimension.
struct ProfileNumber {
  SensitivityNumber number;
  Dimension dimension;
};

/// What numbers are compared with that are zero, or nearly so.
struct NaturalScales {
  double size = 0;  ///< of the mechanism [m]
  double rate = 0;  ///< largest of the drivers: velocity, and root of acceleration; of slides relative to the
                    ///< size [1/s]
};
[[nodiscard]] NaturalScales natural_scales(const PathColumns& columns);

/// Models that differ in one number. For use by one thread at a time.
class NumberModels {
public:
  [[nodiscard]] static Result<NumberModels> of(const Model& model, const ProfileNumber& number,
                                               const NaturalScales& natural);

  /// The model with the number changed by h, in its unit.
  [[nodiscard]] Result<Model> at(double h);
  /// SensitivityNumber::scale.
  [[nodiscard]] double scale() const { return scale_; }

private:
  NumberModels(ModelVariants variants, std::size_t paths, double value, double scale)
      : variants_(std::move(variants)), paths_(paths), value_(value), scale_(scale) {}

  ModelVariants variants_;
  std::size_t paths_;
  double value_;
  double scale_;
};

/// The models of each number.
[[nodiscard]] Result<std::vector<std::unique_ptr<NumberModels>>> models_by(
    const Model& model, const std::vector<ProfileNumber>& numbers, const NaturalScales& natural);

/// False for arcs: they count from the first row, and are not functions of one row alone.
[[nodiscard]] bool has_exact_slope(const Column& column);

/// Derivatives of all columns by one number.
class NumberSlopes {
public:
  /// \param columns  of the unchanged model; must outlive this
  NumberSlopes(const PathColumns& columns, NumberModels& models);

  enum class State {
    kExact,
    kNoInfluence,  ///< nothing changes with the number
    kOther,        ///< it changes something not differentiable: left to differences
    kRows,         ///< it changes the number of rows
  };
  [[nodiscard]] State state() const { return state_; }

  /// Derivatives of all columns at the place to which a run of the model has moved.
  /// \param rates  rates_to_ask() there, which every number has in common \pre kExact
  [[nodiscard]] tl::expected<std::vector<SidedSlope>, NoSensitivity> at(
      const Run& run, const PathPlace& place, RatesAsked rates = RatesAsked::kAll) const;

private:
  // Derivatives of the drivers and the time at a place by the number.
  struct DriverSlopes {
    std::vector<DriverState> drivers;
    double time = 0;
  };
  [[nodiscard]] DriverSlopes drivers_at(const PathPlace& place) const;
  [[nodiscard]] bool find_drivers(NumberModels& models);
  [[nodiscard]] bool drivers_change() const;

  const PathColumns& columns_;
  State state_ = State::kOther;
  double step_ = 0;                    // step of the number
  std::vector<DriverPlaces> drivers_;  // with the number changed by -4 … 4 steps
  std::optional<Sensitivity> by_;
};

/// kRegular where no change point is met.
[[nodiscard]] RatesAsked rates_to_ask(const PathColumns& columns, const Run& run, const PathPlace& place);

}  // namespace higherpair
