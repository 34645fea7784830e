#include "fit_data.hpp"
#include "fit_statistics.hpp"
#include "front/demands.hpp"
#include "front/model_data.hpp"
#include "higherpair/front/fit.hpp"
#include "higherpair/geometry/boundary_fit.hpp"
#include "higherpair/io/diagnostic.hpp"

#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr double kDegrees = 180 / kPi;

// The column of that name, or the only one whose name ends in it.
Result<const MeasuredColumn*> coordinate(const MeasuredTable& table, const std::string& name) {
  const MeasuredColumn* found = nullptr;
  int count = 0;
  std::vector<std::string> names;
  for (const MeasuredColumn& column : table.columns) {
    names.push_back(column.name);
    if (column.name == name) return &column;
    if (!column.name.ends_with("." + name)) continue;
    found = &column;
    ++count;
  }
  if (count == 1) return found;
  return wrong(Place{table.source},
               fmt::format("needs a column `{}`{}", name,
                           count > 1 ? ": several names end in it" : "; " + suggestion(name, names)));
}

BoundaryFitResult fitted(const std::vector<Vector2d>& points, FittedCurve curve) {
  switch (curve) {
    case FittedCurve::kLine:
      return fit_line(points);
    case FittedCurve::kCircle:
      return fit_circle(points);
    case FittedCurve::kEllipse:
      return fit_conic(points, ConicForm::kEllipse);
    case FittedCurve::kParabola:
      return fit_conic(points, ConicForm::kParabola);
    case FittedCurve::kHyperbola:
      return fit_conic(points, ConicForm::kHyperbola);
    case FittedCurve::kConic:
      break;
  }
  return fit_conic(points);
}

std::size_t least_count(FittedCurve curve) {
  switch (curve) {
    case FittedCurve::kLine:
      return 2;
    case FittedCurve::kCircle:
      return 3;
    case FittedCurve::kParabola:
      return 4;
    default:
      return 5;
  }
}

struct Form {
  std::string type;
  std::vector<std::string> names;
  std::vector<bool> angles;
};

Form form_of(const BoundaryFit& fit) {
  switch (fit.curve.kind) {
    case CurveKind::kLine:
      return {"line", {"point x", "point y", "normal"}, {false, false, true}};
    case CurveKind::kParabola:
      return {"parabola", {"vertex x", "vertex y", "focal_length", "rotation"}, {false, false, false, true}};
    case CurveKind::kHyperbola:
      return {"hyperbola",
              {"center x", "center y", "semi_axis a", "semi_axis b", "rotation"},
              {false, false, false, false, true}};
    default:
      if (fit.parameters.size() == 3)
        return {"circle", {"center x", "center y", "radius"}, {false, false, false}};
      return {"ellipse",
              {"center x", "center y", "semi_axis a", "semi_axis b", "rotation"},
              {false, false, false, false, true}};
  }
}

// In the form that read_curves() reads.
std::string curve_text(const CurveFitReport& report) {
  const auto value = [&](std::size_t i) { return report.numbers[i].value; };
  if (report.type == "line") {
    return fmt::format("{{ type = \"line\", point = [{}, {}], normal = {} }}", value(0), value(1), value(2));
  }
  if (report.type == "circle") {
    return fmt::format("{{ type = \"circle\", center = [{}, {}], radius = {} }}", value(0), value(1),
                       value(2));
  }
  if (report.type == "parabola") {
    return fmt::format("{{ type = \"parabola\", vertex = [{}, {}], focal_length = {}, rotation = {} }}",
                       value(0), value(1), value(2), value(3));
  }
  return fmt::format("{{ type = \"{}\", center = [{}, {}], semi_axes = [{}, {}], rotation = {} }}",
                     report.type, value(0), value(1), value(2), value(3), value(4));
}

struct PointColumns {
  const MeasuredColumn* x;
  const MeasuredColumn* y;
  std::string unit;
};

