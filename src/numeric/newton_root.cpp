#include "higherpair/numeric/newton_root.hpp"

#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {

namespace {

// The bracket of the search: its end `near`, on the side of 0, where value and slope are known, and its end
// `far`, beyond the root.
class Search {
public:
  Search(const ValueAndSlope& at_0, double h) : h_(h), at_near_(at_0), far_(h), last_(std::abs(h)) {}

  [[nodiscard]] bool is_within(double x) const { return (x - near_) * h_ > 0 && (far_ - x) * h_ > 0; }

  [[nodiscard]] double next() {
    if (is_within(from_far_)) {
      return from_far_;
    }
    const double step = -at_near_.value / at_near_.slope;
    // Where f jumps to the other sign, the root is approached from this side, stopping short by twice the
    // second-order correction of the Newton step, and by more than rounding.
    const double x =
        near_ +
        (jumps_ ? step * (1 - std::clamp(2 * bend_ * std::abs(step), kLeastShortOfRoot, kMostShortOfRoot))
                : step);
    halved_ = !is_within(x);
    return halved_ ? near_ + (far_ - near_) / 2 : x;
  }

  // Takes in the value found at x; returns whether the search ends there.
  bool take(double x, const ValueAndSlope& at) {
    const bool known = std::isfinite(at.value);
    const double step = -at.value / at.slope;
    const double size = std::abs(step);
    if (known &&
        (x + step == x || (!halved_ && size <= kNewtonRootNear * std::abs(h_) && size >= last_ / 2))) {
      return true;
    }
    from_far_ = kNoValue;
    if (known && std::signbit(at.value) == std::signbit(at_near_.value)) {
      bend_ = std::abs((at.slope - at_near_.slope) / ((x - near_) * 2 * at.slope));
      near_ = x;
      at_near_ = at;
      last_ = size;
      return false;
    }
    far_ = x;
    if (known && is_within(x + step)) {
      from_far_ = x + step;
      last_ = size;
    } else {
      jumps_ = true;
    }
    return false;
  }

  // The near end, if f falls to 0 there.
  [[nodiscard]] std::optional<double> end(double nothing) const {
    const bool is_root = std::abs(at_near_.value) <= nothing ||
                         std::abs(at_near_.value / at_near_.slope) <= kNewtonRootNear * std::abs(h_);
    return is_root ? std::optional(near_) : std::nullopt;
  }

private:
  double h_;
  double near_ = 0;
  ValueAndSlope at_near_;
  double far_;
  double from_far_ = kNoValue;  // where Newton's step from the far end leads
  bool jumps_ = false;          // that step does not lead into the bracket
  bool halved_ = false;         // the last place is a bisection, not a Newton step
  double bend_ = kInf;          // |f''/2f'| at the near end
  double last_;                 // size of the last step
};

}  // namespace

std::optional<double> newton_root_between(const std::function<ValueAndSlope(double)>& f,
                                          const ValueAndSlope& at_0, double h, double at_h, double nothing) {
  constexpr int kMostCalls = 100;
  if (at_0.value == 0) {
    return 0.0;
  }
  if (at_h == 0) {
    return h;
  }
  if (!(std::signbit(at_0.value) != std::signbit(at_h)) || !std::isfinite(at_0.value) ||
      !std::isfinite(at_h)) {
    return std::nullopt;
  }
  Search search(at_0, h);
  for (int i = 0; i < kMostCalls; ++i) {
    const double x = search.next();
    if (!search.is_within(x)) {
      break;
    }
    const ValueAndSlope at = f(x);
    if (at.value == 0 || search.take(x, at)) {
      return x;
    }
  }
  return search.end(nothing);
}

}  // namespace higherpair
