#include "higherpair/dynamics/statics.hpp"

#include "higherpair/dynamics/tooth_force.hpp"
#include "higherpair/linkage/dyad_statics.hpp"
#include "higherpair/mechanism/condition_system.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "numeric/least_norm.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Records the first row of each item before `append` adds its rows.
template <class F>
void for_each_index(const std::vector<int>& items, std::vector<std::size_t>& first_rows,
                    const std::vector<ConstraintRow>& rows, F append) {
  for (const int index : items) {
    first_rows[index] = rows.size();
    append(static_cast<std::size_t>(index));
  }
}

Eigen::Vector3d scaled(const Eigen::Vector3d& wrench, double size) {
  return {wrench.x(), wrench.y(), wrench.z() / size};
}

}  // namespace

Statics::Statics(const Run& run)
    : size_(run.plan().size),
      contacts_may_part_(std::any_of(run.mechanism().contacts.begin(), run.mechanism().contacts.end(),
                                     [](const Contact& contact) { return contact.keep == Keep::kGap; })) {
  joint_rows_.resize(run.mechanism().joints.size());
  flanks_.assign(run.mechanism().joints.size(), 1);
  contact_rows_.resize(run.mechanism().contacts.size());
  driver_rows_.resize(run.mechanism().drivers.size());
  for (const Group& group : run.plan().groups) {
    held_.push_back(idle_bodies_of(run.plan(), group));
  }
  set_layout(run);
}

// The conditions are those of run.row; of drivers only the coefficients are needed, not the values.
void Statics::append_rows_of(const Run& run, std::size_t g) {
  const Mechanism& mechanism = run.mechanism();
  const Group& group = run.plan().groups[g];
  const std::vector<BodyMotion>& bodies = run.row.bodies;
  for_each_index(group.joints, joint_rows_, rows_, [&](std::size_t i) {
    const Joint& joint = mechanism.joints[i];
    append_rows(mechanism, joint, bodies, size_, rows_);
    if (joint.teeth) {
      rows_.back() = tooth_row(mechanism, joint, flanks_[i], bodies, size_);
    }
  });
  for_each_index(group.contacts, contact_rows_, rows_, [&](std::size_t i) {
    const ContactMotion& motion = run.row.contacts[i];
    if (motion.touches) {
      append_rows(mechanism, mechanism.contacts[i], motion, bodies, rows_);
    } else {  // the body is held on its joint
      const Joint& joint = mechanism.joints[group.joints.front()];
      append_driver_row(mechanism, joint, 0, bodies, size_, rows_);
    }
  });
  for_each_index(group.drivers, driver_rows_, rows_, [&](std::size_t i) {
    append_driver_row(mechanism, driven_joint(mechanism, i), 0, bodies, size_, rows_);
  });
  for (const int body : held_[g]) {
    rows_.push_back(angle_row(bodies, body, 0, size_));
  }
}

bool Statics::choose_flanks(const Mechanism& mechanism) {
  bool others = false;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const double carried = mechanism.joints[i].teeth ? multipliers_[joint_rows_[i]] : 0;
    if (carried * flanks_[i] < 0) {
      flanks_[i] = -flanks_[i];
      others = true;
    }
  }
  return others;
}

void Statics::set_layout(const Run& run) {
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    const Group& group = run.plan().groups[g];
    Block block;
    block.first_row = rows_.size();
    block.bodies = group.bodies;
    append_rows_of(run, g);
    block.row_count = rows_.size() - block.first_row;
    for (std::size_t i = 1; i <= held_[g].size(); ++i) {
      held_rows_.push_back(rows_.size() - i);
    }
    redundant_ = redundant_ || block.row_count != 3 * group.bodies.size();
    if (std::holds_alternative<RrrDyad>(group.kind)) {
      block.factors = pinned_dyad(block);
    } else if (group.bodies.size() == 2) {
      block.factors.emplace<Factors<Matrix6d>>(Matrix6d::Identity());
    } else if (group.bodies.size() > 2) {
      block.factors.emplace<Factors<Eigen::MatrixXd>>();
    }
    blocks_.push_back(std::move(block));
  }
  multipliers_.resize(rows_.size());
  determined_.assign(rows_.size(), true);
  set_columns();
}

