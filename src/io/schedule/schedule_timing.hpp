#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/profile.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

#include <tl/expected.hpp>

namespace higherpair::io_detail {

/// A mistake "driver.KEY rule", located at the driver's table.
[[nodiscard]] Diagnostic mistake(const Profile& profile, std::size_t driver, std::string_view key,
                                 std::string_view rule);

/// The rows of a schedule in time.
struct Timing {
  std::int64_t rows = 1;
  double duration = 0;
  double time_step = 0;  // 0: the rows divide the duration evenly
};

/// The timing of `step`: until the duration, or the end of the drivers' laws, by time steps or by a number of
/// samples.
[[nodiscard]] tl::expected<Timing, Diagnostics> timing_of(const Profile& profile,
                                                          std::optional<std::int64_t> samples);

/// The whole of the drivers' laws, in equally spaced rows.
[[nodiscard]] tl::expected<Timing, Diagnostics> timing_of_laws(const Profile& profile,
                                                               std::optional<std::int64_t> samples);

/// The shortest decimal number that reads as x > 0, minus x: the rounding error of x.
[[nodiscard]] double rest_of_decimal(double x);

}  // namespace higherpair::io_detail
