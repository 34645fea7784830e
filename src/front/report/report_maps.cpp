#include "front/columns/column_set.hpp"
#include "front/pictures/column_scales.hpp"
#include "front/tolerances.hpp"
#include "higherpair/front/contacts.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "packed_series.hpp"
#include "report_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace higherpair {
namespace {

constexpr std::int64_t kMapSamples = 181;  // of a map
constexpr double kWidth = 560;             // of its picture [px]
constexpr double kAxisSteps = 1e5;         // into which an axis is divided

// The column of a joint's coordinate.
std::optional<std::size_t> column_of(const Model& model, const ReportData& data, const std::string& joint) {
  const Mechanism& mechanism = model.mechanism();
  std::string name = joint + ".position";
  for (const Driver& driver : mechanism.drivers) {
    if (mechanism.joints[driver.joint].name != joint) continue;
    name = driver_name(driver);
  }
  const std::size_t slot = column_slot(data.columns, name);
  return slot < data.columns.size() ? std::optional(slot) : std::nullopt;
}

// A whole turn in the unit of a joint's coordinate; none for a slide.
std::optional<double> turn_of(const Model& model, const std::string& name) {
  const auto& joints = model.mechanism().joints;
  const auto joint =
      std::find_if(joints.begin(), joints.end(), [&](const Joint& one) { return one.name == name; });
  if (joint == joints.end() || !has_angle(joint->type)) return std::nullopt;
  return full_turn(model.units());
}

// The branch's position at a driver position; none outside of the branch.
std::optional<double> position_on(const MapBranchReport& branch, double driver) {
  const auto after = std::lower_bound(branch.rows.begin(), branch.rows.end(), driver,
                                      [](const MapRow& row, double at) { return row.driver < at; });
  if (after == branch.rows.end()) return std::nullopt;
  if (after == branch.rows.begin()) {
    return after->driver == driver ? std::optional(after->position) : std::nullopt;
  }
  const MapRow &a = *(after - 1), &b = *after;
  return a.position + (driver - a.driver) / (b.driver - a.driver) * (b.position - a.position);
}

struct MapPlace {
  double driver = kNoValue, position = kNoValue;
  int branch = 0;  ///< from 1
};

// The place of a row in the map: each coordinate is shifted by whole turns so that the place is on the
// nearest branch.
MapPlace place_on(const ContactMapReport& map, double driver, double position, std::optional<double> turn,
                  std::optional<double> follower_turn) {
  MapPlace best;
  double nearest = kInf;
  for (std::size_t i = 0; i < map.branches.size(); ++i) {
    const auto& rows = map.branches[i].rows;
    if (rows.empty()) continue;
    const double lap = turn.value_or(0);
    const double first = turn ? std::ceil((rows.front().driver - driver) / lap - kWholeLap) : 0;
    for (double x = driver + first * lap; x <= rows.back().driver + kWholeLap * std::abs(lap); x += lap) {
      const auto y = position_on(map.branches[i], std::clamp(x, rows.front().driver, rows.back().driver));
      if (!y) break;
      const double shift = follower_turn ? *follower_turn * std::round((*y - position) / *follower_turn) : 0;
      const double away = std::abs(*y - position - shift);
      if (away < nearest) {
        nearest = away;
        best = {x, position + shift, static_cast<int>(i) + 1};
      }
      if (!turn) break;
    }
  }
  return best;
}

void write_map(JsonWriter& json, const Model& model, const ReportData& data, const ContactMapReport& map,
               const PlotData& plot) {
  const auto driver = column_of(model, data, map.driver_joint);
  const auto position = column_of(model, data, map.position_joint);
  const auto turn = turn_of(model, map.driver_joint), follower_turn = turn_of(model, map.position_joint);
  const auto& contacts = model.mechanism().contacts;
  const auto contact = std::find_if(contacts.begin(), contacts.end(),
                                    [&](const Contact& one) { return one.name == map.contact; });
  const auto index = static_cast<std::size_t>(contact - contacts.begin());
  std::vector<double> x, y, branch;
  for (std::size_t k = 0; k < data.rows.size(); ++k) {
    const Row& row = data.rows[k];
    MapPlace place;
    // Bodies that are apart have no contact that could be on the map.
    if (driver && position && row.status != RowStatus::kNotAssemblable &&
        data.motions[k].contacts[index].touches) {
      place = place_on(map, row.values[*driver], row.values[*position], turn, follower_turn);
    }
    x.push_back(place.driver);
    y.push_back(place.position);
    branch.push_back(place.branch > 0 ? place.branch : kNoValue);
  }
  const auto step = [](const std::vector<double>& values) {
    const double largest = largest_of(values);
    return largest > 0 ? largest / kAxisSteps : 1;
  };
  json.open('{').key("contact").string(map.contact).key("picture").string(plots_svg({plot}, kWidth));
  json.key("x");
  write_packed(json, x, step(x));
  json.key("y");
  write_packed(json, y, step(y));
  json.key("branch");
  write_packed(json, branch, 1);
  json.close('}');
}

}  // namespace

void write_maps(JsonWriter& json, const Model& model, const ReportData& data, const std::atomic<bool>* stop) {
  json.key("maps").open('[');
  if (auto maps = map_of(model, {kMapSamples, kMapOverlap, stop}); maps && !maps->stopped) {
    maps->title.clear();
    const std::vector<PlotData> plots = plots_of(*maps);
    std::size_t drawn = 0;
    for (const ContactMapReport& map : maps->contacts) {
      if (map.refusal.empty()) write_map(json, model, data, map, plots[drawn++]);
    }
  }
  json.close(']');
}

}  // namespace higherpair
