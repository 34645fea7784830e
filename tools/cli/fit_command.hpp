#pragma once

#include "higherpair/front/fit.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

struct FitCommandOptions {
  std::string input;     ///< the profile; with `curve` the points
  std::string measured;  ///< empty: none
  std::optional<std::string> output;
  std::optional<std::string> json;
  std::optional<std::string> csv;    ///< residuals
  std::optional<std::string> curve;  ///< type of curve that is fitted to points
  std::optional<std::string> loss;
  std::optional<double> confidence;
  std::vector<std::string> columns;
  std::vector<std::string> offsets;
  std::optional<int> starts;
  std::optional<std::uint64_t> seed;
  int threads = 0;
  bool quiet = false;
};

/// Adds the command `fit` and its options.
CLI::App* add_fit_command(CLI::App& app, FitCommandOptions& options);

/// Fits the profile's variables to measured motion, or a curve to measured points; returns the exit code: 4
/// if the fit is not good (FitReport::good), 130 if it was interrupted; the results are written all the same.
[[nodiscard]] int fit_command(const FitCommandOptions& options);

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
