#include "sheet_curves.hpp"

#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "sheet_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr int kDeepest = 40;
// Below this depth a curve need not be proven to be a graph over a parameter: next to a crossing of two it is
// not.
constexpr int kMostForGraph = 16;
constexpr std::size_t kMostSheetSteps = 200000;  // of all curves: more are noise

enum class Rim { kLow1, kHigh1, kLow2, kHigh2 };

// A zero on the rim of a cell.
struct Zero {
  int id = 0;
  double t1 = 0, t2 = 0;
  Rim rim = Rim::kLow1;
};

struct Rect {
  Bounds t1, t2;
};

// A step between two zeros, given by their ids.
struct Link {
  int from = 0, to = 0;
  SheetStep step;
};

class CurveFinder {
public:
  CurveFinder(const TangencySheet& sheet, const MapRange& range)
      : sheet_(sheet), range_(range), grid_(sheet, range) {}

  [[nodiscard]] SheetCurves run() {
    for (int i = 0; i < grid_.count1(); ++i) {
      for (int j = 0; j < grid_.count2() && !is_stopped(range_); ++j) {
        if (grid_.has_cell(i, j)) {
          enter(i, j);
        }
      }
    }
    chain();
    return std::move(found_);
  }

private:
  void enter(int i, int j) {
    span1_ = grid_.part1(i).span;
    span2_ = grid_.part2(j).span;
    const Rect cell{grid_.part1(i).t, grid_.part2(j).t};
    width_ = {cell.t1.width(), cell.t2.width()};
    std::vector<Zero> zeros;
    const auto add = [&](const std::vector<SheetGrid::Zero>& on_edge, Rim rim) {
      for (const auto& [id, t] : on_edge) {
        const bool along2 = rim == Rim::kLow1 || rim == Rim::kHigh1;
        const double fixed = rim == Rim::kLow1    ? cell.t1.low
                             : rim == Rim::kHigh1 ? cell.t1.high
                             : rim == Rim::kLow2  ? cell.t2.low
                                                  : cell.t2.high;
        zeros.push_back({id, along2 ? fixed : t, along2 ? t : fixed, rim});
      }
    };
    add(grid_.zeros_along2(grid_.part1(i).first, j), Rim::kLow1);
    add(grid_.zeros_along2(grid_.part1(i).last, j), Rim::kHigh1);
    add(grid_.zeros_along1(i, grid_.part2(j).first), Rim::kLow2);
    add(grid_.zeros_along1(i, grid_.part2(j).last), Rim::kHigh2);
    if (zeros.empty()) {
      find_within(cell, grid_.look_into(grid_.stretch1(i), grid_.stretch2(j)), 0);
    } else {
      connect(cell, zeros, 0);
    }
  }

  // A cell without zeros on its rim that has a closed curve in it is split at a place inside of that curve.
  void find_within(const Rect& cell, const CellLook& look, int depth) {
    if (!look.place || depth == kDeepest) {
      found_.complete = found_.complete && !look.place && look.proven;
      return;
    }
    const double split1 = (look.place->x() - cell.t1.low) / cell.t1.width();
    const double split2 = (look.place->y() - cell.t2.low) / cell.t2.width();
    if (std::min(split1, split2) > 0 && std::max(split1, split2) < 1) {
      halve(cell, {}, split1, split2, depth);
    } else {
      found_.complete = false;
    }
  }

  [[nodiscard]] StretchNode stretch1(const Bounds& t) const { return {sheet_, true, span1_, t}; }
  [[nodiscard]] StretchNode stretch2(const Bounds& t) const { return {sheet_, false, span2_, t}; }
  [[nodiscard]] SheetPlace one(double t) const { return sheet_.place1({span1_, t}); }
  [[nodiscard]] SheetPlace two(double t) const { return sheet_.place2({span2_, t}); }

  // The direction of the curve, in widths of the cell.
  [[nodiscard]] Vector2d direction(double t1, double t2) const {
    const Vector2d slopes = sheet_.slopes(one(t1), two(t2));
    return Vector2d(-slopes.y() * width_.y(), slopes.x() * width_.x()).normalized();
  }

  // Whether the curve between two zeros is nearly straight, by its directions at both ends and in between,
  // and the bodies turn little along it.
  [[nodiscard]] bool is_straight(const Zero& a, const Zero& b) const {
    const Vector2d chord((b.t1 - a.t1) / width_.x(), (b.t2 - a.t2) / width_.y());
    const double length = chord.norm();
    if (length < kNoChord) {
      return true;
    }
    const auto middle = place_on(sheet_, step_between(a, b), 0.5);
    if (!middle) {
      return false;
    }
    const auto along = [&](double t1, double t2) { return direction(t1, t2).dot(chord) / length; };
    const auto [least, most] =
        std::minmax({along(a.t1, a.t2), along(b.t1, b.t2), along(middle->place1.t, middle->place2.t)});
    if (!(least > kStraightSheetCurve || most < -kStraightSheetCurve)) {
      return false;
    }
    const SheetPoint from = sheet_.point(one(a.t1), two(a.t2));
    const SheetPoint to = sheet_.point(one(b.t1), two(b.t2));
    const BoundaryPair& pair = sheet_.pair();
    return (!pair.motion1.turns || std::abs(nearest_turn(to.u - from.u, 0)) < kMostSheetTurn) &&
           (!pair.motion2.turns || std::abs(nearest_turn(to.q - from.q, 0)) < kMostSheetTurn);
  }

