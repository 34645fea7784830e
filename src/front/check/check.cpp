#include "higherpair/front/check.hpp"

#include "check_parts.hpp"
#include "front/demands.hpp"
#include "front/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr std::int64_t kMostRows = 37;

// A small number of rows is enough: events between rows are found however far apart these are. None where the
// profile gives rows one by one, or the time between them.
std::optional<std::int64_t> few_rows(const Profile& profile, bool in_time) {
  std::int64_t most = kMostRows;
  for (const DriverProgram& program : profile.programs) {
    if (in_time ? program.time_step.has_value() : !program.positions.empty()) {
      return std::nullopt;
    }
    if (!in_time) most = std::min(most, program.samples.value_or(kDefaultSamples));
  }
  return most;
}

// What is wrong with limits that a program has made; empty: nothing.
std::string fault_of(const CheckLimits& limits, const Mechanism& mechanism) {
  const auto in = [](const char* name, const std::vector<LimitSet>& sets, std::size_t count) -> std::string {
    if (!sets.empty() && sets.size() != count) {
      return fmt::format("CheckLimits::{}: there are {} for {}", name, sets.size(), count);
    }
    for (const LimitSet& set : sets) {
      for (std::size_t k = 0; k < set.size(); ++k) {
        if (!set[k]) continue;
        const auto key = static_cast<LimitKey>(k);
        const std::string objection =
            std::isfinite(set[k]->value) ? objection_to(key, set[k]->value) : "must be finite";
        if (!objection.empty()) {
          return fmt::format("CheckLimits::{}: {} = {}: {}", name, name_of(key), set[k]->value, objection);
        }
      }
    }
    return "";
  };
  for (std::string fault :
       {in("all", {limits.all}, 1), in("contacts", limits.contacts, mechanism.contacts.size()),
        in("joints", limits.joints, mechanism.joints.size()),
        in("bodies", limits.bodies, mechanism.bodies.size())}) {
    if (!fault.empty()) return fault;
  }
  return "";
}

// Runs through all rows for the events between them. False if the run was stopped.
bool run_through(Analysis& analysis, CheckReport& report) {
  Row row;
  while (analysis.next(row)) {
  }
  report.stopped = analysis.stopped();
  report.events = analysis.events();
  report.good = analysis.good() && !report.stopped;
  report.notes = analysis.notes();
  return !report.stopped;
}

// If the run showed no overlap and no second contact, switches off the overlap monitoring of contacts that do
// not overlap at the start.
void spare_watches(const std::vector<Event>& events, Run& start) {
  const bool quiet = std::none_of(events.begin(), events.end(), [](const Event& event) {
    return event.type == EventType::kSecondContact || event.type == EventType::kOverlap ||
           event.type == EventType::kRelease;
  });
  for (OverlapWatch& watch : start.at.watches) {
    watch.needed = watch.needed && (!quiet || watch.overlaps);
  }
}

// Says that the rest of a path is not examined, and takes back that limits are kept.
void leave_open(const Profile& profile, const DriverSchedule& schedule, double end,
                const CheckFigures& figures, CheckReport& report) {
  report.events.push_back(end_of_examination(profile, schedule, end));
  report.good = false;
  for (CheckFigure& figure : report.figures) {
    if (figure.verdict != Verdict::kKept) continue;
    figure.verdict = Verdict::kUndecided;
    figure.remark += fmt::format("{}not examined beyond {}", figure.remark.empty() ? "" : "; ",
                                 figures.place(report.events.back().driver_si));
  }
}

