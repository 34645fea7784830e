#include "chain_bounds.hpp"

#include <cmath>
#include <optional>

namespace higherpair {
namespace {

// A sine smaller than this is near a limit; steps of a run take a crossing into account from 1e-3 on.
constexpr double kLeastSine = 0.02;
// A body that turns further from one position to the next might be whole turns off.
constexpr double kSafeTurn = 2;

double squared(double x) {
  return x * x;
}

struct PointBound {
  double speed = 0;
  double acceleration = 0;
};

PointBound bound_at(const MotionBound& body, const Vector2d& p_B) {
  const double r = (p_B - body.p_B).norm();
  return {body.speed + body.omega * r, body.acceleration + (body.alpha + squared(body.omega)) * r};
}

// The sine of which this is a bound of the |cosine|; none where it may be too small.
std::optional<double> least_sine(double cosine) {
  const double square_of_sine = 1 - squared(cosine);
  return cosine >= 0 && square_of_sine >= squared(kLeastSine) ? std::optional(std::sqrt(square_of_sine))
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
    if (!(least2 >= squared(kLeastSine * size_))) {
      return false;
    }
    const double s = std::sqrt(least2);
    const double offset = std::abs(offset_of(dyad));
    const double omega = speed / s;
    const double sliding = speed + offset * omega;
    const double alpha = (acceleration + 2 * sliding * omega + offset * squared(omega)) / s;
    at(dyad.link) = {dyad.pA, A.speed, A.acceleration, omega, alpha};
    if (dyad.slider) {
      ride(*dyad.slider, B);
    }
    return turns_little(omega);
  }

  template <class Other>
  bool add(const Other& /*kind*/, const ChainWatch<double>& /*watch*/) {
    return false;
  }

private:
  [[nodiscard]] MotionBound& at(int body) { return bodies_[static_cast<std::size_t>(body)]; }
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

bool stays_on_branches(const Plan& plan, std::span<const ChainWatch<double>> watches, double step,
                       std::vector<MotionBound>& bounds) {
  ChainBounds all(step, plan.size, bounds);
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    if (!std::visit([&](const auto& kind) { return all.add(kind, watches[g]); }, plan.groups[g].kind)) {
      return false;
    }
  }
  return true;
}

}  // namespace higherpair
