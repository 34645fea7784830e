#include "branches_command.hpp"

#include "higherpair/analysis/branches.hpp"
#include "higherpair/contact/certify.hpp"
#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile_reader.hpp"
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

// All positions of one follower.
struct ContactReport {
  std::string contact;
  std::string joint;
  std::string position_unit;
  std::vector<Entry> entries;
  std::string note;         ///< why there is no list, or empty
  std::string certificate;  ///< what was certified; empty: not asked for
};

struct Report {
  std::string title;
  std::string length_unit;
  std::string angle_unit;
  std::string drivers;  ///< in words
  double driver = 0;
  std::vector<ContactReport> contacts;
  std::vector<std::string> joints;
  std::vector<std::string> joint_units;
  std::vector<std::vector<double>> assemblies;
  bool complete = true;
  bool certified = false;
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

Entry entry_of(const CurveContact& contact, const Profile& profile, const ContactPlace& place) {
  const CarriedBody& follower = place.follower;
  const bool turns = follower.freedom.turns;
  const Scaling length = from_si(dimension::kLength, profile.units);
  const Scaling angle = from_si(dimension::kAngle, profile.units);
  // A turning joint's coordinate starts at the turn that is nearest to the poses.
  const double q = contact.q - place.carrier_angle;
  const bool reversed = !place.known_is_first && contact.opposed;
  const Vector2d n_W = reversed ? Vector2d(-contact.n_W) : contact.n_W;
  Entry entry;
  entry.position =
      plus_zero((turns ? angle : length).apply(follower.sign * (turns ? nearest_turn(q, place.posed) : q)));
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
                                        const ContactPlace& place) {
  const double sign = place.follower.sign;
  const Scaling scaling =
      from_si(place.follower.freedom.turns ? dimension::kAngle : dimension::kLength, profile.units);
  // The position may be a turn away from q: the interval keeps its place about it.
  const auto bound = [&](double q_bound, double towards) {
    return std::nextafter(entry.position + scaling.apply(sign * (q_bound - q_of_contact)), towards);
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const double a = bound(q[0], -sign * infinity);
  const double b = bound(q[1], sign * infinity);
  return {std::min(a, b), std::max(a, b)};
}

nlohmann::ordered_json json_of(const Report& report) {
  nlohmann::ordered_json json;
  json["driver"] = report.driver;
  json["contacts"] = nlohmann::ordered_json::array();
  for (const ContactReport& contact : report.contacts) {
    for (const Entry& entry : contact.entries) {
      json["contacts"].push_back({{"contact", contact.contact},
                                  {"position", entry.position},
                                  {"x", entry.x},
                                  {"y", entry.y},
                                  {"normal", entry.normal},
                                  {"opposed", entry.opposed},
                                  {"free", entry.free}});
      if (entry.certified) {
        json["contacts"].back()["certified"] = *entry.certified;
      } else if (report.certified) {
        json["contacts"].back()["certified"] = nullptr;
      }
    }
  }
  json["assemblies"] = nlohmann::ordered_json::array();
  for (const std::vector<double>& assembly : report.assemblies) {
    nlohmann::ordered_json position;
    for (std::size_t i = 0; i < assembly.size(); ++i) {
      position[report.joints[i]] = assembly[i];
    }
    json["assemblies"].push_back({{"position", position}});
  }
  return json;
}

std::string csv_of(const Report& report) {
  const std::string& length = report.length_unit;
  const std::string position_unit = report.contacts.empty() ? "1" : report.contacts.front().position_unit;
  std::string text = fmt::format("contact,position[{}],x[{}],y[{}],normal[{}],opposed,free", position_unit,
                                 length, length, report.angle_unit);
  if (report.certified) {
    text += fmt::format(",certified_low[{0}],certified_high[{0}]", position_unit);
  }
  text += '\n';
  for (const ContactReport& contact : report.contacts) {
    for (const Entry& entry : contact.entries) {
      text += fmt::format("{},{},{},{},{},{},{}", contact.contact, entry.position, entry.x, entry.y,
                          entry.normal, entry.opposed, entry.free);
      if (entry.certified) {
        text += fmt::format(",{},{}", (*entry.certified)[0], (*entry.certified)[1]);
      } else if (report.certified) {
        text += ",,";
      }
      text += '\n';
    }
  }
  return text;
}

std::string head(const std::string& name, const std::string& unit) {
  return name + " [" + unit + "]";
}

std::string contact_text(const Report& report, const ContactReport& contact) {
  std::string text = fmt::format("\ncontact {}: {} {}\n", contact.contact, contact.entries.size(),
                                 contact.entries.size() == 1 ? "position" : "positions");
  if (!contact.note.empty()) {
    return text + contact.note + "\n";
  }
  text += fmt::format("\n{:>20}{:>18}{:>18}{:>18}  opposed free\n",
                      head(contact.joint, contact.position_unit), head("x", report.length_unit),
                      head("y", report.length_unit), head("normal", report.angle_unit));
  for (const Entry& entry : contact.entries) {
    text += fmt::format("{:>20.12g}{:>18.10g}{:>18.10g}{:>18.10g}  {:<8}{}{}\n", entry.position, entry.x,
                        entry.y, entry.normal, entry.opposed ? "yes" : "no", entry.free ? "yes" : "no",
                        entry.remark.empty() ? "" : "   " + entry.remark);
    if (entry.certified) {
      text += fmt::format("{:>20}in [{}, {}]\n", "", (*entry.certified)[0], (*entry.certified)[1]);
    }
  }
  return contact.certificate.empty() ? text : text + "\n" + contact.certificate + "\n";
}

std::string assemblies_text(const Report& report) {
  std::string text = fmt::format("\nassemblies: {}{}\n\n", report.assemblies.size(),
                                 report.complete ? "" : " (there may be more)");
  for (std::size_t i = 0; i < report.joints.size(); ++i) {
    text += fmt::format("{:>24}", head(report.joints[i], report.joint_units[i]));
  }
  for (const std::vector<double>& assembly : report.assemblies) {
    text += '\n';
    for (const double position : assembly) {
      text += fmt::format("{:>24.12g}", position);
    }
  }
  return text + "\n";
}

std::string text_of(const Report& report) {
  std::string text = report.title.empty() ? "" : report.title + "\n\n";
  text += report.drivers + "\n";
  for (const ContactReport& contact : report.contacts) {
    text += contact_text(report, contact);
  }
  return text + assemblies_text(report);
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
    for (const ContactReport& contact : report.contacts) {
      for (const std::string& remark : {contact.note, contact.certificate}) {
        if (!remark.empty()) {
          fmt::print(stderr, "{}: contacts.{}: {}\n", options.profile, contact.contact, remark);
        }
      }
    }
  }
  return good ? kExitOk : kExitMachine;
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
      report.entries[i].certified =
          position_interval(*interval, found.contacts[i].q, report.entries[i], profile, place);
    }
  }
}

