#include "higherpair/contact/finder.hpp"

#include "higherpair/contact/separation.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/newton.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "listed_contact.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

constexpr int kMaxListSteps = 2000;  // a list of all contacts costs no more than these

// Bound of the rate of the signed distance with q: the speed of the fastest point of a bounded body.
std::optional<double> speed_bound(const ContactPair& pair, double u) {
  if (!pair.motion2.turns) {
    return 1.0;
  }
  const auto reach1 = reach_from(pair.curve1, pose_at(pair.motion1, u).inverse_times(pair.motion2.p_WO));
  const auto reach2 = reach_from(pair.curve2, pair.motion2.p_BO);
  return reach1 && reach2 ? std::min(*reach1, *reach2) : reach1 ? reach1 : reach2;
}

Separation separation_at(const ContactPair& pair, double u, double q, double tolerance) {
  return separation(pair.curve1, pose_at(pair.motion1, u), pair.curve2, pose_at(pair.motion2, q), tolerance);
}

// The signed distance, to within a fraction of itself or `finest`.
struct Distance {
  Separation separation;
  double tolerance = 0;
};

Distance distance_at(const ContactPair& pair, double u, double q, double guess, double finest) {
  double tolerance = std::max(kRoughGap * guess, finest);
  for (;;) {
    const Separation here = separation_at(pair, u, q, tolerance);
    const double needed = std::max(kRoughGap * std::abs(here.gap), finest);
    if (!(tolerance > 4 * needed)) {
      return {here, tolerance};
    }
    tolerance = needed;
  }
}

// The contact of two nearly touching bodies near this position; none if they overlap there elsewhere.
std::optional<FindResult> touch(const ContactPair& pair, double u, double q, const Vector2d& n_W, int branch,
                                double size) {
  const ContactResult result = solve_contact(pair, u, q, n_W, branch);
  const double moved = std::abs(result.at.q - q) * (pair.motion2.turns ? 1 : 1 / size);
  if (result.status != ContactStatus::kOk || !(moved < kSameTouch) || !(result.step_n < kNewtonTurn)) {
    return std::nullopt;
  }
  const Separation check = separation_at(pair, u, result.at.q, kFineGap * size);
  if (!(std::abs(check.gap) <= kStillTouching * size)) {
    return std::nullopt;
  }
  return FindResult{FindStatus::kFound, result.at, branch};
}

// \param from_overlap  true: the bodies may overlap at the start; the result is then where they separate
// \param farthest  contacts farther than this from q are not wanted
FindResult search(const ContactPair& pair, double u, double q, int direction, bool from_overlap,
                  ListedContacts& listed, double farthest = kInf) {
  const double size = size_at(pair, u, q);
  const std::optional<double> bound = speed_bound(pair, u);
  if (!bound || listed.is_known()) {
    return listed.find(q, direction, from_overlap);
  }
  const double tolerance = kFineGap * size;
  const double range = std::min(pair.motion2.turns ? 2 * kPi : 1e6 * size, farthest);
  const double start = q;
  bool overlapping = false;
  double last_gap = size;
  for (int i = 0; std::abs(q - start) <= range; ++i) {
    if (i == kMaxListSteps) {
      return listed.find(start, direction, from_overlap);
    }
    const auto [here, error] = distance_at(pair, u, q, last_gap, tolerance);
    if (here.gap == -kInf) {
      if (from_overlap) {
        return listed.find(start, direction, from_overlap);
      }
      return {FindStatus::kOverlapAtStart, {}};
    }
    if (i == 0) {
      overlapping = here.gap < -kTouching * size;
      if (overlapping && !from_overlap) {
        return {FindStatus::kOverlapAtStart, {}};
      }
    }
    if (std::abs(here.gap) <= kTouching * size) {
      // Coming from a gap, the distance falls with q·direction; coming out of an overlap, it grows.
      const int branch = overlapping ? direction : -direction;
      if (const auto found = touch(pair, u, q, here.n_W, branch, size)) {
        return *found;
      }
      if (const auto other = i == 0 ? touch(pair, u, q, here.n_W, -branch, size) : std::nullopt) {
        return *other;
      }
    }
    last_gap = std::abs(here.gap);
    q += direction * std::max((last_gap - error) * (1 - kFineGap), kLeastApproach * size) / *bound;
  }
  return {FindStatus::kNoContact, {}};
}

}  // namespace

double distance_ahead(const OneFreedom& follower, double q, int direction, double contact, double near) {
  const double distance = direction * (contact - q);
  const double turn = 2 * kPi;
  const double ahead = follower.turns ? distance - turn * std::floor((distance + near) / turn) : distance;
  return ahead < 0 && ahead >= -near ? 0 : ahead;
}

FindResult find_contact(const ContactPair& pair, double u, double q, int direction) {
  ListedContacts listed(pair, u);
  return search(pair, u, q, direction, false, listed);
}

FindResult find_nearest_contact(const ContactPair& pair, double u, double q, std::optional<int> branch) {
  ListedContacts listed(pair, u);
  FindResult best;
  for (const int direction : {1, -1}) {
    const double farthest = best.status == FindStatus::kFound ? std::abs(best.at.q - q) : kInf;
    FindResult found = search(pair, u, q, direction, true, listed, farthest);
    if (pair.motion2.turns && !listed.is_known() && found.status == FindStatus::kNoContact &&
        best.status != FindStatus::kFound) {
      return found;  // there is none in a whole turn
    }
    if (found.status == FindStatus::kFound && branch && found.branch != *branch) {
      // The other end of the overlap, or of the gap, has the other sign.
      const double size = size_at(pair, u, found.at.q);
      const double beyond = direction * kBesideTouch * (pair.motion2.turns ? 1 : size);
      found = search(pair, u, found.at.q + beyond, direction, true, listed);
      if (found.branch != *branch) {
        found.status = FindStatus::kNoContact;
      }
    }
    if (best.status == FindStatus::kUnbounded) {
      break;
    }
    const bool better =
        found.status == FindStatus::kFound &&
        (best.status != FindStatus::kFound || std::abs(found.at.q - q) < std::abs(best.at.q - q));
    if (better || (best.status != FindStatus::kFound && direction == 1)) {
      best = found;
    }
  }
  return best;
}

}  // namespace higherpair
