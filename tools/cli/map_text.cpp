#include "map_report.hpp"
#include "number_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

// 12 digits; rounding errors of 0 are printed as 0.
std::string rounded(double value) {
  return fmt::format("{:.12g}", std::abs(value) < 1e-13 ? 0.0 : value);
}

std::string free_word(const MapBranchReport& branch) {
  const auto free = [](const MapRow& row) { return row.free; };
  if (std::all_of(branch.rows.begin(), branch.rows.end(), free)) {
    return "yes";
  }
  return std::any_of(branch.rows.begin(), branch.rows.end(), free) ? "partly" : "no";
}

std::string end_word(const MapEndReport& end, int turns) {
  if (end.type == "closed") {
    return turns == 1 ? "closed" : fmt::format("closed, {} turns", turns);
  }
  return end.other ? fmt::format("{} with {}", end.type, *end.other) : end.type;
}

std::string branches_table(const ContactMapReport& contact) {
  std::string text =
      fmt::format("\n{:>8}{:>22}  {:<20}{:>22}  {:<20}{:<9}free\n", "branch",
                  title("from", contact.driver_unit), "", title("to", contact.driver_unit), "", "opposed");
  for (std::size_t i = 0; i < contact.branches.size(); ++i) {
    const MapBranchReport& branch = contact.branches[i];
    const int index = static_cast<int>(i) + 1;
    const bool own = contact.own && contact.own->branch == index;
    text += fmt::format("{:>8}{:>22}  {:<20}{:>22}  {:<20}{:<9}{}\n",
                        (own ? "* " : "") + std::to_string(index), rounded(branch.begin.driver),
                        end_word(branch.begin, branch.turns), rounded(branch.end.driver),
                        end_word(branch.end, branch.turns), branch.opposed ? "yes" : "no", free_word(branch));
  }
  return text;
}

std::string list_of(const std::vector<int>& branches) {
  std::string text;
  for (const int branch : branches) {
    text += (text.empty() ? "" : ", ") + std::to_string(branch);
  }
  return text.empty() ? "-" : text;
}

std::string events_table(const ContactMapReport& contact, const MapReport& report) {
  if (contact.events.empty()) {
    return "\nno folds: nothing stops the driver on any branch\n";
  }
  std::string text =
      fmt::format("\n{:<12}{:>22}{:>26}{:>16}{:>16}  {:<9}branches\n", "", title("at", contact.driver_unit),
                  title(contact.position_joint, contact.position_unit), title("x", report.length_unit),
                  title("y", report.length_unit), "opposed");
  for (const MapEventReport& event : contact.events) {
    text += fmt::format("{:<12}{:>22}{:>26}{:>16.8g}{:>16.8g}  {:<9}{}\n", event.type,
                        rounded(event.at.driver), rounded(event.at.position), event.at.x, event.at.y,
                        event.opposed ? "yes" : "no", list_of(event.branches));
  }
  return text;
}

// The positions where second contacts appear, and where the follower turns back.
std::string marks_text(const ContactMapReport& contact) {
  std::string text;
  for (std::size_t i = 0; i < contact.branches.size(); ++i) {
    const MapBranchReport& branch = contact.branches[i];
    for (const MapRow& row : branch.free_changes) {
      text += fmt::format("branch {}: a second contact of the two bodies at {} {}\n", i + 1,
                          rounded(row.driver), contact.driver_unit);
    }
    if (!branch.opposed) {
      continue;
    }
    for (const MapRow& row : branch.extremes) {
      text +=
          fmt::format("branch {}: the follower turns back at {} {}, where it is at {} {}\n", i + 1,
                      rounded(row.driver), contact.driver_unit, rounded(row.position), contact.position_unit);
    }
  }
  return text.empty() ? text : "\n" + text;
}

std::string neighbour_text(const NeighbourReport& near, const ContactMapReport& contact) {
  return fmt::format("branch {}, {} {} away", near.branch, rounded(near.distance), contact.position_unit);
}

std::string own_text(const ContactMapReport& contact) {
  if (!contact.own) {
    return "\nthe mechanism is on none of these branches\n";
  }
  const OwnBranch& own = *contact.own;
  const MapBranchReport& branch = contact.branches[own.branch - 1];
  std::string text = fmt::format("\n* the mechanism is on branch {}, at {} {} with {} = {} {}\n", own.branch,
                                 rounded(own.driver), contact.driver_unit, contact.position_joint,
                                 rounded(own.position), contact.position_unit);
  if (branch.turns == 0) {
    text += fmt::format("  the driver can go back by {} {} and on by {} {}\n",
                        rounded(own.driver - branch.begin.driver), contact.driver_unit,
                        rounded(branch.end.driver - own.driver), contact.driver_unit);
  }
  if (!own.at_start || !own.nearest) {
    return text + "  no other opposed contact shares a driver position with it\n";
  }
  text += "  next to it there: " + neighbour_text(*own.at_start, contact) + "\n";
  return text + fmt::format("  nearest to it: {}, at {} {}\n", neighbour_text(*own.nearest, contact),
                            rounded(own.nearest->driver), contact.driver_unit);
}

}  // namespace

std::string map_text(const MapReport& report) {
  std::string text = report.title.empty() ? "" : report.title + "\n";
  for (const ContactMapReport& contact : report.contacts) {
    if (!contact.refusal.empty()) {
      text += fmt::format("\ncontact {}: no map: {}\n", contact.contact, contact.refusal);
      continue;
    }
    text +=
        fmt::format("\ncontact {}: {} {}, {} from {} to {} {}\n", contact.contact, contact.branches.size(),
                    contact.branches.size() == 1 ? "branch" : "branches", contact.driver_joint,
                    rounded(contact.start), rounded(contact.end), contact.driver_unit);
    if (!contact.complete) {
      text += "not every branch could be followed to its end: the map is not complete\n";
    }
    text += branches_table(contact) + events_table(contact, report) + marks_text(contact) + own_text(contact);
  }
  return text;
}

}  // namespace higherpair::cli
