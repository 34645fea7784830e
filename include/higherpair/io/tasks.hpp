#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/profile.hpp"
#include "higherpair/io/units.hpp"
#include "higherpair/sweep/variants.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// What a measure says of the values v of its column, over all rows of a run in which it has one.
enum class MeasureKind {
  kMax,
  kMin,
  kMaxAbs,  ///< max |v|
  kRange,   ///< max v − min v
  kMean,    ///< every row counts as much as every other
  kRms,     ///< √(mean of v²), likewise
  kFirst,   ///< v in the first row of the run
  kLast,
  kAt,  ///< v in the row at a given place
};

/// The words of the key `of`, by MeasureKind.
inline constexpr std::array<std::string_view, 9> kMeasureNames = {"max", "min",   "maxabs", "range", "mean",
                                                                  "rms", "first", "last",   "at"};

[[nodiscard]] constexpr std::string_view name_of(MeasureKind kind) {
  return kMeasureNames[static_cast<std::size_t>(kind)];
}

/// One number about a run, as a profile asks for it: `{ column = "follower.alpha", of = "max" }`.
struct Measure {
  std::string column;
  MeasureKind of = MeasureKind::kMax;
  double at = 0;     ///< of kAt: position of the (first) driver, of a run in time the time; as tables show it
  Place place;       ///< of the column's name in the profile
  std::string path;  ///< of the same, "sweep.results.peak.column"
};

/// A column of a sweep's table: one number about the run of each variant.
struct SweepResult {
  std::string name;
  Measure measure;
  bool where = false;  ///< a column NAME.where as well: Measured::where
};

/// What [sweep] asks for: many variants of the profile, and what of each.
struct SweepTask {
  VariantPlan plan;
  std::vector<SweepResult> results;  ///< one row a variant
  std::vector<std::string> rows;     ///< names or globs of columns; not empty: all rows of every run instead
  bool in_time = false;              ///< runs in time, as `step`
  bool counts = false;               ///< columns of how many rows have which status, and of how many events
  Place place;                       ///< of [sweep] in the profile
  std::vector<std::string> units;    ///< of each variable, as tables show them; "1" of a pure number
};

/// A number of the profile that is made with a tolerance. All numbers are in the unit in which the number
/// stands in the profile.
struct Tolerance {
  std::string name;
  std::vector<std::string> paths;  ///< as --set names them; several have one value
  double value = 0;                ///< as the profile has it
  double minus = 0;                ///< the zone is from value − minus …
  double plus = 0;                 ///< … to value + plus; −minus < plus, either may be negative
  std::string unit;                ///< "mm"; "1" of a pure number
  DistributionKind kind = DistributionKind::kNormal;  ///< about the middle of the zone; not kValues
  double sigmas =
      3;  ///< of a normal one: the ends of the zone are so many standard deviations from its middle
  Place place;

  [[nodiscard]] double middle() const { return value + (plus - minus) / 2; }
  /// Half the width of the zone, > 0.
  [[nodiscard]] double half() const { return (plus + minus) / 2; }
  [[nodiscard]] double deviation() const;
  /// As variants draw it. A normal one is not cut off at the ends of the zone.
  [[nodiscard]] Distribution distribution() const;
};

/// A number about the run that tolerances move.
struct ToleranceResult {
  std::string name;
  Measure measure;
  std::optional<double> within;  ///< it shall not move by more, in the unit of tables; > 0
};

/// What [tolerances] says: which numbers scatter, and what of the run is wanted.
struct ToleranceTask {
  std::vector<Tolerance> tolerances;      ///< at least one
  std::vector<Correlation> correlations;  ///< between tolerances, both normal
  std::vector<ToleranceResult> results;   ///< may be empty
  bool in_time = false;                   ///< runs in time, as `step`
  Place place;

  /// Random variants that scatter so; how many is left open.
  [[nodiscard]] VariantPlan variants() const;
};

