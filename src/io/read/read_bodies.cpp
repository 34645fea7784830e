#include "reading.hpp"

namespace higherpair::io_detail {
namespace {

void read_named_points(Reading& reading, const Item& item, Body& body) {
  for_each_named(reading, item, "[x, y]", [&](const std::string& name, const Item& entry) {
    const auto point = as_vector(reading, entry, dimension::kLength);
    body.points.push_back({name, point.value_or(Vector2d::Zero())});
  });
}

void read_pose(Reading& reading, const Item& item, Body& body) {
  if (auto pose = as_reader(reading, item, "a table { x, y, angle }")) {
    body.guess_p_WB.x() = pose->quantity("x", {dimension::kLength});
    body.guess_p_WB.y() = pose->quantity("y", {dimension::kLength});
    body.guess_theta = pose->quantity("angle", {dimension::kAngle});
    pose->finish();
  }
}

// Without an inertia the body is a point mass at its centre of mass.
void read_mass(TableReader& table, Body& body) {
  const auto mass = table.take("mass");
  if (!mass) {
    for (const char* key : {"center_of_mass", "inertia"}) {
      table.refuse(key, "needs a mass beside it (mass = 0 if the inertia alone counts)", "mass");
    }
    table.knows({"center_of_mass", "inertia"});
    return;
  }
  MassProperties properties;
  const auto value = as_quantity(table.reading(), *mass, {dimension::kMass, Sign::kNotNegative});
  properties.mass = value.value_or(Quantity{}).si;
  properties.center_of_mass_B = table.need_vector("center_of_mass", dimension::kLength);
  properties.inertia = table.quantity("inertia", {dimension::kInertia, Sign::kNotNegative});
  body.mass = properties;
}

void refuse_what_moves(TableReader& table) {
  for (const char* key : {"pose", "mass", "center_of_mass", "inertia"}) {
    table.refuse(key, "ground is the frame and never moves: it has no pose and no mass");
  }
}

void read_body(TableReader& table, Body& body, LateCurves& late) {
  if (const auto points = table.take("points")) read_named_points(table.reading(), *points, body);
  if (const auto curves = table.take("curves")) read_curves(table.reading(), *curves, body, late);
  if (body.name == "ground") {
    refuse_what_moves(table);
  } else {
    if (const auto pose = table.take("pose")) read_pose(table.reading(), *pose, body);
    read_mass(table, body);
  }
  table.finish();
}

}  // namespace

void read_bodies(TableReader& root, Mechanism& mechanism, LateCurves& late) {
  mechanism.bodies.emplace_back();
  mechanism.bodies.front().name = "ground";
  for_each_table(root.reading(), root.take("bodies"), "a body (a table)",
                 [&](const std::string& name, TableReader& table) {
                   if (name == "ground") {
                     read_body(table, mechanism.bodies.front(), late);
                     return;
                   }
                   mechanism.bodies.emplace_back();
                   mechanism.bodies.back().name = name;
                   read_body(table, mechanism.bodies.back(), late);
                 });
}

}  // namespace higherpair::io_detail
