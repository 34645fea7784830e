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

/// Where a fit is.
struct FitProgress {
  int starts = 0;      ///< searches that are done
  int all_starts = 1;  ///< of so many
  int rounds = 0;      ///< of noise and weights, behind the searches
  double off = 0;      ///< of the best so far: root mean square of the residuals, each by its column's spread
};

/// Each that is set replaces what [fit] of the profile says.
struct FitSettings {
  std::optional<FitLoss> loss;
  std::optional<double> confidence;  ///< of the intervals, within 0 … 1
  std::vector<std::string> columns;  ///< names or globs of the measured columns that count; empty: the
                                     ///< profile's
  std::vector<std::string> offsets;  ///< columns whose zero is not known, besides those of the profile
  std::optional<int> starts;
  std::optional<std::uint64_t> seed;
  int threads = 0;  ///< 0: all; makes no difference to the result
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const FitProgress&)> progress;  ///< called by one thread at a time; may be empty
};

enum class FitEnd { kConverged, kNotConverged, kStopped };

/// Numbers of a mechanism that were found from its measured motion. All in the units of the profile and of
/// its tables; NaN where undefined.
struct FitReport {
  static constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

  /// A number that was looked for: one of the profile, or one of how it was measured.
  struct Number {
    std::string name;
    std::vector<std::string> paths;  ///< none of what belongs to the measurement
    std::string unit;
    double before = kUndefined;  ///< in the profile
    double after = kUndefined;
    double error = kUndefined;  ///< standard error
    double half = kUndefined;   ///< the interval is after ± half
    double low = kUndefined;    ///< bounds; NaN: none
    double high = kUndefined;
    bool at_bound = false;   ///< it would go on; the other numbers are those for it there
    bool determined = true;  ///< whether the columns say what it is
  };
  struct Column {
    std::string name;
    std::string unit;
    int values = 0;
    int outliers = 0;
    double noise = kUndefined;  ///< standard deviation, estimated; robustly with a loss other than squares
    std::optional<double> deviation;  ///< the same, as given
    double rms = kUndefined;          ///< of the residuals
    double largest = kUndefined;      ///< the residual of largest size, with its sign: measured less fitted
    double largest_at = kUndefined;   ///< driver or time
    double explained = kUndefined;    ///< R²: share of the variance that the motion explains
    double succession = kUndefined;   ///< autocorrelation of residuals that follow one another
    bool systematic = false;          ///< it is more than chance
  };
  struct Residual {
    int line = 0;      ///< of the table
    double where = 0;  ///< driver or time as measured
    std::size_t column = 0;
    double measured = 0;
    double fitted = 0;
    double weight = 1;  ///< what the loss leaves of it
    bool outlier = false;
  };

  std::string title;
  bool in_time = false;
  std::string where_unit;           ///< of the driver, or of time
  std::vector<Number> variables;    ///< in the order of the profile
  std::vector<Number> measurement;  ///< offsets, and places, angles and scales of frames
  std::vector<Column> columns;
  std::vector<Residual> residuals;        ///< row by row
  std::vector<std::string> undetermined;  ///< what the columns do not say, a sentence each
  std::vector<std::string> notes;         ///< what else is worth knowing
  Eigen::MatrixXd correlation;            ///< of variables, then of the measurement's numbers
  FitLoss loss = FitLoss::kSquares;
  double confidence = 0;
  int freedoms = 0;                 ///< values less numbers looked for
  double noise_ratio = kUndefined;  ///< size of the residuals in deviations, where all columns have one given
  double chance = kUndefined;  ///< that residuals are so large or larger if the deviations given are right
  bool too_large = false;      ///< they are: the model, or the deviations, are wrong
  int missing = 0;             ///< values in rows that the fitted mechanism does not come to
  int starts = 0;
  int different = 0;   ///< ends of these
  int iterations = 0;  ///< of the fit from the best one
  bool exact = false;  ///< derivatives are exact, not differences
  FitEnd end = FitEnd::kConverged;
  /// Whether it converged, every number is determined, all rows are there and nothing says that the model is
  /// wrong.
  bool good = false;
  /// The new profile: the old one's text with other numbers in it.
  std::string text;
};

/// A residual's size in units of noise from which on it is called an outlier.
inline constexpr double kOutlier = 4.685;
/// Below this chance residuals are too large for the deviations given.
inline constexpr double kUnlikely = 1e-4;

/// Looks for the variables of [design] with which the mechanism moves as was measured: that the squares of
/// the residuals, in units of each column's noise, add up to the least (or another loss). Intervals are those
/// of Student's t and the covariance (JᵀJ)⁻¹ to first order, of robust losses Huber's. Rows are run in the
/// order of the table, from the profile's first position.
/// \param measured  its columns have the names of the profile's; `driver` or `time` says where each row is
/// Fails (kInput) for a model without variables or one that was built; for columns that do not exist, no
/// columns, fewer values than unknowns, variables that change nothing in them, and values that look as if
/// they were in another unit; (kMechanism) where the mechanism cannot be started.
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
    double distance = 0;  ///< from the curve, > 0 outside; of a line on the side of its normal
  };

  std::string type;  ///< as profiles call the curve that was found
  std::string unit;
  std::vector<Number> numbers;
  std::vector<Point> points;
  double rms = 0;      ///< of the distances
  double noise = 0;    ///< the same per degree of freedom
  double largest = 0;  ///< the distance of largest size
  int largest_line = 0;
  double confidence = 0;
  std::string text;  ///< the curve as a profile has it, `curves.fitted = { … }`, with a comment
};

/// The curve from which the points are least far, by the sum of squared distances. The table has columns `x`
/// and `y`, or one each whose names end so; their unit is that of the header, else mm. Fails (kInput) for
/// columns that are not there, units of two kinds, and points that have no such curve.
[[nodiscard]] Result<CurveFitReport> fit_curve(const MeasuredTable& points, FittedCurve curve,
                                               double confidence = 0.95);

}  // namespace higherpair
