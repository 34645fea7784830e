// Events on the path to a row.
#include "analysis_impl.hpp"
#include "higherpair/io/row_path.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr std::array kRates = {"position", "velocity", "acceleration"};

// A value in some units, converted to others; the same to the last digit where they are equal.
double converted(double value, const Dimension& dimension, const Units& from, const Units& to) {
  return from == to ? value : from_si(dimension, to).apply(to_si(dimension, from).apply(value));
}

// Order along the path. The driver may pass a position twice, so only time or share can decide.
bool is_earlier(const Event& a, const Event& b) {
  if (a.row != b.row) {
    return a.row < b.row;
  }
  return a.time && b.time ? *a.time < *b.time : a.share < b.share;
}

std::string jump_text(const EventJump& jump, const Mechanism& mechanism, const Units& units) {
  const Joint& driver = driven_joint(mechanism, jump.driver);
  const Dimension rate =
      rate_of(jump.turns ? dimension::kAngle : dimension::kLength, jump.order, coordinate_dimension(driver));
  const Scaling shown = from_si(rate, units);
  const std::string unit = rate == dimension::kNumber ? "" : " " + unit_text(rate, units);
  return fmt::format("; for a unit rate of {} {} jumps from {:.6g} to {:.6g}{}",
                     mechanism.drivers.size() == 1 ? "the driver" : "driver " + driver.name, jump.of,
                     shown.apply(jump.before), shown.apply(jump.after), unit);
}

// The positions of the drivers after the first.
std::string further_drivers_text(const RunEvent& what, const Mechanism& mechanism, const Units& units) {
  std::string text;
  for (std::size_t i = 0; i < what.further_drivers.size(); ++i) {
    text += fmt::format("{} driver.{} = {}", i == 0 ? "; with" : ",", mechanism.drivers[i + 1].name,
                        with_unit(what.further_drivers[i], driver_dimension(mechanism, i + 1), units, 10));
  }
  return text;
}

std::string cause_of(const RunEvent& what, const Mechanism& mechanism, const Units& units) {
  std::string cause = what.cause;
  if (what.curvature) {
    const Dimension curvature = dimension::kNumber / dimension::kLength;
    const Scaling shown = from_si(curvature, units);
    cause += fmt::format(" from {:.6g} to {:.6g} {}", shown.apply((*what.curvature)[0]),
                         shown.apply((*what.curvature)[1]), unit_text(curvature, units));
  }
  if (what.jump) cause += jump_text(*what.jump, mechanism, units);
  return cause + further_drivers_text(what, mechanism, units);
}

}  // namespace

bool is_fault(EventType type, std::int64_t row, double share, std::int64_t last_row) {
  const bool at_end = (row == last_row && share >= 1 - kAtRowEnd) || row == 0;
  return (loses_motion(type) && !at_end) || type == EventType::kOverlap;
}

void Analysis::Impl::add_event(const RunEvent& what, double share) {
  const Mechanism& mechanism = model->profile.mechanism;
  Event event;
  event.type = what.type;
  event.row = next;
  event.share = share;
  event.driver_si = what.driver;
  event.driver = from_si(driver_dimension(mechanism), units).apply(what.driver);
  if (schedule.is_timed()) {
    const double position = from_si(driver_dimension(mechanism), model->profile.units).apply(what.driver);
    event.time = converted(schedule.passing_time(next, position, share), dimension::kTime,
                           model->profile.units, units);
  }
  event.joint = what.joint;
  event.contact = what.contact;
  if (event.contact) {
    event.item = mechanism.contacts[*event.contact].name;
  } else if (event.joint) {
    event.item = mechanism.joints[*event.joint].name;
  }
  event.cause = cause_of(what, mechanism, units);
  if (what.joint && what.value) {
    const Joint& joint = mechanism.joints[*what.joint];
    event.value = from_si(coordinate_dimension(joint), units).apply(*what.value);
  }
  found.good = found.good && !is_fault(event.type, event.row, event.share, schedule.size() - 1);
  found.events.push_back(std::move(event));
}

