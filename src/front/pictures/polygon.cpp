#include "higherpair/drawing/row_polygons.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/io/coordinate.hpp"
#include "polygon_units.hpp"
#include "reach.hpp"

#include <utility>

namespace higherpair {

void to_units(std::vector<Polygon>& polygons, const Units& units) {
  for (Polygon& polygon : polygons) {
    const Dimension& of = polygon.kind == Polygon::Kind::kVelocity       ? dimension::kVelocity
                          : polygon.kind == Polygon::Kind::kAcceleration ? dimension::kAcceleration
                                                                         : dimension::kForce;
    polygon = in_unit(std::move(polygon), from_si(of, units).apply(1), unit_text(of, units));
  }
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
  all.polygons = {velocity_polygon(run.mechanism(), run.row), acceleration_polygon(run.mechanism(), run.row)};
  if (wanted.forces) {
    InverseDynamics dynamics(run);
    for (Polygon& polygon : force_polygons(run.mechanism(), run.row, dynamics.solve(run))) {
      all.polygons.push_back(std::move(polygon));
    }
  }
  to_units(all.polygons, model.units());
  return all;
}

}  // namespace higherpair
