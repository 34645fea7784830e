#include "force_columns.hpp"

#include <algorithm>
#include <utility>

namespace higherpair {

ForceColumns::ForceColumns(const Run& run, std::vector<Preload> preloads)
    : statics_(run),
      preloads_(std::move(preloads)),
      damped_(std::any_of(run.mechanism().springs.begin(), run.mechanism().springs.end(),
                          [](const Spring& spring) { return spring.damping != 0; })),
      values_(run.mechanism().contacts.size() * count()),
      known_(run.mechanism().contacts.size()),
      largest_(count()) {}

bool ForceColumns::solve(const Run& run) {
  const Mechanism& mechanism = run.mechanism();
  const MotionRow& row = run.row;
  if (row.status == RowStatus::kNotAssemblable || !row.all_rates) {
    return false;
  }
  statics_.set_row(run);
  // Only closed contacts can open, and not those with a wall on either side.
  for (std::size_t i = 0; i < known_.size(); ++i) {
    known_[i] = row.contacts[i].touches && !mechanism.contacts[i].both_sides;
  }
  still_ = row.bodies;
  for (BodyMotion& body : still_) {
    body.v_WB.setZero();
    body.omega = 0;
  }
  const std::vector<Wrench> none(row.bodies.size(), Wrench(Wrench::Zero()));
  wrenches_ = none;
  add_applied(mechanism, still_, wrenches_);
  rest_ = wrenches_;
  bool balanced = take(0);
  wrenches_ = none;
  if (damped_) {
    add_applied(mechanism, row.bodies, wrenches_);
    for (std::size_t i = 0; i < wrenches_.size(); ++i) {
      wrenches_[i] -= rest_[i];
    }
  }
  balanced = balanced && take(1);
  wrenches_ = none;
  add_inertia(mechanism, row.bodies, wrenches_);
  balanced = balanced && take(2);
  for (std::size_t k = 0; k < preloads_.size() && balanced; ++k) {
    wrenches_ = none;
    const auto index = static_cast<std::size_t>(preloads_[k].index);
    if (preloads_[k].on == Preload::On::kSpring) {
      add_tension(mechanism, mechanism.springs[index], 1, row.bodies, wrenches_);
    } else {
      add_joint_effort(mechanism, mechanism.joints[index], 1, row.bodies, wrenches_);
    }
    balanced = take(ForcePiece::kParts + k);
  }
  return balanced;
}

bool ForceColumns::take(std::size_t column) {
  if (!statics_.balance(wrenches_)) {
    return false;
  }
  largest_[column] = statics_.largest_multiplier();
  for (std::size_t contact = 0; contact < known_.size(); ++contact) {
    const std::size_t row = statics_.contact_row(contact);
    known_[contact] = known_[contact] && statics_.is_determined(row);
    values_[contact * count() + column] = statics_.multiplier(row);
  }
  return true;
}

}  // namespace higherpair
