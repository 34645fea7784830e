#include "chain_variants.hpp"

#include "front/analysis_impl.hpp"
#include "front/design/design_columns.hpp"
#include "front/tolerances.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/description.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "higherpair/mechanism/redimension.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using Quantity = ChainColumn::Quantity;

constexpr std::int64_t kMostKeptRows = 1LL << 16;  // all of which are kept in memory

// In the order of kMotionEndings.
constexpr std::array kQuantities = {Quantity::kX,  Quantity::kY,  Quantity::kAngle,
                                    Quantity::kVx, Quantity::kVy, Quantity::kOmega,
                                    Quantity::kAx, Quantity::kAy, Quantity::kAlpha};

std::optional<ChainRecipe::Target> target_of(const Mechanism& mechanism, std::string_view path) {
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    for (std::size_t p = 0; p < body.points.size(); ++p) {
      const std::string place = fmt::format("bodies.{}.points.{}.", body.name, body.points[p].name);
      if (path.starts_with(place) && path.size() == place.size() + 1 &&
          (path.back() == '0' || path.back() == '1')) {
        return ChainRecipe::Target{b, p, path.back() - '0'};
      }
    }
  }
  return std::nullopt;
}

struct NamedColumn {
  ChainColumn column;
  Dimension dimension;
};

// As add_force_columns names them.
std::optional<NamedColumn> force_column_named(const Mechanism& mechanism, std::string_view name) {
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const Joint& joint = mechanism.joints[j];
    const int index = static_cast<int>(j);
    if (name == joint.name + ".fx") {
      return NamedColumn{{index, std::nullopt, Quantity::kForceX}, dimension::kForce};
    }
    if (name == joint.name + ".fy") {
      return NamedColumn{{index, std::nullopt, Quantity::kForceY}, dimension::kForce};
    }
    if (has_moment(joint.type) && name == joint.name + ".m") {
      return NamedColumn{{index, std::nullopt, Quantity::kMoment}, dimension::kTorque};
    }
  }
  for (std::size_t c = 0; c < mechanism.contacts.size(); ++c) {
    if (name == mechanism.contacts[c].name + ".force") {
      return NamedColumn{{static_cast<int>(c), std::nullopt, Quantity::kContactForce}, dimension::kForce};
    }
  }
  const Driver& driver = mechanism.drivers.front();
  const std::string prefix = driver_name(driver);
  const Dimension dimension = effort_dimension(driver_turns(mechanism));
  if (name == prefix + ".effort") {
    return NamedColumn{{0, std::nullopt, Quantity::kEffort}, dimension};
  }
  if (name == prefix + ".effort_check") {
    return NamedColumn{{0, std::nullopt, Quantity::kEffortByPower}, dimension};
  }
  return std::nullopt;
}

// Adds the column of this name unless it is already there; returns its index.
std::optional<std::size_t> add_column(const Mechanism& mechanism, const Units& units, const std::string& name,
                                      ChainRecipe& recipe) {
  const auto add = [&](ChainColumn column, const Dimension& dimension) {
    for (std::size_t i = 0; i < recipe.columns.size(); ++i) {
      const ChainColumn& other = recipe.columns[i];
      if (other.item == column.item && other.point == column.point && other.quantity == column.quantity) {
        return i;
      }
    }
    recipe.columns.push_back(column);
    recipe.scales.push_back(from_si(dimension, units));
    return recipe.columns.size() - 1;
  };
  if (const auto of = body_column(mechanism, units, name)) {
    if (of->body == kGround || of->minus != kGround) return std::nullopt;
    const auto point = of->point ? std::optional(static_cast<int>(*of->point)) : std::nullopt;
    return add({static_cast<int>(of->body), point, kQuantities[of->quantity]}, dimension_of(*of));
  }
  for (std::size_t c = 0; c < mechanism.contacts.size(); ++c) {
    if (name == fmt::format("{}.pressure", mechanism.contacts[c].name)) {
      return add({static_cast<int>(c), std::nullopt, Quantity::kPressure}, dimension::kAngle);
    }
  }
  const auto force = force_column_named(mechanism, name);
  return force ? std::optional(add(force->column, force->dimension)) : std::nullopt;
}

// Takes the driver's motion in all rows; false if the driver turns back, or its law jumps, between two rows.
bool take_rows(const DriverSchedule& schedule, bool in_time, ChainRecipe& recipe) {
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    if (!schedule.turning_points(k).empty() || !schedule.law_jumps(k).empty()) {
      return false;
    }
    const DriverState state = schedule.state(k);
    recipe.rows.push_back({state.si.position, state.si.velocity, state.si.acceleration});
    recipe.where.push_back(in_time ? schedule.time(k) : state.profile.position);
  }
  return true;
}

bool set_numbers(const ChainRecipe& recipe, std::span<const double> numbers, Mechanism& mechanism) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const ChainRecipe::Target& target = recipe.targets[i];
    const double value = recipe.to_si.apply(numbers[i]);
    if (!(std::abs(value) <= kLargestQuantity)) {
      return false;
    }
    mechanism.bodies[target.body].points[target.point].p_B[target.axis] = value;
  }
  return true;
}

bool same_rows(const std::vector<DriverMotion>& a, const std::vector<DriverMotion>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const DriverMotion& x, const DriverMotion& y) {
    return x.position == y.position && x.velocity == y.velocity && x.acceleration == y.acceleration;
  });
}

bool is_as_written(const ChainRecipe& recipe, std::span<const double> numbers, const Mechanism& read) {
  Mechanism written = recipe.mechanism;
  return set_numbers(recipe, numbers, written) && numbers_of(written) == numbers_of(read);
}

