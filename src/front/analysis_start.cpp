// From a model and settings to a run before its first row.
#include "analysis_impl.hpp"
#include "demands.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/notes.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

Error input_error(Diagnostics mistakes) {
  return {ErrorKind::kInput, std::move(mistakes)};
}

// At this many rows, up to twice as many, rolling pairs and the travel of drivers are checked before a run.
constexpr std::int64_t kSampledRows = 1000;

std::string text_of(const Slip& slip, const Profile& profile) {
  const Dimension dimension = driver_dimension(profile.mechanism);
  const Dimension per_unit = dimension::kLength / dimension;
  return fmt::format(
      "contacts.{}: this pair cannot roll: at driver = {} {} it would have to slip by {} {} of the driver; "
      "set rolling = false, or choose curves and joints whose contact point stays at the instant centre",
      profile.mechanism.contacts[slip.contact].name, from_si(dimension, profile.units).apply(slip.driver),
      unit_text(dimension, profile.units), from_si(per_unit, profile.units).apply(std::abs(slip.velocity)),
      unit_text(per_unit, profile.units));
}

// Driver positions over the whole run, in SI units.
std::vector<double> some_positions(const DriverSchedule& schedule) {
  std::vector<double> positions;
  const std::int64_t stride = std::max<std::int64_t>(1, schedule.size() / kSampledRows);
  for (std::int64_t k = 0; k < schedule.size(); k += stride) {
    positions.push_back(schedule.state(k).si.position);
  }
  return positions;
}

}  // namespace

bool can_be_position(double position, const Dimension& of_driver, const Units& units) {
  const double si = to_si(of_driver, units).apply(position);
  return of_driver == dimension::kAngle ? is_sharp_angle(si) : std::abs(si) <= kLargestQuantity;
}

std::string_view farthest_position(const Dimension& of_driver) {
  return of_driver == dimension::kAngle ? "1e9 turns" : "1e50 m";
}

Result<DriverSchedule> schedule_of(const Model::Data& model, const RunSettings& settings) {
  const auto refuse = [&](const std::string& rule) { return wrong(model, "setting " + rule); };
  if (std::string fault =
          first_unmet({within(3, kHighestDerivative, "setting derivatives", settings.derivatives.value_or(3)),
                       positive("setting tolerance", settings.tolerance)});
      !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  if (std::string fault = fault_of(settings.units.value_or(model.profile.units)); !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  const auto made = [&](const Profile& profile) {
    return (settings.in_time ? DriverSchedule::step(profile, settings.samples)
                             : DriverSchedule::analyze(profile, settings.samples))
        .map_error(input_error);
  };
  if (settings.positions.empty()) {
    return made(model.profile);
  }
  if (settings.in_time || model.profile.programs.size() != 1) {
    return refuse("positions: only for a single driver, and not in time");
  }
  const Dimension of_driver = driver_dimension(model.profile.mechanism);
  for (const double position : settings.positions) {
    if (!can_be_position(position, of_driver, model.profile.units)) {
      return refuse(
          fmt::format("positions {}: is not finite, or beyond {}", position, farthest_position(of_driver)));
    }
  }
  Profile other = model.profile;
  other.programs.front().positions = settings.positions;
  return made(other);
}

namespace {

// How far a driver goes from its first position.
double travel_of(const DriverSchedule& schedule, std::size_t driver) {
  const auto position = [&](std::int64_t row) { return schedule.state(row, driver).si.position; };
  const std::int64_t last = schedule.size() - 1;
  const std::int64_t stride =
      schedule.is_listed() ? 1 : std::max<std::int64_t>(1, schedule.size() / kSampledRows);
  double travel = std::abs(position(last) - position(0));
  for (std::int64_t row = 0; row < last; row += stride) {
    travel = std::max(travel, std::abs(position(row) - position(0)));
  }
  return travel;
}

// Named in the messages below.
static_assert(kMostDriverTurns == 1e7 && kLongestDriverSlide == 1e7);

// The objection to a driver that moves this far in all [rad or m]; empty if there is none.
std::string travel_objection(const Model::Data& model, std::size_t driver, double travel) {
  const Profile& profile = model.profile;
  const std::string name = driver_name(profile.mechanism.drivers[driver]);
  const auto length = [&](double metres) { return with_unit(metres, dimension::kLength, profile.units); };
  const double longest = kLongestDriverSlide * model.plan->size;
  if (driver_turns(profile.mechanism, driver)) {
    const double turns = travel / (2 * kPi);
    return turns <= kMostDriverTurns ? ""
                                     : fmt::format(
                                           "{} goes {:.6g} turns in all; at most 1e7 turns can be followed; "
                                           "change its `end`, `positions` or `duration`",
                                           name, turns);
  }
  return travel <= longest
             ? ""
             : fmt::format(
                   "{} goes {} in all; at most {}, 1e7 times the size of the mechanism, can "
                   "be followed (the largest distance of its points, or {} where they coincide); change its "
                   "`end`, `positions` or `duration`",
                   name, length(travel), length(longest), length(1));
}

std::optional<Error> refuse_long_travel(const Model::Data& model, const DriverSchedule& schedule) {
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    std::string objection = travel_objection(model, i, schedule.travel(i));
    if (!objection.empty()) {
      const char* key = schedule.is_timed() ? "duration" : schedule.is_listed() ? "positions" : "end";
      return Error{ErrorKind::kInput, {{model.profile.programs[i].place_of(key), std::move(objection)}}};
    }
  }
  return std::nullopt;
}

Result<Run> started(const Model::Data& model, const RunSettings& settings, const DriverSchedule& schedule) {
  const auto refuse = [&](std::string reason) {
    return tl::unexpected(error_about(model, ErrorKind::kMechanism, std::move(reason)));
  };
  if (auto refusal = refuse_long_travel(model, schedule)) {
    return tl::unexpected(*std::move(refusal));
  }
  auto run = start_run(run_model(model), schedule.first_positions(), settings.tolerance);
  if (!run) {
    return refuse(run.error().slip
                      ? text_of(*run.error().slip, model.profile)
                      : run.error().reason + start_advice(model.profile, schedule.first_positions(),
                                                          settings.tolerance, settings.stop));
  }
  run->stop = settings.stop;
  const auto& contacts = model.profile.mechanism.contacts;
  if (std::any_of(contacts.begin(), contacts.end(), [](const Contact& contact) { return contact.rolling; })) {
    if (const auto slip = find_slip(*run, some_positions(schedule))) {
      return refuse(text_of(*slip, model.profile));
    }
  }
  return *std::move(run);
}

}  // namespace

Result<ColumnSet> columns_of(const Model::Data& model, const RunSettings& settings, const Units& units) {
  ColumnSet columns(units, settings.columns);
  const Mechanism& mechanism = model.profile.mechanism;
  add_motion_columns(columns, model.profile, units, settings.in_time);
  if (settings.forces) {
    add_force_columns(columns, mechanism);
  }
  add_status_columns(columns);
  if (settings.jerk) {
    add_jerk_columns(columns, model.profile, *model.plan);
  }
  if (settings.derivatives) {
    add_derivative_columns(columns, mechanism, *settings.derivatives);
  }
  if (auto done = columns.finish(model.profile.source); !done) {
    return wrong({std::move(done.error())});
  }
  return columns;
}

namespace {

std::optional<Error> refuse_without_driver(const Model::Data& model) {
  if (!model.profile.mechanism.drivers.empty()) {
    return std::nullopt;
  }
  return error_about(model, ErrorKind::kMechanism,
                     driver_objection(model.profile.mechanism, std::vector<double>{})
                         .value_or("no driver: nothing moves this mechanism; `mobility` says what it is"));
}

}  // namespace

Result<DriverSchedule> first_schedule(const Model::Data& model) {
  if (auto refusal = refuse_without_driver(model)) {
    return tl::unexpected(*std::move(refusal));
  }
  return DriverSchedule::analyze(model.profile).map_error(input_error);
}

void set_travels(Profile& profile) {
  Mechanism& mechanism = profile.mechanism;
  std::optional<DriverSchedule> schedule;
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    double& travel = mechanism.drivers[i].travel;
    travel = 0;
    if (driver_turns(mechanism, i)) continue;
    if (!schedule) {
      auto made = DriverSchedule::analyze(profile);
      if (!made) continue;
      schedule = *std::move(made);
    }
    travel = travel_of(*schedule, i);
  }
}

