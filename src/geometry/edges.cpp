#include "higherpair/geometry/edges.hpp"

#include "higherpair/geometry/involute_span.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <utility>

namespace higherpair {
namespace {

bool ends_in_edge(const Span& span) {
  return !span.is_corner() && involute_of(span) == nullptr;
}

}  // namespace

Boundary with_edges(const Boundary& boundary) {
  if (boundary.is_closed()) {
    return boundary;
  }
  std::vector<SpanPtr> spans = boundary.spans();
  const SpanPtr first = spans.front();
  const SpanPtr last = spans.back();
  if (ends_in_edge(*first)) {
    const SpanPoint begin = first->at(first->range().low);
    const double angle = angle_of(begin.n_B);
    spans.insert(spans.begin(), corner_span(begin.p_B, angle - kEdgeTurn, angle));
  }
  if (ends_in_edge(*last)) {
    const SpanPoint end = last->at(last->range().high);
    const double angle = angle_of(end.n_B);
    spans.push_back(corner_span(end.p_B, angle, angle + kEdgeTurn));
  }
  return *Boundary::make(std::move(spans), false, kInf);
}

bool is_edge(const Boundary& boundary, int span) {
  return boundary.spans()[span]->is_corner() &&
         (boundary.joint_after(span) == SpanJoint::kEnd ||
          boundary.joint_after(boundary.next_span(span, false)) == SpanJoint::kEnd);
}

}  // namespace higherpair
