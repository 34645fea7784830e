#pragma once

#include "higherpair/front/sensitivity.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair::cli {

/// The results of `sensitivity`.
struct SensitivityFindings {
  SensitivityReport report;
  const ToleranceTask* task = nullptr;  ///< from the profile; null: no bands
  std::vector<ToleranceBand> bands;     ///< one for each result, if there is a task
  std::optional<ToleranceVariants> variants;
  std::size_t top = 10;  ///< how many numbers are printed for each result
};

/// The change of a result in per cent per one per cent of the number; none if either is 0.
[[nodiscard]] std::optional<double> relative_slope(const ResultSensitivity& result, std::size_t number,
                                                   const SensitivityReport& report);

/// The results as tables with at most 80 characters per line, as CSV, and as JSON.
[[nodiscard]] std::string sensitivity_text(const SensitivityFindings& findings);
[[nodiscard]] std::string sensitivity_csv(const SensitivityFindings& findings);
[[nodiscard]] std::string sensitivity_json(const SensitivityFindings& findings);

}  // namespace higherpair::cli
