#include "read_boundary.hpp"

#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/tolerances.hpp"
#include "io/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

bool turned_round(TableReader& table, bool has_inside) {
  const char* const key = has_inside ? "side" : "material";
  table.refuse(has_inside ? "material" : "side",
               has_inside
                   ? "this curve has its material inside or outside: `side`"
                   : "an open curve has its material on the left or right of its direction: `material`");
  const auto choice = has_inside ? table.take(key, as_choice, {"inside", "outside"})
                                 : table.take(key, as_choice, {"left", "right"});
  return choice == 1U;
}

std::string name_of_piece(const Outline& outline, std::size_t i) {
  return outline.names.empty() ? "the curve" : outline.names[i % outline.names.size()];
}

// Of pieces that the profile names: those of a gear, which have no names, are as they have to be.
void note_slight_corners(TableReader& table, const Outline& outline) {
  if (outline.names.empty()) {
    return;
  }
  const std::size_t count = outline.pieces.size();
  for (std::size_t i = 0; i < (outline.closed ? count : count - 1); ++i) {
    const PieceEnd end = end_of(outline.pieces[i]);
    const Vector2d t = begin_of(outline.pieces[(i + 1) % count]).t_B;
    const double turn = angle_from_to(end.t_B, t);
    if (std::abs(turn) > kNoTurn && std::abs(turn) < kSlightTurn) {
      const std::string first = name_of_piece(outline, i), second = name_of_piece(outline, i + 1);
      note_whole(table, fmt::format("{} meet in a {} of {:.2g} deg at {}: if the joint is to be smooth, give "
                                    "more digits{}",
                                    first == second ? "two parts of " + first : first + " and " + second,
                                    turn > 0 ? "corner" : "notch", std::abs(turn) * 180 / kPi,
                                    point_text(table.reading(), end.p_B),
                                    outline.has_fillet ? ", or leave it to `fillet`" : ""));
      return;
    }
  }
}

// The index of the piece that a span of the boundary comes from: convex corners are spans but not pieces.
std::size_t piece_of(const Boundary& boundary, int span) {
  const auto begin = boundary.spans().begin();
  return static_cast<std::size_t>(
      std::count_if(begin, begin + span, [](const SpanPtr& s) { return !s->is_corner(); }));
}

// Names the two stretches between given points that are nearest to a self-crossing.
std::string between_points(const Outline& outline, const Vector2d& p) {
  const auto& points = outline.points;
  const auto distance = [&](std::size_t i) {
    const Vector2d& a = points[i];
    const Vector2d side = points[(i + 1) % points.size()] - a;
    const double part = std::clamp((p - a).dot(side) / std::max(side.squaredNorm(), kNeverZero), 0.0, 1.0);
    return (a + part * side - p).norm();
  };
  std::vector<std::size_t> order(points.size() - (outline.closed ? 0 : 1));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  const auto apart = [&](std::size_t i) {
    const std::size_t steps = i > order[0] ? i - order[0] : order[0] - i;
    return steps > 1 && steps + 1 < points.size();
  };
  const auto second = std::find_if(order.begin(), order.end(), apart);
  const auto name = [&](std::size_t i) { return outline.point_names[i % points.size()]; };
  std::string text = fmt::format(", behind {}", name(order[0]));
  if (second != order.end()) {
    text += fmt::format(" and behind {}", name(*second));
  }
  return text + " (are the points in their order?)";
}

bool report_fault(TableReader& table, const Outline& outline,
                  const tl::expected<Boundary, BoundaryFault>& made) {
  const Reading& reading = table.reading();
  if (!made) {
    const auto index = static_cast<std::size_t>(made.error().span);
    report_whole(table,
                 fmt::format("{} has a cusp or leaves the range of numbers", name_of_piece(outline, index)));
    return true;
  }
  if (const auto crossing = find_self_crossing(*made)) {
    const std::string first = name_of_piece(outline, piece_of(*made, crossing->first.span));
    const std::string second = name_of_piece(outline, piece_of(*made, crossing->second.span));
    std::string where;
    if (!outline.points.empty()) {
      where = between_points(outline, crossing->p_B);
    } else if (!outline.names.empty()) {
      where = fmt::format(", where {} and {} meet", first, second);
    }
    report_whole(table, fmt::format("crosses itself at {}{}: a boundary does not",
                                    point_text(reading, crossing->p_B), where));
    return true;
  }
  return false;
}

}  // namespace

std::string length_text(const Reading& reading, double metres) {
  return with_unit(metres, dimension::kLength, reading.units);
}

std::string point_text(const Reading& reading, const Vector2d& p) {
  const Scaling scaling = from_si(dimension::kLength, reading.units);
  // Print rounding errors of 0, and -0, as 0.
  const auto text = [&](double x) {
    return fmt::format("{:.6g}", std::abs(x) > kNoCoordinate * p.norm() ? scaling.apply(x) : 0.0);
  };
  return fmt::format("({}, {})", text(p.x()), text(p.y()));
}

bool report_gaps(TableReader& table, const Outline& outline) {
  const Reading& reading = table.reading();
  const std::size_t count = outline.pieces.size();
  for (std::size_t i = 0; i < (outline.closed ? count : count - 1); ++i) {
    const Vector2d end = end_of(outline.pieces[i]).p_B;
    const Vector2d begin = begin_of(outline.pieces[(i + 1) % count]).p_B;
    const double distance = (begin - end).norm();
    if (distance <= outline.tolerance) {
      continue;
    }
    const bool last = i + 1 == count;
    report_whole(
        table, fmt::format("{} ends at {} and {} begins at {}, {} away{}; ends within `tolerance` ({}) meet",
                           name_of_piece(outline, i), point_text(reading, end), name_of_piece(outline, i + 1),
                           point_text(reading, begin), length_text(reading, distance),
                           last ? ": it does not close (closed = false is open)" : "",
                           length_text(reading, outline.tolerance)));
    return true;
  }
  return false;
}

std::optional<NamedCurve> curve_of(TableReader& table, Outline outline) {
  const bool turn = turned_round(table, outline.closed || outline.has_inside);
  if (report_gaps(table, outline)) {
    return std::nullopt;
  }
  close_gaps(outline.pieces, outline.closed);
  const bool clockwise = outline.closed && enclosed_area(outline.pieces) < 0;
  if (turn != clockwise) {
    outline.pieces = reversed(outline.pieces);
    std::reverse(outline.names.begin(), outline.names.end());
  }
  if (outline.whole) {
    NamedCurve curve = {"", *outline.whole};
    curve.curve.side = turn ? Side::kOutside : Side::kInside;
    return curve;
  }
  return boundary_curve(table, outline);
}

std::optional<NamedCurve> boundary_curve(TableReader& table, const Outline& outline) {
  note_slight_corners(table, outline);
  auto boundary = Boundary::make(spans_of(outline.pieces), outline.closed, outline.tolerance);
  if (report_fault(table, outline, boundary)) {
    return std::nullopt;
  }
  NamedCurve curve;
  curve.curve.kind = CurveKind::kChain;
  curve.boundary = std::make_shared<const Boundary>(*std::move(boundary));
  return curve;
}

}  // namespace higherpair::io_detail
