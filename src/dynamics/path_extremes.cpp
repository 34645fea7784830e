#include "higherpair/dynamics/path_extremes.hpp"

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/peaks.hpp"
#include "sample_steps.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kFewest = 48;          // least number of parts of a path
constexpr double kMostSamples = 1e6;    // of a path
constexpr double kFewestInStretch = 3;  // least number of parts between two breaks
constexpr double kMarks = 256;          // positions of the run that are kept to go on from, on a path
// Between samples a motion should not be lost. To take it up again costs thousands of steps: after so many
// times the best value found so far is the extreme.
constexpr int kMostLost = 10;
constexpr std::size_t kApproaches = 5;  // positions at which growth towards a singular one is judged

// Whether rates next to an event grow without bound, or are rounding.
bool is_singular(const RunEvent& event) {
  return event.type == EventType::kLimitPosition || event.type == EventType::kDeadPoint;
}

bool is_lost(const Run& run) {
  return !run.at.on_branch || std::any_of(run.events.begin(), run.events.end(), [](const RunEvent& event) {
    return event.type == EventType::kLimitPosition;
  });
}

// The number of parts at whose ends a stretch of the path without breaks is sampled.
double sampled_parts(const Run& start, const DriverPath& path, double from, double to) {
  return std::ceil(std::max(
      kFewest, largest_move(start, path.at(from), path.at(to), kLongestSampleTurn, kLongestSampleSlide)));
}

// A run that moves along the path.
class Mover {
public:
  Mover(const Run& run, const DriverPath& path, double at) : path_(&path), run_(run), at_(at) {}

  const Run& move(double at) {
    path_->move(run_, at_, at);
    at_ = at;
    return run_;
  }
  [[nodiscard]] double at() const { return at_; }
  [[nodiscard]] const Run& run() const { return run_; }

private:
  const DriverPath* path_;
  Run run_;
  double at_;
};

// A stretch of the path on which everything is smooth, as far as is known.
struct Stretch {
  double from = 0;
  double to = 0;
  std::optional<double> singular_from;  // the place of something singular before it
  std::optional<double> singular_to;    // and beyond it
  std::optional<Mover> first;           // at the first position, if there is something singular before it
  std::vector<double> at;
  std::vector<std::vector<double>> values;  // of every quantity, at those positions
};

// All quantities on the way from a stretch's outermost sample to the singular position beyond it. The first
// are those of the sample; the distance that is left is halved from each to the next.
struct Approach {
  double at = 0;  // of the sample
  std::array<std::vector<double>, kApproaches> values;
};

class Search {
public:
  Search(const Run& start, const DriverPath& path, const std::vector<PathQuantities>& blocks,
         const std::vector<double>& breaks)
      : start_(start), path_(path), blocks_(blocks), breaks_(breaks) {}

  std::vector<std::vector<PathRange>> run() {
    sample();
    approach();
    std::vector<std::vector<PathRange>> ranges;
    std::size_t first = 0;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      ranges.emplace_back();
      for (std::size_t k = 0; k < blocks_[b].sought.size(); ++k) {
        const Sought& sought = blocks_[b].sought[k];
        PathRange range;
        if (sought.greatest) range.greatest = extreme(b, k, first + k, 1);
        if (sought.least) range.least = extreme(b, k, first + k, -1);
        ranges.back().push_back(range);
      }
      first += blocks_[b].sought.size();
    }
    return ranges;
  }

