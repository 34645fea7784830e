// Selects the numbers by which results are differentiated, and the results.
#include "sensitivity_numbers.hpp"

#include "front/outputs.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/design_task.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/tasks.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/core.h>

namespace higherpair {
namespace {

// The parts of a profile that hold numbers of the mechanism itself.
constexpr std::string_view kMechanism[] = {"bodies.", "joints.", "loads.", "springs.", "gravity."};

bool is_of_mechanism(std::string_view path) {
  return std::any_of(std::begin(kMechanism), std::end(kMechanism),
                     [&](std::string_view table) { return path.starts_with(table); });
}

// Whether a number belongs to a task in the profile, not to the mechanism.
bool is_of_task(std::string_view path) {
  constexpr std::string_view kTasks[] = {"limits.", "sweep.", "design.", "tolerances."};
  return std::any_of(std::begin(kTasks), std::end(kTasks),
                     [&](std::string_view table) { return path.starts_with(table); });
}

using Quantities = std::vector<ProfileDocument::Quantity>;

ProfileNumber number_of(const ProfileDocument::Quantity& quantity, const Units& units) {
  return {{quantity.path, {quantity.path}, quantity.value, unit_text(quantity.dimension, units), 1},
          quantity.dimension};
}

const ProfileDocument::Quantity* quantity_at(const Quantities& quantities, const std::string& path) {
  const auto found =
      std::find_if(quantities.begin(), quantities.end(), [&](const auto& q) { return q.path == path; });
  return found == quantities.end() ? nullptr : &*found;
}

Result<std::vector<ProfileNumber>> chosen_by(const std::vector<std::string>& globs,
                                             const Quantities& quantities, const Units& units) {
  std::vector<bool> chosen(quantities.size(), false);
  for (const std::string& glob : globs) {
    bool any = false;
    for (std::size_t i = 0; i < quantities.size(); ++i) {
      if (!is_of_task(quantities[i].path) && matches(glob, quantities[i].path)) chosen[i] = any = true;
    }
    if (!any) {
      std::vector<std::string> paths;
      for (const auto& quantity : quantities) {
        if (!is_of_task(quantity.path)) paths.push_back(quantity.path);
      }
      return wrong(Place{"setting by " + glob},
                   fmt::format("no number of the profile has such a path; {}", suggestion(glob, paths)));
    }
  }
  std::vector<ProfileNumber> numbers;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (chosen[i]) numbers.push_back(number_of(quantities[i], units));
  }
  return numbers;
}

std::vector<ProfileNumber> of_tolerances(const ToleranceTask& task, const Quantities& quantities) {
  std::vector<ProfileNumber> numbers;
  for (const Tolerance& tolerance : task.tolerances) {
    const auto* quantity = quantity_at(quantities, tolerance.paths.front());
    numbers.push_back({{tolerance.name, tolerance.paths, tolerance.value, tolerance.unit, 1},
                       quantity != nullptr ? quantity->dimension : dimension::kNumber});
  }
  return numbers;
}

// The variables of a design. Those that are no quantity of the profile, such as factors of laws, count as
// pure numbers.
std::vector<ProfileNumber> of_variables(const DesignTask& task, const Quantities& quantities,
                                        const Units& units) {
  std::vector<ProfileNumber> numbers;
  for (const DesignTask::Variable& variable : task.variables) {
    const auto* quantity = quantity_at(quantities, variable.paths.front());
    const Dimension of = quantity != nullptr ? quantity->dimension : dimension::kNumber;
    numbers.push_back({{variable.name, variable.paths, variable.range.start, unit_text(of, units), 1}, of});
  }
  return numbers;
}

NamedMeasure named(const std::string& column, MeasureKind of) {
  NamedMeasure result;
  result.name = fmt::format("{}:{}", column, name_of(of));
  result.measure.column = column;
  result.measure.of = of;
  return result;
}

}  // namespace

Result<std::vector<ProfileNumber>> numbers_for(const Model& model, const std::vector<std::string>& by) {
  if (!model.data().document) {
    return wrong(model, "was built and has no keys to differentiate by: write a profile");
  }
  const Quantities quantities = model.data().document->quantities();
  const Profile& profile = model.profile();
  if (!by.empty()) return chosen_by(by, quantities, profile.units);
  if (profile.tolerances) return of_tolerances(*profile.tolerances, quantities);
  if (profile.design) return of_variables(*profile.design, quantities, profile.units);
  std::vector<ProfileNumber> numbers;
  for (const auto& quantity : quantities) {
    if (is_of_mechanism(quantity.path)) numbers.push_back(number_of(quantity, profile.units));
  }
  return numbers;
}