int fail(const BranchesOptions& options, const std::string& reason) {
  fmt::print(stderr, "{}: {}\n", options.profile, reason);
  return kExitMechanism;
}

std::string unit_of(const Profile& profile, bool turns) {
  return unit_text(turns ? dimension::kAngle : dimension::kLength, profile.units);
}

Report make_report(const Profile& profile, const DriverSchedule& schedule, const Branches& branches) {
  const Mechanism& mechanism = profile.mechanism;
  Report report;
  report.title = mechanism.title;
  report.length_unit = unit_of(profile, false);
  report.angle_unit = unit_of(profile, true);
  report.driver = schedule.state(0).profile.position;
  report.complete = branches.complete;
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    const Driver& driver = mechanism.drivers[i];
    const bool turns = mechanism.joints[static_cast<std::size_t>(driver.joint)].type == JointType::kRevolute;
    report.drivers +=
        fmt::format("{}driver{}{} = {} {}", i == 0 ? "" : ", ", driver.name.empty() ? "" : ".", driver.name,
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
      positions.push_back(plus_zero(
          from_si(turns ? dimension::kAngle : dimension::kLength, profile.units).apply(assembly[i])));
    }
  }
  return report;
}

// The joint of a follower on its carrier.
std::string joint_name(const Mechanism& mechanism, const CarriedBody& carried) {
  for (const Joint& joint : mechanism.joints) {
    const bool joins = (joint.first.body == carried.body && joint.second.body == carried.carrier) ||
                       (joint.first.body == carried.carrier && joint.second.body == carried.body);
    if (joins && can_be_driven(joint.type)) {
      return joint.name;
    }
  }
  return "";
}

// Lists the positions of one follower; an error ends the command with its exit code.
tl::expected<ContactReport, int> list_contact(const BranchesOptions& options, const Profile& profile,
                                              const ContactPlace& place) {
  ContactReport report;
  report.contact = profile.mechanism.contacts[static_cast<std::size_t>(place.contact)].name;
  report.joint = joint_name(profile.mechanism, place.follower);
  report.position_unit = unit_of(profile, place.follower.freedom.turns);
  const CurveContacts found = find_curve_contacts(place.pair, place.u);
  if (found.status == ContactsStatus::kNoPair) {
    return tl::unexpected(
        fail(options, "contacts." + report.contact + ": " + std::string(describe(found.status))));
  }
  if (found.status != ContactsStatus::kComplete) {
    report.note = describe(found.status);
  }
  for (const CurveContact& contact : found.contacts) {
    report.entries.push_back(entry_of(contact, profile, place));
  }
  if (options.certify) {
    const Certificate certificate = certify_contacts(place.pair, place.u, found);
    if (certificate.status == CertificateStatus::kDisagreement) {
      fmt::print(stderr, "{}: contacts.{}: {}\n", options.profile, report.contact,
                 describe(certificate.status));
      return tl::unexpected(kExitMachine);
    }
    add_certificate(certificate, found, profile, place, report);
  }
  return report;
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
  std::vector<double> drivers;
  for (std::size_t i = 0; i < schedule->driver_count(); ++i) {
    drivers.push_back(schedule->state(0, i).si.position);
  }
  const auto branches = list_branches(profile->mechanism, drivers);
  if (!branches) {
    return fail(options, branches.error().reason);
  }
  Report report = make_report(*profile, *schedule, *branches);
  report.certified = options.certify;
  for (const ContactPlace& place : branches->contacts) {
    auto contact = list_contact(options, *profile, place);
    if (!contact) {
      return contact.error();
    }
    report.contacts.push_back(std::move(*contact));
  }
  return write_all(options, report);
}

}  // namespace higherpair::cli
