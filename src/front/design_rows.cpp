#include "design_rows.hpp"

#include "analysis_impl.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/io/row_path.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace higherpair {
namespace {

// Of a driver, between two places where the reach of dyads is looked at: a pin's angle [rad], or of the size.
constexpr double kGapStep = kPi / 30, kGapSlide = 0.05;

// What the rows of one candidate say, row by row.
class RowReader {
public:
  RowReader(const DesignSetup& setup, const Mechanism& mechanism, const Plan& plan, DesignRows& rows)
      : setup_(setup), mechanism_(mechanism), plan_(plan), rows_(rows) {
    for (const Group& group : plan.groups) {
      if (traits_of(group).two_modes) rows_.gaps.push_back(-std::numeric_limits<double>::infinity());
    }
    for (const DesignTask::Constraint& constraint : setup.numbers.task().constraints) {
      if (constraint.transmission) rows_.transmissions.push_back(1);
    }
    for (const DesignTask::Objective& objective : setup.numbers.task().objectives) {
      if (objective.path) rows_.points.emplace_back();
    }
  }

  // \param there  whether the bodies could be placed
  void take(const std::vector<BodyMotion>& bodies, bool there, double driver, RowStatus status) {
    rows_.positions.push_back(driver);
    not_good_ += status == RowStatus::kOk ? 0 : 1;
    if (there) take_transmissions(bodies);
    std::size_t path = 0;
    for (const DesignTask::Objective& objective : setup_.numbers.task().objectives) {
      if (!objective.path) continue;
      const PointRef& ref = objective.path->ref;
      std::vector<Vector2d>& points = rows_.points[path++];
      points.push_back(there || points.empty()
                           ? bodies[static_cast<std::size_t>(ref.body)].X_WB * point_of(mechanism_, ref)
                           : points.back());
    }
  }

  void take_gaps(const std::vector<std::optional<double>>& gaps) {
    std::size_t mode = 0;
    for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
      if (traits_of(plan_.groups[g]).two_modes) {
        if (gaps[g]) rows_.gaps[mode] = std::max(rows_.gaps[mode], *gaps[g]);
        ++mode;
      }
    }
  }

  void take_gaps(const std::vector<BodyMotion>& bodies) {
    std::vector<std::optional<double>> gaps;
    for (const Group& group : plan_.groups) gaps.push_back(closure_gap(group, bodies));
    take_gaps(gaps);
  }

  // \param limits  events on the path that end it
  void finish(int limits) {
    rows_.missing = (not_good_ + 0.5 * limits) / static_cast<double>(rows_.positions.size());
  }

private:
  void take_transmissions(const std::vector<BodyMotion>& bodies) {
    std::size_t k = 0;
    for (const DesignTask::Constraint& constraint : setup_.numbers.task().constraints) {
      if (!constraint.transmission) continue;
      const auto sine = transmission_sine(plan_, constraint.transmission->joint, bodies);
      rows_.transmissions[k] = std::min(rows_.transmissions[k], std::abs(sine.value_or(0)));
      ++k;
    }
  }

  const DesignSetup& setup_;
  const Mechanism& mechanism_;
  const Plan& plan_;
  DesignRows& rows_;
  double not_good_ = 0;
};

std::vector<double> positions_in(const DriverSchedule& schedule, std::int64_t row) {
  std::vector<double> drivers;
  for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
    drivers.push_back(schedule.state(row, i).si.position);
  }
  return drivers;
}

bool is_end(EventType type) {
  return type == EventType::kLimitPosition || type == EventType::kEnd || type == EventType::kOverlap;
}

// Looks at the reach of dyads at places of equal distance between rows as well, and where it is least among
// three of them, at the vertex of the parabola through these: a linkage that just cannot turn fails between
// rows.
class GapWatch {
public:
  GapWatch(const Mechanism& mechanism, DirectMotion& motion, RowReader& reader)
      : mechanism_(mechanism), motion_(motion), reader_(reader) {}

  // True if all groups could be placed.
  bool go_to(const std::vector<DriverMotion>& drivers) {
    const int parts = last_.empty() ? 1 : parts_to(drivers);
    std::vector<DriverMotion> between = drivers;
    bool placed = false;
    for (int part = 1; part <= parts; ++part) {
      for (std::size_t i = 0; part < parts && i < drivers.size(); ++i) {
        between[i].position =
            std::lerp(last_[i].position, drivers[i].position, static_cast<double>(part) / parts);
      }
      placed = motion_.move_to(part < parts ? between : drivers, false);
      note(std::abs(part < parts || !last_.empty() ? (drivers.front().position - position()) / parts : 0));
    }
    last_ = drivers;
    return placed;
  }

private:
  [[nodiscard]] double position() const { return last_.empty() ? 0 : last_.front().position; }

