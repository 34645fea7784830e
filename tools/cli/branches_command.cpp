#include "branches_command.hpp"

#include "higherpair/contact/certify.hpp"
#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "output_file.hpp"
#include "run_command.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace higherpair::cli {
namespace {

// One contact in the profile's units.
struct Entry {
  double position = 0;
  double x = 0;
  double y = 0;
  double normal = 0;
  bool opposed = false;
  bool free = false;
  std::string remark;
  std::optional<std::array<double, 2>> certified;  ///< interval of the position
};

struct Report {
  std::string title;
  std::string contact;  ///< empty: the mechanism has none
  std::string joint;
  std::string length_unit;
  std::string angle_unit;
  std::string position_unit;
  std::string driver_unit;
  double driver = 0;
  std::vector<Entry> entries;
  std::string note;         ///< why there is no list, or empty
  std::string certificate;  ///< what was certified; empty: not asked for
};

double plus_zero(double value) {
  return value == 0 ? 0.0 : value;
}

std::string remark_on(const CurveContact& contact) {
  if (contact.coincident) {
    return "the curves coincide";
  }
  if (contact.conforming) {
    return "conforming: equal curvatures";
  }
  return contact.at_limit ? "limit position: two contacts merge" : "";
}

Entry entry_of(const CurveContact& contact, const Profile& profile, const ContactGroup& group) {
  const GroundedBody& follower = group.follower;
  const Body& body = profile.mechanism.bodies[static_cast<std::size_t>(follower.body)];
  const bool turns = follower.freedom.turns;
  const Scaling length = from_si(dimension::kLength, profile.units);
  const Scaling angle = from_si(dimension::kAngle, profile.units);
  // A turning joint's coordinate starts at the turn that is nearest to the poses.
  const double q = turns ? nearest_turn(contact.q, body.guess_theta) : contact.q;
  const bool reversed = !group.driver_is_first && contact.opposed;
  const Vector2d n_W = reversed ? Vector2d(-contact.n_W) : contact.n_W;
  Entry entry;
  entry.position = plus_zero((turns ? angle : length).apply(follower.sign * q));
  entry.x = plus_zero(length.apply(contact.p_W.x()));
  entry.y = plus_zero(length.apply(contact.p_W.y()));
  entry.normal = plus_zero(angle.apply(angle_of(n_W)));
  entry.opposed = contact.opposed;
  entry.free = contact.free;
  entry.remark = remark_on(contact);
  return entry;
}

// The interval of q as one of the position: in the profile's units, rounded outwards.
std::array<double, 2> position_interval(const std::array<double, 2>& q, double q_of_contact,
                                        const Entry& entry, const Profile& profile,
                                        const ContactGroup& group) {
  const bool turns = group.follower.freedom.turns;
  const Scaling scaling = from_si(turns ? dimension::kAngle : dimension::kLength, profile.units);
  // The position may be a turn away from q: the interval keeps its place about it.
  const auto bound = [&](double q_bound, double towards) {
    const double offset = scaling.apply(group.follower.sign * (q_bound - q_of_contact));
    return std::nextafter(entry.position + offset, towards);
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const double a = bound(q[0], -group.follower.sign * infinity);
  const double b = bound(q[1], group.follower.sign * infinity);
  return {std::min(a, b), std::max(a, b)};
}

nlohmann::ordered_json json_of(const Report& report) {
  nlohmann::ordered_json json;
  json["driver"] = report.driver;
  json["contacts"] = nlohmann::ordered_json::array();
  for (const Entry& entry : report.entries) {
    json["contacts"].push_back({{"contact", report.contact},
                                {"position", entry.position},
                                {"x", entry.x},
                                {"y", entry.y},
                                {"normal", entry.normal},
                                {"opposed", entry.opposed},
                                {"free", entry.free}});
    if (entry.certified) {
      json["contacts"].back()["certified"] = *entry.certified;
    } else if (!report.certificate.empty()) {
      json["contacts"].back()["certified"] = nullptr;
    }
  }
  json["assemblies"] = nlohmann::ordered_json::array();
  return json;
}

std::string csv_of(const Report& report) {
  const std::string& length = report.length_unit;
  const bool certified = !report.certificate.empty();
  std::string text = fmt::format("contact,position[{}],x[{}],y[{}],normal[{}],opposed,free",
                                 report.position_unit, length, length, report.angle_unit);
  if (certified) {
    text += fmt::format(",certified_low[{0}],certified_high[{0}]", report.position_unit);
  }
  text += '\n';
  for (const Entry& entry : report.entries) {
    text += fmt::format("{},{},{},{},{},{},{}", report.contact, entry.position, entry.x, entry.y,
                        entry.normal, entry.opposed, entry.free);
    if (entry.certified) {
      text += fmt::format(",{},{}", (*entry.certified)[0], (*entry.certified)[1]);
    } else if (certified) {
      text += ",,";
    }
    text += '\n';
  }
  return text;
}

std::string text_of(const Report& report) {
  std::string text = report.title.empty() ? "" : report.title + "\n\n";
  text += fmt::format("driver = {} {}\n", report.driver, report.driver_unit);
  if (report.contact.empty()) {
    return text + "the mechanism has no contact\n";
  }
  text += fmt::format("contact {}: {} {}\n", report.contact, report.entries.size(),
                      report.entries.size() == 1 ? "position" : "positions");
  if (!report.note.empty()) {
    return text + report.note + "\n";
  }
  const auto head = [](const std::string& name, const std::string& unit) { return name + " [" + unit + "]"; };
  text += fmt::format("\n{:>20}{:>18}{:>18}{:>18}  {:<8}{:<5}\n", head(report.joint, report.position_unit),
                      head("x", report.length_unit), head("y", report.length_unit),
                      head("normal", report.angle_unit), "opposed", "free");
  for (const Entry& entry : report.entries) {
    text += fmt::format("{:>20.12g}{:>18.10g}{:>18.10g}{:>18.10g}  {:<8}{:<5}{}\n", entry.position, entry.x,
                        entry.y, entry.normal, entry.opposed ? "yes" : "no", entry.free ? "yes" : "no",
                        entry.remark);
    if (entry.certified) {
      text += fmt::format("{:>20}in [{}, {}]\n", "", (*entry.certified)[0], (*entry.certified)[1]);
    }
  }
  if (!report.certificate.empty()) {
    text += "\n" + report.certificate + "\n";
  }
  return text;
}

bool write(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
  if (!file.good()) {
    fmt::print(stderr, "higherpair: {}\n", file.error());
  }
  return file.good();
}

int write_all(const BranchesOptions& options, const Report& report) {
  bool good = true;
  if (options.csv) {
    good = write(*options.csv, csv_of(report)) && good;
  }
  if (options.json) {
    good = write(*options.json, json_of(report).dump(2) + "\n") && good;
  }
  if (!options.csv && !options.json) {
    good = write("-", text_of(report));
  } else if (!options.quiet) {
    for (const std::string& remark : {report.note, report.certificate}) {
      if (!remark.empty()) {
        fmt::print(stderr, "{}: contacts.{}: {}\n", options.profile, report.contact, remark);
      }
    }
  }
  return good ? kExitOk : kExitMachine;
}

void add_certificate(const Certificate& certificate, const CurveContacts& found, const Profile& profile,
                     const ContactGroup& group, Report& report) {
  report.certificate = describe(certificate.status);
  if (certificate.status != CertificateStatus::kNotDecided) {
    report.certificate +=
        " (every number of the mechanism to within 2^-50 of itself, the driver's angle as a rational "
        "rotation "
        "within 2^-60, quarter turns exact)";
  }
  for (std::size_t i = 0; i < report.entries.size(); ++i) {
    if (const auto& interval = certificate.intervals[i]) {
      report.entries[i].certified =
          position_interval(*interval, found.contacts[i].q, report.entries[i], profile, group);
    }
  }
}

int fail(const BranchesOptions& options, const std::string& reason) {
  fmt::print(stderr, "{}: {}\n", options.profile, reason);
  return kExitMechanism;
}

}  // namespace

int branches_command(const BranchesOptions& options) {
  const auto profile = read_profile_file(options.profile, options.overrides);
  if (!profile) {
    return report_input(profile.error());
  }
  const auto schedule = DriverSchedule::analyze(*profile);
  if (!schedule) {
    return report_input(schedule.error());
  }
  const auto plan = make_plan(profile->mechanism);
  if (!plan) {
    return fail(options, plan.error());
  }
  const DriverState driver = schedule->state(0);
  const auto unit_of = [&](bool turns) {
    return unit_text(turns ? dimension::kAngle : dimension::kLength, profile->units);
  };
  Report report;
  report.title = profile->mechanism.title;
  report.length_unit = unit_of(false);
  report.angle_unit = unit_of(true);
  report.driver = driver.profile.position;
  report.driver_unit = unit_of(plan->driver.freedom.turns);
  if (!plan->group) {
    return write_all(options, report);
  }
  const ContactGroup& group = *plan->group;
  report.contact = profile->mechanism.contacts[static_cast<std::size_t>(group.contact)].name;
  report.joint = profile->mechanism.joints[static_cast<std::size_t>(group.follower.joint)].name;
  report.position_unit = unit_of(group.follower.freedom.turns);
  const CurveContacts found = find_curve_contacts(group.pair, plan->driver.sign * driver.si.position);
  if (found.status == ContactsStatus::kNoPair) {
    return fail(options, "contacts." + report.contact + ": " + std::string(describe(found.status)));
  }
  if (found.status != ContactsStatus::kComplete) {
    report.note = describe(found.status);
  }
  for (const CurveContact& contact : found.contacts) {
    report.entries.push_back(entry_of(contact, *profile, group));
  }
  if (options.certify) {
    const Certificate certificate =
        certify_contacts(group.pair, plan->driver.sign * driver.si.position, found);
    if (certificate.status == CertificateStatus::kDisagreement) {
      fmt::print(stderr, "{}: contacts.{}: {}\n", options.profile, report.contact,
                 describe(certificate.status));
      return kExitMachine;
    }
    add_certificate(certificate, found, *profile, group, report);
  }
  return write_all(options, report);
}

}  // namespace higherpair::cli
