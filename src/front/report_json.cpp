#include "higherpair/drawing/scene.hpp"
#include "json_writer.hpp"
#include "report_data.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace higherpair {
namespace {

constexpr int kPlaceDigits = 8;
constexpr int kShapeDigits = 6;  // of what is drawn in one row alone
constexpr int kValueDigits = 10;
constexpr double kMillimetres = 1000;  // in a metre
constexpr double kSamePlace = 1e-6;    // of the picture, and [rad]: first and last row show one picture

void write(JsonWriter& json, std::span<const double> numbers, int digits) {
  json.open('[');
  for (const double number : numbers) {
    json.number(number, digits);
  }
  json.close(']');
}

// The number that a column has in every row is written once.
void write_values(JsonWriter& json, const ReportData& data, std::size_t column) {
  std::vector<double> values;
  for (const Row& row : data.rows) {
    values.push_back(row.values[column]);
  }
  const bool constant =
      std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
  json.key("values");
  write(json, std::span(values).first(constant ? 1 : values.size()), kValueDigits);
}

void write_columns(JsonWriter& json, const ReportData& data) {
  json.key("columns").open('[');
  for (std::size_t k = 0; k < data.columns.size(); ++k) {
    const Column& column = data.columns[k];
    json.open('{').key("name").string(column.name).key("unit").string(column.unit);
    json.key("noise").number(kNoise * data.scales[k], 3);
    if (!column.words.empty()) {
      json.key("words").open('[');
      for (const std::string_view word : column.words) json.string(word);
      json.close(']');
    }
    write_values(json, data, k);
    json.close('}');
  }
  json.close(']');
}

std::string_view name_of(Shape::Kind kind) {
  switch (kind) {
    case Shape::Kind::kPath:
      return "path";
    case Shape::Kind::kCircle:
      return "circle";
    case Shape::Kind::kArrow:
      return "arrow";
    case Shape::Kind::kText:
      break;
  }
  return "text";
}

void write_shapes(JsonWriter& json, std::string_view key, const std::vector<Shape>& shapes, bool numbers) {
  json.key(key).open('[');
  for (const Shape& shape : shapes) {
    json.open('{')
        .key("role")
        .string(higherpair::name_of(shape.role))
        .key("kind")
        .string(name_of(shape.kind));
    json.key("name").string(shape.name);
    if (shape.body != 0) json.key("body").integer(shape.body);
    if (shape.closed) json.key("closed").boolean(true);
    if (!shape.text.empty()) json.key("text").string(shape.text);
    if (numbers) {
      json.key("numbers");
      write(json, shape.numbers, kPlaceDigits);
    }
    json.close('}');
  }
  json.close(']');
}

struct RowScene {
  bool defined = false;
  std::vector<Scene::Place> places;
};

void write_moving(JsonWriter& json, const Scene& scene) {
  json.open('[');
  for (const Shape& shape : scene.moving) {
    write(json, shape.numbers, kShapeDigits);
  }
  json.close(']');
}

void write_place(JsonWriter& json, const RowScene& row) {
  if (!row.defined) {
    json.null();
    return;
  }
  json.open('[');
  for (const Scene::Place& place : row.places) {
    json.number(place.x, kPlaceDigits).number(place.y, kPlaceDigits).number(place.theta, kPlaceDigits);
  }
  json.close(']');
}

bool same_place(const RowScene& a, const RowScene& b, const Box& view) {
  const double near = kSamePlace * view.size().norm();
  return a.defined && b.defined &&
         std::equal(a.places.begin(), a.places.end(), b.places.begin(), b.places.end(),
                    [&](const Scene::Place& p, const Scene::Place& q) {
                      return std::hypot(p.x - q.x, p.y - q.y) <= near &&
                             std::abs(std::remainder(p.theta - q.theta, 2 * kPi)) <= kSamePlace;
                    });
}

// Shapes, and where they are in every row.
void write_scene(JsonWriter& json, const Mechanism& mechanism, const ReportData& data) {
  SceneMaker maker(mechanism, data.motions);
  std::vector<RowScene> rows;
  JsonWriter moving;
  std::vector<Shape> shapes;
  moving.open('[');
  for (const MotionRow& motion : data.motions) {
    const Scene& scene = maker.at(motion);
    if (shapes.size() < scene.moving.size()) shapes = scene.moving;
    rows.push_back({scene.defined, scene.places});
    write_moving(moving, scene);
  }
  moving.close(']');
  const Scene& scene = maker.scene();
  json.key("scene").open('{').key("view");
  write(json, std::vector{scene.view.low.x(), scene.view.low.y(), scene.view.high.x(), scene.view.high.y()},
        kPlaceDigits);
  json.key("unit").number(scene.unit, kPlaceDigits).key("bodies").open('[');
  for (const Body& body : mechanism.bodies) json.string(body.name);
  json.close(']');
  write_shapes(json, "fixed", scene.fixed, true);
  write_shapes(json, "moving", shapes, false);
  json.close('}');
  json.key("closed").boolean(rows.size() > 2 && same_place(rows.front(), rows.back(), scene.view));
  json.key("places").open('[');
  for (const RowScene& row : rows) write_place(json, row);
  json.close(']').key("moving").raw(moving.take());
}

void write_driver(JsonWriter& json, const Model& model) {
  const Mechanism& mechanism = model.mechanism();
  const Joint& joint = mechanism.joints[static_cast<std::size_t>(mechanism.drivers.front().joint)];
  json.key("driver").open('{').key("joint").string(joint.name);
  json.key("body").integer(joint.second.body == 0 ? joint.first.body : joint.second.body).key("turn");
  if (joint.type == JointType::kRevolute) {
    json.number(from_si(dimension::kAngle, model.units()).apply(2 * kPi), kValueDigits);
  } else {
    json.null();
  }
  json.close('}');
}

void write_joints(JsonWriter& json, const Mechanism& mechanism) {
  json.key("joints").open('[');
  for (const Joint& joint : mechanism.joints) {
    const auto& body = mechanism.bodies[static_cast<std::size_t>(joint.second.body)];
    const NamedPoint& named = body.points[static_cast<std::size_t>(joint.second.point)];
    const Vector2d point = kMillimetres * named.p_B;
    json.open('{')
        .key("name")
        .string(joint.name)
        .key("at")
        .string(body.name + "." + named.name)
        .key("body")
        .integer(joint.second.body)
        .key("point");
    write(json, std::vector{point.x(), point.y()}, kPlaceDigits);
    json.close('}');
  }
  json.close(']').key("contacts").open('[');
  for (const Contact& contact : mechanism.contacts) json.string(contact.name);
  json.close(']');
}

void write_facts(JsonWriter& json, const Mechanism& mechanism, const ReportData& data) {
  json.key("facts").open('[');
  for (const Fact& fact : facts_of(mechanism, data)) {
    json.open('{').key("of").string(fact.of).key("name").string(fact.name);
    json.key("value").number(fact.value, kValueDigits).key("unit").string(fact.unit);
    json.key("column").string(fact.column).key("at").open('[');
    for (const Extremes::Value& at : fact.at) {
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
  for (const std::vector<std::string>& plot : first_plots(mechanism, data)) {
    json.open('[');
    for (const std::string& column : plot) json.string(column);
    json.close(']');
  }
  json.close(']');
}

void write_events(JsonWriter& json, const ReportData& data) {
  json.key("events").open('[');
  for (const Event& event : data.events) {
    json.open('{').key("type").string(name_of(event.type)).key("driver").number(event.driver, kValueDigits);
    if (event.time) json.key("time").number(*event.time, kValueDigits);
    json.key("row").integer(static_cast<long long>(page_row(data, event.row)));
    json.key("item").string(event.item).key("cause").string(event.cause).close('}');
  }
  json.close(']');
}

double largest_residual(const ReportData& data) {
  for (std::size_t k = 0; k < data.columns.size(); ++k) {
    if (data.columns[k].name == "residual") return data.extremes[k].high.value;
  }
  return 0;
}

}  // namespace

std::string json_of(const Model& model, const ReportData& data, const std::string& source) {
  const Mechanism& mechanism = model.mechanism();
  const Units& units = model.units();
  JsonWriter json;
  json.open('{').key("format").integer(1).key("title").string(mechanism.title);
  json.key("description").string(mechanism.description);
  json.key("version").string(HIGHERPAIR_VERSION).key("file");
  json.string(std::filesystem::path(model.profile().source).filename().string());
  json.key("source").string(source).key("residual").number(largest_residual(data), 3);
  json.key("good").boolean(data.good).key("size").integer(data.size);
  json.key("lengthUnit").string(name_of(units.length));
  json.key("lengthPerMm").number(from_si(dimension::kLength, units).apply(1 / kMillimetres), kValueDigits);
  write_driver(json, model);
  write_joints(json, mechanism);
  write_facts(json, mechanism, data);
  write_events(json, data);
  write_columns(json, data);
  write_scene(json, mechanism, data);
  return json.close('}').take();
}

}  // namespace higherpair
