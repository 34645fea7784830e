#include "higherpair/mechanism/plan.hpp"

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/mobility_text.hpp"
#include "higherpair/mechanism/redimension.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "higherpair/numeric/contains.hpp"
#include "idle_turning.hpp"
#include "recognise.hpp"
#include "structural_conditions.hpp"
#include "structure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>

#include <boost/geometry/algorithms/append.hpp>
#include <boost/geometry/algorithms/convex_hull.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <fmt/core.h>

namespace higherpair {
namespace {

using HullPoint = boost::geometry::model::d2::point_xy<double>;

// The two points that are farthest apart are on the convex hull.
double largest_distance(const std::vector<Vector2d>& points) {
  boost::geometry::model::multi_point<HullPoint> all;
  for (const Vector2d& point : points) {
    boost::geometry::append(all, HullPoint(point.x(), point.y()));
  }
  boost::geometry::model::polygon<HullPoint> hull;
  boost::geometry::convex_hull(all, hull);
  double square = 0;
  for (const HullPoint& a : hull.outer()) {
    for (const HullPoint& b : hull.outer()) {
      square = std::max(square, Vector2d(a.x() - b.x(), a.y() - b.y()).squaredNorm());
    }
  }
  return std::sqrt(square);
}

std::string names_of(const Mechanism& mechanism, const std::vector<LooseBody>& loose) {
  std::string names;
  for (const LooseBody& body : loose) {
    names += (names.empty() ? "" : ", ") + mechanism.bodies[body.body].name +
             (body.turning_only ? " (its turning)" : "");
  }
  return names;
}

// Explains why too few coordinates are determined. The rank explains more than the matching: which joints
// could be driven, and what the count misses.
std::string too_loose(const Mechanism& mechanism, const std::vector<LooseBody>& loose) {
  const Mobility mobility = analyse_mobility(mechanism);
  if (const auto objection = driver_objection(mechanism, mobility)) {
    return *objection;
  }
  const auto drivers = mechanism.drivers.size();
  return "the mechanism has more freedom than drivers: by the count " + formula_text(mobility.count) +
         ", drivers " + std::to_string(drivers) + "; not placed: " + names_of(mechanism, loose) +
         "; add a driver, joint or contact that sets " + (loose.size() == 1 ? "it" : "them");
}

}  // namespace

double size_of(const Mechanism& mechanism) {
  std::vector<Vector2d> points;
  double largest = 0;  // largest coordinate, to which rounding is relative
  const std::vector<BodyMotion> bodies = posed_bodies(mechanism);
  const auto add = [&](int body, const Vector2d& p_B) {
    points.push_back(bodies[body].X_WB * p_B);
    largest = std::max({largest, p_B.norm(), points.back().norm()});
  };
  for (const Joint& joint : mechanism.joints) {
    add(joint.first.body, point_of(mechanism, joint.first));
    add(joint.second.body, point_of(mechanism, joint.second));
  }
  for (const Contact& contact : mechanism.contacts) {
    for (const CurveRef& ref : {contact.first, contact.second}) {
      const Curve& curve = curve_of(mechanism, ref);
      add(ref.body, anchor(curve));
      if (const auto middle = middle_of(curve)) {
        add(ref.body, *middle);
      }
    }
  }
  const double size = largest_distance(points);
  if (size > kCoincident * largest && size > kLeastSize) {
    return size;
  }
  return largest > kLeastSize ? largest : 1;
}

namespace {

// Sets what depends on the dimensions: the groups, one for each set, and the size.
void fill_in(Plan& plan, const Mechanism& mechanism, const std::vector<BodySet>& sets) {
  for (const BodySet& set : sets) {
    plan.groups.push_back(recognise(mechanism, set, plan.groups));
  }
  plan.size = size_of(mechanism);
  plan.couples = std::any_of(plan.groups.begin(), plan.groups.end(),
                             [](const Group& group) { return traits_of(group).coupled; });
  for (Group& group : plan.groups) {
    if (auto* dyad = std::get_if<RprDyad>(&group.kind)) {
      dyad->size = plan.size;
    }
    std::copy_if(group.joints.begin(), group.joints.end(), std::back_inserter(group.ended_joints),
                 [&](int index) {
                   const Joint& joint = mechanism.joints[index];
                   return joint.from || joint.to;
                 });
  }
}

// A contact that may part needs a joint that holds its body while it is open.
std::optional<std::string> cannot_part(const Mechanism& mechanism, const Plan& plan) {
  for (const Group& group : plan.groups) {
    for (const int index : group.contacts) {
      const Contact& contact = mechanism.contacts[index];
      if (contact.keep == Keep::kGap && !std::holds_alternative<TouchingBody>(group.kind)) {
        return fmt::format(
            "contacts.{}: with keep = \"gap\" one of the two bodies must hang on a revolute or prismatic "
            "joint, which holds it while they are apart, and be moved by this contact alone",
            contact.name);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

tl::expected<Plan, std::string> make_plan(const Mechanism& mechanism) {
  const Structure structure = analyse_structure(mechanism);
  Plan plan;
  std::vector<LooseBody> missing;
  for (const LooseBody& loose : structure.loose) {
    if (loose.turning_only && turns_idly({mechanism, size_of(mechanism)}, loose.body)) {
      plan.idle_bodies.push_back(loose.body);
    } else {
      missing.push_back(loose);
    }
  }
  if (!missing.empty()) {
    return tl::unexpected(too_loose(mechanism, missing));
  }
  plan.surplus = structure.surplus;
  plan.coincidences = coincidences_of(mechanism);
  plan.phase_bodies = phase_bodies(mechanism);
  fill_in(plan, mechanism, structure.sets);
  if (auto objection = cannot_part(mechanism, plan)) {
    return tl::unexpected(*std::move(objection));
  }
  return plan;
}

std::vector<int> idle_bodies_of(const Plan& plan, const Group& group) {
  std::vector<int> idle;
  std::copy_if(plan.idle_bodies.begin(), plan.idle_bodies.end(), std::back_inserter(idle),
               [&](int body) { return contains(group.bodies, body); });
  return idle;
}

std::optional<std::size_t> group_with_contact(const Plan& plan, int contact) {
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    const std::vector<int>& contacts = plan.groups[g].contacts;
    if (contains(contacts, contact)) {
      return g;
    }
  }
  return std::nullopt;
}

bool can_be_redimensioned(const Plan& plan, const Mechanism& mechanism) {
  return plan.coincidences == coincidences_of(mechanism);
}

Plan redimensioned(const Plan& plan, const Mechanism& mechanism) {
  Plan other;
  other.idle_bodies = plan.idle_bodies;
  other.phase_bodies = phase_bodies(mechanism);
  other.surplus = plan.surplus;
  other.coincidences = plan.coincidences;
  std::vector<BodySet> sets;
  for (const Group& group : plan.groups) {
    sets.push_back({group.bodies, group.joints, group.contacts, group.drivers});
  }
  fill_in(other, mechanism, sets);
  return other;
}

tl::expected<Plan, std::string> plan_like(const Plan& plan, const Mechanism& mechanism) {
  return can_be_redimensioned(plan, mechanism) ? redimensioned(plan, mechanism) : make_plan(mechanism);
}

void redimension_groups(Plan& plan, const Mechanism& mechanism) {
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    Group& group = plan.groups[g];
    group.kind = kind_of(mechanism, {group.bodies, group.joints, group.contacts, group.drivers},
                         std::span(plan.groups).first(g));
    if (auto* dyad = std::get_if<RprDyad>(&group.kind)) {
      dyad->size = plan.size;
    }
  }
}

}  // namespace higherpair
