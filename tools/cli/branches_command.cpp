#include "branches_command.hpp"

#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "output_file.hpp"
#include "run_command.hpp"

#include <cmath>

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
  std::string note;  ///< why there is no list, or empty
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
  }
  json["assemblies"] = nlohmann::ordered_json::array();
  return json;
}

std::string csv_of(const Report& report) {
  const std::string& length = report.length_unit;
  std::string text = fmt::format("contact,position[{}],x[{}],y[{}],normal[{}],opposed,free\n",
                                 report.position_unit, length, length, report.angle_unit);
  for (const Entry& entry : report.entries) {
    text += fmt::format("{},{},{},{},{},{},{}\n", report.contact, entry.position, entry.x, entry.y,
                        entry.normal, entry.opposed, entry.free);
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
  } else if (!report.note.empty() && !options.quiet) {
    fmt::print(stderr, "{}: contacts.{}: {}\n", options.profile, report.contact, report.note);
  }
  return good ? kExitOk : kExitMachine;
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
  return write_all(options, report);
}

}  // namespace higherpair::cli
