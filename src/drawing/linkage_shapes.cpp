#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "outline.hpp"
#include "sketch.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

// Sizes in units.
constexpr double kLinkagePin = 0.8;
constexpr double kLinkageBlock = 4, kLinkageBlockWidth = 2.4;
constexpr double kEdge = 2;     // from the edge of the picture to the point where a link is broken off
constexpr double kMark = 2;     // length of the break mark, and from it to the end of the link
constexpr double kSwing = 1.2;  // of the break mark to either side

using Kind = Shape::Kind;

// One body of a contact in its equivalent linkage.
struct End {
  std::optional<Vector2d> pivot, center;
  Vector2d guide;  // direction of the slide of a block at the centre
  bool slides = false, flat = false;
};

End end_of(const Mechanism& mechanism, const CurveRef& ref, const Vector2d& p_W, const Vector2d& n_W,
           double rho) {
  End end;
  end.flat = is_line(curve_of(mechanism, ref)) || std::isinf(rho);
  end.guide = perp(n_W);
  if (!end.flat) end.center = kMillimetresPerMetre * (p_W - rho * n_W);
  if (const auto freedom = grounded_freedom(mechanism, ref.body)) {
    end.slides = !freedom->turns;
    if (freedom->turns) end.pivot = kMillimetresPerMetre * freedom->p_WO;
    if (end.slides && !end.flat) end.guide = freedom->direction_W;
  }
  return end;
}

// The points of the link from the pivot, if there is one, to the centre.
std::vector<Vector2d> way_of(const End& end) {
  if (!end.pivot) {
    return {*end.center};
  }
  if (!end.flat) {
    return {*end.pivot, *end.center};
  }
  // The guide goes through the centre; the pivot may lie beside it.
  const Vector2d foot = *end.center + (*end.pivot - *end.center).dot(end.guide) * end.guide;
  return {*end.pivot, foot, *end.center};
}

bool is_within(const Box& box, const Vector2d& p) {
  return (p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all();
}

// The part of a link within the box, as parameters from 0 to 1 (Liang and Barsky); from > to if there is
// none.
std::array<double, 2> part_within(const Box& box, const Vector2d& a, const Vector2d& b) {
  double from = 0, to = 1;
  for (const int axis : {0, 1}) {
    const double extent = b[axis] - a[axis];
    const double low = box.low[axis] - a[axis], high = box.high[axis] - a[axis];
    if (extent == 0) {
      if (low > 0 || high < 0) return {1, 0};
      continue;
    }
    from = std::max(from, std::min(low / extent, high / extent));
    to = std::min(to, std::max(low / extent, high / extent));
  }
  return {from, to};
}

// The zigzag where a link that continues to `end` along d, out of the picture, is broken off; and its middle.
struct BreakMark {
  std::array<Vector2d, 5> points;
  Vector2d middle;
};

BreakMark mark_at(const Vector2d& end, const Vector2d& d, double unit) {
  const Vector2d along = unit * kMark / 4 * d, across = kSwing * unit * perp(d);
  const Vector2d middle = end - 4 * along;
  return {{middle - 2 * along, middle - along + across, middle + along - across, middle + 2 * along, end},
          middle};
}

// Adds a link to the path. One that leaves the picture ends in a break mark, with its length written beside
// it.
void append_link(std::vector<double>& path, Shape& length, const Box& box, const Vector2d& a,
                 const Vector2d& b, double unit) {
  const auto [from, to] = part_within(box, a, b);
  if (from > to) {
    return;
  }
  const Vector2d d = (b - a).normalized();
  std::optional<Vector2d> broken;
  const Vector2d low = from > 0 ? Vector2d(a + from * (b - a)) : a;
  const Vector2d high = to < 1 ? Vector2d(a + to * (b - a)) : b;
  // Where little of the link is in the picture, its marks are smaller.
  const double size = std::min(unit, (high - low).norm() / (3 * kMark));
  const auto goes_on = [&] {
    const std::size_t n = path.size();
    return n >= 2 && path[n - 2] == low.x() && path[n - 1] == low.y();
  };
  if (!goes_on()) {
    if (!path.empty()) append_break(path);
    append(path, low);
  }
  if (from > 0) {
    const BreakMark mark = mark_at(low, -d, size);
    for (std::size_t i = 4; i-- > 0;) append(path, mark.points[i]);
    broken = mark.middle;
  }
  if (to < 1) {
    const BreakMark mark = mark_at(high, d, size);
    for (std::size_t i = 0; i < 4; ++i) append(path, mark.points[i]);
    broken = mark.middle;
  }
  append(path, high);
  if (broken && length.numbers.empty()) {
    const Vector2d inwards = (box.low + box.high) / 2 - *broken;
    const Vector2d away = inwards.dot(perp(d)) >= 0 ? perp(d) : Vector2d(-perp(d));
    length.numbers = {broken->x(), broken->y(), away.x(), away.y(), (b - a).norm()};
  }
}

}  // namespace

