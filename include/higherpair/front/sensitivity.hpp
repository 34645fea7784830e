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

/// A number about a run, and what it is called.
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
  /// every number of bodies, joints, loads, springs and gravity.
  std::vector<std::string> by;
  int threads = 0;                          ///< so many; 0: as many as there are cores to be used
  const std::atomic<bool>* stop = nullptr;  ///< as RunSettings::stop
};

/// A number of the profile that results depend on.
struct SensitivityNumber {
  std::string name;                ///< as [tolerances] calls it, else its path
  std::vector<std::string> paths;  ///< several have one value and change together
  double value = 0;                ///< in the unit that it has in the profile
  std::string unit;                ///< that unit, "mm"; "1" of a pure number
  /// A change of it that weighs as much as those of others by theirs: of a length the size of the mechanism,
  /// of an angle a radian, of others the number itself, or 1 where it is 0.
  double scale = 1;
};

enum class SlopeKind {
  kExact,        ///< by implicit differentiation of what joints, contacts and drivers have to do
  kDifferences,  ///< by central differences between whole runs with other numbers
  kKink,         ///< it is another one to either side: see Slope::down and Slope::up
  kNone,         ///< there is none; the remark says why
};

/// The derivative of a result by a number, in the unit of the result per unit of the number.
struct Slope {
  SlopeKind kind = SlopeKind::kNone;
  double down = std::numeric_limits<double>::quiet_NaN();  ///< towards smaller numbers
  double up = std::numeric_limits<double>::quiet_NaN();    ///< towards larger ones; equal but for a kink
  double error = 0;    ///< of differences: how far off it may be, as two step lengths show
  std::string remark;  ///< empty: nothing special

  /// The one of larger size, with its sign; NaN: none.
  [[nodiscard]] double steepest() const { return std::abs(down) > std::abs(up) ? down : up; }
};

/// A result and its derivatives.
struct ResultSensitivity {
  std::string name;
  Measure measure;
  std::string unit;
  double value = std::numeric_limits<double>::quiet_NaN();
  std::optional<double> where;  ///< position of the (first) driver, in time the time; none of a range or mean
  /// Of max, min and maxabs: another extreme and its place that would become the result if it grew by a
  /// little; the nearest.
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
  bool good = true;           ///< as Motion::good
  bool stopped = false;       ///< slopes are missing
  Diagnostics notes;          ///< as Analysis::notes
};

/// Of each joint to ground that is not driven its range and its largest acceleration, of each contact its
/// largest pressure angle, with loads or masses the largest effort of each driver; where there is none of
/// these, of each moving body the range of its angle.
[[nodiscard]] std::vector<NamedMeasure> default_results(const Model& model);

/// "follower.alpha:maxabs", "slider.x:at=30": a measure of which the path is the text itself. Fails for what
/// is none.
[[nodiscard]] Result<NamedMeasure> measure_from(const std::string& text);

/// How results of a run change with the numbers of its profile, each by itself. Extremes (max, min, maxabs,
/// range) are those of the whole path, whatever its rows, as check() has them; mean and rms are of the rows.
///
/// With x the coordinates of the mechanism and F(x, p) = 0 what joints, contacts and drivers have to do,
/// rates included, ∂F/∂x dx/dp = -∂F/∂p gives how every column changes with p at a fixed place of the path.
/// The derivative of an extreme is that of its column at the place of the extreme (envelope theorem: the
/// column is level there); at the ends of the path that place is fixed. Where two extremes are equal the
/// result has a kink. Contacts that may part, arcs, extremes at a jump of their column, and numbers by which
/// a curve of several parts does not change smoothly are differentiated by differences of whole runs instead.
///
/// Fails as Model::run does, for columns and paths that do not exist (the message names those that are like
/// it), and for a model that was built.
[[nodiscard]] Result<SensitivityReport> sensitivity(const Model& model,
                                                    const SensitivitySettings& settings = {});

/// The derivatives of whole columns, row by row.
struct RowSlopes {
  std::int64_t row = 0;
  std::span<const double> values;  ///< of SlopeTable::columns; NaN where undefined
  /// Of the columns by the numbers: first all columns by the first number, then by the second one, ….
  std::span<const double> slopes;
};

struct SlopeTable {
  std::vector<Column> columns;  ///< the place (driver, or time), and those that were asked for
  std::vector<SensitivityNumber> numbers;
  bool good = true;
  bool stopped = false;
};

