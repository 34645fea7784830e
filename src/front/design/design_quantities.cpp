#include "design_quantities.hpp"

#include "higherpair/front/check.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/mechanism/loops.hpp"
#include "higherpair/numeric/contains.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>

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
  const auto add = [&](const auto& entry) -> DesignQuantity& {
    DesignQuantity& quantity = quantities.all.emplace_back();
    quantity.place = entry.place;
    quantity.path_of_key = entry.path_of_key;
    quantity.first = quantities.numbers++;
    return quantity;
  };
  const auto add_measure = [&](const auto& entry, const Measure& measure) {
    add(entry).measure = quantities.measures.size();
    quantities.measures.push_back(measure);
  };
  for (const DesignTask::Objective& objective : task.objectives) {
    if (objective.measure) add_measure(objective, *objective.measure);
    if (objective.figure) add(objective).figure = objective.figure;
    if (objective.extent) add(objective).extent = objective.extent;
    if (objective.followed) {
      add_measure(objective, objective.followed->measure);
      quantities.all.back().at = objective.followed->at;
      quantities.numbers += objective.followed->at.size() - 1;
    }
  }
  for (const DesignTask::Constraint& constraint : task.constraints) {
    if (constraint.measure) add_measure(constraint, *constraint.measure);
    if (constraint.figure) add(constraint).figure = constraint.figure;
    if (constraint.extent) add(constraint).extent = constraint.extent;
    if (constraint.grashof) add(constraint).grashof = constraint.grashof;
    if (!constraint.without.empty()) add(constraint).without = constraint.without;
  }
  return quantities;
}

std::vector<Measure> DesignQuantities::measures_at_all_places() const {
  std::vector<Measure> places = measures;
  for (const DesignQuantity& quantity : all) {
    for (std::size_t k = 1; k < quantity.at.size(); ++k) {
      places.push_back(measures[*quantity.measure]);
      places.back().at = quantity.at[k];
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
    if (!quantities[k].figure) continue;
    const auto figure =
        std::find_if(report->figures.begin(), report->figures.end(),
                     [&](const CheckFigure& one) { return is_meant(one, *quantities[k].figure); });
    if (figure != report->figures.end()) values[k] = figure->value.value_or(values[k]);
  }
  return values;
}

Diagnostics complete_quantities(const Model& model, const std::vector<Measure>& measures,
                                const std::vector<Column>& table, std::vector<DesignQuantity>& quantities) {
  Diagnostics mistakes;
  const bool has_figures = std::any_of(quantities.begin(), quantities.end(),
                                       [](const DesignQuantity& one) { return one.figure.has_value(); });
  const auto report =
      has_figures ? check(model) : Result<CheckReport>(tl::unexpected(Error{ErrorKind::kInput, {}}));
  for (DesignQuantity& quantity : quantities) {
    const auto object = [&](const std::string& what) {
      mistakes.push_back({quantity.place, fmt::format("{}: {}", quantity.path_of_key, what)});
    };
    if (quantity.grashof || quantity.extent) quantity.unit = unit_text(dimension::kLength, model.units());
    if (quantity.grashof) {
      if (!four_bar_of(model.mechanism(), *quantity.grashof)) {
        object(
            "expected a mechanism with one four-bar; of several the coupler says which, coupler = \"BODY\"");
      }
    } else if (quantity.measure) {
      for (const Column& column : table) {
        if (column.name == measures[*quantity.measure].column) quantity.unit = column.unit;
      }
    } else if (quantity.figure && report) {
      const auto meant = [&](const CheckFigure& one) { return is_meant(one, *quantity.figure); };
      const auto count = std::count_if(report->figures.begin(), report->figures.end(), meant);
      if (count != 1) {
        object(figure_objection(report->figures, *quantity.figure));
      } else {
        quantity.unit = std::find_if(report->figures.begin(), report->figures.end(), meant)->unit;
      }
    }
  }
  return mistakes;
}

}  // namespace higherpair
