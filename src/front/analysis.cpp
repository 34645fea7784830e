#include "analysis_impl.hpp"
#include "demands.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/notes.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
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
  if (has_angle(driven_joint(profile.mechanism, driver).type)) {
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
  if (auto done = columns.finish(model.name); !done) {
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
  const auto turns = [&](std::size_t i) { return has_angle(driven_joint(mechanism, i).type); };
  std::optional<DriverSchedule> schedule;
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    double& travel = mechanism.drivers[i].travel;
    travel = 0;
    if (turns(i)) continue;
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

void Analysis::Impl::read_drivers() {
  drivers.resize(schedule.driver_count());
  motions.resize(schedule.driver_count());
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    drivers[i] = schedule.state(next, i);
    motions[i] = {drivers[i].si.position, drivers[i].si.velocity, drivers[i].si.acceleration};
  }
}

bool Analysis::Impl::next_row(Row& row) {
  if (next == schedule.size() || is_stopped(run)) {
    return false;
  }
  if (scout && next > 0 && next % kBlockRows == 0) {
    begin_block();
  }
  read_drivers();
  move();
  if (is_stopped(run)) {
    return false;
  }
  reactions = dynamics ? &dynamics->solve(run) : nullptr;
  note_idle_moments();
  history.note(run);
  RowSource source{run, drivers, schedule.time(next), reactions, false, &history};
  source.opens = source.reactions != nullptr && run.row.status == RowStatus::kOk && source.reactions->opens();
  columns.fill(source, row.values);
  row.number = next;
  row.status = source.status();
  note_status(row.status);
  return advance(next + 1);
}

void Analysis::Impl::note_idle_moments() {
  if (reactions == nullptr || !reactions->defined) {
    return;
  }
  const Statics& statics = dynamics->statics();
  for (std::size_t i = 0; i < statics.holding_count(); ++i) {
    const Statics::Holding holding = statics.holding(i);
    IdleMoment& largest = found.idle[holding.body];
    if (holding.matters && std::abs(holding.moment) > std::abs(largest.moment)) {
      largest = {-holding.moment, next};
    }
  }
}

void Analysis::Impl::note_status(RowStatus status) {
  found.good = found.good && status == RowStatus::kOk;
  if (status == RowStatus::kNotConverged) {
    InexactRows& rows = found.inexact;
    rows.first = rows.count++ == 0 ? next : rows.first;
    rows.residual = std::max(rows.residual, run.row.residual);
  }
}

// The rows before `end` have been taken. False where the run is stopped in the search for openings that
// follows the last row: that row then counts as not taken.
bool Analysis::Impl::advance(std::int64_t end) {
  if (end == schedule.size() && start && !report_openings()) {
    return false;
  }
  next = end;
  return true;
}

void Analysis::Impl::begin_block() {
  const RunPlace here{run, history};
  const RunPlace& ahead = scout->go_to(schedule, next - 1);
  begin_at(next, go_on_alike(here, ahead) ? ahead : here);
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

std::unique_ptr<Analysis::Impl> make_impl(std::shared_ptr<const Model::Data> model, const Units& units,
                                          DriverSchedule schedule, Run run, ColumnSet columns, bool forces) {
  auto impl = std::make_unique<Analysis::Impl>(
      Analysis::Impl{std::move(model), units, std::move(schedule), std::move(run), std::move(columns)});
  if (forces) {
    impl->dynamics.emplace(impl->run);
    impl->start = impl->run;
    impl->found.idle.resize(impl->run.mechanism().bodies.size());
  }
  return impl;
}

std::unique_ptr<Analysis::Impl> Analysis::Impl::make_worker() const {
  auto worker = std::make_unique<Impl>(*this);
  worker->start.reset();
  worker->scout.reset();
  worker->reactions = nullptr;
  return worker;
}

void Analysis::Impl::begin_at(std::int64_t row, const RunPlace& from) {
  run = from.run;
  history = from.history;
  next = row;
  if (dynamics) {
    dynamics.emplace(run);
  }
}

void RowsFound::add(RowsFound later) {
  events.insert(events.end(), std::make_move_iterator(later.events.begin()),
                std::make_move_iterator(later.events.end()));
  good = good && later.good;
  for (std::size_t body = 0; body < later.idle.size(); ++body) {
    if (std::abs(later.idle[body].moment) > std::abs(idle[body].moment)) idle[body] = later.idle[body];
  }
  inexact.first = inexact.count == 0 ? later.inexact.first : inexact.first;
  inexact.count += later.inexact.count;
  inexact.residual = std::max(inexact.residual, later.inexact.residual);
}

void Analysis::Impl::add_block(RowsFound of_block, std::int64_t end) {
  found.add(std::move(of_block));
  (void)advance(end);
}

Analysis::Analysis(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Analysis::Analysis(Analysis&& other) noexcept = default;
Analysis& Analysis::operator=(Analysis&& other) noexcept = default;
Analysis::~Analysis() = default;

std::int64_t Analysis::size() const {
  return impl_->schedule.size();
}

const std::vector<Column>& Analysis::columns() const {
  return impl_->columns.columns();
}

bool Analysis::next(Row& row) {
  return impl_->next_row(row);
}

bool Analysis::stopped() const {
  return impl_->next < impl_->schedule.size() && is_stopped(impl_->run);
}

const std::vector<Event>& Analysis::events() const {
  return impl_->found.events;
}

namespace {

std::string idle_text(const Analysis::Impl& impl, std::size_t body) {
  const Mechanism& mechanism = impl.model->profile.mechanism;
  const auto [moment, row] = impl.found.idle[body];
  return fmt::format(
      "bodies.{}: it turns freely, and nothing balances the moment about its pin, {} at driver = {}, so that "
      "the forces are not those of equilibrium; put loads, springs and the centre of mass on the pin, or set "
      "rolling = true",
      mechanism.bodies[body].name, with_unit(moment, dimension::kTorque, impl.units),
      with_unit(impl.schedule.state(row).si.position, driver_dimension(mechanism), impl.units));
}

std::string inexact_text(const Analysis::Impl& impl) {
  const InexactRows& rows = impl.found.inexact;
  const Dimension of_driver = driver_dimension(impl.model->profile.mechanism);
  return fmt::format(
      "{} of {} rows are `not_converged`, the first at driver = {}: conditions are met to {}, where the "
      "tolerance is {:.3g}",
      rows.count, impl.next, with_unit(impl.schedule.state(rows.first).si.position, of_driver, impl.units),
      with_unit(rows.residual, dimension::kLength, impl.units, 3),
      from_si(dimension::kLength, impl.units).apply(impl.run.tolerance * impl.run.plan().size));
}

}  // namespace

Diagnostics Analysis::notes() const {
  Diagnostics notes = impl_->notes;
  for (std::size_t body = 0; body < impl_->found.idle.size(); ++body) {
    if (impl_->found.idle[body].moment != 0) {
      notes.push_back(about(impl_->model->profile.source, idle_text(*impl_, body)));
    }
  }
  if (impl_->found.inexact.count > 0) {
    notes.push_back(about(impl_->model->profile.source, inexact_text(*impl_)));
  }
  if (impl_->next == impl_->schedule.size()) {
    const auto touched = [&](std::size_t contact) {
      return std::any_of(impl_->found.events.begin(), impl_->found.events.end(), [&](const Event& event) {
        return event.contact == static_cast<int>(contact) &&
               (event.type == EventType::kEngage || event.type == EventType::kOverlap);
      });
    };
    std::vector<std::size_t> untouched = impl_->open;
    std::erase_if(untouched, touched);
    for (Diagnostic& note : untouched_notes(impl_->model->profile, untouched)) {
      notes.push_back(std::move(note));
    }
  }
  return notes;
}

std::vector<SmallestForce> Analysis::smallest_forces() const {
  const Mechanism& mechanism = impl_->model->profile.mechanism;
  std::vector<SmallestForce> forces;
  for (std::size_t i = 0; i < impl_->contacts.lowest.size(); ++i) {
    if (const auto& lowest = impl_->contacts.lowest[i]) {
      forces.push_back({mechanism.contacts[i].name,
                        from_si(dimension::kForce, impl_->units).apply(lowest->force),
                        from_si(driver_dimension(mechanism), impl_->units).apply(lowest->driver)});
    }
  }
  return forces;
}

std::optional<double> Analysis::highest_speed() const {
  return impl_->contacts.highest_speed;
}

bool Analysis::good() const {
  return impl_->found.good;
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
