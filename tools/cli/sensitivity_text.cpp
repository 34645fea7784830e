#include "paragraph.hpp"
#include "sensitivity_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/ranges.h>

namespace higherpair::cli {
namespace {

constexpr std::size_t kNameWidth = 40;
constexpr double kGoodDifference = 1e-4;  // relative error that leaves the first four of six digits right

std::string figure(double value, int digits = 6) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits);
}

std::string trimmed(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

// A name, padded to its column; a long one gets a line of its own.
std::string named(const std::string& name) {
  return name.size() <= kNameWidth ? fmt::format("  {:<{}}", name, kNameWidth)
                                   : fmt::format("  {}\n  {:<{}}", name, "", kNameWidth);
}

// Remarks on the slopes of several numbers, each printed once with all the numbers that it concerns.
class Remarks {
public:
  void add(const std::string& remark, const std::string& name) {
    const auto found =
        std::find_if(remarks_.begin(), remarks_.end(), [&](const auto& one) { return one.first == remark; });
    if (found == remarks_.end()) {
      remarks_.push_back({remark, {name}});
    } else {
      found->second.push_back(name);
    }
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const auto& [remark, names] : remarks_) {
      text += paragraph(fmt::format("{}: {}", fmt::join(names, ", "), remark), 2);
    }
    return text;
  }

private:
  std::vector<std::pair<std::string, std::vector<std::string>>> remarks_;
};

class SensitivityWriter {
public:
  explicit SensitivityWriter(const SensitivityFindings& findings)
      : findings_(findings), report_(findings.report) {}

  std::string write() {
    if (!report_.title.empty()) text_ += report_.title + "\n";
    for (std::size_t m = 0; m < report_.results.size(); ++m) {
      result_ = &report_.results[m];
      index_ = m;
      write_head();
      if (findings_.task != nullptr) {
        write_tolerances();
        write_bands();
      } else {
        write_slopes();
      }
    }
    write_idle();
    if (findings_.variants) write_variants();
    if (!report_.good) text_ += "\nthe path is not good\n";
    return std::move(text_);
  }

private:
  // Writes a line such as "peak, maxabs of follower.alpha: 19.47 deg/s^2, at 30 deg".
  void write_head() {
    const ResultSensitivity& result = *result_;
    const std::string what = result.measure.of == MeasureKind::kAt
                                 ? fmt::format("{} at {}", result.measure.column, figure(result.measure.at))
                                 : fmt::format("{} of {}", name_of(result.measure.of), result.measure.column);
    const std::string automatic = fmt::format("{}:{}", result.measure.column, name_of(result.measure.of));
    const bool own_name = !result.name.starts_with(automatic);
    const std::string unit = result.unit == "1" ? "" : fmt::format(" {}", result.unit);
    const bool placed = result.where && is_placed();
    text_ += "\n";
    text_ += paragraph(
        fmt::format("{}{}: {}{}{}", own_name ? fmt::format("{}, ", result.name) : "", what,
                    figure(result.value, 9), unit,
                    placed ? fmt::format(", at {} {}", figure(*result.where), report_.where_unit) : ""),
        0);
    if (!result.remark.empty()) text_ += paragraph(result.remark, 2);
    if (result.rival) {
      const double gap =
          std::abs(result.value) > 0 ? std::abs((result.value - *result.rival) / result.value) : 1;
      if (gap < kNearRival) {
        text_ += paragraph(
            fmt::format("at {} {} it is {}{}, almost the same: that place may take over",
                        figure(*result.rival_where), report_.where_unit, figure(*result.rival, 9), unit),
            2);
      }
    }
  }

  [[nodiscard]] bool is_placed() const {
    const MeasureKind of = result_->measure.of;
    return of == MeasureKind::kMax || of == MeasureKind::kMin || of == MeasureKind::kMaxAbs;
  }

  [[nodiscard]] const Slope& slope(std::size_t i) const { return result_->slopes[i]; }

