#include "design_candidates.hpp"

#include "design_direct.hpp"
#include "front/analysis_impl.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/redimension.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {

DesignCandidates::DesignCandidates(const DesignSetup& setup)
    : setup_(&setup), pins_(PinnedRows::of(setup)), run_slopes_(RunSlopes::of(setup)) {
  direct_ = setup.numbers.is_linear() && DirectMotion::is_possible(*setup.numbers.model().data().plan);
  const auto& objectives = setup.numbers.task().objectives;
  any_position_ = std::any_of(objectives.begin(), objectives.end(), [](const auto& objective) {
    return objective.path() && !objective.path()->timed;
  });
}

void DesignCandidates::work_out(std::span<const double> x, int branch) {
  work_out_rows(x, branch);
  add_quantities(x, branch);
}

void DesignCandidates::work_out_rows(std::span<const double> x, int branch) {
  if (pins_) {
    pins_->work_out(x, branch, rows_);
    if (rows_.missing == 0 && any_position_) place_directly(x, branch);
  } else if (direct_) {
    rows_.restart();
    auto candidate = candidate_of(x, false);
    candidate ? place_rows(*setup_, std::move(candidate->mechanism), candidate->plan, branch, rows_) : fail();
  }
  if ((pins_ || direct_) && (rows_.missing > 0 || !setup_->needs_table())) {
    if (pins_ && rows_.missing == 0 && setup_->needs_extents()) add_extents(x, branch);
    return;
  }
  const auto candidate = candidate_of(x, setup_->needs_table());
  if (!candidate) {
    fail();
    return;
  }
  // A candidate that passes in closed form and fails when it is followed is close to a limit position, where
  // each row is expensive.
  const WhenLost when_lost = pins_ || direct_ ? WhenLost::kGiveUp : WhenLost::kLookFurther;
  if (!pins_) {
    follow_rows(*setup_, *candidate, branch, when_lost, rows_);
    return;
  }
  // Gaps, transmissions and paths from the pins are kept: their exact derivatives are known.
  DesignRows followed;
  follow_rows(*setup_, *candidate, branch, when_lost, followed);
  std::swap(rows_.measured, followed.measured);
  std::swap(rows_.extents, followed.extents);
  std::swap(rows_.table, followed.table);
  std::swap(rows_.table_slots, followed.table_slots);
  std::swap(rows_.places, followed.places);
  rows_.table_columns = followed.table_columns;
  rows_.started = rows_.started && followed.started;
  rows_.missing = std::max(rows_.missing, followed.missing);
  rows_.run = std::move(followed.run);
}

std::optional<DesignSlopes> DesignCandidates::slopes(std::span<const double> x, int branch,
                                                     std::span<const std::vector<SlopePlace>> places) const {
  if (!run_slopes_ || !rows_.started || rows_.missing > 0) {
    return std::nullopt;
  }
  const auto candidate = candidate_of(x, setup_->needs_table());
  return candidate ? run_slopes_->of_candidate(x, *candidate, branch, rows_, places, !pins_) : std::nullopt;
}

// The candidate's model with the poses that it has on the branch.
Result<Model> DesignCandidates::model_of(std::span<const double> x, int branch) const {
  auto model = setup_->numbers.model_of(x);
  if (!model || !model->data().plan) {
    return model;
  }
  const auto schedule = schedule_of(model->data(), setup_->settings);
  const auto run = schedule ? start_on_branch(run_model(model->data()), schedule->first_positions(), branch)
                            : std::nullopt;
  if (!run) {
    return model;
  }
  Mechanism posed = model->mechanism();
  for (std::size_t i = 1; i < posed.bodies.size(); ++i) {
    posed.bodies[i].guess_p_WB = run->at.state.bodies[i].X_WB.p_WB;
    posed.bodies[i].guess_theta = run->at.state.bodies[i].theta;
  }
  return model->with_mechanism(std::move(posed));
}