/// Differentiates whole columns, row by row, with all that sensitivity() says of derivatives. Fails as it
/// does, and for columns of words, which have none.
/// \param columns  names or globs
/// \param begin    called once before the first row, with the columns and numbers
/// \param take     takes a row; false ends it
[[nodiscard]] Result<SlopeTable> sensitivity_rows(const Model& model, const std::vector<std::string>& columns,
                                                  const SensitivitySettings& settings,
                                                  const std::function<void(const SlopeTable&)>& begin,
                                                  const std::function<bool(const RowSlopes&)>& take);

/// So many standard deviations to either side are a statistical band: 99.73 % of a normal distribution.
inline constexpr double kBandSigmas = 3;
/// The quantiles between which as much lies.
inline constexpr double kBandQuantile = 0.00134989803163009;

/// How a result scatters where it changes with every number along its slope. With s_i the slopes, t_i half
/// the widths of the zones, m_i their middles and p_i the numbers of the profile:
///     centre = value + Σ s_i (m_i − p_i)
///     worst case: every number at the end of its zone that is worse
///     statistical: centre ± 3 σ, σ² = Σ Σ ρ_ik s_i σ_i s_k σ_k, but never beyond the worst case
/// with ρ_ii = 1 and ρ_ik of correlated numbers, else 0: the root sum of squares where none are (W. H.
/// Greenwood and K. W. Chase, Worst case tolerance analysis with nonlinear problems, 1988). A slope that is
/// another one to either side counts as the steeper one in σ.
struct ToleranceBand {
  double center = 0;
  double worst_low = 0, worst_high = 0;
  double deviation = 0;  ///< σ
  double low = 0, high = 0;
  /// Of each tolerance in σ²: Σ_k ρ_ik s_i σ_i s_k σ_k/σ², negative where its scatter makes up for that of
  /// others. Their sum is 1; all 0 where σ is.
  std::vector<double> shares;
  std::vector<std::size_t> order;  ///< the tolerances, the largest share first
  bool complete = true;            ///< false: some slopes are not known and count as 0

  std::optional<double> within;  ///< what is wanted: value ± within
  bool kept = true;              ///< the statistical band is within it
  bool worst_kept = true;        ///< so is the worst case
  /// Where it is not kept: the factor on the width of the zone of order.front() that would make it so; none:
  /// even without any scatter of this number it would not be.
  std::optional<double> tighten;
  /// The same factor on all zones at once; none: their middles alone are too far off.
  std::optional<double> tighten_all;
};

/// The bands of all results. \pre the report's numbers are those of the task
[[nodiscard]] std::vector<ToleranceBand> tolerance_bands(const ToleranceTask& task,
                                                         const SensitivityReport& report);

struct ToleranceVariantSettings {
  std::int64_t count = 100'000;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: as many as there are cores to be used
  std::optional<std::int64_t> samples;
  double tolerance = 1e-9;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::int64_t)> progress;  ///< told how many variants are done; may be empty
};

/// What of a result random variants show, beside what its slopes say of the same variants.
struct VariantBand {
  double low = 0, median = 0, high = 0;  ///< quantiles kBandQuantile, 0.5 and 1 - kBandQuantile
  double mean = 0, deviation = 0;
  double linear_low = 0, linear_median = 0, linear_high = 0;  ///< of value + Σ s_i (p_i − value of p_i)
  double farthest = 0;        ///< largest difference between a variant and its linear value
  double share_within = 1;    ///< of the variants; 1 where nothing is wanted
  std::int64_t variants = 0;  ///< that have the result
  /// Whether the quantiles differ from the linear ones by more than kCurved of the band's half width: the
  /// result bends within the tolerances, and the linear bands are that far off.
  bool curved = false;
};
inline constexpr double kCurved = 0.05;

struct ToleranceVariants {
  std::int64_t count = 0;
  std::int64_t good = 0;           ///< how many of them have a path that is good
  std::vector<VariantBand> bands;  ///< of the report's results
  bool stopped = false;
};

/// Runs random variants of the model, whose numbers scatter as the tolerances say, and takes the results of
/// each. Extremes are those of the rows; what the rows miss of an extreme of the model itself is added.
/// \pre report is sensitivity() of the model with its [tolerances]. Fails as Sweep::of does
[[nodiscard]] Result<ToleranceVariants> tolerance_variants(const Model& model,
                                                           const SensitivityReport& report,
                                                           const ToleranceVariantSettings& settings = {});

}  // namespace higherpair
