#include "listed_contact.hpp"

#include "contact/touch/place_points.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <limits>

namespace higherpair {

double size_at(const ContactPair& pair, double u, double q) {
  const Vector2d p1 = pose_at(pair.motion1, u) * anchor(pair.curve1);
  const Vector2d p2 = pose_at(pair.motion2, q) * anchor(pair.curve2);
  return (p1 - p2).norm() + (p1 - pair.motion1.p_WO).norm() + (p2 - pair.motion2.p_WO).norm() +
         std::min(size_of(pair.curve1), size_of(pair.curve2)) + std::numeric_limits<double>::min();
}

FindResult ListedContacts::find(double q, int direction, bool from_overlap) {
  const ContactPair& pair = pair_;
  const double u = u_;
  if (!list_) {
    list_ = find_free_contacts(pair, u);
  }
  if (list_->status == ContactsStatus::kTangentAtInfinity) {
    return {FindStatus::kUnbounded, {}};
  }
  const Pose<double> X_W1 = pose_at(pair.motion1, u);
  const Pose<double> X_W2 = pose_at(pair.motion2, q);
  const double size = size_at(pair, u, q);
  const Separation here = separation(pair.curve1, X_W1, pair.curve2, X_W2, kFineGap * size);
  const bool overlapping = here.gap < -kTouching * size;
  if (overlapping && !from_overlap) {
    return {FindStatus::kOverlapAtStart, {}};
  }
  // Coming from a gap, the distance falls with q·direction; coming out of an overlap, it grows.
  const int branch = overlapping ? direction : -direction;
  FindResult result;
  double shortest = kInf;
  for (const CurveContact& contact : list_->contacts) {
    const double distance =
        distance_ahead(pair.motion2, q, direction, contact.q, kTouching * (pair.motion2.turns ? 1 : size));
    if (!contact.free || !(distance >= 0) || !(distance < shortest)) {
      continue;
    }
    if (contact.branch == 0 && !contact.coincident) {
      ContactPosition at;
      at.u = u;
      at.q = q + direction * distance;
      at.n_W = contact.n_W;
      if (place_points(pair, at)) {
        shortest = distance;
        result = {FindStatus::kFound, at, 0};
      }
      continue;
    }
    if (contact.branch != branch) {
      continue;
    }
    const ContactResult solved =
        solve_contact(pair, u, q + direction * distance, contact.n_W, contact.branch);
    if (solved.status == ContactStatus::kOk) {
      shortest = distance;
      result = {FindStatus::kFound, solved.at, contact.branch};
    }
  }
  return result;
}

}  // namespace higherpair