std::optional<Mechanism> DesignCandidates::mechanism_of(std::span<const double> x) const {
  if (setup_->numbers.is_linear()) {
    return setup_->numbers.mechanism_of(x);
  }
  const auto model = setup_->numbers.model_of(x);
  return model ? std::optional(model->mechanism()) : std::nullopt;
}

// Adds the quantities other than measures and events: figures, extents and Grashof margins.
void DesignCandidates::add_quantities(std::span<const double> x, int branch) {
  const std::vector<DesignQuantity>& quantities = setup_->quantities;
  rows_.measured.resize(setup_->numbers_measured, kNoValue);
  if (setup_->needs_check() && rows_.missing == 0) {
    const auto model = model_of(x, branch);
    const std::vector<double> figures = model ? figures_of(*model, quantities) : std::vector<double>();
    for (std::size_t k = 0; k < figures.size(); ++k) {
      if (quantities[k].as<DesignTask::Figure>()) rows_.measured[quantities[k].first] = figures[k];
    }
  }
  const Scaling length = from_si(dimension::kLength, setup_->numbers.model().units());
  for (std::size_t k = 0, extent = 0; extent < rows_.extents.size(); ++k) {
    const auto* of = quantities[k].as<DesignTask::Extent>();
    if (of == nullptr) continue;
    double sum = 0;
    for (const ExtentTerm& term : terms_that_count(*of, rows_.extents[extent])) sum += term.far;
    rows_.measured[quantities[k].first] = length.apply(sum);
    ++extent;
  }
  std::optional<Mechanism> mechanism;
  for (const DesignQuantity& quantity : quantities) {
    const auto* grashof = quantity.as<DesignTask::Grashof>();
    if (grashof == nullptr) continue;
    if (!mechanism) mechanism = mechanism_of(x);
    if (!mechanism) return;
    if (const auto room = grashof_room(*mechanism, *grashof)) {
      rows_.measured[quantity.first] = length.apply(*room);
    }
  }
}

// Prepares the motion in closed form, for places between the rows of pins.
void DesignCandidates::place_directly(std::span<const double> x, int branch) {
  if (auto candidate = candidate_of(x, false)) {
    rows_.mechanism = std::move(candidate->mechanism);
    rows_.direct.emplace(*rows_.mechanism, std::move(candidate->plan), branch);
  }
}

// Computes the extents for a linkage of pins without a table: they need the bodies, which pins do not
// position.
void DesignCandidates::add_extents(std::span<const double> x, int branch) {
  if (auto candidate = candidate_of(x, false)) {
    DesignRows placed;
    place_rows(*setup_, std::move(candidate->mechanism), candidate->plan, branch, placed);
    std::swap(rows_.extents, placed.extents);
  }
}

std::size_t closure_count(const Plan& plan) {
  return static_cast<std::size_t>(std::count_if(
      plan.groups.begin(), plan.groups.end(), [](const Group& group) { return traits_of(group).two_modes; }));
}

void DesignCandidates::fail() {
  rows_.restart();
  rows_.missing = 1;
  rows_.gaps.assign(setup_->closures, setup_->size);
}

std::optional<DesignCandidate> DesignCandidates::candidate_of(std::span<const double> x,
                                                              bool with_data) const {
  const DesignSetup& setup = *setup_;
  const bool linear = setup.numbers.is_linear();
  const auto data = linear && !with_data ? nullptr : setup.numbers.data_of(x);
  if (!data && (!linear || with_data)) return std::nullopt;
  if (data && !data->plan) return std::nullopt;
  auto schedule = linear ? Result<DriverSchedule>(setup.schedule) : schedule_of(*data, setup.settings);
  if (!schedule) return std::nullopt;
  auto mechanism =
      std::make_unique<const Mechanism>(data ? data->profile.mechanism : setup.numbers.mechanism_of(x));
  auto plan = data ? data->plan : plan_like(*setup.numbers.model().data().plan, *mechanism);
  // With other groups it would be another mechanism, with other constraints.
  if (!plan || closure_count(*plan) != setup.closures) return std::nullopt;
  return DesignCandidate{data, std::move(mechanism), *std::move(plan), *std::move(schedule)};
}

}  // namespace higherpair
