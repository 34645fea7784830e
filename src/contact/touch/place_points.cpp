#include "place_points.hpp"

#include "contact_points.hpp"

namespace higherpair {

bool place_points(const ContactPair& pair, ContactPosition& at) {
  const ContactPoints points = points_at(pair, place_pair(pair, at.u, at.q), at.n_W);
  at.n_W = points.n_W;
  if (points.exist) {
    static_cast<CommonNormal&>(at) = points;
  }
  return points.exist;
}

}  // namespace higherpair
