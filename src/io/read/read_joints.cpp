#include "higherpair/numeric/contains.hpp"
#include "reading.hpp"

#include <array>
#include <string_view>

namespace higherpair::io_detail {
namespace {

constexpr std::array<JointType, 5> kJointTypes = {JointType::kRevolute, JointType::kPrismatic,
                                                  JointType::kSlot, JointType::kGears, JointType::kBelt};

constexpr std::array<std::string_view, 5> kFixed = {"fixed", "weld", "welded", "rigid", "bonded"};

// Whether the table has a type that other programs give to bodies fixed to each other; then says what to do.
bool refuses_fixed(TableReader& table) {
  const auto item = table.take("type");
  const auto* text = item ? std::get_if<std::string>(&item->value->content) : nullptr;
  if (text == nullptr || !contains(kFixed, *text)) {
    return false;
  }
  report(table.reading(), *item,
         "bodies that are fixed to each other are one body: give it the points and curves of both");
  return true;
}

std::optional<JointType> read_type(TableReader& table) {
  if (refuses_fixed(table)) {
    return std::nullopt;
  }
  const auto choice = table.need_type("revolute, prismatic, slot, gears or belt",
                                      {"revolute", "prismatic", "slot", "gears", "belt"});
  return choice ? std::optional(kJointTypes[*choice]) : std::nullopt;
}

// The key `between`, if it names two points.
std::optional<Item> read_ends(TableReader& table, const Mechanism& mechanism, Joint& joint) {
  const auto item = table.need("between", "two points, [\"body.point\", \"body.point\"]");
  const auto pair = item ? as_point_pair(table.reading(), *item, mechanism) : std::nullopt;
  if (pair) {
    joint.first = pair->first;
    joint.second = pair->second;
  }
  return pair ? item : std::nullopt;
}

// A joint whose points are wrong refers to the first point of ground, whose position is asked for later: make
// sure that there is one.
void have_a_point(Body& ground) {
  if (ground.points.empty()) {
    ground.points.emplace_back();
  }
}

void read_direction(TableReader& table, Joint& joint) {
  if (joint.type == JointType::kRevolute) {
    table.refuse("direction", "a revolute joint has no direction");
    return;
  }
  constexpr const char* kDirection = "an angle or [dx, dy] in the frame of the first body";
  constexpr const char* kNotTheAngle =
      "an angle or [dx, dy] in the frame of the first body (`angle` is how far the second body is turned)";
  joint.direction_A = table.need("direction", table.has("angle") ? kNotTheAngle : kDirection, as_direction)
                          .value_or(Vector2d::UnitX());
}

void read_angle(TableReader& table, const Mechanism& mechanism, Joint& joint) {
  if (joint.type != JointType::kPrismatic) {
    table.refuse("angle", "has a meaning for prismatic joints only: in the others the body turns");
    return;
  }
  const auto theta = [&](const PointRef& point) { return mechanism.bodies[point.body].guess_theta; };
  joint.relative_angle =
      table.quantity("angle", {dimension::kAngle}, theta(joint.second) - theta(joint.first));
}

// Reads `from` and `to`: the least and the largest coordinate of a line with ends.
void read_line_ends(TableReader& table, Joint& joint) {
  if (joint.type == JointType::kRevolute) {
    for (const char* key : {"from", "to"}) {
      table.refuse(key, "has a meaning for prismatic joints and slots only: a pin has no ends");
    }
    return;
  }
  const auto from = table.take("from");
  const auto to = table.take("to");
  const auto end = [&](const std::optional<Item>& item) -> std::optional<double> {
    const auto quantity = item ? as_quantity(table.reading(), *item, {dimension::kLength}) : std::nullopt;
    return quantity ? std::optional(quantity->si) : std::nullopt;
  };
  joint.from = end(from);
  joint.to = end(to);
  if (joint.from && joint.to && !(*joint.from < *joint.to)) {
    report(table.reading(), *from, "`from` must be below `to`: they are the ends of the line");
  }
}

}  // namespace

std::vector<bool> read_joints(TableReader& root, Mechanism& mechanism) {
  std::vector<bool> type_known;
  std::vector<PendingGears> gears;
  bool ends_known = true;  // of all joints
  for_each_table(root.reading(), root.take("joints"), "a joint (a table)",
                 [&](const std::string& name, TableReader& table) {
                   Joint joint;
                   joint.name = name;
                   const auto type = read_type(table);
                   const auto between = read_ends(table, mechanism, joint);
                   ends_known = ends_known && between;
                   if (!between) {
                     have_a_point(mechanism.bodies.front());
                   }
                   if (type) {
                     joint.type = *type;
                     if (couples_turning(*type)) {
                       read_ratio(table, joint);
                       read_teeth(table, joint);
                       const auto carrier = table.take("carrier");
                       if (between) {
                         gears.push_back({mechanism.joints.size(), *between, carrier,
                                          joint.teeth ? table.take("module") : std::nullopt});
                       }
                     } else {
                       read_direction(table, joint);
                       read_angle(table, mechanism, joint);
                       read_line_ends(table, joint);
                     }
                     table.finish();
                   }
                   type_known.push_back(type.has_value());
                   mechanism.joints.push_back(joint);
                 });
  if (ends_known) {  // otherwise the pin that a carrier depends on may be wrong
    set_carriers(root.reading(), gears, mechanism);
  }
  return type_known;
}

}  // namespace higherpair::io_detail
