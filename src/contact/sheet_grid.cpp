#include "sheet_grid.hpp"

#include "higherpair/geometry/roots.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kLifted = 1e-12;  // of the size: above the rounding of F, below what changes its zeros
constexpr double kBeside = 1e-8;   // of a part: a zero that is moved so little stays the same
constexpr int kLeastParts = 4;     // of a span, also where it is straight
// Far parts of lines and open conics are halved: of even parts the last ones would be nearly all of them.
constexpr double kEvenSpeed = 4;  // between the ends of a part
constexpr int kMostHalvings = 24;
constexpr double kFace = 0.37;  // of a part of a face: its nodes lie off the middle, which may be special

std::int64_t key_of(int a, int b) {
  return (static_cast<std::int64_t>(a) << 32) | b;
}

const std::vector<SheetGrid::Zero>& found_at(
    const std::unordered_map<std::int64_t, std::vector<SheetGrid::Zero>>& zeros, std::int64_t key) {
  static const std::vector<SheetGrid::Zero> kNone;
  const auto at = zeros.find(key);
  return at == zeros.end() ? kNone : at->second;
}

}  // namespace

SheetGrid::SheetGrid(const TangencySheet& sheet, const MapRange& range)
    : sheet_(sheet),
      lifted_(kLifted * sheet.size()),
      side1_(side_of(*sheet.pair().boundary1, sheet.size())),
      side2_(side_of(*sheet.pair().boundary2, sheet.size())) {
  place_nodes(side1_, true);
  place_nodes(side2_, false);
  find_zeros(range);
}

void SheetGrid::add_parts(const Boundary& boundary, int span, const Bounds& t, double length, int halvings,
                          std::vector<Part>& parts) {
  const Span& curve = *boundary.spans()[static_cast<std::size_t>(span)];
  const SpanPoint a = curve.at(t.low);
  const SpanPoint b = curve.at(t.high);
  const auto away = [&](const SpanPoint& point) { return (point.p_B - boundary.middle_B()).norm(); };
  const bool uneven = std::max(a.speed, b.speed) > kEvenSpeed * std::min(a.speed, b.speed);
  const bool long_one = (b.p_B - a.p_B).norm() > 2 * std::max(length, std::min(away(a), away(b)));
  if (halvings > 0 && (uneven || long_one)) {
    const double middle = t.low + t.width() / 2;
    add_parts(boundary, span, {t.low, middle}, length, halvings - 1, parts);
    add_parts(boundary, span, {middle, t.high}, length, halvings - 1, parts);
  } else {
    parts.push_back({span, t, curve.is_corner(), -1, -1});
  }
}

SheetGrid::Side SheetGrid::side_of(const Boundary& boundary, double length) {
  Side side;
  std::vector<int> first_part;
  for (std::size_t s = 0; s < boundary.spans().size(); ++s) {
    const Span& span = *boundary.spans()[s];
    const Bounds range = span.range();
    const int parts = span.is_corner() ? span.parts() : std::max(span.parts(), kLeastParts);
    first_part.push_back(static_cast<int>(side.parts.size()));
    const double shift = parts == kLeastParts ? kFace : 0;
    const auto end = [&](int k) {
      const double share = k == 0 || k == parts ? k : k - shift;
      return k == parts ? range.high : range.low + share / parts * range.width();
    };
    for (int k = 0; k < parts; ++k) {
      add_parts(boundary, static_cast<int>(s), {end(k), end(k + 1)}, length, kMostHalvings, side.parts);
    }
  }
  // A node at the end of every part, and one where a part has none before it.
  const int count = static_cast<int>(side.parts.size());
  for (int k = 0; k < count; ++k) {
    side.parts[static_cast<std::size_t>(k)].last = k;
  }
  side.ends.assign(side.parts.size(), false);
  for (int k = 0; k < count; ++k) {
    Part& part = side.parts[static_cast<std::size_t>(k)];
    if (k > first_part[static_cast<std::size_t>(part.span)]) {
      part.first = k - 1;
      continue;
    }
    const int before = boundary.next_span(part.span, false);
    const SpanJoint joint = boundary.joint_after(before);
    const int last_before = before + 1 < static_cast<int>(first_part.size())
                                ? first_part[static_cast<std::size_t>(before) + 1] - 1
                                : count - 1;
    if (joint == SpanJoint::kEnd || joint == SpanJoint::kNotch) {
      side.ends[static_cast<std::size_t>(last_before)] = true;
      part.first = static_cast<int>(side.ends.size());
      side.ends.push_back(true);
    } else {
      part.first = last_before;
    }
  }
  side.at_corner.assign(side.ends.size(), false);
  for (const Part& part : side.parts) {
    for (const int node : {part.first, part.last}) {
      const auto n = static_cast<std::size_t>(node);
      side.at_corner[n] = side.at_corner[n] || part.corner;
    }
  }
  return side;
}

