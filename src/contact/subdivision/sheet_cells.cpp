#include "sheet_cells.hpp"

namespace higherpair {
namespace {

constexpr int kMostCellHalvings = 60;  // 30 of each parameter
constexpr int kMostLooks = 2000;       // at parts of one cell

class CellSearch {
public:
  CellSearch(const TangencySheet& sheet, const StretchNode& one, const StretchNode& two, double level,
             double sign)
      : sheet_(sheet), rim1_(one.t()), rim2_(two.t()), level_(level), sign_(sign) {}

  [[nodiscard]] CellLook look(StretchNode& one, StretchNode& two, int halvings) {
    const SheetStretch& a = one.stretch();
    const SheetStretch& b = two.stretch();
    const SheetRange range = sheet_.range(a, b, level_);
    if (!range.zero) {
      return {};
    }
    if (sign_ * (sheet_.value(a.middle, b.middle) - level_) < 0 && sheet_.faces(a.middle, b.middle)) {
      return {Vector2d((one.t().low + one.t().high) / 2, (two.t().low + two.t().high) / 2), true};
    }
    if (one.is_place() && two.is_place()) {
      return {};
    }
    // Along a stretch on which F is monotonic, sign·F is least at one end; on the rim there is no zero.
    if (range.slope1 != 0 && !one.is_place()) {
      StretchNode& least = one.end(sign_ * range.slope1 < 0);
      return is_end(rim1_, least) ? CellLook{} : look(least, two, halvings);
    }
    if (range.slope2 != 0 && !two.is_place()) {
      StretchNode& least = two.end(sign_ * range.slope2 < 0);
      return is_end(rim2_, least) ? CellLook{} : look(one, least, halvings);
    }
    if (halvings == kMostCellHalvings || ++looks_ > kMostLooks) {
      return {std::nullopt, false};
    }
    const auto effect = [&](const SheetStretch& stretch) {
      return stretch.reach + stretch.tilt * sheet_.size();
    };
    const bool halve_first = !one.is_place() && (two.is_place() || effect(a) > effect(b));
    CellLook all;
    for (const bool high : {false, true}) {
      CellLook part =
          halve_first ? look(one.half(high), two, halvings + 1) : look(one, two.half(high), halvings + 1);
      if (part.place) {
        return part;
      }
      all.proven = all.proven && part.proven;
    }
    return all;
  }

private:
  [[nodiscard]] static bool is_end(const Bounds& rim, const StretchNode& place) {
    return place.t().low == rim.low || place.t().low == rim.high;
  }

  const TangencySheet& sheet_;
  Bounds rim1_, rim2_;  // the cell
  double level_;
  double sign_;
  int looks_ = 0;
};

}  // namespace

StretchNode::StretchNode(const TangencySheet& sheet, bool first, int span, const Bounds& t)
    : sheet_(&sheet),
      first_(first),
      span_(span),
      t_(t),
      stretch_(first ? sheet.stretch1(span, t) : sheet.stretch2(span, t)) {}

StretchNode& StretchNode::child(std::size_t k) {
  if (!children_[k]) {
    const double middle = t_.low + t_.width() / 2;
    const Bounds t = k == 0   ? Bounds{t_.low, middle}
                     : k == 1 ? Bounds{middle, t_.high}
                     : k == 2 ? Bounds{t_.low, t_.low}
                              : Bounds{t_.high, t_.high};
    children_[k] = std::make_unique<StretchNode>(*sheet_, first_, span_, t);
  }
  return *children_[k];
}

CellLook look_into_cell(const TangencySheet& sheet, StretchNode& one, StretchNode& two, double level,
                        double sign) {
  return CellSearch(sheet, one, two, level, sign).look(one, two, 0);
}

}  // namespace higherpair
