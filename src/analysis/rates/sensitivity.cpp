#include "higherpair/analysis/sensitivity.hpp"

#include "analysis/boundaries/span_ends.hpp"
#include "analysis/tolerances.hpp"
#include "higherpair/geometry/boundary.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "series_motion.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Core>

namespace higherpair {
namespace {

using Parametric = Partials<double, 1>;
using ParametricSeries = PowerSeries<Parametric, 2>;
constexpr std::size_t kRateOrder = 2;  // of the series of a row, up to accelerations

double partial(const ParametricSeries& series, std::size_t k) {
  return series.c[k].c[1];
}

// The coordinate of a joint in the poses of the description.
Parametric posed_coordinate(const Mechanism& mechanism, const Mechanism& derivative,
                            const Dimensions<Parametric>::Joint& joint) {
  const auto posed = [&](int index) {
    const Body& body = mechanism.bodies[index];
    const Body by_p = index == 0 ? Body() : derivative.bodies[index];
    const Parametric theta = parametric(body.guess_theta, by_p.guess_theta);
    return BodyAt<Parametric>{{Rotation<Parametric>::from_angle(theta),
                               {parametric(body.guess_p_WB.x(), by_p.guess_p_WB.x()),
                                parametric(body.guess_p_WB.y(), by_p.guess_p_WB.y())}},
                              theta};
  };
  return joint_coordinate(joint.of, posed(joint.first), posed(joint.second), posed(joint.carrier));
}

// The position at which a run starts, where nothing is held by rolling yet.
struct Start {
  Plan plan;
  Dimensions<double> values;
  Dimensions<Parametric> dimensions;
  Coordinates<double> numbers;
  Coordinates<ParametricSeries> at;
};

bool is_placed(const Start& start, const Group& group) {
  const ConditionSystem system(start.values, condition_set(start.plan, group), start.plan.size);
  Eigen::VectorXd values;
  Eigen::MatrixXd J;
  system.evaluate(start.numbers, values, J);
  return is_regular(J);
}

// A follower that its contact does not place to first order, held as if it were driven.
struct HeldFollower {
  std::size_t driver = 0;  // index in Start::at.drivers
  const TrackedPair* pair = nullptr;
  double by_pose = 0;  // derivative of its pose's coordinate
};

std::vector<HeldFollower> hold_loose_followers(const Mechanism& mechanism, const Mechanism& derivative,
                                               Start& start) {
  std::vector<HeldFollower> held;
  for (Group& group : start.plan.groups) {
    const auto* tracked = std::get_if<TrackedPair>(&group.kind);
    if (tracked == nullptr || !mechanism.contacts[tracked->contact].rolling || is_placed(start, group)) {
      continue;
    }
    const int joint = group.joints.front();
    const Parametric posed = posed_coordinate(mechanism, derivative, start.dimensions.joints[joint]);
    held.push_back({start.values.drivers.size(), tracked, posed.c[1]});
    group.drivers.push_back(static_cast<int>(start.values.drivers.size()));
    start.values.drivers.push_back(joint);
    start.dimensions.drivers.push_back(joint);
    start.at.drivers.emplace_back(posed);
    start.numbers.drivers.push_back(posed.c[0]);
  }
  return held;
}

// Velocity of a point in ground for a unit rate of a joint to ground, with lengths relative to the size.
Vector2<ParametricSeries> velocity_per_coordinate(const Start& start, const Coordinates<ParametricSeries>& at,
                                                  int joint, const Vector2<ParametricSeries>& p_W) {
  const auto& of = start.dimensions.joints[joint];
  const BodyAt<ParametricSeries>& first = at.bodies[of.first];
  if (of.of.type == JointType::kRevolute) {
    return perp(Vector2<ParametricSeries>(p_W - first.point(of.of.p_A))) / ParametricSeries(start.plan.size);
  }
  return first.vector(of.of.direction_A);
}

// Derivative by p of the measure that is 0 where the material points at the contact can have the same
// velocity.
double rate_of_slip(const Mechanism& mechanism, const Start& start, const HeldFollower& held,
                    const Coordinates<ParametricSeries>& at) {
  const auto index = static_cast<std::size_t>(held.pair->contact);
  const auto& contact = start.dimensions.contacts[index];
  const FacingPoints<ParametricSeries> facing = facing_points(
      contact.curve1, at.bodies[contact.first], contact.curve2, at.bodies[contact.second], at.phi[index]);
  const bool flat1 = contact.curve1.kind == CurveKind::kLine;
  const Vector2<ParametricSeries>& p_W = flat1 ? facing.p2_W : facing.p1_W;
  const int driver = mechanism.drivers[held.pair->driver].joint;
  return partial(cross(velocity_per_coordinate(start, at, driver, p_W),
                       velocity_per_coordinate(start, at, start.values.drivers[held.driver], p_W)),
                 0);
}

// Sets the derivatives of the angles that bodies keep: those of their poses.
void set_held_angles(const Mechanism& derivative, Coordinates<ParametricSeries>& at) {
  for (std::size_t i = 0; i < at.held_angles.size(); ++i) {
    at.held_angles[i].c[0].c[1] = derivative.bodies[i].guess_theta;
  }
}

Start start_of(const Run& run, const Mechanism& derivative, const std::vector<double>& drivers) {
  Start start{run.plan(),
              dimensions_of(run.mechanism()),
              dimensions_of(run.mechanism(), derivative),
              row_coordinates(run),
              {}};
  start.at = constant<ParametricSeries>(start.numbers);
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    start.at.drivers[i].c[0].c[1] = drivers[i];
  }
  set_held_angles(derivative, start.at);
  start.plan.idle_bodies.insert(start.plan.idle_bodies.end(), run.plan().phase_bodies.begin(),
                                run.plan().phase_bodies.end());
  for (std::size_t i = 0; i < start.values.contacts.size(); ++i) {
    start.values.contacts[i].rolling = start.dimensions.contacts[i].rolling = false;
  }
  return start;
}

}  // namespace

