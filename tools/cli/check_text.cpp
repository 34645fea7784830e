#include "check_report.hpp"
#include "json_text.hpp"
#include "number_text.hpp"
#include "paragraph.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

// "pressure angle" for "pressure_angle".
std::string words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{:.7g}", *value) : "";
}

std::string line_of(const CheckFigure& figure) {
  const std::string verdict =
      figure.verdict == Verdict::kExceeded ? "EXCEEDED" : std::string(name_of(figure.verdict));
  const std::string value = figure.value                            ? number(figure.value)
                            : figure.verdict == Verdict::kUndecided ? "unknown"
                                                                    : "unbounded";
  std::string line =
      fmt::format("  {:<29} {:>11} {:<9} {:>9} {:>9} {}", words(figure.quantity), value,
                  figure.unit == "1" ? "" : figure.unit, figure.at ? fmt::format("{:.6g}", *figure.at) : "",
                  number(figure.limit), verdict);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string check_text(const CheckReport& report) {
  std::string text = report.title.empty() ? "" : report.title + "\n";
  std::string item, of;
  for (const CheckFigure& figure : report.figures) {
    if (figure.item != item) {
      text += fmt::format("{}{:<31} {:>11} {:<9} {:>9} {:>9}\n", text.empty() ? "" : "\n", figure.item,
                          "value", "", title("at", report.driver_unit), "limit");
      of.clear();
    }
    if (!figure.of.empty() && figure.of != of) {
      text += " " + figure.of + "\n";
    }
    item = figure.item;
    of = figure.of;
    text += line_of(figure);
    if (!figure.remark.empty()) text += paragraph(figure.remark, 6);
  }
  const auto count = [&](Verdict verdict) {
    return std::count_if(report.figures.begin(), report.figures.end(),
                         [&](const CheckFigure& figure) { return figure.verdict == verdict; });
  };
  const auto exceeded = count(Verdict::kExceeded), undecided = count(Verdict::kUndecided);
  const auto limited = exceeded + undecided + count(Verdict::kKept);
  text += limited == 0                ? "\nno limits\n"
          : exceeded + undecided == 0 ? fmt::format("\n{} limits, all kept\n", limited)
                                      : fmt::format("\n{} of {} limits exceeded\n", exceeded, limited);
  if (undecided > 0) text += fmt::format("{} undecided\n", undecided);
  return report.good || exceeded + undecided > 0 ? text : text + "the path is not good\n";
}

std::string check_csv(const CheckReport& report) {
  std::string text = fmt::format("item,of,quantity,value,unit,at[{}],limit,verdict\n", report.driver_unit);
  for (const CheckFigure& figure : report.figures) {
    text +=
        fmt::format("{},{},{},{},{},{},{},{}\n", figure.item, figure.of, figure.quantity, cell(figure.value),
                    figure.unit, cell(figure.at), cell(figure.limit), name_of(figure.verdict));
  }
  return text;
}

std::string check_json(const CheckReport& report) {
  nlohmann::ordered_json json;
  json["title"] = report.title;
  json["good"] = report.good;
  json["driver_unit"] = report.driver_unit;
  json["figures"] = nlohmann::ordered_json::array();
  for (const CheckFigure& figure : report.figures) {
    json["figures"].push_back({{"item", figure.item},
                               {"of", figure.of},
                               {"quantity", figure.quantity},
                               {"value", number_or_null(figure.value)},
                               {"unit", figure.unit},
                               {"at", number_or_null(figure.at)},
                               {"limit", number_or_null(figure.limit)},
                               {"verdict", name_of(figure.verdict)},
                               {"remark", figure.remark}});
  }
  return document_of(json);
}

}  // namespace higherpair::cli
