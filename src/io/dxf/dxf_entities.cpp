#include "dxf_entities.hpp"

#include "dxf_numbers.hpp"
#include "higherpair/geometry/spline_span.hpp"
#include "io/tolerances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

using ReadShape = tl::expected<DxfShape, DxfFault>;

constexpr double kDegree = kPi / 180;

ReadShape result(const DxfNumbers& numbers, DxfShape shape) {
  if (numbers.fault()) {
    return tl::unexpected(*numbers.fault());
  }
  return shape;
}

// The piece seen from below: x changes sign.
ContourPiece mirrored(const ContourPiece& piece) {
  const auto mirror = [](const Vector2d& p) { return Vector2d(-p.x(), p.y()); };
  if (const auto* line = std::get_if<LinePiece>(&piece)) {
    return LinePiece{mirror(line->from), mirror(line->to)};
  }
  const auto& arc = std::get<ArcPiece>(piece);
  return ArcPiece{mirror(arc.center), arc.radius, kPi - arc.from, -arc.sweep};
}

void check_arc(DxfNumbers& numbers, const ContourPiece& piece) {
  const auto* arc = std::get_if<ArcPiece>(&piece);
  if (arc != nullptr && !make_circle(arc->center, arc->radius)) {
    numbers.refuse("has an arc too small to compute with: are the units right?");
  }
}

ReadShape line(DxfNumbers& numbers) {
  const LinePiece piece = {numbers.need_point(10, "first point"), numbers.need_point(11, "second point")};
  return result(numbers, piece.from == piece.to ? DxfShape{} : DxfShape{{piece}, std::nullopt});
}

ReadShape arc(DxfNumbers& numbers) {
  ArcPiece piece;
  piece.center = numbers.need_point(10, "centre");
  piece.radius = numbers.need_radius();
  piece.from = numbers.need(50, "start angle") * kDegree;
  const double sweep = std::fmod(numbers.need(51, "end angle") * kDegree - piece.from, 2 * kPi);
  piece.sweep = sweep > 0 ? sweep : sweep + 2 * kPi;
  check_arc(numbers, piece);
  return result(numbers, {{numbers.facing() < 0 ? mirrored(piece) : piece}, std::nullopt});
}

ReadShape circle(DxfNumbers& numbers) {
  ArcPiece piece = {numbers.need_point(10, "centre"), numbers.need_radius(), 0, 2 * kPi};
  piece.center.x() *= numbers.facing();
  check_arc(numbers, piece);
  if (numbers.fault()) {
    return tl::unexpected(*numbers.fault());
  }
  return DxfShape{{piece}, *make_circle(piece.center, piece.radius)};
}

// The angle of the normal at the parameter u of an ellipse; equal to u at multiples of a quarter turn.
double normal_at(double a, double b, double u) {
  return nearest_turn(std::atan2(a * std::sin(u), b * std::cos(u)), u);
}

ReadShape ellipse(DxfNumbers& numbers) {
  const Vector2d center = numbers.need_point(10, "centre");
  const Vector2d axis = numbers.need_point(11, "major axis");
  const double ratio = numbers.need(40, "ratio of its axes");
  double from = numbers.find(41).value_or(0);
  double to = numbers.find(42).value_or(2 * kPi);
  if (numbers.facing() < 0) {
    from = -std::exchange(to, -from);
  }
  const double a = axis.norm();
  const double b = ratio * a;
  const auto curve = make_ellipse(center, {a, b}, angle_of(axis));
  if (!numbers.fault() && (!curve || !(ratio > 0))) numbers.refuse("has axes that are not > 0");
  if (numbers.fault()) {
    return tl::unexpected(*numbers.fault());
  }
  double sweep = std::fmod(to - from, 2 * kPi);
  sweep = sweep > kWholeTurn ? sweep : sweep + 2 * kPi;
  if (sweep >= 2 * kPi - kWholeTurn) {
    return DxfShape{{conic_span(*curve, 0, 2 * kPi)}, *curve};
  }
  const double turn = angle_of(axis);
  return DxfShape{{conic_span(*curve, turn + normal_at(a, b, from), turn + normal_at(a, b, from + sweep))},
                  std::nullopt};
}

struct Vertex {
  Vector2d p = Vector2d::Zero();
  double bulge = 0;  // tan(angle of the arc to the next vertex / 4), > 0 counter-clockwise
};

ReadShape polyline(DxfNumbers& numbers, const std::vector<Vertex>& vertices, bool closed) {
  const bool below = numbers.facing() < 0;
  DxfShape shape;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < vertices.size(); ++i) {
    const Vertex& a = vertices[i];
    const Vertex& b = vertices[(i + 1) % vertices.size()];
    if (a.p != b.p) {
      const ContourPiece piece = bow_piece(a.p, b.p, 4 * std::atan(a.bulge));
      check_arc(numbers, piece);
      shape.pieces.push_back(below ? mirrored(piece) : piece);
    }
  }
  return result(numbers, std::move(shape));
}