  // The numbers with an influence on the result, most important first.
  [[nodiscard]] std::vector<std::size_t> ranked() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < report_.numbers.size(); ++i) {
      if (slope(i).kind == SlopeKind::kNone || slope(i).steepest() != 0) order.push_back(i);
    }
    const auto weight = [&](std::size_t i) {
      const double of = slope(i).kind == SlopeKind::kNone ? 0 : slope(i).steepest();
      return std::abs(of) * report_.numbers[i].scale;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return weight(a) > weight(b); });
    return order;
  }

  // "deg/unit": each row gives the unit of its number.
  [[nodiscard]] std::string slope_head() const {
    const bool plain = result_->unit == "1" || result_->unit.size() > 5;
    return plain ? "per unit" : fmt::format("{}/unit", result_->unit);
  }

  void write_slopes() {
    const std::vector<std::size_t> order = ranked();
    if (order.empty()) {
      text_ += "  none of the numbers changes it\n";
      return;
    }
    const Slope& first = slope(order.front());
    if (first.kind == SlopeKind::kNone) {  // they are last in this order, so no number has a slope
      text_ += paragraph(fmt::format("no derivatives: {}", reason(first)), 2);
      return;
    }
    text_ += fmt::format("  {:<{}}{:>10} {:<4} {:>11} {:>8}\n", "", kNameWidth, "number", "", slope_head(),
                         "% per %");
    Remarks remarks;
    for (std::size_t k = 0; k < std::min(order.size(), findings_.top); ++k) {
      const SensitivityNumber& number = report_.numbers[order[k]];
      const auto relative = relative_slope(*result_, order[k], report_);
      text_ += named(number.name) +
               trimmed(fmt::format("{:>10} {:<4} {:>11} {:>8}", figure(number.value),
                                   number.unit == "1" ? "" : number.unit, figure(slope(order[k]).steepest()),
                                   relative ? fmt::format("{:.3f}", *relative) : ""));
      note(order[k], remarks);
    }
    text_ += remarks.text();
    if (order.size() > findings_.top) {
      text_ +=
          fmt::format("  and {} more: --top {} prints all\n", order.size() - findings_.top, order.size());
    }
  }

  void note(std::size_t i, Remarks& remarks) const {
    const std::string& name = report_.numbers[i].name;
    const Slope& one = slope(i);
    if (one.kind == SlopeKind::kKink) {
      remarks.add(
          fmt::format("{} to smaller values, {} to larger ones: a kink", figure(one.down), figure(one.up)),
          name);
    } else if (one.kind == SlopeKind::kDifferences) {
      remarks.add(one.error <= kGoodDifference * std::abs(one.up)
                      ? "by differences, good to the digits shown but the last ones"
                      : fmt::format("by differences, with an error of about {:.1g} %",
                                    100 * one.error / std::abs(one.up)),
                  name);
    } else if (one.kind == SlopeKind::kNone) {
      remarks.add(reason(one), name);
    }
  }

  static std::string reason(const Slope& none) {
    return none.remark.empty() ? "the result has no value, or its rates are not defined there" : none.remark;
  }

  void write_tolerances() {
    const ToleranceBand& band = findings_.bands[index_];
    text_ += fmt::format("  {:<24}{:>10} {:<4} {:>9} {:>9} {:>10} {:>7}\n", "", "number", "", "plus", "minus",
                         slope_head(), "share");
    Remarks remarks;
    for (const std::size_t i : band.order) {
      const Tolerance& tolerance = findings_.task->tolerances[i];
      const std::string name = tolerance.name.size() <= 24
                                   ? fmt::format("  {:<24}", tolerance.name)
                                   : fmt::format("  {}\n  {:<24}", tolerance.name, "");
      text_ += name + trimmed(fmt::format(
                          "{:>10} {:<4} {:>9} {:>9} {:>10} {:>5.1f} %", figure(tolerance.value),
                          tolerance.unit == "1" ? "" : tolerance.unit, figure(tolerance.plus, 4),
                          figure(tolerance.minus, 4), figure(slope(i).steepest(), 5), 100 * band.shares[i]));
      note(i, remarks);
    }
    text_ += remarks.text();
  }

  void write_bands() {
    const ToleranceBand& band = findings_.bands[index_];
    const double value = result_->value;
    const bool known = !std::isnan(value);
    const auto line = [&](const std::string& name, double low, double high) {
      const std::string from_value =
          known ? fmt::format("{:>+11.4g} {:>+11.4g}", low - value, high - value) : "";
      text_ += trimmed(
          fmt::format("  {:<22}{:>14} to {:<14} {}", name, figure(low, 9), figure(high, 9), from_value));
    };
    if (known) {
      line("worst case", band.worst_low, band.worst_high);
      line("statistical, 99.73 %", band.low, band.high);
    }
    if (findings_.variants && findings_.variants->bands[index_].variants > 0) {
      const VariantBand& seen = findings_.variants->bands[index_];
      line("variants, 99.73 %", seen.low, seen.high);
    }
    if (known && !band.complete) {
      text_ += paragraph("numbers without a derivative are not in these bands: see the variants", 2);
    }
    if (band.within) write_wanted(band);
    if (findings_.variants) write_curvature();
  }

  void write_wanted(const ToleranceBand& band) {
    if (std::isnan(result_->value)) {
      text_ += fmt::format("  wanted within +-{}: undecided, for it has no value\n", figure(*band.within));
      return;
    }
    const auto& tolerances = findings_.task->tolerances;
    std::string text = fmt::format("wanted within +-{}: {}", figure(*band.within),
                                   !band.kept        ? "EXCEEDED"
                                   : band.worst_kept ? "kept, even by the worst case"
                                                     : "kept, but not by the worst case");
    if (!band.kept) {
      const Tolerance& widest = tolerances[band.order.front()];
      const std::string unit = widest.unit == "1" ? "" : fmt::format(" {}", widest.unit);
      if (band.tighten) {
        text += fmt::format("; tighten {} from +-{} to +-{}{}", widest.name, figure(widest.half(), 4),
                            figure(widest.half() * *band.tighten, 4), unit);
      } else if (band.tighten_all) {
        text += fmt::format("; tighten {} first, but it alone is not enough", widest.name);
      }
      text += band.tighten_all
                  ? fmt::format(", or all zones to {:.1f} % of their width", 100 * *band.tighten_all)
                  : "; the middles of the zones are off by more than that: shift them";
    }
    text_ += paragraph(text, 2);
  }

  void write_curvature() {
    const VariantBand& seen = findings_.variants->bands[index_];
    if (seen.variants == 0) {
      text_ += "  no variant has this result\n";
    } else if (seen.curved) {
      text_ += paragraph(
          fmt::format(
              "it bends within the tolerances: along its slopes the same variants would lie from {} to "
              "{}; trust the variants",
              figure(seen.linear_low, 9), figure(seen.linear_high, 9)),
          2);
    }
  }

  // Lists the numbers that have no influence on any result.
  void write_idle() {
    std::vector<std::string> idle;
    for (std::size_t i = 0; i < report_.numbers.size(); ++i) {
      const bool none = std::all_of(report_.results.begin(), report_.results.end(), [&](const auto& result) {
        return result.slopes[i].kind == SlopeKind::kExact && result.slopes[i].steepest() == 0;
      });
      if (none) idle.push_back(report_.numbers[i].name);
    }
    if (!idle.empty()) {
      text_ += "\n";
      text_ += paragraph(fmt::format("without influence on any of these: {}", fmt::join(idle, ", ")), 0);
    }
  }

  void write_variants() {
    const ToleranceVariants& variants = *findings_.variants;
    text_ += fmt::format("\n{} variants, {} of them run all the way\n", variants.count, variants.good);
  }

  static constexpr double kNearRival = 0.01;

  const SensitivityFindings& findings_;
  const SensitivityReport& report_;
  const ResultSensitivity* result_ = nullptr;
  std::size_t index_ = 0;
  std::string text_;
};

}  // namespace

std::optional<double> relative_slope(const ResultSensitivity& result, std::size_t number,
                                     const SensitivityReport& report) {
  const double of = report.numbers[number].value;
  const Slope& slope = result.slopes[number];
  if (slope.kind == SlopeKind::kNone || of == 0 || !(std::abs(result.value) > 0)) {
    return std::nullopt;
  }
  return slope.steepest() * of / result.value;
}

std::string sensitivity_text(const SensitivityFindings& findings) {
  return SensitivityWriter(findings).write();
}

}  // namespace higherpair::cli
