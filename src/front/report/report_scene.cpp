#include "front/tolerances.hpp"
#include "higherpair/drawing/picture.hpp"
#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "packed_series.hpp"
#include "report_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

void write(JsonWriter& json, std::span<const double> numbers) {
  json.open('[');
  for (const double number : numbers) {
    json.number(number, kPlaceDigits);
  }
  json.close(']');
}

std::string_view name_of(Shape::Kind kind) {
  static constexpr std::array kNames = {"path", "circle", "arrow", "text"};
  static_assert(kNames.size() == static_cast<std::size_t>(Shape::Kind::kText) + 1);
  return kNames[static_cast<std::size_t>(kind)];
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
    if (!shape.colour.empty()) json.key("colour").string(shape.colour);
    if (shape.outline) json.key("outline").boolean(true);
    if (numbers) {
      json.key("numbers");
      write(json, shape.numbers);
    }
    json.close('}');
  }
  json.close(']');
}

struct RowScene {
  bool defined = false;
  std::vector<Scene::Place> places;
  std::vector<std::vector<double>> moving;  ///< numbers of each shape
};

bool same_place(const RowScene& a, const RowScene& b, const Box& view) {
  const double near = kSamePicture * view.size().norm();
  return a.defined && b.defined &&
         std::equal(a.places.begin(), a.places.end(), b.places.begin(), b.places.end(),
                    [&](const Scene::Place& p, const Scene::Place& q) {
                      return std::hypot(p.x - q.x, p.y - q.y) <= near &&
                             std::abs(std::remainder(p.theta - q.theta, 2 * kPi)) <= kSamePicture;
                    });
}

// One series for each number that a shape has in any row.
void write_moving(JsonWriter& json, const std::vector<RowScene>& rows, std::size_t shape, double step) {
  const auto numbers_in = [&](const RowScene& row) -> std::span<const double> {
    return shape < row.moving.size() ? row.moving[shape] : std::span<const double>();
  };
  std::size_t count = 0;
  for (const RowScene& row : rows) count = std::max(count, numbers_in(row).size());
  json.open('[');
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> series;
    for (const RowScene& row : rows) {
      const auto numbers = numbers_in(row);
      series.push_back(i < numbers.size() ? numbers[i] : kNoValue);
    }
    write_packed(json, series, step);
  }
  json.close(']');
}

void write_places(JsonWriter& json, const std::vector<RowScene>& rows, double step) {
  json.open('[');
  for (std::size_t body = 0; body < rows.front().places.size(); ++body) {
    const auto write = [&](double Scene::Place::*member, double rounding) {
      std::vector<double> series;
      for (const RowScene& row : rows) {
        series.push_back(row.defined ? row.places[body].*member : kNoValue);
      }
      write_packed(json, series, rounding);
    };
    write(&Scene::Place::x, step);
    write(&Scene::Place::y, step);
    write(&Scene::Place::theta, kAngleStep);
  }
  json.close(']');
}

// Drawn size of one unit: mm of an arrow, rad of the arc of a torque.
void write_scales(JsonWriter& json, const Scene& scene, const DrawSettings& units) {
  const auto write = [&](Role role, double scale, const PictureUnit& unit) {
    if (!(scale > 0)) return;
    json.key(higherpair::name_of(role)).open('{').key("unit").string(unit.name);
    json.key("length").number(scale * unit.si, kPlaceDigits).close('}');
  };
  json.key("scales").open('{');
  write(Role::kVelocity, kMillimetres * scene.velocity_scale, units.velocity);
  write(Role::kAcceleration, kMillimetres * scene.acceleration_scale, units.acceleration);
  write(Role::kForce, scene.force_scale, units.force);
  if (scene.torque_scale > 0) {
    json.key("torque").open('{').key("unit").string(units.torque.name);
    json.key("turn").number(scene.torque_scale * units.torque.si, kPlaceDigits).close('}');
  }
  json.close('}');
}

}  // namespace

void write_scene(JsonWriter& json, const Model& model, const ReportData& data) {
  const Mechanism& mechanism = model.mechanism();
  SceneMaker maker(mechanism, data.motions, {}, data.reactions, model.profile().looks);
  std::vector<RowScene> rows;
  std::vector<Shape> shapes;
  for (std::size_t k = 0; k < data.motions.size(); ++k) {
    const Scene& scene = maker.at(data.motions[k], data.reactions.empty() ? nullptr : &data.reactions[k]);
    if (shapes.size() < scene.moving.size()) shapes = scene.moving;
    RowScene& row = rows.emplace_back(RowScene{scene.defined, scene.places, {}});
    for (const Shape& shape : scene.moving) row.moving.push_back(shape.numbers);
  }
  const Scene& scene = maker.scene();
  const double size = scene.view.size().norm();
  json.key("scene").open('{').key("view");
  write(json, std::vector{scene.view.low.x(), scene.view.low.y(), scene.view.high.x(), scene.view.high.y()});
  json.key("unit").number(scene.unit, kPlaceDigits).key("bodies").open('[');
  for (const Body& body : mechanism.bodies) json.string(body.name);
  json.close(']');
  write_shapes(json, "fixed", scene.fixed, true);
  write_shapes(json, "moving", shapes, false);
  write_scales(json, scene, draw_settings(model.units()));
  json.close('}');
  json.key("closed").boolean(rows.size() > 2 && same_place(rows.front(), rows.back(), scene.view));
  json.key("count").integer(static_cast<long long>(rows.size()));
  json.key("places");
  write_places(json, rows, kPlaceStep * size);
  json.key("moving").open('[');
  for (std::size_t i = 0; i < shapes.size(); ++i) write_moving(json, rows, i, kShapeStep * size);
  json.close(']');
}

}  // namespace higherpair
