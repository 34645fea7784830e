#include "boundary_search.hpp"

#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/geometry/polyline.hpp"

#include <algorithm>
#include <cmath>

// All contacts of two boundaries, as common points of two plane curves that are sampled.

namespace higherpair {
namespace {

// Makes angles continuous along the boundary.
class Unwrapped {
public:
  double operator()(const Vector2d& n) {
    last_ = known_ ? nearest_turn(angle_of(n), last_) : angle_of(n);
    known_ = true;
    return last_;
  }

private:
  double last_ = 0;
  bool known_ = false;
};

// \param sense  +1 for body 1, -1 for body 2, whose normals are reversed
Features features_of(const Boundary& boundary, const Pose<double>& X_WB, const OneFreedom& follower,
                     double sense, double scale) {
  Features features;
  Unwrapped angle;
  for (const auto& [place, point] : boundary.samples()) {
    const Vector2d n = X_WB.R_WB * point.n_B;
    const Vector2d m = X_WB * point.p_B - follower.p_WO;
    const Vector2d at = follower.turns
                            ? Vector2d(sense * m.dot(n), sense * m.dot(perp(n)))
                            : Vector2d(scale * angle(sense * n), m.dot(perp(follower.direction_W)));
    features.push_back({at, place});
  }
  return features;
}

// The follower's coordinate that brings a place of body 2 to one of body 1: opposes their normals if it
// turns, else closes their distance along the slide.
double coordinate_of(const BoundaryPair& pair, const Pose<double>& X_W1, const BoundaryPlace& place1,
                     const BoundaryPlace& place2) {
  const SpanPoint one = pair.boundary1->at(place1);
  const SpanPoint two = pair.boundary2->at(place2);
  if (pair.motion2.turns) {
    return principal_angle(angle_of(-(X_W1.R_WB * one.n_B)) - angle_of(two.n_B));
  }
  const Pose<double> at_zero = pose_at(pair.motion2, 0);
  return (X_W1 * one.p_B - at_zero * two.p_B).dot(pair.motion2.direction_W);
}

bool is_known(const std::vector<BoundaryContact>& contacts, const BoundaryContact& contact,
              const OneFreedom& motion2, double size) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const BoundaryContact& known) {
    return coordinate_distance(motion2, size, known.q, contact.q) <= kSameFound &&
           (known.at.p1_W - contact.at.p1_W).norm() <= kSameFoundPoint * size;
  });
}

}  // namespace

std::optional<BoundaryContact> contact_between(const BoundaryPair& pair, double u,
                                               const BoundaryPlace& place1, const BoundaryPlace& place2) {
  const double guess = coordinate_of(pair, pose_at(pair.motion1, u), place1, place2);
  BoundaryResult solved = solve_boundary_contact(pair, u, guess, place1, place2, 0);
  if (solved.status != ContactStatus::kOk) {
    return std::nullopt;
  }
  if (pair.motion2.turns) {
    solved.contact.q = principal_angle(solved.contact.q);
  }
  return solved.contact;
}

std::vector<BoundaryContact> contacts_at_crossings(const BoundaryPair& pair, double u) {
  const double scale = std::max(pair.boundary1->size(), pair.boundary2->size());
  const Polyline curve1(features_of(*pair.boundary1, pose_at(pair.motion1, u), pair.motion2, 1, scale));
  const Polyline curve2(features_of(*pair.boundary2, pose_at(pair.motion2, 0), pair.motion2, -1, scale));
  std::vector<BoundaryContact> contacts;
  const auto look = [&](const Pose<double>& X_12) {
    for (const PolylineCrossing& at : polyline_crossings(curve1, curve2, X_12)) {
      if (auto contact = contact_between(pair, u, at.places[0], at.places[1])) {
        contacts.push_back(*std::move(contact));
      }
    }
  };
  if (pair.motion2.turns) {
    look({});
    return contacts;
  }
  // The first coordinate is an angle: the second curve repeats itself at every turn.
  const double turn = 2 * kPi * scale;
  const PartBox &box1 = curve1.node(0).box, &box2 = curve2.node(0).box;
  const double last = std::floor((box1.max().x() - box2.min().x()) / turn);
  for (double k = std::ceil((box1.min().x() - box2.max().x()) / turn); k <= last; ++k) {
    look({{}, Vector2d(k * turn, 0)});
  }
  return contacts;
}

bool is_proper(const BoundaryContact& contact) {
  const EquivalentLink link = link_at(contact.at);
  return contact.gap_q != 0 && std::isfinite(link.z) && link.z >= 0;
}

void sort_by_coordinate(std::vector<BoundaryContact>& contacts) {
  std::sort(contacts.begin(), contacts.end(),
            [](const BoundaryContact& a, const BoundaryContact& b) { return a.q < b.q; });
}

std::vector<BoundaryContact> find_boundary_contacts(const BoundaryPair& pair, double u) {
  const double scale = std::max(pair.boundary1->size(), pair.boundary2->size());
  std::vector<BoundaryContact> contacts;
  for (const BoundaryContact& found : contacts_at_crossings(pair, u)) {
    if (is_proper(found) && !is_known(contacts, found, pair.motion2, scale)) {
      contacts.push_back(found);
    }
  }
  sort_by_coordinate(contacts);
  return contacts;
}

}  // namespace higherpair