  // The zero of F itself that is nearest to one of the lifted F.
  [[nodiscard]] Zero polished(Zero at) const {
    for (int pass = 0; pass < 2; ++pass) {
      const Vector2d slopes = sheet_.slopes(one(at.t1), two(at.t2)).cwiseProduct(width_);
      const Vector2d step = -sheet_.value(one(at.t1), two(at.t2)) / slopes.squaredNorm() * slopes;
      if (step.norm() < kNoChord) {
        at.t1 += step.x() * width_.x();
        at.t2 += step.y() * width_.y();
      }
    }
    return at;
  }

  [[nodiscard]] SheetStep step_between(const Zero& a, const Zero& b) const {
    return {{span1_, a.t1}, {span2_, a.t2}, {span1_, b.t1}, {span2_, b.t2}, width_};
  }

  // Whether F is monotonic in one of the two parameters: then the cell has no closed curve.
  [[nodiscard]] bool is_graph(const Rect& cell) const {
    const SheetRange range =
        sheet_.range(sheet_.stretch1(span1_, cell.t1), sheet_.stretch2(span2_, cell.t2), 0);
    return range.slope1 != 0 || range.slope2 != 0;
  }

  void connect(const Rect& cell, const std::vector<Zero>& zeros, int depth) {
    const bool goes_on = links_.size() <= kMostSheetSteps && !is_stopped(range_);
    if (goes_on && zeros.empty()) {
      StretchNode on1 = stretch1(cell.t1);
      StretchNode on2 = stretch2(cell.t2);
      find_within(cell, grid_.look_into(on1, on2), depth);
    } else if (goes_on && zeros.size() == 2 &&
               (depth == kDeepest ||
                (is_straight(zeros[0], zeros[1]) && (depth >= kMostForGraph || is_graph(cell))))) {
      const Zero& a = zeros[0];
      const Zero& b = zeros[1];
      found_.complete = found_.complete && depth < kDeepest;
      links_.push_back({a.id, b.id, step_between(polished(a), polished(b))});
    } else if (goes_on && depth != kDeepest) {
      halve(cell, zeros, kOffMiddle, kOffMiddle, depth);
    } else {
      found_.complete = false;
    }
  }

  // Splits a cell into four, each with the zeros on its rim, and connects these.
  void halve(const Rect& cell, const std::vector<Zero>& zeros, double split1, double split2, int depth) {
    const double m1 = cell.t1.low + split1 * cell.t1.width();
    const double m2 = cell.t2.low + split2 * cell.t2.width();
    std::array<std::array<std::vector<Zero>, 2>, 2> quarters;
    std::array<std::array<Rect, 2>, 2> rects;
    for (const bool high1 : {false, true}) {
      for (const bool high2 : {false, true}) {
        const Bounds t1 = high1 ? Bounds{m1, cell.t1.high} : Bounds{cell.t1.low, m1};
        const Bounds t2 = high2 ? Bounds{m2, cell.t2.high} : Bounds{cell.t2.low, m2};
        for (const Zero& zero : zeros) {
          const bool within1 = zero.rim == Rim::kLow1    ? !high1
                               : zero.rim == Rim::kHigh1 ? high1
                                                         : (zero.t1 >= m1) == high1;
          const bool within2 = zero.rim == Rim::kLow2    ? !high2
                               : zero.rim == Rim::kHigh2 ? high2
                                                         : (zero.t2 >= m2) == high2;
          if (within1 && within2) {
            quarters[high1][high2].push_back(zero);
          }
        }
        rects[high1][high2] = {t1, t2};
      }
    }
    const auto add = [&](bool along1, const Bounds& t, std::vector<Zero>& low, std::vector<Zero>& high) {
      StretchNode on1 = stretch1(along1 ? t : Bounds{m1, m1});
      StretchNode on2 = stretch2(along1 ? Bounds{m2, m2} : t);
      for (const double zero : grid_.zeros_between(on1, on2)) {
        const int id = grid_.new_id();
        const double t1 = along1 ? zero : m1;
        const double t2 = along1 ? m2 : zero;
        low.push_back({id, t1, t2, along1 ? Rim::kHigh2 : Rim::kHigh1});
        high.push_back({id, t1, t2, along1 ? Rim::kLow2 : Rim::kLow1});
      }
    };
    add(true, {cell.t1.low, m1}, quarters[0][0], quarters[0][1]);
    add(true, {m1, cell.t1.high}, quarters[1][0], quarters[1][1]);
    add(false, {cell.t2.low, m2}, quarters[0][0], quarters[1][0]);
    add(false, {m2, cell.t2.high}, quarters[0][1], quarters[1][1]);
    for (const bool high1 : {false, true}) {
      for (const bool high2 : {false, true}) {
        connect(rects[high1][high2], quarters[high1][high2], depth + 1);
      }
    }
  }

