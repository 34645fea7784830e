#include "design_slopes.hpp"

#include "design_slope_run.hpp"
#include "front/tolerances.hpp"
#include "higherpair/analysis/displaced.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/numeric/stencil.hpp"
#include "numeric/eigen_index.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace higherpair {
namespace {

// Maximum number of rows in which columns are differentiated along a displaced row; for more, finite
// differences of whole candidates are faster.
constexpr std::size_t kMostAlong = 8;

bool is_covered(const DesignSetup& setup) {
  const Mechanism& mechanism = setup.numbers.model().mechanism();
  return (has_whole_curves(mechanism) || !setup.needs_extents()) &&
         std::none_of(mechanism.contacts.begin(), mechanism.contacts.end(),
                      [](const Contact& contact) { return contact.keep == Keep::kGap; });
}

// The derivatives wanted in one row, added up when the run gets there.
using Task = std::function<bool(const SlopeRun&, const std::vector<RowSensitivity>&)>;
struct RowTasks {
  RatesAsked rates = RatesAsked::kNone;
  std::vector<Task> all;

  void add(RatesAsked asked, Task task) {
    rates = std::max(rates, asked);
    all.push_back(std::move(task));
  }
};
using Tasks = std::map<std::size_t, RowTasks>;

bool carry_out(const Tasks& tasks, SlopeRun& run) {
  for (const auto& [row, of_row] : tasks) {
    run.go_to(row);
    const std::vector<RowSensitivity> slopes = run.sensitivities(of_row.rates);
    if (slopes.empty() || !std::all_of(of_row.all.begin(), of_row.all.end(),
                                       [&](const Task& task) { return task(run, slopes); })) {
      return false;
    }
  }
  return true;
}

Vector2d point_slope(const SlopeRun& run, std::size_t variable, const PointRef& point,
                     const RowSensitivity& of_row) {
  const BodyColumn x{static_cast<std::size_t>(point.body), static_cast<std::size_t>(point.point), 0, 1};
  BodyColumn y = x;
  y.quantity = 1;
  const Mechanism& derivative = run.by(variable).derivative();
  return {column_slope(x, run.run(), derivative, of_row), column_slope(y, run.run(), derivative, of_row)};
}

void add_path_tasks(std::span<const std::vector<SlopePlace>> places, DesignSlopes& slopes, Tasks& tasks) {
  for (std::size_t path = 0; path < places.size(); ++path) {
    for (std::size_t i = 0; i < places[path].size(); ++i) {
      const SlopePlace place = places[path][i];
      Eigen::MatrixXd& J = slopes.paths[path];
      const auto at = eigen_index(2 * i);
      tasks[place.row].add(RatesAsked::kNone, [place, &J, at](const SlopeRun& run, const auto& of_row) {
        const std::optional<SlopeRun> beside =
            place.driver ? std::optional(run.beside(*place.driver)) : std::nullopt;
        const std::vector<RowSensitivity> aside =
            beside ? beside->sensitivities(RatesAsked::kNone) : std::vector<RowSensitivity>();
        if (beside && aside.empty()) return false;
        for (std::size_t v = 0; v < of_row.size(); ++v) {
          J.block<2, 1>(at, eigen_index(v)) = beside ? point_slope(*beside, v, place.point, aside[v])
                                                     : point_slope(run, v, place.point, of_row[v]);
        }
        return true;
      });
    }
  }
}

// Gaps of dyads and transmission angles are functions of the plan's dimensions and of where the bodies are.
void add_group_tasks(const DesignSetup& setup, const DesignRows& rows, DesignSlopes& slopes, Tasks& tasks) {
  const auto add = [&](const WeightedRow& at, auto value, Eigen::MatrixXd& J, std::size_t index) {
    tasks[at.row].add(
        RatesAsked::kNone, [value, &J, index, weight = at.weight](const SlopeRun& run, const auto& of_row) {
          for (std::size_t v = 0; v < of_row.size(); ++v) {
            J(eigen_index(index), eigen_index(v)) +=
                weight * run.slope_of(v, of_row[v], [&](const Run& displaced) {
                  return value(redimensioned(displaced.plan(), displaced.mechanism()), displaced.row.bodies);
                });
          }
          return true;
        });
  };
  for (std::size_t k = 0; k < rows.gap_rows.size(); ++k) {
    const auto gap = [k](const Plan& plan, const std::vector<BodyMotion>& bodies) {
      std::size_t mode = 0;
      for (const Group& group : plan.groups) {
        if (traits_of(group).two_modes && mode++ == k) return closure_gap(group, bodies).value_or(0);
      }
      return 0.0;
    };
    for (const WeightedRow& at : rows.gap_rows[k]) add(at, gap, slopes.gaps, k);
  }
  const auto transmissions = setup.numbers.task().transmissions();
  for (std::size_t k = 0; k < rows.transmission_rows.size(); ++k) {
    const auto sine = [joint = transmissions[k]->joint](const Plan& plan,
                                                        const std::vector<BodyMotion>& bodies) {
      return std::abs(transmission_sine(plan, joint, bodies).value_or(0));
    };
    add({rows.transmission_rows[k], 1}, sine, slopes.transmissions, k);
  }
}

// Extents of bodies: each term is differentiated in the row in which it is largest.
void add_extent_tasks(const DesignSetup& setup, const DesignRows& rows, DesignSlopes& slopes, Tasks& tasks) {
  const double unit = from_si(dimension::kLength, setup.numbers.model().units()).apply(1);
  std::size_t k = 0;
  for (const DesignQuantity& quantity : setup.quantities) {
    const auto* extent = quantity.as<DesignTask::Extent>();
    if (extent == nullptr) continue;
    for (const ExtentTerm& term : terms_that_count(*extent, rows.extents[k++])) {
      tasks[term.row].add(RatesAsked::kNone, [&, extent, q = quantity.first, unit, term](const SlopeRun& run,
                                                                                         const auto& of_row) {
        const auto far = [&](const Run& displaced) {
          return far_along(*extent, term.direction_W, displaced.mechanism(), displaced.row.bodies);
        };
        for (std::size_t v = 0; v < of_row.size(); ++v) {
          slopes.measured(eigen_index(q), eigen_index(v)) += unit * run.slope_of(v, of_row[v], far);
        }
        return true;
      });
    }
  }
}

// The Grashof margins of four-bars depend on no row.
void add_rooms(const DesignSetup& setup, const DesignCandidate& candidate,
               const std::vector<MechanismDerivative>& derivatives, DesignSlopes& slopes) {
  const double unit = from_si(dimension::kLength, setup.numbers.model().units()).apply(1);
  for (const DesignQuantity& quantity : setup.quantities) {
    const auto* grashof = quantity.as<DesignTask::Grashof>();
    for (std::size_t v = 0; grashof && v < derivatives.size(); ++v) {
      const auto room = [&](double h) {
        return grashof_room(displaced(*candidate.mechanism, derivatives[v].numbers, h), *grashof).value_or(0);
      };
      slopes.measured(eigen_index(quantity.first), eigen_index(v)) =
          unit * eighth_order_difference(room, kGrashofStep * setup.size);
    }
  }
}

DesignSlopes no_slopes(std::size_t variables, const DesignRows& rows,
                       std::span<const std::vector<SlopePlace>> places) {
  const auto zeros = [variables](std::size_t count) {
    return Eigen::MatrixXd(Eigen::MatrixXd::Zero(eigen_index(count), eigen_index(variables)));
  };
  DesignSlopes slopes;
  slopes.measured = zeros(rows.measured.size());
  slopes.gaps = zeros(rows.gaps.size());
  slopes.transmissions = zeros(rows.transmissions.size());
  for (const auto& path : places) slopes.paths.push_back(zeros(2 * path.size()));
  return slopes;
}

// A share of a measured number: a column in one row.
struct WeightedColumn {
  std::size_t number = 0;  // index in DesignRows::measured
  std::size_t measure = 0;
  double weight = 1;
};
// Those that have to be differentiated along a displaced row, for each row.
using AlongRows = std::map<std::size_t, std::vector<WeightedColumn>>;

// Calls f(row, share) for every share of a column's numbers, which begin with `first`.
template <class F>
void for_each_share(const DesignSetup& setup, const ColumnQuantity& column, std::size_t first,
                    const DesignRows& rows, F f) {
  const std::size_t measure = column.measure;
  std::vector<double> values;
  for (std::size_t k = rows.table_slots[measure]; k < rows.table.size(); k += rows.table_columns) {
    values.push_back(rows.table[k]);
  }
  if (column.at.empty()) {
    for (const WeightedRow& at : rows_of(setup.measures[measure], values, rows.places)) {
      f(at.row, WeightedColumn{first, measure, at.weight});
    }
    return;
  }
  const auto followed = rows_at(column.at, rows.places);
  for (std::size_t k = 0; k < followed.size(); ++k) {
    const auto row = followed[k];
    if (row && !std::isnan(values[*row])) f(*row, WeightedColumn{first + k, measure, 1});
  }
}

// Quantities that are columns of bodies have slopes in closed form. \return the others
AlongRows add_column_tasks(const DesignSetup& setup, const std::vector<std::optional<BodyColumn>>& columns,
                           const DesignRows& rows, DesignSlopes& slopes, Tasks& tasks) {
  AlongRows along;
  for (const DesignQuantity& quantity : setup.quantities) {
    const auto* measured = quantity.as<ColumnQuantity>();
    if (measured == nullptr) continue;
    const auto& column = columns[measured->measure];
    for_each_share(setup, *measured, quantity.first, rows, [&](std::size_t row, const WeightedColumn& share) {
      if (!column) {
        along[row].push_back(share);
        return;
      }
      const RatesAsked rates = order_of(*column) == 0 ? RatesAsked::kNone : RatesAsked::kAll;
      tasks[row].add(rates, [&slopes, share, &column](const SlopeRun& run, const auto& of_row) {
        for (std::size_t v = 0; v < of_row.size(); ++v) {
          slopes.measured(eigen_index(share.number), eigen_index(v)) +=
              share.weight * column_slope(*column, run.run(), run.by(v).derivative(), of_row[v]);
        }
        return true;
      });
    });
  }
  return along;
}

// \param like  the candidate's data; outlives the tasks
void add_along_tasks(const AlongRows& along, std::optional<Model::Data>& like, const DesignRows& rows,
                     DesignSlopes& slopes, Tasks& tasks) {
  for (const auto& [row, wanted] : along) {
    tasks[row].add(RatesAsked::kAll, [&, wanted = wanted](const SlopeRun& run, const auto& of_row) {
      for (std::size_t v = 0; v < of_row.size(); ++v) {
        const std::vector<double> table = run.table_slopes(*like, v, of_row[v]);
        for (const WeightedColumn& share : wanted) {
          slopes.measured(eigen_index(share.number), eigen_index(v)) +=
              share.weight * table[rows.table_slots[share.measure]];
        }
      }
      return true;
    });
  }
}

}  // namespace

