#pragma once

#include "number_slopes.hpp"

#include <vector>

namespace higherpair {

/// The numbers by which the results of a report are differentiated: see SensitivitySettings::by.
[[nodiscard]] Result<std::vector<ProfileNumber>> numbers_for(const Model& model,
                                                             const std::vector<std::string>& by);

struct WantedResults {
  std::vector<NamedMeasure> results;
  bool in_time = false;  ///< from the settings, or from the table of the profile that names the results
};

/// The results to be differentiated: see SensitivitySettings::results.
[[nodiscard]] WantedResults results_for(const Model& model, const SensitivitySettings& settings);

}  // namespace higherpair
