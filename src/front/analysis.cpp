#include "analysis_impl.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/notes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/core.h>

namespace higherpair {

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

}  // namespace higherpair