// The columns of the points, whose numbers are lengths in one unit.
Result<PointColumns> point_columns(const MeasuredTable& points) {
  const auto x = coordinate(points, "x"), y = coordinate(points, "y");
  if (!x || !y) {
    return tl::unexpected(x ? y.error() : x.error());
  }
  for (const MeasuredColumn* column : {*x, *y}) {
    if (column->mistake) return wrong(column->mistake->place, column->mistake->message);
    const auto unit = find_unit(column->unit);
    if (!column->unit.empty() && !(unit && dimension_of(*unit) == dimension::kLength)) {
      return wrong(column->place,
                   fmt::format("{}[{}]: expected a unit of length, such as mm", column->name, column->unit));
    }
  }
  if ((*x)->unit != (*y)->unit) {
    return wrong((*y)->place, fmt::format("x is in {} and y in {}: both have to be in one unit",
                                          (*x)->unit.empty() ? "no unit" : (*x)->unit,
                                          (*y)->unit.empty() ? "no unit" : (*y)->unit));
  }
  return PointColumns{*x, *y, (*x)->unit.empty() ? "mm" : (*x)->unit};
}

// Adds the curve's numbers with their confidence intervals, in the report's unit and in degrees.
void add_numbers(const BoundaryFit& fit, const Form& form, CurveFitReport& report) {
  // The point and normal of a line have two degrees of freedom.
  const std::size_t freedoms_used = form.type == "line" ? 2 : form.names.size();
  const double quantile = student_quantile(
      static_cast<double>(report.points.size()) - static_cast<double>(freedoms_used), report.confidence);
  for (std::size_t i = 0; i < form.names.size(); ++i) {
    const auto k = eigen_index(i);
    const double scale = form.angles[i] ? kDegrees : 1;
    const double error = scale * std::sqrt(fit.covariance(k, k));
    report.numbers.push_back({form.names[i], form.angles[i] ? "deg" : report.unit, scale * fit.parameters[i],
                              error, quantile * error});
  }
}

void set_distances(const BoundaryFit& fit, CurveFitReport& report) {
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    report.points[i].distance = fit.distances[i];
    if (i == 0 || std::abs(fit.distances[i]) > std::abs(report.largest)) {
      report.largest = fit.distances[i];
      report.largest_line = report.points[i].line;
    }
  }
  report.rms = fit.rms;
  report.noise = fit.noise;
}

}  // namespace

const std::vector<std::string>& fitted_curve_names() {
  static const std::vector<std::string> names = {"line",     "circle",    "ellipse",
                                                 "parabola", "hyperbola", "conic"};
  return names;
}

Result<CurveFitReport> fit_curve(const MeasuredTable& given, FittedCurve curve, double confidence) {
  if (std::string fault = first_unmet({share("confidence", confidence)}); !fault.empty()) {
    return wrong(Place{given.source}, std::move(fault));
  }
  const auto table = whole(given);
  if (!table) {
    return tl::unexpected(table.error());
  }
  const MeasuredTable& points = *table;
  const auto measured = point_columns(points);
  if (!measured) {
    return tl::unexpected(measured.error());
  }
  CurveFitReport report;
  report.unit = measured->unit;
  report.confidence = confidence;
  std::vector<Vector2d> places;
  for (std::size_t k = 0; k < points.lines.size(); ++k) {
    const Vector2d p(measured->x->values[k], measured->y->values[k]);
    if (p.hasNaN()) continue;
    places.push_back(p);
    report.points.push_back({points.lines[k], p.x(), p.y(), 0});
  }
  const auto fit = fitted(places, curve);
  if (!fit) {
    const std::string more =
        fit.error() == BoundaryFitError::kTooFew ? fmt::format(": at least {} are needed", least_count(curve))
        : fit.error() == BoundaryFitError::kOtherForm ? ": try --curve conic, or measure more of the curve"
                                                      : "";
    return wrong(Place{points.source}, fmt::format("no {} can be fitted: the {} points {}{}",
                                                   fitted_curve_names()[static_cast<std::size_t>(curve)],
                                                   places.size(), describe(fit.error()), more));
  }
  const Form form = form_of(*fit);
  report.type = form.type;
  add_numbers(*fit, form, report);
  set_distances(*fit, report);
  report.text = fmt::format(
      "# {} fitted to {} points of {}: rms distance {:.3g} {}; lengths in {}, angles in deg{}\ncurves.fitted "
      "= {}\n",
      report.type, places.size(), points.source, report.rms, report.unit, report.unit,
      report.type == "line" ? "; the normal points away from the body: add 180 if that is on the other side"
                            : "",
      curve_text(report));
  return report;
}

}  // namespace higherpair