void Statics::set_columns() {
  columns_.assign(rows_.size(), {-1, -1, -1});
  for (const Block& block : blocks_) {
    for (std::size_t i = block.first_row; i < block.first_row + block.row_count; ++i) {
      for (std::size_t k = 0; k < columns_[i].size(); ++k) {
        const auto found = std::find(block.bodies.begin(), block.bodies.end(), rows_[i].body[k]);
        if (found != block.bodies.end()) {
          columns_[i][k] = static_cast<int>(3 * (found - block.bodies.begin()));
        }
      }
    }
  }
}

void Statics::set_row(const Run& run) {
  rows_.clear();
  for (std::size_t g = 0; g < blocks_.size(); ++g) {
    append_rows_of(run, g);
  }
  if (contacts_may_part_) {
    set_columns();
  }
  if (redundant_) {
    factorise_all();
    return;
  }
  for (Block& block : blocks_) {
    std::visit(
        [&](auto& factors) {
          if constexpr (!std::is_same_v<decltype(factors), PinnedDyad&>) {
            factorise(block, factors);
          }
        },
        block.factors);
  }
}

Statics::PinnedDyad Statics::pinned_dyad(const Block& block) const {
  PinnedDyad dyad;
  for (std::size_t pin = block.first_row; pin < block.first_row + block.row_count; pin += 2) {
    const auto side_of = [&](int body) { return rows_[pin].body[0] == body ? 0U : 1U; };
    const auto joins = [&](int body) { return rows_[pin].body[side_of(body)] == body; };
    const bool is_inner = joins(block.bodies[0]) && joins(block.bodies[1]);
    for (std::size_t i = 0; i < 2; ++i) {
      if (joins(block.bodies[i])) {
        (is_inner ? dyad.inner : dyad.outer)[i] = {pin, side_of(block.bodies[i])};
      }
    }
  }
  return dyad;
}

void Statics::solve(const Block& block, const PinnedDyad& dyad, std::vector<Wrench>& wrenches) {
  // The force of a pin on the dyad's body is `sign` times its multipliers; it acts at `r` from the origin of
  // the body's frame.
  struct Pin {
    double sign;
    Vector2d r;
  };
  const auto pin_at = [&](const PinnedDyad::Pin& pin) {
    const Eigen::Vector3d& along_x = rows_[pin.row].coefficient[pin.side];
    const Eigen::Vector3d& along_y = rows_[pin.row + 1].coefficient[pin.side];
    return Pin{along_x.x(), along_x.x() * Vector2d(along_y.z(), -along_x.z())};
  };
  std::array<Vector2d, 2> arm, force;
  std::array<double, 2> moment{};  // about the outer pins
  std::array<double, 2> sign{}, outer_sign{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Wrench& wrench = wrenches[block.bodies[i]];
    const Pin outer = pin_at(dyad.outer[i]);
    const Pin inner = pin_at(dyad.inner[i]);
    force[i] = wrench.head<2>();
    arm[i] = inner.r - outer.r;
    sign[i] = inner.sign;
    outer_sign[i] = outer.sign;
    moment[i] = wrench.z() - cross(outer.r, force[i]);
  }
  const Vector2d at_inner = sign[0] * rrr_inner_force(arm[0], arm[1], moment[0], moment[1]);
  multipliers_[dyad.inner[0].row] = at_inner.x();
  multipliers_[dyad.inner[0].row + 1] = at_inner.y();
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t row = dyad.outer[i].row;
    const std::size_t known = 1 - dyad.outer[i].side;
    const Vector2d at_outer = -outer_sign[i] * (force[i] + sign[i] * at_inner);
    multipliers_[row] = at_outer.x();
    multipliers_[row + 1] = at_outer.y();
    wrenches[rows_[row].body[known]] +=
        at_outer.x() * rows_[row].coefficient[known] + at_outer.y() * rows_[row + 1].coefficient[known];
  }
}

