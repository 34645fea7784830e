// The results of `sensitivity` for programs.
#include "json_text.hpp"
#include "number_text.hpp"
#include "sensitivity_report.hpp"

#include <array>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kKinds = {"exact", "differences", "kink", "none"};

Json slope_json(const SensitivityFindings& findings, std::size_t m, std::size_t i) {
  const ResultSensitivity& result = findings.report.results[m];
  const Slope& slope = result.slopes[i];
  Json json = {{"number", findings.report.numbers[i].name},
               {"unit", unit_per(result.unit, findings.report.numbers[i].unit)},
               {"kind", kKinds[static_cast<std::size_t>(slope.kind)]},
               {"down", number_or_null(slope.down)},
               {"up", number_or_null(slope.up)},
               {"relative", number_or_null(relative_slope(result, i, findings.report))}};
  if (slope.kind == SlopeKind::kDifferences) json["error"] = slope.error;
  if (!slope.remark.empty()) json["remark"] = slope.remark;
  if (findings.task != nullptr) json["share"] = findings.bands[m].shares[i];
  return json;
}

Json band_json(const SensitivityFindings& findings, std::size_t m) {
  const ToleranceBand& band = findings.bands[m];
  Json json = {{"center", number_or_null(band.center)},
               {"worst_case", {number_or_null(band.worst_low), number_or_null(band.worst_high)}},
               {"deviation", number_or_null(band.deviation)},
               {"statistical", {number_or_null(band.low), number_or_null(band.high)}},
               {"complete", band.complete}};
  if (band.within) {
    json["within"] = *band.within;
    json["kept"] = band.kept;
    json["worst_case_kept"] = band.worst_kept;
    if (!band.kept && !std::isnan(band.center)) {
      json["tighten"] = {{"number", findings.task->tolerances[band.order.front()].name},
                         {"factor", number_or_null(band.tighten)},
                         {"factor_of_all", number_or_null(band.tighten_all)}};
    }
  }
  return json;
}

Json variants_json(const VariantBand& seen) {
  if (seen.variants == 0) {
    return {{"variants", 0}};
  }
  return {{"variants", seen.variants},
          {"band", {seen.low, seen.high}},
          {"median", seen.median},
          {"mean", seen.mean},
          {"deviation", seen.deviation},
          {"linear_band", {seen.linear_low, seen.linear_high}},
          {"linear_median", seen.linear_median},
          {"farthest_from_linear", seen.farthest},
          {"share_within", seen.share_within},
          {"curved", seen.curved}};
}

}  // namespace

std::string sensitivity_csv(const SensitivityFindings& findings) {
  const SensitivityReport& report = findings.report;
  std::string text = fmt::format(
      "result,column,of,value,unit,at[{}],number,number_value,number_unit,down,up,kind,relative,share\n",
      report.where_unit);
  for (std::size_t m = 0; m < report.results.size(); ++m) {
    const ResultSensitivity& result = report.results[m];
    for (std::size_t i = 0; i < report.numbers.size(); ++i) {
      const SensitivityNumber& number = report.numbers[i];
      const Slope& slope = result.slopes[i];
      text +=
          fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", result.name, result.measure.column,
                      name_of(result.measure.of), cell(result.value), result.unit, cell(result.where),
                      number.name, cell(number.value), number.unit, cell(slope.down), cell(slope.up),
                      kKinds[static_cast<std::size_t>(slope.kind)], cell(relative_slope(result, i, report)),
                      findings.task != nullptr ? cell(findings.bands[m].shares[i]) : "");
    }
  }
  return text;
}

std::string sensitivity_json(const SensitivityFindings& findings) {
  const SensitivityReport& report = findings.report;
  Json json = {{"title", report.title}, {"good", report.good}, {"where_unit", report.where_unit}};
  json["numbers"] = Json::array();
  for (std::size_t i = 0; i < report.numbers.size(); ++i) {
    const SensitivityNumber& number = report.numbers[i];
    Json one = {
        {"name", number.name}, {"paths", number.paths}, {"value", number.value}, {"unit", number.unit}};
    if (findings.task != nullptr) {
      one["plus"] = findings.task->tolerances[i].plus;
      one["minus"] = findings.task->tolerances[i].minus;
      one["deviation"] = findings.task->tolerances[i].deviation();
    }
    json["numbers"].push_back(std::move(one));
  }
  json["results"] = Json::array();
  for (std::size_t m = 0; m < report.results.size(); ++m) {
    const ResultSensitivity& result = report.results[m];
    Json one = {{"name", result.name},
                {"column", result.measure.column},
                {"of", name_of(result.measure.of)},
                {"value", number_or_null(result.value)},
                {"unit", result.unit},
                {"where", number_or_null(result.where)},
                {"rival", number_or_null(result.rival)},
                {"rival_where", number_or_null(result.rival_where)},
                {"remark", result.remark}};
    one["slopes"] = Json::array();
    for (std::size_t i = 0; i < report.numbers.size(); ++i)
      one["slopes"].push_back(slope_json(findings, m, i));
    if (findings.task != nullptr) one["band"] = band_json(findings, m);
    if (findings.variants) one["variants"] = variants_json(findings.variants->bands[m]);
    json["results"].push_back(std::move(one));
  }
  if (findings.variants) {
    json["variants"] = {{"count", findings.variants->count}, {"good", findings.variants->good}};
  }
  return document_of(json);
}

}  // namespace higherpair::cli
