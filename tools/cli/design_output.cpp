// The results of a design command, for people and for programs.
#include "design_report.hpp"
#include "json_text.hpp"
#include "number_text.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string_view end_text(DesignEnd end) {
  static constexpr std::array kNames = {"starts", "evaluations", "time", "target", "stopped"};
  static_assert(kNames.size() == static_cast<std::size_t>(DesignEnd::kStopped) + 1);
  return kNames[static_cast<std::size_t>(end)];
}

std::string_view bound_text(const DesignReport::Variable& variable) {
  if (!variable.at_bound) return "";
  return variable.high - variable.after < variable.after - variable.low ? "  at its max" : "  at its min";
}

std::string variables_text(const DesignReport& report) {
  const int width = widest("variable", report.variables, &DesignReport::Variable::name);
  std::string text = fmt::format("{:<{}}  {:>16}  {:>16}  {:>12}  {:>12}\n", "variable", width, "before",
                                 "after", "min", "max");
  for (const auto& variable : report.variables) {
    text += fmt::format("{:<{}}  {:>16}  {:>16}  {:>12}  {:>12}{}\n", variable.name, width,
                        shown(variable.before), shown(variable.after), shown(variable.low),
                        shown(variable.high), bound_text(variable));
  }
  return text;
}

std::string objectives_text(const DesignReport& report) {
  const int width = widest("objective", report.objectives, &DesignReport::Objective::what);
  std::string text =
      fmt::format("\n{:<{}}  {:>16}  {:>16}  {:>12}\n", "objective", width, "before", "after", "target");
  for (const auto& objective : report.objectives) {
    text += fmt::format("{:<{}}  {:>16}  {:>16}  {:>12}  {}\n", objective.what, width,
                        shown(objective.before), shown(objective.after),
                        objective.target ? shown(*objective.target) : "least", objective.unit);
    if (const auto& placed = objective.placement) {
      text += fmt::format("  when turned by {:.9g} {}, scaled by {:.9g}, then moved by {:.9g}, {:.9g} {}\n",
                          placed->turn, objective.angle_unit, placed->scale, placed->x, placed->y,
                          objective.length_unit);
    }
  }
  return text + fmt::format("{:<{}}  {:>16}  {:>16}\n", "altogether", width, shown(report.before),
                            shown(report.after));
}

std::string constraints_text(const DesignReport& report) {
  constexpr std::string_view kAssembles = "assembles all the way";
  const int width = widest(kAssembles, report.constraints, &DesignReport::Constraint::what);
  std::string text = fmt::format("\n{:<{}}  {:>16}  {:>16}\n", "constraint", width, "before", "after") +
                     fmt::format("{:<{}}  {:>16}  {:>16}\n", kAssembles, width,
                                 report.starts_good ? "yes" : "no", report.path_good ? "yes" : "no");
  for (const auto& constraint : report.constraints) {
    text += fmt::format(
        "{:<{}}  {:>16}  {:>16}  {:<10} margin {}{}{}\n", constraint.what, width, shown(constraint.before),
        shown(constraint.after), constraint.unit, shown(constraint.margin, 4),
        constraint.margin < 0 ? ", VIOLATED" : "",
        constraint.cost > 0 ? fmt::format(", costs {:.4g} {}", constraint.cost, constraint.cost_unit) : "");
  }
  return text;
}

