#include "redundancy.hpp"

#include "free_directions.hpp"
#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/constraint_rows.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/mechanism/pins.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "higherpair/numeric/contains.hpp"
#include "numeric/product.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace higherpair {
namespace {

// The joint or contact that every row belongs to: joints by their index, then contacts.
std::vector<int> owners_of_rows(const Mechanism& mechanism) {
  std::vector<int> owners;
  int owner = 0;
  for (const Joint& joint : mechanism.joints) {
    owners.insert(owners.end(), static_cast<std::size_t>(row_count(joint)), owner++);
  }
  for (const Contact& contact : mechanism.contacts) {
    owners.insert(owners.end(), static_cast<std::size_t>(row_count(contact)), owner++);
  }
  return owners;
}

int root(std::vector<int>& parent, int i) {
  while (parent[i] != i) {
    i = parent[i];
  }
  return i;
}

bool is_same_pin_twice(const std::vector<Pin>& pins, const Redundancy& set) {
  return std::any_of(pins.begin(), pins.end(), [&](const Pin& pin) {
    const auto involved = std::count_if(pin.joints.begin(), pin.joints.end(),
                                        [&](int joint) { return contains(set.joints, joint); });
    return static_cast<std::size_t>(involved) >= pin.ends.size();
  });
}

// A link between two pins, as a vector between the two bodies at its ends.
struct Link {
  int body = 0;
  int from = 0;
  int to = 0;
  Vector2d along_W = Vector2d::Zero();
};

// Links connected to the other bodies of a set by exactly two pins.
std::vector<Link> links_of(const Mechanism& mechanism, const Redundancy& set,
                           const std::vector<BodyMotion>& bodies) {
  std::vector<Link> links;
  for (int b = 1; b < static_cast<int>(mechanism.bodies.size()); ++b) {
    std::vector<BodyPoint> own;
    std::vector<int> others;
    bool pins_only = true;
    for (const int index : set.joints) {
      const Joint& joint = mechanism.joints[index];
      if (!has_end_on(joint, b)) {
        continue;
      }
      pins_only = pins_only && joint.type == JointType::kRevolute;
      own.push_back({b, point_on(mechanism, joint, b)});
      others.push_back(end_off(joint, b).body);
    }
    if (own.size() != 2 || !pins_only || others[0] == others[1]) {
      continue;
    }
    const std::size_t low = others[0] < others[1] ? 0 : 1;
    const Vector2d along_B = own[1 - low].p_B - own[low].p_B;
    links.push_back({b, others[low], others[1 - low], bodies[b].X_WB.R_WB * along_B});
  }
  return links;
}

// Three or more equal and parallel links between the same two bodies.
std::vector<int> parallel_cranks(const std::vector<Link>& links, double size) {
  for (const Link& link : links) {
    std::vector<int> same;
    for (const Link& other : links) {
      if (other.from == link.from && other.to == link.to &&
          (other.along_W - link.along_W).norm() <= kParallelLinks * size) {
        same.push_back(other.body);
      }
    }
    if (same.size() >= 3) {
      return same;
    }
  }
  return {};
}

RedundancyCause contact_cause(const Mechanism& mechanism, const Redundancy& set) {
  const bool rolls = std::any_of(set.contacts.begin(), set.contacts.end(),
                                 [&](int contact) { return mechanism.contacts[contact].rolling; });
  return rolls ? RedundancyCause::kRollingOnPivots : RedundancyCause::kSlidingOnPivots;
}

void set_cause(const SizedMechanism& sized, const std::vector<Pin>& pins, const MechanismPosition& position,
               Redundancy& set) {
  const Mechanism& mechanism = sized.mechanism;
  const auto is = [&](JointType type) {
    return [&mechanism, type](int joint) { return mechanism.joints[joint].type == type; };
  };
  if (is_same_pin_twice(pins, set)) {
    set.cause = RedundancyCause::kSamePin;
    return;
  }
  if (set.contacts.size() == 1 && set.conditions == 1 &&
      std::all_of(set.joints.begin(), set.joints.end(), is(JointType::kRevolute))) {
    set.cause = contact_cause(mechanism, set);
    return;
  }
  if (set.contacts.empty() && std::all_of(set.joints.begin(), set.joints.end(), is(JointType::kPrismatic))) {
    set.cause = RedundancyCause::kSlidesAlone;
    return;
  }
  set.bodies = parallel_cranks(links_of(mechanism, set, position.bodies), sized.size);
  if (!set.bodies.empty()) {
    set.cause = RedundancyCause::kParallelCranks;
  }
}

}  // namespace

std::vector<Redundancy> find_redundancies(const SizedMechanism& sized, const MechanismPosition& position,
                                          const Eigen::MatrixXd& left) {
  std::vector<Redundancy> found;
  if (left.cols() == 0) {
    return found;
  }
  const Mechanism& mechanism = sized.mechanism;
  const std::vector<int> owners = owners_of_rows(mechanism);
  const auto count = static_cast<int>(mechanism.joints.size() + mechanism.contacts.size());
  const Eigen::MatrixXd projector = product(left, left.transpose());
  std::vector<int> parent(static_cast<std::size_t>(count));
  std::iota(parent.begin(), parent.end(), 0);
  std::vector<double> weight(static_cast<std::size_t>(count), 0);
  std::vector<bool> involved(static_cast<std::size_t>(count), false);
  for (Eigen::Index i = 0; i < projector.rows(); ++i) {
    const int owner = owners[i];
    weight[owner] += projector(i, i);
    for (Eigen::Index k = 0; k <= i; ++k) {
      if (std::abs(projector(i, k)) > kInvolved) {
        involved[owner] = true;
        parent[root(parent, owner)] = root(parent, owners[k]);
      }
    }
  }
  const std::vector<Pin> pins = find_pins(mechanism);
  for (int top = 0; top < count; ++top) {
    Redundancy set;
    double trace = 0;
    for (int i = 0; i < count; ++i) {
      if (!involved[i] || root(parent, i) != top) {
        continue;
      }
      trace += weight[i];
      const auto joints = static_cast<int>(mechanism.joints.size());
      i < joints ? set.joints.push_back(i) : set.contacts.push_back(i - joints);
    }
    // The trace of a projector is its rank.
    set.conditions = static_cast<int>(std::lround(trace));
    if (set.conditions > 0) {
      set_cause(sized, pins, position, set);
      found.push_back(std::move(set));
    }
  }
  return found;
}

std::vector<int> repeated_rows(const Mechanism& mechanism, const std::vector<int>& order) {
  const auto start = assemble_near_poses(mechanism, {});
  if (!start) {
    return {};
  }
  const Moves moves = explore({mechanism, size_of(mechanism)}, *start);
  if (moves.real.cols() < moves.at_best.right.cols()) {
    return {};
  }
  Eigen::MatrixXd left = moves.at_best.left;
  std::vector<int> repeated;
  for (auto row = order.rbegin(); row != order.rend() && left.cols() > 0; ++row) {
    if (left.row(*row).norm() > kInvolved) {
      repeated.push_back(*row);
      // The remaining columns are dependences among the other rows.
      left = product(left, null_spaces(left.row(*row)).right);
    }
  }
  return repeated;
}

}  // namespace higherpair
