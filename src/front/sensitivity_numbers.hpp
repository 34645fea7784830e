#pragma once

#include "number_slopes.hpp"

#include <vector>

namespace higherpair {

/// The numbers by which a report differentiates: see SensitivitySettings::by.
[[nodiscard]] Result<std::vector<ProfileNumber>> numbers_for(const Model& model,
                                                             const std::vector<std::string>& by);

struct WantedResults {
  std::vector<NamedMeasure> results;
  bool in_time = false;  ///< as the settings or the table of the profile have it that names them
};

/// The results that it differentiates: see SensitivitySettings::results.
[[nodiscard]] WantedResults results_for(const Model& model, const SensitivitySettings& settings);

}  // namespace higherpair