ReadShape light_polyline(DxfNumbers& numbers) {
  std::vector<Vertex> vertices;
  for (const DxfPair& pair : numbers.pairs()) {
    if (pair.code == 10) {
      vertices.push_back({{numbers.length(pair), 0}});
    } else if (pair.code == 20 && !vertices.empty()) {
      vertices.back().p.y() = numbers.length(pair);
    } else if (pair.code == 42 && !vertices.empty()) {
      vertices.back().bulge = numbers.value(pair);
    }
  }
  const auto count = numbers.find(90);
  if (count && *count != static_cast<double>(vertices.size())) {
    numbers.refuse(fmt::format("announces {} vertices and has {}: is it damaged?", *count, vertices.size()));
  }
  return polyline(numbers, vertices, (numbers.flags() & 1U) != 0);
}

ReadShape old_polyline(DxfNumbers& numbers, const std::vector<DxfGroup>& groups) {
  constexpr unsigned kNotPlane = 8U | 16U | 64U;  // 3D polylines and meshes
  constexpr unsigned kFrame = 16U;                // a control vertex of a fitted spline
  if ((numbers.flags() & kNotPlane) != 0) {
    numbers.refuse("is a polyline or mesh in space: flatten it");
  }
  std::vector<Vertex> vertices;
  for (const DxfGroup& group : groups) {
    DxfNumbers vertex(group, numbers.unit());
    if ((vertex.flags() & kFrame) == 0) {
      const Vector2d p = vertex.need_point(10, "place");
      vertices.push_back({p, vertex.find(42).value_or(0)});
    }
    if (vertex.fault()) {
      return tl::unexpected(*vertex.fault());
    }
  }
  return polyline(numbers, vertices, (numbers.flags() & 1U) != 0);
}

std::string fault_of(const NurbsCurve& curve, double degree) {
  const std::size_t count = curve.control.size();
  if (!(degree >= 1 && degree <= kHighestNurbsDegree && degree == std::floor(degree))) {
    return fmt::format("has the degree {}: 1 to {} are read", degree, kHighestNurbsDegree);
  }
  if (count == 0) {
    return "has points that it goes through and no control points: save the drawing with them";
  }
  if (count <= static_cast<std::size_t>(curve.degree)) {
    return fmt::format("has {} control points: its degree takes at least {}", count, curve.degree + 1);
  }
  if (curve.knots.size() != count + static_cast<std::size_t>(curve.degree) + 1) {
    return fmt::format("has {} knots where {} control points and degree {} take {}", curve.knots.size(),
                       count, curve.degree, count + static_cast<std::size_t>(curve.degree) + 1);
  }
  if (!std::is_sorted(curve.knots.begin(), curve.knots.end())) {
    return "has knots that fall";
  }
  if (!curve.weights.empty() && curve.weights.size() != count) {
    return fmt::format("has {} weights for {} control points", curve.weights.size(), count);
  }
  const bool positive =
      std::all_of(curve.weights.begin(), curve.weights.end(), [](double w) { return w > 0; });
  return positive ? "" : "has a weight that is not > 0";
}

ReadShape spline(DxfNumbers& numbers) {
  NurbsCurve curve;
  for (const DxfPair& pair : numbers.pairs()) {
    if (pair.code == 40) curve.knots.push_back(numbers.value(pair));
    if (pair.code == 41) curve.weights.push_back(numbers.value(pair));
    if (pair.code == 10) curve.control.emplace_back(numbers.length(pair), 0);
    if (pair.code == 20 && !curve.control.empty()) {
      curve.control.back().y() = numbers.length(pair);
    }
  }
  const double degree = numbers.need(71, "degree");
  curve.degree = static_cast<int>(std::clamp(degree, 0.0, 100.0));
  if (const std::string fault = fault_of(curve, degree); !numbers.fault() && !fault.empty()) {
    numbers.refuse(fault);
  }
  if (numbers.fault()) {
    return tl::unexpected(*numbers.fault());
  }
  if (std::all_of(curve.weights.begin(), curve.weights.end(),
                  [&](double w) { return w == curve.weights.front(); })) {
    curve.weights.clear();
  }
  DxfShape shape;
  for (SpanPtr& span : nurbs_spans(curve)) {
    shape.pieces.emplace_back(std::move(span));
  }
  return shape;
}

struct CurveType {
  std::string_view name;
  ReadShape (*read)(DxfNumbers& numbers);  // none for POLYLINE, which also needs its vertices
};

constexpr CurveType kCurves[] = {{"LINE", line},       {"ARC", arc},       {"CIRCLE", circle},
                                 {"ELLIPSE", ellipse}, {"SPLINE", spline}, {"LWPOLYLINE", light_polyline},
                                 {"POLYLINE", nullptr}};

const CurveType* find_type(std::string_view name) {
  const auto type = std::find_if(std::begin(kCurves), std::end(kCurves),
                                 [&](const CurveType& candidate) { return candidate.name == name; });
  return type == std::end(kCurves) ? nullptr : type;
}

}  // namespace

bool is_dxf_curve(std::string_view type) {
  return find_type(type) != nullptr;
}

tl::expected<DxfShape, DxfFault> dxf_shape(const DxfGroup& entity, const std::vector<DxfGroup>& vertices,
                                           const Scaling& unit) {
  DxfNumbers numbers(entity, unit);
  const CurveType* type = find_type(entity.type);
  assert(type != nullptr);
  return type->read == nullptr ? old_polyline(numbers, vertices) : type->read(numbers);
}

}  // namespace higherpair::io_detail
