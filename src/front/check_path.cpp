// The parts of a check that follow the path, and the order of their figures.
#include "check_parts.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

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

void mark_growing(CheckFigure& figure, const PathExtreme& extreme, CheckFigures::Bound bound) {
  if (extreme.grows) {
    figure.remark = fmt::format("it still {} there, towards a limit position or dead point",
                                bound == CheckFigures::Bound::kMost ? "grows" : "falls");
    figure.verdict = figure.verdict == Verdict::kKept ? Verdict::kUndecided : figure.verdict;
  }
}

void add_path_figures(const CheckedPath& checked, CheckFigures& figures) {
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
  const RowPath rows = path_of(checked.schedule);
  const auto ranges = path_extremes(checked.start, rows.path, blocks, look_at(checked, rows.path));
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
}

}  // namespace higherpair