Curve Sensitivity::of_local_curve(const Run& run, std::size_t contact, std::size_t side) const {
  const CurveRef& ref = ref_of(run.mechanism().contacts[contact], side);
  const BoundaryPlace& place = run.row.contacts[contact].place[side];
  return local_curve_derivative(boundary_at(run, contact, side).at(place), curve_of(run.mechanism(), ref),
                                at_fixed_place(contact, side, place));
}

PlaceDerivative Sensitivity::at_fixed_place(std::size_t contact, std::size_t side,
                                            const BoundaryPlace& place) const {
  return derivative_.boundaries ? derivative_.boundaries->at(contact, side, place) : PlaceDerivative{};
}

// With s₁ and s₂ the arc lengths of the contact along the boundaries, each along its own n turned +90°, the
// angle φ of the common normal and the common point require
//     κ₁ ds₁ = dφ - (turn of n₁ without it),  κ₂ ds₂ likewise,  ds₁ + ds₂ = shift of boundary 2 along n₁
//     +90°.
// The more curved boundary determines its own ds, and the shift that of the other, which may be straight.
std::array<PlaceDerivative, 2> Sensitivity::of_places(const Run& run, const RowSensitivity& of_row,
                                                      std::size_t contact) const {
  const ContactMotion& motion = run.row.contacts[contact];
  std::array<PlaceDerivative, 2> by;
  std::array<SpanPoint, 2> points;
  std::array<double, 2> kappa{}, turn{}, shift{}, ds{};
  for (std::size_t side = 0; side < 2; ++side) {
    const CurveRef& ref = ref_of(run.mechanism().contacts[contact], side);
    const Boundary& boundary = boundary_at(run, contact, side);
    const BoundaryPlace& place = motion.place[side];
    const SpanPoint& point = points[side] = boundary.at(place);
    const Rotation<double>& R_WB = run.row.bodies[ref.body].X_WB.R_WB;
    const BodyMotion& body = of_row.bodies[ref.body];
    by[side] = at_fixed_place(contact, side, place);
    const Vector2d moved_W =
        body.X_WB.p_WB + body.theta * perp(Vector2d(R_WB * point.p_B)) + R_WB * by[side].p_B;
    const bool corner = boundary.is_corner(place);
    kappa[side] = corner ? kInf : std::abs(point.kappa);
    turn[side] = of_row.phi[contact] - body.theta;
    ds[side] = corner ? 0 : (turn[side] - by[side].n_B.dot(perp(point.n_B))) / point.kappa;
    shift[side] = moved_W.dot(perp(motion.at.n_W));
  }
  const std::size_t straighter = kappa[0] < kappa[1] ? 0 : 1;
  ds[straighter] = shift[1] - shift[0] - ds[1 - straighter];
  for (std::size_t side = 0; side < 2; ++side) {
    const auto rates = boundary_at(run, contact, side).curvature_rates(motion.place[side]);
    const Vector2d t_B = perp(points[side].n_B);
    by[side].p_B += ds[side] * t_B;
    by[side].n_B = turn[side] * t_B;
    by[side].kappa += ds[side] * points[side].slope;
    by[side].slope += rates ? ds[side] * (*rates)[0] : 0;
  }
  return by;
}

Mechanism Sensitivity::derivative_at(const Run& run) const {
  Mechanism derivative = derivative_.numbers;
  for (const auto [contact, side] : BoundarySides(run.mechanism())) {
    const CurveRef& ref = ref_of(run.mechanism().contacts[contact], side);
    Curve& curve = derivative.bodies[ref.body].curves[ref.curve].curve;
    if (run.row.contacts[contact].touches) {
      curve = of_local_curve(run, contact, side);
    } else {
      curve.vertex_B = curve.axis_B = Vector2d::Zero();
      curve.semi_latus = curve.q = curve.kappa = curve.slope = 0;
    }
  }
  return derivative;
}

