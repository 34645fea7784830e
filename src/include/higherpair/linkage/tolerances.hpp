#pragma once

namespace higherpair {

/// Lengths whose signed sum is at most this many roundings of their total length count as balanced (a change
/// point). A decimal length is off by half a rounding, its conversion of unit by one more, the sum by one:
/// together at most 2.
inline constexpr double kBalanceRoundings = 2;

/// A reach below this many roundings of its terms counts as zero. Rounding of the angle, its sine, the
/// products and the sum together amount to 6.
inline constexpr double kReachRoundings = 8;

/// Relative velocities below this fraction of the fastest in the mechanism count as zero when an instant
/// centre is sought. A chain of a few groups leaves rounding of 1e-15 to 1e-14; a centre farther away than
/// 1e12 sizes of the mechanism is a direction.
inline constexpr double kPoleTolerance = 1e-12;

}  // namespace higherpair
