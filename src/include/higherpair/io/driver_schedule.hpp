#pragma once

#include "higherpair/analysis/driver_curve.hpp"
#include "higherpair/cam/motion_law.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/profile.hpp"
#include "higherpair/io/units.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// One driver in one row.
struct DriverState {
  DriverMotion profile;  ///< in the profile's units, as tables show them
  DriverMotion si;
  HigherRates higher_si{};  ///< 0 unless a law drives
};

/// The driver positions of a run, row by row. Rows are computed on demand: a schedule of ten million rows
/// takes no more memory than one of ten.
class DriverSchedule {
public:
  /// Most rows of a run: their numbers are exact doubles.
  static constexpr std::int64_t kMostRows = std::int64_t{1} << 53;

  /// The rows of `analyze` and `forces`: the given positions, or
  ///     start + (end - start) k/(samples - 1),   k = 0 … samples - 1,
  /// correctly rounded and exact at both ends; velocity and acceleration are the profile's in every row.
  /// If a law drives, the rows are in time, from 0 to the end of the law that ends last; other drivers move
  /// as in step(). A driver with a law and explicit positions has at each of them the velocity and
  /// acceleration with which the law first reaches it. Fails if `samples` is below 1 or above 2^53, or given
  /// for explicit positions or a prismatic driver without `end`; if the drivers have unequal numbers of
  /// positions; and if a law ends before time 0, does not reach a position, or occurs together with explicit
  /// positions of another driver.
  /// \param samples replaces the profile's `samples` of every driver (the option --samples).
  [[nodiscard]] static tl::expected<DriverSchedule, Diagnostics> analyze(
      const Profile& profile, std::optional<std::int64_t> samples = std::nullopt);

  /// The rows of `step`: t = k time_step up to duration and a last row at duration, position = start +
  /// velocity t + acceleration t²/2. A remainder of the duration below 1e-9 time steps (or the rounding of
  /// their number) is ignored: duration 6 and time_step 0.01 give 601 rows. t is the double nearest to k
  /// times the decimal number that is given as time_step (3 times 0.1 is 0.3). If a law drives, the duration
  /// is by default up to the end of the law that ends last, and without a time step there are `samples` rows.
  /// At a jump of the law a row has the rates after it, except that the last row has those before it.
  /// Duration and time step may be given by any of several drivers, but not differently. Fails if one of them
  /// is missing, for more than 2^53 rows, and if the motion leaves the range of a double or turns a driver
  /// more than 1e9 times.
  /// \param samples number of rows, equally spaced over the duration, instead of `time_step`.
  [[nodiscard]] static tl::expected<DriverSchedule, Diagnostics> step(
      const Profile& profile, std::optional<std::int64_t> samples = std::nullopt);

  /// Number of rows, >= 1.
  [[nodiscard]] std::int64_t size() const { return size_; }

  /// Number of drivers: that of Mechanism::drivers, in the same order.
  [[nodiscard]] std::size_t driver_count() const { return drivers_.size(); }

  /// Whether rows have a time (made by `step`, or where a law drives).
  [[nodiscard]] bool is_timed() const { return timed_; }

  /// Whether positions are given one by one; else they are equally spaced, or a function of time.
  [[nodiscard]] bool is_listed() const;

  /// Time of a row in the profile's unit and in seconds; 0 in a schedule without time.
  [[nodiscard]] double time(std::int64_t row) const;
  [[nodiscard]] double time_si(std::int64_t row) const { return time_to_si_.apply(time(row)); }

  /// The drivers at any time of a schedule in time [s], in SI units and radians; at a jump of a law, after
  /// it.
  [[nodiscard]] DriverMotion at_time(double time_si, std::size_t driver) const;

  /// The motion of several drivers in time; null for one driver, for rows without time, and where nothing
  /// moves.
  [[nodiscard]] const std::shared_ptr<const DriverCurve>& curve() const { return curve_; }

