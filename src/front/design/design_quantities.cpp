#include "design_quantities.hpp"

#include "higherpair/front/check.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/mechanism/loops.hpp"
#include "higherpair/numeric/contains.hpp"
#include "higherpair/numeric/overload.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

std::optional<FourBarInMechanism> four_bar_of(const Mechanism& mechanism,
                                              const DesignTask::Grashof& grashof) {
  std::vector<FourBarInMechanism> found = find_four_bars(mechanism);
  std::erase_if(found, [&](const FourBarInMechanism& loop) {
    return grashof.coupler >= 0 && loop.coupler != grashof.coupler;
  });
  return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
}

bool is_meant(const CheckFigure& figure, const DesignTask::Figure& wanted) {
  return figure.item == wanted.item && figure.quantity == wanted.quantity &&
         (wanted.of.empty() || figure.of == wanted.of);
}

std::string figure_objection(const std::vector<CheckFigure>& figures, const DesignTask::Figure& wanted) {
  std::vector<std::string> names;
  std::vector<std::string> curves;
  for (const CheckFigure& figure : figures) {
    const std::string name = figure.item + "." + figure.quantity;
    if (!contains(names, name)) names.push_back(name);  // of 2 curves
    if (figure.item == wanted.item && figure.quantity == wanted.quantity) curves.push_back(figure.of);
  }
  const std::string name = wanted.item + "." + wanted.quantity;
  if (curves.empty()) {
    return fmt::format("`check` has no such figure of this mechanism; {}", suggestion(name, names));
  }
  return fmt::format("which curve is meant? say curve = \"{}\"", joined_words(curves, "\" or curve = \""));
}

}  // namespace

DesignQuantities quantities_of(const DesignTask& task) {
  DesignQuantities quantities;
  const auto add = [&](const auto& entry, auto of, std::size_t numbers) {
    quantities.all.push_back({std::move(of), quantities.numbers, "", entry.place, entry.path_of_key});
    quantities.numbers += numbers;
  };
  const auto add_column = [&](const auto& entry, const Measure& measure, const std::vector<double>& at) {
    add(entry, ColumnQuantity{quantities.measures.size(), at}, std::max<std::size_t>(1, at.size()));
    quantities.measures.push_back(measure);
  };
  const auto add_entry = [&](const auto& entry) {
    std::visit(Overload{[](const DesignTask::PointPath&) {}, [](const DesignTask::Transmission&) {},
                        [&](const Measure& measure) { add_column(entry, measure, {}); },
                        [&](const DesignTask::Followed& one) { add_column(entry, one.measure, one.at); },
                        [&](const auto& other) { add(entry, other, 1); }},
               entry.of);
  };
  const auto mark_sign = [&](const auto& entry, bool with_sign) {
    if (std::holds_alternative<DesignTask::Figure>(entry.of)) quantities.all.back().with_sign = with_sign;
  };
  for (const DesignTask::Objective& objective : task.objectives) {
    add_entry(objective);
    mark_sign(objective, objective.target.has_value());
  }
  for (const DesignTask::Constraint& constraint : task.constraints) {
    add_entry(constraint);
    mark_sign(constraint, constraint.below && *constraint.below < 0);
  }
  return quantities;
}

std::vector<Measure> DesignQuantities::measures_at_all_places() const {
  std::vector<Measure> places = measures;
  for (const DesignQuantity& quantity : all) {
    const auto* column = quantity.as<ColumnQuantity>();
    for (std::size_t k = 1; column != nullptr && k < column->at.size(); ++k) {
      places.push_back(measures[column->measure]);
      places.back().at = column->at[k];
    }
  }
  return places;
}

// A link turns fully relative to all others iff its length plus that of any other one is at most the sum of
// the remaining two; it is the shortest then (Grashof).
std::optional<double> grashof_room(const Mechanism& mechanism, const DesignTask::Grashof& grashof) {
  const auto loop = four_bar_of(mechanism, grashof);
  if (!loop) {
    return std::nullopt;
  }
  const FourBar& bar = loop->linkage;
  const auto room = [](double turns, double a, double b, double c) {
    return std::min({b + c - turns - a, a + c - turns - b, a + b - turns - c});
  };
  switch (grashof.of) {
    case GrashofClass::kCrankRocker:
      return room(bar.r2, bar.r1, bar.r3, bar.r4);
    case GrashofClass::kRockerCrank:
      return room(bar.r4, bar.r1, bar.r2, bar.r3);
    case GrashofClass::kDoubleCrank:
      return room(bar.r1, bar.r2, bar.r3, bar.r4);
    case GrashofClass::kDoubleRocker:
      return room(bar.r3, bar.r1, bar.r2, bar.r4);
    default:
      return -grashof_margin(bar);
  }
}

std::vector<double> figures_of(const Model& model, const std::vector<DesignQuantity>& quantities) {
  std::vector<double> values(quantities.size(), kNoValue);
  const auto report = check(model);
  for (std::size_t k = 0; report && k < quantities.size(); ++k) {
    const auto* wanted = quantities[k].as<DesignTask::Figure>();
    if (wanted == nullptr) continue;
    const auto figure = std::find_if(report->figures.begin(), report->figures.end(),
                                     [&](const CheckFigure& one) { return is_meant(one, *wanted); });
    if (figure == report->figures.end() || !figure->value) continue;
    values[k] = figure->by_size && !quantities[k].with_sign ? std::abs(*figure->value) : *figure->value;
  }
  return values;
}

Diagnostics complete_quantities(const Model& model, const std::vector<Measure>& measures,
                                const std::vector<Column>& table, std::vector<DesignQuantity>& quantities) {
  Diagnostics mistakes;
  const auto report = has_any<DesignTask::Figure>(quantities)
                          ? check(model)
                          : Result<CheckReport>(tl::unexpected(Error{ErrorKind::kInput, {}}));
  for (DesignQuantity& quantity : quantities) {
    const auto object = [&](const std::string& what) {
      mistakes.push_back({quantity.place, fmt::format("{}: {}", quantity.path_of_key, what)});
    };
    const std::string length = unit_text(dimension::kLength, model.units());
    std::visit(
        Overload{[](const DesignTask::Events&) {}, [&](const DesignTask::Extent&) { quantity.unit = length; },
                 [&](const DesignTask::Grashof& grashof) {
                   quantity.unit = length;
                   if (four_bar_of(model.mechanism(), grashof)) return;
                   object(
                       "expected a mechanism with one four-bar; of several the coupler says which, "
                       "coupler = \"BODY\"");
                 },
                 [&](const ColumnQuantity& measured) {
                   for (const Column& column : table) {
                     if (column.name == measures[measured.measure].column) quantity.unit = column.unit;
                   }
                 },
                 [&](const DesignTask::Figure& figure) {
                   if (!report) return;
                   const auto meant = [&](const CheckFigure& one) { return is_meant(one, figure); };
                   const auto& figures = report->figures;
                   if (std::count_if(figures.begin(), figures.end(), meant) != 1) {
                     object(figure_objection(figures, figure));
                   } else {
                     quantity.unit = std::find_if(figures.begin(), figures.end(), meant)->unit;
                   }
                 }},
        quantity.of);
  }
  return mistakes;
}

}  // namespace higherpair
