#include "higherpair/sweep/tolerances.hpp"
#include "sweep_reading.hpp"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

void wrong(TableReader& table, const std::string& key, std::string_view rule) {
  const auto item = table.take(key);
  if (item) report(table.reading(), *item, rule);
}

void read_values(TableReader& table, const NumberUnit& unit, Distribution& d) {
  d.kind = DistributionKind::kValues;
  d.values = table.take("values", as_numbers_in, unit, 0).value_or(std::vector<double>{0});
  if (d.values.empty()) {
    wrong(table, "values", "expected at least one");
    d.values.push_back(0);
  }
}

void read_limits(TableReader& table, const NumberUnit& unit, Distribution& d) {
  const Mistakes mistakes(table.reading());
  for (const auto& [key, limit] : {std::pair("min", &d.low), std::pair("max", &d.high)}) {
    *limit = table.take(key, as_number_in, unit).value_or(*limit);
  }
  if (mistakes.none() && !(d.low < d.high)) {
    wrong(table, "max", fmt::format("must be larger than min = {}", d.low));
  }
}

void read_normal(TableReader& table, const NumberUnit& unit, Distribution& d) {
  d.kind = DistributionKind::kNormal;
  if (const auto list = table.take("normal", as_numbers_in, unit, 2)) {
    d.mean = (*list)[0];
    d.deviation = (*list)[1];
    if (!(d.deviation > 0)) {
      wrong(table, "normal", "expected [mean, standard deviation], and a deviation above 0");
      d.deviation = 1;
    }
  }
  read_limits(table, unit, d);
  if (d.deviation > 0 && d.low < d.high && share_within(d) < kLeastShareWithin) {
    wrong(table, "normal", "next to nothing of this distribution lies between min and max");
  }
}

void read_triangular(TableReader& table, const NumberUnit& unit, Distribution& d) {
  d.kind = DistributionKind::kTriangular;
  const auto list = table.take("triangular", as_numbers_in, unit, 3);
  const std::vector<double> ends = list.value_or(std::vector<double>{0, 0.5, 1});
  d.low = ends[0];
  d.mode = ends[1];
  d.high = ends[2];
  if (!(d.low < d.high && d.low <= d.mode && d.mode <= d.high)) {
    wrong(table, "triangular", "expected [least, most likely, largest value], in this order");
  }
}

void read_uniform(TableReader& table, const NumberUnit& unit, Distribution& d) {
  if (const auto list = table.take("uniform", as_numbers_in, unit, 2)) {
    d.low = (*list)[0];
    d.high = (*list)[1];
    if (!(d.low < d.high)) {
      wrong(table, "uniform", "expected [least, largest value], in this order");
    }
  }
}

constexpr std::array kForms = {"values", "normal", "triangular", "uniform", "min"};

// The key that gives the values of a variable; "" if there is none or more than one.
std::string form_of(TableReader& table, const Item& item) {
  std::vector<std::string> forms;
  for (const char* form : kForms) {
    const bool limit_of_normal =
        std::string_view(form) == "min" && !forms.empty() && forms.front() == "normal";
    if (table.take(form) && !limit_of_normal) forms.emplace_back(form);
  }
  if (forms.size() == 1) {
    return forms.front();
  }
  table.knows({"max"});
  table.reading().mistakes.push_back(
      {item.value->mark,
       fmt::format("{}: expected {} `values`, `min` and `max`, `normal`, `triangular`, `uniform`",
                   path_of(table.reading(), item), forms.empty() ? "one of" : "only one of")});
  return "";
}

}  // namespace

void read_distribution(TableReader& table, const Item& item, std::optional<SweepMethod> method,
                       const NumberUnit& unit, SweepVariable& variable) {
  const std::string form = form_of(table, item);
  const bool values = form.empty() || form == "values";
  std::string_view objection;
  if (method == SweepMethod::kGrid && !values && form != "min") {
    objection = "a grid takes `values`, or `min`, `max` and `count`; distributions are for random and sobol";
  } else if (method == SweepMethod::kList && !values) {
    objection = "a list takes `values`";
  }
  if (!objection.empty()) {
    table.refuse(form, objection);
    table.knows({"min", "max", "count"});
    return;
  }
  Distribution& d = variable.distribution;
  if (form == "values") {
    read_values(table, unit, d);
  } else if (form == "normal") {
    read_normal(table, unit, d);
  } else if (form == "triangular") {
    read_triangular(table, unit, d);
  } else if (form == "uniform") {
    read_uniform(table, unit, d);
  } else if (form == "min" && table.need("max", "the largest value")) {
    read_limits(table, unit, d);
  }
  const bool spaced = method == SweepMethod::kGrid && form == "min";
  if (spaced) {
    variable.count =
        table.need("count", "how many values from min to max a grid takes", as_count, {1, kMostVariants})
            .value_or(1);
  } else if (method) {
    table.refuse("count", "belongs to `min` and `max` of a grid");
  } else {
    table.knows({"count"});
  }
}

}  // namespace higherpair::io_detail