  [[nodiscard]] int parts_to(const std::vector<DriverMotion>& drivers) const {
    double parts = 1;
    for (std::size_t i = 0; i < drivers.size(); ++i) {
      const Joint& joint = mechanism_.joints[static_cast<std::size_t>(mechanism_.drivers[i].joint)];
      const double step = joint.type == JointType::kRevolute ? kGapStep : kGapSlide * motion_.plan().size;
      parts = std::max(parts, std::ceil(std::abs(drivers[i].position - last_[i].position) / step - 1e-9));
    }
    return static_cast<int>(std::min(parts, 1000.0));
  }

  void note(double step) {
    const auto& gaps = motion_.gaps();
    const bool even = before_.size() == 2 && std::abs(step - step_) <= 1e-6 * step;
    std::vector<std::optional<double>> largest = gaps;
    for (std::size_t g = 0; even && g < gaps.size(); ++g) {
      const auto& a = before_[0][g];
      const auto& b = before_[1][g];
      if (!gaps[g] || !a || !b || *b < *a || *b < *gaps[g]) continue;
      const double bend = 2 * *b - *a - *gaps[g];
      const double vertex = bend > 0 ? *b + (*gaps[g] - *a) * (*gaps[g] - *a) / (8 * bend) : *b;
      largest[g] = std::max(*gaps[g], vertex);
    }
    reader_.take_gaps(largest);
    if (before_.size() == 2) before_.erase(before_.begin());
    before_.push_back(gaps);
    step_ = step;
  }

  const Mechanism& mechanism_;
  DirectMotion& motion_;
  RowReader& reader_;
  std::vector<DriverMotion> last_;
  std::vector<std::vector<std::optional<double>>> before_;  // of the two places before
  double step_ = 0;
};

// Positions in closed form, where the plan has them.
void place_rows(const DesignSetup& setup, DirectMotion& motion, const Mechanism& mechanism, RowReader& reader,
                DesignRows& rows) {
  GapWatch watch(mechanism, motion, reader);
  for (std::int64_t k = 0; k < setup.schedule.size(); ++k) {
    const std::vector<DriverMotion> motions = drivers_in(setup.schedule, k);
    const bool placed = watch.go_to(motions);
    rows.started = rows.started || placed;
    reader.take(motion.bodies(), placed, motions.front().position,
                placed ? RowStatus::kOk : RowStatus::kNotAssemblable);
  }
  const bool closes = std::all_of(rows.gaps.begin(), rows.gaps.end(), [](double gap) { return gap < 0; });
  reader.finish(closes ? 0 : 1);
}

// Positions alone: without a table.
void follow_rows(Run& run, const DriverSchedule& schedule, RowReader& reader) {
  int limits = 0;
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    const std::vector<DriverMotion> motions = drivers_in(schedule, k);
    move_to(run, motions);
    const bool inner = k > 0 && k + 1 < schedule.size();
    limits +=
        static_cast<int>(std::count_if(run.events.begin(), run.events.end(), [&](const RunEvent& event) {
          return is_end(event.type) &&
                 (inner || event.type == EventType::kOverlap || (k > 0 && event.share < 1 - 1e-9));
        }));
    const bool there = run.row.status != RowStatus::kNotAssemblable;
    reader.take(run.row.bodies, there, motions.front().position, run.row.status);
    there ? reader.take_gaps(run.row.bodies) : reader.take_gaps(closure_gaps(run, positions_in(schedule, k)));
  }
  reader.finish(limits);
}

