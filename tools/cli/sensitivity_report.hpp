#pragma once

#include "higherpair/front/sensitivity.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair::cli {

/// What `sensitivity` has found.
struct SensitivityFindings {
  SensitivityReport report;
  const ToleranceTask* task = nullptr;  ///< of the profile; null: no bands
  std::vector<ToleranceBand> bands;     ///< of the results, with a task
  std::optional<ToleranceVariants> variants;
  std::size_t top = 10;  ///< so many numbers of a result are printed
};

/// "deg/mm": of a result by a number.
[[nodiscard]] std::string unit_per(const std::string& result, const std::string& number);

/// The change of a result in per cent for one per cent of the number; none where either is 0.
[[nodiscard]] std::optional<double> relative_slope(const ResultSensitivity& result, std::size_t number,
                                                   const SensitivityReport& report);

/// The findings as tables of at most 80 characters a line, as CSV, and as JSON.
[[nodiscard]] std::string sensitivity_text(const SensitivityFindings& findings);
[[nodiscard]] std::string sensitivity_csv(const SensitivityFindings& findings);
[[nodiscard]] std::string sensitivity_json(const SensitivityFindings& findings);

}  // namespace higherpair::cli