void SheetGrid::place_nodes(Side& side, bool is_first) {
  const auto place = [&](int span, double t) {
    return is_first ? sheet_.place1({span, t}) : sheet_.place2({span, t});
  };
  side.nodes.resize(side.ends.size());
  for (const Part& part : side.parts) {
    side.first.push_back(place(part.span, part.t.low));
    side.last.push_back(place(part.span, part.t.high));
    side.nodes[static_cast<std::size_t>(part.last)] = side.last.back();
    if (part.first >= static_cast<int>(side.parts.size())) {
      side.nodes[static_cast<std::size_t>(part.first)] = side.first.back();
    }
  }
}

double SheetGrid::level(const SheetPlace& one, const SheetPlace& two) const {
  return sheet_.value(one, two) - lifted_;
}

void SheetGrid::find_zeros(const MapRange& range) {
  const std::size_t n1 = side1_.nodes.size();
  const std::size_t n2 = side2_.nodes.size();
  std::vector<double> values(n1 * n2);
  for (std::size_t a = 0; a < n1 && !is_stopped(range); ++a) {
    for (std::size_t b = 0; b < n2; ++b) {
      values[a * n2 + b] = level(side1_.nodes[a], side2_.nodes[b]);
    }
  }
  const auto value = [&](int a, int b) {
    return values[static_cast<std::size_t>(a) * n2 + static_cast<std::size_t>(b)];
  };
  for (std::size_t a = 0; a < n1 && !is_stopped(range); ++a) {
    for (std::size_t j = 0; j < side2_.parts.size(); ++j) {
      const Part& part = side2_.parts[j];
      const auto node = static_cast<int>(a);
      keep(along2_, key_of(node, static_cast<int>(j)),
           zeros_of(side1_.nodes[a], part.span, part.t, false, value(node, part.first),
                    value(node, part.last), side2_.first[j], side2_.last[j]),
           ends_at(side1_, a) ? 1 : 0);
    }
  }
  for (std::size_t i = 0; i < side1_.parts.size() && !is_stopped(range); ++i) {
    const Part& part = side1_.parts[i];
    for (std::size_t b = 0; b < n2; ++b) {
      const auto node = static_cast<int>(b);
      keep(along1_, key_of(static_cast<int>(i), node),
           zeros_of(side2_.nodes[b], part.span, part.t, true, value(part.first, node), value(part.last, node),
                    side1_.first[i], side1_.last[i]),
           ends_at(side2_, b) ? 2 : 0);
    }
  }
}

void SheetGrid::keep(std::unordered_map<std::int64_t, std::vector<Zero>>& zeros, std::int64_t key,
                     const std::vector<double>& found, int ending) {
  for (const double t : found) {
    ending_.resize(static_cast<std::size_t>(ids_) + 1, 0);
    ending_.back() = ending;
    zeros[key].push_back({new_id(), t});
  }
}

const std::vector<SheetGrid::Zero>& SheetGrid::zeros_along2(int node1, int j) const {
  return found_at(along2_, key_of(node1, j));
}

const std::vector<SheetGrid::Zero>& SheetGrid::zeros_along1(int i, int node2) const {
  return found_at(along1_, key_of(i, node2));
}

int SheetGrid::boundary_ending_at(int id) const {
  return static_cast<std::size_t>(id) < ending_.size() ? ending_[static_cast<std::size_t>(id)] : 0;
}

std::vector<double> SheetGrid::zeros_between(const SheetPlace& fixed, int span, const Bounds& t,
                                             bool along1) const {
  const auto at = [&](double x) { return along1 ? sheet_.place1({span, x}) : sheet_.place2({span, x}); };
  const SheetPlace first = at(t.low);
  const SheetPlace last = at(t.high);
  const auto value = [&](const SheetPlace& moved) {
    return along1 ? level(moved, fixed) : level(fixed, moved);
  };
  return zeros_of(fixed, span, t, along1, value(first), value(last), first, last);
}

