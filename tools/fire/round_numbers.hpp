#pragma once

#include <cstddef>
#include <string>

#include <fmt/core.h>

namespace higherpair::fire {

/// Finds for each of the numbers(one) the roundest value with which `one` still fails: 0, then one digit more
/// at a time, up to `most_digits`.
/// \param keep  puts a rounder variant in place of `one` if that still fails, and returns whether it does
template <class One, class Keep>
void round_numbers(const One& one, int most_digits, const Keep& keep) {
  One rounder = one;
  for (std::size_t i = 0; i < numbers(rounder).size(); ++i) {
    for (int digits = 0; digits <= most_digits; ++digits) {
      rounder = one;
      double& number = *numbers(rounder)[i];
      number = digits == 0 ? 0 : std::stod(fmt::format("{:.{}g}", number, digits));
      if (keep(rounder)) break;
    }
    rounder = one;
  }
}

}  // namespace higherpair::fire