std::string search_text(const DesignReport& report) {
  std::string text = fmt::format("\n{} searches by {}, {} candidates; {} different optima\n", report.starts,
                                 report.method, report.evaluations, report.different);
  const bool has_steps = std::any_of(report.variables.begin(), report.variables.end(),
                                     [](const auto& variable) { return variable.step > 0; });
  std::vector<std::string> designs;
  for (std::size_t k = 0; k < std::min<std::size_t>(5, report.optima.size()); ++k) {
    std::string design;
    for (std::size_t i = 0; i < report.variables.size(); ++i) {
      design += fmt::format(" {} {:.5g}", report.variables[i].name, report.optima[k].variables[i]);
    }
    // The assembly is not among the numbers.
    const auto same = std::find(designs.begin(), designs.end(), design);
    text += fmt::format(
        "  {}. {}{}{}{}{}:{}\n", k + 1, shown(report.optima[k].objective),
        report.optima[k].holds ? "" : " (violates a constraint)",
        report.optima[k].as_found.value_or(true) ? "" : " (its profile starts otherwise)",
        has_steps && report.optima[k].text.empty() ? " (not rounded to steps)" : "",
        same == designs.end() ? "" : fmt::format(" (as {}, assembled otherwise)", same - designs.begin() + 1),
        design);
    designs.push_back(std::move(design));
  }
  return text;
}

}  // namespace

std::string design_text(const DesignReport& report) {
  std::string text = report.title.empty() ? "" : report.title + "\n\n";
  text += variables_text(report) + objectives_text(report) + constraints_text(report) + search_text(report);
  if (!report.as_found) {
    text +=
        "\nthe profile that was written does not start in the assembly that was found: poses that would lead "
        "there are taken exactly, as for the fixed angle of a slide or the start of a driver. The numbers "
        "above are of the profile as written; give these numbers (angle, start) on their own, or the poses "
        "of "
        "the assembly that is wanted\n";
  } else if (!report.holds) {
    text += "\nno design was found in which all constraints hold: this is the one that violates them least\n";
  }
  return text;
}

std::string design_json(const DesignReport& report) {
  Json json;
  json["title"] = report.title;
  json["holds"] = report.holds;
  json["path_good"] = report.path_good;
  json["as_found"] = report.as_found;
  json["before"] = number_or_null(report.before);
  json["after"] = number_or_null(report.after);
  json["variables"] = Json::array();
  for (const auto& variable : report.variables) {
    json["variables"].push_back({{"name", variable.name},
                                 {"paths", variable.paths},
                                 {"before", number_or_null(variable.before)},
                                 {"after", number_or_null(variable.after)},
                                 {"min", variable.low},
                                 {"max", variable.high},
                                 {"at_bound", variable.at_bound}});
  }
  json["objectives"] = Json::array();
  for (const auto& objective : report.objectives) {
    json["objectives"].push_back(
        {{"what", objective.what},
         {"unit", objective.unit},
         {"before", number_or_null(objective.before)},
         {"after", number_or_null(objective.after)},
         {"target", objective.target ? number_or_null(*objective.target) : Json(nullptr)}});
    if (const auto& placed = objective.placement) {
      json["objectives"].back()["placement"] = {
          {"turn", placed->turn}, {"scale", placed->scale}, {"x", placed->x}, {"y", placed->y}};
    }
  }
  json["constraints"] = Json::array();
  for (const auto& constraint : report.constraints) {
    json["constraints"].push_back({{"what", constraint.what},
                                   {"unit", constraint.unit},
                                   {"limit", constraint.limit},
                                   {"before", number_or_null(constraint.before)},
                                   {"after", number_or_null(constraint.after)},
                                   {"margin", number_or_null(constraint.margin)},
                                   {"cost", number_or_null(constraint.cost)},
                                   {"cost_unit", constraint.cost_unit}});
  }
  Json optima = Json::array();
  for (const auto& optimum : report.optima) {
    optima.push_back({{"objective", number_or_null(optimum.objective)},
                      {"holds", optimum.holds},
                      {"as_found", optimum.as_found ? Json(*optimum.as_found) : Json()},
                      {"variables", optimum.variables}});
  }
  json["search"] = {{"method", report.method},           {"starts", report.starts},
                    {"evaluations", report.evaluations}, {"end", end_text(report.end)},
                    {"different", report.different},     {"optima", optima}};
  return document_of(json);
}

}  // namespace higherpair::cli
