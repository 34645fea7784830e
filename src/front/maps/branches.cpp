#include "higherpair/analysis/branches.hpp"

#include "front/demands.hpp"
#include "front/model_data.hpp"
#include "higherpair/contact/boundary_enumeration.hpp"
#include "higherpair/contact/certify.hpp"
#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/front/contacts.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/notes.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

std::string remark_on(const CurveContact& contact) {
  if (contact.coincident) {
    return "the curves coincide";
  }
  if (contact.conforming) {
    return "conforming: equal curvatures";
  }
  return contact.at_limit ? "limit position: two contacts merge" : "";
}

// The coordinate of a turning joint is taken in the turn nearest to the pose.
double position_of(double q, const Profile& profile, const ContactPlace& place) {
  const CarriedBody& follower = place.follower;
  const bool turns = follower.freedom.turns;
  const double own = q - place.carrier_angle;
  const Scaling scaling = from_si(coordinate_dimension(turns), profile.units);
  return plus_zero(scaling.apply(follower.sign * (turns ? nearest_turn(own, place.posed) : own)));
}

ContactEntry entry_of(const CurveContact& contact, const Profile& profile, const ContactPlace& place) {
  const Scaling length = from_si(dimension::kLength, profile.units);
  const Scaling angle = from_si(dimension::kAngle, profile.units);
  const bool reversed = !place.known_is_first && contact.opposed;
  const Vector2d n_W = reversed ? Vector2d(-contact.n_W) : contact.n_W;
  ContactEntry entry;
  entry.position = position_of(contact.q, profile, place);
  entry.x = plus_zero(length.apply(contact.p_W.x()));
  entry.y = plus_zero(length.apply(contact.p_W.y()));
  entry.normal = plus_zero(angle.apply(angle_of(n_W)));
  entry.opposed = contact.opposed;
  entry.free = contact.free;
  entry.remark = remark_on(contact);
  return entry;
}

// Converts an interval of q to one of the follower's position, in the profile's units, rounded outwards.
std::array<double, 2> position_interval(const std::array<double, 2>& q, double q_of_contact,
                                        const Profile& profile, const ContactPlace& place) {
  const double position = position_of(q_of_contact, profile, place);
  const double sign = place.follower.sign;
  const Scaling scaling = from_si(coordinate_dimension(place.follower.freedom.turns), profile.units);
  // The position may differ from q by a turn: the interval is placed relative to the position.
  const auto bound = [&](double q_bound, double towards) {
    return std::nextafter(position + scaling.apply(sign * (q_bound - q_of_contact)), towards);
  };
  const double a = bound(q[0], -sign * kInf);
  const double b = bound(q[1], sign * kInf);
  return {std::min(a, b), std::max(a, b)};
}

std::string unit_of(const Profile& profile, bool turns) {
  return unit_text(coordinate_dimension(turns), profile.units);
}

// The joint of a follower on its carrier.
std::string joint_name(const Mechanism& mechanism, const CarriedBody& carried) {
  for (const Joint& joint : mechanism.joints) {
    if (joins(joint, carried.body, carried.carrier) && can_be_driven(joint.type)) {
      return joint.name;
    }
  }
  return "";
}

BranchesReport report_on(const Profile& profile, const DriverSchedule& schedule, const Branches& branches) {
  const Mechanism& mechanism = profile.mechanism;
  BranchesReport report;
  report.title = mechanism.title;
  report.length_unit = unit_of(profile, false);
  report.angle_unit = unit_of(profile, true);
  report.driver = schedule.state(0).profile.position;
  report.complete = branches.complete;
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    const bool turns = driver_turns(mechanism, i);
    report.drivers += fmt::format("{}{} = {} {}", i == 0 ? "" : ", ", driver_name(mechanism.drivers[i]),
                                  schedule.state(0, i).profile.position, unit_of(profile, turns));
  }
  for (const Joint& joint : mechanism.joints) {
    report.joints.push_back(joint.name);
    report.joint_units.push_back(unit_of(profile, has_angle(joint.type)));
  }
  for (const std::vector<double>& assembly : branches.assemblies) {
    std::vector<double>& positions = report.assemblies.emplace_back();
    for (std::size_t i = 0; i < assembly.size(); ++i) {
      const bool turns = has_angle(mechanism.joints[i].type);
      positions.push_back(plus_zero(from_si(coordinate_dimension(turns), profile.units).apply(assembly[i])));
    }
  }
  return report;
}

ContactReport report_on(const Profile& profile, const ContactPlace& place, const CurveContacts& found) {
  ContactReport report;
  report.contact = profile.mechanism.contacts[place.contact].name;
  report.joint = joint_name(profile.mechanism, place.follower);
  report.position_unit = unit_of(profile, place.follower.freedom.turns);
  report.complete = found.status == ContactsStatus::kComplete;
  if (!report.complete) {
    report.note = describe(found.status);
  }
  for (const CurveContact& contact : found.contacts) {
    report.entries.push_back(entry_of(contact, profile, place));
  }
  return report;
}

void add_certificate(const Certificate& certificate, const CurveContacts& found, const Profile& profile,
                     const ContactPlace& place, ContactReport& report) {
  report.certificate = describe(certificate.status);
  if (certificate.status != CertificateStatus::kNotDecided) {
    report.certificate +=
        " (every number of the mechanism to within 2^-50 of itself, the driver's angle as a rational "
        "rotation "
        "within 2^-60, quarter turns exact)";
  }
  for (std::size_t i = 0; i < report.entries.size(); ++i) {
    if (const auto& interval = certificate.intervals[i]) {
      report.entries[i].certified = position_interval(*interval, found.contacts[i].q, profile, place);
    }
  }
}

