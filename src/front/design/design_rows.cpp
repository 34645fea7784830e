#include "design_rows.hpp"

namespace higherpair {

const std::vector<BodyMotion>& DesignRows::bodies_at(double driver) {
  if (direct) {
    (void)direct->move_to({{driver, 1, 0}}, true);
    return direct->bodies();
  }
  move_to(*run, {{driver, 1, 0}});
  return run->row.bodies;
}

void DesignRows::restart() {
  started = false;
  missing = 0;
  gaps.clear();
  measured.clear();
  extents.clear();
  transmissions.clear();
  for (std::vector<Vector2d>& path : points) path.clear();
  positions.clear();
  gap_rows.clear();
  transmission_rows.clear();
  table.clear();
  table_columns = 0;
  table_slots.clear();
  places.clear();
  direct.reset();
  mechanism.reset();
  run.reset();
}

}  // namespace higherpair