std::vector<NamedMeasure> default_results(const Model& model) {
  const Mechanism& mechanism = model.mechanism();
  std::vector<NamedMeasure> results;
  for (const Joint* joint : outputs_of(mechanism)) {
    results.push_back(named(joint->name + ".position", MeasureKind::kRange));
    results.push_back(named(joint->name + ".acceleration", MeasureKind::kMaxAbs));
  }
  for (const Contact& contact : mechanism.contacts) {
    results.push_back(named(contact.name + ".pressure", MeasureKind::kMax));
  }
  for (std::size_t i = 0; has_forces(mechanism) && i < mechanism.drivers.size(); ++i) {
    results.push_back(named(driver_name(mechanism.drivers[i]) + ".effort", MeasureKind::kMaxAbs));
  }
  for (std::size_t i = 1; results.empty() && i < mechanism.bodies.size(); ++i) {
    results.push_back(named(mechanism.bodies[i].name + ".angle", MeasureKind::kRange));
  }
  return results;
}

namespace {

bool runs_in_time(const Model& model, const SensitivitySettings& settings) {
  const auto& tolerances = model.profile().tolerances;
  return settings.in_time || (tolerances && tolerances->in_time);
}

}  // namespace

Result<NamedMeasure> measure_from(const Model& model, const std::string& text,
                                  const SensitivitySettings& settings) {
  const Place place{"setting results " + text};
  const std::size_t colon = text.rfind(':');
  const std::vector<std::string> kinds(kMeasureNames.begin(), kMeasureNames.end());
  if (colon == std::string::npos || colon == 0) {
    return wrong(place,
                 fmt::format("expected COLUMN:OF, such as follower.alpha:maxabs; OF is one of {} (at=X)",
                             joined_words(kinds)));
  }
  NamedMeasure result;
  result.name = text;
  result.measure.column = text.substr(0, colon);
  result.measure.place = place;
  std::string of = text.substr(colon + 1);
  const std::size_t equals = of.find('=');
  const std::string at = equals == std::string::npos ? "" : of.substr(equals + 1);
  of = of.substr(0, equals);
  const auto kind = std::find(kinds.begin(), kinds.end(), of);
  if (kind == kinds.end()) {
    return wrong(place, fmt::format("`{}` is no measure of a column; {}", of, suggestion(of, kinds)));
  }
  result.measure.of = static_cast<MeasureKind>(kind - kinds.begin());
  if (result.measure.of != MeasureKind::kAt) {
    return equals == std::string::npos
               ? Result<NamedMeasure>(std::move(result))
               : wrong(place, fmt::format("only `at` has a place: leave out `={}`", at));
  }
  const auto [end, status] = std::from_chars(at.data(), at.data() + at.size(), result.measure.at);
  if (status == std::errc() && end == at.data() + at.size()) {
    return result;
  }
  if (auto refusal = refuse_to_start(model.data())) {
    return tl::unexpected(*std::move(refusal));
  }
  const Dimension wanted =
      runs_in_time(model, settings) ? dimension::kTime : driver_dimension(model.mechanism());
  const auto quantity = parse_quantity(at, wanted, model.units());
  if (!quantity) {
    return wrong(place, fmt::format("expected COLUMN:at=X, X a position of the driver (in time: the time); "
                                    "`{}`: {}",
                                    at, quantity.error()));
  }
  result.measure.at = quantity->profile;
  return result;
}

WantedResults results_for(const Model& model, const SensitivitySettings& settings) {
  const Profile& profile = model.profile();
  WantedResults wanted;
  wanted.in_time = runs_in_time(model, settings);
  wanted.results = settings.results;
  if (wanted.results.empty() && profile.tolerances) {
    for (const ToleranceResult& result : profile.tolerances->results) {
      wanted.results.push_back({result.name, result.measure});
    }
  }
  if (wanted.results.empty() && profile.sweep && !profile.sweep->results.empty()) {
    wanted.in_time = wanted.in_time || profile.sweep->in_time;
    for (const SweepResult& result : profile.sweep->results) {
      wanted.results.push_back({result.name, result.measure});
    }
  }
  if (wanted.results.empty()) wanted.results = default_results(model);
  return wanted;
}

}  // namespace higherpair
