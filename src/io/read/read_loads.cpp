#include "reading.hpp"

namespace higherpair::io_detail {
namespace {

std::optional<int> read_body(TableReader& table, const Mechanism& mechanism) {
  const auto item = table.need("body", "the name of a body");
  const auto body = item ? as_body(table.reading(), *item, mechanism) : std::nullopt;
  if (body == 0) {
    report(table.reading(), *item, "ground never moves: a load on it does nothing");
  }
  return body;
}

void read_force(TableReader& table, const Mechanism& mechanism, std::optional<int> body, Load& load) {
  load.force = table.need_vector("force", dimension::kForce);
  const auto point = table.need("point", "the point of the body at which the force acts");
  if (point && body) {
    const Body& owner = mechanism.bodies[*body];
    const auto index = as_point_of(table.reading(), *point, owner);
    load.p_B = index ? owner.points[*index].p_B : Vector2d::Zero();
  }
  load.frame =
      table.take("frame", as_choice, {"ground", "body"}) == 1U ? LoadFrame::kBody : LoadFrame::kGround;
}

void read_load(TableReader& table, const Mechanism& mechanism, Load& load) {
  const auto body = read_body(table, mechanism);
  load.body = body.value_or(0);
  const auto torque = table.take("torque");
  if (torque) {
    load.torque = as_quantity(table.reading(), *torque, {dimension::kTorque}).value_or(Quantity{}).si;
  }
  const bool has_force = table.take("force").has_value();
  if (!has_force && !torque) {
    table.instead({"torque"});
    (void)table.need("force", "[x, y] (or a torque)");
    table.knows({"point", "frame"});
  } else if (has_force) {
    read_force(table, mechanism, body, load);
  } else {
    table.refuse("point", "belongs to a force: a torque has no point");
    table.refuse("frame", "belongs to a force: a torque is the same in every frame");
  }
  table.finish();
}

}  // namespace

void read_loads(TableReader& root, Mechanism& mechanism) {
  for_each_table(root.reading(), root.take("loads"), "a load (a table)",
                 [&](const std::string& name, TableReader& table) {
                   Load load;
                   load.name = name;
                   read_load(table, mechanism, load);
                   mechanism.loads.push_back(load);
                 });
}

}  // namespace higherpair::io_detail