std::optional<RunSlopes> RunSlopes::of(const DesignSetup& setup) {
  if (setup.settings.jerk || setup.settings.derivatives || setup.needs_check() || !is_covered(setup)) {
    return std::nullopt;
  }
  return RunSlopes(setup);
}

RunSlopes::RunSlopes(const DesignSetup& setup) : setup_(&setup) {
  const Model& model = setup.numbers.model();
  for (const Measure& measure : setup.measures) {
    columns_.push_back(body_column(model.mechanism(), model.units(), measure.column));
  }
}

std::optional<std::vector<MechanismDerivative>> RunSlopes::derivatives_at(std::span<const double> x) const {
  std::vector<MechanismDerivative> derivatives;
  for (std::size_t v = 0; v < x.size(); ++v) {
    auto derivative = setup_->numbers.derivative(v, x);
    if (!derivative) return std::nullopt;
    derivatives.push_back(*std::move(derivative));
  }
  return derivatives;
}

std::optional<DesignSlopes> RunSlopes::of_candidate(std::span<const double> x,
                                                    const DesignCandidate& candidate, int branch,
                                                    const DesignRows& rows,
                                                    std::span<const std::vector<SlopePlace>> places,
                                                    bool groups) const {
  const auto derivatives = derivatives_at(x);
  const bool elsewhere =
      std::any_of(rows.gap_rows.begin(), rows.gap_rows.end(), [](const auto& gap) { return gap.empty(); });
  if (!derivatives || (groups && elsewhere)) {
    return std::nullopt;
  }
  DesignSlopes slopes = no_slopes(x.size(), rows, places);
  Tasks tasks;
  add_rooms(*setup_, candidate, *derivatives, slopes);
  add_extent_tasks(*setup_, rows, slopes, tasks);
  const AlongRows along = add_column_tasks(*setup_, columns_, rows, slopes, tasks);
  if (along.size() > kMostAlong || (!along.empty() && !candidate.data)) {
    return std::nullopt;
  }
  std::optional<Model::Data> like;
  if (!along.empty()) like = *candidate.data;
  add_along_tasks(along, like, rows, slopes, tasks);
  add_path_tasks(places, slopes, tasks);
  if (groups) add_group_tasks(*setup_, rows, slopes, tasks);
  auto run = SlopeRun::start(*setup_, candidate, branch, *derivatives);
  if (!run || !carry_out(tasks, *run) || !slopes.measured.allFinite() || !slopes.gaps.allFinite()) {
    return std::nullopt;
  }
  return slopes;
}

}  // namespace higherpair