std::optional<Sensitivity> Sensitivity::at_start(const Run& started, MechanismDerivative of_mechanism,
                                                 const std::vector<double>& drivers) {
  Run run = started;
  set_local_curves(run);
  Sensitivity sensitivity;
  sensitivity.derivative_ = std::move(of_mechanism);
  const Mechanism derivative = sensitivity.derivative_at(run);
  Start start = start_of(run, derivative, drivers);
  const auto solved = [&] { return solve_series(start.plan, start.values, start.dimensions, start.at); };
  // The contact point has to be where both joints let the bodies have the same velocity there. Discs about
  // their centres satisfy that in any position; they keep that of the pose.
  for (const HeldFollower& held : hold_loose_followers(run.mechanism(), derivative, start)) {
    const auto rate_with = [&](double by_p) {
      start.at.drivers[held.driver].c[0].c[1] = by_p;
      return rate_of_slip(run.mechanism(), start, held, solved().at);
    };
    const double without = rate_with(0);
    const double change = rate_with(1) - without;
    start.at.drivers[held.driver].c[0].c[1] =
        std::abs(change) > kNoInfluenceSlip ? -without / change : held.by_pose;
  }
  const auto motion = solved();
  if (!motion.all_known()) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < run.mechanism().contacts.size(); ++i) {
    const bool rolls = run.mechanism().contacts[i].rolling;
    sensitivity.arcs_.push_back(
        rolls ? partial(arc_difference(start.dimensions.contacts[i], motion.at.bodies, motion.at.phi[i]), 0)
              : 0);
  }
  return sensitivity;
}

bool meets_change_point(const Run& run, const std::vector<DriverMotion>& motions) {
  if (run.row.status == RowStatus::kNotAssemblable || !run.row.all_rates) {
    return false;
  }
  auto at = constant<PowerSeries<double, 3>>(row_coordinates(run));
  for (std::size_t i = 0; i < motions.size(); ++i) {
    at.drivers[i] = series_of_driver<3>(motions[i]);
  }
  SeriesOptions options;
  options.last = kRateOrder;
  return meets_change_point(run, dimensions_of(run.mechanism()), std::move(at), options);
}

tl::expected<RowSensitivity, NoSensitivity> Sensitivity::of_row(const Run& run,
                                                                const std::vector<DriverMotion>& motions,
                                                                const std::vector<DriverMotion>& derivatives,
                                                                RatesAsked rates) const {
  if (run.row.status == RowStatus::kNotAssemblable || !run.row.all_rates) {
    return tl::unexpected(NoSensitivity::kNoRates);
  }
  Coordinates<ParametricSeries> at = constant<ParametricSeries>(row_coordinates(run));
  for (std::size_t i = 0; i < motions.size(); ++i) {
    at.drivers[i].c = {parametric(motions[i].position, derivatives[i].position),
                       parametric(motions[i].velocity, derivatives[i].velocity),
                       parametric(motions[i].acceleration / 2, derivatives[i].acceleration / 2)};
  }
  for (std::size_t i = 0; i < at.arcs.size(); ++i) {
    at.arcs[i].c[0].c[1] = arcs_[i];
  }
  const std::optional<Mechanism> local = run.local ? std::optional(derivative_at(run)) : std::nullopt;
  const Mechanism& derivative = local ? *local : derivative_.numbers;
  set_held_angles(derivative, at);
  SeriesOptions options;
  options.last = rates == RatesAsked::kNone ? 0 : kRateOrder;
  options.regular = rates == RatesAsked::kRegular;
  const auto motion = row_series(run, run.plan(), dimensions_of(run.mechanism()),
                                 dimensions_of(run.mechanism(), derivative), std::move(at), options);
  if (!motion.all_known()) {
    return tl::unexpected(motion.diverges ? NoSensitivity::kDiverges : NoSensitivity::kNoRates);
  }
  RowSensitivity of_row;
  for (const BodyAt<ParametricSeries>& body : motion.at.bodies) {
    const auto vector = [&](std::size_t k) {
      return Vector2d(partial(body.X_WB.p_WB.x(), k), partial(body.X_WB.p_WB.y(), k));
    };
    of_row.bodies.push_back({{{}, vector(0)},
                             partial(body.theta, 0),
                             vector(1),
                             partial(body.theta, 1),
                             2 * vector(2),
                             2 * partial(body.theta, 2)});
  }
  for (const ParametricSeries& phi : motion.at.phi) {
    of_row.phi.push_back(partial(phi, 0));
    of_row.phi_dot.push_back(partial(phi, 1));
  }
  of_row.arcs = arcs_;
  return of_row;
}

}  // namespace higherpair
