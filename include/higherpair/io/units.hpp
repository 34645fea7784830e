#pragma once

#include "higherpair/geometry/pose.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace higherpair {

/// The units that a profile may be written in. Inside the library everything is in SI units and radians; the
/// functions below convert.
enum class Unit {
  kMetre,
  kCentimetre,
  kMillimetre,
  kMicrometre,
  kKilometre,
  kInch,
  kFoot,
  kDegree,
  kRadian,
  kRevolution,
  kKilogram,
  kGram,
  kPound,
  kSecond,
  kMillisecond,
  kMinute,
  kNewton,
  kKilonewton,
  kPoundForce,
};

/// The five base units of a profile; units of compound quantities are products of them (a torque in
/// force·length, an inertia in mass·length²). Each member holds a unit of its own kind.
struct Units {
  Unit length = Unit::kMillimetre;
  Unit angle = Unit::kDegree;
  Unit mass = Unit::kKilogram;
  Unit time = Unit::kSecond;
  Unit force = Unit::kNewton;

  bool operator==(const Units&) const = default;
};

/// m, rad, kg, s, N.
inline constexpr Units kSiUnits = {Unit::kMetre, Unit::kRadian, Unit::kKilogram, Unit::kSecond,
                                   Unit::kNewton};

/// Exponents of the base units. Force has an exponent of its own, so that a torque is written N*mm and not
/// kg*mm^2/s^2.
struct Dimension {
  int length = 0;
  int mass = 0;
  int time = 0;
  int angle = 0;
  int force = 0;

  bool operator==(const Dimension&) const = default;
};

/// The dimension of a product, or of a quotient.
[[nodiscard]] constexpr Dimension operator*(const Dimension& a, const Dimension& b) {
  return {a.length + b.length, a.mass + b.mass, a.time + b.time, a.angle + b.angle, a.force + b.force};
}

[[nodiscard]] constexpr Dimension operator/(const Dimension& a, const Dimension& b) {
  return {a.length - b.length, a.mass - b.mass, a.time - b.time, a.angle - b.angle, a.force - b.force};
}

/// The dimensions of everything in profiles and tables.
namespace dimension {
inline constexpr Dimension kNumber = {};
inline constexpr Dimension kLength = {.length = 1};
inline constexpr Dimension kAngle = {.angle = 1};
inline constexpr Dimension kMass = {.mass = 1};
inline constexpr Dimension kTime = {.time = 1};
inline constexpr Dimension kForce = {.force = 1};
inline constexpr Dimension kVelocity = kLength / kTime;
inline constexpr Dimension kAcceleration = kVelocity / kTime;
inline constexpr Dimension kAngularVelocity = kAngle / kTime;
inline constexpr Dimension kAngularAcceleration = kAngularVelocity / kTime;
inline constexpr Dimension kTorque = kForce * kLength;
inline constexpr Dimension kInertia = kMass * kLength * kLength;
inline constexpr Dimension kStiffness = kForce / kLength;
inline constexpr Dimension kAngularStiffness = kTorque / kAngle;
inline constexpr Dimension kDamping = kForce * kTime / kLength;
inline constexpr Dimension kAngularDamping = kTorque * kTime / kAngle;
}  // namespace dimension

/// The dimension of the derivative of this order by time, or by another quantity.
[[nodiscard]] constexpr Dimension rate_of(Dimension of, int order = 1,
                                          const Dimension& by = dimension::kTime) {
  for (int k = 0; k < order; ++k) of = of / by;
  return of;
}

/// The factor between two units of one dimension, held to twice the precision of a double:
/// `apply(x)` is the double nearest to factor·x (80 mm are exactly the double 0.08, 90 deg exactly kPi/2).
/// Infinities and NaN pass through; a result too large for a double is an infinity.
class Scaling {
public:
  Scaling() = default;
  Scaling(double high, double low) : high_(high), low_(low) {}

  [[nodiscard]] double apply(double value) const;

private:
  double high_ = 1;  ///< the factor, rounded
  double low_ = 0;   ///< the exact factor less high_
};

/// From the units given to SI units and radians, and back. Either way the result is correctly rounded, so
/// that the round trip is the identity wherever the SI doubles are dense enough. Set up once per column:
/// `apply` costs a few flops.
[[nodiscard]] Scaling to_si(const Dimension& dimension, const Units& units);
[[nodiscard]] Scaling from_si(const Dimension& dimension, const Units& units);

/// Whether an angle [rad] is at most 1e9 turns: beyond that rounding blurs its position within the turn.
[[nodiscard]] inline bool is_sharp_angle(double angle) {
  constexpr double kMostTurns = 1e9;
  return std::abs(angle) <= kMostTurns * 2 * kPi;
}

/// The name of a unit in profiles: "mm", "deg", "lbf".
[[nodiscard]] std::string_view name_of(Unit unit);

/// What kind of quantity the unit measures.
[[nodiscard]] Dimension dimension_of(Unit unit);

/// The unit of that name; nothing for a name that no unit has.
[[nodiscard]] std::optional<Unit> find_unit(std::string_view name);

/// The unit of a dimension in ASCII, "deg/s^2", "N*mm", "1/mm", "N*mm*s/deg"; "1" for a pure number. Reading
/// it back as part of a quantity gives the same unit.
[[nodiscard]] std::string unit_text(const Dimension& dimension, const Units& units);

/// The unit of the derivative of a quantity by another one, from the units of both: "deg/mm", "N/(m/s)".
[[nodiscard]] std::string unit_per(const std::string& quantity, const std::string& other);

/// A value in SI units and radians as a text in the units given, "12.5 mm".
/// \param digits  significant digits, as of the format "g"
[[nodiscard]] std::string with_unit(double si, const Dimension& dimension, const Units& units,
                                    int digits = 6);

/// The dimension in words with its article, to end "expected ...": "a length", "an angular velocity".
[[nodiscard]] std::string describe(const Dimension& dimension);

/// A number with its own unit.
struct Quantity {
  double value = 0;    ///< as written
  double si = 0;       ///< in SI units and radians, correctly rounded
  double profile = 0;  ///< in the units asked for, correctly rounded; `value` itself where they are the same
};

/// Largest quantity accepted, in SI units: products of several such quantities stay within the range of a
/// double.
inline constexpr double kLargestQuantity = 1e50;

/// Reads "25.4 mm", "300 rpm", "9.81 m/s^2", "0.2 N m", "2.1e-4 kg m^2": a decimal number and a unit made of
/// factors separated by spaces or `*`, at most one `/` (all factors after it divide) and integer powers `^n`.
/// The units are those of `Unit`, rpm (rev/min) and 1. A force may be spelled in kg m/s^2; angles are never
/// left out. The error is the end of a sentence about the text ("kg is a mass, expected a length, such as
/// mm").
[[nodiscard]] tl::expected<Quantity, std::string> parse_quantity(std::string_view text,
                                                                 const Dimension& expected,
                                                                 const Units& units);

/// What to write instead of a number with a decimal comma or with separators of thousands, 30,5 or 1 000, to
/// the end of `text`, its unit or a comment. Empty for all else, and for a number that is right.
[[nodiscard]] std::string separator_advice(std::string_view text);

}  // namespace higherpair
