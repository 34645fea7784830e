// Forces of contacts and drivers along the path, and Hertz's pressure.
#include "check_parts.hpp"
#include "higherpair/cam/hertz.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/io/coordinate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace higherpair {
namespace {

using Bound = CheckFigures::Bound;

constexpr Dimension kPressure = dimension::kForce / (dimension::kLength * dimension::kLength);

class CheckedForces {
public:
  CheckedForces(const CheckedPath& checked, const CheckFigures& figures)
      : mechanism_(checked.start.mechanism()), report_(*checked.forces), dynamics_(checked.start) {
    for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) {
      pressures_.push_back(pressure_of(i, figures));
    }
  }

  // Force and pressure of each contact, then the effort of each driver.
  [[nodiscard]] std::vector<Sought> sought() const {
    std::vector<Sought> all(2 * mechanism_.contacts.size(), kGreatest);
    for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) {
      all[2 * i] = mechanism_.contacts[i].both_sides ? kBoth : kGreatest;
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
      out[2 * i] = *force;
      const double curvature = curvature_of(run, i);
      if (pressures_[i] && curvature > 0) {
        out[2 * i + 1] = line_pressure(*force / pressures_[i]->width, curvature, pressures_[i]->modulus);
      }
    }
    for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) {
      if (reactions.drivers[i].effort) {
        out[2 * mechanism_.contacts.size() + i] = *reactions.drivers[i].effort;
      }
    }
  }

  void read_contact(std::size_t i, const PathRanges& ranges, CheckFigures& figures) const {
    figures.about("contacts." + mechanism_.contacts[i].name);
    if (const auto most = peak_of(ranges[2 * i])) {
      mark_growing(figures.add("contact_force", dimension::kForce, most->value, most->driver,
                               figures.of_contact(i, LimitKey::kMaxContactForce), Bound::kMost),
                   *most);
    }
    read_least(i, figures);
    const auto& pressure = ranges[2 * i + 1].greatest;
    if (pressure && pressures_[i]) {
      figures.add("contact_pressure", kPressure, pressure->value, pressure->driver,
                  figures.of_contact(i, LimitKey::kMaxContactPressure), Bound::kMost);
      for (const GivenLimit* given : pressures_[i]->given) {
        figures.use(given);
      }
    }
  }

  void read_drivers(const PathRanges& ranges, CheckFigures& figures) const {
    for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) {
      const Driver& driver = mechanism_.drivers[i];
      const auto joint = static_cast<std::size_t>(driver.joint);
      const bool turns = has_angle(mechanism_.joints[joint].type);
      const auto peak = peak_of(ranges[2 * mechanism_.contacts.size() + i]);
      if (peak) {
        figures.about(driver.name.empty() ? "driver" : "drivers." + driver.name);
        CheckFigure& figure = figures.add(
            turns ? "driving_torque" : "driving_force", effort_dimension(turns), peak->value, peak->driver,
            figures.of_joint(joint, turns ? LimitKey::kMaxDrivingTorque : LimitKey::kMaxDrivingForce),
            Bound::kMost);
        mark_growing(figure, *peak);
      }
    }
  }

private:
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
      const CurveRef& ref = side == 0 ? contact.first : contact.second;
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
    if (contains_null(pressure.given)) {
      return std::nullopt;
    }
    pressure.modulus = contact_modulus(materials[0], materials[1]);
    pressure.width = pressure.given.front()->value;
    return pressure;
  }

  static bool contains_null(const std::vector<const GivenLimit*>& given) {
    return std::find(given.begin(), given.end(), nullptr) != given.end();
  }

  // κ1 + κ2; NaN at corners.
  [[nodiscard]] double curvature_of(const Run& run, std::size_t i) const {
    const Contact& contact = mechanism_.contacts[i];
    const CommonNormal& at = run.row.contacts[i].at;
    const auto side = [&](const CurveRef& ref, double rho) {
      return is_line(named_curve(mechanism_, ref).curve) ? 0.0
             : rho == 0                                  ? std::numeric_limits<double>::quiet_NaN()
                                                         : 1 / rho;
    };
    return side(contact.first, at.rho1) + side(contact.second, at.rho2);
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
