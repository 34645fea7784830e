// Notes on parts of a design that are probably not as they are meant: targets that look like numbers in
// another unit, closed paths that do not close.
#include "design_setup.hpp"
#include "front/other_units.hpp"
#include "front/tolerances.hpp"
#include "higherpair/front/design.hpp"
#include "higherpair/numeric/contains.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

bool is_within(double a, double b, double times) {
  return a <= times * b && b <= times * a;
}

// The unit in which a target would be close to the profile's value, if it is far from it as given.
std::optional<OtherUnit> meant_unit(double wanted, double present, const std::string& unit,
                                    const Units& units) {
  if (!(wanted > 0) || !(present > 0) || is_within(wanted, present, kTargetApart)) {
    return std::nullopt;
  }
  return best_unit(unit, units, kTargetAsMuch, [&](const OtherUnit& other) {
    return std::max(wanted * other.factor / present, present / (wanted * other.factor));
  });
}

double spread_of(const std::vector<double>& values) {
  double low = kInf, high = -kInf;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return high - low;
}

class TaskNotes {
public:
  explicit TaskNotes(const DesignSetup& setup)
      : setup_(setup), task_(setup.numbers.task()), units_(setup.numbers.model().units()) {}

  Diagnostics notes() {
    const DesignScore& score = setup_.start_score;
    if (!score.started) return {};
    motion_ = run();
    for (std::size_t k = 0; k < task_.objectives.size(); ++k) {
      const DesignTask::Objective& objective = task_.objectives[k];
      if (objective.path()) {
        note_open(objective);
        note_path(objective);
        continue;
      }
      const std::string& unit = setup_.quantities[setup_.objective_places[k].quantity].unit;
      if (objective.target) note_target(objective, score.objectives[k], unit);
      if (objective.followed()) note_followed(objective, unit);
    }
    return std::move(notes_);
  }

private:
  // The profile's motion, with the columns of the measures and the paths.
  [[nodiscard]] std::optional<Motion> run() const {
    RunSettings settings = setup_.settings;
    for (const DesignTask::PointPath* path : task_.paths()) {
      for (const char* end : {".x", ".y"}) {
        const std::string name = path->point + end;
        if (!contains(settings.columns, name)) settings.columns.push_back(name);
      }
    }
    auto motion = setup_.numbers.model().run(settings);
    return motion ? std::optional(*std::move(motion)) : std::nullopt;
  }

  [[nodiscard]] std::vector<double> column(const std::string& name) const {
    if (!motion_ || !motion_->find_column(name)) return {};
    const auto values = motion_->column(name);
    return {values.begin(), values.end()};
  }

  // A path that is to be closed, of a run that does not end where it began.
  void note_open(const DesignTask::Objective& objective) {
    if (!objective.path()->closed) return;
    const std::string& point = objective.path()->point;
    const std::vector<double> xs = column(point + ".x"), ys = column(point + ".y");
    double length = 0;
    for (std::size_t k = 1; k < xs.size() && k < ys.size(); ++k) {
      length += std::hypot(xs[k] - xs[k - 1], ys[k] - ys[k - 1]);
    }
    if (xs.size() < 2 || xs.size() != ys.size() ||
        std::hypot(xs.back() - xs.front(), ys.back() - ys.front()) <= kClosedPath * length) {
      return;
    }
    notes_.push_back(
        {objective.place,
         fmt::format("{}.path.closed: the path of {} does not end where it begins: its places count as those "
                     "of an open path. Let the driver make a whole turn",
                     objective.path_of_key, point)});
  }

  void note_path(const DesignTask::Objective& objective) {
    const DesignTask::PointPath& path = *objective.path();
    if (path.free_scale) return;
    const Scaling length = from_si(dimension::kLength, units_);
    std::vector<double> xs, ys;
    for (const Vector2d& point : path.through) {
      xs.push_back(length.apply(point.x()));
      ys.push_back(length.apply(point.y()));
    }
    const double wanted = std::max(spread_of(xs), spread_of(ys));
    const double present =
        std::max(spread_of(column(path.point + ".x")), spread_of(column(path.point + ".y")));
    const std::string unit = unit_text(dimension::kLength, units_);
    if (const auto other = meant_unit(wanted, present, unit, units_)) {
      notes_.push_back(
          {objective.place,
           fmt::format(
               "{0}.path: its points lie within {1:.4g} {2}, and {3} of the profile moves within {4:.4g} "
               "{2}: are they in {5}? Points are in {2}, or have their unit, \"5 {5}\"; a file, units = "
               "\"{5}\"",
               objective.path_of_key, wanted, unit, path.point, present, other->unit)});
    }
  }

  void note_target(const DesignTask::Objective& objective, double present, const std::string& unit) {
    if (const auto other = meant_unit(std::abs(*objective.target), std::abs(present), unit, units_)) {
      notes_.push_back(
          {objective.place,
           fmt::format("{0}.target = {1}: the profile has {2:.6g} {3}: is it in {4}? Targets are in the "
                       "units of tables: {5:.9g} {3}",
                       objective.path_of_key, *objective.target, present, unit, other->unit,
                       other->factor * *objective.target)});
    }
  }

  void note_followed(const DesignTask::Objective& objective, const std::string& unit) {
    const std::string& name = objective.followed()->measure.column;
    const double wanted = spread_of(objective.followed()->values), present = spread_of(column(name));
    if (const auto other = meant_unit(wanted, present, unit, units_)) {
      notes_.push_back(
          {objective.place,
           fmt::format("{0}.follow: its values lie within {1:.4g} {2}, and {3} of the profile within "
                       "{4:.4g} {2}: are they in {5}? They are to be in {2}: {6:.6g} times as much",
                       objective.path_of_key, wanted, unit, name, present, other->unit, other->factor)});
    }
  }

  const DesignSetup& setup_;
  const DesignTask& task_;
  const Units& units_;
  std::optional<Motion> motion_;
  Diagnostics notes_;
};

}  // namespace

Diagnostics design_notes(const Model& model) {
  if (!model.data().document) return {};
  const auto setup = design_setup(model);
  return setup && (*setup)->start_branch ? TaskNotes(**setup).notes() : Diagnostics();
}

}  // namespace higherpair
