#pragma once

#include "higherpair/front/sweep.hpp"

#include <span>
#include <string>
#include <vector>

namespace higherpair::bench {

inline constexpr int kVariantPositions = 360;

/// A sweep over the dimensions of a shipped linkage, with kVariantPositions rows for each variant; the
/// results are the largest and smallest values of three columns.
struct VariantCase {
  std::string name;
  Sweep sweep;
};

/// Four-bar, slider-crank, slotted lever, Watt six-bar, discs and an oval cam. The first variants of the
/// four-bar are checked against variant_by_hand(); ends the program with a message if they differ.
[[nodiscard]] std::vector<VariantCase> checked_variants();

/// Results of a variant of the four-bar: angle and angular velocity of the rocker, height of the coupler's
/// point E.
struct ByHandResults {
  double highest[3];
  double lowest[3];
};

/// The lengths of a four-bar, and E on the coupler.
struct FourBarLengths {
  double ground, crank, coupler, rocker, along, across;
};

/// Cosine and sine of the driver's angle in all kVariantPositions rows.
struct DriverTable {
  std::vector<double> cosine, sine;
};
[[nodiscard]] DriverTable driver_table();

/// A variant as it would be written for this one linkage and machine: rows in the widest registers available,
/// unit vectors, no checks. It is the standard of comparison for a variant of the four-bar.
[[nodiscard]] ByHandResults variant_by_hand(const FourBarLengths& bar, const DriverTable& driver,
                                            double speed);

}  // namespace higherpair::bench
