// [tolerances]: which numbers of the profile scatter, and which results of the run are wanted.
#include "higherpair/io/tasks.hpp"
#include "reading.hpp"
#include "sweep_reading.hpp"

#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {

double Tolerance::deviation() const {
  switch (kind) {
    case DistributionKind::kUniform:
      return half() / std::sqrt(3.0);
    case DistributionKind::kTriangular:
      return half() / std::sqrt(6.0);
    default:
      return half() / sigmas;
  }
}

Distribution Tolerance::distribution() const {
  Distribution d;
  d.kind = kind;
  if (kind == DistributionKind::kNormal) {
    d.mean = middle();
    d.deviation = deviation();
  } else {
    d.low = value - minus;
    d.high = value + plus;
    d.mode = middle();
  }
  return d;
}

VariantPlan ToleranceTask::variants() const {
  VariantPlan plan;
  plan.method = SweepMethod::kRandom;
  plan.correlations = correlations;
  for (const Tolerance& tolerance : tolerances) {
    plan.variables.push_back({tolerance.name, tolerance.paths, tolerance.distribution(), 0});
  }
  return plan;
}

namespace io_detail {
namespace {

constexpr std::string_view kOneTolerance = "tolerance, NAME = { path = …, plus_minus = … }";

// Keys of [tolerances] that name no tolerance.
bool is_own_key(std::string_view key) {
  return key == "results" || key == "correlations" || key == "time";
}

class ToleranceReader {
public:
  ToleranceReader(Reading& reading, const Table& document)
      : reading_(reading), document_(document), paths_{document, {}, "tolerances"} {}

  Tolerance read(const std::string& name, TableReader& table) {
    Tolerance tolerance;
    tolerance.name = name;
    tolerance.place = place_of(reading_, table.mark());
    SweepVariable variable;
    const Mistakes mistakes(reading_);
    read_paths(table, paths_, variable);
    tolerance.paths = std::move(variable.paths);
    dimension_ = {};
    if (mistakes.none()) read_values(table, tolerance);
    tolerance.unit = unit_text(dimension_, reading_.units);
    read_zone(table, tolerance);
    read_distribution(table, tolerance);
    table.finish();
    return tolerance;
  }

private:
  // Reads the numbers at all paths: they must be equal and of one dimension.
  void read_values(TableReader& table, Tolerance& tolerance) {
    const auto item = table.take("path");
    for (std::size_t i = 0; i < tolerance.paths.size(); ++i) {
      const std::string& path = tolerance.paths[i];
      const auto dimension = varied_dimension(reading_, path);
      if (!dimension) {
        report(reading_, *item, fmt::format("{} is no dimension of the mechanism: it cannot scatter", path));
        return;
      }
      const auto value = number_read(reading_, *end_of_path(document_, path).value);
      if (!value) return;  // reported where the number is read
      if (i > 0 && (*value != tolerance.value || *dimension != dimension_)) {
        report(reading_, *item,
               fmt::format("{} is {} and {} is {}: numbers with one tolerance are equal in the profile",
                           tolerance.paths.front(), tolerance.value, path, *value));
        return;
      }
      tolerance.value = *value;
      dimension_ = *dimension;
    }
  }

  void read_zone(TableReader& table, Tolerance& tolerance) {
    // A mistake is reported, and then any zone will do.
    const auto number = [&](const std::optional<Item>& item) -> std::optional<double> {
      if (!item) return 0;
      const auto quantity = as_quantity(reading_, *item, {dimension_});
      return quantity ? std::optional(quantity->profile) : std::nullopt;
    };
    const auto plus = table.take("plus");
    const auto minus = table.take("minus");
    tolerance.plus = tolerance.minus = 1;
    if (!plus && !minus) {
      const auto both =
          table.need("plus_minus", "how far the number may be off to either side, or `plus` and `minus`");
      const auto half = both ? number(both) : std::nullopt;
      if (half && !(*half > 0)) {
        report(reading_, *both, "must be > 0");
      } else if (half) {
        tolerance.plus = tolerance.minus = *half;
      }
      return;
    }
    table.refuse("plus_minus", "this and `plus`, `minus` say the same: leave one of the two out");
    const auto high = number(plus), low = number(minus);
    if (high && low && !(*high + *low > 0)) {
      report(reading_, plus ? *plus : *minus,
             fmt::format("the zone from {} - {} to {} + {} is empty: plus + minus must be > 0",
                         tolerance.value, *low, tolerance.value, *high),
             plus && minus ? "" : table.path_to(plus ? "minus" : "plus"));
    } else if (high && low) {
      tolerance.plus = *high;
      tolerance.minus = *low;
    }
  }

  void read_distribution(TableReader& table, Tolerance& tolerance) {
    const auto choice = table.take("distribution", as_choice, {"normal", "uniform", "triangular"});
    constexpr DistributionKind kKinds[] = {DistributionKind::kNormal, DistributionKind::kUniform,
                                           DistributionKind::kTriangular};
    tolerance.kind = kKinds[choice.value_or(0)];
    if (tolerance.kind != DistributionKind::kNormal) {
      table.refuse("sigmas", "belongs to a normal distribution");
      return;
    }
    if (const auto sigmas = table.take("sigmas")) {
      const auto number = as_quantity(reading_, *sigmas, {dimension::kNumber, Sign::kPositive});
      tolerance.sigmas = number ? number->si : 3;
    }
  }

  Reading& reading_;
  const Table& document_;
  SweepPaths paths_;
  Dimension dimension_;  // of the number being read
};

void read_results_of(TableReader& table, const Mechanism& mechanism, ToleranceTask& task) {
  read_results(table, unit_of_place(mechanism, task.in_time),
               [&](const std::string& name, const std::optional<Measure>& measure, TableReader& entry) {
                 ToleranceResult result;
                 result.name = name;
                 result.measure = measure.value_or(Measure());
                 result.within =
                     entry.take("within", as_positive_in,
                                unit_of_column(entry.reading(), mechanism, result.measure.column));
                 task.results.push_back(std::move(result));
               });
}

void read_correlations_of(TableReader& table, ToleranceTask& task) {
  VariantPlan plan = task.variants();
  read_correlations(table, {"tolerance", "tolerances with distribution = \"normal\"", "tolerances"}, plan);
  task.correlations = std::move(plan.correlations);
}

}  // namespace

void read_tolerances(TableReader& root, const Table& document, Profile& profile) {
  const auto read = [&](const Item& item, TableReader& table, ToleranceTask& task) {
    Reading& reading = table.reading();
    const Mistakes mistakes(reading);
    task.in_time = table.flag("time", false);
    ToleranceReader reader(reading, document);
    const std::string what = fmt::format("a {}", kOneTolerance);
    for_each_named(reading, item, what, [&](const std::string& name, const Item& entry) {
      if (is_own_key(name)) return;
      read_named_table(reading, name, entry, what, [&](const std::string&, TableReader& one) {
        task.tolerances.push_back(reader.read(name, one));
      });
    });
    read_correlations_of(table, task);
    read_results_of(table, profile.mechanism, task);
    if (mistakes.none() && task.tolerances.empty()) {
      report(reading, item, fmt::format("expected at least one {}", kOneTolerance));
    }
  };
  profile.tolerances = read_task<ToleranceTask>(root, "tolerances", read);
}

}  // namespace io_detail
}  // namespace higherpair