template <class Matrix>
void Statics::factorise(const Block& block, Factors<Matrix>& factors) const {
  const auto n = static_cast<Eigen::Index>(block.row_count);
  Matrix A = Matrix::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t at = block.first_row + static_cast<std::size_t>(i);
    add_coefficients(
        rows_[at], size_, [&](std::size_t k) { return columns_[at][k]; }, A.col(i));
  }
  factors.compute(A);
}

template <class Matrix>
void Statics::solve(const Block& block, const Factors<Matrix>& factors, std::vector<Wrench>& wrenches) {
  constexpr int kSize = Matrix::RowsAtCompileTime;
  Eigen::Matrix<double, kSize, 1> b(static_cast<Eigen::Index>(block.row_count));
  for (std::size_t k = 0; k < block.bodies.size(); ++k) {
    b.template segment<3>(static_cast<Eigen::Index>(3 * k)) = -scaled(wrenches[block.bodies[k]], size_);
  }
  const Eigen::Matrix<double, kSize, 1> x = factors.solve(b);
  for (std::size_t i = 0; i < block.row_count; ++i) {
    const std::size_t at = block.first_row + i;
    multipliers_[at] = x(static_cast<Eigen::Index>(i));
    for (std::size_t k = 0; k < columns_[at].size(); ++k) {
      if (columns_[at][k] < 0) {
        wrenches[rows_[at].body[k]] += multipliers_[at] * rows_[at].coefficient[k];
      }
    }
  }
}

bool Statics::balance(std::vector<Wrench>& wrenches) {
  if (redundant_) {
    return solve_all(wrenches);
  }
  for (std::size_t g = blocks_.size(); g-- > 0;) {
    const Block& block = blocks_[g];
    std::visit([&](const auto& factors) { solve(block, factors, wrenches); }, block.factors);
  }
  return std::all_of(multipliers_.begin(), multipliers_.end(), [](double x) { return std::isfinite(x); });
}

double Statics::largest_multiplier() const {
  double largest = 0;
  for (const double multiplier : multipliers_) {
    largest = std::max(largest, std::abs(multiplier));
  }
  return largest;
}

Statics::Holding Statics::holding(std::size_t i) const {
  const ConstraintRow& held = rows_[held_rows_[i]];
  const int body = held.body[1];
  double largest = 0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (std::find(rows_[k].body.begin(), rows_[k].body.end(), body) != rows_[k].body.end()) {
      largest = std::max(largest, std::abs(multipliers_[k]));
    }
  }
  const double multiplier = multipliers_[held_rows_[i]];
  return {body, multiplier * held.coefficient[1].z(), std::abs(multiplier) > kHeldByRounding * largest};
}

void Statics::factorise_all() {
  Eigen::Index columns = 0;
  for (const Block& block : blocks_) {
    columns += 3 * static_cast<Eigen::Index>(block.bodies.size());
  }
  jacobian_ = jacobian_of(rows_, size_, columns, [](int body) { return 3 * (body - 1); });
  pseudoinverse_ = LeastNormSolver(jacobian_, kRepeatedConditions).pseudoinverse();
  // J J⁺ projects onto the multipliers that balance some load; what it removes from a unit multiplier is
  // undetermined.
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    determined_[i] = 1 - jacobian_.row(at).dot(pseudoinverse_.col(at)) <= kDetermined;
  }
}

bool Statics::solve_all(const std::vector<Wrench>& wrenches) {
  Eigen::VectorXd b(jacobian_.cols());
  for (std::size_t body = 1; body < wrenches.size(); ++body) {
    b.segment<3>(3 * (static_cast<Eigen::Index>(body) - 1)) = -scaled(wrenches[body], size_);
  }
  const Eigen::VectorXd x = pseudoinverse_.transpose() * b;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    multipliers_[i] = x(static_cast<Eigen::Index>(i));
  }
  const double left = (jacobian_.transpose() * x - b).lpNorm<Eigen::Infinity>();
  return left <= kBalancedWrenches * b.lpNorm<Eigen::Infinity>();
}

}  // namespace higherpair