std::vector<double> SheetGrid::zeros_of(const SheetPlace& fixed, int span, const Bounds& t, bool along1,
                                        double low, double high, const SheetPlace& first,
                                        const SheetPlace& last) const {
  const auto at = [&](double x) {
    return along1 ? sheet_.place1({span, t.low + x}) : sheet_.place2({span, t.low + x});
  };
  const auto value = [&](double x) { return along1 ? level(at(x), fixed) : level(fixed, at(x)); };
  const auto slope_at = [&](const SheetPlace& moved) {
    return along1 ? sheet_.slopes(moved, fixed).x() : sheet_.slopes(fixed, moved).y();
  };
  // The zero of F itself, where it is next to that of the lifted one.
  const auto unlifted = [&](double lifted) {
    double x = lifted;
    for (int pass = 0; pass < 3; ++pass) {
      const SheetPlace moved = at(x);
      x -= (along1 ? sheet_.value(moved, fixed) : sheet_.value(fixed, moved)) / slope_at(moved);
    }
    return std::abs(x - lifted) <= kBeside * t.width() ? std::clamp(x, 0.0, t.width()) : lifted;
  };
  std::vector<double> zeros;
  const auto add = [&](double from, double value_from, double to, double value_to) {
    const auto f = [&](double x) { return value(from + x); };
    double root = from + root_between(f, value_from, to - from, value_to).value_or((to - from) / 2);
    root = unlifted(root);
    const SheetPlace moved = at(root);
    if (along1 ? sheet_.faces(moved, fixed) : sheet_.faces(fixed, moved)) {
      zeros.push_back(t.low + root);
    }
  };
  const double width = t.width();
  if ((low >= 0) != (high >= 0)) {
    add(0, low, width, high);
    return zeros;
  }
  const double sign = low >= 0 ? 1 : -1;
  const double slope_low = slope_at(first);
  const double slope_high = slope_at(last);
  if (!(sign * slope_low < 0 && sign * slope_high > 0)) {
    return zeros;
  }
  const auto slope = [&](double x) { return slope_at(at(x)); };
  const auto extreme = root_between(slope, slope_low, width, slope_high);
  const double deepest = extreme ? value(*extreme) : low;
  if ((deepest >= 0) != (low >= 0)) {
    add(0, low, *extreme, deepest);
    add(*extreme, deepest, width, high);
  }
  return zeros;
}

// From the middle along each of the two boundaries in turn to the extreme value there.
std::optional<Vector2d> SheetGrid::inner_zero(int i, int j) const {
  constexpr int kRounds = 6;
  const auto place = [](const Side& side, int k, bool high) {
    return (high ? side.last : side.first)[static_cast<std::size_t>(k)];
  };
  const double sign = level(place(side1_, i, false), place(side2_, j, false)) >= 0 ? 1 : -1;
  for (const bool high : {false, true}) {
    const double outwards = high ? 1 : -1;
    for (const bool other : {false, true}) {
      const double slope1 = sheet_.slopes(place(side1_, i, high), place(side2_, j, other)).x();
      const double slope2 = sheet_.slopes(place(side1_, i, other), place(side2_, j, high)).y();
      if (!(sign * outwards * slope1 > 0 && sign * outwards * slope2 > 0)) {
        return std::nullopt;
      }
    }
  }
  const Part& one = part1(i);
  const Part& two = part2(j);
  Vector2d at(one.t.low + one.t.width() / 2, two.t.low + two.t.width() / 2);
  for (int round = 0; round < kRounds; ++round) {
    for (const bool along1 : {true, false}) {
      const Bounds& t = along1 ? one.t : two.t;
      const auto slope = [&](double x) {
        const double t1 = along1 ? t.low + x : at.x();
        const double t2 = along1 ? at.y() : t.low + x;
        const Vector2d slopes = sheet_.slopes(sheet_.place1({one.span, t1}), sheet_.place2({two.span, t2}));
        return along1 ? slopes.x() : slopes.y();
      };
      if (const auto x = root_between(slope, slope(0), t.width(), slope(t.width()))) {
        (along1 ? at.x() : at.y()) = t.low + *x;
      }
      const SheetPlace on1 = sheet_.place1({one.span, at.x()});
      const SheetPlace on2 = sheet_.place2({two.span, at.y()});
      if (sign * level(on1, on2) < 0 && sheet_.faces(on1, on2)) {
        return at;
      }
    }
  }
  return std::nullopt;
}

}  // namespace higherpair
