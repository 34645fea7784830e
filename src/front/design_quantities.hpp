#pragma once

#include "higherpair/front/measure.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/design_task.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// One number about a candidate that an objective or constraint is about, apart from paths and transmission
/// angles: one of the five.
struct DesignQuantity {
  std::optional<std::size_t> measure;        ///< of DesignSetup::measures
  std::optional<DesignTask::Figure> figure;  ///< of check()
  std::optional<DesignTask::Extent> extent;
  std::optional<DesignTask::Grashof> grashof;  ///< by how much a four-bar is of a class
  std::vector<EventType> without;              ///< how many of these events happen
  std::string unit;                            ///< of tables
};

/// Those of the objectives, then those of the constraints, in their order; a column that follows values has
/// one for each. Their units are not known yet.
[[nodiscard]] std::vector<DesignQuantity> quantities_of(const DesignTask& task);
/// Their measures.
[[nodiscard]] std::vector<Measure> measures_of(const DesignTask& task);

/// By how much the four-bar of the mechanism that is meant is of the class [m]: the least by which one of the
/// inequalities between its lengths holds. None where it is not one.
[[nodiscard]] std::optional<double> grashof_room(const Mechanism& mechanism,
                                                 const DesignTask::Grashof& grashof);

/// The figures of a model, each as quantities want it; NaN where there is none or it is without bounds.
[[nodiscard]] std::vector<double> figures_of(const Model& model,
                                             const std::vector<DesignQuantity>& quantities);

/// Sets the units of quantities; says what the model has no figure or four-bar of. \param table  columns of a
/// run of the start, if it starts
[[nodiscard]] Diagnostics complete_quantities(const Model& model, const DesignTask& task,
                                              const std::vector<Measure>& measures,
                                              const std::vector<Column>& table,
                                              std::vector<DesignQuantity>& quantities);

}  // namespace higherpair