void add_speed(const Analysis& analysis, bool forces, CheckFigures& figures, const CheckLimits& limits) {
  const auto& contacts = analysis.impl().model->profile.mechanism.contacts;
  if (!forces || contacts.empty()) {
    return;
  }
  const auto& given = limits.all[static_cast<std::size_t>(LimitKey::kMinSpeedFactor)];
  const std::optional<double> factor = analysis.highest_speed();
  if (!factor && !given) {
    return;
  }
  figures.about("mechanism");
  const std::optional<double> value = factor && std::isfinite(*factor) ? factor : std::nullopt;
  CheckFigure& figure = figures.add("speed_factor", dimension::kNumber, value, std::nullopt,
                                    given ? &*given : nullptr, CheckFigures::Bound::kLeast);
  if (!factor) {
    figure.verdict = Verdict::kUndecided;
    figure.remark = "not known: dampers act, or a force is not defined everywhere";
  } else if (!value) {
    figure.remark = "no speed opens a contact";
  } else {
    figure.remark = *value > 0 ? "a contact opens at this multiple of the drivers' speed"
                               : "a contact opens at rest already";
  }
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  static constexpr std::array kNames = {"", "kept", "exceeded", "undecided"};
  static_assert(kNames.size() == static_cast<std::size_t>(Verdict::kUndecided) + 1);
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string CheckFigures::place(double driver) const {
  return with_unit(driver, driver_dimension(profile_.mechanism), profile_.units);
}

CheckFigure& CheckFigures::add(const std::string& quantity, const Dimension& dimension,
                               std::optional<double> value, std::optional<double> driver,
                               std::string remark) {
  CheckFigure figure;
  figure.item = item_;
  figure.of = of_;
  figure.quantity = quantity;
  figure.unit = unit_text(dimension, profile_.units);
  if (value) {
    figure.value = from_si(dimension, profile_.units).apply(*value);
  }
  if (driver) {
    figure.at = from_si(driver_dimension(profile_.mechanism), profile_.units).apply(*driver);
  }
  figure.remark = std::move(remark);
  report_.figures.push_back(std::move(figure));
  return report_.figures.back();
}

CheckFigure& CheckFigures::add(const std::string& quantity, const Dimension& dimension,
                               std::optional<double> value, std::optional<double> driver,
                               const GivenLimit* limit, Bound bound) {
  CheckFigure& figure = add(quantity, dimension, value, driver);
  if (limit == nullptr) {
    return figure;
  }
  use(limit);
  figure.limit = limit->profile.value_or(from_si(dimension, profile_.units).apply(limit->value));
  const double slack = kAtCheckLimit * std::abs(limit->value);
  const bool kept = !value || (bound == Bound::kMost ? std::abs(*value) <= limit->value + slack
                                                     : *value >= limit->value - slack);
  figure.verdict = kept ? Verdict::kKept : Verdict::kExceeded;
  return figure;
}

void CheckFigures::note_unused() {
  const auto note = [&](const LimitSet& set) {
    for (std::size_t k = 0; k < set.size(); ++k) {
      const auto& limit = set[k];
      if (!limit || used_.count(&*limit) != 0) continue;
      const std::string name(limit->path.empty() ? name_of(static_cast<LimitKey>(k)) : limit->path);
      Diagnostic unused{limit->place, name + ": nothing in this mechanism has this"};
      if (unused.place.source.empty()) unused.place.source = profile_.source;
      report_.notes.push_back(std::move(unused));
    }
  };
  note(limits_.all);
  for (const auto* sets : {&limits_.contacts, &limits_.joints, &limits_.bodies}) {
    std::for_each(sets->begin(), sets->end(), note);
  }
}

Result<CheckReport> check(const Model& model, const CheckSettings& settings) {
  const Profile& profile = model.profile();
  const CheckLimits none;
  const CheckLimits& limits = settings.limits ? *settings.limits : profile.limits ? *profile.limits : none;
  std::string fault = first_unmet({positive("setting tolerance", settings.tolerance)});
  if (fault.empty()) fault = fault_of(limits, profile.mechanism);
  if (!fault.empty()) {
    return wrong(model, std::move(fault));
  }
  RunSettings run;
  run.in_time = settings.in_time;
  run.tolerance = settings.tolerance;
  run.stop = settings.stop;
  run.forces = has_forces(profile.mechanism);
  run.columns = {"status"};
  run.samples = few_rows(profile, settings.in_time);
  auto analysis = model.start(run);
  if (!analysis) {
    return tl::unexpected(std::move(analysis.error()));
  }
  Run start = analysis->impl().run;
  CheckReport report;
  report.title = profile.mechanism.title;
  report.driver_unit = unit_text(driver_dimension(profile.mechanism), profile.units);
  if (!run_through(*analysis, report)) {
    return report;
  }
  spare_watches(report.events, start);
  CheckFigures figures(profile, limits, report);
  const DriverSchedule& schedule = analysis->impl().schedule;
  const auto end = add_path_figures(
      {profile, schedule, start, run.forces ? &analysis->impl().contacts : nullptr}, figures);
  if (end) {
    leave_open(profile, schedule, *end, figures, report);
  }
  add_speed(*analysis, run.forces, figures, limits);
  add_size_figures(profile, figures);
  figures.note_unused();
  report.stopped = is_stopped(start);
  report.good = report.good && !report.stopped &&
                std::all_of(report.figures.begin(), report.figures.end(), [](const CheckFigure& figure) {
                  return figure.verdict == Verdict::kNoLimit || figure.verdict == Verdict::kKept;
                });
  return report;
}

}  // namespace higherpair
