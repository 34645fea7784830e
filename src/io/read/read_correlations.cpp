#include "sweep_reading.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

std::optional<std::size_t> variable_named(TableReader& table, const Item& item, const CorrelationWords& words,
                                          const VariantPlan& plan) {
  const auto name = as_text(table.reading(), item);
  if (!name) {
    return std::nullopt;
  }
  const auto index =
      named_thing(table.reading(), item, *name, "there is no " + words.one, plan.variables, words.home);
  if (!index) {
    return std::nullopt;
  }
  const Distribution& d = plan.variables[*index].distribution;
  if (d.kind != DistributionKind::kNormal || d.is_truncated()) {
    report(table.reading(), item, fmt::format("only {} can be correlated", words.possible));
    return std::nullopt;
  }
  return static_cast<std::size_t>(*index);
}

std::optional<std::pair<std::size_t, std::size_t>> read_between(TableReader& table,
                                                                const CorrelationWords& words,
                                                                const VariantPlan& plan) {
  const std::string expected = fmt::format("the names of two {}s", words.one);
  const auto item = table.need("between", expected);
  const auto items = item ? as_items(table.reading(), *item, expected, 2, 2) : std::nullopt;
  if (!items) {
    return std::nullopt;
  }
  const auto first = variable_named(table, items->front(), words, plan);
  const auto second = variable_named(table, items->back(), words, plan);
  if (!first || !second) {
    return std::nullopt;
  }
  const auto is_same = [&](const Correlation& other) {
    return std::minmax(other.first, other.second) == std::minmax(*first, *second);
  };
  if (*first == *second) {
    report(table.reading(), *item, fmt::format("expected two different {}s", words.one));
  } else if (std::any_of(plan.correlations.begin(), plan.correlations.end(), is_same)) {
    report(table.reading(), *item, "another correlation is between these two already");
  } else {
    return std::pair(*first, *second);
  }
  return std::nullopt;
}

void read_correlation(TableReader& table, const CorrelationWords& words, VariantPlan& plan) {
  const auto between = read_between(table, words, plan);
  const auto covariance = table.take("covariance");
  const auto coefficient = covariance
                               ? table.take("coefficient")
                               : table.need("coefficient", "a number between -1 and 1, or a `covariance`");
  if (covariance && coefficient) {
    report(table.reading(), *covariance, "this and `coefficient` say the same: leave one of the two out");
    table.finish();
    return;
  }
  const auto item = covariance ? covariance : coefficient;
  const auto unit_at = [&](std::size_t i) { return unit_of_paths(table.reading(), plan.variables[i].paths); };
  const NumberUnit unit =
      covariance && between ? product_of(unit_at(between->first), unit_at(between->second)) : no_unit();
  const auto given = item ? as_number_in(table.reading(), *item, unit) : std::nullopt;
  table.finish();
  if (!between || !given) {
    return;
  }
  const double number = *given;
  const auto deviation = [&](std::size_t i) { return plan.variables[i].distribution.deviation; };
  const double scale = covariance ? deviation(between->first) * deviation(between->second) : 1;
  if (!(std::abs(number) < scale)) {
    report(table.reading(), *item,
           fmt::format("must lie between {} and {}{}; {}s that are the same are one with several paths",
                       -scale, scale, covariance ? ", the product of both deviations" : "", words.one));
    return;
  }
  plan.correlations.push_back({between->first, between->second, number / scale});
}

}  // namespace

void read_correlations(TableReader& task, const CorrelationWords& words, VariantPlan& plan) {
  const auto item = task.take("correlations");
  const auto items =
      item ? as_items(task.reading(), *item, "a list of { between = [\"a\", \"b\"], coefficient = … }", 0)
           : std::nullopt;
  if (!items) {
    return;
  }
  for (const Item& entry : *items) {
    if (auto table = as_reader(task.reading(), entry, "a correlation (a table)")) {
      read_correlation(*table, words, plan);
    }
  }
  if (!correlation_factor(plan)) {
    report(
        task.reading(), *item,
        fmt::format("these contradict each other: no {}s can be correlated like this; bring the coefficients "
                    "nearer to 0",
                    words.one));
  }
}

}  // namespace higherpair::io_detail
