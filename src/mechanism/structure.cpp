#include "structure.hpp"

#include "higherpair/mechanism/constraint_rows.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/numeric/contains.hpp"
#include "idle_turning.hpp"
#include "redundancy.hpp"
#include "structural_conditions.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

namespace higherpair {
namespace {

constexpr int kUnmatched = -1;

// A maximum matching by augmenting paths. Conditions are taken in order and stay matched once they are, so
// that of conditions that contradict or repeat each other the last is left over.
class Matching {
public:
  Matching(const std::vector<Condition>& conditions, std::size_t variables)
      : conditions_(conditions), owner_(variables, kUnmatched), seen_(variables, -1) {
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      (void)augment(static_cast<int>(i), static_cast<int>(i));
    }
  }

  // Exchanges matched variables such that of all that can be left over, those of the highest ranks are.
  // Exact: a variable that is left over, and those that can be instead, form a circuit of a matroid, of which
  // the highest must be left over (as the longest edge of a cycle is from a shortest spanning tree).
  void leave_over(const std::vector<int>& ranks) {
    for (int v = 0; v < static_cast<int>(owner_.size()); ++v) {
      if (owner_[v] == kUnmatched) {
        leave_over_instead(v, ranks);
      }
    }
  }

  // The variable that each condition is matched with.
  [[nodiscard]] std::vector<int> partners() const {
    std::vector<int> partners(conditions_.size(), kUnmatched);
    for (std::size_t v = 0; v < owner_.size(); ++v) {
      if (owner_[v] != kUnmatched) {
        partners[owner_[v]] = static_cast<int>(v);
      }
    }
    return partners;
  }

private:
  bool augment(int condition, int round) {
    const std::vector<int>& variables = conditions_[condition].variables;
    for (const int variable : variables) {
      int& owner = owner_[variable];
      if (owner == kUnmatched) {
        owner = condition;
        return true;
      }
    }
    for (const int variable : variables) {
      const auto v = static_cast<std::size_t>(variable);
      if (seen_[v] != round) {
        seen_[v] = round;
        if (augment(owner_[v], round)) {
          owner_[v] = condition;
          return true;
        }
      }
    }
    return false;
  }

  // Walks from an unmatched variable to the conditions that it enters, to the variables that these are
  // matched with, and on; all conditions on the walk to the one of the highest rank then pass to the variable
  // before.
  void leave_over_instead(int unmatched, const std::vector<int>& ranks) {
    const std::vector<int> partner = partners();
    std::vector<int> before(owner_.size(), kUnmatched);
    std::vector<int> reached = {unmatched};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (std::size_t c = 0; c < conditions_.size(); ++c) {
        const int next = partner[c];
        if (next != kUnmatched && contains(conditions_[c].variables, reached[i]) &&
            !contains(reached, next)) {
          before[next] = reached[i];
          reached.push_back(next);
        }
      }
    }
    int v =
        *std::max_element(reached.begin(), reached.end(), [&](int a, int b) { return ranks[a] < ranks[b]; });
    int condition = std::exchange(owner_[v], kUnmatched);
    while (v != unmatched) {
      v = before[v];
      std::swap(owner_[v], condition);
    }
  }

  const std::vector<Condition>& conditions_;
  std::vector<int> owner_;
  std::vector<int> seen_;
};

// Component of each body; bodies depend only on components with smaller numbers.
std::vector<int> components(const std::vector<Condition>& conditions, const std::vector<int>& matched,
                            std::size_t bodies) {
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
  Graph graph(bodies);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const std::vector<int>& all = conditions[i].bodies;
    for (const int body : all) {
      for (const int other : all) {
        if (body != other && matched[i] != kUnmatched && matched[i] / 3 == body) {
          boost::add_edge(static_cast<std::size_t>(body), static_cast<std::size_t>(other), graph);
        }
      }
    }
  }
  std::vector<int> component(bodies);
  boost::strong_components(
      graph, boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, graph)));
  return component;
}

std::vector<LooseBody> loose_bodies(const std::vector<int>& matched, std::size_t bodies) {
  std::set<int> placed(matched.begin(), matched.end());
  std::vector<LooseBody> loose;
  for (int body = 1; body < static_cast<int>(bodies); ++body) {
    const bool x = placed.count(variable(body, Coordinate::kX)) > 0;
    const bool y = placed.count(variable(body, Coordinate::kY)) > 0;
    const bool angle = placed.count(variable(body, Coordinate::kAngle)) > 0;
    if (!x || !y || !angle) {
      loose.push_back({body, x && y});
    }
  }
  return loose;
}

// Removes the coordinates of conditions that others imply, so that these determine nothing. Of the joints,
// those on ground keep theirs: a body that lost its pin on ground would have to be placed together with all
// that carries it instead.
void take_out_repeated(const Mechanism& mechanism, std::vector<Condition>& conditions) {
  const int joint_rows =
      std::accumulate(mechanism.joints.begin(), mechanism.joints.end(), 0,
                      [](int rows, const Joint& joint) { return rows + row_count(joint); });
  std::vector<int> order;
  std::vector<int> after_joints_on_ground;
  for (const Condition& condition : conditions) {
    if (condition.row != Condition::kNoRow) {
      const bool first = condition.row < joint_rows && condition.bodies.size() == 1;
      (first ? order : after_joints_on_ground).push_back(condition.row);
    }
  }
  order.insert(order.end(), after_joints_on_ground.begin(), after_joints_on_ground.end());
  const std::vector<int> repeated = repeated_rows(mechanism, order);
  for (Condition& condition : conditions) {
    if (contains(repeated, condition.row)) {
      condition.variables.clear();
    }
  }
}

