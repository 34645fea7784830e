// Checks the units and the motions of the drivers of a mechanism that was built in C++.
#include "analysis_impl.hpp"
#include "demands.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "model_data.hpp"

#include <algorithm>

#include <fmt/core.h>

namespace higherpair {
namespace {

// \param driver  the path of its table
std::string fault_of(const DriverProgram& program, const std::string& driver, const Dimension& position,
                     const Units& units) {
  const auto place = [&](const std::string& key, double value) {
    return Demand{can_be_position(value, position, units), driver + key, value,
                  fmt::format("is not finite, or beyond {}", farthest_position(position))};
  };
  const auto rate = [&](const std::string& key, const Dimension& dimension, double value) {
    return Demand{fits(to_si(dimension, units).apply(value)), driver + key, value, kFitRule};
  };
  const auto bad = std::find_if_not(program.positions.begin(), program.positions.end(),
                                    [&](double value) { return can_be_position(value, position, units); });
  return first_unmet({
      place(".start", program.start),
      place(".end", program.end.value_or(0)),
      place(".positions", bad == program.positions.end() ? 0 : *bad),
      rate(".velocity", rate_of(position), program.velocity),
      rate(".acceleration", rate_of(position, 2), program.acceleration),
      within(1, DriverSchedule::kMostRows, driver + ".samples", program.samples.value_or(1)),
      at_least(0.0, driver + ".duration", program.duration.value_or(0)),
      positive(driver + ".time_step", program.time_step.value_or(1)),
  });
}

}  // namespace

std::string fault_of(const std::vector<DriverProgram>& programs, const Mechanism& mechanism,
                     const Units& units) {
  if (programs.size() != mechanism.drivers.size()) {
    return fmt::format("{} programs for {} drivers: each driver needs its own", programs.size(),
                       mechanism.drivers.size());
  }
  std::string found;
  for (std::size_t i = 0; i < programs.size() && found.empty(); ++i) {
    found = fault_of(programs[i], driver_path(mechanism.drivers[i]), driver_dimension(mechanism, i), units);
  }
  return found;
}

std::string fault_of(const Units& units) {
  struct Member {
    const char* name;
    Unit unit;
    Dimension dimension;
  };
  for (const auto& [name, unit, dimension] : {Member{"length", units.length, dimension::kLength},
                                              {"angle", units.angle, dimension::kAngle},
                                              {"mass", units.mass, dimension::kMass},
                                              {"time", units.time, dimension::kTime},
                                              {"force", units.force, dimension::kForce}}) {
    if (unit < Unit::kMetre || unit > Unit::kPoundForce) {
      return fmt::format("Units::{} = {}: is no unit", name, static_cast<int>(unit));
    }
    if (dimension_of(unit) != dimension) {
      return fmt::format("Units::{} = {}: is the unit of {}, expected that of {}", name, name_of(unit),
                         describe(dimension_of(unit)), describe(dimension));
    }
  }
  return "";
}

}  // namespace higherpair
