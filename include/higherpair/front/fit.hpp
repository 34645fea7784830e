#pragma once

#include "higherpair/front/model.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/measured_table.hpp"
#include "higherpair/io/tasks.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Progress of a fit.
struct FitProgress {
  int starts = 0;      ///< searches finished
  int all_starts = 1;  ///< out of this many
  int rounds = 0;      ///< of estimating noise and weights, after the searches
  double off = 0;      ///< of the best so far: root mean square of the residuals, each relative to its
                       ///< column's spread
};

/// Each member that is set overrides [fit] of the profile.
struct FitSettings {
  std::optional<FitLoss> loss;
  std::optional<double> confidence;  ///< of the intervals, > 0 and < 1
  std::vector<std::string> columns;  ///< names or globs of the measured columns to use; empty: the profile's
  std::vector<std::string> offsets;  ///< columns with an unknown zero offset, in addition to those of the
                                     ///< profile
  std::optional<int> starts;         ///< number of searches, >= 1
  std::optional<std::uint64_t> seed;
  int threads = 0;  ///< 0 or less: all cores, at most 1024; does not affect the result
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const FitProgress&)> progress;  ///< called by one thread at a time; may be empty
};

enum class FitEnd { kConverged, kNotConverged, kStopped };

/// Numbers of a mechanism identified from its measured motion, in the units of the profile and of its tables;
/// NaN where undefined.
struct FitReport {
  static constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

  /// An unknown of the fit: a number of the profile, or one that describes how the motion was measured.
  struct Number {
    std::string name;
    std::vector<std::string> paths;  ///< empty for a number of the measurement
    std::string unit;
    double before = kUndefined;  ///< in the profile
    double after = kUndefined;
    double error = kUndefined;  ///< standard error
    double half = kUndefined;   ///< the interval is after ± half
    double low = kUndefined;    ///< bounds; NaN: none
    double high = kUndefined;
    bool at_bound = false;   ///< the fit would move it farther; the other numbers are those with it held
                             ///< there
    bool determined = true;  ///< whether the measured columns determine it
  };
  struct Column {
    std::string name;
    std::string unit;
    int values = 0;
    int outliers = 0;
    double noise = kUndefined;  ///< estimated standard deviation; a robust estimate for a loss other than
                                ///< squares
    std::optional<double> deviation;  ///< the same, as given
    double rms = kUndefined;          ///< of the residuals
    double largest = kUndefined;      ///< the residual of largest size, with its sign: measured less fitted
    double largest_at = kUndefined;   ///< driver or time
    double explained = kUndefined;    ///< R²: share of the variance that the motion explains
    bool unexplained = false;         ///< the values are farther from the fit than from their own mean
    double succession = kUndefined;   ///< autocorrelation of successive residuals
    bool systematic = false;          ///< the autocorrelation is more than chance
  };
  struct Residual {
    int line = 0;      ///< of the table
    double where = 0;  ///< driver or time as measured
    std::size_t column = 0;
    double measured = 0;
    double fitted = 0;
    double weight = 1;  ///< weight that the loss gives it
    bool outlier = false;
  };

  std::string title;
  bool in_time = false;
  std::string where_unit;           ///< of the driver, or of time
  std::vector<Number> variables;    ///< in the order of the profile
  std::vector<Number> measurement;  ///< offsets, and positions, angles and scales of frames
  std::vector<Column> columns;
  std::vector<Residual> residuals;        ///< row by row
  std::vector<std::string> undetermined;  ///< what the columns do not determine, a sentence each
  std::vector<std::string> notes;         ///< what else is worth knowing
  Eigen::MatrixXd correlation;            ///< of variables, then of the measurement's numbers
  FitLoss loss = FitLoss::kSquares;
  double confidence = 0;
  int freedoms = 0;                 ///< degrees of freedom: values minus unknowns
  double noise_ratio = kUndefined;  ///< size of the residuals relative to the deviations, if these are
                                    ///< given for all columns
  double chance = kUndefined;       ///< probability of residuals this large or larger if the given deviations
                                    ///< are right
  bool too_large = false;  ///< `chance` is below kLeastFitChance: the model, or the deviations, are wrong
  int missing = 0;         ///< values in rows that the fitted mechanism does not reach
  int starts = 0;
  int different = 0;   ///< distinct results of these
  int iterations = 0;  ///< of the fit from the best one
  bool exact = false;  ///< derivatives are exact, not differences
  FitEnd end = FitEnd::kConverged;
  /// Whether it converged, every number is determined, all rows are reached, no column is unexplained and
  /// `too_large` is false.
  bool good = false;
  /// The new profile: the text of the old one with new numbers.
  std::string text;
};

/// A residual larger than this multiple of the noise is an outlier.
inline constexpr double kOutlierDeviations = 4.685;
/// If `chance` is below this the residuals are too large for the given deviations.
inline constexpr double kLeastFitChance = 1e-4;

/// Finds the values of the variables of [design] with which the mechanism moves as measured: the least sum of
/// squares of the residuals in units of each column's noise, or of another loss. Intervals are those of
/// Student's t and the covariance (JᵀJ)⁻¹, to first order; for robust losses with Huber's corrections. Rows
/// are run in the order of the table, from the profile's first position.
/// Fails (kInput) for a model without variables or one built in C++; for settings beyond their ranges; for
/// columns that do not exist or have different lengths, no columns, fewer values than unknowns, variables
/// that change nothing in them, and values that look as if they were in another unit; (kMechanism) if the
/// mechanism cannot be started. \param measured  its columns have the names of the profile's; `driver` or
/// `time` locates each row
[[nodiscard]] Result<FitReport> fit(const Model& model, const MeasuredTable& measured,
                                    const FitSettings& settings = {});

/// The curve to fit to points of a boundary.
enum class FittedCurve { kLine, kCircle, kEllipse, kParabola, kHyperbola, kConic };

/// "line", "circle", "ellipse", "parabola", "hyperbola", "conic".
[[nodiscard]] const std::vector<std::string>& fitted_curve_names();

/// A curve through measured points. Lengths in the unit of the points, angles in degrees; NaN where
/// undefined.
struct CurveFitReport {
  struct Number {
    std::string name;  ///< "center x", "radius"
    std::string unit;
    double value = 0;
    double error = 0;  ///< standard error
    double half = 0;   ///< the interval is value ± half
  };
  struct Point {
    int line = 0;  ///< of the table
    double x = 0, y = 0;
    double distance = 0;  ///< from the curve, > 0 outside; for a line on the side of its normal
  };

  std::string type;  ///< type of the curve found, as in profiles
  std::string unit;
  std::vector<Number> numbers;
  std::vector<Point> points;
  double rms = 0;      ///< of the distances
  double noise = 0;    ///< the same, but per degree of freedom
  double largest = 0;  ///< the distance of largest size
  int largest_line = 0;
  double confidence = 0;
  std::string text;  ///< the curve as in a profile, `curves.fitted = { … }`, with a comment
};

/// The curve with the least sum of squared distances from the points. The table has columns `x` and `y`, or
/// one each whose name ends in that; their unit is that of the header, else mm. Fails (kInput) for missing
/// columns or ones of different lengths, different units of x and y, points that have no such curve, and a
/// confidence that is not > 0 and < 1.
[[nodiscard]] Result<CurveFitReport> fit_curve(const MeasuredTable& points, FittedCurve curve,
                                               double confidence = 0.95);

}  // namespace higherpair
