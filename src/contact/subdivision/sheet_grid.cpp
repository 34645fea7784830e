#include "sheet_grid.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/roots.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr int kLeastParts = 4;  // of a span, even if it is straight
constexpr int kMostHalvings = 24;
constexpr int kMostEdgeParts = 60;  // into which a side of a cell is cut in search of zeros

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
      lifted_(kGridLifted * sheet.size()),
      side1_(side_of(*sheet.pair().boundary1, sheet.size())),
      side2_(side_of(*sheet.pair().boundary2, sheet.size())) {
  place_nodes(side1_, true);
  place_nodes(side2_, false);
  find_zeros(range);
}

void SheetGrid::add_parts(const Boundary& boundary, int span, const Bounds& t, double length, int halvings,
                          std::vector<Part>& parts) {
  const Span& curve = *boundary.spans()[span];
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
    const double shift = parts == kLeastParts ? kOffMiddleOfFace : 0;
    const auto end = [&](int k) {
      const double share = k == 0 || k == parts ? k : k - shift;
      return k == parts ? range.high : range.low + share / parts * range.width();
    };
    for (int k = 0; k < parts; ++k) {
      add_parts(boundary, static_cast<int>(s), {end(k), end(k + 1)}, length, kMostHalvings, side.parts);
    }
  }
  // A node at the end of every part, and one at the beginning of a part that follows no other.
  const int count = static_cast<int>(side.parts.size());
  for (int k = 0; k < count; ++k) {
    side.parts[k].last = k;
  }
  side.ends.assign(side.parts.size(), false);
  for (int k = 0; k < count; ++k) {
    Part& part = side.parts[k];
    if (k > first_part[part.span]) {
      part.first = k - 1;
      continue;
    }
    const int before = boundary.next_span(part.span, false);
    const SpanJoint joint = boundary.joint_after(before);
    const int last_before = before + 1 < static_cast<int>(first_part.size())
                                ? first_part[static_cast<std::size_t>(before) + 1] - 1
                                : count - 1;
    if (joint == SpanJoint::kEnd || joint == SpanJoint::kNotch) {
      side.ends[last_before] = true;
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
  side.nodes.resize(side.ends.size());
  for (const Part& part : side.parts) {
    side.stretches.push_back(std::make_unique<StretchNode>(sheet_, is_first, part.span, part.t));
    StretchNode& stretch = *side.stretches.back();
    side.nodes[part.last] = &stretch.end(true);
    if (part.first >= static_cast<int>(side.parts.size())) {
      side.nodes[part.first] = &stretch.end(false);
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
      values[a * n2 + b] = level(side1_.nodes[a]->stretch().middle, side2_.nodes[b]->stretch().middle);
    }
  }
  const auto value = [&](int a, int b) {
    return values[static_cast<std::size_t>(a) * n2 + static_cast<std::size_t>(b)];
  };
  std::vector<double> zeros;
  for (std::size_t a = 0; a < n1 && !is_stopped(range); ++a) {
    for (std::size_t j = 0; j < side2_.parts.size(); ++j) {
      const Part& part = side2_.parts[j];
      const auto node = static_cast<int>(a);
      zeros.clear();
      int parts = 0;
      add_zeros(*side1_.nodes[a], *side2_.stretches[j], value(node, part.first), value(node, part.last),
                parts, zeros);
      keep(along2_, key_of(node, static_cast<int>(j)), zeros, ends_at(side1_, a) ? 1 : 0);
    }
  }
  for (std::size_t i = 0; i < side1_.parts.size() && !is_stopped(range); ++i) {
    const Part& part = side1_.parts[i];
    for (std::size_t b = 0; b < n2; ++b) {
      const auto node = static_cast<int>(b);
      zeros.clear();
      int parts = 0;
      add_zeros(*side1_.stretches[i], *side2_.nodes[b], value(part.first, node), value(part.last, node),
                parts, zeros);
      keep(along1_, key_of(static_cast<int>(i), node), zeros, ends_at(side2_, b) ? 2 : 0);
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
  return static_cast<std::size_t>(id) < ending_.size() ? ending_[id] : 0;
}

std::vector<double> SheetGrid::zeros_between(StretchNode& one, StretchNode& two) const {
  std::vector<double> zeros;
  const auto at_ends = [&](bool high) {
    return level(one.end(high).stretch().middle, two.end(high).stretch().middle);
  };
  int parts = 0;
  add_zeros(one, two, at_ends(false), at_ends(true), parts, zeros);
  return zeros;
}

// Halved until F is monotonic along a part, or is not 0 there.
void SheetGrid::add_zeros(StretchNode& one, StretchNode& two, double low, double high, int& parts,
                          std::vector<double>& zeros) const {
  ++parts;
  const bool along1 = two.is_place();
  const SheetRange range = sheet_.range(one.stretch(), two.stretch(), lifted_);
  const bool crosses = (low >= 0) != (high >= 0);
  if ((along1 ? range.slope1 : range.slope2) != 0 || parts > kMostEdgeParts || (!range.zero && !crosses)) {
    if (const auto zero = crosses ? zero_along(one, two, low, high) : std::nullopt) {
      zeros.push_back(*zero);
    }
    return;
  }
  const double middle = level(one.stretch().middle, two.stretch().middle);
  for (const bool second : {false, true}) {
    add_zeros(along1 ? one.half(second) : one, along1 ? two : two.half(second), second ? middle : low,
              second ? high : middle, parts, zeros);
  }
}

// The zero of F itself, if it is next to that of the lifted F, else the latter; none if it is no tangency.
std::optional<double> SheetGrid::zero_along(const StretchNode& one, const StretchNode& two, double low,
                                            double high) const {
  const bool along1 = two.is_place();
  const Bounds t = along1 ? one.t() : two.t();
  const auto places = [&](double x) {
    return along1 ? std::pair(sheet_.place1({one.span(), t.low + x}), two.stretch().middle)
                  : std::pair(one.stretch().middle, sheet_.place2({two.span(), t.low + x}));
  };
  const auto value = [&](double x) {
    const auto [a, b] = places(x);
    return level(a, b);
  };
  const double lifted = root_between(value, low, t.width(), high).value_or(t.width() / 2);
  double x = lifted;
  for (int pass = 0; pass < 3; ++pass) {
    const auto [a, b] = places(x);
    const Vector2d slopes = sheet_.slopes(a, b);
    x -= sheet_.value(a, b) / (along1 ? slopes.x() : slopes.y());
  }
  x = std::abs(x - lifted) <= kGridBeside * t.width() ? std::clamp(x, 0.0, t.width()) : lifted;
  const auto [a, b] = places(x);
  return sheet_.faces(a, b) ? std::optional(t.low + x) : std::nullopt;
}

CellLook SheetGrid::look_into(StretchNode& one, StretchNode& two) const {
  const double corner = level(one.end(false).stretch().middle, two.end(false).stretch().middle);
  return look_into_cell(sheet_, one, two, lifted_, corner >= 0 ? 1 : -1);
}

}  // namespace higherpair
