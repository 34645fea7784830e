#pragma once

#include "higherpair/front/error.hpp"
#include "higherpair/io/measured_table.hpp"

#include <string>
#include <vector>

namespace higherpair {

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
