#include "front/demands.hpp"
#include "front/model_data.hpp"
#include "higherpair/drawing/outline_svg.hpp"
#include "higherpair/front/export.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/geometry/arc_polyline.hpp"
#include "higherpair/geometry/boundary_points.hpp"
#include "higherpair/io/dxf_writer.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

Result<double> tolerance_of(const Model& model, const ExportedCurve& curve, const ExportAccuracy& accuracy) {
  const double size = curve.boundary.size();
  const double least = finest_tolerance(curve.boundary);
  const double tolerance = accuracy.tolerance.value_or(std::max(kDefaultExportTolerance * size, least));
  const auto text = [&](double metres) {
    return fmt::format("{:.3g} {}", from_si(dimension::kLength, model.units()).apply(metres),
                       name_of(model.units().length));
  };
  if (least > kCoarsestShape * size) {
    return wrong(
        model,
        fmt::format("{} is too small to be drawn at {} from the origin of its body's frame: make it "
                    "at least {} large, or move the origin near it",
                    curve.name, text(curve.boundary.middle_B().norm()), text(1.01 * least / kCoarsestShape)));
  }
  if (!(tolerance >= least)) {
    return wrong(model, fmt::format("a tolerance of {} is finer than {} can be drawn: take at least {}",
                                    text(tolerance), curve.name, text(1.01 * least)));
  }
  return tolerance;
}

Result<std::vector<NamedOutline>> outlines_of(const Model& model, const std::vector<ExportedCurve>& curves,
                                              const ExportAccuracy& accuracy) {
  std::vector<NamedOutline> outlines;
  for (const ExportedCurve& curve : curves) {
    const auto tolerance = tolerance_of(model, curve, accuracy);
    if (!tolerance) {
      return tl::unexpected(tolerance.error());
    }
    outlines.push_back({curve.name, arc_polyline(curve.boundary, *tolerance)});
  }
  return outlines;
}

}  // namespace

Result<std::string> curve_csv(const Model& model, const ExportedCurve& curve, const ExportAccuracy& accuracy,
                              const Units& units) {
  if (std::string fault = first_unmet({at_least(2, "ExportAccuracy::points", accuracy.points.value_or(2))});
      !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  const auto tolerance = tolerance_of(model, curve, accuracy);
  if (!tolerance) {
    return tl::unexpected(tolerance.error());
  }
  const Dimension per_length = dimension::kNumber / dimension::kLength;
  const std::string length = unit_text(dimension::kLength, units);
  const std::vector<Column> columns = {{"x", length, {}},
                                       {"y", length, {}},
                                       {"nx", "1", {}},
                                       {"ny", "1", {}},
                                       {"curvature", unit_text(per_length, units), {}},
                                       {"arc", length, {}}};
  const Scaling lengths = from_si(dimension::kLength, units);
  const Scaling curvatures = from_si(per_length, units);
  std::string text;
  append_csv_header(columns, text);
  Row row;
  for (const BoundaryStation& at : accuracy.points ? points_at_equal_arcs(curve.boundary, *accuracy.points)
                                                   : points_within(curve.boundary, *tolerance)) {
    const double curvature = at.corner ? kNoValue : curvatures.apply(at.point.kappa);
    row.values = {lengths.apply(at.point.p_B.x()),
                  lengths.apply(at.point.p_B.y()),
                  at.point.n_B.x(),
                  at.point.n_B.y(),
                  curvature,
                  lengths.apply(at.arc)};
    append_csv_row(columns, row, text);
  }
  return text;
}

Result<std::string> curves_dxf(const Model& model, const std::vector<ExportedCurve>& curves,
                               const ExportAccuracy& accuracy, const Units& units) {
  return outlines_of(model, curves, accuracy).map([&](const std::vector<NamedOutline>& outlines) {
    std::vector<DxfOutline> layers;
    for (const NamedOutline& outline : outlines) {
      std::string layer = outline.name;
      std::replace(layer.begin(), layer.end(), '.', '-');  // DXF R12 allows no dots in names
      layers.push_back({std::move(layer), outline.line});
    }
    return dxf_text(layers, units.length);
  });
}

Result<std::string> curves_svg(const Model& model, const std::vector<ExportedCurve>& curves,
                               const ExportAccuracy& accuracy, const Units& units) {
  return outlines_of(model, curves, accuracy).map([&](const std::vector<NamedOutline>& outlines) {
    return outline_svg(outlines, model.mechanism().title, draw_settings(units).length);
  });
}

}  // namespace higherpair
