#include "branches_report.hpp"
#include "json_text.hpp"
#include "number_text.hpp"
#include "unit_columns.hpp"

#include <cmath>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

constexpr double kPlaceRounding = 1e-12;  // of a place, relative to its distance from the origin

// A coordinate of a place, or 0 if it is that to within rounding.
double without_rounding(double coordinate, double distance) {
  return std::abs(coordinate) <= kPlaceRounding * distance ? 0 : coordinate;
}

std::string contact_text(const BranchesReport& report, const ContactReport& contact) {
  std::string text = fmt::format("\ncontact {}: {} {}\n", contact.contact, contact.entries.size(),
                                 contact.entries.size() == 1 ? "position" : "positions");
  if (!contact.note.empty()) {
    return text + contact.note + "\n";
  }
  text += fmt::format("\n{:>20}{:>18}{:>18}{:>18}  opposed free\n",
                      title(contact.joint, contact.position_unit), title("x", report.length_unit),
                      title("y", report.length_unit), title("normal", report.angle_unit));
  for (const ContactEntry& entry : contact.entries) {
    const double far = std::hypot(entry.x, entry.y);
    text += fmt::format("{:>20.12g}{:>18.10g}{:>18.10g}{:>18.10g}  {:<8}{}{}\n", entry.position,
                        without_rounding(entry.x, far), without_rounding(entry.y, far), entry.normal,
                        entry.opposed ? "yes" : "no", entry.free ? "yes" : "no",
                        entry.remark.empty() ? "" : "   " + entry.remark);
    if (entry.certified) {
      text += fmt::format("{:>20}in [{}, {}]\n", "", (*entry.certified)[0], (*entry.certified)[1]);
    }
  }
  text += contact.proof.empty() ? "" : "\n" + contact.proof + "\n";
  return contact.certificate.empty() ? text : text + "\n" + contact.certificate + "\n";
}

std::string assemblies_text(const BranchesReport& report) {
  std::string text = fmt::format("\nassemblies: {}{}\n\n", report.assemblies.size(),
                                 report.complete ? "" : " (there may be more)");
  for (std::size_t i = 0; i < report.joints.size(); ++i) {
    text += fmt::format("{:>24}", title(report.joints[i], report.joint_units[i]));
  }
  for (const std::vector<double>& assembly : report.assemblies) {
    text += '\n';
    for (const double position : assembly) {
      text += fmt::format("{:>24.12g}", position);
    }
  }
  return text + "\n";
}

}  // namespace

std::string branches_text(const BranchesReport& report) {
  std::string text = report.title.empty() ? "" : report.title + "\n\n";
  text += report.drivers + "\n";
  for (const ContactReport& contact : report.contacts) {
    text += contact_text(report, contact);
  }
  return text + assemblies_text(report);
}

std::string branches_csv(const BranchesReport& report) {
  std::vector<std::string> units;
  for (const ContactReport& contact : report.contacts) {
    units.push_back(contact.position_unit);
  }
  const UnitColumns columns(units);
  std::string text =
      "contact" + columns.heads("position") +
      fmt::format(",x[{0}],y[{0}],normal[{1}],opposed,free", report.length_unit, report.angle_unit);
  if (report.certified) {
    text += columns.heads("certified_low") + columns.heads("certified_high");
  }
  text += '\n';
  for (const ContactReport& contact : report.contacts) {
    const std::string& unit = contact.position_unit;
    for (const ContactEntry& entry : contact.entries) {
      text += fmt::format("{}{},{},{},{},{},{}", contact.contact, columns.cells(unit, entry.position),
                          entry.x, entry.y, entry.normal, entry.opposed, entry.free);
      if (report.certified) {
        const auto& interval = entry.certified;
        text += columns.cells(unit, interval ? std::optional((*interval)[0]) : std::nullopt) +
                columns.cells(unit, interval ? std::optional((*interval)[1]) : std::nullopt);
      }
      text += '\n';
    }
  }
  return text;
}

std::string branches_json(const BranchesReport& report) {
  nlohmann::ordered_json json;
  json["driver"] = report.driver;
  json["contacts"] = nlohmann::ordered_json::array();
  for (const ContactReport& contact : report.contacts) {
    for (const ContactEntry& entry : contact.entries) {
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
  json["lists"] = nlohmann::ordered_json::array();
  for (const ContactReport& contact : report.contacts) {
    json["lists"].push_back(
        {{"contact", contact.contact}, {"complete", contact.complete}, {"undecided", contact.undecided}});
  }
  json["assemblies"] = nlohmann::ordered_json::array();
  for (const std::vector<double>& assembly : report.assemblies) {
    nlohmann::ordered_json position;
    for (std::size_t i = 0; i < assembly.size(); ++i) {
      position[report.joints[i]] = assembly[i];
    }
    json["assemblies"].push_back({{"position", position}});
  }
  return document_of(json);
}

}  // namespace higherpair::cli
