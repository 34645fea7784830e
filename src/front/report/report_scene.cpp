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
#include <deque>

namespace higherpair {
namespace {

// Browsers round coordinates, sizes of letters and widths of lines in ways that suit pictures some hundred
// units across. So the page has such a unit of length, whatever the size of the mechanism: this many per mm.
double page_units(const Box& view) {
  const double power = 2 - std::floor(std::log10(view.size().norm()));
  return std::isfinite(power) ? std::pow(10, power) : 1;
}

void write(JsonWriter& json, std::span<const double> numbers, double factor) {
  json.open('[');
  for (const double number : numbers) {
    json.number(factor * number, kPlaceDigits);
  }
  json.close(']');
}

std::string_view name_of(Shape::Kind kind) {
  static constexpr std::array kNames = {"path", "circle", "arrow", "text"};
  static_assert(kNames.size() == static_cast<std::size_t>(Shape::Kind::kText) + 1);
  return kNames[static_cast<std::size_t>(kind)];
}

// \param per_mm  of the unit of the numbers, which are left out if it is 0
template <class Shapes>
void write_shapes(JsonWriter& json, std::string_view key, const Shapes& shapes, double per_mm) {
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
    if (per_mm > 0) {
      json.key("numbers");
      write(json, shape.numbers, per_mm);
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
void write_moving(JsonWriter& json, const std::vector<RowScene>& rows, std::size_t shape, double per_mm,
                  double step) {
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
      series.push_back(i < numbers.size() ? per_mm * numbers[i] : kNoValue);
    }
    write_packed(json, series, step);
  }
  json.close(']');
}

void write_places(JsonWriter& json, const std::vector<RowScene>& rows, double per_mm, double step) {
  json.open('[');
  for (std::size_t body = 0; body < rows.front().places.size(); ++body) {
    const auto write = [&](double Scene::Place::*member, double factor, double rounding) {
      std::vector<double> series;
      for (const RowScene& row : rows) {
        series.push_back(row.defined ? factor * row.places[body].*member : kNoValue);
      }
      write_packed(json, series, rounding);
    };
    write(&Scene::Place::x, per_mm, step);
    write(&Scene::Place::y, per_mm, step);
    write(&Scene::Place::theta, 1, kAngleStep);
  }
  json.close(']');
}

// Drawn size of one unit: length of an arrow, rad of the arc of a torque.
void write_scales(JsonWriter& json, const Scene& scene, double per_mm, const DrawSettings& units) {
  const auto write = [&](Role role, double scale, const PictureUnit& unit) {
    if (!(scale > 0)) return;
    json.key(higherpair::name_of(role)).open('{').key("unit").string(unit.name);
    json.key("length").number(per_mm * scale * unit.si, kPlaceDigits).close('}');
  };
  json.key("scales").open('{');
  write(Role::kVelocity, kMillimetresPerMetre * scene.velocity_scale, units.velocity);
  write(Role::kAcceleration, kMillimetresPerMetre * scene.acceleration_scale, units.acceleration);
  write(Role::kForce, scene.force_scale, units.force);
  if (scene.torque_scale > 0) {
    json.key("torque").open('{').key("unit").string(units.torque.name);
    json.key("turn").number(scene.torque_scale * units.torque.si, kPlaceDigits).close('}');
  }
  json.close('}');
}

void write_joints(JsonWriter& json, const Mechanism& mechanism, double per_mm) {
  json.key("joints").open('[');
  for (const Joint& joint : mechanism.joints) {
    const auto& body = mechanism.bodies[joint.second.body];
    const NamedPoint& named = body.points[joint.second.point];
    json.open('{').key("name").string(joint.name).key("at").string(body.name + "." + named.name);
    json.key("body").integer(joint.second.body).key("point");
    write(json, std::array{named.p_B.x(), named.p_B.y()}, kMillimetresPerMetre * per_mm);
    json.close('}');
  }
  json.close(']');
}

}  // namespace

void write_scene(JsonWriter& json, const Model& model, const ReportData& data) {
  const Mechanism& mechanism = model.mechanism();
  SceneMaker maker(mechanism, data.motions, {}, data.reactions, model.profile().looks);
  std::vector<RowScene> rows;
  std::deque<Shape> shapes;
  for (std::size_t k = 0; k < data.motions.size(); ++k) {
    const Scene& scene = maker.at(data.motions[k], data.reactions.empty() ? nullptr : &data.reactions[k]);
    if (shapes.size() < scene.moving.size()) shapes = scene.moving;
    RowScene& row = rows.emplace_back(RowScene{scene.defined, scene.places, {}});
    for (const Shape& shape : scene.moving) row.moving.push_back(shape.numbers);
  }
  const Scene& scene = maker.scene();
  const double per_mm = page_units(scene.view);
  const double size = per_mm * scene.view.size().norm();
  const double length = from_si(dimension::kLength, model.units()).apply(1 / kMillimetresPerMetre);
  json.key("lengthPerUnit").number(length / per_mm, kPlaceDigits + 2);
  write_joints(json, mechanism, per_mm);
  json.key("scene").open('{').key("view");
  write(json, std::vector{scene.view.low.x(), scene.view.low.y(), scene.view.high.x(), scene.view.high.y()},
        per_mm);
  json.key("unit").number(per_mm * scene.unit, kPlaceDigits).key("bodies").open('[');
  for (const Body& body : mechanism.bodies) json.string(body.name);
  json.close(']');
  write_shapes(json, "fixed", scene.fixed, per_mm);
  write_shapes(json, "moving", shapes, 0);
  write_scales(json, scene, per_mm, draw_settings(model.units()));
  json.close('}');
  json.key("closed").boolean(rows.size() > 2 && same_place(rows.front(), rows.back(), scene.view));
  json.key("count").integer(static_cast<long long>(rows.size()));
  json.key("places");
  write_places(json, rows, per_mm, kPlaceStep * size);
  json.key("moving").open('[');
  for (std::size_t i = 0; i < shapes.size(); ++i) write_moving(json, rows, i, per_mm, kShapeStep * size);
  json.close(']');
}

}  // namespace higherpair
