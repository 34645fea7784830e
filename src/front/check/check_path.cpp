// The parts of a check that follow the path, and the order of their figures.
#include "check_parts.hpp"
#include "front/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace higherpair {

std::optional<PathExtreme> peak_of(const PathRange& range) {
  const auto& [least, greatest] = range;
  if (!least || !greatest) {
    return least ? least : greatest;
  }
  const double low = std::abs(least->value), high = std::abs(greatest->value);
  const bool same = std::abs(low - high) <= kSamePathValue * std::max(low, high);
  return (same ? least->at < greatest->at : low > high) ? least : greatest;
}

namespace {

void remark_growing(CheckFigure& figure, std::string what) {
  figure.remark = std::move(what) + ", towards a limit position or dead point";
  figure.verdict = figure.verdict == Verdict::kKept ? Verdict::kUndecided : figure.verdict;
}

}  // namespace

void mark_growing(CheckFigure& figure, const PathExtreme& extreme, const CheckFigures& figures,
                  CheckFigures::Bound bound) {
  const char* const how = bound == CheckFigures::Bound::kMost ? "grows" : "falls";
  if (extreme.grows) {
    remark_growing(figure, fmt::format("it still {} there", how));
  } else if (extreme.growth) {
    remark_growing(figure, fmt::format("it still {} at {}", how, figures.place(extreme.growth->driver)));
  }
}

void mark_growing_elsewhere(CheckFigure& figure, const PathExtreme& extreme, const CheckFigures& figures,
                            std::string_view how, double least) {
  const bool goes_on = extreme.growth && std::abs(extreme.growth->limit) > least;
  if (extreme.grows || goes_on) {
    const double driver = extreme.grows ? extreme.driver : extreme.growth->driver;
    remark_growing(figure, fmt::format("{} still grows at {}", how, figures.place(driver)));
  }
}

void mark_growing(CheckFigure& figure, const PathRange& range, const CheckFigures& figures) {
  const auto peak = peak_of(range);
  for (const auto& extreme : {range.least, range.greatest}) {
    if (!peak || !extreme) continue;
    const bool changes_sign =
        extreme->growth && extreme->growth->limit * peak->value < -peak->value * peak->value;
    if (extreme->value * peak->value < 0 || changes_sign) {
      mark_growing_elsewhere(figure, *extreme, figures, "with the other sign it", std::abs(peak->value));
    }
  }
  if (peak) {
    mark_growing(figure, *peak, figures);
  }
}

void add_peak(const std::string& quantity, const Dimension& dimension, const PathRange& range,
              const GivenLimit* limit, CheckFigures& figures) {
  if (const auto peak = peak_of(range)) {
    CheckFigure& figure =
        figures.add(quantity, dimension, peak->value, peak->driver, limit, CheckFigures::Bound::kMost);
    figure.by_size = true;
    mark_growing(figure, range, figures);
  }
}

Event end_of_examination(const Profile& profile, const DriverSchedule& schedule, double end) {
  Event event;
  event.type = EventType::kEnd;
  event.driver_si = path_of(schedule).path.at(end).front().position;
  event.driver = from_si(driver_dimension(profile.mechanism), profile.units).apply(event.driver_si);
  if (schedule.is_timed()) event.time = from_si(dimension::kTime, profile.units).apply(end);
  event.cause =
      "the path is too long to look for extremes beyond; let the drivers go less far, such as one period";
  return event;
}

std::optional<double> add_path_figures(const CheckedPath& checked, CheckFigures& figures) {
  std::vector<ContactCheck> contacts;
  std::vector<PathQuantities> blocks;
  for (std::size_t i = 0; i < checked.start.mechanism().contacts.size(); ++i) {
    const bool split = figures.of_contact(i, LimitKey::kMaxReturnPressureAngle) != nullptr;
    contacts.push_back(contact_check(checked, i, split));
    blocks.push_back(contacts.back().quantities);
  }
  const JointCheck joints = joint_check(checked);
  blocks.push_back(joints.accelerations);
  blocks.push_back(joints.jerks);
  std::optional<ForceCheck> forces;
  if (checked.forces != nullptr) {
    forces = force_check(checked, figures);
    blocks.push_back(forces->quantities);
  }
  RowPath rows = path_of(checked.schedule);
  const auto end = cut_to_examined(checked.start, rows.path);
  const auto ranges = path_extremes(checked.start, rows.path, blocks, known_breaks(checked, rows.path));
  const std::size_t count = contacts.size();
  for (std::size_t i = 0; i < count; ++i) {
    contacts[i].read(ranges[i], figures);
    if (forces) {
      forces->read_contact(i, ranges[count + 2], figures);
    }
    contacts[i].read_curves(ranges[i], figures);
  }
  joints.read(ranges[count], ranges[count + 1], figures);
  if (forces) {
    forces->read_drivers(ranges[count + 2], figures);
  }
  return end;
}

}  // namespace higherpair
