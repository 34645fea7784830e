#pragma once

#include "higherpair/front/fit.hpp"

#include <string>

namespace higherpair::cli {

/// \name The results as readable text and JSON, and the residuals as CSV
/// @{
[[nodiscard]] std::string fit_text(const FitReport& report);
[[nodiscard]] std::string fit_json(const FitReport& report);
[[nodiscard]] std::string fit_csv(const FitReport& report);
[[nodiscard]] std::string fit_text(const CurveFitReport& report);
[[nodiscard]] std::string fit_json(const CurveFitReport& report);
[[nodiscard]] std::string fit_csv(const CurveFitReport& report);
/// @}

}  // namespace higherpair::cli
