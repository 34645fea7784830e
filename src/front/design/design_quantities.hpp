#pragma once

#include "higherpair/front/measure.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/design_task.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace higherpair {

/// A column of the table as one number, or followed.
struct ColumnQuantity {
  std::size_t measure = 0;  ///< index in DesignSetup::measures
  std::vector<double> at;   ///< not empty: its numbers are those at these positions of the driver
};

/// What an objective or constraint refers to, other than paths and transmission angles: one number of a
/// candidate, or several of a column that is followed.
struct DesignQuantity {
  std::variant<ColumnQuantity, DesignTask::Figure, DesignTask::Extent, DesignTask::Grashof,
               DesignTask::Events>
      of;
  std::size_t first = 0;    ///< index of its first number in DesignRows::measured
  std::string unit;         ///< as in tables
  Place place;              ///< of the objective or constraint
  std::string path_of_key;  ///< and its path in the profile
  /// The sign of a figure that `check` gives by size counts: it has a target, or a limit below 0.
  bool with_sign = false;

  /// Null where it is of another kind.
  template <class Kind>
  [[nodiscard]] const Kind* as() const {
    return std::get_if<Kind>(&of);
  }
};

/// Whether one of them is of a kind.
template <class Kind>
[[nodiscard]] bool has_any(const std::vector<DesignQuantity>& quantities) {
  return std::any_of(quantities.begin(), quantities.end(),
                     [](const DesignQuantity& quantity) { return quantity.as<Kind>() != nullptr; });
}

struct DesignQuantities {
  std::vector<DesignQuantity> all;
  std::vector<Measure> measures;
  std::size_t numbers = 0;  ///< of all quantities

  /// The measures, and one for every further position at which a column is followed.
  [[nodiscard]] std::vector<Measure> measures_at_all_places() const;
};

/// The quantities of the objectives, then those of the constraints, in their order. Units are not set yet.
[[nodiscard]] DesignQuantities quantities_of(const DesignTask& task);

/// The margin by which the four-bar meant in the mechanism is of the class [m]: the least margin of the
/// inequalities between its lengths. None where there is no such four-bar, or several.
[[nodiscard]] std::optional<double> grashof_room(const Mechanism& mechanism,
                                                 const DesignTask::Grashof& grashof);

/// The figures of a model, one for each quantity; NaN where there is none or it is unbounded.
[[nodiscard]] std::vector<double> figures_of(const Model& model,
                                             const std::vector<DesignQuantity>& quantities);

/// Sets the units of quantities; returns a diagnostic for each figure or four-bar that the model does not
/// have. \param table  columns of a run of the start, if it can be started
[[nodiscard]] Diagnostics complete_quantities(const Model& model, const std::vector<Measure>& measures,
                                              const std::vector<Column>& table,
                                              std::vector<DesignQuantity>& quantities);

}  // namespace higherpair
