#include "io/read/laws.hpp"
#include "io/tolerances.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// A table is assumed to be rounded if its values have at most this many decimals and it has enough points to
// judge.
constexpr int kMostDecimals = 7;
constexpr std::size_t kFewestPoints = 12;

// The unit of the last decimal that suffices for all values; none if they need more than kMostDecimals.
std::optional<double> guessed_rounding(const std::vector<Vector2d>& points) {
  for (int decimals = 0; decimals <= kMostDecimals; ++decimals) {
    const double power = std::pow(10.0, decimals);
    const bool enough = std::all_of(points.begin(), points.end(), [&](const Vector2d& point) {
      const double scaled = point.y() * power;
      return std::abs(scaled - std::round(scaled)) <= kWholeNumber * std::max(1.0, std::abs(scaled));
    });
    if (enough) {
      return 1 / power;
    }
  }
  return std::nullopt;
}

// Largest difference of the accelerations of two laws, compared at the points and halfway between them.
double largest_difference(const MotionLaw& a, const MotionLaw& b, const std::vector<Vector2d>& points) {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    for (const double share : {0.0, 0.5}) {
      const double x = std::lerp(points[i].x(), points[i + 1].x(), share);
      largest = std::max(largest, std::abs(a.derivative(2, x) - b.derivative(2, x)));
    }
  }
  return largest;
}

// A number of the law as made, converted to the profile's units.
double in_shown_unit(const Reading& reading, const LawQuantities& quantities, const Dimension& dimension,
                     double number) {
  return quantities.units == LawUnits::kSi ? from_si(dimension, reading.units).apply(number) : number;
}

void note_rounding(TableReader& table, const LawQuantities& quantities, const ReadLaw& law) {
  Reading& reading = table.reading();
  const auto quantity = table.take("rounding", as_quantity, {quantities.value});
  const std::vector<Vector2d>& given = law.profile.points;
  const auto rounding = quantity ? std::optional(quantity->profile) : guessed_rounding(given);
  if (law.profile.smoothing > 0 || !rounding || (!quantity && given.size() < kFewestPoints)) {
    return;
  }
  LawDescription smooth = law.in(quantities.units);
  const bool si = quantities.units == LawUnits::kSi;
  smooth.smoothing = (si ? to_si(quantities.value, reading.units).apply(*rounding) : *rounding) / 2;
  const auto beside = MotionLaw::make(smooth);
  if (!beside) {
    return;
  }
  const double noise = largest_difference(*law.made, *beside, smooth.points);
  const double peak = std::abs(beside->extremes(2).peak());
  if (!(noise > kNoiseWorthSaying * peak)) {
    return;
  }
  const Dimension acceleration = quantities.value / quantities.coordinate / quantities.coordinate;
  note_whole(table, fmt::format("its values are {} {:g} {}; the spline through them has about {:.2g} {} "
                                "of noise from that in its "
                                "second derivative, whose peak is {:.3g}; smoothing = {:g} takes it out",
                                quantity ? "rounded to" : "given to, and probably rounded to,", *rounding,
                                unit_text(quantities.value, reading.units),
                                in_shown_unit(reading, quantities, acceleration, noise),
                                unit_text(acceleration, reading.units),
                                in_shown_unit(reading, quantities, acceleration, peak), *rounding / 2));
}

}  // namespace

void note_law(TableReader& table, const LawQuantities& quantities, const ReadLaw& law) {
  Reading& reading = table.reading();
  if (!law.profile.points.empty()) {
    note_rounding(table, quantities, law);
  }
  if (law.profile.repeats && quantities.coordinate == dimension::kAngle && law.made->advance() != 0) {
    note_whole(table, fmt::format("it does not end where it begins: every turn is {:g} {} higher "
                                  "than the one before",
                                  in_shown_unit(reading, quantities, quantities.value, law.made->advance()),
                                  unit_text(quantities.value, reading.units)));
  }
}

}  // namespace higherpair::io_detail
