#include "polygon.hpp"

#include "higherpair/drawing/row_polygons.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/io/coordinate.hpp"
#include "reach.hpp"

#include <iterator>
#include <optional>
#include <utility>

namespace higherpair {

std::vector<Polygon> polygons_in(const Mechanism& mechanism, const MotionRow& row, const Reactions* reactions,
                                 const Units& units) {
  std::vector<Polygon> polygons = {velocity_polygon(mechanism, row), acceleration_polygon(mechanism, row)};
  if (reactions != nullptr) {
    auto forces = force_polygons(mechanism, row, *reactions);
    std::move(forces.begin(), forces.end(), std::back_inserter(polygons));
  }
  for (Polygon& polygon : polygons) {
    const Dimension& of = polygon.kind == Polygon::Kind::kVelocity       ? dimension::kVelocity
                          : polygon.kind == Polygon::Kind::kAcceleration ? dimension::kAcceleration
                                                                         : dimension::kForce;
    polygon = in_unit(std::move(polygon), from_si(of, units).apply(1), unit_text(of, units));
  }
  return polygons;
}

Result<Polygons> polygons_of(const Model& model, const PolygonSettings& wanted) {
  const auto reached = reach(model, driver_alone(model, wanted.tolerance, wanted.stop), wanted.at);
  if (!reached) {
    return tl::unexpected(reached.error());
  }
  Polygons all;
  if (reached->limit) {
    all.limit = reached->limit->cause;
  }
  all.passed = reached->passed;
  const Run& run = reached->run;
  all.driver = reached->driver;
  all.driver_unit = unit_text(driver_dimension(run.mechanism()), model.units());
  std::optional<InverseDynamics> dynamics;
  if (wanted.forces) dynamics.emplace(run);
  all.polygons =
      polygons_in(run.mechanism(), run.row, dynamics ? &dynamics->solve(run) : nullptr, model.units());
  return all;
}

}  // namespace higherpair