// The equivalent linkage O1, C1, C2, O2, as far as these points exist. A side that slides or is flat has a
// block instead of a pin.
void SceneMaker::add_linkage(const MotionRow& row, std::size_t index) {
  const Contact& contact = mechanism_->contacts[index];
  const CommonNormal& at = row.contacts[index].at;
  const double u = scene_.unit;
  std::array<End, 2> ends{end_of(*mechanism_, contact.first, at.p1_W, at.n_W, at.rho1),
                          end_of(*mechanism_, contact.second, at.p2_W, -at.n_W, at.rho2)};
  // A flat body acts as a slide, along its face, for the centre of the other one.
  for (std::size_t i = 0; i < 2; ++i) {
    if (ends[i].flat && ends[1 - i].center) {
      ends[i].center = ends[1 - i].center;
    }
  }
  const bool whole = ends[0].center && ends[1].center;
  const Vector2d edge = Vector2d::Constant(kEdge * u);
  const Box box{scene_.view.low + edge, scene_.view.high - edge};
  std::vector<double> path;
  std::array<Shape, 3> lengths;  // r2, r3, r4; shown if both ends are pins
  if (whole) {
    const std::vector<Vector2d> first = way_of(ends[0]), second = way_of(ends[1]);
    for (std::size_t i = 1; i < first.size(); ++i) {
      append_link(path, lengths[0], box, first[i - 1], first[i], u);
    }
    if (first.back() != second.back()) {
      append_link(path, lengths[1], box, first.back(), second.back(), u);
    }
    for (std::size_t i = second.size(); i-- > 1;) {
      append_link(path, lengths[2], box, second[i], second[i - 1], u);
    }
  }
  next(Role::kLinkage, contact.name, Kind::kPath).numbers = std::move(path);
  constexpr std::array kNames{"r2", "r3", "r4"};
  const std::array<bool, 3> named{!ends[0].flat, !ends[0].flat && !ends[1].flat, !ends[1].flat};
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    Shape& text = next(Role::kLinkage, contact.name + "." + kNames[i], Kind::kText);
    text.text = kNames[i];
    if (named[i]) text.numbers = lengths[i].numbers;
  }
  for (const End& end : ends) {
    const bool shown = whole && is_within(box, *end.center);
    Shape& pivot = next(Role::kLinkage, contact.name, Kind::kCircle, true);
    if (whole && end.pivot) pivot.numbers = {end.pivot->x(), end.pivot->y(), kLinkagePin * u};
    Shape& block = next(Role::kLinkage, contact.name, Kind::kPath, true);
    if (shown && (end.slides || end.flat)) {
      block.numbers = rectangle(*end.center, end.guide, kLinkageBlock * u, kLinkageBlockWidth * u);
    }
    Shape& pin = next(Role::kLinkage, contact.name, Kind::kCircle, true);
    if (shown) pin.numbers = {end.center->x(), end.center->y(), kLinkagePin * u};
  }
}

}  // namespace higherpair