  // Joins the steps into curves.
  void chain() {
    std::vector<std::array<int, 2>> at_zero(static_cast<std::size_t>(grid_.ids()), {-1, -1});
    for (std::size_t k = 0; k < links_.size(); ++k) {
      for (const int id : {links_[k].from, links_[k].to}) {
        auto& here = at_zero[id];
        found_.complete = found_.complete && here[1] < 0;
        here[here[0] < 0 ? 0 : 1] = static_cast<int>(k);
      }
    }
    std::vector<bool> taken(links_.size(), false);
    for (const bool closed : {false, true}) {
      for (std::size_t k = 0; k < links_.size(); ++k) {
        for (const int id : {links_[k].from, links_[k].to}) {
          if (!taken[k] && (closed || at_zero[id][1] < 0)) {
            follow(static_cast<int>(k), id, at_zero, taken);
          }
        }
      }
    }
  }

  void follow(int link, int start, const std::vector<std::array<int, 2>>& at_zero, std::vector<bool>& taken) {
    SheetCurve curve;
    int at = start;
    while (link >= 0 && !taken[link]) {
      taken[link] = true;
      const Link& here = links_[link];
      SheetStep step = here.step;
      const bool forward = here.from == at;
      if (!forward) {
        std::swap(step.from1, step.to1);
        std::swap(step.from2, step.to2);
      }
      at = forward ? here.to : here.from;
      curve.steps.push_back(step);
      const auto& next = at_zero[at];
      link = next[0] == link ? next[1] : next[0];
    }
    curve.closed = at == start;
    if (!curve.closed) {
      curve.ends_at_begin = grid_.boundary_ending_at(start);
      curve.ends_at_end = grid_.boundary_ending_at(at);
      found_.complete = found_.complete && curve.ends_at_begin != 0 && curve.ends_at_end != 0;
    }
    found_.curves.push_back(std::move(curve));
  }

  const TangencySheet& sheet_;
  const MapRange& range_;
  SheetGrid grid_;
  int span1_ = 0, span2_ = 0;  // of the current cell
  Vector2d width_;             // of the current cell
  std::vector<Link> links_;
  SheetCurves found_;
};

}  // namespace

SheetCurves sheet_curves(const TangencySheet& sheet, const MapRange& range) {
  return CurveFinder(sheet, range).run();
}

std::optional<SheetPlaces> place_on(const TangencySheet& sheet, const SheetStep& step, double share) {
  constexpr int kPasses = 12;
  const Vector2d from(step.from1.t, step.from2.t);
  const Vector2d to(step.to1.t, step.to2.t);
  const Vector2d chord = (to - from).cwiseQuotient(step.width);
  const Vector2d across = perp(chord).cwiseProduct(step.width);
  const double length2 = chord.squaredNorm();
  SheetPlaces places{step.from1, step.from2, {}};
  double offset = 0;
  double last = kInf;
  for (int pass = 0; pass < kPasses; ++pass) {
    const Vector2d t = from + share * (to - from) + offset * across;
    places.place1.t = t.x();
    places.place2.t = t.y();
    const SheetPlace at1 = sheet.place1(places.place1);
    const SheetPlace at2 = sheet.place2(places.place2);
    const double value = sheet.value(at1, at2);
    const Vector2d slopes = sheet.slopes(at1, at2);
    const double change = length2 == 0 ? 0 : -value / slopes.dot(across);
    if (!std::isfinite(change)) {
      return std::nullopt;
    }
    const double size = std::abs(change);
    // Where a curve turns sharply, the last digit of its parameter changes F by more than F's own rounding.
    const double rounding = kEps * slopes.cwiseProduct(t).lpNorm<1>();
    if (std::abs(value) <= kEps * sheet.size() || size == 0 || (pass > 2 && size >= last / 2)) {
      places.at = sheet.point(at1, at2);
      const bool near = std::abs(offset) <= 1 && std::abs(value) <= kFineGap * sheet.size() + rounding;
      return near || length2 == 0 ? std::optional(places) : std::nullopt;
    }
    last = size;
    offset += change;
  }
  return std::nullopt;
}

}  // namespace higherpair
