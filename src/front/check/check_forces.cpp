// Forces of contacts and drivers along the path, and Hertz's pressure.
#include "check_parts.hpp"
#include "higherpair/cam/hertz.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/numeric/contains.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace higherpair {
namespace {

using Bound = CheckFigures::Bound;

constexpr Dimension kPressureUnit = dimension::kForce / (dimension::kLength * dimension::kLength);

class CheckedForces {
public:
  CheckedForces(const CheckedPath& checked, const CheckFigures& figures)
      : mechanism_(checked.start.mechanism()), report_(*checked.forces), dynamics_(checked.start) {
    for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) {
      pressures_.push_back(pressure_of(i, figures));
    }
  }

  // Of each contact, then the effort of each driver.
  [[nodiscard]] std::vector<Sought> sought() const {
    std::vector<Sought> all(kOfContact * mechanism_.contacts.size(), kGreatest);
    for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) {
      all[kOfContact * i + kForce] = mechanism_.contacts[i].both_sides ? kBoth : kGreatest;
    }
    all.insert(all.end(), mechanism_.drivers.size(), kBoth);
    return all;
  }

  void fill(const Run& run, std::span<double> out) {
    const Reactions& reactions = dynamics_.solve(run);
    for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) {
      const std::optional<double>& force = reactions.contacts[i].force;
      if (!force || !run.row.contacts[i].touches) {
        continue;
      }
      out[kOfContact * i + kForce] = *force;
      const bool pulls = mechanism_.contacts[i].both_sides && *force < 0;
      const double load = std::max(pulls ? -*force : *force, 0.0);
      const double curvature = curvature_of(run, i, pulls);
      const bool sharp = std::isinf(curvature);
      if (pressures_[i]) {
        out[kOfContact * i + kSharp] = sharp && load > 0 ? 1 : 0;
      }
      if (pressures_[i] && curvature > 0 && !sharp) {
        out[kOfContact * i + kPressure] =
            line_pressure(load / pressures_[i]->width, curvature, pressures_[i]->modulus);
      }
    }
    for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) {
      if (reactions.drivers[i].effort) {
        out[kOfContact * mechanism_.contacts.size() + i] = *reactions.drivers[i].effort;
      }
    }
  }

  void read_contact(std::size_t i, const PathRanges& ranges, CheckFigures& figures) const {
    figures.about("contacts." + mechanism_.contacts[i].name);
    add_peak("contact_force", dimension::kForce, ranges[kOfContact * i + kForce],
             figures.of_contact(i, LimitKey::kMaxContactForce), figures);
    read_least(i, figures);
    if (pressures_[i]) {
      read_pressure(i, ranges, figures);
    }
  }

  void read_drivers(const PathRanges& ranges, CheckFigures& figures) const {
    for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) {
      const Driver& driver = mechanism_.drivers[i];
      const auto joint = static_cast<std::size_t>(driver.joint);
      const bool turns = has_angle(mechanism_.joints[joint].type);
      figures.about(driver_path(driver));
      add_peak(turns ? "driving_torque" : "driving_force", effort_dimension(turns),
               ranges[kOfContact * mechanism_.contacts.size() + i],
               figures.of_joint(joint, turns ? LimitKey::kMaxDrivingTorque : LimitKey::kMaxDrivingForce),
               figures);
    }
  }

