#include "higherpair/analysis/start_ranges.hpp"

#include "analysis/tolerances.hpp"
#include "assembly.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/mobility_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace higherpair {
namespace {

constexpr int kTries = 72;
constexpr int kTriesBeside = 36;  // in each of the two steps next to the start
constexpr int kHalvings = 24;     // 2^-24/72 < 1e-9
constexpr std::size_t kMostRanges = 3;

// A range with what is known of its ends: each lies between a position at which the mechanism can be
// assembled and one at which it cannot. Where they are the same the end is that of the scan.
struct RoughRange {
  std::array<double, 2> inside{}, outside{};  // of the low and the high end
  bool settled = false;

  [[nodiscard]] StartRange range() const { return {inside[0], inside[1]}; }
};

// \param turn  of a driver that turns; else 0
double distance(const StartRange& range, double from, double turn) {
  const double ahead = std::min(std::abs(range.low - from), std::abs(range.high - from));
  return turn > 0 ? std::min(ahead, std::abs(from + turn - range.high)) : ahead;
}

// The least distance that the range can turn out to have.
double least_distance(const RoughRange& rough, double from, double turn) {
  return distance({rough.inside[0], rough.inside[1]}, from, turn) -
         std::max(std::abs(rough.inside[0] - rough.outside[0]), std::abs(rough.inside[1] - rough.outside[1]));
}

class Scan {
public:
  // \param closed  whether it ends where it begins, at the start; else the start is in its middle
  Scan(Run& run, double from, double span, bool closed)
      : run_(run), from_(from), span_(span), closed_(closed) {}

  // The ranges nearest to a position, the nearest first. Only those that may be among them are settled: where
  // teeth mesh there are many, and every trial has to look for overlaps of all of them.
  std::vector<StartRange> nearest(double to, double turn) {
    std::vector<RoughRange> found = rough_ranges();
    // Of two that are equally near the first on the way.
    const double same = kSameStartDistance * span_;
    const auto rank = [&](const RoughRange& range) {
      const double settled = std::round(distance(range.range(), to, turn) / same) * same;
      return std::pair(range.settled ? settled : least_distance(range, to, turn) - same, range.inside[0]);
    };
    const auto sort = [&] {
      std::sort(found.begin(), found.end(),
                [&](const RoughRange& a, const RoughRange& b) { return rank(a) < rank(b); });
    };
    const auto open = [&] {
      const auto end = found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), kMostRanges));
      const auto first = std::find_if(found.begin(), end, [](const RoughRange& one) { return !one.settled; });
      return first == end ? nullptr : &*first;
    };
    sort();
    for (RoughRange* range = open(); range != nullptr && !is_stopped(run_); range = open()) {
      settle(*range);
      sort();
    }
    std::vector<StartRange> ranges;
    for (std::size_t i = 0; i < std::min(found.size(), kMostRanges); ++i) {
      ranges.push_back(found[i].range());
    }
    return ranges;
  }

private:
  std::vector<RoughRange> rough_ranges() {
    std::vector<RoughRange> found;
    const std::vector<double> tried = shares();
    const bool first = assembles(at(0));
    bool last = first;
    if (first) {
      found.push_back({{at(0), at(1)}, {at(0), at(1)}});
    }
    for (std::size_t k = 1; k < tried.size() && !is_stopped(run_); ++k) {
      const double here = at(tried[k]);
      const double before = at(tried[k - 1]);
      const bool now = closed_ && k + 1 == tried.size() ? first : assembles(here);
      if (now && !last) {
        found.push_back({{here, at(1)}, {before, at(1)}});
      } else if (!now && last) {
        found.back().inside[1] = before;
        found.back().outside[1] = here;
      }
      last = now;
    }
    return found;
  }

  // The positions to try, as fractions of the range: more of them next to the start.
  [[nodiscard]] std::vector<double> shares() const {
    std::vector<double> shares;
    for (int k = 0; k < kTries; ++k) {
      const bool beside = closed_ ? k == 0 || k + 1 == kTries : k == kTries / 2 || k + 1 == kTries / 2;
      const int parts = beside ? kTriesBeside : 1;
      for (int i = 0; i < parts; ++i) {
        shares.push_back((k + static_cast<double>(i) / parts) / kTries);
      }
    }
    shares.push_back(1);
    return shares;
  }

  void settle(RoughRange& range) {
    for (std::size_t end = 0; end < 2; ++end) {
      double& inside = range.inside[end];
      for (int i = 0; i < kHalvings && range.outside[end] != inside && !is_stopped(run_); ++i) {
        const double middle = (inside + range.outside[end]) / 2;
        (assembles(middle) ? inside : range.outside[end]) = middle;
      }
    }
    range.settled = true;
  }

  [[nodiscard]] double at(double x) const { return from_ + x * span_; }

  bool assembles(double driver) {
    run_.at.inputs.front() = driver;
    return !assemble(run_);
  }

  Run& run_;
  double from_;
  double span_;
  bool closed_;
};

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
  const double from = drivers.front();
  std::vector<StartRange> ranges = turn > 0 ? Scan(*run, from, turn, true).nearest(from, turn)
                                            : Scan(*run, from - reach, 2 * reach, false).nearest(from, turn);
  if (is_stopped(*run)) {
    return std::nullopt;
  }
  for (StartRange& range : ranges) {
    const double ahead = (range.low + range.high) / 2 - from;
    const double turns = turn > 0 ? turn * std::ceil(ahead / turn - 0.5 - kSameStartDistance) : 0;
    range = {range.low - turns, range.high - turns};
  }
  return ranges;
}

}  // namespace higherpair
