#include "structure.hpp"

#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

namespace higherpair {
namespace {

// A coordinate of a body: x and y of a reference point (a pin, where it has one), and its angle.
enum class Coordinate { kX = 0, kY = 1, kAngle = 2 };

int variable(int body, Coordinate coordinate) {
  return 3 * body + static_cast<int>(coordinate);
}

// One condition: its bodies and the coordinates that enter.
struct Condition {
  std::vector<int> bodies;  // moving ones
  std::vector<int> variables;
};

// Indices in the order of the names: the order of the description must not matter, not even for rounding.
template <class T>
std::vector<int> by_name(const std::vector<T>& items) {
  std::vector<int> order(items.size());
  std::iota(order.begin(), order.end(), 0);
  const auto name = [&](int index) -> const std::string& {
    return items[static_cast<std::size_t>(index)].name;
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return name(a) < name(b); });
  return order;
}

struct Order {
  explicit Order(const Mechanism& mechanism)
      : bodies(by_name(mechanism.bodies)),
        joints(by_name(mechanism.joints)),
        contacts(by_name(mechanism.contacts)),
        drivers(by_name(mechanism.drivers)) {}

  std::vector<int> bodies, joints, contacts, drivers;
};

class Conditions {
public:
  Conditions(const Mechanism& mechanism, const Order& order)
      : mechanism_(mechanism), reference_(mechanism.bodies.size()) {
    for (const int index : order.joints) {
      const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
      if (joint.type == JointType::kRevolute) {
        choose_reference(joint.first);
        choose_reference(joint.second);
      }
    }
    for (const int index : order.drivers) {
      const Driver& driver = mechanism.drivers[static_cast<std::size_t>(index)];
      add_driver(mechanism.joints[static_cast<std::size_t>(driver.joint)]);
    }
    for (const int index : order.joints) {
      add_joint(mechanism.joints[static_cast<std::size_t>(index)]);
    }
    for (const int index : order.contacts) {
      add_contact(mechanism.contacts[static_cast<std::size_t>(index)]);
    }
    for (const int index : order.contacts) {
      const Contact& contact = mechanism.contacts[static_cast<std::size_t>(index)];
      if (contact.rolling) {
        add_slip(contact);
      }
    }
  }

  [[nodiscard]] const std::vector<Condition>& all() const { return conditions_; }

private:
  void choose_reference(const PointRef& ref) {
    auto& reference = reference_[static_cast<std::size_t>(ref.body)];
    if (!reference) {
      reference = point_of(mechanism_, ref);
    }
  }

  [[nodiscard]] bool is_reference(int body, const Vector2d& p_B) const {
    const Vector2d reference =
        reference_[static_cast<std::size_t>(body)].value_or(Vector2d(Vector2d::Zero()));
    return (p_B - reference).norm() <= 1e-12 * (p_B.norm() + reference.norm());
  }

  void enter(Condition& condition, int body, std::initializer_list<Coordinate> coordinates) const {
    if (body == 0) {
      return;
    }
    condition.bodies.push_back(body);
    for (const Coordinate coordinate : coordinates) {
      condition.variables.push_back(variable(body, coordinate));
    }
  }

  void enter_all(Condition& condition, int body) const {
    enter(condition, body, {Coordinate::kX, Coordinate::kY, Coordinate::kAngle});
  }

  // One component of the place of a point.
  void enter_point(Condition& condition, const PointRef& ref, Coordinate coordinate) const {
    if (is_reference(ref.body, point_of(mechanism_, ref))) {
      enter(condition, ref.body, {coordinate});
    } else {
      enter(condition, ref.body, {coordinate, Coordinate::kAngle});
    }
  }

  void add_joint(const Joint& joint) {
    if (joint.type == JointType::kRevolute) {
      for (const Coordinate coordinate : {Coordinate::kX, Coordinate::kY}) {
        Condition condition;
        enter_point(condition, joint.first, coordinate);
        enter_point(condition, joint.second, coordinate);
        conditions_.push_back(condition);
      }
      return;
    }
    if (couples_turning(joint.type)) {
      add_turning(joint);
      return;
    }
    add_along_line(joint);
    if (joint.type == JointType::kPrismatic) {
      add_angle(joint);
    }
  }

  void add_along_line(const Joint& joint) {
    Condition condition;
    enter_all(condition, joint.first.body);
    enter_all(condition, joint.second.body);
    conditions_.push_back(condition);
  }

  void add_angle(const Joint& joint) {
    Condition condition;
    enter(condition, joint.first.body, {Coordinate::kAngle});
    enter(condition, joint.second.body, {Coordinate::kAngle});
    conditions_.push_back(condition);
  }