private:
  enum OfContact : std::size_t {
    kForce,
    kPressure,
    kSharp,  // 1 while a corner is pressed, 0 otherwise
    kOfContact
  };

  void read_pressure(std::size_t i, const PathRanges& ranges, CheckFigures& figures) const {
    const GivenLimit* most = figures.of_contact(i, LimitKey::kMaxContactPressure);
    const auto& sharp = ranges[kOfContact * i + kSharp].greatest;
    const auto& pressure = ranges[kOfContact * i + kPressure].greatest;
    if (sharp && sharp->value > 0) {
      CheckFigure& figure =
          figures.add("contact_pressure", kPressureUnit, std::nullopt, sharp->driver, most, Bound::kMost);
      figure.verdict = most != nullptr ? Verdict::kExceeded : figure.verdict;
      figure.remark = "unbounded at a sharp corner";
    } else if (pressure) {
      mark_growing(figures.add("contact_pressure", kPressureUnit, pressure->value, pressure->driver, most,
                               Bound::kMost),
                   *pressure, figures);
    } else {
      return;
    }
    for (const GivenLimit* given : pressures_[i]->given) {
      figures.use(given);
    }
  }

  // What the pressure of a contact depends on besides its force.
  struct Pressure {
    double modulus = 0;  // E*
    double width = 0;
    std::vector<const GivenLimit*> given;
  };

  [[nodiscard]] std::optional<Pressure> pressure_of(std::size_t i, const CheckFigures& figures) const {
    const Contact& contact = mechanism_.contacts[i];
    Pressure pressure;
    pressure.given.push_back(figures.of_contact(i, LimitKey::kWidth));
    std::array<ElasticMaterial, 2> materials;
    for (const std::size_t side : {0U, 1U}) {
      const CurveRef& ref = ref_of(contact, side);
      if (is_point(named_curve(mechanism_, ref).curve)) {
        return std::nullopt;
      }
      for (const LimitKey key : {LimitKey::kElasticModulus, LimitKey::kPoissonRatio}) {
        const GivenLimit* given = figures.of_body(ref.body, key);
        pressure.given.push_back(given);
        (key == LimitKey::kElasticModulus ? materials[side].modulus : materials[side].poisson) =
            given != nullptr ? given->value : 0;
      }
    }
    if (contains(pressure.given, nullptr)) {
      return std::nullopt;
    }
    pressure.modulus = contact_modulus(materials[0], materials[1]);
    pressure.width = pressure.given.front()->value;
    return pressure;
  }

  // κ1 + κ2, +∞ at corners. A contact held on both sides that pulls presses the round body against the wall
  // opposite, which is farther out by its diameter and curved the other way; NaN where neither body is round.
  [[nodiscard]] double curvature_of(const Run& run, std::size_t i, bool pulls) const {
    const Contact& contact = mechanism_.contacts[i];
    const CommonNormal& at = run.row.contacts[i].at;
    const Curve& first = named_curve(mechanism_, contact.first).curve;
    const Curve& second = named_curve(mechanism_, contact.second).curve;
    const double rho1 = is_line(first) ? kInf : at.rho1;
    const double rho2 = is_line(second) ? kInf : at.rho2;
    if (!pulls) {
      return 1 / std::abs(rho1) == kInf || 1 / std::abs(rho2) == kInf ? kInf : 1 / rho1 + 1 / rho2;
    }
    const auto opposite = [](double round, double wall) { return 1 / round - 1 / (wall + 2 * round); };
    const bool round1 = first.kind == CurveKind::kCircle && rho1 > 0;
    const bool round2 = second.kind == CurveKind::kCircle && rho2 > 0;
    if (round1 && (!round2 || rho1 < rho2)) {
      return opposite(rho1, rho2);
    }
    return round2 ? opposite(rho2, rho1) : kNoValue;
  }

  void read_least(std::size_t i, CheckFigures& figures) const {
    const auto& lowest = report_.lowest[i];
    if (!lowest || mechanism_.contacts[i].both_sides) {  // a contact held on both sides may pull
      return;
    }
    CheckFigure& figure = figures.add("least_contact_force", dimension::kForce, lowest->force, lowest->driver,
                                      figures.of_contact(i, LimitKey::kMinContactForce), Bound::kLeast);
    const bool opens = std::any_of(report_.openings.begin(), report_.openings.end(),
                                   [&](const auto& opening) { return opening.what.contact == i; });
    if (opens) {
      figure.limit = figure.limit.value_or(0);
      figure.verdict = Verdict::kExceeded;
      figure.remark = "the contact would have to pull: it opens";
    }
  }

  const Mechanism& mechanism_;
  const ContactForceReport& report_;
  InverseDynamics dynamics_;
  std::vector<std::optional<Pressure>> pressures_;
};

}  // namespace

ForceCheck force_check(const CheckedPath& checked, const CheckFigures& figures) {
  const auto forces = std::make_shared<CheckedForces>(checked, figures);
  ForceCheck check;
  check.quantities = {forces->sought(),
                      [forces](const Run& run, double, std::span<double> out) { forces->fill(run, out); }};
  check.read_contact = [forces](std::size_t contact, const PathRanges& ranges, CheckFigures& into) {
    forces->read_contact(contact, ranges, into);
  };
  check.read_drivers = [forces](const PathRanges& ranges, CheckFigures& into) {
    forces->read_drivers(ranges, into);
  };
  return check;
}

}  // namespace higherpair
