#include "listed_contact.hpp"

#include "higherpair/contact/separation.hpp"
#include "limit.hpp"

#include <cmath>

namespace higherpair {
namespace {

constexpr double kTouching = 1e-9;  // of the size: a start as near as this to a contact is that contact

// How far the follower moves from q in the sense of `direction` to a contact; a turning one less than a turn.
double way_to(const ContactPair& pair, double q, int direction, const CurveContact& contact) {
  const double way = direction * (contact.q - q);
  if (!pair.motion2.turns) {
    return way < 0 && way > -kTouching * std::abs(q) ? 0 : way;
  }
  const double turn = 2 * kPi;
  const double rest = way - turn * std::floor(way / turn);
  return rest > turn * (1 - kTouching) ? rest - turn : rest;
}

}  // namespace

FindResult ListedContacts::find(double q, int direction, bool from_overlap) {
  const ContactPair& pair = pair_;
  const double u = u_;
  FindResult result;
  if (!list_) {
    list_ = find_curve_contacts(pair, u);
  }
  if (list_->status == ContactsStatus::kTangentAtInfinity) {
    result.status = FindStatus::kUnbounded;
    return result;
  }
  const Pose<double> X_W1 = pose_at(pair.motion1, u);
  const Pose<double> X_W2 = pose_at(pair.motion2, q);
  const double size = (X_W1 * pair.curve1.vertex_B - X_W2 * pair.curve2.vertex_B).norm() +
                      pair.curve1.semi_latus + pair.curve2.semi_latus;
  const Separation here = separation(pair.curve1, X_W1, pair.curve2, X_W2, 1e-12 * size);
  const bool overlapping = here.gap < -kTouching * size;
  if (overlapping && !from_overlap) {
    result.status = FindStatus::kOverlapAtStart;
    return result;
  }
  // Coming from the gap the distance falls with q·direction; out of an overlap it grows.
  const int branch = overlapping ? direction : -direction;
  double shortest = INFINITY;
  for (const CurveContact& contact : list_->contacts) {
    const double way = way_to(pair, q, direction, contact);
    if (!contact.free || !(way >= -kTouching) || !(way < shortest)) {
      continue;
    }
    if (contact.branch == 0 && !contact.coincident) {
      ContactPosition at;
      at.u = u;
      at.q = q + direction * way;
      at.n_W = contact.n_W;
      if (place_points(pair, at)) {
        shortest = way;
        result = {FindStatus::kFound, at, 0};
      }
      continue;
    }
    if (contact.branch != branch) {
      continue;
    }
    const ContactResult solved = solve_contact(pair, u, q + direction * way, contact.n_W, contact.branch);
    if (solved.status == ContactStatus::kOk) {
      shortest = way;
      result = {FindStatus::kFound, solved.at, contact.branch};
    }
  }
  return result;
}

}  // namespace higherpair
