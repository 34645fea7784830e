#include "free_assembly.hpp"
#include "free_directions.hpp"
#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "idle_turning.hpp"
#include "numeric/least_norm.hpp"
#include "numeric/product.hpp"
#include "redundancy.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace higherpair {
namespace {

// The remaining motions: orthonormal directions, and the size below which components are not significant.
struct Freedom {
  Eigen::MatrixXd directions;
  double floor = kMoves;
};

Eigen::MatrixXd without_rows(const Eigen::MatrixXd& matrix, Eigen::Index begin, Eigen::Index count) {
  Eigen::MatrixXd rest(matrix.rows() - count, matrix.cols());
  rest << matrix.topRows(begin), matrix.bottomRows(matrix.rows() - begin - count);
  return rest;
}

// The only direction in which a body can move alone (x, y, size·θ), if there is just one.
std::optional<Eigen::Vector3d> motion_alone(const Freedom& freedom, int body) {
  const Eigen::Index row = column_of(body);
  const NullSpaces others = null_spaces(without_rows(freedom.directions, row, 3), freedom.floor);
  if (others.right.cols() != 1) {
    return std::nullopt;
  }
  return Eigen::Vector3d(freedom.directions.middleRows(row, 3) * others.right.col(0));
}

std::vector<IdleFreedom> idle_freedoms(const SizedMechanism& sized, const Freedom& freedom,
                                       const MechanismPosition& position, const MechanismPosition& start) {
  std::vector<IdleFreedom> idle;
  if (freedom.directions.cols() == 0) {
    return idle;
  }
  for (int b = 1; b < static_cast<int>(sized.mechanism.bodies.size()); ++b) {
    if (freedom.directions.middleRows(column_of(b), 3).norm() < kMoves) {
      continue;
    }
    const auto motion = motion_alone(freedom, b);
    if (!motion || std::abs(motion->z()) < kMoves) {
      continue;
    }
    // v + ω ẑ×r = 0 at the centre.
    const Vector2d r_W = perp(Vector2d(motion->head<2>())) * (sized.size / motion->z());
    const auto body = static_cast<std::size_t>(b);
    const Vector2d p_B = position.bodies[body].X_WB.R_WB.inverse() * r_W;
    if (turns_idly(sized, b, p_B)) {
      idle.push_back({b, start.bodies[body].X_WB * p_B});
    }
  }
  return idle;
}

// Drivers that are useless because those before them determine their joints already. Directions are unit
// vectors and rows have coefficients of the order of 1, so the floor is absolute.
std::vector<int> useless_drivers(const Eigen::MatrixXd& rates, double floor) {
  std::vector<int> useless;
  Eigen::MatrixXd kept(0, rates.cols());
  for (Eigen::Index i = 0; i < rates.rows(); ++i) {
    Eigen::MatrixXd more(kept.rows() + 1, rates.cols());
    more << kept, rates.row(i);
    if (rank_of(more, floor) > rank_of(kept, floor)) {
      kept = std::move(more);
    } else {
      useless.push_back(static_cast<int>(i));
    }
  }
  return useless;
}

// Joints that could be driven, because their coordinates still move.
std::vector<int> moving_joints(const SizedMechanism& sized, const Freedom& freedom,
                               const MechanismPosition& position) {
  Mechanism probe = sized.mechanism;
  probe.drivers.clear();
  for (std::size_t i = 0; i < probe.joints.size(); ++i) {
    if (can_be_driven(probe.joints[i].type)) {
      probe.drivers.push_back({"", static_cast<int>(i)});
    }
  }
  const Eigen::MatrixXd rates = product(driver_rows({probe, sized.size}, position), freedom.directions);
  std::vector<int> joints;
  for (Eigen::Index i = 0; i < rates.rows(); ++i) {
    if (rates.row(i).norm() > freedom.floor) {
      joints.push_back(probe.drivers[i].joint);
    }
  }
  return joints;
}

bool is_idle(const Mobility& mobility, int body) {
  return std::any_of(mobility.idle.begin(), mobility.idle.end(),
                     [&](const IdleFreedom& idle) { return idle.body == body; });
}

// Finds which drivers are useless and what still moves with all drivers held.
void judge_drivers(const SizedMechanism& sized, const Freedom& all, const MechanismPosition& start,
                   const MechanismPosition& position, Mobility& mobility) {
  const Eigen::MatrixXd rates = product(driver_rows(sized, position), all.directions);
  mobility.useless_drivers = useless_drivers(rates, all.floor);
  const Freedom left{product(all.directions, null_spaces(rates, all.floor).right), all.floor};
  mobility.idle = idle_freedoms(sized, left, position, start);
  mobility.missing_drivers =
      static_cast<int>(left.directions.cols()) - static_cast<int>(mobility.idle.size());
  if (mobility.missing_drivers == 0) {
    return;
  }
  for (int b = 1; b < static_cast<int>(sized.mechanism.bodies.size()); ++b) {
    if (!is_idle(mobility, b) && left.directions.middleRows(column_of(b), 3).norm() > left.floor) {
      mobility.loose_bodies.push_back(b);
    }
  }
  for (const int joint : moving_joints(sized, left, position)) {
    const Joint& candidate = sized.mechanism.joints[joint];
    if (!is_idle(mobility, candidate.first.body) && !is_idle(mobility, candidate.second.body)) {
      mobility.joints_to_drive.push_back(joint);
    }
  }
}

// Rate of a driver at the start [rad/s or m/s]: the given one. A single driver that starts from rest has rate
// 1: the instant centres are the same for any other.
double rate_at_start(const MobilityQuestion& question, std::size_t driver) {
  const std::vector<double>& given = question.velocities;
  return given.empty() || (given.size() == 1 && given.front() == 0) ? 1 : given[driver];
}

// Velocities at the start for the rates of the drivers; the solution of least norm, so that idle bodies are
// at rest.
std::vector<BodyMotion> moving_bodies(const SizedMechanism& sized, const MobilityQuestion& question,
                                      const MechanismPosition& start) {
  const LinearConditions conditions = conditions_at(sized, {}, start);
  const Eigen::MatrixXd drivers = driver_rows(sized, start);
  Eigen::MatrixXd J(conditions.J.rows() + drivers.rows(), conditions.J.cols());
  J << conditions.J, drivers;
  Eigen::VectorXd rates = Eigen::VectorXd::Zero(J.rows());
  for (Eigen::Index i = 0; i < drivers.rows(); ++i) {
    const auto driver = static_cast<std::size_t>(i);
    const bool turns = driven_joint(sized.mechanism, driver).type == JointType::kRevolute;
    rates(conditions.J.rows() + i) = rate_at_start(question, driver) * (turns ? sized.size : 1);
  }
  const Eigen::VectorXd solved = LeastNormSolver(J, kRankFloor).solve(rates);
  // A driver at its dead point moves nothing.
  if (!((J * solved - rates).norm() <= kDriversMove * rates.norm())) {
    return {};
  }
  std::vector<BodyMotion> bodies = start.bodies;
  for (std::size_t b = 1; b < bodies.size(); ++b) {
    const Eigen::Index column = column_of(static_cast<int>(b));
    bodies[b].v_WB = solved.segment<2>(column);
    bodies[b].omega = solved(column + 2) / sized.size;
  }
  return bodies;
}

void analyse_at(const SizedMechanism& sized, const MobilityQuestion& question, const MechanismPosition& start,
                Mobility& mobility) {
  Moves moves = explore(sized, start);
  mobility.conditions = static_cast<int>(moves.here.left.rows());
  mobility.rank = moves.at_best.rank;
  mobility.positions = moves.positions;
  mobility.start_freedom = static_cast<int>(moves.here.right.cols());
  const auto null_space = moves.at_best.right.cols();
  const bool shaky = moves.real.cols() < null_space;
  Freedom freedom{moves.at_best.right, kMoves};
  if (shaky) {
    // Directions are needed at the position at which the rank was determined.
    freedom = {moves.positions > 1 ? explore(sized, moves.best).real : moves.real, kMovesShaky};
  }
  mobility.freedom = static_cast<int>(freedom.directions.cols());
  mobility.shaky = static_cast<int>(null_space) - mobility.freedom;
  mobility.singular = mobility.start_freedom > mobility.freedom;
  mobility.redundancies = find_redundancies(sized, moves.best, moves.at_best.left);
  judge_drivers(sized, freedom, start, moves.best, mobility);
  if (mobility.missing_drivers == 0) {
    mobility.moving = moving_bodies(sized, question, start);
  }
}

// The counts of bodies, joints and contacts for the mobility formula.
MobilityCount count_mobility(const Mechanism& mechanism) {
  MobilityCount count;
  count.bodies = static_cast<int>(mechanism.bodies.size());
  for (const Joint& joint : mechanism.joints) {
    switch (joint.type) {
      case JointType::kRevolute:
        ++count.revolutes;
        break;
      case JointType::kPrismatic:
        ++count.prismatics;
        break;
      case JointType::kSlot:
        ++count.slots;
        break;
      case JointType::kGears:
        ++count.gears;
        break;
      case JointType::kBelt:
        ++count.belts;
        break;
    }
  }
  for (const Contact& contact : mechanism.contacts) {
    ++(contact.rolling ? count.rolling : count.slipping);
  }
  return count;
}

}  // namespace

Mobility analyse_mobility(const Mechanism& mechanism, const MobilityQuestion& question) {
  Mobility mobility;
  mobility.count = count_mobility(mechanism);
  mobility.drivers_held = question.start || !question.drivers.empty();
  std::optional<MechanismPosition> start = question.start ? assemble_near(mechanism, *question.start)
                                                          : assemble_near_poses(mechanism, question.drivers);
  if (!start && mobility.drivers_held) {
    mobility.drivers_held = false;
    start = assemble_near_poses(mechanism, {});
  }
  if (!start) {
    return mobility;
  }
  mobility.assembled = true;
  mobility.start = start->bodies;
  analyse_at({mechanism, size_of(mechanism)}, question, *start, mobility);
  return mobility;
}

}  // namespace higherpair