enum class Agreement { kNone, kUnknown, kFull };

// Whether a variant that is read equals what the recipe makes of its numbers; unknown if it cannot be read.
Agreement agreement(const ChainRecipe& recipe, std::span<const double> numbers, const RunSettings& run,
                    ModelVariants& models) {
  const Result<Model> read = models.with(numbers);
  if (!read) {
    return Agreement::kUnknown;
  }
  const auto schedule = schedule_of(read->data(), run);
  ChainRecipe other;
  const bool same = can_be_redimensioned(recipe.plan, read->mechanism()) &&
                    (!recipe.writes() || is_as_written(recipe, numbers, read->mechanism())) && schedule &&
                    take_rows(*schedule, run.in_time, other) && same_rows(recipe.rows, other.rows) &&
                    recipe.where == other.where;
  return same ? Agreement::kFull : Agreement::kNone;
}

// Over all tries: none if one of them disagrees, unknown if none can be read.
Agreement agreement(const ChainRecipe& recipe, std::span<const std::vector<double>> tries,
                    const RunSettings& run, ModelVariants& models) {
  Agreement all = Agreement::kUnknown;
  for (const std::vector<double>& numbers : tries) {
    const Agreement agrees = agreement(recipe, numbers, run, models);
    if (agrees == Agreement::kNone) {
      return agrees;
    }
    all = agrees == Agreement::kFull ? agrees : all;
  }
  return all;
}

// Numbers that may vary besides coordinates of points; variants must be read then.
bool may_vary(std::string_view path) {
  return path.starts_with("bodies.") || path.starts_with("loads.") || path.starts_with("springs.") ||
         path.starts_with("gravity");
}

// False where a number belongs to anything but bodies, loads, springs and gravity.
bool take_targets(std::span<const std::string> paths, ChainRecipe& recipe) {
  bool all = true;
  for (const std::string& path : paths) {
    if (const auto target = target_of(recipe.mechanism, path)) {
      recipe.targets.push_back(*target);
    } else if (may_vary(path)) {
      all = false;
    } else {
      return false;
    }
  }
  if (!all) {
    recipe.targets.clear();
  }
  return true;
}

}  // namespace

std::optional<ChainRecipe> ChainRecipe::of(const Model& model, std::span<const std::string> paths,
                                           const RunSettings& run, std::vector<Measure> measures,
                                           ModelVariants& models,
                                           std::span<const std::vector<double>> tries) {
  if (run.jerk || run.derivatives || !(run.tolerance >= kLeastChainTolerance) || !model.data().plan ||
      model.mechanism().drivers.size() != 1 || measures.empty()) {
    return std::nullopt;
  }
  const Units units = run.units.value_or(model.units());
  ChainRecipe recipe;
  recipe.mechanism = model.mechanism();
  recipe.plan = *model.data().plan;
  recipe.to_si = higherpair::to_si(dimension::kLength, model.units());
  recipe.measures = std::move(measures);
  if (!take_targets(paths, recipe)) {
    return std::nullopt;
  }
  for (const Measure& measure : recipe.measures) {
    const auto slot = add_column(recipe.mechanism, units, measure.column, recipe);
    if (!slot) {
      return std::nullopt;
    }
    recipe.slots.push_back(*slot);
  }
  const auto schedule = schedule_of(model.data(), run);
  if (!schedule || schedule->size() > kMostKeptRows || units != model.units() ||
      !take_rows(*schedule, run.in_time, recipe) ||
      !DyadChain::of(recipe.mechanism, recipe.plan, recipe.rows, recipe.columns)) {
    return std::nullopt;
  }
  Agreement agrees = agreement(recipe, tries, run, models);
  if (agrees == Agreement::kNone && recipe.writes()) {
    recipe.targets.clear();  // a number has more effect than a point, such as where a load acts
    agrees = agreement(recipe, tries, run, models);
  }
  return agrees == Agreement::kFull ? std::optional(std::move(recipe)) : std::nullopt;
}

std::optional<ChainVariants> ChainVariants::of(const ChainRecipe& recipe) {
  auto chain = DyadChain::of(recipe.mechanism, recipe.plan, recipe.rows, recipe.columns);
  return chain ? std::optional(ChainVariants(recipe, *std::move(chain))) : std::nullopt;
}

bool ChainVariants::solve(std::span<const double> numbers) {
  return set_numbers(*recipe_, numbers, mechanism_) && solve(mechanism_);
}

bool ChainVariants::solve(const Model& variant) {
  return variant.data().plan && solve(variant.mechanism());
}

bool ChainVariants::solve(const Mechanism& mechanism) {
  if (!chain_.solve(mechanism)) {
    return false;
  }
  // Values that overflow in the units of the table are undefined there.
  for (std::size_t i = 0; i < recipe_->columns.size(); ++i) {
    extremes_[i] = extremes_of(chain_.values(i));
    if (!std::isfinite(recipe_->scales[i].apply(extremes_[i].low)) ||
        !std::isfinite(recipe_->scales[i].apply(extremes_[i].high))) {
      return false;
    }
  }
  return true;
}

Measured ChainVariants::value(std::size_t measure, bool wants_where) const {
  const std::size_t slot = recipe_->slots[measure];
  const Series series{chain_.values(slot), extremes_[slot], recipe_->scales[slot], recipe_->where};
  return measured(recipe_->measures[measure], series, wants_where);
}

}  // namespace higherpair
