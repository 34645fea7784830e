#include "higherpair/io/force_table.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>

namespace higherpair {
namespace {

constexpr std::size_t kLastColumns = 2;  // status and residual

const Joint& joint_of(const Mechanism& mechanism, int index) {
  return mechanism.joints[static_cast<std::size_t>(index)];
}

// The number up to six digits, rounded away from 0: what is needed at least.
double rounded_up(double value) {
  if (value == 0) {
    return 0;
  }
  const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
  return std::copysign(std::ceil(std::abs(value) / digit * (1 - 1e-12)) * digit, value);
}

// " (free_length 31.5 mm instead of 40 mm)", where the spring is one whose free length can be so.
std::string other_free(const Spring& spring, const char* key, const Dimension& dimension, double preload,
                       const Profile& profile) {
  const double free = spring.free - preload / spring.stiffness;
  if (spring.stiffness == 0 || (!spring.joint && free < 0)) {
    return "";
  }
  const Scaling scale = from_si(dimension, profile.units);
  const std::string unit = unit_text(dimension, profile.units);
  return fmt::format(" ({} {:.7g} {} instead of {:.7g} {})", key, scale.apply(free), unit,
                     scale.apply(spring.free), unit);
}

std::string more_of_spring(const Spring& spring, double preload, const Profile& profile) {
  const Joint* joint = spring.joint ? &joint_of(profile.mechanism, *spring.joint) : nullptr;
  const bool turns = joint != nullptr && joint->type == JointType::kRevolute;
  const Dimension dimension = turns ? dimension::kTorque : dimension::kForce;
  const double amount = rounded_up(from_si(dimension, profile.units).apply(preload));
  const std::string size = fmt::format("{:.6g} {}", std::abs(amount), unit_text(dimension, profile.units));
  const double rounded = to_si(dimension, profile.units).apply(amount);
  if (joint == nullptr) {
    return fmt::format("springs.{} {} by {} more{}", spring.name, preload > 0 ? "pulls" : "pushes", size,
                       other_free(spring, "free_length", dimension::kLength, rounded, profile));
  }
  return fmt::format("springs.{} {} by {} more towards {} coordinates{}", spring.name,
                     turns ? "turns" : "pushes", size, preload > 0 ? "smaller" : "larger",
                     turns ? other_free(spring, "free_angle", dimension::kAngle, rounded, profile)
                           : other_free(spring, "free_length", dimension::kLength, rounded, profile));
}

std::string effort_on_joint(const Joint& joint, double effort, const Profile& profile) {
  const bool turns = joint.type == JointType::kRevolute;
  const Dimension dimension = turns ? dimension::kTorque : dimension::kForce;
  return fmt::format("a constant {} of {:.6g} {} acts on joints.{}", turns ? "torque" : "force",
                     rounded_up(from_si(dimension, profile.units).apply(effort)),
                     unit_text(dimension, profile.units), joint.name);
}

std::string advice(const PreloadNeed& need, const Profile& profile) {
  const bool on_spring = need.preload.on == Preload::On::kSpring;
  const auto index = static_cast<std::size_t>(need.preload.index);
  const Mechanism& mechanism = profile.mechanism;
  const std::optional<double> preload = need.smallest();
  if (!preload) {
    return on_spring ? fmt::format("; no constant preload of springs.{} keeps it closed everywhere",
                                   mechanism.springs[index].name)
                     : fmt::format("; no constant effort on joints.{} keeps it closed everywhere",
                                   mechanism.joints[index].name);
  }
  return "; it stays closed in all rows if " +
         (on_spring ? more_of_spring(mechanism.springs[index], *preload, profile)
                    : effort_on_joint(mechanism.joints[index], *preload, profile));
}

}  // namespace

tl::expected<ForceTable, std::string> ForceTable::make(const Profile& profile,
                                                       const std::vector<Column>& motion) {
  ForceTable table;
  table.force_ = from_si(dimension::kForce, profile.units);
  table.torque_ = from_si(dimension::kTorque, profile.units);
  table.columns_.assign(motion.begin(), motion.end() - kLastColumns);
  table.add_names(profile);
  table.columns_.insert(table.columns_.end(), motion.end() - kLastColumns, motion.end());
  std::set<std::string> seen;
  for (const Column& column : table.columns_) {
    if (!seen.insert(column.name).second) {
      return tl::unexpected("two columns would be called '" + column.name +
                            "': rename one of the bodies, points, joints, contacts or drivers that share "
                            "this name");
    }
  }
  return table;
}

void ForceTable::add_names(const Profile& profile) {
  const Mechanism& mechanism = profile.mechanism;
  const std::string force = unit_text(dimension::kForce, profile.units);
  const std::string torque = unit_text(dimension::kTorque, profile.units);
  for (const Joint& joint : mechanism.joints) {
    joints_.push_back(joint.type);
    columns_.push_back({joint.name + ".fx", force});
    columns_.push_back({joint.name + ".fy", force});
    if (has_moment(joint.type)) {
      columns_.push_back({joint.name + ".m", torque});
    }
  }
  for (const Contact& contact : mechanism.contacts) {
    columns_.push_back({contact.name + ".force", force});
    columns_.push_back({contact.name + ".friction", force});
  }
  for (const Driver& driver : mechanism.drivers) {
    const std::string name = driver.name.empty() ? "driver" : "driver." + driver.name;
    drivers_.push_back(joint_of(mechanism, driver.joint).type);
    const std::string& unit = drivers_.back() == JointType::kRevolute ? torque : force;
    columns_.push_back({name + ".effort", unit});
    columns_.push_back({name + ".effort_check", unit});
  }
}

void ForceTable::add(const Scaling& scale, std::optional<double> value) {
  if (value && std::isfinite(*value)) {
    cells_.emplace_back(scale.apply(*value));
  } else {
    cells_.emplace_back();
  }
}

const std::vector<Cell>& ForceTable::cells(const Reactions& reactions, const std::vector<Cell>& motion) {
  cells_.assign(motion.begin(), motion.end() - kLastColumns);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    add(force_, reactions.joints[i].fx);
    add(force_, reactions.joints[i].fy);
    if (has_moment(joints_[i])) {
      add(torque_, reactions.joints[i].moment);
    }
  }
  for (const ContactReaction& contact : reactions.contacts) {
    add(force_, contact.force);
    add(force_, contact.friction);
  }
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    const Scaling& scale = drivers_[i] == JointType::kRevolute ? torque_ : force_;
    add(scale, reactions.drivers[i].effort);
    add(scale, reactions.drivers[i].by_power);
  }
  cells_.insert(cells_.end(), motion.end() - kLastColumns, motion.end());
  Cell& status = cells_[cells_.size() - kLastColumns];
  if (reactions.opens() && std::get<std::string_view>(status) == name_of(RowStatus::kOk)) {
    status = "contact_open";
  }
  return cells_;
}

std::string describe(const ContactOpening& opening, const PreloadNeed* need, const Profile& profile) {
  std::string text;
  switch (opening.kind) {
    case ContactOpening::Kind::kRoot:
      text = "from here on the contact would have to pull";
      break;
    case ContactOpening::Kind::kPole:
      text =
          "the contact force grows beyond all bounds here and changes its sign: a dead point, beyond which "
          "the contact would have to pull";
      break;
    case ContactOpening::Kind::kPulled:
      text = "the contact would have to pull here already";
      break;
  }
  return need != nullptr && need->opened ? text + advice(*need, profile) : text;
}

}  // namespace higherpair