void Analysis::Impl::move() {
  const std::size_t first = found.events.size();
  move_to_row(run, schedule, next, motions, [&](double from, double to) {
    for (const RunEvent& event : run.events) {
      add_event(event, std::lerp(from, to, event.share));
    }
  });
  add_law_jumps();
  std::stable_sort(found.events.begin() + static_cast<std::ptrdiff_t>(first), found.events.end(), is_earlier);
}

void Analysis::Impl::add_law_jumps() {
  const Profile& profile = model->profile;
  for (const DriverSchedule::LawJump& jump : schedule.law_jumps(next)) {
    const Joint& joint = driven_joint(profile.mechanism, jump.driver);
    Dimension dimension = coordinate_dimension(joint);
    Event event;
    event.type = EventType::kLawJump;
    event.row = next;
    event.share = std::clamp(
        (jump.time - schedule.time(next - 1)) / (schedule.time(next) - schedule.time(next - 1)), 0.0, 1.0);
    event.driver_si = schedule.at_time(to_si(dimension::kTime, profile.units).apply(jump.time), 0).position;
    event.driver = from_si(driver_dimension(profile.mechanism), units).apply(event.driver_si);
    event.time = converted(jump.time, dimension::kTime, profile.units, units);
    event.joint = profile.mechanism.drivers[jump.driver].joint;
    event.item = joint.name;
    for (std::size_t k = 1; k <= 2; ++k) {
      dimension = rate_of(dimension);
      if (jump.join.jumps(k)) {
        const auto shown = [&](double value) { return converted(value, dimension, profile.units, units); };
        event.cause +=
            fmt::format("{} jumps from {:.6g} to {:.6g} {}",
                        event.cause.empty() ? profile.programs[jump.driver].law_name + ": " + kRates[k]
                                            : fmt::format(" and {}", kRates[k]),
                        shown(jump.join.before[k]), shown(jump.join.after[k]), unit_text(dimension, units));
      }
    }
    event.cause += "; a row there shows what is after it";
    found.events.push_back(std::move(event));
  }
}

std::vector<Event> Analysis::Impl::faults_before(std::int64_t row) const {
  std::vector<Event> faults;
  std::copy_if(found.events.begin(), found.events.end(), std::back_inserter(faults), [&](const Event& event) {
    return event.row <= row && is_fault(event.type, event.row, event.share, row);
  });
  return faults;
}

Event Analysis::Impl::opening_event(const ContactForceReport::Opening& opening) const {
  Event event;
  event.type = EventType::kContactOpen;
  event.row = static_cast<std::int64_t>(std::ceil(opening.row));
  event.share = opening.row - std::ceil(opening.row) + 1;
  event.driver_si = opening.what.driver;
  event.driver = from_si(driver_dimension(model->profile.mechanism), units).apply(opening.what.driver);
  if (schedule.is_timed()) {
    const double before = schedule.time_si(std::max<std::int64_t>(event.row - 1, 0));
    event.time =
        from_si(dimension::kTime, units).apply(std::lerp(before, schedule.time_si(event.row), event.share));
  }
  event.contact = static_cast<int>(opening.what.contact);
  event.item = model->profile.mechanism.contacts[opening.what.contact].name;
  event.cause = opening.cause;
  return event;
}

// Contacts may open between rows as well: openings are searched for on the whole path, whatever its rows.
// False if the run is stopped before all are found.
bool Analysis::Impl::report_openings() {
  contacts = report_contacts(model->profile, schedule, *start);
  if (is_stopped(run)) {
    return false;
  }
  for (const ContactForceReport::Opening& opening : contacts.openings) {
    found.events.push_back(opening_event(opening));
    found.good = false;
  }
  std::stable_sort(found.events.begin(), found.events.end(), is_earlier);
  return true;
}

}  // namespace higherpair
