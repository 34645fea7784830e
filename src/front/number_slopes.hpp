#pragma once

#include "higherpair/analysis/sensitivity.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/front/sensitivity.hpp"
#include "path_columns.hpp"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// A number of a profile, and what it measures.
struct ProfileNumber {
  SensitivityNumber number;
  Dimension dimension;
};

/// Models that differ in one number. One thread at a time.
class NumberModels {
public:
  /// \param size  of the mechanism [m]
  [[nodiscard]] static Result<NumberModels> of(const Model& model, const ProfileNumber& number, double size);

  /// With the number changed by h, in its unit.
  [[nodiscard]] Result<Model> at(double h);
  [[nodiscard]] const Model& nominal() const { return model_; }
  /// A change of the number that matters as much as that of other ones by theirs: the mechanism's size, a
  /// radian, the number itself.
  [[nodiscard]] double scale() const { return scale_; }

private:
  NumberModels(Model model, ModelVariants variants, std::size_t paths, double value, double scale)
      : model_(std::move(model)),
        variants_(std::move(variants)),
        paths_(paths),
        value_(value),
        scale_(scale) {}

  Model model_;
  ModelVariants variants_;
  std::size_t paths_;
  double value_;
  double scale_;
};

/// Why no column of a mechanism can be differentiated exactly; empty: those of has_exact_slope can.
[[nodiscard]] std::string exactness_objection(const Mechanism& mechanism);
/// Arcs count from the first row: they are not functions of one row alone.
[[nodiscard]] bool has_exact_slope(const Column& column);

/// Derivatives of columns by one number.
class NumberSlopes {
public:
  /// \param columns  of the model without the change; to outlive this
  NumberSlopes(const PathColumns& columns, NumberModels& models);

  enum class State {
    kExact,
    kNoInfluence,  ///< nothing changes with the number
    kOther,        ///< it changes what is not differentiated, or not smoothly: left to differences
    kRows,         ///< it changes how many rows there are
  };
  [[nodiscard]] State state() const { return state_; }

  /// Of all columns where a run of the model has moved to; none where that has no rates. \pre kExact
  [[nodiscard]] std::optional<std::vector<double>> at(const Run& run, const PathPlace& place) const;

private:
  // Of the drivers and the time at a place, by the number.
  struct DriverSlopes {
    std::vector<DriverState> drivers;
    double time = 0;
  };
  [[nodiscard]] DriverSlopes drivers_at(const PathPlace& place) const;
  [[nodiscard]] bool find_drivers(NumberModels& models);
  [[nodiscard]] bool drivers_change() const;

  const PathColumns& columns_;
  State state_ = State::kOther;
  double step_ = 0;                    // of the number
  std::vector<DriverPlaces> drivers_;  // with the number changed by -4 … 4 steps
  std::optional<Sensitivity> by_;
};

}  // namespace higherpair
