#pragma once

#include "higherpair/front/measure.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/design_task.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// One number of a candidate to which an objective or constraint refers, other than paths and transmission
/// angles: exactly one of the first five members is set. One number, or several of a column that is followed.
struct DesignQuantity {
  std::optional<std::size_t> measure;        ///< index in DesignSetup::measures
  std::optional<DesignTask::Figure> figure;  ///< as in the report of check()
  std::optional<DesignTask::Extent> extent;
  std::optional<DesignTask::Grashof> grashof;  ///< the margin by which a four-bar is of a class
  std::vector<EventType> without;              ///< the number of such events
  std::vector<double>
      at;                 ///< not empty: the column of `measure` is followed at these positions of the driver
  std::size_t first = 0;  ///< index of its first number in DesignRows::measured
  std::string unit;       ///< as in tables
  Place place;            ///< of the objective or constraint
  std::string path_of_key;  ///< and its path in the profile
};

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