private:
  void sample() {
    for (const PathQuantities& block : blocks_) {
      count_ += block.sought.size();
    }
    Mover mover(start_, path_, path_.knots.front());
    if (path_.knots.size() == 1) {
      begin(mover.at());
      take(mover, mover.at());
      end(mover.at());
      return;
    }
    for (std::size_t i = 1; i < path_.knots.size(); ++i) {
      const double from = path_.knots[i - 1], to = path_.knots[i];
      const double longest = (to - from) / sampled_parts(start_, path_, from, to);
      std::vector<double> ends{from};
      for (const double at : breaks_) {
        if (at > from && at < to) ends.push_back(at);
      }
      ends.push_back(to);
      for (std::size_t k = 1; k < ends.size() && !is_stopped(start_); ++k) {
        sample_between(mover, ends[k - 1], ends[k],
                       std::min(longest, (ends[k] - ends[k - 1]) / kFewestInStretch));
      }
    }
  }

  void sample_between(Mover& mover, double from, double to, double longest) {
    begin(from);
    const double last = std::lerp(from, to, 1 - kInsideStretch);
    double at = std::lerp(from, to, kInsideStretch);
    take(mover, at);
    while (at < last && !is_stopped(start_)) {
      const double step = std::max(steps_.next(mover.run(), at, longest), shortest_);
      const double left = std::ceil((last - at) / step - kRoomInStep);
      at = left > 1 ? at + (last - at) / left : last;
      take(mover, at);
    }
    end(to);
  }

  void begin(double from) {
    stretches_.push_back({from, from, {}, {}, {}, {}, std::vector<std::vector<double>>(count_)});
  }
  void end(double to) { stretches_.back().to = to; }

  void take(Mover& mover, double at) {
    const double was = mover.at();
    const Run& run = mover.move(at);
    bool skip = false;
    std::vector<double> breaks;
    for (const double share : run.smooth_joints) {
      breaks.push_back(path_.place_of(share, was, at));
    }
    for (const RunEvent& event : run.events) {
      const double place = path_.place_of(event.share, was, at);
      if (is_singular(event)) {
        part_at(place, at, kApartFromSingular * (at - was));
        skip = skip || at - place < kApartFromSingular * (at - was);
      } else if (breaks_motion(event.type)) {
        breaks.push_back(place);
      }
    }
    std::sort(breaks.begin(), breaks.end());
    for (const double place : breaks) {
      if (place > stretches_.back().from && !stretches_.back().at.empty() && place < at) {
        end(place);
        begin(place);
      }
    }
    if (skip) {
      return;
    }
    stretches_.back().at.push_back(at);
    if (stretches_.back().singular_from && !stretches_.back().first) stretches_.back().first = mover;
    std::size_t first = 0;
    for (const PathQuantities& block : blocks_) {
      const std::vector<double> values = values_of(block, run, at);
      for (std::size_t k = 0; k < values.size(); ++k) {
        stretches_.back().values[first + k].push_back(values[k]);
      }
      first += values.size();
    }
    if (marks_.empty() || at - marks_.back().at() >= between_marks_) {
      marks_.push_back(mover);
    }
  }

  // Ends the stretch before a singular position and begins another one beyond it.
  void part_at(double place, double at, double apart) {
    Stretch& before = stretches_.back();
    while (!before.at.empty() && place - before.at.back() < apart) {
      before.at.pop_back();
      for (std::vector<double>& values : before.values) {
        values.pop_back();
      }
    }
    before.singular_to = place;
    end(before.at.empty() ? before.from : before.at.back());
    begin(at);
    stretches_.back().singular_from = place;
  }

  void approach() {
    for (const Stretch& stretch : stretches_) {
      if (stretch.at.empty() || is_stopped(start_)) continue;
      if (stretch.singular_from) approach(stretch, stretch.at.front(), *stretch.singular_from);
      if (stretch.singular_to) approach(stretch, stretch.at.back(), *stretch.singular_to);
    }
  }

  void approach(const Stretch& stretch, double at, double singular) {
    // From the last state before it that is known, on the same stretch.
    const auto after = mark_after(at);
    const bool marked = after != marks_.begin() && !(stretch.first && after[-1].at() < stretch.first->at());
    Mover mover = marked ? after[-1] : stretch.first.value_or(marks_.front());
    Approach& found = approaches_.emplace_back();
    found.at = at;
    for (std::size_t i = 0; i < kApproaches; ++i) {
      const double place = singular + std::ldexp(at - singular, -static_cast<int>(i));
      const Run& run = mover.move(place);
      for (const PathQuantities& block : blocks_) {
        const std::vector<double> values = values_of(block, run, place);
        found.values[i].insert(found.values[i].end(), values.begin(), values.end());
      }
    }
  }

  // The first mark beyond a place.
  [[nodiscard]] std::vector<Mover>::const_iterator mark_after(double at) const {
    return std::upper_bound(marks_.begin(), marks_.end(), at,
                            [](double place, const Mover& mark) { return place < mark.at(); });
  }

  static std::vector<double> values_of(const PathQuantities& block, const Run& run, double at) {
    std::vector<double> values(block.sought.size(), kNoValue);
    if (run.row.status == RowStatus::kOk || run.row.status == RowStatus::kOverlap ||
        run.row.status == RowStatus::kContactOpen) {
      block.values(run, at, values);
    }
    return values;
  }

  [[nodiscard]] std::optional<PathExtreme> extreme(std::size_t b, std::size_t k, std::size_t index,
                                                   double sign) const {
    PeakFinder finder;
    double largest = 0;
    for (const Stretch& stretch : stretches_) {
      std::vector<double> values = stretch.values[index];
      for (double& value : values) {
        value *= sign;
        largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
      }
      if (!values.empty()) {
        finder.add(stretch.at, values, stretch.singular_from ? stretch.at.front() : stretch.from,
                   stretch.singular_to ? stretch.at.back() : stretch.to);
      }
    }
    std::optional<Mover> mover;
    int lost = 0;
    const auto value = [&](double at) {
      if (lost >= kMostLost) {
        return kNoValue;
      }
      // Start from the last mark before the first position that is asked for, then move back and forth:
      // between neighbouring samples of a stretch the branch is not lost, but back over a break it may be.
      if (!mover || !mover->run().at.on_branch || std::abs(at - mover->at()) > between_marks_ ||
          &stretch_at(at) != &stretch_at(mover->at())) {
        const auto after = mark_after(at);
        mover.emplace(after == marks_.begin() ? marks_.front() : after[-1]);
      }
      const Run& run = mover->move(at);
      lost += is_lost(run) ? 1 : 0;
      return sign * values_of(blocks_[b], run, at)[k];
    };
    PeakLimits limits;
    limits.shortest = kJumpPlace * (path_.knots.back() - path_.knots.front());
    limits.noise = std::max(kValueRounding * largest, blocks_[b].sought[k].noise);
    const auto peak = finder.largest(value, limits);
    if (!peak || is_stopped(start_)) {
      return std::nullopt;
    }
    const bool nothing = largest <= blocks_[b].sought[k].noise;
    const double at = settled(peak->at);
    PathExtreme extreme{nothing ? 0 : sign * peak->value, at, path_.at(at).front().position,
                        !nothing && grows_at(at, index, sign, limits.noise), std::nullopt};
    if (!nothing) {
      extreme.growth = growth(index, sign, peak->value, std::max(limits.noise, kLeastGrowth * largest));
    }
    return extreme;
  }

  // Where sign times a quantity goes on beyond a level, towards something singular. What it rises by while
  // the distance is halved stays the same for a logarithm and becomes less for anything bounded.
  [[nodiscard]] std::optional<PathGrowth> growth(std::size_t index, double sign, double level,
                                                 double least) const {
    std::optional<PathGrowth> farthest;
    for (const Approach& approach : approaches_) {
      const auto rise = [&](std::size_t i) {
        return sign * (approach.values[i][index] - approach.values[i - 1][index]);
      };
      constexpr std::size_t last = kApproaches - 1;
      if (!(rise(last) > least)) {
        continue;
      }
      const bool unbounded =
          rise(last) > rise(last - 1) && rise(last - 1) > rise(last - 2) && rise(last - 2) > 0;
      const double limit =
          unbounded ? kInf : sign * approach.values[last][index] + rise(last) / (std::sqrt(2.0) - 1);
      if (limit > level + least && (!farthest || limit > sign * farthest->limit)) {
        farthest = PathGrowth{approach.at, path_.at(approach.at).front().position, sign * limit};
      }
    }
    return farthest;
  }

  // Whether a place is the sample next to something singular, and the quantity has risen up to there.
  [[nodiscard]] bool grows_at(double at, std::size_t index, double sign, double noise) const {
    return std::any_of(stretches_.begin(), stretches_.end(), [&](const Stretch& stretch) {
      const std::size_t count = stretch.at.size();
      const auto rises = [&](std::size_t end, std::size_t beside) {
        const std::vector<double>& values = stretch.values[index];
        return at == stretch.at[end] && (count == 1 || !(sign * (values[end] - values[beside]) <= noise));
      };
      return count > 0 &&
             ((stretch.singular_from && rises(0, 1)) || (stretch.singular_to && rises(count - 1, count - 2)));
    });
  }

  [[nodiscard]] const Stretch& stretch_at(double at) const {
    const auto after =
        std::upper_bound(stretches_.begin(), stretches_.end(), at,
                         [](double place, const Stretch& stretch) { return place < stretch.from; });
    return after == stretches_.begin() ? stretches_.front() : after[-1];
  }

  // The outermost sample of a stretch counts as its end, as does any position within rounding of it.
  [[nodiscard]] double settled(double at) const {
    const Stretch& stretch = stretch_at(at);
    const auto is_end = [&](double distance) {
      const double share = distance / (stretch.to - stretch.from);
      return share < kJumpPlace * 10 || std::abs(share - kInsideStretch) < kJumpPlace * 10;
    };
    return stretch.singular_from || stretch.singular_to ? at
           : is_end(at - stretch.from)                  ? stretch.from
           : is_end(stretch.to - at)                    ? stretch.to
                                                        : at;
  }

  const Run& start_;
  const DriverPath& path_;
  const std::vector<PathQuantities>& blocks_;
  const std::vector<double>& breaks_;
  std::size_t count_ = 0;  // number of quantities
  SampleSteps steps_{start_.mechanism()};
  std::vector<Stretch> stretches_;
  std::vector<Approach> approaches_;
  std::vector<Mover> marks_;
  double shortest_ = (path_.knots.back() - path_.knots.front()) / kMostSamples;  // step
  double between_marks_ = (path_.knots.back() - path_.knots.front()) / kMarks;
};

}  // namespace

std::optional<double> cut_to_examined(const Run& start, DriverPath& path) {
  double left = kMostSamples;
  for (std::size_t i = 1; i < path.knots.size(); ++i) {
    const double parts = sampled_parts(start, path, path.knots[i - 1], path.knots[i]);
    if (parts > left) {
      const double end = std::lerp(path.knots[i - 1], path.knots[i], left / parts);
      path.knots.resize(i);
      if (left > 0) path.knots.push_back(end);
      return end;
    }
    left -= parts;
  }
  return std::nullopt;
}

std::vector<std::vector<PathRange>> path_extremes(const Run& start, const DriverPath& path,
                                                  const std::vector<PathQuantities>& blocks,
                                                  const std::vector<double>& breaks) {
  return Search(start, path, blocks, breaks).run();
}

}  // namespace higherpair