  /// The time, in the profile's unit, at which the drivers pass a place on their path from the row before to
  /// `row`: a single driver by its law of motion, several in proportion to the time.
  /// \param position  of a single driver, in the profile's unit
  /// \param share     fraction of that path
  [[nodiscard]] double passing_time(std::int64_t row, double position, double share) const;

  /// One driver in one row. \pre 0 <= row < size(), driver < driver_count().
  [[nodiscard]] DriverState state(std::int64_t row, std::size_t driver = 0) const;

  /// How far a driver goes in all, there and back [rad or m].
  [[nodiscard]] double travel(std::size_t driver) const;

  /// Its largest speed, in any row and, in time, between them [rad/s or m/s].
  [[nodiscard]] double greatest_speed(std::size_t driver) const;

  /// The positions of all drivers in the first row [rad or m].
  [[nodiscard]] std::vector<double> first_positions() const;

  /// Where the driver turns back between a row and the one before.
  struct TurningPoint {
    DriverMotion si;   ///< the driver at rest, in SI units and radians
    double share = 0;  ///< fraction of the time between the rows
  };

  /// The turning points of a single driver in time, in order; none unless it turns back strictly between the
  /// rows.
  [[nodiscard]] std::vector<TurningPoint> turning_points(std::int64_t row) const;

  /// Whether a single driver goes from one row to a later one without turning back, whatever the rows between
  /// them; false for several drivers.
  [[nodiscard]] bool is_one_way(std::int64_t from, std::int64_t to) const;

  /// Where velocity or acceleration of a law jumps.
  struct LawJump {
    std::size_t driver = 0;
    double time = 0;      ///< in the profile's unit
    double position = 0;  ///< of the driver in the profile's unit
    LawJoin join;         ///< the join, as in the first repetition of the law
  };

  /// The jumps after the row before up to and including this one, in order; not those at the ends of the run.
  [[nodiscard]] std::vector<LawJump> law_jumps(std::int64_t row) const;

  /// Times strictly within a run in time, ascending [s], at which a driver turns back or a law changes to
  /// another function.
  [[nodiscard]] std::vector<double> breaks() const;

  /// The same with the first and the last time of the run.
  [[nodiscard]] std::vector<double> knots() const;

private:
  struct OneDriver {
    std::vector<double> positions;  ///< explicit ones; else start … end
    double start = 0;
    double end = 0;
    double velocity = 0;
    double acceleration = 0;
    Scaling position_to_si;
    Scaling velocity_to_si;
    Scaling acceleration_to_si;
    std::array<Scaling, 4> higher_to_si;
    std::optional<MotionLaw> law;
    std::vector<double> times;  ///< at which the law reaches the explicit positions
  };

  DriverSchedule() = default;
  static std::vector<OneDriver> drivers_of(const Profile& profile);
  static tl::expected<DriverSchedule, Diagnostics> in_time(const Profile& profile,
                                                           std::optional<std::int64_t> samples,
                                                           bool equally_spaced);
  [[nodiscard]] DriverMotion values(std::int64_t row, const OneDriver& driver) const;
  [[nodiscard]] LawSide side_of(std::int64_t row) const;
  [[nodiscard]] double way(const OneDriver& driver, double from, double to) const;
  [[nodiscard]] std::shared_ptr<const DriverCurve> make_curve() const;
  [[nodiscard]] static std::vector<double> reversals(const OneDriver& driver, double from, double to);

  std::vector<OneDriver> drivers_;
  std::int64_t size_ = 1;
  bool timed_ = false;
  double duration_ = 0;
  double time_step_ = 0;       ///< 0: rows are equally spaced over the duration
  double time_step_rest_ = 0;  ///< the decimal number given, less its double
  Scaling time_to_si_;
  Scaling time_from_si_;
  std::shared_ptr<const DriverCurve> curve_;
};

}  // namespace higherpair
