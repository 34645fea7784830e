#include "higherpair/geometry/pose.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "reading.hpp"

#include <algorithm>
#include <initializer_list>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// Poses and points converted back to the profile's units, so that a drawing in millimetres gives round
// numbers.
class PoseCoordinate {
public:
  PoseCoordinate(const Mechanism& mechanism, const Units& units)
      : mechanism_(mechanism),
        length_(from_si(dimension::kLength, units)),
        angle_(from_si(dimension::kAngle, units)) {}

  // The coordinate of a joint in the poses.
  [[nodiscard]] double of(const Joint& joint) const {
    const Body& first = body(joint.first);
    if (joint.type == JointType::kRevolute) {
      return angle_.apply(body(joint.second).guess_theta) - angle_.apply(first.guess_theta);
    }
    const Vector2d p_12_W = place(joint.second) - place(joint.first);
    return joint.direction_A.dot(Rotation<double>::from_angle(-first.guess_theta) * p_12_W);
  }

private:
  [[nodiscard]] const Body& body(const PointRef& ref) const { return mechanism_.bodies[ref.body]; }

  [[nodiscard]] Vector2d in_profile_units(const Vector2d& v) const {
    return {length_.apply(v.x()), length_.apply(v.y())};
  }

  [[nodiscard]] Vector2d place(const PointRef& ref) const {
    const Body& owner = body(ref);
    const Pose<double> X_WB = {Rotation<double>::from_angle(owner.guess_theta),
                               in_profile_units(owner.guess_p_WB)};
    return X_WB * in_profile_units(owner.points[ref.point].p_B);
  }

  const Mechanism& mechanism_;
  Scaling length_;
  Scaling angle_;
};

std::optional<double> read_number(TableReader& table, const std::string& key, const Expected& expected) {
  const auto quantity = table.take(key, as_quantity, expected);
  return quantity ? std::optional(quantity->profile) : std::nullopt;
}

void read_samples(TableReader& table, DriverProgram& program) {
  const auto item = table.take("samples");
  const auto samples = item ? as_integer(table.reading(), *item) : std::nullopt;
  if (samples && (*samples < 1 || *samples > DriverSchedule::kMostRows)) {
    report(table.reading(), *item, "must be an integer from 1 to 2^53");
    return;
  }
  program.samples = samples;
}

void read_positions(TableReader& table, const Dimension& dimension, DriverProgram& program) {
  const auto item = table.take("positions");
  const auto list = item ? as_list(table.reading(), *item, {dimension}) : std::nullopt;
  if (!list) {
    return;
  }
  if (list->empty()) {
    report(table.reading(), *item, "must have at least one position");
  }
  for (const Quantity& position : *list) {
    program.positions.push_back(position.profile);
  }
}

// 1 rad/s, or 1 length unit per second, in the profile's units.
double default_velocity(const Joint& joint, const Units& units) {
  constexpr Dimension kPerTime = dimension::kNumber / dimension::kTime;
  return from_si(has_angle(joint.type) ? dimension::kAngularVelocity : kPerTime, units).apply(1);
}

void read_times(TableReader& table, DriverProgram& program) {
  program.duration = read_number(table, "duration", {dimension::kTime, Sign::kNotNegative});
  program.time_step = read_number(table, "time_step", {dimension::kTime, Sign::kPositive});
}

// Reads the keys whose values are angles for a revolute joint and lengths for a prismatic one.
void read_motion(TableReader& table, const Mechanism& mechanism, const Joint& joint, DriverProgram& program) {
  const Units& units = table.reading().units;
  const Dimension position = coordinate_dimension(joint);
  program.start =
      read_number(table, "start", {position}).value_or(PoseCoordinate(mechanism, units).of(joint));
  program.end = read_number(table, "end", {position});
  read_positions(table, position, program);
  program.velocity =
      read_number(table, "velocity", {rate_of(position)}).value_or(default_velocity(joint, units));
  program.acceleration = read_number(table, "acceleration", {rate_of(position, 2)}).value_or(0);
}

constexpr std::initializer_list<const char*> kMotionKeys = {"start", "end", "positions", "velocity",
                                                            "acceleration"};

