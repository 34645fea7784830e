#include "reading.hpp"

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// The quantities of a spring along a line, or about a pivot.
struct SpringKind {
  Expected stiffness;
  Expected damping;
  Expected free;
  const char* free_key;
  const char* other_free_key;
};

constexpr SpringKind kBetweenPoints = {{dimension::kStiffness, Sign::kNotNegative},
                                       {dimension::kDamping, Sign::kNotNegative},
                                       {dimension::kLength, Sign::kNotNegative},
                                       "free_length",
                                       "free_angle"};
// A joint coordinate may be negative, and so may the free length of a spring on it.
constexpr SpringKind kOnSlide = {
    kBetweenPoints.stiffness, kBetweenPoints.damping, {dimension::kLength}, "free_length", "free_angle"};
constexpr SpringKind kOnPivot = {{dimension::kAngularStiffness, Sign::kNotNegative},
                                 {dimension::kAngularDamping, Sign::kNotNegative},
                                 {dimension::kAngle},
                                 "free_angle",
                                 "free_length"};

// Where it is not known which kind of spring it is.
void skip_numbers(TableReader& table) {
  table.knows({"stiffness", "damping", "free_length", "free_angle"});
  table.finish();
}

void read_numbers(TableReader& table, const SpringKind& kind, Spring& spring) {
  spring.stiffness = table.quantity("stiffness", kind.stiffness);
  spring.damping = table.quantity("damping", kind.damping);
  spring.free = table.quantity(kind.free_key, kind.free);
  table.refuse(kind.other_free_key, fmt::format("this spring has a {}", kind.free_key));
  if (!table.take("stiffness") && !table.take("damping")) {
    (void)table.need("stiffness", describe(kind.stiffness.dimension) + " (or a damping)");
  }
  table.finish();
}

void read_between(TableReader& table, const Item& between, const Mechanism& mechanism, Spring& spring) {
  if (const auto pair = as_point_pair(table.reading(), between, mechanism)) {
    spring.first = pair->first;
    spring.second = pair->second;
  }
  read_numbers(table, kBetweenPoints, spring);
}

void read_on_joint(TableReader& table, const Item& item, const Mechanism& mechanism,
                   const std::vector<bool>& joint_type_known, Spring& spring) {
  spring.joint = as_joint(table.reading(), item, mechanism);
  if (!spring.joint || !joint_type_known[static_cast<std::size_t>(*spring.joint)]) {
    skip_numbers(table);
    return;
  }
  const JointType type = mechanism.joints[*spring.joint].type;
  if (couples_turning(type)) {
    report(table.reading(), item,
           "gears and belts have no spring: expected the joint of one of their wheels");
  }
  read_numbers(table, has_angle(type) ? kOnPivot : kOnSlide, spring);
}

void read_spring(TableReader& table, const Mechanism& mechanism, const std::vector<bool>& joint_type_known,
                 Spring& spring) {
  const auto joint = table.take("joint");
  const auto between = table.take("between");
  if (joint && between) {
    report(table.reading(), *joint, "a spring acts on a joint or between two points, not both");
    skip_numbers(table);
  } else if (joint) {
    read_on_joint(table, *joint, mechanism, joint_type_known, spring);
  } else if (between) {
    read_between(table, *between, mechanism, spring);
  } else {
    (void)table.need("between", "two points, [\"body.point\", \"body.point\"], or `joint` instead");
    skip_numbers(table);
  }
}

}  // namespace

void read_springs(TableReader& root, Mechanism& mechanism, const std::vector<bool>& joint_type_known) {
  for_each_table(root.reading(), root.take("springs"), "a spring (a table)",
                 [&](const std::string& name, TableReader& table) {
                   Spring spring;
                   spring.name = name;
                   read_spring(table, mechanism, joint_type_known, spring);
                   mechanism.springs.push_back(spring);
                 });
}

}  // namespace higherpair::io_detail