std::optional<Error> refuse_to_start(const Model::Data& model) {
  auto refusal = refuse_without_driver(model);
  if (!refusal && !model.plan) {
    refusal = error_about(model, ErrorKind::kMechanism, model.plan.error());
  }
  return refusal;
}

std::optional<RunSettings> settings_with_columns(const Model::Data& model, const RunSettings& settings) {
  for (const auto& [forces, jerk] : {std::pair(false, false), {true, false}, {false, true}, {true, true}}) {
    RunSettings more = settings;
    more.forces = more.forces || forces;
    more.jerk = more.jerk || jerk;
    if (columns_of(model, more, more.units.value_or(model.profile.units))) return more;
  }
  return std::nullopt;
}

Result<Analysis> Model::start(const RunSettings& settings) const {
  if (auto refusal = refuse_without_driver(*data_)) {
    return tl::unexpected(*std::move(refusal));
  }
  auto schedule = schedule_of(*data_, settings);
  if (!schedule) {
    return tl::unexpected(std::move(schedule.error()));
  }
  if (auto refusal = refuse_to_start(*data_)) {
    return tl::unexpected(*std::move(refusal));
  }
  const Units units = settings.units.value_or(data_->profile.units);
  auto columns = columns_of(*data_, settings, units);
  if (!columns) {
    return tl::unexpected(std::move(columns.error()));
  }
  auto run = started(*data_, settings, *schedule);
  if (!run) {
    return tl::unexpected(std::move(run.error()));
  }
  Diagnostics notes = start_notes(data_->profile, run->at.state.bodies);
  for (Diagnostic& note : direction_notes(data_->profile, *schedule)) {
    notes.push_back(std::move(note));
  }
  if (settings.forces && !has_forces(data_->profile.mechanism)) {
    notes.push_back(
        about(data_->profile.source,
              "nothing loads the mechanism: no body has a mass, and there are no loads and no springs; "
              "all forces are 0"));
  }
  auto impl =
      make_impl(data_, units, *std::move(schedule), *std::move(run), *std::move(columns), settings.forces);
  impl->notes = std::move(notes);
  const auto& contacts = data_->profile.mechanism.contacts;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (contacts[i].keep == Keep::kGap && !impl->run.at.state.contacts[i].touches) {
      impl->open.push_back(i);
    }
  }
  if (impl->schedule.size() > kBlockRows) {
    impl->scout.emplace(impl->run);
  }
  return Analysis(std::move(impl));
}

}  // namespace higherpair
