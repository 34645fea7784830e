#include "higherpair/geometry/contour.hpp"

#include "higherpair/numeric/overload.hpp"

#include <Eigen/Geometry>

namespace higherpair {
namespace {

PieceEnd end_of_arc(const ArcPiece& arc, double angle) {
  const Vector2d e = unit_vector(angle);
  return {arc.center + arc.radius * e, arc.sweep > 0 ? perp(e) : Vector2d(-perp(e))};
}

SpanPtr arc_span(const ArcPiece& arc) {
  if (arc.sweep > 0) {
    return conic_span(*make_circle(arc.center, arc.radius), arc.from, arc.from + arc.sweep);
  }
  // Outward normals of a concave arc point to its centre.
  return conic_span(*make_circle(arc.center, arc.radius, Side::kOutside), arc.from + arc.sweep + kPi,
                    arc.from + kPi);
}

template <class Found>
void for_each_point(const std::vector<ContourPiece>& pieces, const Found& found) {
  for (const SpanPtr& span : spans_of(pieces)) {
    const Bounds range = span->range();
    for (int k = 0; k <= span->parts(); ++k) {
      found(span->at(range.low + range.width() * k / span->parts()).p_B);
    }
  }
}

}  // namespace

PieceEnd end_at(const Span& span, double t) {
  const SpanPoint point = span.at(t);
  return {point.p_B, perp(point.n_B)};
}

PieceEnd begin_of(const ContourPiece& piece) {
  return std::visit(Overload{[](const LinePiece& line) {
                               return PieceEnd{line.from, (line.to - line.from).normalized()};
                             },
                             [](const ArcPiece& arc) { return end_of_arc(arc, arc.from); },
                             [](const SpanPtr& span) { return end_at(*span, span->range().low); }},
                    piece);
}

PieceEnd end_of(const ContourPiece& piece) {
  return std::visit(Overload{[](const LinePiece& line) {
                               return PieceEnd{line.to, (line.to - line.from).normalized()};
                             },
                             [](const ArcPiece& arc) { return end_of_arc(arc, arc.from + arc.sweep); },
                             [](const SpanPtr& span) { return end_at(*span, span->range().high); }},
                    piece);
}

ContourPiece reversed(const ContourPiece& piece) {
  return std::visit(Overload{[](const LinePiece& line) -> ContourPiece {
                               return LinePiece{line.to, line.from};
                             },
                             [](const ArcPiece& arc) -> ContourPiece {
                               return ArcPiece{arc.center, arc.radius, arc.from + arc.sweep, -arc.sweep};
                             },
                             [](const SpanPtr& span) -> ContourPiece { return reversed_span(span); }},
                    piece);
}

std::vector<ContourPiece> reversed(const std::vector<ContourPiece>& pieces) {
  std::vector<ContourPiece> back;
  back.reserve(pieces.size());
  for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
    back.push_back(reversed(*piece));
  }
  return back;
}

SpanPtr span_of(const ContourPiece& piece) {
  return std::visit(
      Overload{[](const LinePiece& line) { return face_span(line.from, line.to); },
               [](const ArcPiece& arc) { return arc_span(arc); }, [](const SpanPtr& span) { return span; }},
      piece);
}

std::vector<SpanPtr> spans_of(const std::vector<ContourPiece>& pieces) {
  std::vector<SpanPtr> spans;
  spans.reserve(pieces.size());
  for (const ContourPiece& piece : pieces) {
    spans.push_back(span_of(piece));
  }
  return spans;
}

double enclosed_area(const std::vector<ContourPiece>& pieces) {
  double area = 0;
  std::optional<Vector2d> origin;
  Vector2d before = Vector2d::Zero();
  for_each_point(pieces, [&](const Vector2d& p) {
    if (!origin) origin = p;
    const Vector2d arm = p - *origin;
    area += cross(before, arm);
    before = arm;
  });
  return area;
}

double size_of(const std::vector<ContourPiece>& pieces) {
  Eigen::AlignedBox2d box;
  for_each_point(pieces, [&](const Vector2d& p) { box.extend(p); });
  return box.isEmpty() ? 0 : box.diagonal().norm() / 2;
}

void close_gaps(std::vector<ContourPiece>& pieces, bool closed) {
  const std::size_t last = closed ? 0 : 1;  // pieces without a next one
  for (std::size_t i = 0; i + last < pieces.size(); ++i) {
    ContourPiece& next = pieces[(i + 1) % pieces.size()];
    auto* before = std::get_if<LinePiece>(&pieces[i]);
    auto* after = std::get_if<LinePiece>(&next);
    if (after != nullptr) {
      after->from = end_of(pieces[i]).p_B;
    } else if (before != nullptr) {
      before->to = begin_of(next).p_B;
    }
  }
}

}  // namespace higherpair
