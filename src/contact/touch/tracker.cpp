#include "higherpair/contact/tracker.hpp"

#include "higherpair/contact/step_agreement.hpp"
#include "higherpair/contact/step_length.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "inner_step.hpp"

#include <cmath>
#include <limits>

namespace higherpair {
namespace {

// Whether the normal has turned as predicted, to within a fraction of the step's change.
bool normal_agrees(const ContactTrack& track, const Step& step, double h, double share) {
  return is_as_predicted((step.result.at.n_W - predicted_normal(track, h)).norm(), step.change, share);
}

}  // namespace

ContactTrack start_track(const ContactPair& pair, const ContactPosition& at, int branch) {
  ContactTrack track;
  track.pair = pair;
  track.branch = branch;
  track.at = at;
  track.phi = angle_of(at.n_W);
  const Vector2d& p = at.p1_W;
  const double radius1 = std::abs(at.rho1);
  const double radius2 = std::abs(at.rho2);
  const double radii = is_line(pair.curve1) || is_line(pair.curve2) ? radius1 + radius2
                                                                    : radius1 * radius2 / (radius1 + radius2);
  track.size = (p - pair.motion1.p_WO).norm() + (p - pair.motion2.p_WO).norm() + radii +
               std::numeric_limits<double>::min();
  return track;
}

ContactStatus step_to(ContactTrack& track, double u, int branch) {
  const Step step = try_step(track, u - track.at.u, branch);
  if (!step.solved) {
    return step.result.status == ContactStatus::kOk ? ContactStatus::kOtherBranch : step.result.status;
  }
  accept(track, step.result.at, branch);
  track.at.u = u;
  return ContactStatus::kOk;
}

bool walk_to(ContactTrack& track, double u, bool may_cross) {
  const double unit = unit_of(track.pair.motion1, track);
  StepLength length(kLargestTurn * unit);
  while (track.at.u != u) {
    const auto [h, last] = length.next(u - track.at.u);
    const bool crosses = may_cross && (track.at.gap_q + track.at.dgap_q * h) * track.at.gap_q < 0;
    const int branch = crosses ? -track.branch : track.branch;
    const double agreement = crosses ? kCrossingAgreement : kWalkAgreement;
    const Step step = try_step(track, h, branch);
    const bool strays = may_cross && turns_back(track.at, step.result.at, h);
    if (agrees(step, agreement) && normal_agrees(track, step, h, agreement) && !strays) {
      accept(track, step.result.at, branch);
      track.at.u = last ? u : track.at.u;
      length.taken();
      continue;
    }
    length.refused(h);
    if (length.value() < shortest_step(unit, u)) {
      return false;
    }
  }
  return true;
}

}  // namespace higherpair
