#include "higherpair/front/mobility.hpp"

#include "front/demands.hpp"
#include "front/model_data.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/notes.hpp"
#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "higherpair/mechanism/plan_text.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace higherpair {
namespace {

MobilityQuestion question_of(const DriverSchedule& schedule, std::int64_t row = 0) {
  MobilityQuestion question;
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    const DriverState state = schedule.state(row, i);
    question.drivers.push_back(state.si.position);
    question.velocities.push_back(state.si.velocity);
  }
  return question;
}

tl::expected<Run, StartFailure> started(const Model::Data& data, const std::vector<double>& drivers,
                                        double tolerance) {
  if (!data.plan) {
    return tl::unexpected(StartFailure{data.plan.error(), std::nullopt});
  }
  return start_run(run_model(data), drivers, tolerance);
}

bool all_touch(const Run& run) {
  return std::all_of(run.at.state.contacts.begin(), run.at.state.contacts.end(),
                     [](const ContactMotion& contact) { return contact.touches; });
}

// Moves a run from the first row to the first row in which every contact touches: there contacts that may
// separate constrain their bodies as all others do. Stays at the first row if there is none.
std::int64_t row_in_touch(Run& run, const DriverSchedule& schedule) {
  Run start = run;
  std::vector<DriverMotion> drivers(schedule.driver_count());
  for (std::int64_t row = 0; row < schedule.size(); ++row) {
    for (std::size_t i = 0; i < drivers.size(); ++i) {
      drivers[i] = {schedule.state(row, i).si.position, 1, 0};
    }
    move_to(run, drivers);
    if (run.row.status == RowStatus::kOk && all_touch(run)) {
      return row;
    }
  }
  run = std::move(start);
  return 0;
}

// The motion in the first row, in which contacts may be open; none where it has no rates.
std::optional<std::vector<BodyMotion>> motion_at_start(Run run, const MobilityQuestion& question) {
  std::vector<DriverMotion> drivers;
  for (std::size_t i = 0; i < question.drivers.size(); ++i) {
    drivers.push_back({question.drivers[i], question.velocities[i], 0});
  }
  move_to(run, drivers);
  return run.row.all_rates ? std::optional(run.row.bodies) : std::nullopt;
}

}  // namespace

Result<MobilityFindings> mobility_of(const Model& model, double tolerance) {
  const Model::Data& data = model.data();
  const Mechanism& mechanism = data.profile.mechanism;
  if (std::string fault = first_unmet({positive("tolerance", tolerance)}); !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  const auto schedule = DriverSchedule::analyze(data.profile);
  if (!schedule) {
    return wrong(schedule.error());
  }
  MobilityQuestion question = question_of(*schedule);
  auto run = started(data, question.drivers, tolerance);
  std::optional<std::vector<BodyMotion>> moving;
  if (run && !all_touch(*run)) {
    moving = motion_at_start(*run, question);
    question = question_of(*schedule, row_in_touch(*run, *schedule));
  }
  if (run && all_touch(*run)) {
    question.start = MechanismPosition{run->at.state.bodies, run->at.state.contacts};
  }
  MobilityFindings findings{model, analyse_mobility(mechanism, question), {}, std::nullopt};
  if (moving) findings.mobility.moving = *std::move(moving);
  if (data.plan) {
    for (const Group& group : data.plan->groups) {
      findings.plan.push_back({group.bodies, describe(mechanism, group)});
    }
  }
  // Objections from the rank come first.
  findings.objection = driver_objection(mechanism, findings.mobility);
  if (!findings.objection && !run) {
    findings.objection = run.error().reason + start_advice(data.profile, question.drivers, tolerance);
  }
  return findings;
}

}  // namespace higherpair