// The contacts of curves with ends or of several parts.
CurveContacts curve_contacts(const BoundaryPair& pair, double u, const BoundaryContacts& all) {
  const double tolerance = kTouchingDepth * (pair.boundary1->size() + pair.boundary2->size());
  CurveContacts found;
  found.status = ContactsStatus::kComplete;
  for (const BoundaryContact& at : all.contacts) {
    CurveContact entry;
    entry.u = u;
    entry.q = at.q;
    entry.p_W = at.at.p_W();
    entry.n_W = at.at.n_W;
    entry.opposed = true;
    entry.free = !bodies_overlap(*pair.boundary1, pose_at(pair.motion1, u), *pair.boundary2,
                                 pose_at(pair.motion2, at.q), tolerance);
    found.contacts.push_back(entry);
  }
  return found;
}

// Reports whether the list of contacts is proven to be complete, and where it is not.
void add_proof(const BoundaryContacts& all, const Profile& profile, const ContactPlace& place,
               ContactReport& report) {
  report.complete = all.has_bounds && all.undecided.empty();
  if (report.complete) {
    report.proof = "proven: there are no other contacts of opposed normals";
    return;
  }
  report.proof = "not proven to be all: ";
  if (!all.has_bounds) {
    report.proof += "one of the curves gives no bounds";
    return;
  }
  for (const Bounds& q : all.undecided) {
    const auto interval = position_interval({q.low, q.high}, (q.low + q.high) / 2, profile, place);
    report.undecided.push_back(interval);
    const std::string low = fmt::format("{:.10g}", interval[0]);
    const std::string high = fmt::format("{:.10g}", interval[1]);
    report.proof += fmt::format("{}{} {}", report.undecided.size() == 1 ? "" : ", ",
                                low == high ? "at " + low : fmt::format("between {} and {}", low, high),
                                report.position_unit);
  }
  report.proof += " contacts merge or the curves lie on each other, to within rounding";
}

ContactReport list_boundary_contact(const Profile& profile, const ContactPlace& place, bool certify) {
  const Mechanism& mechanism = profile.mechanism;
  const Contact& contact = mechanism.contacts[place.contact];
  const CurveRef& known = place.known_is_first ? contact.first : contact.second;
  const CurveRef& own = place.known_is_first ? contact.second : contact.first;
  const BoundaryPair pair{&boundary_of(mechanism, known), place.pair.motion1, &boundary_of(mechanism, own),
                          place.pair.motion2};
  const BoundaryContacts all = enumerate_boundary_contacts(pair, place.u);
  ContactReport report = report_on(profile, place, curve_contacts(pair, place.u, all));
  add_proof(all, profile, place, report);
  if (certify) {
    report.certificate = "not decided exactly: the algebra knows whole conics, lines and points only";
  }
  return report;
}

// Lists the positions of one follower.
Result<ContactReport> list_contact(const Model::Data& model, const ContactPlace& place, bool certify) {
  if (model.profile.mechanism.contacts[place.contact].by_boundary) {
    return list_boundary_contact(model.profile, place, certify);
  }
  const CurveContacts found = find_curve_contacts(place.pair, place.u);
  ContactReport report = report_on(model.profile, place, found);
  const std::string name = "contacts." + report.contact + ": ";
  if (found.status == ContactsStatus::kNoPair) {
    return tl::unexpected(
        error_about(model, ErrorKind::kMechanism, name + std::string(describe(found.status))));
  }
  if (certify) {
    const Certificate certificate = certify_contacts(place.pair, place.u, found);
    if (certificate.status == CertificateStatus::kDisagreement) {
      return tl::unexpected(
          error_about(model, ErrorKind::kInternal, name + std::string(describe(certificate.status))));
    }
    add_certificate(certificate, found, model.profile, place, report);
  }
  return report;
}

bool is_empty(const BranchesReport& report) {
  return report.assemblies.empty() &&
         std::all_of(report.contacts.begin(), report.contacts.end(),
                     [](const ContactReport& contact) { return contact.entries.empty(); });
}

}  // namespace

bool can_certify() {
  return has_exact_arithmetic();
}

Result<BranchesReport> branches_of(const Model& model, const BranchesSettings& settings) {
  const Model::Data& data = model.data();
  if (std::string fault = first_unmet({positive("setting tolerance", settings.tolerance)}); !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  const auto schedule = first_schedule(data);
  if (!schedule) {
    return tl::unexpected(schedule.error());
  }
  const auto branches = list_branches(data.profile.mechanism, schedule->first_positions());
  if (!branches) {
    return tl::unexpected(error_about(data, ErrorKind::kMechanism, branches.error().reason));
  }
  BranchesReport report = report_on(data.profile, *schedule, *branches);
  report.certified = settings.certify;
  for (const ContactPlace& place : branches->contacts) {
    auto contact = list_contact(data, place, settings.certify);
    if (!contact) {
      return tl::unexpected(std::move(contact.error()));
    }
    report.contacts.push_back(*std::move(contact));
  }
  if (is_empty(report)) {
    const auto run = start_run(run_model(data), schedule->first_positions(), settings.tolerance);
    if (!run) {
      return tl::unexpected(error_about(
          data, ErrorKind::kMechanism,
          run.error().reason + start_advice(data.profile, schedule->first_positions(), settings.tolerance)));
    }
  }
  return report;
}

}  // namespace higherpair