// The conditions, those that others imply without their coordinates: that parallel guides or cranks repeat
// each other does not show in which coordinates enter their conditions, and bodies that can move would count
// as placed.
std::vector<Condition> independent_conditions(const Mechanism& mechanism, const NameOrder& order) {
  std::vector<Condition> conditions = structural_conditions(mechanism, order);
  if (contains(Matching(conditions, 3 * mechanism.bodies.size()).partners(), kUnmatched)) {
    take_out_repeated(mechanism, conditions);
  }
  return conditions;
}

bool is_rolling(const Mechanism& mechanism, int body) {
  return std::any_of(mechanism.contacts.begin(), mechanism.contacts.end(),
                     [&](const Contact& contact) { return contact.rolling && has_end_on(contact, body); });
}

bool is_joined_to_ground(const Mechanism& mechanism, int body) {
  return std::any_of(mechanism.joints.begin(), mechanism.joints.end(),
                     [&](const Joint& joint) { return joins(joint, kGround, body); });
}

// The bodies of rolling contacts. The later one is, the sooner it keeps the angle of its pose: after a body
// on ground one that is carried, and last those whose angle their contacts hardly set.
std::vector<int> rolling_bodies(const Mechanism& mechanism, const NameOrder& order) {
  std::vector<int> bodies;
  std::copy_if(order.bodies.begin(), order.bodies.end(), std::back_inserter(bodies),
               [&](int body) { return is_rolling(mechanism, body); });
  if (bodies.size() < 2) {
    return bodies;
  }
  const double size = size_of(mechanism);
  std::stable_sort(bodies.begin(), bodies.end(), [&](int a, int b) {
    const auto rank = [&](int body) {
      return std::pair(is_nearly_round({mechanism, size}, body), !is_joined_to_ground(mechanism, body));
    };
    return rank(a) < rank(b);
  });
  return bodies;
}

}  // namespace

std::vector<int> phase_bodies(const Mechanism& mechanism) {
  const NameOrder order(mechanism);
  const std::vector<int> rolling = rolling_bodies(mechanism, order);
  if (rolling.empty()) {
    return {};
  }
  Mechanism slipping = mechanism;
  for (Contact& contact : slipping.contacts) {
    contact.rolling = false;
  }
  const std::size_t bodies = mechanism.bodies.size();
  const std::vector<Condition> conditions = independent_conditions(slipping, order);
  std::vector<int> ranks(3 * bodies, 0);
  for (std::size_t i = 0; i < rolling.size(); ++i) {
    ranks[variable(rolling[i], Coordinate::kAngle)] = static_cast<int>(i) + 1;
  }
  Matching matching(conditions, 3 * bodies);
  matching.leave_over(ranks);
  std::vector<int> held;
  for (const LooseBody& loose : loose_bodies(matching.partners(), bodies)) {
    if (loose.turning_only) {
      held.push_back(loose.body);
    }
  }
  return held;
}

Structure analyse_structure(const Mechanism& mechanism) {
  const NameOrder order(mechanism);
  const std::vector<Condition> conditions = independent_conditions(mechanism, order);
  const std::size_t bodies = mechanism.bodies.size();
  const std::vector<int> matched = Matching(conditions, 3 * bodies).partners();
  const std::vector<int> component = components(conditions, matched, bodies);

  Structure structure;
  structure.loose = loose_bodies(matched, bodies);
  structure.surplus = static_cast<int>(std::count(matched.begin(), matched.end(), kUnmatched));
  std::vector<BodySet> by_component(bodies);
  for (const int body : order.bodies) {
    if (body != 0) {
      const int number = component[body];
      by_component[number].bodies.push_back(body);
    }
  }
  // A condition belongs to the last placed of its bodies; ground counts as placed before all others.
  const auto set_of = [&](int first, int second, int third = 0) -> BodySet& {
    const auto place = [&](int body) { return body == 0 ? 0 : component[body]; };
    return by_component[std::max({place(first), place(second), place(third)})];
  };
  for (const int i : order.joints) {
    const Joint& joint = mechanism.joints[i];
    const int carrier = couples_turning(joint.type) ? joint.carrier : 0;
    set_of(joint.first.body, joint.second.body, carrier).joints.push_back(i);
  }
  for (const int i : order.contacts) {
    const Contact& contact = mechanism.contacts[i];
    set_of(contact.first.body, contact.second.body).contacts.push_back(i);
  }
  for (const int i : order.drivers) {
    const Joint& joint = driven_joint(mechanism, static_cast<std::size_t>(i));
    set_of(joint.first.body, joint.second.body).drivers.push_back(i);
  }
  for (BodySet& set : by_component) {
    if (!set.bodies.empty()) {
      structure.sets.push_back(std::move(set));
    }
  }
  return structure;
}

}  // namespace higherpair