// With the table that the measures need.
bool measure_rows(const DesignSetup& setup, std::shared_ptr<const Model::Data> data, Run run,
                  RowReader& reader, DesignRows& rows) {
  auto schedule =
      setup.numbers.is_linear() ? Result<DriverSchedule>(setup.schedule) : schedule_of(*data, setup.settings);
  auto columns = columns_of(*data, setup.settings, data->profile.units);
  if (!schedule || !columns) {
    return false;
  }
  std::optional<InverseDynamics> dynamics;
  std::optional<Run> start;
  if (setup.settings.forces) {
    dynamics.emplace(run);
    start = run;
  }
  Analysis analysis(std::make_unique<Analysis::Impl>(Analysis::Impl{data,
                                                                    data->profile.units,
                                                                    *std::move(schedule),
                                                                    std::move(run),
                                                                    *std::move(columns),
                                                                    std::move(dynamics),
                                                                    std::move(start),
                                                                    0,
                                                                    {},
                                                                    {},
                                                                    {},
                                                                    true,
                                                                    {},
                                                                    {},
                                                                    nullptr}));
  MeasureSet measures(setup.measures, analysis.columns());
  Row row;
  while (analysis.next(row)) {
    const Run& at = analysis.impl().run;
    const std::vector<double> drivers = positions_in(analysis.impl().schedule, row.number);
    const bool there = row.status != RowStatus::kNotAssemblable;
    measures.add(row);
    reader.take(at.row.bodies, there, drivers.front(), row.status);
    there ? reader.take_gaps(at.row.bodies) : reader.take_gaps(closure_gaps(at, drivers));
  }
  for (std::size_t m = 0; m < measures.size(); ++m) {
    rows.measured.push_back(measures.value(m).value);
  }
  const auto ends = std::count_if(analysis.events().begin(), analysis.events().end(),
                                  [](const Event& event) { return is_end(event.type); });
  reader.finish(analysis.good() ? 0 : static_cast<int>(ends));
  rows.run = analysis.impl().run;
  return true;
}

}  // namespace

const std::vector<BodyMotion>& DesignRows::bodies_at(double driver) {
  if (direct) {
    (void)direct->move_to({{driver, 1, 0}}, true);
    return direct->bodies();
  }
  move_to(*run, {{driver, 1, 0}});
  return run->row.bodies;
}

namespace {

// The candidate's mechanism and order of solution, and its profile where measures need it.
struct Candidate {
  std::shared_ptr<const Model::Data> data;
  std::unique_ptr<const Mechanism> mechanism;
  Plan plan;
  DriverSchedule schedule;
};

std::optional<Candidate> candidate_of(const DesignSetup& setup, std::span<const double> x, bool with_data) {
  const bool linear = setup.numbers.is_linear();
  const auto data = linear && !with_data ? nullptr : setup.numbers.data_of(x);
  if (!data && (!linear || with_data)) return std::nullopt;
  if (data && !data->plan) return std::nullopt;
  auto schedule = linear ? Result<DriverSchedule>(setup.schedule) : schedule_of(*data, setup.settings);
  if (!schedule) return std::nullopt;
  auto mechanism =
      std::make_unique<const Mechanism>(data ? data->profile.mechanism : setup.numbers.mechanism_of(x));
  Plan plan = data ? *data->plan : redimensioned(*setup.numbers.model().data().plan, *mechanism);
  return Candidate{data, std::move(mechanism), std::move(plan), *std::move(schedule)};
}

DesignRows nothing(const DesignSetup& setup) {
  DesignRows rows;
  rows.missing = 1;
  for (int branches = setup.branches; branches > 1; branches /= 2) rows.gaps.push_back(setup.size);
  return rows;
}

DesignRows direct_rows(const DesignSetup& setup, Candidate candidate, int branch) {
  DesignRows rows;
  rows.mechanism = std::move(candidate.mechanism);
  rows.direct.emplace(*rows.mechanism, candidate.plan, branch);
  RowReader reader(setup, *rows.mechanism, candidate.plan, rows);
  place_rows(setup, *rows.direct, *rows.mechanism, reader, rows);
  return rows;
}

DesignRows run_rows(const DesignSetup& setup, Candidate candidate, int branch) {
  DesignRows rows;
  RowReader reader(setup, *candidate.mechanism, candidate.plan, rows);
  const std::vector<double> first = candidate.schedule.first_positions();
  const RunModel model = make_run_model(*candidate.mechanism, candidate.plan);
  auto run = start_on_branch(model, first, branch);
  if (!run) {
    rows.missing = 1;
    reader.take_gaps(first_closure_gaps(model, first, branch));
    return rows;
  }
  rows.started = true;
  if (setup.measures.empty()) {
    follow_rows(*run, candidate.schedule, reader);
    rows.run = *std::move(run);
  } else {
    rows.started = measure_rows(setup, candidate.data, *std::move(run), reader, rows);
  }
  return rows;
}

}  // namespace

DesignRows rows_of(const DesignSetup& setup, std::span<const double> x, int branch) {
  const bool direct =
      setup.numbers.is_linear() && DirectMotion::is_possible(*setup.numbers.model().data().plan);
  if (direct) {
    auto candidate = candidate_of(setup, x, false);
    if (!candidate) return nothing(setup);
    DesignRows rows = direct_rows(setup, *std::move(candidate), branch);
    if (rows.missing > 0 || setup.measures.empty()) return rows;
  }
  auto candidate = candidate_of(setup, x, !setup.measures.empty());
  return candidate ? run_rows(setup, *std::move(candidate), branch) : nothing(setup);
}

}  // namespace higherpair
