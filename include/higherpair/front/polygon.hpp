#pragma once

#include "higherpair/drawing/polygon.hpp"
#include "higherpair/front/model.hpp"

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Which polygons of which position.
struct PolygonSettings {
  double at = 0;                            ///< position of the (first) driver, in its unit
  bool forces = false;                      ///< also the force polygon of every body
  double tolerance = 1e-9;                  ///< as RunSettings::tolerance
  const std::atomic<bool>* stop = nullptr;  ///< as RunSettings::stop
};

/// The polygons of one position, in the profile's units.
struct Polygons {
  std::vector<Polygon> polygons;  ///< of velocities, of accelerations, of the forces on each body
  double driver = 0;              ///< position that they are of, in the driver's unit
  std::string driver_unit;
  /// Where `at` cannot be reached: `driver` is the limit position before it, and this is why, a sentence.
  std::optional<std::string> limit;
};

/// Converts polygons from SI units to those of tables.
void to_units(std::vector<Polygon>& polygons, const Units& units);

/// The polygons where the driver, coming from its first position, is at `at`. With several drivers they are
/// of the row in which the first one is nearest to it. Fails as Model::run does.
[[nodiscard]] Result<Polygons> polygons_of(const Model& model, const PolygonSettings& settings);

}  // namespace higherpair
