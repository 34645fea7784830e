#include "higherpair/io/jerk_table.hpp"

#include <cmath>

namespace higherpair {
namespace {

constexpr Dimension kJerk = dimension::kAcceleration / dimension::kTime;
constexpr Dimension kAngularJerk = dimension::kAngularAcceleration / dimension::kTime;

}  // namespace

JerkTable::JerkTable(const Profile& profile, const Plan& plan)
    : joints_(profile.mechanism.contacts.size()),
      linear_(from_si(kJerk, profile.units)),
      angular_(from_si(kAngularJerk, profile.units)) {
  for (const Group& group : plan.groups) {
    const bool follows =
        std::holds_alternative<TrackedPair>(group.kind) || std::holds_alternative<TouchingBody>(group.kind);
    if (follows) {
      joints_[static_cast<std::size_t>(group.contacts.front())] = group.joints.front();
    }
  }
  add_names(profile);
}

void JerkTable::add_names(const Profile& profile) {
  const Mechanism& mechanism = profile.mechanism;
  const std::string linear = unit_text(kJerk, profile.units);
  const std::string angular = unit_text(kAngularJerk, profile.units);
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    columns_.push_back({body.name + ".jx", linear});
    columns_.push_back({body.name + ".jy", linear});
    columns_.push_back({body.name + ".jerk", angular});
    for (const NamedPoint& point : body.points) {
      columns_.push_back({body.name + "." + point.name + ".jx", linear});
      columns_.push_back({body.name + "." + point.name + ".jy", linear});
    }
  }
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    const bool slides =
        joints_[i] && mechanism.joints[static_cast<std::size_t>(*joints_[i])].type != JointType::kRevolute;
    for (const char* name : {".jerk", ".jerk_linkage"}) {
      columns_.push_back({mechanism.contacts[i].name + name, slides ? linear : angular});
    }
  }
}

void JerkTable::number(const Scaling& scale, const std::optional<double>& value) {
  if (value && std::isfinite(scale.apply(*value))) {
    cells_.emplace_back(scale.apply(*value));
  } else {
    cells_.emplace_back();
  }
}

void JerkTable::vector(const std::optional<Vector2d>& v) {
  number(linear_, v ? std::optional(v->x()) : std::nullopt);
  number(linear_, v ? std::optional(v->y()) : std::nullopt);
}

void JerkTable::add_body(const Run& run, const JerkRow& jerks, std::size_t index) {
  const std::optional<BodyJerk>& jerk = jerks.bodies[index];
  vector(jerk ? std::optional(jerk->j_WB) : std::nullopt);
  number(angular_, jerk ? std::optional(jerk->angular) : std::nullopt);
  for (const NamedPoint& point : run.mechanism.bodies[index].points) {
    vector(jerk ? std::optional(point_jerk(run.row.bodies[index], *jerk, point.p_B)) : std::nullopt);
  }
}

const std::vector<Cell>& JerkTable::behind(const std::vector<Cell>& cells, const Run& run) {
  const JerkRow jerks = jerks_of(run);
  cells_ = cells;
  for (std::size_t i = 1; i < jerks.bodies.size(); ++i) {
    add_body(run, jerks, i);
  }
  for (const std::optional<int>& joint : joints_) {
    const bool slides =
        joint && run.mechanism.joints[static_cast<std::size_t>(*joint)].type != JointType::kRevolute;
    for (const auto* bodies : {&jerks.bodies, &jerks.linkage}) {
      number(slides ? linear_ : angular_, joint ? joint_jerk(run, *joint, *bodies) : std::nullopt);
    }
  }
  return cells_;
}

}  // namespace higherpair
