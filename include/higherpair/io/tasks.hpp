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

namespace higherpair {

/// How a measure reduces the values v of its column, over all rows of a run that have one.
enum class MeasureKind {
  kMax,
  kMin,
  kMaxAbs,  ///< max |v|
  kRange,   ///< max v − min v
  kMean,    ///< with equal weight for every row
  kRms,     ///< √(mean of v²), likewise
  kFirst,   ///< v in the first row of the run
  kLast,
  kAt,  ///< v in the row at a given driver position or time
};

/// The values of the key `of`, in the order of MeasureKind.
inline constexpr std::array<std::string_view, 9> kMeasureNames = {"max", "min",   "maxabs", "range", "mean",
                                                                  "rms", "first", "last",   "at"};

/// As profiles write it: "max".
[[nodiscard]] constexpr std::string_view name_of(MeasureKind kind) {
  return kMeasureNames[static_cast<std::size_t>(kind)];
}

/// One number about a run, as a profile asks for it: `{ column = "follower.alpha", of = "max" }`.
struct Measure {
  std::string column;
  MeasureKind of = MeasureKind::kMax;
  double at = 0;          ///< for kAt: position of the (first) driver, or the time in a run in time; in the
                          ///< unit of tables
  Place place;            ///< of the column's name in the profile
  std::string path;       ///< key path of the same, "sweep.results.peak.column"
  bool followed = false;  ///< made for one value of a `follow` list of [design], not written as a measure
};

/// A column of a sweep's table: one number about the run of each variant.
struct SweepResult {
  std::string name;
  Measure measure;
  bool where = false;  ///< adds a column NAME.where: Measured::where
};

/// The task in [sweep]: many variants of the profile, and the results wanted of each.
struct SweepTask {
  VariantPlan plan;
  std::vector<SweepResult> results;  ///< in one row per variant
  std::vector<std::string> rows;     ///< names or globs of columns; not empty: all rows of every run instead
  bool in_time = false;              ///< runs in time, as `step`
  bool counts = false;               ///< adds columns with the numbers of rows of each status and of events
  Place place;                       ///< of [sweep] in the profile
  std::vector<std::string> units;    ///< one for each variable, as tables show them; "1" for a pure number
};

/// A number of the profile that has a tolerance. All values are in the unit that the number has in the
/// profile.
struct Tolerance {
  std::string name;
  std::vector<std::string> paths;  ///< as in --set; several paths share one value
  double value = 0;                ///< as the profile has it
  double minus = 0;                ///< the zone is from value − minus …
  double plus = 0;                 ///< … to value + plus; −minus < plus, either may be negative
  std::string unit;                ///< "mm"; "1" for a pure number
  DistributionKind kind = DistributionKind::kNormal;  ///< centred on the middle of the zone; not kValues
  double sigmas = 3;  ///< for a normal one: half the width of the zone in standard deviations
  Place place;

  [[nodiscard]] double middle() const { return value + (plus - minus) / 2; }
  /// Half the width of the zone, > 0.
  [[nodiscard]] double half() const { return (plus + minus) / 2; }
  [[nodiscard]] double deviation() const;
  /// The distribution that variants are drawn from. A normal one is not truncated at the ends of the zone.
  [[nodiscard]] Distribution distribution() const;
};

/// A result of the run that the tolerances affect.
struct ToleranceResult {
  std::string name;
  Measure measure;
  std::optional<double> within;  ///< largest deviation allowed, in the unit of tables; > 0
};

/// The task in [tolerances]: which numbers scatter, and the results wanted.
struct ToleranceTask {
  std::vector<Tolerance> tolerances;      ///< at least one
  std::vector<Correlation> correlations;  ///< between tolerances, both normal
  std::vector<ToleranceResult> results;   ///< may be empty
  bool in_time = false;                   ///< runs in time, as `step`
  Place place;

  /// Random variants with this scatter; their number is left open.
  [[nodiscard]] VariantPlan variants() const;
};

/// How a residual counts, by its size in units of the noise of its column.
enum class FitLoss {
  kSquares,  ///< by its square
  kHuber,    ///< by its square up to 1.345, linearly beyond: for a few wrong values
  kTukey,    ///< by its square with a weight that falls to 0 at 4.685 (Tukey's biweight): for many values
             ///< that are far off
};

/// "squares", "huber", "tukey".
[[nodiscard]] const std::vector<std::string>& fit_loss_names();
[[nodiscard]] std::string_view name_of(FitLoss loss);

/// The task in [fit] of a profile: how the columns were measured. The unknowns are the variables of [design].
struct FitTask {
  /// [[fit.columns]]
  struct Column {
    std::string column;               ///< name or glob
    std::optional<double> deviation;  ///< standard deviation of its noise, in the unit of tables; none:
                                      ///< estimated
    double weight = 1;                ///< weight of its squares
    bool offset = false;              ///< it has an unknown zero offset
    Place place;
    std::string path;  ///< "fit.columns.0"
  };
  /// [[fit.frames]]: a point whose path was measured in a frame of its own.
  struct Frame {
    std::string point;      ///< "coupler.E"
    bool position = false;  ///< whether the position of that frame is unknown,
    bool turn = false;      ///< its angle,
    bool scale = false;     ///< and its unit of length
    Place place;
    std::string path;
  };

  std::vector<Column> columns;
  std::vector<Frame> frames;
  std::vector<std::string> use;  ///< names or globs of the measured columns to use; empty: all
  FitLoss loss = FitLoss::kSquares;
  double confidence = 0.95;
  std::optional<int> starts;
  std::optional<std::uint64_t> seed;
  Place place;  ///< of [fit]; of the whole profile if there is none
};

/// The keys of [limits]: limits for the behaviour of a mechanism, and the material of its bodies.
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
/// Why a value in SI units makes no sense as this limit: "must be > 0"; empty if it does.
[[nodiscard]] std::string objection_to(LimitKey key, double value);

struct GivenLimit {
  double value = 0;               ///< SI units
  std::optional<double> profile;  ///< in the units of the profile, as written
  std::string path;               ///< "limits.contacts.touch.max_pressure_angle"
  Place place;
};

/// Indexed by LimitKey; none where no limit is given.
using LimitSet = std::array<std::optional<GivenLimit>, kLimitKeys>;

/// [limits]: the general limits, and those of individual contacts, joints and bodies.
struct CheckLimits {
  LimitSet all;
  std::vector<LimitSet> contacts;  ///< one for each of Mechanism::contacts; may be empty
  std::vector<LimitSet> joints;    ///< one for each of Mechanism::joints; may be empty
  std::vector<LimitSet> bodies;    ///< one for each of Mechanism::bodies; may be empty
};

/// The limit of one contact, joint or body: its own, else the general one; null if neither is given.
[[nodiscard]] const GivenLimit* limit_of(const CheckLimits& limits, const std::vector<LimitSet>& own,
                                         std::size_t index, LimitKey key);

}  // namespace higherpair
