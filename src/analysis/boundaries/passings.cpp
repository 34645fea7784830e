#include "passings.hpp"

#include "analysis/follow/step.hpp"
#include "analysis/groups/group_kinds.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"

namespace higherpair {

void append_passings(const Run& run, const CurveRef& own, const CurveRef& other, int span,
                     bool (*counts)(SpanJoint), std::vector<Passing>& passings) {
  const Boundary& boundary = boundary_of(run.mechanism(), own);
  if (counts(boundary.joint_after(span))) {
    passings.push_back({own, other, end_of(boundary, span, true), 1});
  }
  if (counts(boundary.joint_after(boundary.next_span(span, false)))) {
    passings.push_back({own, other, end_of(boundary, span, false), -1});
  }
}

namespace {

// The foot of a point on the straight span of a place; none beyond its ends.
std::optional<BoundaryPlace> foot_on_span(const Boundary& boundary, const BoundaryPlace& at,
                                          const Vector2d& p_B) {
  const SpanPoint here = boundary.at(at);
  const BoundaryPlace foot = boundary.advance(at, (p_B - here.p_B).dot(perp(here.n_B)), 0).place;
  return foot.span == at.span ? std::optional(foot) : std::nullopt;
}

}  // namespace

std::optional<PassingAt> passing_at(const Run& run, const Passing& passing, const State& state,
                                    const BoundaryPlace& near) {
  const Boundary& own = boundary_of(run.mechanism(), passing.own);
  const Boundary& other = boundary_of(run.mechanism(), passing.other);
  const Pose<double>& X_WO = state.bodies[passing.own.body].X_WB;
  const Pose<double>& X_WC = state.bodies[passing.other.body].X_WB;
  const SpanPoint end = own.at(passing.end);
  const Vector2d n_W = X_WO.R_WB * end.n_B;
  const Vector2d p_W = X_WO * end.p_B;
  const bool flat = is_flat(other, near);
  const auto place = flat ? foot_on_span(other, near, X_WC.inverse_times(p_W))
                          : place_with_normal(other, near, X_WC.R_WB.inverse() * Vector2d(-n_W));
  if (!place) {
    return std::nullopt;
  }
  const SpanPoint facing = other.at(*place);
  const Vector2d apart = X_WC * facing.p_B - p_W;
  const double beyond =
      flat ? own.size() * cross(n_W, X_WC.R_WB * Vector2d(-facing.n_B)) : apart.dot(perp(n_W));
  return PassingAt{passing.outwards * beyond, apart.dot(n_W), *place};
}

namespace {

constexpr int kPassingHalvings = 40;  // halvings of a step until a place that faces an end is found

// Part of a step in which a function changes its sign, with its values at both ends.
struct Bracket {
  double from = 0, to = 0;
  double at_from = 0, at_to = 0;
};

// A bracket of the sign change in a step. Where the other curve has moved past the facing place the function
// has no value; the bracket is then next to the end of the step that has one.
template <class F>
std::optional<Bracket> bracket_of(const F& value, double h) {
  double from = 0, to = h;
  std::optional<double> at_from = value(from), at_to = value(to);
  for (int i = 0; i < kPassingHalvings && at_from.has_value() != at_to.has_value(); ++i) {
    const double middle = (from + to) / 2;
    const auto at_middle = value(middle);
    std::optional<double>& known = at_from ? at_from : at_to;
    const bool replaces_from = at_from.has_value() == (at_middle && (*at_middle > 0) == (*known > 0));
    (replaces_from ? from : to) = middle;
    (replaces_from ? at_from : at_to) = at_middle;
  }
  if (!at_from || !at_to || (*at_from > 0) == (*at_to > 0)) {
    return std::nullopt;
  }
  return Bracket{from, to, *at_from, *at_to};
}

}  // namespace

std::optional<double> passing_within(Run& run, const Path& path, double s, double h, const Passing& passing,
                                     const BoundaryPlace& near) {
  const StateAside aside(run.work.trial);
  const auto beyond = [&](double x) -> std::optional<double> {
    const auto there = x == 0                      ? passing_at(run, passing, run.at.state, near)
                       : x == h                    ? passing_at(run, passing, aside.kept(), near)
                       : solve_at(run, path, s, x) ? passing_at(run, passing, run.work.trial, near)
                                                   : std::nullopt;
    return there ? std::optional(there->beyond) : std::nullopt;
  };
  std::optional<double> x;
  if (const auto bracket = bracket_of(beyond, h)) {
    x = root_between([&](double ahead) { return beyond(bracket->from + ahead).value_or(kNoValue); },
                     bracket->at_from, bracket->to - bracket->from, bracket->at_to);
    x = x ? std::optional(bracket->from + *x) : std::nullopt;
  }
  return x;
}

}  // namespace higherpair
