// Derivatives by dimensions, compared with differences between whole runs with other dimensions and with
// closed forms.
#include "analysis/run_testing.hpp"
#include "higherpair/analysis/displaced.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/geometry/arc_length.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"

#include <filesystem>
#include <random>

namespace higherpair {
namespace {

using testing::profile_of;
using testing::shipped;

struct Row {
  higherpair::Run start;
  higherpair::Run run;
};

std::optional<Row> row_of(const Mechanism& mechanism, const std::vector<double>& start,
                          const std::vector<DriverMotion>& motions) {
  auto run = start_run(mechanism, start);
  if (!run) return std::nullopt;
  Row row{*run, *run};
  move_to(row.run, motions);
  if (row.run.row.status != RowStatus::kOk) return std::nullopt;
  return row;
}

// All numbers of a row's bodies and contacts.
Eigen::VectorXd numbers_of(const MotionRow& row) {
  std::vector<double> all;
  for (const BodyMotion& body : row.bodies) {
    all.insert(all.end(), {body.X_WB.p_WB.x(), body.X_WB.p_WB.y(), body.theta, body.v_WB.x(), body.v_WB.y(),
                           body.omega, body.a_WB.x(), body.a_WB.y(), body.alpha});
  }
  for (const ContactMotion& contact : row.contacts) {
    all.insert(all.end(), {contact.phi, contact.rates.phi_dot});
  }
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

Eigen::VectorXd numbers_of(const RowSensitivity& row) {
  std::vector<double> all;
  for (const BodyMotion& body : row.bodies) {
    all.insert(all.end(), {body.X_WB.p_WB.x(), body.X_WB.p_WB.y(), body.theta, body.v_WB.x(), body.v_WB.y(),
                           body.omega, body.a_WB.x(), body.a_WB.y(), body.alpha});
  }
  for (std::size_t i = 0; i < row.phi.size(); ++i) all.insert(all.end(), {row.phi[i], row.phi_dot[i]});
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

// Forces and moments of joints, contacts and drivers, and the data of the contacts' equivalent links, where
// the row has them.
std::vector<double> details_of(const higherpair::Run& run) {
  std::vector<double> all;
  const Reactions reactions = InverseDynamics(run).solve(run);
  for (const JointReaction& joint : reactions.joints) {
    all.push_back(joint.fx.value_or(0));
    all.push_back(joint.fy.value_or(0));
    all.push_back(joint.moment.value_or(0));
  }
  for (const ContactReaction& contact : reactions.contacts) {
    all.push_back(contact.force.value_or(0));
    all.push_back(contact.friction.value_or(0));
  }
  for (std::size_t i = 0; i < run.mechanism().contacts.size(); ++i) {
    const Contact& contact = run.mechanism().contacts[i];
    const auto side = [&](const CurveRef& ref) -> ContactBody {
      return {curve_of(run.mechanism(), ref), run.row.bodies[ref.body], nullptr};
    };
    const ContactDetails details = higherpair::details_of(side(contact.first), side(contact.second),
                                                          run.row.contacts[i].at, run.row.contacts[i].phi);
    for (const auto& [arc, ref] :
         {std::pair(details.side1.arc, contact.first), {details.side2.arc, contact.second}}) {
      // Where the arc begins depends on the curve's axis, but only up to whole turns.
      const double turn = arc_length(curve_of(run.mechanism(), ref), 2 * kPi);
      const bool closed = is_conic(curve_of(run.mechanism(), ref)) && curve_of(run.mechanism(), ref).q > 0;
      all.push_back(closed ? turn * std::sin(2 * kPi * arc / turn) : arc);
    }
    all.insert(all.end(), {details.lengths[2].value_or(0), details.side1.rho.value_or(0)});
  }
  return all;
}

Mechanism zero_of(Mechanism mechanism) {
  for_each_number(mechanism, [](double& number) { number = 0; });
  return mechanism;
}

// The derivative of the mechanism by each of its numbers in turn; unit vectors are rotated.
std::vector<Mechanism> parameters_of(const Mechanism& mechanism) {
  std::vector<Mechanism> parameters;
  const Mechanism zero = zero_of(mechanism);
  std::size_t count = 0;
  for_each_number(mechanism, [&](double) { ++count; });
  for (std::size_t k = 0; k < count; ++k) {
    Mechanism one = zero;
    for_each_number(one, [&, i = std::size_t{0}](double& number) mutable { number = i++ == k ? 1 : 0; });
    bool keep = true;
    for (std::size_t b = 0; b < one.bodies.size(); ++b) {
      for (std::size_t c = 0; c < one.bodies[b].curves.size(); ++c) {
        const Curve& curve = mechanism.bodies[b].curves[c].curve;
        Curve& by_p = one.bodies[b].curves[c].curve;
        // Circles and parabolas must keep their kind.
        keep =
            keep && (by_p.q == 0 || curve.kind == CurveKind::kEllipse || curve.kind == CurveKind::kHyperbola);
        keep = keep && by_p.axis_B.y() == 0;
        by_p.axis_B = by_p.axis_B.x() * perp(curve.axis_B);
      }
    }
    for (std::size_t j = 0; j < one.joints.size(); ++j) {
      Vector2d& by_p = one.joints[j].direction_A;
      keep = keep && by_p.y() == 0;
      by_p = by_p.x() * perp(mechanism.joints[j].direction_A);
    }
    if (keep) parameters.push_back(one);
  }
  return parameters;
}

Mechanism turned_to_unit(Mechanism mechanism) {
  for (Body& body : mechanism.bodies) {
    for (NamedCurve& curve : body.curves) curve.curve.axis_B.normalize();
  }
  for (Joint& joint : mechanism.joints) joint.direction_A.normalize();
  return mechanism;
}

TEST(Sensitivities, AreTheDifferencesBetweenRunsWithOtherDimensions) {
  for (const std::string& name : testing::shipped_without_boundaries()) {
    SCOPED_TRACE(name);
    const Profile profile = shipped(name);
    const DriverSchedule schedule = DriverSchedule::analyze(profile).value();
    std::vector<double> start;
    std::vector<DriverMotion> motions;
    for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
      start.push_back(schedule.state(0, i).si.position);
      motions.push_back({schedule.state(schedule.size() / 7, i).si.position, 1.3, -0.4});
    }
    const Mechanism& mechanism = profile.mechanism;
    const auto row = row_of(mechanism, start, motions);
    ASSERT_TRUE(row);
    const double size = row->run.plan().size;
    std::vector<Mechanism> parameters = parameters_of(mechanism);
    std::shuffle(parameters.begin(), parameters.end(), std::mt19937(5));
    parameters.resize(std::min<std::size_t>(parameters.size(), 14));
    int compared = 0;
    for (const Mechanism& derivative : parameters) {
      const auto by = Sensitivity::at_start(row->start, derivative, std::vector<double>(start.size(), 0.0));
      ASSERT_TRUE(by);
      const auto of_row = by->of_row(row->run, motions, std::vector<DriverMotion>(start.size()));
      ASSERT_TRUE(of_row);
      const Eigen::VectorXd derivatives = numbers_of(*of_row);
      const std::vector<double> details = derivative_along(
          row->run, *by, *of_row, [](const higherpair::Run& run, double /*h*/) { return details_of(run); });
      // With two step sizes, whose difference shows the error. Redundant mechanisms can be assembled with
      // their own dimensions only.
      const auto difference = [&](double h) -> std::optional<std::pair<Eigen::VectorXd, Eigen::VectorXd>> {
        const auto after = row_of(turned_to_unit(displaced(mechanism, derivative, h)), start, motions);
        const auto before = row_of(turned_to_unit(displaced(mechanism, derivative, -h)), start, motions);
        if (!after || !before) return std::nullopt;
        const auto d1 = details_of(after->run), d0 = details_of(before->run);
        const Eigen::Map<const Eigen::VectorXd> e1(d1.data(), static_cast<Eigen::Index>(d1.size()));
        const Eigen::Map<const Eigen::VectorXd> e0(d0.data(), static_cast<Eigen::Index>(d0.size()));
        return std::pair<Eigen::VectorXd, Eigen::VectorXd>(
            (numbers_of(after->run.row) - numbers_of(before->run.row)) / (2 * h), (e1 - e0) / (2 * h));
      };
      const double h = 2e-4 * size;
      const auto wide = difference(h), narrow = difference(h / 2);
      if (!wide || !narrow) continue;
      ++compared;
      std::string changed;
      for_each_number(derivative, [&, i = 0](double by_p) mutable {
        if (by_p != 0) changed += std::to_string(i) + ' ';
        ++i;
      });
      SCOPED_TRACE("numbers changed: " + changed);
      const auto compare = [&](const Eigen::VectorXd& ours, const Eigen::VectorXd& w,
                               const Eigen::VectorXd& n) {
        const Eigen::VectorXd best = (4 * n - w) / 3;
        const double scale = best.lpNorm<Eigen::Infinity>();
        const double error = (w - n).lpNorm<Eigen::Infinity>() / 20 + 1e-7 * (1 + scale);
        Eigen::Index worst = 0;
        EXPECT_LE((ours - best).cwiseAbs().maxCoeff(&worst), error)
            << "number " << worst << ": " << ours(worst) << " and " << best(worst);
      };
      compare(derivatives, wide->first, narrow->first);
      compare(Eigen::Map<const Eigen::VectorXd>(details.data(), static_cast<Eigen::Index>(details.size())),
              wide->second, narrow->second);
    }
    EXPECT_GT(compared, 2);
  }
}

// A slider-crank with crank r and rod l: the slider is at x = r cos u + w, w = √(l² - r² sin² u).
TEST(SensitivityOf, ASliderCrankToTheLengthOfItsCrankIsTheClosedForm) {
  const double u = 0.8, omega = 2.5, r = 0.03, l = 0.1;
  const auto mechanism_with = [](double crank) {
    return profile_of(R"(
[bodies.ground]
points.O = [0, 0]
[bodies.crank]
points = { O = [0, 0], A = [30, 0] }
[bodies.rod]
pose   = { x = 21, y = 21, angle = -12 }
points = { A = [0, 0], B = [100, 0] }
[bodies.slider]
pose     = { x = 119, y = 0 }
points.B = [0, 0]
[joints]
o = { type = "revolute", between = ["ground.O", "crank.O"] }
a = { type = "revolute", between = ["crank.A", "rod.A"] }
b = { type = "revolute", between = ["rod.B", "slider.B"] }
s = { type = "prismatic", between = ["ground.O", "slider.B"], direction = [1, 0] }
[driver]
joint = "o"
)",
                      {"bodies.crank.points.A.0=" + std::to_string(crank)})
        .mechanism;
  };
  const auto derivative = mechanism_derivative(
      [&](double h) -> std::optional<Mechanism> { return mechanism_with(30 + h); }, 0.01, 30);
  ASSERT_TRUE(derivative);
  const auto row = row_of(mechanism_with(30), {0}, {{u, omega, 0}});
  ASSERT_TRUE(row);
  const auto by = Sensitivity::at_start(row->start, *derivative, {0});
  const auto of_row = by->of_row(row->run, {{u, omega, 0}}, {{}});
  ASSERT_TRUE(of_row);
  // Per millimetre of r.
  const double s = std::sin(u), c = std::cos(u), w = std::sqrt(l * l - r * r * s * s);
  const BodyMotion& slider = of_row->bodies[3];
  EXPECT_NEAR(slider.X_WB.p_WB.x(), 1e-3 * (c - r * s * s / w), 1e-15);
  // x' = -r s - r² s c/w.
  const double by_r = -s - 2 * r * s * c / w - r * r * r * s * s * s * c / (w * w * w);
  EXPECT_NEAR(slider.v_WB.x(), 1e-3 * omega * by_r, 1e-14);
}

// Discs that roll about fixed centres: θ2 = θ2(0) - (r1/r2) (u - u0), whatever the pose of the first row.
TEST(SensitivityOf, RollingDiscsToARadiusGrowsFromTheStart) {
  const auto mechanism_with = [](double radius) {
    return profile_of(R"(units = { length = "m", angle = "rad" }
[bodies.ground]
points = { O1 = [0, 0], O2 = [3, 0] }
[bodies.one]
points.O = [0, 0]
curves.disc = { type = "circle", center = [0, 0], radius = 1 }
[bodies.two]
pose = { x = 3, y = 0, angle = 0.7 }
points.O = [0, 0]
curves.disc = { type = "circle", center = [0, 0], radius = 2 }
[joints]
a = { type = "revolute", between = ["ground.O1", "one.O"] }
b = { type = "revolute", between = ["ground.O2", "two.O"] }
[contacts.roll]
between = ["one.disc", "two.disc"]
rolling = true
[driver]
joint = "a"
)",
                      {"bodies.one.curves.disc.radius=" + std::to_string(radius),
                       "bodies.ground.points.O2.0=" + std::to_string(radius + 2),
                       "bodies.two.pose.x=" + std::to_string(radius + 2)})
        .mechanism;
  };
  const auto derivative = mechanism_derivative(
      [&](double h) -> std::optional<Mechanism> { return mechanism_with(1 + h); }, 0.01, 1);
  ASSERT_TRUE(derivative);
  const auto row = row_of(mechanism_with(1), {0.2}, {{5.2, 3, 0}});
  ASSERT_TRUE(row);
  const auto by = Sensitivity::at_start(row->start, *derivative, {0});
  ASSERT_TRUE(by);
  const auto of_row = by->of_row(row->run, {{5.2, 3, 0}}, {{}});
  ASSERT_TRUE(of_row);
  EXPECT_NEAR(of_row->bodies[2].theta, -5.0 / 2, 1e-13);
  EXPECT_NEAR(of_row->bodies[2].omega, -3.0 / 2, 1e-13);
  EXPECT_NEAR(of_row->bodies[2].X_WB.p_WB.x(), 1, 1e-13);
  // Also by the angle at which the second disc starts.
  Mechanism angle = zero_of(row->run.mechanism());
  angle.bodies[2].guess_theta = 1;
  const auto by_angle = Sensitivity::at_start(row->start, angle, {0});
  ASSERT_TRUE(by_angle);
  EXPECT_NEAR(by_angle->of_row(row->run, {{5.2, 3, 0}}, {{}})->bodies[2].theta, 1, 1e-13);
}

// Arcs jump in this way where a curve's axis turns through the direction from which its angle is measured.
TEST(SensitivityOf, AColumnThatJumpsAtTheRowItselfIsThatOfTheRowsOwnSide) {
  const auto row = row_of(shipped("four_bar").mechanism, {0.3}, {{0.7, 1, 0}});
  Mechanism derivative = zero_of(row->run.mechanism());
  derivative.bodies[1].points.back().p_B.x() = 1;
  const auto by = Sensitivity::at_start(row->start, derivative, {0});
  const auto of_row = by->of_row(row->run, {{0.7, 1, 0}}, {{}});
  for (const double own : {-1, 1}) {
    const auto values = derivative_along(row->run, *by, *of_row, [&](const higherpair::Run&, double h) {
      const double smooth = std::exp(h) + 3 * h * h;
      return std::vector<double>{smooth, own * h < 0 ? smooth + 5 : smooth};
    });
    EXPECT_NEAR(values[0], 1, 1e-11);
    EXPECT_NEAR(values[1], 1, 1e-8);
  }
}

TEST(SensitivityOf, ADimensionThatJumpsIsRefused) {
  const Mechanism mechanism = shipped("four_bar").mechanism;
  const auto at = [&](double h) -> std::optional<Mechanism> {
    Mechanism jumping = mechanism;
    jumping.joints[0].relative_angle = h > 0 ? 1 : 0;
    return jumping;
  };
  EXPECT_FALSE(mechanism_derivative(at, 1));
  EXPECT_FALSE(
      mechanism_derivative([&](double h) { return h > 0 ? std::nullopt : std::optional(mechanism); }, 1));
}

}  // namespace
}  // namespace higherpair
