#pragma once

#include "higherpair/io/tasks.hpp"
#include "io/document/typed_values.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair::io_detail {

/// The unit of a number in a task: that of the numbers of the profile, or of the column, that it is a value
/// or a limit of.
struct NumberUnit {
  std::optional<Dimension> dimension;  ///< none: only a plain number is possible
  /// To a number with a unit of its own, if there is no dimension; empty if another mistake is the reason.
  std::string objection;
};

[[nodiscard]] NumberUnit unit_of_paths(const Reading& reading, const std::vector<std::string>& paths);
[[nodiscard]] NumberUnit unit_of_column(const Reading& reading, const Mechanism& mechanism,
                                        const std::string& column);
/// Of a figure of check().
[[nodiscard]] NumberUnit unit_of_figure(const Mechanism& mechanism, const std::string& item,
                                        const std::string& quantity);
/// Of the (first) driver's position.
[[nodiscard]] NumberUnit unit_of_driver(const Mechanism& mechanism);
/// Of where a row is: the time, or the driver's position.
[[nodiscard]] NumberUnit unit_of_place(const Mechanism& mechanism, bool in_time);
/// Of a covariance of two numbers.
[[nodiscard]] NumberUnit product_of(const NumberUnit& a, const NumberUnit& b);
/// A number without any unit, such as a weight.
[[nodiscard]] NumberUnit no_unit();

/// The number that a value of the profile is, in the profile's unit, if it is a plain one or has a unit of
/// the dimension as which it was read.
[[nodiscard]] std::optional<double> number_read(const Reading& reading, const Value& value);

/// A number in the profile's unit: a plain one, or one with its own unit, which is converted.
[[nodiscard]] std::optional<double> as_number_in(Reading& reading, const Item& item, const NumberUnit& unit);
/// The same for a number that must be > 0.
[[nodiscard]] std::optional<double> as_positive_in(Reading& reading, const Item& item,
                                                   const NumberUnit& unit);
/// A list of them; any number of them where `count` is 0.
[[nodiscard]] std::optional<std::vector<double>> as_numbers_in(Reading& reading, const Item& item,
                                                               const NumberUnit& unit, std::size_t count);

}  // namespace higherpair::io_detail