  void add_turning(const Joint& joint) {
    Condition condition;
    enter(condition, joint.first.body, {Coordinate::kAngle});
    enter(condition, joint.second.body, {Coordinate::kAngle});
    // Wheels that turn alike do not see their carrier turn.
    if (joint.turning_ratio != 1) {
      enter(condition, joint.carrier, {Coordinate::kAngle});
    }
    conditions_.push_back(condition);
  }

  void add_driver(const Joint& joint) {
    joint.type == JointType::kRevolute ? add_angle(joint) : add_along_line(joint);
  }

  // A circle about its body's reference pin, or a knife edge there, does not see the body's turning.
  void enter_curve(Condition& condition, const CurveRef& ref) const {
    const Curve& curve = curve_of(mechanism_, ref);
    const bool round = curve.kind == CurveKind::kCircle || curve.kind == CurveKind::kPoint;
    const Vector2d middle = curve.kind == CurveKind::kCircle ? center(curve) : curve.vertex_B;
    if (round && reference_[static_cast<std::size_t>(ref.body)] && is_reference(ref.body, middle)) {
      enter(condition, ref.body, {Coordinate::kX, Coordinate::kY});
    } else {
      enter_all(condition, ref.body);
    }
  }

  void add_contact(const Contact& contact) {
    Condition condition;
    enter_curve(condition, contact.first);
    enter_curve(condition, contact.second);
    conditions_.push_back(condition);
  }

  void add_slip(const Contact& contact) {
    Condition slip;
    enter_all(slip, contact.first.body);
    enter_all(slip, contact.second.body);
    conditions_.push_back(slip);
  }

  const Mechanism& mechanism_;
  std::vector<std::optional<Vector2d>> reference_;
  std::vector<Condition> conditions_;
};

constexpr int kUnmatched = -1;

// A maximum matching by augmenting paths. Conditions are taken in their order and keep a partner once they
// have one, so that what stays over is the last of the conditions that contradict or repeat each other.
class Matching {
public:
  Matching(const std::vector<Condition>& conditions, std::size_t variables)
      : conditions_(conditions), owner_(variables, kUnmatched), seen_(variables, -1) {
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      (void)augment(static_cast<int>(i), static_cast<int>(i));
    }
  }

  // For each condition the variable that it is matched with.
  [[nodiscard]] std::vector<int> partners() const {
    std::vector<int> partners(conditions_.size(), kUnmatched);
    for (std::size_t v = 0; v < owner_.size(); ++v) {
      if (owner_[v] != kUnmatched) {
        partners[static_cast<std::size_t>(owner_[v])] = static_cast<int>(v);
      }
    }
    return partners;
  }

private:
  bool augment(int condition, int round) {
    const std::vector<int>& variables = conditions_[static_cast<std::size_t>(condition)].variables;
    for (const int variable : variables) {
      int& owner = owner_[static_cast<std::size_t>(variable)];
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

  const std::vector<Condition>& conditions_;
  std::vector<int> owner_;
  std::vector<int> seen_;
};

// Component of each body; a body depends on components of smaller number only.
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

}  // namespace

Structure analyse_structure(const Mechanism& mechanism) {
  const Order order(mechanism);
  const Conditions conditions(mechanism, order);
  const std::size_t bodies = mechanism.bodies.size();
  const std::vector<int> matched = Matching(conditions.all(), 3 * bodies).partners();
  const std::vector<int> component = components(conditions.all(), matched, bodies);

  Structure structure;
  structure.loose = loose_bodies(matched, bodies);
  structure.surplus = static_cast<int>(std::count(matched.begin(), matched.end(), kUnmatched));
  std::vector<BodySet> by_component(bodies);
  for (const int body : order.bodies) {
    if (body != 0) {
      const int number = component[static_cast<std::size_t>(body)];
      by_component[static_cast<std::size_t>(number)].bodies.push_back(body);
    }
  }
  // A condition belongs to the last placed of its bodies; ground counts as placed before all.
  const auto set_of = [&](int first, int second, int third = 0) -> BodySet& {
    const auto place = [&](int body) { return body == 0 ? 0 : component[static_cast<std::size_t>(body)]; };
    return by_component[static_cast<std::size_t>(std::max({place(first), place(second), place(third)}))];
  };
  for (const int i : order.joints) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(i)];
    const int carrier = couples_turning(joint.type) ? joint.carrier : 0;
    set_of(joint.first.body, joint.second.body, carrier).joints.push_back(i);
  }
  for (const int i : order.contacts) {
    const Contact& contact = mechanism.contacts[static_cast<std::size_t>(i)];
    set_of(contact.first.body, contact.second.body).contacts.push_back(i);
  }
  for (const int i : order.drivers) {
    const Driver& driver = mechanism.drivers[static_cast<std::size_t>(i)];
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(driver.joint)];
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
