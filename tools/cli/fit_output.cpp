// The results of a fit, for people and for programs.
#include "fit_report.hpp"
#include "higherpair/front/motion.hpp"
#include "json_text.hpp"
#include "number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostOutliers = 10;  // largest number listed

std::string number_text(const FitReport::Number& number, int width, bool with_before) {
  return fmt::format("{:<{}}  {:>14}  {:>16}  {:>12}  {}{}{}\n", number.name, width,
                     with_before ? shown(number.before) : "", shown(number.after),
                     std::isfinite(number.half) ? "+-" + shown(number.half, 3) : "-", number.unit,
                     number.at_bound ? "  at its bound" : "", number.determined ? "" : "  not determined");
}

std::string numbers_text(const FitReport& report) {
  const int width = std::max(widest("variable", report.variables, &FitReport::Number::name),
                             widest("", report.measurement, &FitReport::Number::name));
  std::string text = fmt::format("{:<{}}  {:>14}  {:>16}  {:>12}\n", "variable", width, "before", "after",
                                 fmt::format("{:g} %", 100 * report.confidence));
  for (const auto& variable : report.variables) text += number_text(variable, width, true);
  for (const auto& own : report.measurement) text += number_text(own, width, false);
  return text;
}

std::string columns_text(const FitReport& report) {
  const int width = widest("column", report.columns, &FitReport::Column::name);
  std::string text = fmt::format("\n{:<{}}  {:>6}  {:>10}  {:>10}  {:>10} {:>14}  {:>8}  {:>8}\n", "column",
                                 width, "values", "rms", "noise", "largest", "at", "R2", "outliers");
  for (const auto& column : report.columns) {
    text += fmt::format("{:<{}}  {:>6}  {:>10}  {:>10}  {:>10} {:>14}  {:>8}  {:>8}  {}\n", column.name,
                        width, column.values, shown(column.rms, 3), shown(column.noise, 3),
                        shown(column.largest, 3), shown(column.largest_at),
                        std::isfinite(column.explained) ? fmt::format("{:.6f}", column.explained) : "-",
                        column.outliers, column.unit);
  }
  return text;
}

std::string outliers_text(const FitReport& report) {
  std::string text;
  std::size_t count = 0;
  for (const auto& residual : report.residuals) {
    if (!residual.outlier || ++count > kMostOutliers) continue;
    const auto& column = report.columns[residual.column];
    text += fmt::format("  line {}: {} = {}, fitted {}\n", residual.line, column.name,
                        shown(residual.measured), shown(residual.fitted));
  }
  if (count == 0) return "";
  if (count > kMostOutliers) text += fmt::format("  … and {} more\n", count - kMostOutliers);
  return fmt::format("\noutliers, more than {} deviations off:\n{}", kOutlierDeviations, text);
}

std::string_view end_text(FitEnd end) {
  static constexpr std::array kNames = {"converged", "not converged", "stopped"};
  static_assert(kNames.size() == static_cast<std::size_t>(FitEnd::kStopped) + 1);
  return kNames[static_cast<std::size_t>(end)];
}

std::string judgement(const FitReport& report) {
  std::string text;
  if (report.end == FitEnd::kNotConverged) {
    text += "the fit did not converge: these numbers are the best so far\n";
  }
  if (report.missing > 0) {
    text +=
        fmt::format("{} measured values are where the fitted mechanism does not come to\n", report.missing);
  }
  if (report.too_large) {
    text += fmt::format(
        "the residuals are {:.3g} times the deviations given (chance {:.1g}): the model or the "
        "deviations are wrong\n",
        report.noise_ratio, report.chance);
  }
  for (const FitReport::Column& column : report.columns) {
    if (column.unexplained) {
      text += fmt::format(
          "{}: the values are farther from the fitted motion than from their own mean: look at their "
          "unit, the branch and the bounds\n",
          column.name);
    }
  }
  for (const std::string& sentence : report.undetermined) text += sentence + "\n";
  return text;
}

}  // namespace

std::string fit_text(const FitReport& report) {
  std::string text = report.title.empty() ? "" : report.title + "\n\n";
  text += numbers_text(report) + columns_text(report) + outliers_text(report);
  text += fmt::format("\n{} values, {} degrees of freedom, loss {}, {} derivatives, {} iterations",
                      report.residuals.size(), report.freedoms, name_of(report.loss),
                      report.exact ? "exact" : "numerical", report.iterations);
  if (report.starts > 1)
    text += fmt::format("; {} starts, {} different ends", report.starts, report.different);
  text += "\n";
  for (const std::string& note : report.notes) text += "note: " + note + "\n";
  const std::string judged = judgement(report);
  return judged.empty() ? text : text + "\n" + judged;
}

