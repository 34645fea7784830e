#include "design_direct.hpp"

#include "front/tolerances.hpp"
#include "higherpair/io/row_path.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr double kMostParts = 1000;

// Checks the closure of dyads at equally spaced places between rows as well, and, where the gap is largest at
// the middle one of three places, at the vertex of the parabola through these: a linkage that only just fails
// to turn fails between rows.
class GapWatch {
public:
  GapWatch(const DesignSetup& setup, DirectMotion& motion, RowReader& reader)
      : setup_(setup), motion_(motion), reader_(reader) {}

  // True if all groups could be positioned. The row's number is that of the calls before.
  bool go_to_row(const std::vector<DriverMotion>& drivers) {
    bool placed = true;
    for_each_part(setup_.schedule, static_cast<std::int64_t>(row_), drivers,
                  [&](const std::vector<DriverMotion>& end, double /*from*/, double to) {
                    placed = go_to(end, to == 1);
                  });
    ++row_;
    return placed;
  }

private:
  struct Place {
    std::optional<std::size_t> row;  // none: between two rows
    std::vector<std::optional<double>> gaps;
  };

  bool go_to(const std::vector<DriverMotion>& drivers, bool is_row) {
    const int parts = last_.empty() ? 1 : closure_parts(setup_, last_, drivers);
    std::vector<DriverMotion> between = drivers;
    bool placed = false;
    for (int part = 1; part <= parts; ++part) {
      for (std::size_t i = 0; part < parts && i < drivers.size(); ++i) {
        between[i].position =
            std::lerp(last_[i].position, drivers[i].position, static_cast<double>(part) / parts);
      }
      placed = motion_.move_to(part < parts ? between : drivers, false);
      const double step = last_.empty() ? 0 : (drivers.front().position - last_.front().position) / parts;
      note(std::abs(step), is_row && part == parts ? std::optional(row_) : std::nullopt);
    }
    last_ = drivers;
    return placed;
  }

  void note(double step, std::optional<std::size_t> row) {
    const auto& gaps = motion_.gaps();
    const bool even = before_.size() == 2 && std::abs(step - step_) <= kEvenStep * step;
    for (std::size_t g = 0; g < gaps.size(); ++g) {
      if (!gaps[g]) continue;
      reader_.take_gap(g, *gaps[g], row ? std::vector<WeightedRow>{{*row, 1}} : std::vector<WeightedRow>());
      if (even && before_[0].gaps[g] && before_[1].gaps[g]) take_vertex(g, *gaps[g], row);
    }
    if (before_.size() == 2) before_.erase(before_.begin());
    before_.push_back({row, gaps});
    step_ = step;
  }

  // The gap at the vertex of the parabola through three places, if the vertex lies between them.
  void take_vertex(std::size_t g, double c, std::optional<std::size_t> row) {
    const auto vertex = vertex_of(*before_[0].gaps[g], *before_[1].gaps[g], c);
    if (!vertex) return;
    std::vector<WeightedRow> rows;
    if (row && before_[0].row && before_[1].row) {
      rows = {{*before_[0].row, vertex->weights[0]},
              {*before_[1].row, vertex->weights[1]},
              {*row, vertex->weights[2]}};
    }
    reader_.take_gap(g, vertex->value, rows);
  }

  const DesignSetup& setup_;
  DirectMotion& motion_;
  RowReader& reader_;
  std::vector<DriverMotion> last_;
  std::vector<Place> before_;  // the two preceding places
  double step_ = 0;
  std::size_t row_ = 0;
};

}  // namespace

// With s = (c - a)/(2b - a - c) the value is b + s (c - a)/8.
std::optional<GapVertex> vertex_of(double a, double b, double c) {
  if (!(b >= a && b >= c)) {
    return std::nullopt;
  }
  const double bend = 2 * b - a - c;
  if (!(bend > 0)) {
    return GapVertex{b, {0, 1, 0}};
  }
  const double s = (c - a) / bend;
  return GapVertex{b + (c - a) * (c - a) / (8 * bend),
                   {-s / 4 + s * s / 8, 1 - s * s / 4, s / 4 + s * s / 8}};
}

int closure_parts(const DesignSetup& setup, std::span<const DriverMotion> from,
                  std::span<const DriverMotion> to) {
  const Mechanism& mechanism = setup.numbers.model().mechanism();
  double parts = 1;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const Joint& joint = driven_joint(mechanism, i);
    const double step = joint.type == JointType::kRevolute ? kGapStep : kGapSlide * setup.size;
    parts = std::max(parts, std::ceil(std::abs(to[i].position - from[i].position) / step - kWholeGapSteps));
  }
  return static_cast<int>(std::min(parts, kMostParts));
}

void place_rows(const DesignSetup& setup, std::unique_ptr<const Mechanism> mechanism, const Plan& plan,
                int branch, DesignRows& rows) {
  rows.mechanism = std::move(mechanism);
  rows.direct.emplace(*rows.mechanism, plan, branch);
  RowReader reader(setup, *rows.mechanism, plan, rows);
  GapWatch watch(setup, *rows.direct, reader);
  for (std::int64_t k = 0; k < setup.schedule.size(); ++k) {
    const std::vector<DriverMotion> motions = drivers_in(setup.schedule, k);
    const bool placed = watch.go_to_row(motions);
    rows.started = rows.started || placed;
    reader.take(rows.direct->bodies(), placed, motions.front().position,
                placed ? RowStatus::kOk : RowStatus::kNotAssemblable);
  }
  const bool closes =
      std::all_of(rows.gaps.begin(), rows.gaps.end(), [&](double gap) { return setup.closes(gap); });
  reader.finish(closes ? 0 : 1);
}

}  // namespace higherpair
