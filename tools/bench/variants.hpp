#pragma once

#include "higherpair/front/sweep.hpp"

#include <span>
#include <string>
#include <vector>

namespace higherpair::bench {

inline constexpr int kVariantPositions = 360;

/// A sweep over the dimensions of a shipped linkage: kVariantPositions of each variant, and of three columns
/// the largest and the smallest value.
struct VariantCase {
  std::string name;
  Sweep sweep;
};

/// Four-bar, slider-crank, slotted lever, Watt six-bar, discs and an oval cam; of the four-bar's variants the
/// first are held against variant_by_hand(). Ends the program with a message where they differ.
[[nodiscard]] std::vector<VariantCase> checked_variants();

/// What is asked of a variant of the four-bar: rocker's angle and angular velocity, height of the coupler's
/// point E.
struct ByHandResults {
  double highest[3];
  double lowest[3];
};

/// The lengths of a four-bar, and E on the coupler.
struct FourBarLengths {
  double ground, crank, coupler, rocker, along, across;
};

/// The driver in all rows; as many as kVariantPositions.
struct DriverTable {
  std::vector<double> cosine, sine;
};
[[nodiscard]] DriverTable driver_table();

/// A variant as somebody would write it for this one linkage and machine: rows in registers as wide as it
/// has, unit vectors, nothing checked. The floor of what a variant of the four-bar costs.
[[nodiscard]] ByHandResults variant_by_hand(const FourBarLengths& bar, const DriverTable& driver,
                                            double speed);

}  // namespace higherpair::bench