// The coordinate as a function of time.
void read_driving_law(TableReader& table, const Item& name, const Joint& joint, Mechanism& mechanism,
                      LawBook& laws, DriverProgram& program) {
  for (const char* key : kMotionKeys) {
    table.refuse(key, "the law says where the driver is at which time: leave it out");
  }
  const auto law = laws.find(name, {dimension::kTime, coordinate_dimension(joint)}, mechanism);
  if (law) {
    program.law = laws.made(*law);
    program.law_name = "laws." + mechanism.laws[*law].name;
    program.start = (*program.law)(0.0);
    program.velocity = default_velocity(joint, table.reading().units);
  }
}

std::optional<int> read_joint(TableReader& table, const Mechanism& mechanism,
                              const std::vector<bool>& joint_type_known) {
  const auto item = table.need("joint", "the name of a joint");
  const auto joint = item ? as_joint(table.reading(), *item, mechanism) : std::nullopt;
  if (!joint) {
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(*joint);
  if (!can_be_driven(mechanism.joints[index].type)) {
    const bool slot = mechanism.joints[index].type == JointType::kSlot;
    report(table.reading(), *item,
           fmt::format("{} two freedoms: expected a revolute or prismatic joint",
                       slot ? "a slot leaves" : "gears and belts leave"));
    return std::nullopt;
  }
  if (is_driven(mechanism, *joint)) {
    report(table.reading(), *item, "another driver drives this joint already");
  }
  return joint_type_known[index] ? joint : std::nullopt;
}

std::vector<std::pair<std::string, Place>> places_of_keys(const TableReader& table) {
  std::vector<std::pair<std::string, Place>> places;
  for (const Entry& entry : table.entries()) {
    places.emplace_back(entry.key, place_of(table.reading(), entry.value.mark));
  }
  return places;
}

void read_driver(TableReader& table, const std::string& name, Profile& profile,
                 const std::vector<bool>& joint_type_known, LawBook& laws) {
  DriverProgram program;
  program.place = place_of(table.reading(), table.mark());
  program.key_places = places_of_keys(table);
  Mechanism& mechanism = profile.mechanism;
  const auto joint = read_joint(table, mechanism, joint_type_known);
  const auto law = table.take("law");
  if (joint && law) {
    read_driving_law(table, *law, mechanism.joints[*joint], mechanism, laws, program);
  } else if (joint) {
    read_motion(table, mechanism, mechanism.joints[*joint], program);
  } else {
    table.knows(kMotionKeys);  // without the joint their units are not known
  }
  read_samples(table, program);
  read_times(table, program);
  table.finish();
  mechanism.drivers.push_back({name, joint.value_or(-1)});
  profile.programs.push_back(std::move(program));
}

}  // namespace

void read_drivers(TableReader& root, Profile& profile, const std::vector<bool>& joint_type_known,
                  LawBook& laws) {
  Reading& reading = root.reading();
  const auto one = root.take("driver");
  const auto several = root.take("drivers");
  if (one && several) {
    report(reading, *several, "expected either one [driver] or several [drivers.NAME], not both");
  }
  if (!one && !several) {
    reading.mistakes.push_back(
        {root.mark(),
         "driver is missing: add a table [driver] with joint = \"...\", the joint that is driven",
         "",
         {"driver", "drivers"}});
  }
  const auto* tables = several ? std::get_if<Table>(&several->value->content) : nullptr;
  if (tables != nullptr && find(*tables, "joint") != nullptr) {
    report(reading, *several, "a single driver has the heading [driver], several have [drivers.NAME] each");
    return;
  }
  if (auto table = as_reader(reading, one, "a table")) {
    read_driver(*table, "", profile, joint_type_known, laws);
  }
  for_each_table(reading, several, "a driver (a table)", [&](const std::string& name, TableReader& table) {
    read_driver(table, name, profile, joint_type_known, laws);
  });
}

}  // namespace higherpair::io_detail

namespace higherpair {

const Place& DriverProgram::place_of(std::string_view key) const {
  const auto given =
      std::find_if(key_places.begin(), key_places.end(), [&](const auto& one) { return one.first == key; });
  return given == key_places.end() ? place : given->second;
}

DriverProgram default_program(const Mechanism& mechanism, const Driver& driver, const Units& units) {
  const Joint& joint = mechanism.joints[driver.joint];
  DriverProgram program;
  program.start = io_detail::PoseCoordinate(mechanism, units).of(joint);
  program.velocity = io_detail::default_velocity(joint, units);
  return program;
}

}  // namespace higherpair
