#include "higherpair/front/pictures.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

// The parts of a branch on which the bodies do not overlap, or the others, extended to the next free row.
PlotSeries part_of(const MapBranchReport& branch, const std::string& unit, bool free) {
  PlotSeries part;
  part.unit = unit;
  for (std::size_t i = 0; i < branch.rows.size(); ++i) {
    const auto differs = [&](std::size_t other) { return branch.rows[other].free != branch.rows[i].free; };
    const bool at_change = (i > 0 && differs(i - 1)) || (i + 1 < branch.rows.size() && differs(i + 1));
    const bool inside = branch.rows[i].free == free || (!free && at_change);
    part.x.push_back(branch.rows[i].driver);
    part.y.push_back(inside ? branch.rows[i].position : kNoValue);
  }
  return part;
}

bool is_drawn(const PlotSeries& series) {
  return std::any_of(series.y.begin(), series.y.end(), [](double y) { return !std::isnan(y); });
}

void add_branch(const ContactMapReport& contact, std::size_t index, PlotData& plot) {
  const MapBranchReport& branch = contact.branches[index];
  const bool own = contact.own && contact.own->branch == static_cast<int>(index) + 1;
  PlotSeries free = part_of(branch, contact.position_unit, true);
  PlotSeries blocked = part_of(branch, contact.position_unit, false);
  free.name = fmt::format("branch {}{}", index + 1, own ? ", the mechanism's own" : "");
  free.line = own ? PlotLine::kEmphasis : PlotLine::kOwn;
  blocked.name = fmt::format("branch {}, the bodies overlap", index + 1);
  blocked.line = PlotLine::kFaint;
  if (is_drawn(blocked)) plot.series.push_back(std::move(blocked));
  if (is_drawn(free)) plot.series.push_back(std::move(free));
}

void add_points(const ContactMapReport& contact, PlotData& plot) {
  for (const MapEventReport& event : contact.events) {
    const std::string detail =
        fmt::format("{} at {} = {:.6g} {}, {} = {:.6g} {}", event.type, contact.driver_joint, event.at.driver,
                    contact.driver_unit, contact.position_joint, event.at.position, contact.position_unit);
    plot.points.push_back(
        {event.at.driver, event.at.position, contact.position_unit, event.type, event.type, detail});
  }
  if (contact.own) {
    plot.points.push_back({contact.own->driver, contact.own->position, contact.position_unit, "start",
                           "start", "where the mechanism starts"});
  }
}

}  // namespace

std::vector<PlotData> plots_of(const MapReport& map) {
  std::vector<PlotData> plots;
  for (const ContactMapReport& contact : map.contacts) {
    if (!contact.refusal.empty()) continue;
    PlotData& plot = plots.emplace_back();
    plot.title = (map.title.empty() ? "" : map.title + ": ") + "contact " + contact.contact;
    plot.x = {contact.driver_joint, contact.driver_unit};
    plot.y_name = contact.position_joint;
    for (std::size_t i = 0; i < contact.branches.size(); ++i) {
      add_branch(contact, i, plot);
    }
    add_points(contact, plot);
    if (!contact.complete) {
      plot.notes.emplace_back("not every branch could be followed to its end: the map is not complete");
    }
  }
  return plots;
}

}  // namespace higherpair
