#include "higherpair/analysis/start_ranges.hpp"

#include "assembly.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kTries = 72;
constexpr int kHalvings = 24;  // 2^-24/72 < 1e-9
constexpr std::size_t kMostRanges = 3;

class Scan {
public:
  // \param closed  whether it ends where it begins
  Scan(Run& run, double from, double span, bool closed)
      : run_(run), from_(from), span_(span), closed_(closed) {}

  std::vector<StartRange> ranges() {
    std::vector<StartRange> found;
    const bool first = assembles(0);
    bool last = first;
    if (first) {
      found.push_back({at(0), at(1)});
    }
    for (int k = 1; k <= kTries && !is_stopped(run_); ++k) {
      const double x = static_cast<double>(k) / kTries;
      const double before = static_cast<double>(k - 1) / kTries;
      const bool here = closed_ && k == kTries ? first : assembles(x);
      if (here && !last) {
        found.push_back({at(end_between(x, before)), at(1)});
      } else if (!here && last) {
        found.back().high = at(end_between(before, x));
      }
      last = here;
    }
    return found;
  }

private:
  [[nodiscard]] double at(double x) const { return from_ + x * span_; }

  bool assembles(double x) {
    run_.at.drivers.front() = at(x);
    return !assemble(run_);
  }

  // The last position at which the mechanism can be assembled, from `inside` to `outside`.
  double end_between(double inside, double outside) {
    for (int i = 0; i < kHalvings && !is_stopped(run_); ++i) {
      const double middle = (inside + outside) / 2;
      (assembles(middle) ? inside : outside) = middle;
    }
    return inside;
  }

  Run& run_;
  double from_;
  double span_;
  bool closed_;
};

double distance(const StartRange& range, double from, double turn) {
  const double ahead = std::min(std::abs(range.low - from), std::abs(range.high - from));
  return turn > 0 ? std::min(ahead, std::abs(from + turn - range.high)) : ahead;
}

}  // namespace

std::optional<std::vector<StartRange>> find_start_ranges(const Mechanism& mechanism,
                                                         const std::vector<double>& drivers, double tolerance,
                                                         const std::atomic<bool>* stop) {
  auto run = planned_run(mechanism, drivers);
  if (!run || drivers.empty() || surplus_objection(mechanism, run->plan(), drivers)) {
    return std::nullopt;
  }
  run->tolerance = tolerance;
  run->stop = stop;
  if (!assemble(*run)) {
    return std::nullopt;
  }
  const double turn = driven_joint(mechanism).type == JointType::kRevolute ? 2 * kPi : 0;
  const double reach = kReachOfSlide * run->plan().size;
  std::vector<StartRange> ranges = turn > 0 ? Scan(*run, drivers.front(), turn, true).ranges()
                                            : Scan(*run, drivers.front() - reach, 2 * reach, false).ranges();
  if (is_stopped(*run)) {
    return std::nullopt;
  }
  std::stable_sort(ranges.begin(), ranges.end(), [&](const StartRange& a, const StartRange& b) {
    return distance(a, drivers.front(), turn) < distance(b, drivers.front(), turn);
  });
  ranges.resize(std::min(ranges.size(), kMostRanges));
  for (StartRange& range : ranges) {
    const double turns = turn > 0 ? turn * (std::ceil(range.high / turn) - 1) : 0;
    range = {range.low - turns, range.high - turns};
  }
  return ranges;
}

}  // namespace higherpair
