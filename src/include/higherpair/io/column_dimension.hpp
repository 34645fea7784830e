#pragma once

#include "higherpair/io/units.hpp"
#include "higherpair/mechanism/description.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace higherpair {

/// The endings of the columns that a body has, in their order; number k is derivative k / 3 by time of x, y
/// or the angle, which k % 3 tells. Points have those of x and y.
struct MotionEnding {
  std::string_view name;
  Dimension dimension;

  [[nodiscard]] static constexpr bool is_of_angle(std::size_t k) { return k % 3 == 2; }
};
inline constexpr std::array<MotionEnding, 9> kMotionEndings = {{{"x", dimension::kLength},
                                                                {"y", dimension::kLength},
                                                                {"angle", dimension::kAngle},
                                                                {"vx", dimension::kVelocity},
                                                                {"vy", dimension::kVelocity},
                                                                {"omega", dimension::kAngularVelocity},
                                                                {"ax", dimension::kAcceleration},
                                                                {"ay", dimension::kAcceleration},
                                                                {"alpha", dimension::kAngularAcceleration}}};

/// The dimension of a column of a table, by its name; of a glob if all that it can stand for has the same.
/// None if no such column has numbers with one. Whether the run has the column is not looked at. The jerk of
/// a contact is that of the joint on which it moves a body, which the plan of the mechanism knows.
/// \pre all that the mechanism names is there
[[nodiscard]] std::optional<Dimension> column_dimension(const Mechanism& mechanism, std::string_view column);

/// The dimension of a figure of check(), by its item and the name of its quantity: "contacts.touch",
/// "contact_pressure". None if there is no such quantity.
[[nodiscard]] std::optional<Dimension> figure_dimension(const Mechanism& mechanism, std::string_view item,
                                                        std::string_view quantity);

}  // namespace higherpair
