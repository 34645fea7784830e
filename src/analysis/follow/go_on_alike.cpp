#include "higherpair/analysis/go_on_alike.hpp"

#include "analysis/tolerances.hpp"
#include "events.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "path_events.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

template <class T, class Alike>
bool all_alike(const std::vector<T>& a, const std::vector<T>& b, const Alike& alike) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), alike);
}

bool have_same_item(const std::optional<RunEvent>& a, const std::optional<RunEvent>& b) {
  return a.has_value() == b.has_value() && (!a || is_same_item(*a, *b));
}

bool on_same_branch(const State& a, const State& b) {
  const auto same_mode = [](const GroupState& one, const GroupState& other) {
    return one.mode == other.mode && one.open == other.open;
  };
  const auto same_kind = [](const PairTrack& one, const PairTrack& other) {
    return one.index() == other.index();
  };
  // Same spans, and the same side of where curvatures are equal.
  const auto same_contact = [](const ContactMotion& one, const ContactMotion& other) {
    const bool same_place =
        one.place[0].span == other.place[0].span && one.place[1].span == other.place[1].span;
    const bool same_curves = (one.at.rho1 > 0) == (other.at.rho1 > 0) &&
                             (one.at.rho2 > 0) == (other.at.rho2 > 0) &&
                             (one.at.rho1 + one.at.rho2 > 0) == (other.at.rho1 + other.at.rho2 > 0);
    return one.touches == other.touches && (!one.touches || (same_place && same_curves));
  };
  return all_alike(a.groups, b.groups, same_mode) && all_alike(a.tracks, b.tracks, same_kind) &&
         all_alike(a.contacts, b.contacts, same_contact);
}

bool at_same_place(const State& a, const State& b, double size) {
  const double near = kSameRunPosition * size;
  const auto same_pose = [&](const BodyMotion& one, const BodyMotion& other) {
    return (one.X_WB.p_WB - other.X_WB.p_WB).norm() <= near &&
           std::abs(one.theta - other.theta) <= kSameRunPosition;
  };
  const auto same_normal = [&](const ContactMotion& one, const ContactMotion& other) {
    return !one.touches || std::abs(one.phi - other.phi) <= kSameRunPosition;
  };
  return all_alike(a.bodies, b.bodies, same_pose) && all_alike(a.contacts, b.contacts, same_normal);
}

// The positions of the last row; none where it could not be reached.
const State* row_of(const Run& run) {
  return run.at.on_branch ? &run.at.shown() : nullptr;
}

bool is_lost_alike(const Run& a, const Run& b) {
  if (!have_same_item(a.at.lost.event, b.at.lost.event)) {
    return false;
  }
  for (std::size_t i = 0; i < a.at.lost.at.size(); ++i) {
    const double one = a.at.lost.at[i];
    if (std::abs(one - b.at.lost.at[i]) > kSameRunPosition * (input_scale(a, i) + std::abs(one))) {
      return false;
    }
  }
  return true;
}

bool has_alike_past(const Run& a, const Run& b) {
  const auto in_stroke = [](const Run& run, const OutputJoint& output) {
    const Joint& joint = run.mechanism().joints[output.joint];
    return is_stroke(run, output, joint_motion(run.mechanism(), joint, run.at.state.bodies).position);
  };
  const auto same_stroke = [&](const OutputJoint& one, const OutputJoint& other) {
    return one.sense == other.sense && in_stroke(a, one) == in_stroke(b, other);
  };
  const auto same_watch = [](const OverlapWatch& one, const OverlapWatch& other) {
    return one.overlaps == other.overlaps && one.interrupted == other.interrupted;
  };
  const auto same_event = [&](const RunEvent& one, const RunEvent& other) {
    return is_same_item(one, other) && is_at_same_drivers(a, one, other, kSameRunPosition);
  };
  return all_alike(a.at.outputs, b.at.outputs, same_stroke) &&
         all_alike(a.at.watches, b.at.watches, same_watch) &&
         all_alike(a.at.reported, b.at.reported, same_event) &&
         have_same_item(a.at.limit_here, b.at.limit_here);
}

}  // namespace

bool go_on_alike(const Run& a, const Run& b) {
  const State* row = row_of(a);
  const State* other = row_of(b);
  if (a.at.curve != b.at.curve || a.at.targets != b.at.targets || (row == nullptr) != (other == nullptr) ||
      a.at.beside.has_value() != b.at.beside.has_value()) {
    return false;
  }
  const bool same_row = row == nullptr
                            ? is_lost_alike(a, b)
                            : on_same_branch(*row, *other) && at_same_place(*row, *other, a.plan().size);
  return same_row && on_same_branch(a.at.state, b.at.state) && has_alike_past(a, b);
}

}  // namespace higherpair
