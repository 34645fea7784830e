// The variables of a design.
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/numeric/contains.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "io/tolerances.hpp"
#include "number_unit.hpp"
#include "read_design.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// The parts of a profile whose numbers a design may change: not counts, units or tasks.
constexpr std::string_view kDesignable[] = {"bodies.", "joints.",  "contacts.", "driver.", "drivers.",
                                            "loads.",  "springs.", "laws.",     "gravity."};

bool is_designable(std::string_view path) {
  return !path.ends_with(".samples") &&
         std::any_of(std::begin(kDesignable), std::end(kDesignable),
                     [&](std::string_view room) { return path.starts_with(room); });
}

class VariableReader {
public:
  VariableReader(Reading& reading, const Table& document, std::vector<DesignTask::Variable>& variables)
      : reading_(reading), document_(document), variables_(variables) {}

  void read(const std::string& name, TableReader& table) {
    DesignTask::Variable variable;
    variable.name = name;
    variable.place = place_of(reading_, table.mark());
    std::optional<double> start;
    if (const auto item = table.need("path", "the number's path, \"bodies.crank.points.A.0\"")) {
      for (const Item& path : paths_in(*item)) {
        read_path(path, variable, start);
      }
    }
    const NumberUnit unit = unit_of_paths(reading_, variable.paths);
    variable.unit = unit_text(unit.dimension.value_or(dimension::kNumber), reading_.units);
    const auto min = table.take("min");
    const auto max = table.take("max");
    const auto low = min ? as_number_in(reading_, *min, unit) : std::optional(-kInf);
    const auto high = max ? as_number_in(reading_, *max, unit) : std::optional(kInf);
    const auto step = table.take("step");
    variable.range.step = step ? as_number_in(reading_, *step, unit).value_or(0) : 0;
    if (step && !(variable.range.step > 0)) {
      report(reading_, *step, "expected a number > 0, such as 0.5; leave it out where any value will do");
    }
    variable.range.log = table.flag("log", false);
    table.finish();
    if (low && high && start) {
      variable.range.low = *low;
      variable.range.high = *high;
      variable.range.start = *start;
      check_range(min, max, step, variable);
    }
    variables_.push_back(std::move(variable));
  }

private:
  std::vector<Item> paths_in(const Item& item) {
    if (!std::holds_alternative<Array>(item.value->content)) return {item};
    std::vector<Item> paths = items_of(item);
    if (paths.empty()) report(reading_, item, "expected the path of a number, or a list of such paths");
    return paths;
  }

  // "bodies.crank.points.A.0", or { path = "bodies.coupler.points.A.0", times = -1 }.
  void read_path(const Item& item, DesignTask::Variable& variable, std::optional<double>& start) {
    if (!std::holds_alternative<Table>(item.value->content)) {
      add_path(item, 1, variable, start);
      return;
    }
    TableReader table(reading_, *item.value);
    const auto path = table.need("path", "the number's path, \"bodies.crank.points.A.0\"");
    const auto times = table.take("times");
    const double factor = times ? as_number_in(reading_, *times, no_unit()).value_or(1) : 1;
    if (factor == 0) report(reading_, *times, "must not be 0: the number would not depend on the variable");
    table.finish();
    if (path && factor != 0) add_path(*path, factor, variable, start);
  }

  void add_path(const Item& item, double factor, DesignTask::Variable& variable,
                std::optional<double>& start) {
    const auto path = as_text(reading_, item);
    if (!path) return;
    const Value* value = end_of_path(document_, *path).value;
    const auto number = value == nullptr ? std::nullopt : number_read(reading_, *value);
    if (!number || !is_designable(*path)) {
      report(reading_, item, no_number(*path, value, number.has_value()), *path);
      return;
    }
    for (const DesignTask::Variable& other : variables_) {
      if (contains(other.paths, *path)) {
        report(reading_, item, fmt::format("this number is variable `{}` already", other.name));
      }
    }
    if (start && *number != factor * *start) {
      report(
          reading_, item,
          fmt::format("this number is {}, but by the first one of this variable it is to be {}: write that "
                      "into the profile",
                      *number, factor * *start));
    }
    start = start ? start : *number / factor;
    variable.paths.push_back(*path);
    variable.factors.push_back(factor);
  }

  [[nodiscard]] std::string no_number(const std::string& path, const Value* value, bool is_number) const {
    if (value != nullptr && !is_number && std::holds_alternative<std::string>(value->content)) {
      return fmt::format("this is {}, a text: expected the path of a number", text_of(*value));
    }
    if (value != nullptr && !is_number) {
      return fmt::format("this is {}, not one number; go on to the number itself, such as {}.0",
                         kind_of(*value), path);
    }
    if (value != nullptr) {
      return "this number is none of the mechanism's: variables are numbers of bodies, joints, contacts, "
             "drivers, "
             "loads, springs, laws and gravity";
    }
    std::vector<std::string> paths;
    for_each_number(document_, [&](const std::string& other, double /*number*/) {
      if (is_designable(other)) paths.push_back(other);
    });
    const std::string meant = did_you_mean(path, paths);
    return "there is no number at this path" + (meant.empty() ? std::string() : "; " + meant);
  }

  void check_range(const std::optional<Item>& min, const std::optional<Item>& max,
                   const std::optional<Item>& step, const DesignTask::Variable& variable) {
    const DesignVariable& range = variable.range;
    if (!(range.low < range.high)) {
      report(reading_, *min,
             fmt::format("must be less than max = {}; {}", range.high,
                         range.low > range.high ? "the two are the wrong way round"
                                                : "a fixed number is no variable"));
      return;
    }
    if (range.start < range.low || range.start > range.high) {
      report(reading_, range.start < range.low ? *min : *max,
             fmt::format(
                 "the profile has {} = {}, which is outside; the search begins there: change the number or "
                 "the bounds",
                 variable.paths.front(), range.start));
    }
    if (range.log && !(range.low > 0) && min) {
      report(reading_, *min, "must be > 0 with `log`: logarithms have no 0");
    }
    if (step && range.step > 0 &&
        std::floor(range.high / range.step + kOnVariableStep) <
            std::ceil(range.low / range.step - kOnVariableStep)) {
      report(reading_, *step, "no multiple of it lies between min and max");
    }
  }

  Reading& reading_;
  const Table& document_;
  std::vector<DesignTask::Variable>& variables_;
};

}  // namespace

void read_variable(const std::string& name, TableReader& table, const Table& document,
                   std::vector<DesignTask::Variable>& variables) {
  VariableReader(table.reading(), document, variables).read(name, table);
}

}  // namespace higherpair::io_detail
