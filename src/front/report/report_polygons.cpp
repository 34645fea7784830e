#include "front/pictures/polygon.hpp"
#include "front/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "packed_series.hpp"
#include "report_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <Eigen/Geometry>

namespace higherpair {
namespace {

constexpr double kVectorSteps = 1e5;  // into which the longest vector is divided when drawn and listed
constexpr double kUsual = 0.95;       // fraction of the rows whose polygons fit in the picture
constexpr double kRoom = 1.2;         // size of the picture relative to these
constexpr int kVectorDigits = 6;

// The x and y of a vector in every row.
struct Track {
  std::vector<double> x, y;
};

// One polygon over all rows. Its parts are identified by name, since not all of them are in every row.
struct MovingPolygon {
  Polygon first;  ///< that of the first row which has arrows: its title, unit and pole are those of all rows
  std::vector<std::vector<std::string>> equations;  ///< the different sets of equations
  std::vector<double> set_of_row;                   ///< the index of its set
  std::vector<double> sizes;                        ///< in each of its rows
  bool flat = true;                                 ///< in every row all arrows are on one line
  struct Part {
    PolygonArrow arrow;
    Track from, to;
  };
  std::vector<Part> parts;
  std::map<std::string, std::size_t> part_of_name;
  std::vector<std::pair<std::string, Track>> points;
};

bool is_flat(const Polygon& polygon) {
  Vector2d longest = Vector2d::Zero();
  for (const PolygonArrow& arrow : polygon.arrows) {
    const Vector2d along = arrow.to - arrow.from;
    if (along.norm() > longest.norm()) longest = along;
  }
  return polygon.arrows.size() > 1 &&
         std::all_of(polygon.arrows.begin(), polygon.arrows.end(), [&](const PolygonArrow& arrow) {
           return std::abs(cross(longest, Vector2d(arrow.to - arrow.from))) <=
                  kFlatPolygon * longest.squaredNorm();
         });
}

class Collector {
public:
  explicit Collector(std::size_t rows) : rows_(rows) {}

  void add(const Polygon& polygon, std::size_t row) {
    if (polygon.arrows.empty()) return;
    const auto [known, is_new] = known_.try_emplace(polygon.title, all.size());
    if (is_new) {
      all.emplace_back().first = polygon;
      all.back().set_of_row.assign(rows_, kNoValue);
    }
    MovingPolygon& moving = all[known->second];
    moving.set_of_row[row] = static_cast<double>(set_with(moving, polygon.equations));
    double size = 0;
    for (const PolygonArrow& arrow : polygon.arrows) {
      MovingPolygon::Part& part = part_for(moving, arrow);
      set(part.from, row, arrow.from);
      set(part.to, row, arrow.to);
      size = std::max({size, arrow.from.norm(), arrow.to.norm()});
    }
    moving.sizes.push_back(size);
    moving.flat = moving.flat && is_flat(polygon);
    for (const PolygonPoint& point : polygon.points) set(track_of(moving, point.name), row, point.at);
  }

  std::vector<MovingPolygon> all;

private:
  static std::size_t set_with(MovingPolygon& moving, const std::vector<std::string>& equations) {
    auto& sets = moving.equations;
    const auto known = std::find(sets.begin(), sets.end(), equations);
    const auto index = static_cast<std::size_t>(known - sets.begin());
    if (known == sets.end()) sets.push_back(equations);
    return index;
  }
  MovingPolygon::Part& part_for(MovingPolygon& moving, const PolygonArrow& arrow) {
    const std::string key = std::to_string(static_cast<int>(arrow.kind)) + arrow.name + " " + arrow.item;
    const auto [known, is_new] = moving.part_of_name.try_emplace(key, moving.parts.size());
    if (is_new) moving.parts.push_back({arrow, undefined(), undefined()});
    return moving.parts[known->second];
  }
  Track& track_of(MovingPolygon& moving, const std::string& name) {
    for (auto& [known, track] : moving.points) {
      if (known == name) return track;
    }
    return moving.points.emplace_back(name, undefined()).second;
  }
  [[nodiscard]] Track undefined() const {
    return {std::vector(rows_, kNoValue), std::vector(rows_, kNoValue)};
  }
  static void set(Track& track, std::size_t row, const Vector2d& at) {
    track.x[row] = at.x();
    track.y[row] = at.y();
  }