class ProfileDocument;

/// How a residual counts, in units of the noise of its column.
enum class FitLoss {
  kSquares,  ///< by its square
  kHuber,    ///< by its square up to 1.345, beyond in proportion: for a few wrong values
  kTukey,    ///< by less and less beyond 1, from 4.685 on not at all: for many, far off
};

/// "squares", "huber", "tukey".
[[nodiscard]] const std::vector<std::string>& fit_loss_names();
[[nodiscard]] std::string_view name_of(FitLoss loss);

/// What [fit] of a profile says of the columns that were measured. Which numbers are unknown say the
/// variables of [design].
struct FitTask {
  /// [[fit.columns]]
  struct Column {
    std::string column;               ///< name or glob
    std::optional<double> deviation;  ///< standard deviation of its noise, in the unit of tables; none: found
    double weight = 1;                ///< how much its squares count
    bool offset = false;              ///< its zero is not known
    Place place;
    std::string path;  ///< "fit.columns.0"
  };
  /// [[fit.frames]]: a point whose path was measured in a frame of its own.
  struct Frame {
    std::string point;      ///< "coupler.E"
    bool position = false;  ///< whether the place of that frame is free,
    bool turn = false;      ///< its angle,
    bool scale = false;     ///< and its unit of length
    Place place;
    std::string path;
  };

  std::vector<Column> columns;
  std::vector<Frame> frames;
  std::vector<std::string> use;  ///< names or globs of the measured columns that count; empty: all
  FitLoss loss = FitLoss::kSquares;
  double confidence = 0.95;
  std::optional<int> starts;
  std::optional<std::uint64_t> seed;
  Place place;  ///< of [fit]; of the whole profile where there is none
};

/// [fit] of a profile that was read without a mistake; what holds without it where there is none.
[[nodiscard]] FitTask fit_task_of(const ProfileDocument& document, const Profile& profile);

/// What a profile may say in [limits]: limits of what a mechanism does, and what its bodies are made of.
enum class LimitKey {
  kMaxPressureAngle,
  kMaxReturnPressureAngle,
  kMinConvexRadius,
  kMinConcaveRadius,
  kMaxFaceWidth,
  kMaxSlidingSpeed,
  kMinEntrainmentSpeed,
  kMaxContactForce,
  kMinContactForce,
  kMaxContactPressure,
  kMaxAcceleration,
  kMaxAngularAcceleration,
  kMaxJerk,
  kMaxAngularJerk,
  kMaxDrivingTorque,
  kMaxDrivingForce,
  kMinSpeedFactor,
  kElasticModulus,
  kPoissonRatio,
  kWidth,
};
inline constexpr std::size_t kLimitKeys = 20;

/// Its name in profiles: "max_pressure_angle".
[[nodiscard]] std::string_view name_of(LimitKey key);
[[nodiscard]] Dimension dimension_of(LimitKey key);

struct GivenLimit {
  double value = 0;               ///< SI units
  std::optional<double> profile;  ///< in those of the profile, as written
  std::string path;               ///< "limits.contacts.touch.max_pressure_angle"
  Place place;
};

/// By LimitKey; none where it is not given.
using LimitSet = std::array<std::optional<GivenLimit>, kLimitKeys>;

/// [limits]: what holds for all, and what some contacts, joints and bodies have for themselves.
struct CheckLimits {
  LimitSet all;
  std::vector<LimitSet> contacts;  ///< of Mechanism::contacts; may be empty
  std::vector<LimitSet> joints;    ///< of Mechanism::joints; may be empty
  std::vector<LimitSet> bodies;    ///< of Mechanism::bodies; may be empty
};

/// The limit of one of these things: its own, else that of all; null where neither is given.
[[nodiscard]] const GivenLimit* limit_of(const CheckLimits& limits, const std::vector<LimitSet>& own,
                                         std::size_t index, LimitKey key);

}  // namespace higherpair
