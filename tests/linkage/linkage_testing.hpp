#pragma once

#include "geometry/geometry_testing.hpp"
#include "linkage/driver_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace higherpair::testing {

inline constexpr std::array<AssemblyMode, 2> kModes{AssemblyMode::kPlus, AssemblyMode::kMinus};

/// The references of accuracy tests need more digits than double has.
inline constexpr bool kLongDoubleIsLonger =
    std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits;

inline nlohmann::json read_data(const std::string& name) {
  std::ifstream file(std::string(HIGHERPAIR_TEST_DATA) + "/" + name);
  return nlohmann::json::parse(file);
}

/// One entry of the textbook's numbers, by value: a reference into a temporary would dangle.
inline nlohmann::json textbook(const std::string& entry) {
  return read_data("textbook.json").at(entry);
}

/// The reference data write numbers as decimal strings, and multiples of π by name.
inline double number(const nlohmann::json& value) {
  if (value.is_number()) return value.get<double>();
  const std::string text = value.get<std::string>();
  if (text == "pi") return kPi;
  if (text == "pi/2") return kPi / 2;
  if (text == "-pi/2") return -kPi / 2;
  return std::stod(text);
}

inline AssemblyMode mode_of(int sigma) {
  return sigma > 0 ? AssemblyMode::kPlus : AssemblyMode::kMinus;
}

/// The two modes in turn.
inline AssemblyMode alternating(int i) {
  return mode_of(i % 2 == 0 ? 1 : -1);
}

/// Distance between two angles, up to whole turns.
inline double angle_error(double angle, double expected) {
  return std::abs(std::remainder(angle - expected, 2 * kPi));
}

/// |value - expected| in units of the expected value, or of 1 where that is smaller.
inline double relative_error(double value, double expected) {
  return std::abs(value - expected) / std::max(1.0, std::abs(expected));
}

/// First and second derivative at t = 0 of sampled values, by seven-point central differences (sixth order).
/// `angle[i]` marks value i as an angle, to be made continuous first.
template <std::size_t N>
struct Derivatives {
  std::array<double, N> first;
  std::array<double, N> second;
};

template <std::size_t N, class F>
Derivatives<N> differentiate(const F& values_at, const std::array<bool, N>& angle, double h) {
  const std::array<double, N> at_0 = values_at(0.0);
  std::array<std::array<double, N>, 7> offset{};  // differences from t = 0
  for (std::size_t k = 0; k < 7; ++k) {
    const std::array<double, N> at_k = values_at((static_cast<double>(k) - 3) * h);
    for (std::size_t i = 0; i < N; ++i) {
      const double change = at_k[i] - at_0[i];
      offset[k][i] = angle[i] ? std::remainder(change, 2 * kPi) : change;
    }
  }
  Derivatives<N> result;
  for (std::size_t i = 0; i < N; ++i) {
    const auto odd = [&](std::size_t k) { return offset[3 + k][i] - offset[3 - k][i]; };
    const auto even = [&](std::size_t k) { return offset[3 + k][i] + offset[3 - k][i]; };
    result.first[i] = (45 * odd(1) - 9 * odd(2) + odd(3)) / (60 * h);
    result.second[i] = (270 * even(1) - 27 * even(2) + 2 * even(3)) / (180 * h * h);
  }
  return result;
}

/// Compares rates with differences of positions, relative to the fastest rate (and its square).
///
/// Halfway to its dead point (determinant 0.5) a linkage has derivatives that grow like those of a square
/// root about 0.1 rad from its branch point: with steps of 0.002 rad of the fastest link the truncation error
/// of the second derivative is below 1e-8, and rounding is 1e-9.
class RatesCheck {
public:
  template <std::size_t N, class F>
  void compare(const F& values_at, const std::array<bool, N>& angle, const std::array<double, N>& first,
               const std::array<double, N>& second) {
    double fastest = 1;
    for (const double rate : first) fastest = std::max(fastest, std::abs(rate));
    const Derivatives<N> expected = differentiate<N>(values_at, angle, 0.002 / fastest);
    for (std::size_t i = 0; i < N; ++i) {
      velocity_.see(std::abs(first[i] - expected.first[i]) / fastest);
      acceleration_.see(std::abs(second[i] - expected.second[i]) / (fastest * fastest));
    }
    ++count_;
  }
  [[nodiscard]] int count() const { return count_; }
  void expect_small() const {
    EXPECT_AT_MOST(velocity_.value(), 1e-9);
    EXPECT_AT_MOST(acceleration_.value(), 1e-7);
  }

private:
  Worst velocity_;
  Worst acceleration_;
  int count_ = 0;
};

inline std::complex<double> direction(double angle) {
  return std::polar(1.0, angle);
}

/// Checks both ends of every range of an angle: by `status_at(angle)` the linkage can be assembled inside and
/// not outside. The reach falls through its noise within 8 roundings of a radian and one of each angle (here
/// up to 3π and π); the limit itself has the same error again: 42 roundings in all.
template <class F>
void expect_limits_bound(const DriverRange& range, const F& status_at) {
  const double margin = 2e-14;
  for (int i = 0; i < range.count; ++i) {
    const DriverInterval& interval = range.intervals[i];
    if (!(interval.end - interval.begin > 4 * margin)) continue;
    EXPECT_EQ(status_at(interval.begin), LinkageStatus::kSingular);
    EXPECT_EQ(status_at(interval.end), LinkageStatus::kSingular);
    EXPECT_EQ(status_at(interval.begin + margin), LinkageStatus::kOk);
    EXPECT_EQ(status_at(interval.end - margin), LinkageStatus::kOk);
    EXPECT_EQ(status_at(0.5 * (interval.begin + interval.end)), LinkageStatus::kOk);
    EXPECT_EQ(status_at(interval.begin - margin), LinkageStatus::kNotAssemblable);
    EXPECT_EQ(status_at(interval.end + margin), LinkageStatus::kNotAssemblable);
  }
}

/// The distance of an end of a range from the nearest expected angle: cosines or sines give the ends only up
/// to their order.
inline double distance_to_nearest(double angle, const std::vector<double>& expected) {
  double nearest = 10;
  for (const double candidate : expected) nearest = std::min(nearest, angle_error(angle, candidate));
  return nearest;
}

}  // namespace higherpair::testing
