#include "checks.hpp"

#include "higherpair/contact/details.hpp"

#include <cmath>
#include <cstdlib>

#include <fmt/core.h>

namespace higherpair::bench {
namespace {

// First and second derivative by central differences over seven points.
struct Derivatives {
  double first;
  double second;
};

template <class F>
Derivatives differentiate(const F& value, double at, double h) {
  const double middle = value(at);
  std::array<double, 3> odd{};
  std::array<double, 3> even{};
  for (int k = 1; k <= 3; ++k) {
    const double after = value(at + k * h) - middle;
    const double before = value(at - k * h) - middle;
    odd[k - 1] = after - before;
    even[k - 1] = after + before;
  }
  return {(45 * odd[0] - 9 * odd[1] + odd[2]) / (60 * h),
          (270 * even[0] - 27 * even[1] + 2 * even[2]) / (180 * h * h)};
}

// The point of an oval whose outward normal has the angle phi, from its support function; in the body's
// frame.
Vector2d oval_point(const Oval& oval, double phi) {
  const double c = std::cos(phi - oval.rotation);
  const double s = std::sin(phi - oval.rotation);
  const double h = std::sqrt(oval.a * oval.a * c * c + oval.b * oval.b * s * s);
  return oval.center + Rotation<double>::from_angle(oval.rotation) *
                           Vector2d(oval.a * oval.a * c / h, oval.b * oval.b * s / h);
}

struct Position {
  double u;
  double q;
};

// The position at which the cam touches the follower at the normal angle phi1 in its own frame. Tangency
// gives the relative angle once phi2 is known; phi2 follows from the distance of the pivots. One equation,
// solved by the secant method from a guess.
Position position_by_normal(const Case& reference, double phi1, double phi2_guess) {
  const Vector2d r1 = oval_point(reference.cam, phi1);
  const auto between_pivots = [&](double phi2) -> Vector2d {
    const auto relative = Rotation<double>::from_angle(phi1 + kPi - phi2);
    return r1 - relative * oval_point(reference.follower.front(), phi2);
  };
  const auto error = [&](double phi2) {
    return between_pivots(phi2).norm() - reference.follower_pivot.norm();
  };
  double last = phi2_guess + 1e-4;
  double phi2 = phi2_guess;
  double last_error = error(last);
  for (int i = 0; i < 20; ++i) {
    const double now = error(phi2);
    if (now == last_error || std::abs(now) < 1e-17) {
      break;
    }
    const double next = phi2 - now * (phi2 - last) / (now - last_error);
    last = phi2;
    last_error = now;
    phi2 = next;
  }
  require(std::abs(error(phi2)) < 1e-15, reference.name + ": the independent solution was not found");
  const double u = angle_of(reference.follower_pivot) - angle_of(between_pivots(phi2));
  return {u, u + phi1 + kPi - phi2};
}

// The lift of the flat face is the cam's support function in the direction y.
std::array<double, 3> lift(const Oval& cam, double u) {
  const Vector2d c = Rotation<double>::from_angle(u) * cam.center;
  const double psi = kPi / 2 - u - cam.rotation;
  const double difference = (cam.a * cam.a - cam.b * cam.b) / 2;
  const double g = (cam.a * cam.a + cam.b * cam.b) / 2 + difference * std::cos(2 * psi);
  const double dg = 2 * difference * std::sin(2 * psi);  // by u
  const double d2g = -4 * difference * std::cos(2 * psi);
  const double h = std::sqrt(g);
  return {c.y() + h, c.x() + dg / (2 * h), -c.y() + d2g / (2 * h) - dg * dg / (4 * g * h)};
}

double followed(ContactTrack track, double u) {
  return step_to(track, u, track.branch) == ContactStatus::kOk ? track.at.q : NAN;
}

// Written as !(error <= bound), so that NaN counts as wrong.
void require_close(const Case& reference, const std::string& what, double u, double error, double bound) {
  require(error <= bound, fmt::format("{}: {} is wrong by {} at u = {}", reference.name, what, error, u));
}

void check_closed_form(const Case& reference, const ContactPosition& at) {
  if (reference.follower.empty()) {
    const auto [q, dq, d2q] = lift(reference.cam, at.u);
    require_close(reference, "q", at.u, std::abs(at.q - q), 1e-15);
    require_close(reference, "dq/du", at.u, std::abs(at.dq - dq), 1e-14);
    require_close(reference, "d2q/du2", at.u, std::abs(at.d2q - d2q), 1e-13);
    return;
  }
  if (reference.name == "circle_on_circle") {
    const FourBarByHand::Motion bar = kFourBar.at(at.u);
    require_close(reference, "q", at.u, angle_difference(at.q + kPi, bar.theta4), 1e-14);
    require_close(reference, "dq/du", at.u, std::abs(at.dq - bar.omega4), 1e-14);
    require_close(reference, "d2q/du2", at.u, std::abs(at.d2q - bar.alpha4), 1e-13);
  }
}

}  // namespace

void check_four_bar() {
  for (int step = 0; step < kStepsPerTurn; ++step) {
    const double theta2 = driver_position(step);
    const FourBarByHand::Motion hand = kFourBar.at(theta2);
    const Vector2d gap = kFourBar.r2 * unit_vector(theta2) + kFourBar.r3 * unit_vector(hand.theta3) -
                         kFourBar.r4 * unit_vector(hand.theta4) - Vector2d(kFourBar.r1, 0);
    require(gap.norm() <= 1e-16, "the four-bar by hand does not close");
    const Derivatives rates =
        differentiate([](double angle) { return kFourBar.at(angle).theta4; }, theta2, 0.01);
    require(std::abs(rates.first - hand.omega4) <= 1e-11, "the four-bar by hand has wrong velocities");
    require(std::abs(rates.second - hand.alpha4) <= 1e-9, "the four-bar by hand has wrong accelerations");
  }
}

void check_tracking(const Case& reference) {
  const Run& run = reference.run;
  ContactTrack track = track_of(run);
  for (int step = 0; step < kStepsPerTurn; ++step) {
    const double u = driver_position(step);
    require(step_to(track, u, track.branch) == ContactStatus::kOk, reference.name + ": the contact is lost");
    const ContactPosition& at = track.at;
    require_close(reference, "the closure", u, (at.p2_W - at.p1_W).norm(), 1e-15);
    check_closed_form(reference, at);
    if (step % 100 != 0) {
      continue;
    }
    const Derivatives rates = differentiate([&](double other) { return followed(track, other); }, u, 0.004);
    require_close(reference, "dq/du", u, std::abs(rates.first - at.dq), 1e-9);
    require_close(reference, "d2q/du2", u, std::abs(rates.second - at.d2q), 1e-7);
    if (!reference.follower.empty()) {
      const Position other = position_by_normal(reference, track.phi - u, track.phi + kPi - at.q);
      const double nearby = u + std::remainder(other.u - u, 2 * kPi);
      require_close(reference, "q", u, angle_difference(followed(track, nearby), other.q), 1e-13);
    }
    const ContactDetails details = details_of(reference.pair(), at, track.phi);
    require_close(reference, "a centre of curvature", u,
                  (*details.side1.center_W + at.rho1 * at.n_W - at.p1_W).norm(), 1e-15);
  }
}

void check_rows(const Case& reference) {
  Run run = reference.run;
  ColumnSet table = table_of(reference.profile);
  Row row;
  for (int step = 0; step < kStepsPerTurn; step += 100) {
    const double u = driver_position(step);
    move_to(run, {{u, 1, 0}});
    require(run.row.status == RowStatus::kOk, reference.name + ": a row is not ok");
    const ContactPosition& at = track_of(run).at;
    const BodyMotion wanted = motion_at(reference.pair().motion2, at.q, at.dq, at.d2q);
    const BodyMotion& follower = run.row.bodies.back();
    require((follower.X_WB.p_WB - wanted.X_WB.p_WB).norm() <= 1e-15 && follower.theta == wanted.theta &&
                std::abs(follower.omega - wanted.omega) <= 1e-14 * (1 + std::abs(wanted.omega)),
            reference.name + ": the row differs from the track");
    const std::vector<DriverState> drivers{{{step * 360.0 / kStepsPerTurn, 1, 0}, {u, 1, 0}}};
    table.fill({run, drivers}, row.values);
    std::string text;
    append_csv_row(table.columns(), row, text);
    // The first number of the line is the driver position.
    require(row.values.size() == table.columns().size() &&
                std::strtod(text.c_str(), nullptr) == drivers.front().profile.position,
            reference.name + ": the text of a row is wrong");
  }
}

}  // namespace higherpair::bench
