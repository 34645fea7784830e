#include "front/columns/column_set.hpp"
#include "front/outputs.hpp"
#include "front/tolerances.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "report_data.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace higherpair {
namespace {

struct Found {
  const Column& column;
  const ColumnExtremes& extremes;
  double noise = 0;

  [[nodiscard]] double range() const { return extremes.high.value - extremes.low.value; }
  [[nodiscard]] const ColumnExtremes::Value& largest() const {
    const auto& [low, high] = extremes;
    const double a = std::abs(low.value), b = std::abs(high.value);
    const bool same = std::abs(a - b) <= kColumnNoise * std::max(a, b);
    return (same ? low.row < high.row : a > b) ? low : high;
  }
  [[nodiscard]] bool is_constant() const {
    return range() <= noise || range() <= kColumnNoise * std::abs(largest().value);
  }
  [[nodiscard]] double rounded(double value) const { return std::abs(value) <= noise ? 0 : value; }
};

// A column that is there and has a value in some row.
std::optional<Found> find(const ReportData& data, const std::string& name) {
  const std::size_t k = column_slot(data.columns, name);
  if (k == data.columns.size() || std::isnan(data.extremes[k].low.value)) return std::nullopt;
  return Found{data.columns[k], data.extremes[k], kColumnNoise * data.scales[k]};
}

bool column_is_rate(const Column& column) {
  return column.unit.find('/') != std::string::npos;
}

// Adds facts about one joint or contact.
class FactList {
public:
  FactList(const ReportData& data, std::vector<Fact>& facts) : data_(data), facts_(facts) {}

  void range(const std::string& of, const std::string& column, const std::string& name) {
    if (const auto found = find(data_, column)) {
      const auto& [low, high] = found->extremes;
      add(of, name, *found, found->range(), {low, high});
    }
  }
  void largest(const std::string& of, const std::string& column, const std::string& name) {
    if (const auto found = find(data_, column)) {
      add(of, name, *found, found->largest().value, {found->largest()});
    }
  }
  // The largest value without its sign, as of a speed; the place still has it.
  void fastest(const std::string& of, const std::string& column, const std::string& name) {
    if (const auto found = find(data_, column)) {
      add(of, name, *found, std::abs(found->largest().value), {found->largest()});
    }
  }
  void smallest(const std::string& of, const std::string& column, const std::string& name) {
    if (const auto found = find(data_, column)) {
      add(of, name, *found, found->extremes.low.value, {found->extremes.low});
    }
  }

private:
  void add(const std::string& of, const std::string& name, const Found& found, double value,
           std::vector<ColumnExtremes::Value> at) {
    if (found.is_constant()) {
      if (found.rounded(value) == 0 && column_is_rate(found.column)) return;
      at.clear();
    }
    for (ColumnExtremes::Value& here : at) here.value = found.rounded(here.value);
    facts_.push_back({of, name, found.rounded(value), found.column.unit, found.column.name, std::move(at)});
  }

  const ReportData& data_;
  std::vector<Fact>& facts_;
};

// Whether nothing moves except what is driven.
bool is_driven_alone(const Mechanism& mechanism) {
  return mechanism.joints.size() == mechanism.drivers.size() && mechanism.contacts.empty();
}

// Whether an angle goes through a full turn: what turns right round does not swing.
bool turns_round(const ReportData& data, const std::string& name, double turn) {
  const auto found = find(data, name);
  return found && found->range() >= turn * (1 - kColumnNoise);
}

// The columns of these names that exist and change.
std::vector<std::string> changing(const ReportData& data, const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (const std::string& name : names) {
    if (const auto column = find(data, name); column && !column->is_constant()) found.push_back(name);
  }
  return found;
}

// For a mechanism without outputs: the body named last is usually the last one to be moved.
void add_last_body(const Mechanism& mechanism, const ReportData& data, FactList& list) {
  const std::string& body = mechanism.bodies.back().name;
  for (const auto& [column, name] : {std::pair(".x", "Travel along x"), std::pair(".y", "Travel along y"),
                                     std::pair(".angle", "Turning")}) {
    if (!changing(data, {body + column}).empty()) list.range(body, body + column, name);
  }
}

}  // namespace

std::vector<Fact> facts_of(const Mechanism& mechanism, double turn, const ReportData& data) {
  std::vector<Fact> facts;
  FactList list(data, facts);
  for (const Joint* joint : outputs_of(mechanism)) {
    const std::string& name = joint->name;
    list.range(name, name + ".position",
               !has_angle(joint->type)                       ? "Stroke"
               : turns_round(data, name + ".position", turn) ? "Turns"
                                                             : "Swing");
    list.fastest(name, name + ".velocity", "Max. speed");
    list.largest(name, name + ".acceleration", "Max. acceleration");
  }
  for (const Contact& contact : mechanism.contacts) {
    list.largest(contact.name, contact.name + ".pressure", "Max. pressure angle");
    list.smallest(contact.name, contact.name + ".transmission", "Min. transmission");
    if (!contact.rolling) list.fastest(contact.name, contact.name + ".sliding", "Max. sliding");
    list.smallest(contact.name, contact.name + ".force", "Min. force");
  }
  for (const Driver& driver : mechanism.drivers) {
    const std::string name = driver_name(driver);
    if (is_driven_alone(mechanism)) {
      list.range(name, name, "Travel");
      list.fastest(name, name + ".velocity", "Max. speed");
      list.largest(name, name + ".acceleration", "Max. acceleration");
    }
    const bool turns = has_angle(mechanism.joints[driver.joint].type);
    list.largest(name, name + ".effort", turns ? "Max. driving torque" : "Max. driving force");
  }
  if (facts.empty() && mechanism.bodies.size() > 1) {
    add_last_body(mechanism, data, list);
  }
  return facts;
}

std::vector<std::vector<std::string>> first_plots(const Mechanism& mechanism, const ReportData& data) {
  const std::vector<const Joint*> joints = outputs_of(mechanism);
  std::vector<std::vector<std::string>> plots;
  const auto add = [&](const std::vector<std::string>& names) {
    if (auto found = changing(data, names); !found.empty()) plots.push_back(std::move(found));
  };
  // Positions are usually far apart, and are plotted alone; rates vary about zero.
  for (const Joint* joint : joints) {
    add({joint->name + ".position"});
  }
  for (const char* what : {".velocity", ".acceleration"}) {
    std::vector<std::string> names;
    for (const Joint* joint : joints) {
      names.push_back(joint->name + what);
    }
    add(names);
  }
  for (const Contact& contact : mechanism.contacts) {
    add({contact.name + ".pressure", contact.name + ".transmission"});
    add({contact.name + ".force"});
  }
  for (const Driver& driver : mechanism.drivers) {
    const std::string name = driver_name(driver);
    for (const char* what : {"", ".velocity", ".acceleration"}) {
      if (is_driven_alone(mechanism)) add({name + what});
    }
    add({name + ".effort"});
  }
  if (plots.empty()) {
    const std::string& body = mechanism.bodies.back().name;
    add({body + ".x", body + ".y"});
    add({body + ".angle"});
  }
  return plots;
}

}  // namespace higherpair
