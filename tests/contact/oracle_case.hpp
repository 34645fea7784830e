#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace higherpair::testing {

/// One driver-follower case of the reference data, in the case's own length unit.
struct OracleCase {
  std::string id;
  ContactPair pair;
  nlohmann::json data;
};

/// How much the rounding of a row's inputs may change a value, as given by the reference where it is known.
[[nodiscard]] double noise(const nlohmann::json& row, std::size_t i);

[[nodiscard]] Vector2d vector_of(const nlohmann::json& xy);

/// The cases of tests/data/contact, read once.
[[nodiscard]] const std::vector<OracleCase>& oracle_cases();

}  // namespace higherpair::testing