namespace {

Json numbers_json(const std::vector<FitReport::Number>& numbers) {
  Json list = Json::array();
  for (const auto& one : numbers) {
    list.push_back({{"name", one.name},
                    {"paths", one.paths},
                    {"unit", one.unit},
                    {"before", number_or_null(one.before)},
                    {"after", number_or_null(one.after)},
                    {"standard_error", number_or_null(one.error)},
                    {"half_interval", number_or_null(one.half)},
                    {"min", number_or_null(one.low)},
                    {"max", number_or_null(one.high)},
                    {"at_bound", one.at_bound},
                    {"determined", one.determined}});
  }
  return list;
}

Json columns_json(const FitReport& report) {
  Json list = Json::array();
  for (const auto& column : report.columns) {
    list.push_back({{"name", column.name},
                    {"unit", column.unit},
                    {"values", column.values},
                    {"outliers", column.outliers},
                    {"rms", number_or_null(column.rms)},
                    {"noise", number_or_null(column.noise)},
                    {"deviation", number_or_null(column.deviation)},
                    {"largest", number_or_null(column.largest)},
                    {"largest_at", number_or_null(column.largest_at)},
                    {"r_squared", number_or_null(column.explained)},
                    {"autocorrelation", number_or_null(column.succession)},
                    {"systematic", column.systematic}});
  }
  return list;
}

}  // namespace

std::string fit_json(const FitReport& report) {
  Json json;
  json["title"] = report.title;
  json["good"] = report.good;
  json["end"] = end_text(report.end);
  json["variables"] = numbers_json(report.variables);
  json["measurement"] = numbers_json(report.measurement);
  json["columns"] = columns_json(report);
  json["outliers"] = Json::array();
  for (const auto& residual : report.residuals) {
    if (!residual.outlier) continue;
    json["outliers"].push_back({{"line", residual.line},
                                {"column", report.columns[residual.column].name},
                                {"measured", residual.measured},
                                {"fitted", residual.fitted}});
  }
  json["undetermined"] = report.undetermined;
  json["notes"] = report.notes;
  json["correlation"] = Json::array();
  for (Eigen::Index i = 0; i < report.correlation.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index k = 0; k < report.correlation.cols(); ++k)
      row.push_back(number_or_null(report.correlation(i, k)));
    json["correlation"].push_back(std::move(row));
  }
  json["confidence"] = report.confidence;
  json["freedoms"] = report.freedoms;
  json["noise_ratio"] = number_or_null(report.noise_ratio);
  json["chance"] = number_or_null(report.chance);
  json["missing"] = report.missing;
  json["search"] = {{"loss", name_of(report.loss)},
                    {"starts", report.starts},
                    {"different", report.different},
                    {"iterations", report.iterations},
                    {"derivatives", report.exact ? "exact" : "numerical"}};
  return document_of(json);
}

std::string fit_csv(const FitReport& report) {
  std::string text =
      fmt::format("line[1],{},column,unit,measured[1],fitted[1],residual[1],weight[1],outlier[1]\n",
                  csv_head({report.in_time ? "time" : "driver", report.where_unit, {}}));
  for (const auto& residual : report.residuals) {
    const auto& column = report.columns[residual.column];
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", residual.line, cell(residual.where), column.name,
                        column.unit, cell(residual.measured), cell(residual.fitted),
                        cell(residual.measured - residual.fitted), cell(residual.weight),
                        residual.outlier ? 1 : 0);
  }
  return text;
}

std::string fit_text(const CurveFitReport& report) {
  const int width = std::max(8, widest(report.type, report.numbers, &CurveFitReport::Number::name));
  std::string text = fmt::format("{:<{}}  {:>16}  {:>12}\n", report.type, width, "value",
                                 fmt::format("{:g} %", 100 * report.confidence));
  for (const auto& own : report.numbers) {
    text += fmt::format("{:<{}}  {:>16}  {:>12}  {}\n", own.name, width, shown(own.value),
                        std::isfinite(own.half) ? "+-" + shown(own.half, 3) : "-", own.unit);
  }
  return text + fmt::format("\n{} points, rms distance {} {}, noise {} {}, largest {} {} (line {})\n",
                            report.points.size(), shown(report.rms, 3), report.unit, shown(report.noise, 3),
                            report.unit, shown(report.largest, 3), report.unit, report.largest_line);
}

std::string fit_json(const CurveFitReport& report) {
  Json json;
  json["type"] = report.type;
  json["unit"] = report.unit;
  json["numbers"] = Json::array();
  for (const auto& own : report.numbers) {
    json["numbers"].push_back({{"name", own.name},
                               {"unit", own.unit},
                               {"value", own.value},
                               {"standard_error", number_or_null(own.error)},
                               {"half_interval", number_or_null(own.half)}});
  }
  json["points"] = report.points.size();
  json["rms"] = number_or_null(report.rms);
  json["noise"] = number_or_null(report.noise);
  json["largest"] = {{"distance", number_or_null(report.largest)}, {"line", report.largest_line}};
  json["confidence"] = report.confidence;
  return document_of(json);
}

std::string fit_csv(const CurveFitReport& report) {
  std::string text = fmt::format("line[1],{},{},{}\n", csv_head({"x", report.unit, {}}),
                                 csv_head({"y", report.unit, {}}), csv_head({"distance", report.unit, {}}));
  for (const auto& point : report.points) {
    text += fmt::format("{},{},{},{}\n", point.line, cell(point.x), cell(point.y), cell(point.distance));
  }
  return text;
}

}  // namespace higherpair::cli
