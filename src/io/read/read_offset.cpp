#include "io/tolerances.hpp"
#include "read_boundary.hpp"

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// The offset of a curve whose offsets are again conics, lines or points; none: it has to be made from spans.
std::optional<CurveResult> plain_offset(const Curve& curve, double by) {
  if (curve.kind == CurveKind::kCircle) {
    const double sign = curve.side == Side::kInside ? 1 : -1;
    return make_circle(center(curve), curve.semi_latus + sign * by, curve.side);
  }
  if (is_line(curve)) {
    return make_line(curve.vertex_B - by * curve.axis_B, -curve.axis_B);
  }
  if (is_point(curve)) {
    return make_circle(curve.vertex_B, by);
  }
  return std::nullopt;
}

void report_offset(TableReader& table, const OffsetFault& fault) {
  const Reading& reading = table.reading();
  const std::string place = point_text(reading, fault.at_B);
  report(
      table.reading(), *table.take("by"),
      fault.kind == OffsetFault::Kind::kCusp
          ? fmt::format("the curve bends too sharply at {}: less than {} is possible there", place,
                        length_text(reading, fault.limit))
          : fmt::format("the corner at {} would be cut off: round it first, with a `fillet` larger than this",
                        place));
}

}  // namespace

std::optional<double> read_offset_distance(TableReader& table) {
  const Mistakes mistakes(table.reading());
  const auto item = table.need("by", "a distance, > 0 outwards");
  const auto by = item ? as_quantity(table.reading(), *item, {dimension::kLength}) : std::nullopt;
  for (const char* key : {"side", "material"}) {
    table.refuse(key, "an offset has its material where the other curve has it");
  }
  table.finish();
  return by && mistakes.none() ? std::optional(by->si) : std::nullopt;
}

std::optional<NamedCurve> read_offset(TableReader& table, double by, const NamedCurve& source) {
  Reading& reading = table.reading();
  const Item item = *table.take("by");
  NamedCurve curve;
  if (source.boundary == nullptr) {
    if (const auto plain = plain_offset(source.curve, by)) {
      if (!*plain) {
        report(reading, item, "leaves nothing of this curve");
        return std::nullopt;
      }
      curve.curve = **plain;
      return curve;
    }
    if (source.curve.kind != CurveKind::kEllipse) {
      report(reading, item, "a parabola or hyperbola has no ends: an offset of it cannot be drawn");
      return std::nullopt;
    }
  }
  const Boundary whole = source.boundary != nullptr ? *source.boundary : boundary_of(source.curve, 1);
  auto spans = offset_spans(whole, by);
  if (!spans) {
    report_offset(table, spans.error());
    return std::nullopt;
  }
  Outline outline;
  outline.closed = whole.is_closed();
  outline.pieces.assign(spans->begin(), spans->end());
  outline.tolerance = kOffsetGap * whole.size();  // they meet as exactly as those of the source
  return boundary_curve(table, outline);
}

}  // namespace higherpair::io_detail
