#include "read_design.hpp"

#include "higherpair/io/design_task.hpp"
#include "higherpair/io/suggestion.hpp"
#include "reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace higherpair::io_detail {
namespace {

// Where numbers stand that a design may change: not counts, units or tasks.
constexpr std::string_view kDesignable[] = {"bodies.", "joints.",  "contacts.", "driver.", "drivers.",
                                            "loads.",  "springs.", "laws.",     "gravity."};

bool is_designable(std::string_view path) {
  const bool count = path.size() > 8 && path.substr(path.size() - 8) == ".samples";
  return !count && std::any_of(std::begin(kDesignable), std::end(kDesignable),
                               [&](std::string_view room) { return path.substr(0, room.size()) == room; });
}

class DesignReader {
public:
  DesignReader(Reading& reading, const Table& document, const Profile& profile)
      : reading_(reading), document_(document), profile_(profile) {}

  DesignTask read(TableReader& table) {
    task_.place = place_of(reading_, table.mark());
    if (const auto variables = table.need("variables", "the numbers that may be chosen, one table each")) {
      for_each_table(reading_, *variables, "a variable (a table)",
                     [&](const std::string& name, TableReader& variable) { read_variable(name, variable); });
      if (task_.variables.empty() && reading_.mistakes.empty()) {
        report(reading_, *variables, "expected at least one variable, NAME = { path = …, min = …, max = … }");
      }
    }
    read_list(table.take("objectives"), [&](TableReader& item) {
      if (auto objective = read_objective(item, profile_)) task_.objectives.push_back(*std::move(objective));
    });
    read_list(table.take("constraints"), [&](TableReader& item) {
      if (auto constraint = read_constraint(item, profile_))
        task_.constraints.push_back(*std::move(constraint));
    });
    read_options(table);
    table.finish();
    return std::move(task_);
  }

private:
  template <class F>
  void read_list(const std::optional<Item>& item, F read_one) {
    if (!item) return;
    const auto* items = std::get_if<Array>(&item->value->content);
    if (items == nullptr || items->empty()) {
      report(reading_, *item, fmt::format("expected a list of tables, [[{}]]", item->path));
      return;
    }
    for (std::size_t i = 0; i < items->size(); ++i) {
      const Item one = {&(*items)[i], fmt::format("{}.{}", item->path, i)};
      if (const Table* content = as_table(reading_, one, "a table")) {
        TableReader reader(reading_, *content, one.value->mark, one.path);
        read_one(reader);
        reader.finish();
      }
    }
  }

  void read_variable(const std::string& name, TableReader& table) {
    DesignTask::Variable variable;
    variable.name = name;
    variable.place = place_of(reading_, table.mark());
    std::optional<Item> first;
    std::optional<double> start;
    if (const auto item = table.need("path", "the number's path, \"bodies.crank.points.A.0\"")) {
      for (const Item& path : paths_in(*item)) {
        read_path(path, variable, start);
      }
    }
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const auto min = table.take("min");
    const auto max = table.take("max");
    const auto low = min ? as_plain_number(reading_, *min) : std::optional(-kNone);
    const auto high = max ? as_plain_number(reading_, *max) : std::optional(kNone);
    const auto step = table.take("step");
    variable.range.step = step ? as_plain_number(reading_, *step).value_or(0) : 0;
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
    task_.variables.push_back(std::move(variable));
  }

  std::vector<Item> paths_in(const Item& item) {
    const auto* items = std::get_if<Array>(&item.value->content);
    if (items == nullptr) return {item};
    std::vector<Item> paths;
    for (std::size_t i = 0; i < items->size(); ++i) {
      paths.push_back({&(*items)[i], fmt::format("{}.{}", item.path, i)});
    }
    if (paths.empty()) report(reading_, item, "expected the path of a number, or a list of such paths");
    return paths;
  }

  void read_path(const Item& item, DesignTask::Variable& variable, std::optional<double>& start) {
    const auto path = as_text(reading_, item);
    if (!path) return;
    const Value* value = end_of_path(document_, *path).value;
    const auto number = value == nullptr ? std::nullopt : number_in(*value);
    if (!number || !is_designable(*path)) {
      report(reading_, item, no_number(*path, value));
      return;
    }
    for (const DesignTask::Variable& other : task_.variables) {
      if (std::find(other.paths.begin(), other.paths.end(), *path) != other.paths.end()) {
        report(reading_, item, fmt::format("this number is variable `{}` already", other.name));
      }
    }
    if (start && *start != *number) {
      report(
          reading_, item,
          fmt::format("this number is {} and the first one of this variable {}: numbers that are to be equal "
                      "have to be equal in the profile",
                      *number, *start));
    }
    start = start ? start : number;
    variable.paths.push_back(*path);
    if (const auto known = reading_.varied.find(*path); known != reading_.varied.end() && known->second) {
      variable.unit = unit_text(*known->second, reading_.units);
    }
  }

  [[nodiscard]] std::string no_number(const std::string& path, const Value* value) const {
    if (value != nullptr && std::holds_alternative<std::string>(value->content)) {
      return fmt::format(
          "this is {}, a text: write it as a number in the profile's unit to make it a variable",
          text_of(*value));
    }
    if (value != nullptr && !number_in(*value)) {
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
        std::floor(range.high / range.step + 1e-9) < std::ceil(range.low / range.step - 1e-9)) {
      report(reading_, *step, "no multiple of it lies between min and max");
    }
  }

  void read_options(TableReader& table) {
    if (const auto method = table.take("method")) {
      if (const auto choice = as_choice(reading_, *method, design_method_names())) {
        task_.method = static_cast<DesignMethod>(*choice);
      }
    }
    task_.keep_branch = table.flag("keep_branch", false);
    const auto count = [&](const std::string& key, std::int64_t least) -> std::optional<std::int64_t> {
      const auto item = table.take(key);
      const auto value = item ? as_integer(reading_, *item) : std::nullopt;
      if (value && (*value < least || *value > 1'000'000'000)) {
        report(reading_, *item, fmt::format("expected a number from {} to 1000000000", least));
        return std::nullopt;
      }
      return value;
    };
    if (const auto starts = count("starts", 1)) task_.starts = static_cast<int>(*starts);
    if (const auto seed = count("seed", 0)) task_.seed = static_cast<std::uint64_t>(*seed);
    task_.target = optional_plain_number(table, "target");
  }

  Reading& reading_;
  const Table& document_;
  const Profile& profile_;
  DesignTask task_;
};

}  // namespace

void read_design(TableReader& root, const Table& document, Profile& profile) {
  const auto item = root.take("design");
  const Table* content = item ? as_table(root.reading(), *item, "a design task (a table)") : nullptr;
  if (content == nullptr) return;
  TableReader table(root.reading(), *content, item->value->mark, item->path);
  profile.design =
      std::make_shared<const DesignTask>(DesignReader(root.reading(), document, profile).read(table));
}

}  // namespace higherpair::io_detail
