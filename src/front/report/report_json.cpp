#include "front/columns/column_set.hpp"
#include "front/pictures/jumps.hpp"
#include "front/tolerances.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/numeric/stop.hpp"
#include "packed_series.hpp"
#include "report_data.hpp"
#include "report_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

namespace higherpair {
namespace {

constexpr int kValueDigits = 10;
constexpr double kValueSteps = 4e10;  // into which the largest value of a column is divided

std::vector<double> values_of(const ReportData& data, std::size_t column) {
  std::vector<double> values;
  for (const Row& row : data.rows) values.push_back(row.values[column]);
  return values;
}

void write_values(JsonWriter& json, const ReportData& data, std::size_t column) {
  const auto& [low, high] = data.extremes[column];
  const double largest = std::max(std::abs(low.value), std::abs(high.value));
  const bool words = !data.columns[column].words.empty();
  json.key("values");
  write_packed(json, values_of(data, column), words ? 1 : largest / kValueSteps);
}

// The rows that no line of a plot may join to the row before.
void write_breaks(JsonWriter& json, const ReportData& data, std::size_t column) {
  if (!data.columns[column].words.empty()) return;
  const auto jumps =
      jumps_of(values_of(data, column), data.events, [&](std::int64_t row) { return page_row(data, row); });
  if (jumps.empty()) return;
  json.key("breaks").open('[');
  for (const std::size_t row : jumps) json.integer(static_cast<long long>(row));
  json.close(']');
}

void write_columns(JsonWriter& json, const ReportData& data) {
  json.key("columns").open('[');
  for (std::size_t k = 0; k < data.columns.size(); ++k) {
    const Column& column = data.columns[k];
    json.open('{').key("name").string(column.name).key("unit").string(column.unit);
    json.key("noise").number(kColumnNoise * data.scales[k], 3);
    if (!column.words.empty()) json.key("words").strings(column.words);
    write_values(json, data, k);
    write_breaks(json, data, k);
    json.close('}');
  }
  json.close(']');
}

void write_driver(JsonWriter& json, const Model& model, const ReportData& data) {
  const Mechanism& mechanism = model.mechanism();
  const Driver& driver = mechanism.drivers[data.driver];
  const Joint& joint = driven_joint(mechanism, data.driver);
  json.key("driver").open('{').key("column").string(driver_name(driver));
  json.key("body").integer(joint.second.body == 0 ? joint.first.body : joint.second.body).key("turn");
  if (joint.type == JointType::kRevolute) {
    json.number(full_turn(model.units()), kValueDigits);
  } else {
    json.null();
  }
  json.close('}');
}

void write_contacts(JsonWriter& json, const Mechanism& mechanism) {
  json.key("contacts").open('[');
  for (const Contact& contact : mechanism.contacts) json.string(contact.name);
  json.close(']');
}

void write_facts(JsonWriter& json, const Model& model, const ReportData& data) {
  const Mechanism& mechanism = model.mechanism();
  json.key("facts").open('[');
  for (const Fact& fact : facts_of(mechanism, full_turn(model.units()), data)) {
    json.open('{').key("of").string(fact.of).key("name").string(fact.name);
    json.key("value").number(fact.value, kValueDigits).key("unit").string(fact.unit);
    json.key("column").string(fact.column).key("at").open('[');
    for (const ColumnExtremes::Value& at : fact.at) {
      json.open('{')
          .key("value")
          .number(at.value, kValueDigits)
          .key("driver")
          .number(at.driver, kValueDigits);
      json.key("row").integer(static_cast<long long>(page_row(data, at.row))).close('}');
    }
    json.close(']').close('}');
  }
  json.close(']').key("plots").open('[');
  for (const std::vector<std::string>& plot : first_plots(mechanism, data)) json.strings(plot);
  json.close(']');
}

void write_events(JsonWriter& json, const Model& model, const ReportData& data) {
  json.key("events").open('[');
  for (const Event& event : data.events) {
    json.open('{').key("type").string(name_of(event.type)).key("driver").number(event.driver, kValueDigits);
    if (event.time) json.key("time").number(*event.time, kValueDigits);
    json.key("row").integer(static_cast<long long>(page_row(data, event.row)));
    if (event.value && event.joint) {
      const Joint& joint = model.mechanism().joints[*event.joint];
      json.key("value").number(*event.value, kValueDigits);
      json.key("unit").string(unit_text(coordinate_dimension(joint), model.units()));
    }
    json.key("item").string(event.item).key("cause").string(event.cause).close('}');
  }
  json.close(']');
}

double largest_residual(const ReportData& data) {
  const std::size_t k = column_slot(data.columns, "residual");
  return k < data.columns.size() ? data.extremes[k].high.value : 0;
}

}  // namespace

std::string json_of(const Model& model, const ReportData& data, const std::string& source,
                    const std::atomic<bool>* stop) {
  const Mechanism& mechanism = model.mechanism();
  const Units& units = model.units();
  JsonWriter json;
  json.open('{').key("format").integer(2).key("title").string(mechanism.title);
  json.key("version").string(version()).key("file");
  json.string(std::filesystem::path(model.profile().source).filename().string());
  json.key("source").string(source).key("residual").number(largest_residual(data), 3);
  json.key("good").boolean(data.good).key("size").integer(data.size);
  json.key("lengthUnit").string(name_of(units.length));
  write_driver(json, model, data);
  write_contacts(json, mechanism);
  write_facts(json, model, data);
  write_events(json, model, data);
  write_columns(json, data);
  write_scene(json, model, data);
  const auto go_on = [&] { return !is_raised(stop); };
  if (go_on()) write_polygons(json, model, data);
  if (go_on()) write_maps(json, model, data, stop);
  return json.close('}').take();
}

}  // namespace higherpair