  std::size_t rows_;
  std::map<std::string, std::size_t> known_;
};

bool is_same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

// Vectors that several arrows share are written once.
class Vectors {
public:
  std::size_t number_of(const Track& track) {
    const auto known = std::find_if(tracks_.begin(), tracks_.end(), [&](const Track* other) {
      return is_same(other->x, track.x) && is_same(other->y, track.y);
    });
    if (known == tracks_.end()) {
      tracks_.push_back(&track);
      return tracks_.size() - 1;
    }
    return static_cast<std::size_t>(known - tracks_.begin());
  }
  void write(JsonWriter& json, double step) const {
    json.key("vectors").open('[');
    for (const Track* track : tracks_) {
      json.open('[');
      write_packed(json, track->x, step);
      write_packed(json, track->y, step);
      json.close(']');
    }
    json.close(']');
  }

private:
  std::vector<const Track*> tracks_;
};

// The largest size that is shown. Larger ones leave the picture: near a limit position rates grow without
// bounds.
double largest_shown(std::vector<double> sizes) {
  std::sort(sizes.begin(), sizes.end());
  const double usual =
      kRoom * sizes[static_cast<std::size_t>(kUsual * static_cast<double>(sizes.size() - 1))];
  return usual > 0 ? std::min(sizes.back(), usual) : sizes.back();
}

void write_view(JsonWriter& json, const MovingPolygon& polygon, double limit) {
  Eigen::AlignedBox2d view(Vector2d::Zero(), Vector2d::Zero());
  for (const MovingPolygon::Part& part : polygon.parts) {
    for (const Track* track : {&part.from, &part.to}) {
      for (std::size_t i = 0; i < track->x.size(); ++i) {
        const Vector2d at(track->x[i], track->y[i]);
        if (at.norm() <= limit) view.extend(at);
      }
    }
  }
  json.key("view").open('[');
  for (const double number : {view.min().x(), view.min().y(), view.max().x(), view.max().y()})
    json.number(number, kVectorDigits);
  json.close(']');
}

std::string_view name_of(PolygonArrow::Kind kind) {
  static constexpr std::array kNames = {"absolute", "relative", "normal", "tangential",
                                        "sliding",  "coriolis", "force"};
  static_assert(kNames.size() == static_cast<std::size_t>(PolygonArrow::Kind::kForce) + 1);
  return kNames[static_cast<std::size_t>(kind)];
}

void write_polygon(JsonWriter& json, const MovingPolygon& polygon) {
  const double limit = largest_shown(polygon.sizes);
  const bool forces = polygon.first.kind == Polygon::Kind::kForce;
  Vectors vectors;
  json.open('{').key("title").string((forces ? "Forces on " : "") + polygon.first.title);
  json.key("forces").boolean(forces).key("unit").string(polygon.first.unit);
  json.key("pole").string(polygon.first.pole);
  json.key("flat").boolean(polygon.flat);
  write_view(json, polygon, limit);
  json.key("equations").open('[');
  for (const std::vector<std::string>& equations : polygon.equations) json.strings(equations);
  json.close(']').key("equationsOf");
  write_packed(json, polygon.set_of_row, 1);
  json.key("points").open('[');
  for (const auto& [name, track] : polygon.points) {
    json.open('{').key("name").string(name).key("at");
    json.integer(static_cast<long long>(vectors.number_of(track))).close('}');
  }
  json.close(']').key("arrows").open('[');
  for (const MovingPolygon::Part& part : polygon.parts) {
    json.open('{').key("kind").string(name_of(part.arrow.kind)).key("name").string(part.arrow.name);
    json.key("item").string(part.arrow.item);
    json.key("from").integer(static_cast<long long>(vectors.number_of(part.from)));
    json.key("to").integer(static_cast<long long>(vectors.number_of(part.to))).close('}');
  }
  json.close(']');
  vectors.write(json, limit / kVectorSteps);
  json.close('}');
}

}  // namespace

void write_polygons(JsonWriter& json, const Model& model, const ReportData& data) {
  Collector collector(data.motions.size());
  for (std::size_t row = 0; row < data.motions.size(); ++row) {
    const bool forces = !data.reactions.empty() && data.reactions[row].defined;
    for (const Polygon& polygon : polygons_in(model.mechanism(), data.motions[row],
                                              forces ? &data.reactions[row] : nullptr, model.units())) {
      collector.add(polygon, row);
    }
  }
  json.key("polygons").open('[');
  for (const MovingPolygon& polygon : collector.all) write_polygon(json, polygon);
  json.close(']');
}

}  // namespace higherpair
