#include "chain_bounds.hpp"

#include "analysis/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace higherpair {
namespace {

double squared(double x) {
  return x * x;
}

// Smallest and largest radius of curvature: b²/a at the ends of the long axis, a²/b at those of the short
// one.
double sharpest(const Oval& oval) {
  return oval.along > 0 ? squared(oval.across) / oval.along : 0;
}

double flattest(const Oval& oval) {
  return oval.across > 0 ? squared(oval.along) / oval.across : 0;
}

struct PointBound {
  double speed = 0;
  double acceleration = 0;
};

PointBound bound_at(const MotionBound& body, const Vector2d& p_B) {
  const double r = (p_B - body.p_B).norm();
  return {body.speed + body.omega * r, body.acceleration + (body.alpha + squared(body.omega)) * r};
}

// A lower bound of the sine, given an upper bound of the |cosine|; none if the sine may be too small.
std::optional<double> least_sine(double cosine) {
  const double square_of_sine = 1 - squared(cosine);
  return cosine >= 0 && square_of_sine >= squared(kSafeSine) ? std::optional(std::sqrt(square_of_sine))
                                                             : std::nullopt;
}

class ChainBounds {
public:
  ChainBounds(double step, double size, std::vector<MotionBound>& bodies)
      : step_(step), chord_(squared(step) / 8), size_(size), bodies_(bodies) {}

  bool add(const DrivenBody& driven, const ChainWatch<double>& /*none*/) {
    const OneFreedom& freedom = driven.carried.freedom;
    MotionBound& body = at(driven.carried.body);
    body = {freedom.p_BO, freedom.turns ? 0.0 : 1.0, 0, freedom.turns ? 1.0 : 0.0, 0};
    return true;
  }

  // cos γ = (a² + b² - d²)/(2ab):  |d²(cos γ)| <= (V² + (a + b) A)/(ab) with V, A those of D = B - A.
  bool add(const RrrDyad& dyad, const ChainWatch<double>& watch) {
    const PointBound A = bound_of(dyad.A);
    const PointBound B = bound_of(dyad.B);
    const double speed = A.speed + B.speed;
    const double acceleration = A.acceleration + B.acceleration;
    const double a = dyad.length_a;
    const double b = dyad.length_b;
    const auto sine = least_sine(watch.margin + chord_ * (squared(speed) + (a + b) * acceleration) / (a * b));
    if (!sine) {
      return false;
    }
    const double omega_a = speed / (a * *sine);
    const double omega_b = speed / (b * *sine);
    const double pull = acceleration + a * squared(omega_a) + b * squared(omega_b);
    at(dyad.link_a) = {dyad.a_pA, A.speed, A.acceleration, omega_a, pull / (a * *sine)};
    at(dyad.link_b) = {dyad.b_pB, B.speed, B.acceleration, omega_b, pull / (b * *sine)};
    return turns_little(omega_a) && turns_little(omega_b);
  }

  // sin λ = -y/l, y = n·(A - P) with the line's normal n:  |ÿ| <= A + 2 ω V + (α + ω²) |A - P|.
  bool add(const RrpDyad& dyad, const ChainWatch<double>& watch) {
    const MotionBound line = at(dyad.line.body);
    const PointBound A = bound_of(dyad.A);
    const PointBound P = bound_at(line, dyad.line.p_B);
    const double speed = A.speed + P.speed;
    const double far = std::sqrt(watch.far2) + speed * step_;
    const double second =
        A.acceleration + P.acceleration + 2 * line.omega * speed + (line.alpha + squared(line.omega)) * far;
    const double l = dyad.length;
    const auto cosine = least_sine(watch.margin + chord_ * second / l);
    if (!cosine) {
      return false;
    }
    const double turning = (speed + line.omega * far) / (l * *cosine);
    const MotionBound link = {dyad.pA, A.speed, A.acceleration, line.omega + turning,
                              line.alpha + (second + l * squared(turning)) / (l * *cosine)};
    at(dyad.link) = link;
    if (dyad.slider) {
      ride(*dyad.slider, bound_at(link, dyad.pC));
    }
    return turns_little(link.omega);
  }

  // s² = d² - e²:  |d²(s²)| <= 2 (V² + d A).
  bool add(const RprDyad& dyad, const ChainWatch<double>& watch) {
    const PointBound A = bound_of(dyad.A);
    const PointBound B = bound_of(dyad.B);
    const double speed = A.speed + B.speed;
    const double acceleration = A.acceleration + B.acceleration;
    const double far = std::sqrt(watch.far2) + speed * step_;
    const double least2 = -watch.margin - chord_ * 2 * (squared(speed) + far * acceleration);
    if (!(least2 >= squared(kSafeSine * size_))) {
      return false;
    }
    const double s = std::sqrt(least2);
    const double offset = std::abs(slot_offset(dyad));
    const double omega = speed / s;
    const double sliding = speed + offset * omega;
    const double alpha = (acceleration + 2 * sliding * omega + offset * squared(omega)) / s;
    at(dyad.link) = {dyad.pA, A.speed, A.acceleration, omega, alpha};
    if (dyad.slider) {
      ride(*dyad.slider, B);
    }
    return turns_little(omega);
  }

