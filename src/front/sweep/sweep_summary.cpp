#include "higherpair/front/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr std::size_t kBars = 12;
constexpr std::size_t kLongestBar = 40;
constexpr std::size_t kMostCauses = 1000;  // largest number of different causes that are counted
constexpr std::size_t kShownCauses = 5;
constexpr std::array kShares = {0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};

std::string plural(std::int64_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

std::string statistics_text(const Column& column, const ColumnStatistics& of) {
  std::string text = fmt::format("\n{} [{}]\n", column.name, column.unit);
  if (of.count() == 0) {
    return text + "  undefined in every variant\n";
  }
  text += fmt::format("  smallest {:.7g}   largest {:.7g}   mean {:.7g}   deviation {:.4g}\n ", of.least(),
                      of.largest(), of.mean(), of.deviation());
  for (const double share : kShares) {
    text += fmt::format("{:>10}", fmt::format("{:g} %", 100 * share));
  }
  text += "\n ";
  for (const double share : kShares) {
    text += fmt::format("{:>10.5g}", of.quantile(share));
  }
  text += "\n";
  if (!(of.largest() > of.least())) {
    return text;
  }
  const auto bars = of.histogram(kBars);
  const std::int64_t most = *std::max_element(bars.begin(), bars.end());
  const double width = (of.largest() - of.least()) / static_cast<double>(kBars);
  for (std::size_t i = 0; i < kBars; ++i) {
    const auto length = static_cast<std::size_t>(std::ceil(
        static_cast<double>(kLongestBar) * static_cast<double>(bars[i]) / static_cast<double>(most)));
    text += fmt::format("  {:>12.6g} {:<{}} {}\n", of.least() + width * static_cast<double>(i),
                        std::string(length, '#'), kLongestBar, bars[i]);
  }
  return text;
}

}  // namespace

void ColumnStatistics::add(double value) {
  if (!std::isfinite(value)) {
    return;
  }
  if (count_++ == 0) {
    least_ = largest_ = first_ = value;
  }
  least_ = std::min(least_, value);
  largest_ = std::max(largest_, value);
  const long double difference = static_cast<long double>(value) - first_;
  sum_ += difference;
  squares_ += difference * difference;
}

double ColumnStatistics::mean() const {
  if (count_ == 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return static_cast<double>(first_ + sum_ / static_cast<long double>(count_));
}

double ColumnStatistics::deviation() const {
  if (count_ < 2) {
    return 0;
  }
  const auto n = static_cast<long double>(count_);
  return static_cast<double>(std::sqrt(std::max(0.0L, (squares_ - sum_ * sum_ / n) / (n - 1))));
}

void ColumnStatistics::place(double value) {
  if (!std::isfinite(value)) {
    return;
  }
  bins_.resize(kBins);
  const double range = largest_ / 2 - least_ / 2;  // the whole one may be beyond what a double holds
  const double share = range > 0 ? std::clamp((value / 2 - least_ / 2) / range, 0.0, 1.0) : 0;
  ++bins_[std::min(static_cast<std::size_t>(share * static_cast<double>(kBins)), kBins - 1)];
}

double ColumnStatistics::quantile(double share) const {
  const double wanted = share * static_cast<double>(count_);
  double below = 0;
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    const auto here = static_cast<double>(bins_[i]);
    if (here > 0 && below + here >= wanted) {
      const double place = static_cast<double>(i) + std::clamp((wanted - below) / here, 0.0, 1.0);
      return std::lerp(least_, largest_, place / static_cast<double>(kBins));
    }
    below += here;
  }
  return largest_;
}

std::vector<std::int64_t> ColumnStatistics::histogram(std::size_t bars) const {
  std::vector<std::int64_t> counts(bars, 0);
  for (std::size_t i = 0; i < bins_.size() && bars > 0; ++i) {
    counts[i * bars / kBins] += bins_[i];
  }
  return counts;
}

SweepSummary::SweepSummary(const Sweep& sweep) : sweep_(sweep), results_(sweep.result_count()) {}

template <class Use>
void SweepSummary::for_each_value(const SweepBlock& block, const Use& use) {
  const std::size_t width = sweep_.columns().size();
  for (std::size_t row = 0; row < block.causes.size(); ++row) {
    for (std::size_t i = 0; i < results_.size(); ++i) {
      use(results_[i], block.values[row * width + sweep_.first_result() + i]);
    }
  }
}

void SweepSummary::add(const SweepBlock& block) {
  const std::size_t width = sweep_.columns().size();
  variants_ += block.variants;
  good_ += block.good;
  rows_ += static_cast<std::int64_t>(block.causes.size());
  for (std::size_t row = 0; row < block.causes.size(); ++row) {
    ++statuses_[static_cast<int>(block.values[(row + 1) * width - 1])];
    add_cause(block.causes[row]);
  }
  for_each_value(block, [](ColumnStatistics& of, double value) { of.add(value); });
}

// Causes that differ only in their numbers are counted as one.
void SweepSummary::add_cause(const std::string& cause) {
  if (cause.empty()) {
    return;
  }
  const std::string kind = cause.substr(0, cause.find(" = "));
  if (causes_.size() < kMostCauses || causes_.contains(kind)) {
    SweepCause& known = causes_[kind];
    if (known.count++ == 0) known.example = cause;
  }
}

std::vector<SweepCause> SweepSummary::causes() const {
  std::vector<SweepCause> causes;
  for (const auto& [kind, cause] : causes_) causes.push_back(cause);
  std::stable_sort(causes.begin(), causes.end(),
                   [](const SweepCause& a, const SweepCause& b) { return a.count > b.count; });
  return causes;
}

void SweepSummary::place(const SweepBlock& block) {
  for_each_value(block, [](ColumnStatistics& of, double value) { of.place(value); });
}

std::string SweepSummary::text(const std::string& title) const {
  std::string text = fmt::format("{}{}{}", title, title.empty() ? "" : "\n\n", plural(variants_, "variant"));
  if (rows_ != variants_) {
    text += fmt::format(", {}", plural(rows_, "row"));
  }
  text += ":";
  const auto words = sweep_.columns().back().words;
  for (const auto& [status, count] : statuses_) {
    text += fmt::format(" {} {}", count, words[status]);
  }
  text += "\n";
  if (!good()) {
    text += fmt::format("{}: the path is not good; the column `cause` says why\n",
                        plural(variants_ - good_, "variant"));
    const std::vector<SweepCause> found = causes();
    for (const SweepCause& cause : std::span(found).first(std::min(found.size(), kShownCauses))) {
      text += fmt::format("  {} times, first: {}\n", cause.count, cause.example);
    }
  }
  for (std::size_t i = 0; i < results_.size(); ++i) {
    text += statistics_text(sweep_.columns()[sweep_.first_result() + i], results_[i]);
  }
  return text;
}

}  // namespace higherpair
