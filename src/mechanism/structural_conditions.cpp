#include "structural_conditions.hpp"

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/constraint_rows.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "idle_turning.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>

namespace higherpair {
namespace {

// Indices in the order of the names.
template <class T>
std::vector<int> by_name(const std::vector<T>& items) {
  std::vector<int> order(items.size());
  std::iota(order.begin(), order.end(), 0);
  const auto name = [&](int index) -> const std::string& { return items[index].name; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return name(a) < name(b); });
  return order;
}

// The first row of each item in conditions_at(), after `rows` preceding ones; adds the items' own rows to
// `rows`.
template <class T>
std::vector<int> first_rows(const std::vector<T>& items, int& rows) {
  std::vector<int> first;
  for (const T& item : items) {
    first.push_back(rows);
    rows += row_count(item);
  }
  return first;
}

// The reference points of the bodies: their first pins.
class References {
public:
  // \param order  of the joints, by name
  References(const Mechanism& mechanism, const std::vector<int>& order)
      : mechanism_(mechanism), of_(mechanism.bodies.size()) {
    for (const int index : order) {
      const Joint& joint = mechanism.joints[index];
      if (joint.type == JointType::kRevolute) {
        choose(joint.first);
        choose(joint.second);
      }
    }
  }

  // Whether a point is its body's reference, or the origin of a body without pins.
  [[nodiscard]] bool is_at(const PointRef& ref) const { return is_at(ref.body, point_of(mechanism_, ref)); }

  // Whether a curve is round about its body's reference pin: a circle, or a knife edge there.
  [[nodiscard]] bool is_about(const CurveRef& ref) const {
    const auto middle = round_center(curve_of(mechanism_, ref));
    return middle && of_[ref.body] && is_at(ref.body, *middle);
  }

private:
  void choose(const PointRef& ref) {
    auto& reference = of_[ref.body];
    if (!reference) {
      reference = point_of(mechanism_, ref);
    }
  }

  [[nodiscard]] bool is_at(int body, const Vector2d& p_B) const {
    const Vector2d reference = of_[body].value_or(Vector2d(Vector2d::Zero()));
    return (p_B - reference).norm() <= kSameBodyPoint * (p_B.norm() + reference.norm());
  }

  const Mechanism& mechanism_;
  std::vector<std::optional<Vector2d>> of_;
};

class Conditions {
public:
  Conditions(const Mechanism& mechanism, const NameOrder& order) : references_(mechanism, order.joints) {
    for (const int index : order.drivers) {
      add_driver(driven_joint(mechanism, static_cast<std::size_t>(index)));
    }
    int rows = 0;
    const std::vector<int> joint_rows = first_rows(mechanism.joints, rows);
    for (const int index : order.joints) {
      const std::size_t added = conditions_.size();
      add_joint(mechanism.joints[index]);
      number_rows(added, joint_rows[index]);
    }
    const std::vector<int> contact_rows = first_rows(mechanism.contacts, rows);
    for (const int index : order.contacts) {
      add_contact(mechanism.contacts[index]);
      conditions_.back().row = contact_rows[index];
    }
    for (const int index : order.contacts) {
      const Contact& contact = mechanism.contacts[index];
      if (contact.rolling) {
        add_between(contact);
        conditions_.back().row = contact_rows[index] + 1;
      }
    }
  }

  [[nodiscard]] const std::vector<Condition>& all() const { return conditions_; }

private:
  void number_rows(std::size_t begin, int row) {
    for (std::size_t i = begin; i < conditions_.size(); ++i) {
      conditions_[i].row = row++;
    }
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

  // Enters the coordinates that one component of a point's position depends on.
  void enter_point(Condition& condition, const PointRef& ref, Coordinate coordinate) const {
    if (references_.is_at(ref)) {
      enter(condition, ref.body, {coordinate});
    } else {
      enter(condition, ref.body, {coordinate, Coordinate::kAngle});
    }
  }

  void add_joint(const Joint& joint) {
    if (joint.type == JointType::kRevolute) {
      for (const Coordinate coordinate : {Coordinate::kX, Coordinate::kY}) {
        Condition& condition = conditions_.emplace_back();
        enter_point(condition, joint.first, coordinate);
        enter_point(condition, joint.second, coordinate);
      }
      return;
    }
    if (couples_turning(joint.type)) {
      Condition& condition = add_angles(joint);
      // The carrier's turning does not matter to wheels that turn alike.
      if (joint.turning_ratio != 1) {
        enter(condition, joint.carrier, {Coordinate::kAngle});
      }
      return;
    }
    add_between(joint);
    if (joint.type == JointType::kPrismatic) {
      (void)add_angles(joint);
    }
  }

  // A condition on all coordinates of the two bodies of a joint or contact.
  template <class Pair>
  void add_between(const Pair& pair) {
    Condition& condition = conditions_.emplace_back();
    enter_all(condition, pair.first.body);
    enter_all(condition, pair.second.body);
  }

  // One on their angles alone.
  Condition& add_angles(const Joint& joint) {
    Condition& condition = conditions_.emplace_back();
    enter(condition, joint.first.body, {Coordinate::kAngle});
    enter(condition, joint.second.body, {Coordinate::kAngle});
    return condition;
  }

  void add_driver(const Joint& joint) {
    if (joint.type == JointType::kRevolute) {
      (void)add_angles(joint);
    } else {
      add_between(joint);
    }
  }

  // The condition of a curve that is round about its body's pin does not depend on the body's angle.
  void enter_curve(Condition& condition, const CurveRef& ref) const {
    if (references_.is_about(ref)) {
      enter(condition, ref.body, {Coordinate::kX, Coordinate::kY});
    } else {
      enter_all(condition, ref.body);
    }
  }

  void add_contact(const Contact& contact) {
    Condition& condition = conditions_.emplace_back();
    enter_curve(condition, contact.first);
    enter_curve(condition, contact.second);
  }

  References references_;
  std::vector<Condition> conditions_;
};

}  // namespace

NameOrder::NameOrder(const Mechanism& mechanism)
    : bodies(by_name(mechanism.bodies)),
      joints(by_name(mechanism.joints)),
      contacts(by_name(mechanism.contacts)),
      drivers(by_name(mechanism.drivers)) {}

std::vector<Condition> structural_conditions(const Mechanism& mechanism, const NameOrder& order) {
  return Conditions(mechanism, order).all();
}

namespace {

// Of the bodies of rolling contacts, whether they are nearly round: of these the plan chooses those that keep
// their angles.
void append_nearly_round(const Mechanism& mechanism, std::vector<bool>& coincide) {
  std::optional<double> size;
  for (const Contact& contact : mechanism.contacts) {
    if (!contact.rolling) {
      continue;
    }
    if (!size) {
      size = size_of(mechanism);
    }
    coincide.push_back(is_nearly_round({mechanism, *size}, contact.first.body));
    coincide.push_back(is_nearly_round({mechanism, *size}, contact.second.body));
  }
}

}  // namespace

std::vector<bool> coincidences_of(const Mechanism& mechanism) {
  const References references(mechanism, by_name(mechanism.joints));
  std::vector<bool> coincide;
  for (const Joint& joint : mechanism.joints) {
    if (joint.type == JointType::kRevolute) {
      coincide.push_back(references.is_at(joint.first));
      coincide.push_back(references.is_at(joint.second));
    }
  }
  for (const Contact& contact : mechanism.contacts) {
    coincide.push_back(references.is_about(contact.first));
    coincide.push_back(references.is_about(contact.second));
  }
  append_nearly_round(mechanism, coincide);
  return coincide;
}

}  // namespace higherpair
