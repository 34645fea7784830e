#pragma once

namespace higherpair {

/// Lengths whose signed sum is within this many roundings of their total length count as balanced (a change
/// point). A decimal length is off by half a rounding, its conversion of unit by one more, the sum by one:
/// together at most 2.
inline constexpr double kBalanceRoundings = 2;

/// A reach below this many roundings of the terms it is made of says nothing but that it is zero. The angle's
/// own rounding, its sine, the products and the sum together cost 6.
inline constexpr double kReachRoundings = 8;

/// Relative velocities below this part of the fastest in the mechanism count as none when an instant centre
/// is asked for. A chain of a few groups leaves 1e-15 to 1e-14 of it; a centre further away than 1e12 sizes
/// of the mechanism is a direction.
inline constexpr double kPoleTolerance = 1e-12;

}  // namespace higherpair
