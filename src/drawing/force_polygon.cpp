#include "higherpair/drawing/picture.hpp"
#include "higherpair/drawing/row_polygons.hpp"
#include "higherpair/dynamics/applied_loads.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {
namespace {

// A force on a body, its name, and the item that causes it.
struct Force {
  std::string name;
  std::string item;
  Vector2d force_W = Vector2d::Zero();
};

// The forces on every body, and the names of those that the balance does not determine.
class ForceList {
public:
  ForceList(const Mechanism& mechanism, const MotionRow& row)
      : mechanism_(mechanism),
        row_(row),
        forces_(mechanism.bodies.size()),
        missing_(mechanism.bodies.size()) {}

  void add_applied() {
    for (std::size_t i = 1; i < row_.bodies.size(); ++i) {
      const auto& mass = mechanism_.bodies[i].mass;
      if (!mass) continue;
      const Vector2d a_W = point_motion(row_.bodies[i], mass->center_of_mass_B).a_W;
      forces_[i].push_back({"G", "weight", mass->mass * mechanism_.gravity_W});
      forces_[i].push_back({"(−m a)", "inertia", -mass->mass * a_W});
    }
    for (const Load& load : mechanism_.loads) {
      const auto body = static_cast<std::size_t>(load.body);
      const bool turns_along = load.frame == LoadFrame::kBody;
      add(body, load.name, load.name,
          turns_along ? Vector2d(row_.bodies[body].X_WB.R_WB * load.force) : load.force);
    }
    for (const Spring& spring : mechanism_.springs) {
      std::vector<Wrench> wrenches = no_wrenches();
      add_tension(mechanism_, spring, spring_tension(mechanism_, spring, row_.bodies), row_.bodies, wrenches);
      add(wrenches, spring.name);
    }
  }

  void add_reactions(const Reactions& reactions) {
    for (std::size_t i = 0; i < reactions.drivers.size(); ++i) {
      const auto index = static_cast<std::size_t>(mechanism_.drivers[i].joint);
      const Joint& joint = mechanism_.joints[index];
      if (has_angle(joint.type)) continue;
      std::vector<Wrench> wrenches = no_wrenches();
      if (!reactions.drivers[i].effort) {
        miss(joint.first.body, joint.second.body, joint.name);
        continue;
      }
      add_joint_effort(mechanism_, joint, *reactions.drivers[i].effort, row_.bodies, wrenches);
      add(wrenches, "drive");
    }
    for (std::size_t i = 0; i < reactions.joints.size(); ++i) add(mechanism_.joints[i], reactions.joints[i]);
    for (std::size_t i = 0; i < reactions.contacts.size(); ++i) add_contact(i, reactions.contacts[i]);
  }

  [[nodiscard]] const std::vector<Force>& of(std::size_t body) const { return forces_[body]; }
  [[nodiscard]] const std::vector<std::string>& missing(std::size_t body) const { return missing_[body]; }

  [[nodiscard]] double largest() const {
    double most = 0;
    for (const auto& list : forces_) {
      for (const Force& force : list) most = std::max(most, force.force_W.norm());
    }
    return most;
  }

private:
  [[nodiscard]] std::vector<Wrench> no_wrenches() const {
    return std::vector<Wrench>(row_.bodies.size(), Wrench(Wrench::Zero()));
  }

  void add(std::size_t body, const std::string& name, const std::string& item, const Vector2d& force_W) {
    forces_[body].push_back({"F_{" + name + "}", item, force_W});
  }

  void add(const std::vector<Wrench>& wrenches, const std::string& name) {
    for (std::size_t i = 0; i < wrenches.size(); ++i) add(i, name, name, wrenches[i].head<2>());
  }

  void add_pair(int first, int second, const std::string& name, const Vector2d& on_second_W) {
    add(static_cast<std::size_t>(first), name, name, -on_second_W);
    add(static_cast<std::size_t>(second), name, name, on_second_W);
  }

  void miss(int first, int second, const std::string& name) {
    for (const int body : {first, second}) missing_[body].push_back(name);
  }

  void add(const Joint& joint, const JointReaction& reaction) {
    if (couples_turning(joint.type) && !joint.teeth) return;  // transmits moments only
    if (reaction.fx && reaction.fy) {
      add_pair(joint.first.body, joint.second.body, joint.name, {*reaction.fx, *reaction.fy});
    } else {
      miss(joint.first.body, joint.second.body, joint.name);
    }
  }

  void add_contact(std::size_t index, const ContactReaction& reaction) {
    if (!row_.contacts[index].touches) return;
    const Contact& contact = mechanism_.contacts[index];
    const Vector2d& n_W = row_.contacts[index].at.n_W;
    if (reaction.force && reaction.friction) {
      add_pair(contact.first.body, contact.second.body, contact.name,
               *reaction.force * n_W + *reaction.friction * perp(n_W));
    } else {
      miss(contact.first.body, contact.second.body, contact.name);
    }
  }

  const Mechanism& mechanism_;
  const MotionRow& row_;
  std::vector<std::vector<Force>> forces_;
  std::vector<std::vector<std::string>> missing_;
};

Polygon head_to_tail(const std::vector<Force>& forces, double least) {
  Polygon polygon;
  polygon.kind = Polygon::Kind::kForce;
  Vector2d at = Vector2d::Zero();
  std::string sum;
  for (const Force& force : forces) {
    if (!(force.force_W.norm() > least)) continue;
    const Vector2d next = at + force.force_W;
    polygon.arrows.push_back({PolygonArrow::Kind::kForce, force.name, force.item, at, next});
    at = next;
    sum += (sum.empty() ? "" : " + ") + force.name;
  }
  if (!sum.empty()) polygon.equations.push_back(sum + " = 0");
  return polygon;
}

}  // namespace

std::vector<Polygon> force_polygons(const Mechanism& mechanism, const MotionRow& row,
                                    const Reactions& reactions) {
  std::vector<Polygon> polygons;
  if (!reactions.defined) {
    Polygon none;
    none.kind = Polygon::Kind::kForce;
    none.title = "Forces";
    none.notes.emplace_back("the forces are not defined at this position");
    polygons.push_back(std::move(none));
    return polygons;
  }
  ForceList list(mechanism, row);
  list.add_applied();
  list.add_reactions(reactions);
  const double least = kNegligibleForce * list.largest();
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    Polygon polygon;
    if (list.missing(i).empty()) {
      polygon = head_to_tail(list.of(i), least);
    } else {
      polygon.kind = Polygon::Kind::kForce;
      polygon.notes.push_back("the balance does not determine the force of " + list.missing(i).front());
    }
    polygon.title = mechanism.bodies[i].name;
    if (!polygon.arrows.empty() || !polygon.notes.empty()) polygons.push_back(std::move(polygon));
  }
  return polygons;
}

}  // namespace higherpair
