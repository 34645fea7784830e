#pragma once

#include "front/analysis_impl.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/io/row_path.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace higherpair {

/// A place on the path through the rows of a run.
struct PathPlace {
  double row = 0;  ///< number of the row, with a fraction between two
  double at = 0;   ///< parameter of RowPath

  /// Number of the row; none between two rows.
  [[nodiscard]] std::optional<std::int64_t> on_row() const;
};

/// The motion of the drivers at the rows of a schedule and between them.
class DriverPlaces {
public:
  DriverPlaces(const Profile& profile, DriverSchedule schedule);

  /// State of each of Mechanism::drivers. On a row it is that of the row, whatever the schedule; between rows
  /// it is that at the time for a schedule in time, else interpolated linearly.
  [[nodiscard]] std::vector<DriverState> at(const PathPlace& place) const;
  /// The same at a time [s], whatever the rows. \pre the schedule is in time
  [[nodiscard]] std::vector<DriverState> at_time(double time) const;
  /// In the profile's unit; 0 if the schedule is not in time.
  [[nodiscard]] double time(const PathPlace& place) const;
  [[nodiscard]] const DriverSchedule& schedule() const { return schedule_; }

private:
  struct Scales {
    Dimension position;
    std::array<Scaling, 3> from_si;
    std::array<Scaling, 4> higher_to_si;
    std::optional<MotionLaw> law;
  };
  [[nodiscard]] DriverState state_at(const PathPlace& place, std::size_t driver) const;

  DriverSchedule schedule_;
  std::vector<Scales> drivers_;
  Scaling time_from_si_;
};

/// The largest speed of a driver on the path through a schedule; of a slide relative to the mechanism's size
/// [1/s].
[[nodiscard]] double largest_rate(const DriverSchedule& schedule, const Run& start);

[[nodiscard]] std::vector<DriverMotion> motions_of(const std::vector<DriverState>& drivers);

/// The columns of a run at any place on its path.
class PathColumns {
public:
  /// \param analysis  of which no row has been computed yet
  /// \param settings  with which the analysis was started
  PathColumns(const Analysis& analysis, RunSettings settings);

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_.columns(); }
  [[nodiscard]] const Dimension& dimension(std::size_t column) const { return columns_.dimension(column); }
  [[nodiscard]] const Model::Data& data() const { return *data_; }
  [[nodiscard]] const RunSettings& settings() const { return settings_; }
  [[nodiscard]] const Units& units() const { return data_->profile.units; }
  /// The run at the first positions, as started.
  [[nodiscard]] const Run& start() const { return start_; }
  [[nodiscard]] const RowPath& path() const { return path_; }
  [[nodiscard]] const DriverPlaces& drivers() const { return drivers_; }
  [[nodiscard]] double rate() const { return rate_; }  ///< largest_rate()
  [[nodiscard]] PathPlace place(double at) const { return {path_.row(at), at}; }
  [[nodiscard]] PathPlace place_of_row(std::int64_t row) const {
    return {static_cast<double>(row), parameter_of(row)};
  }

  /// The values of all columns at the place to which `run`, of this model, has moved; NaN: undefined.
  void values(const Run& run, const PathPlace& place, std::vector<double>& values);

private:
  [[nodiscard]] double parameter_of(std::int64_t row) const;

  std::shared_ptr<const Model::Data> data_;
  RunSettings settings_;
  Run start_;
  DriverPlaces drivers_;
  double rate_;
  RowPath path_;
  ColumnSet columns_;
  std::optional<InverseDynamics> dynamics_;
};

/// The values of all columns for a run from which no further rows are computed. \param forces  whether there
/// are columns of forces
[[nodiscard]] std::vector<double> values_of(ColumnSet& columns, bool forces, const Run& run,
                                            const std::vector<DriverState>& drivers, double time);

/// The same for a run whose mechanism has other numbers than the model.
/// \param like  a copy of the model's data; its mechanism is overwritten by that of the run
[[nodiscard]] std::vector<double> columns_of_run(Model::Data& like, const RunSettings& settings,
                                                 const Run& run, const std::vector<DriverState>& drivers,
                                                 double time);

/// Moves along a path from place to place, in their order, passing all rows and turning points between them.
class PathWalk {
public:
  explicit PathWalk(const PathColumns& columns) : columns_(&columns), run_(columns.start()) {}

  /// \pre place is not before the last one
  const Run& go_to(const PathPlace& place);

private:
  void move(const PathPlace& place);

  const PathColumns* columns_;
  Run run_;
  std::int64_t next_row_ = 0;  // first one not passed yet
  std::size_t next_knot_ = 0;
};

}  // namespace higherpair
