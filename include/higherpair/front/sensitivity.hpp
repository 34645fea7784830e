#pragma once

#include "higherpair/front/measure.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/tasks.hpp"

#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// A measure of a run, and its name.
struct NamedMeasure {
  std::string name;
  Measure measure;
};

struct SensitivitySettings {
  bool in_time = false;                 ///< as RunSettings::in_time
  std::optional<std::int64_t> samples;  ///< as RunSettings::samples
  double tolerance = 1e-9;              ///< as RunSettings::tolerance
  /// Empty: those of [tolerances], else those of [sweep], else default_results().
  std::vector<NamedMeasure> results;
  /// Paths or globs ("bodies.*") of the numbers by which to differentiate. Empty: those of [tolerances], else
  /// the variables of [design], else every number of bodies, joints, loads, springs and gravity.
  std::vector<std::string> by;
  int threads = 0;                          ///< at most 1024; 0 or less: one for each available core
  const std::atomic<bool>* stop = nullptr;  ///< as RunSettings::stop
};

/// A number of the profile that results depend on.
struct SensitivityNumber {
  std::string name;                ///< as [tolerances] calls it, else its path
  std::vector<std::string> paths;  ///< several paths share one value and change together
  double value = 0;                ///< in the unit that it has in the profile
  std::string unit;                ///< that unit, "mm"; "1" for a pure number
  /// The change to which slopes by different numbers are referred to compare them: for a length the size of
  /// the mechanism, for an angle a radian, else the absolute value of the number, or 1 if it is 0. At least:
  /// for a driver's velocity and acceleration ω and ω² (of a slide times the size), ω the largest speed of a
  /// driver or root of an acceleration; for a coefficient of a conic what makes its term, at the conic's
  /// size, the largest of the equation.
  double scale = 1;
};

enum class SlopeKind {
  kExact,        ///< by implicit differentiation of the conditions of joints, contacts and drivers
  kDifferences,  ///< by central differences between whole runs with other numbers
  kKink,         ///< the slopes on the two sides differ: see Slope::down and Slope::up
  kNone,         ///< there is none; the remark says why
};

/// The derivative of a result with respect to a number, in the unit of the result per unit of the number.
struct Slope {
  SlopeKind kind = SlopeKind::kNone;
  double down = std::numeric_limits<double>::quiet_NaN();  ///< towards smaller numbers
  double up = std::numeric_limits<double>::quiet_NaN();    ///< towards larger ones; equal to `down` except
                                                           ///< at a kink
  double error = 0;    ///< of differences: error estimated from two step lengths
  std::string remark;  ///< empty: nothing special

  /// The one of larger absolute value, with its sign; NaN: none.
  [[nodiscard]] double steepest() const { return std::abs(down) > std::abs(up) ? down : up; }
  /// How much the result changes with the number, along the slope on that side.
  [[nodiscard]] double change(double of_number) const { return (of_number < 0 ? down : up) * of_number; }
};

/// A result and its derivatives.
struct ResultSensitivity {
  std::string name;
  Measure measure;
  std::string unit;
  double value = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> where;  ///< position of the (first) driver, or the time in a run in time; none for
                                ///< a range or mean
  /// For max, min and maxabs: the value and place of the closest competing extreme, which would become the
  /// result if it grew a little.
  std::optional<double> rival, rival_where;
  std::vector<Slope> slopes;  ///< one for each number of the report
  std::string remark;         ///< what is special about the value, or empty
};

struct SensitivityReport {
  std::string title;
  std::string where_unit;  ///< of ResultSensitivity::where
  bool in_time = false;    ///< whether the run was in time
  std::vector<SensitivityNumber> numbers;
  std::vector<ResultSensitivity> results;
  std::vector<Event> events;  ///< of the run, as Motion::events
  bool good = true;           ///< as Motion::good; false if stopped
  bool stopped = false;       ///< stopped early: slopes are missing
  Diagnostics notes;          ///< as Analysis::notes
};

/// The range and the largest acceleration of each joint to ground that is not driven, the largest pressure
/// angle of each contact, and with loads or masses the largest effort of each driver; if there is none of
/// these, the range of the angle of each moving body.
[[nodiscard]] std::vector<NamedMeasure> default_results(const Model& model);

/// Reads a measure such as "follower.alpha:maxabs", "slider.x:at=30" or "slider.x:at=0.5 rad"; its path is
/// the text itself. Fails for any other text. \param settings  say whether the run is in time; then X of at=X
/// is a time, else a position of the driver
[[nodiscard]] Result<NamedMeasure> measure_from(const Model& model, const std::string& text,
                                                const SensitivitySettings& settings = {});

/// How results of a run change with the numbers of its profile, each taken alone. Extremes (max, min, maxabs,
/// range) are those of the whole path, between its rows too, as in check(); mean and rms are those of the
/// rows.
///
/// With x the coordinates of the mechanism and F(x, p) = 0 the conditions of joints, contacts and drivers,
/// rates included, ∂F/∂x dx/dp = -∂F/∂p gives the change of every column with p at a fixed point of the path.
/// The derivative of an extreme is that of its column at the point of the extreme (envelope theorem: the
/// column is stationary there); an extreme at an end of the path stays there. Where two extremes are equal,
/// the column is constant over a stretch of the path, or it is the absolute value of something that is 0, the
/// result has a kink. Differences of whole runs are used instead for contacts that may part, columns of
/// arc length, extremes at a jump of their column, and numbers with which a curve of several parts does not
/// change smoothly.
///
/// Fails as Model::run does, for columns and paths that do not exist (the message suggests similar names),
/// and for a model built in C++.
[[nodiscard]] Result<SensitivityReport> sensitivity(const Model& model,
                                                    const SensitivitySettings& settings = {});