  // n·(v2 - v1) = 0 gives the body's rate, n·(a2 - a1) = ω2 u2 - ω1 u1 - v_s φ̇ its acceleration, with u1 = z
  // ω_r + w2 v_s, u2 = z ω_r - w1 v_s, φ̇ = ω1 + w1 ω_r + w v_s of the equivalent link, and w1, w2 <= 1.
  // Between two rows |∂gap/∂q| is at least half of its value in them.
  bool add(const OvalContact& contact, const ChainWatch<double>& watch) {
    const double per_q = -watch.margin / 2;
    if (!(per_q > 0)) {
      return false;
    }
    const MotionBound& known = at(contact.touch.known);
    const OneFreedom& freedom = contact.touch.freedom;
    const PointBound joint = bound_at(at(contact.touch.carrier), freedom.p_WO);
    const PointBound center = bound_at(known, contact.on_known.center_B);
    const double reach = contact.on_known.along;
    const double v1 = center.speed + known.omega * reach;
    const double a1 = center.acceleration + (known.alpha + squared(known.omega)) * reach;
    const double arm =
        freedom.turns ? (contact.on_body.center_B - freedom.p_BO).norm() + contact.on_body.along : 0.0;
    const double rate = (v1 + joint.speed) / per_q;
    const double omega = freedom.turns ? rate : 0.0;
    const double sliding = v1 + joint.speed + (freedom.turns ? rate * arm : rate);
    const double turning = known.omega + omega;
    const double least = sharpest(contact.on_known) + sharpest(contact.on_body);
    const double z = std::min(flattest(contact.on_known), flattest(contact.on_body));
    const double along = z * turning + sliding;
    const double second = (a1 + joint.acceleration + squared(omega) * arm + turning * along +
                           sliding * (known.omega + turning + sliding / least)) /
                          per_q;
    at(contact.touch.body) = freedom.turns
                                 ? MotionBound{freedom.p_BO, joint.speed, joint.acceleration, rate, second}
                                 : MotionBound{freedom.p_BO, rate, second, 0, 0};
    return turns_little(omega);
  }

private:
  [[nodiscard]] MotionBound& at(int body) { return bodies_[body]; }
  [[nodiscard]] PointBound bound_of(const BodyPoint& point) { return bound_at(at(point.body), point.p_B); }

  void ride(const Rider& rider, const PointBound& point) {
    const MotionBound& carrier = at(rider.carrier);
    at(rider.body) = {rider.p_B, point.speed, point.acceleration, carrier.omega, carrier.alpha};
  }

  [[nodiscard]] bool turns_little(double omega) const { return omega * step_ <= kSafeTurn; }

  double step_;
  double chord_;  // step²/8
  double size_;   // of the mechanism
  std::vector<MotionBound>& bodies_;
};

}  // namespace

bool stays_on_branches(std::span<const ChainGroup> groups, std::span<const ChainWatch<double>> watches,
                       double step, double size, std::vector<MotionBound>& bounds) {
  ChainBounds all(step, size, bounds);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!std::visit([&](const auto& kind) { return all.add(kind, watches[g]); }, groups[g].kind)) {
      return false;
    }
  }
  return true;
}

bool presses_throughout(std::span<const double> forces) {
  if (forces.size() < 5) {
    return false;
  }
  const std::size_t last = forces.size() - 1;
  const auto dip = [&](std::size_t k) {
    const double* f = &forces[k];
    const double second = f[-1] - 2 * f[0] + f[1];
    const double fourth = f[-2] - 4 * f[-1] + 6 * f[0] - 4 * f[1] + f[2];
    return kForceDip * (std::abs(second) + std::abs(fourth));
  };
  // For the two rows next to an end, the differences of the third row from that end are used.
  bool presses = std::min(forces[0], forces[1]) > kForceDipAtEnd * dip(2) &&
                 std::min(forces[last], forces[last - 1]) > kForceDipAtEnd * dip(last - 2);
  for (std::size_t k = 2; presses && k + 2 <= last; ++k) {
    presses = std::min({forces[k - 1], forces[k], forces[k + 1]}) > dip(k);
  }
  return presses;
}

}  // namespace higherpair
