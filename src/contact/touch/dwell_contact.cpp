#include "higherpair/contact/dwell_contact.hpp"

#include "higherpair/contact/common_normal.hpp"
#include "higherpair/contact/gap_scale.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/geometry/curve_queries.hpp"

#include <cmath>

namespace higherpair {

bool moves_in_itself(const Curve& curve, const OneFreedom& motion) {
  return motion.turns ? is_centered_at(curve, motion.p_BO, size_of(curve) + motion.p_BO.norm())
                      : slides_along_itself(curve, motion.R_WB, motion.direction_W);
}

std::optional<DwellContact> dwell_contact(const ContactPair& pair, double u, double q, double tolerance) {
  const auto& [curve1, motion1, curve2, motion2] = pair;
  if (!moves_in_itself(curve1, motion1)) {
    return std::nullopt;
  }
  const Pose<double> X_W1 = pose_at(motion1, u);
  const Pose<double> X_W2 = pose_at(motion2, q);
  const auto touch =
      find_common_normal(curve1, X_W1, curve2, X_W2, separation(curve1, X_W1, curve2, X_W2, tolerance).n_W);
  if (!touch || !(std::abs(touch->gap()) <= tolerance)) {
    return std::nullopt;
  }
  DwellContact dwell;
  ContactPosition& at = dwell.at;
  at.u = u;
  at.q = q;
  static_cast<CommonNormal&>(at) = *touch;
  at.sliding = -velocity_per_q(motion1, at.p1_W).dot(perp(at.n_W));
  at.gap_q = at.n_W.dot(velocity_per_q(motion2, at.p2_W));
  return gap_q_may_vanish(pair, at) ? std::optional(dwell) : std::nullopt;
}

}  // namespace higherpair