/// The derivatives of whole columns, row by row.
struct RowSlopes {
  std::int64_t row = 0;
  std::span<const double> values;  ///< one for each of SlopeTable::columns; NaN where undefined
  /// Derivatives of all columns with respect to the first number, then to the second one, …; NaN at a kink or
  /// jump.
  std::span<const double> slopes;
};

struct SlopeTable {
  std::vector<Column> columns;  ///< the position of the driver, or the time, and the columns asked for
  std::vector<SensitivityNumber> numbers;
  bool good = true;
  bool stopped = false;
};

/// Differentiates whole columns, row by row, in the same way as sensitivity(). Fails as that does, and for
/// columns none of which has derivatives: those of words, and the residual, which is rounding.
/// \param columns  names or globs; what they match without derivatives is left out. Empty: all
/// \param begin    called once before the first row, with the columns and numbers
/// \param take     receives each row; returning false ends it
[[nodiscard]] Result<SlopeTable> sensitivity_rows(const Model& model, const std::vector<std::string>& columns,
                                                  const SensitivitySettings& settings,
                                                  const std::function<void(const SlopeTable&)>& begin,
                                                  const std::function<bool(const RowSlopes&)>& take);

/// A statistical band extends this many standard deviations to either side: 99.73 % of a normal distribution.
inline constexpr double kBandSigmas = 3;
/// The same share lies between this quantile and 1 minus it.
inline constexpr double kBandQuantile = 0.00134989803163009;

/// The scatter of a result that changes linearly with every number. With s_i the slopes, m_i the middles of
/// the tolerance zones, σ_i the standard deviations and p_i the numbers of the profile:
///     centre = value + Σ s_i (m_i − p_i)
///     worst case: every number at the end of its zone that is worse
///     statistical: centre ± 3 σ, σ² = Σ Σ ρ_ik s_i σ_i s_k σ_k, but never beyond what the numbers give
///     together at the ends of their zones, or at 3 σ where a normal one has fewer in its zone,
/// with ρ_ii = 1, ρ_ik the coefficient of correlated numbers, else 0: the root sum of squares if none are
/// correlated (W. H. Greenwood and K. W. Chase, Worst case tolerance analysis with nonlinear problems, 1988).
/// At a kink σ takes the steeper slope.
struct ToleranceBand {
  double center = 0;
  double worst_low = 0, worst_high = 0;
  double deviation = 0;  ///< σ
  double low = 0, high = 0;
  /// Share of each tolerance in σ²: Σ_k ρ_ik s_i σ_i s_k σ_k/σ², negative if its scatter compensates that of
  /// others. They add up to 1; all are 0 if σ is.
  std::vector<double> shares;
  std::vector<std::size_t> order;  ///< indices of the tolerances, the largest share first
  bool complete = true;            ///< false: some slopes are not known and count as 0

  std::optional<double> within;  ///< the band required: value ± within
  bool kept = true;              ///< the statistical band is within it
  bool worst_kept = true;        ///< so is the worst case
  /// If it is not kept: the factor on the width of the zone of order.front() with which it would be; none: it
  /// would not be even without any scatter of this number.
  std::optional<double> tighten;
  /// The same for all zones at once; none: their middles alone shift the result too far.
  std::optional<double> tighten_all;
};

/// The bands of all results. \pre the report's numbers are those of the task
[[nodiscard]] std::vector<ToleranceBand> tolerance_bands(const ToleranceTask& task,
                                                         const SensitivityReport& report);

/// Largest number of variants for tolerances: all their results are kept in memory, for the quantiles.
inline constexpr std::int64_t kMostToleranceVariants = 100'000'000;

struct ToleranceVariantSettings {
  std::int64_t count = 100'000;  ///< from 1 to kMostToleranceVariants
  std::uint64_t seed = 1;
  int threads = 0;  ///< at most 1024; 0 or less: one for each available core
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::int64_t)> progress;  ///< called with the number of variants finished; may be empty
};

/// Distribution of a result over random variants, and that predicted by its slopes for the same variants.
struct VariantBand {
  double low = 0, median = 0, high = 0;  ///< quantiles kBandQuantile, 0.5 and 1 - kBandQuantile
  double mean = 0, deviation = 0;
  double linear_low = 0, linear_median = 0, linear_high = 0;  ///< predicted by value + Σ s_i Δp_i
  double farthest = 0;        ///< largest difference between a variant and its prediction
  double share_within = 1;    ///< share of the variants within the required band; 1 if none is required
  std::int64_t variants = 0;  ///< number of variants that have the result
  /// Whether the quantiles differ from the linear ones by more than kCurvedShare of the band's half width:
  /// the result is nonlinear within the tolerances, and the linear bands are off by as much.
  bool curved = false;
};
inline constexpr double kCurvedShare = 0.05;

struct ToleranceVariants {
  std::int64_t count = 0;
  std::int64_t good = 0;           ///< number of them whose path is good
  std::vector<VariantBand> bands;  ///< one for each of the report's results
  bool stopped = false;
};

/// Runs random variants of the model, whose numbers scatter according to the tolerances, and collects their
/// results. Extremes are those of the rows, corrected by what the rows of the model itself miss of its
/// extreme.
/// Fails as Sweep::of does, for a model without [tolerances], and for a report by other numbers than theirs.
/// \param report  sensitivity() of the model, whose results need not be those of [tolerances]
[[nodiscard]] Result<ToleranceVariants> tolerance_variants(const Model& model,
                                                           const SensitivityReport& report,
                                                           const ToleranceVariantSettings& settings = {});

}  // namespace higherpair
