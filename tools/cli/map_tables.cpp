#include "json_text.hpp"
#include "map_report.hpp"
#include "signals.hpp"
#include "unit_columns.hpp"

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

// The columns for one coordinate of all contacts.
UnitColumns columns_of(const MapReport& report, std::string ContactMapReport::*unit) {
  std::vector<std::string> units;
  for (const ContactMapReport& contact : report.contacts) {
    if (contact.refusal.empty()) {
      units.push_back(contact.*unit);
    }
  }
  return UnitColumns(units);
}

using Json = nlohmann::ordered_json;

Json json_of(const MapEndReport& end) {
  return {{"type", end.type},
          {"driver", end.driver},
          {"position", end.position},
          {"other", end.other ? Json(*end.other) : Json()}};
}

Json json_of(const std::vector<MapRow>& rows) {
  Json json = Json::array();
  for (const MapRow& row : rows) {
    json.push_back({{"driver", row.driver}, {"position", row.position}, {"x", row.x}, {"y", row.y}});
  }
  return json;
}

Json json_of(const std::optional<NeighbourReport>& neighbour) {
  if (!neighbour) {
    return nullptr;
  }
  return {{"branch", neighbour->branch}, {"driver", neighbour->driver}, {"distance", neighbour->distance}};
}

Json branches_of(const ContactMapReport& contact) {
  Json branches = Json::array();
  for (std::size_t i = 0; i < contact.branches.size(); ++i) {
    const MapBranchReport& branch = contact.branches[i];
    branches.push_back({{"branch", i + 1},
                        {"opposed", branch.opposed},
                        {"turns", branch.turns},
                        {"begin", json_of(branch.begin)},
                        {"end", json_of(branch.end)},
                        {"second_contacts", json_of(branch.free_changes)},
                        {"extremes", json_of(branch.extremes)}});
  }
  return branches;
}

Json events_of(const ContactMapReport& contact) {
  Json events = Json::array();
  for (const MapEventReport& event : contact.events) {
    events.push_back({{"type", event.type},
                      {"driver", event.at.driver},
                      {"position", event.at.position},
                      {"x", event.at.x},
                      {"y", event.at.y},
                      {"normal", event.at.normal},
                      {"opposed", event.opposed},
                      {"branches", event.branches}});
  }
  return events;
}

Json json_of(const ContactMapReport& contact) {
  if (!contact.refusal.empty()) {
    return {{"contact", contact.contact}, {"refusal", contact.refusal}};
  }
  Json json = {{"contact", contact.contact},
               {"driver",
                {{"joint", contact.driver_joint},
                 {"unit", contact.driver_unit},
                 {"start", contact.start},
                 {"end", contact.end}}},
               {"position", {{"joint", contact.position_joint}, {"unit", contact.position_unit}}},
               {"complete", contact.complete},
               {"branches", branches_of(contact)},
               {"events", events_of(contact)},
               {"own", nullptr}};
  if (contact.own) {
    json["own"] = {{"branch", contact.own->branch},
                   {"driver", contact.own->driver},
                   {"position", contact.own->position},
                   {"neighbour", json_of(contact.own->at_start)},
                   {"nearest", json_of(contact.own->nearest)}};
  }
  return json;
}

}  // namespace

std::string map_csv(const MapReport& report) {
  const UnitColumns drivers = columns_of(report, &ContactMapReport::driver_unit);
  const UnitColumns positions = columns_of(report, &ContactMapReport::position_unit);
  std::string text =
      "contact,branch" + drivers.heads("driver") + positions.heads("position") +
      fmt::format(",x[{0}],y[{0}],normal[{1}],opposed,free\n", report.length_unit, report.angle_unit);
  for (const ContactMapReport& contact : report.contacts) {
    for (std::size_t i = 0; i < contact.branches.size(); ++i) {
      const MapBranchReport& branch = contact.branches[i];
      for (const MapRow& row : branch.rows) {
        if (interruption()) {
          return "";
        }
        text += fmt::format("{},{}{}{},{},{},{},{},{}\n", contact.contact, i + 1,
                            drivers.cells(contact.driver_unit, row.driver),
                            positions.cells(contact.position_unit, row.position), row.x, row.y, row.normal,
                            branch.opposed, row.free);
      }
    }
  }
  return text;
}

std::string map_json(const MapReport& report) {
  Json contacts = Json::array();
  std::string rows;
  for (const ContactMapReport& contact : report.contacts) {
    contacts.push_back(json_of(contact));
    for (std::size_t i = 0; i < contact.branches.size(); ++i) {
      const MapBranchReport& branch = contact.branches[i];
      for (const MapRow& row : branch.rows) {
        if (interruption()) {
          return "";
        }
        rows += rows.empty() ? "" : ",";
        rows += text_of(Json::array({contact.contact, i + 1, row.driver, row.position, row.x, row.y,
                                     row.normal, branch.opposed, row.free}));
      }
    }
  }
  // Units of driver and position depend on the row's contact.
  const Json columns = {{{"name", "contact"}, {"unit", nullptr}},
                        {{"name", "branch"}, {"unit", nullptr}},
                        {{"name", "driver"}, {"unit", nullptr}},
                        {{"name", "position"}, {"unit", nullptr}},
                        {{"name", "x"}, {"unit", report.length_unit}},
                        {{"name", "y"}, {"unit", report.length_unit}},
                        {{"name", "normal"}, {"unit", report.angle_unit}},
                        {{"name", "opposed"}, {"unit", nullptr}},
                        {{"name", "free"}, {"unit", nullptr}}};
  std::string text =
      text_of(Json{{"format", 1}, {"title", report.title}, {"contacts", contacts}, {"columns", columns}});
  text.pop_back();  // without its closing brace: the rows, the bulk of a long map, are appended as text
  return text + ",\"rows\":[" + rows + "]}\n";
}

}  // namespace higherpair::cli
