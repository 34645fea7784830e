// A page that shows a design: the mechanism before and after, and what was asked and found.
#include "front/model_data.hpp"
#include "higherpair/drawing/printed_number.hpp"
#include "higherpair/drawing/xml.hpp"
#include "higherpair/front/design.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/io/design_task.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr std::string_view kStyle = R"(
body { font: 15px/1.45 "Helvetica Neue", Arial, "Liberation Sans", sans-serif; color: #111; margin: 2rem auto;
  max-width: 64rem; padding: 0 1rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2rem; }
figure { display: inline-block; width: 48%; margin: 0; vertical-align: top; }
figure svg { width: 100%; height: auto; border: 1px solid #ddd; } figcaption { font-weight: bold; }
@media (max-width: 50rem) { figure { width: 100%; } }
table { border-collapse: collapse; } th, td { padding: .25rem .7rem; text-align: right; border-bottom: 1px solid #ddd; }
th { background: #f3f5f7; } th:first-child, td:first-child { text-align: left; }
.violated { color: #a00; font-weight: bold; }
)";

std::string number_cell(double value) {
  return std::isfinite(value) ? printed_significant(value, 9) : "&ndash;";
}

std::string unit(const std::string& name) {
  return xml_escaped(printed_unit(name));
}

// Cells are escaped already.
std::string row_of(const std::vector<std::string>& cells, std::string_view tag = "td",
                   std::string_view style = "") {
  std::string row = style.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", style);
  for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, cell);
  return row + "</tr>\n";
}

std::string variables_table(const DesignReport& report) {
  std::string table = "<table>\n" + row_of({"variable", "before", "after", "min", "max", ""}, "th");
  for (const auto& variable : report.variables) {
    table += row_of({xml_escaped(variable.name), number_cell(variable.before), number_cell(variable.after),
                     number_cell(variable.low), number_cell(variable.high),
                     variable.at_bound ? "at its bound" : ""});
  }
  return table + "</table>\n";
}

std::string objectives_table(const DesignReport& report) {
  std::string table = "<table>\n" + row_of({"objective", "before", "after", "target", "unit"}, "th");
  for (const auto& objective : report.objectives) {
    table += row_of({xml_escaped(objective.what), number_cell(objective.before), number_cell(objective.after),
                     objective.target ? number_cell(*objective.target) : "least", unit(objective.unit)});
  }
  table += row_of({"altogether", number_cell(report.before), number_cell(report.after), "", ""});
  return table + "</table>\n";
}

std::string constraints_table(const DesignReport& report) {
  std::string table =
      "<table>\n" + row_of({"constraint", "before", "after", "unit", "margin", "what it costs"}, "th");
  table += row_of({"assembles all the way", report.starts_good ? "yes" : "no",
                   report.path_good ? "yes" : "no", "", "", ""},
                  "td", report.path_good ? "" : "violated");
  if (!report.as_found) table += row_of({"starts as it was found", "", "no", "", "", ""}, "td", "violated");
  for (const auto& constraint : report.constraints) {
    const std::string cost =
        constraint.cost > 0 ? number_cell(constraint.cost) + " " + unit(constraint.cost_unit) : "";
    table +=
        row_of({xml_escaped(constraint.what), number_cell(constraint.before), number_cell(constraint.after),
                unit(constraint.unit), number_cell(constraint.margin), cost},
               "td", constraint.margin < 0 ? "violated" : "");
  }
  return table + "</table>\n";
}

std::string search_table(const DesignReport& report) {
  std::vector<std::string> heads = {"", "objective"};
  for (const auto& variable : report.variables) heads.push_back(xml_escaped(variable.name));
  std::string table =
      fmt::format("<p>{} {} by {}, {} candidates; {}:</p>\n", report.starts,
                  report.starts == 1 ? "search" : "searches", xml_escaped(report.method), report.evaluations,
                  report.different == 1
                      ? "one optimum"
                      : fmt::format("{} different optima, the best of which are", report.different)) +
      "<table>\n" + row_of(heads, "th");
  for (std::size_t k = 0; k < report.optima.size(); ++k) {
    const auto& optimum = report.optima[k];
    std::vector<std::string> cells = {fmt::format("{}", k + 1), number_cell(optimum.objective)};
    for (const double value : optimum.variables) cells.push_back(printed_significant(value, 6));
    table += row_of(cells, "td", optimum.holds ? "" : "violated");
  }
  return table + "</table>\n";
}

// A target point of a path, in the frame of the mechanism before it is placed.
Vector2d unplaced(const Vector2d& point, const std::optional<DesignReport::Objective::Placement>& placement,
                  const Units& units) {
  if (!placement) return point;
  const double turn = to_si(dimension::kAngle, units).apply(placement->turn);
  const Scaling length = to_si(dimension::kLength, units);
  const Vector2d moved = point - Vector2d(length.apply(placement->x), length.apply(placement->y));
  return Rotation<double>::from_angle(-turn) * moved / placement->scale;
}

// The target points of all paths [mm].
std::vector<Vector2d> targets_of(const Model& model, const DesignReport& report) {
  std::vector<Vector2d> targets;
  const auto& objectives = model.profile().design->objectives;
  for (std::size_t k = 0; k < objectives.size(); ++k) {
    if (!objectives[k].path()) continue;
    for (const Vector2d& through : objectives[k].path()->through) {
      targets.push_back(kMillimetresPerMetre *
                        unplaced(through, report.objectives[k].placement, model.units()));
    }
  }
  return targets;
}

Result<Scenes> scenes_with_paths(const Model& model) {
  SceneSettings settings;
  for (const DesignTask::PointPath* path : model.profile().design->paths()) {
    settings.traces.push_back(path->point);
  }
  return scenes_of(model, settings);
}

// One frame for both, so that they are drawn to the same scale.
void share_view(std::vector<Scene>& first, std::vector<Scene>& second) {
  const Box both = first.front().view.joined(second.front().view);
  for (std::vector<Scene>* scenes : {&first, &second}) {
    for (Scene& scene : *scenes) scene.view = both;
  }
}

std::string picture_of(const Model& model, const std::vector<Scene>& scenes, const DesignReport& report) {
  DrawSettings draw = draw_settings(model.units());
  draw.title = model.mechanism().title;
  draw.targets = targets_of(model, report);
  const std::string svg = draw_svg(scenes, draw);
  return svg.substr(svg.find("<svg"));
}

std::string figure_of(const Model& model, const Result<Scenes>& scenes, const DesignReport& report,
                      std::string_view caption) {
  const std::string shown = scenes ? picture_of(model, scenes->scenes, report)
                                   : "<p>It cannot be drawn: it cannot be put together.</p>";
  return fmt::format("<figure><figcaption>{}</figcaption>\n{}</figure>\n", caption, shown);
}

}  // namespace

Result<std::string> design_page(const Model& before, const DesignReport& report) {
  if (!before.data().document || !before.profile().design) {
    return wrong(before, "is not the model of a design");
  }
  const auto after = Model::from_text(report.text, before.profile().source);
  if (!after) {
    return tl::unexpected(after.error());
  }
  auto first = scenes_with_paths(before);
  auto second = scenes_with_paths(*after);
  if (!first && !second) {
    return tl::unexpected(second.error());
  }
  if (first && second) share_view(first->scenes, second->scenes);
  const std::string title = report.title.empty() ? "Design" : xml_escaped(report.title);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<h1>{0}</h1>\n",
      title, kStyle);
  page += figure_of(before, first, report, "Before") + figure_of(*after, second, report, "After");
  if (!report.holds) {
    page +=
        "<p class=\"violated\">No design was found in which all constraints hold: this is the one that "
        "violates them least.</p>\n";
  }
  page += "<h2>Variables</h2>\n" + variables_table(report);
  page += "<h2>Objectives</h2>\n" + objectives_table(report);
  page += "<h2>Constraints</h2>\n" + constraints_table(report);
  page += "<h2>Search</h2>\n" + search_table(report);
  return page + "</body>\n</html>\n";
}

}  // namespace higherpair
