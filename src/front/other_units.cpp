#include "other_units.hpp"

#include "higherpair/io/measured_table.hpp"

#include <cctype>

namespace higherpair {

std::vector<OtherUnit> other_units(const std::string& unit, const Units& units) {
  std::vector<OtherUnit> others;
  const auto add = [&](const std::string& from, Unit other) {
    const std::string to(name_of(other));
    const std::size_t at = unit.find(from);
    const bool whole = at != std::string::npos &&
                       (at == 0 || !std::isalpha(static_cast<unsigned char>(unit[at - 1]))) &&
                       (at + from.size() == unit.size() ||
                        !std::isalpha(static_cast<unsigned char>(unit[at + from.size()])));
    if (!whole || from == to) return;
    const std::string text = std::string(unit).replace(at, from.size(), to);
    if (const auto factor = factor_between(text, unit, units)) others.push_back({text, *factor});
  };
  for (const Unit angle : {Unit::kRadian, Unit::kDegree, Unit::kRevolution})
    add(std::string(name_of(units.angle)), angle);
  for (const Unit length : {Unit::kMetre, Unit::kMillimetre, Unit::kInch, Unit::kCentimetre,
                            Unit::kMicrometre, Unit::kKilometre, Unit::kFoot}) {
    add(std::string(name_of(units.length)), length);
  }
  for (const Unit time : {Unit::kSecond, Unit::kMillisecond, Unit::kMinute})
    add(std::string(name_of(units.time)), time);
  return others;
}

}  // namespace higherpair
