#include "higherpair/drawing/picture.hpp"
#include "higherpair/drawing/row_polygons.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "polygon_nodes.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/core.h>

namespace higherpair {
namespace {

using ArrowKind = PolygonArrow::Kind;

class MotionPolygon {
public:
  MotionPolygon(const Mechanism& mechanism, const MotionRow& row, bool accelerations)
      : mechanism_(mechanism), row_(row), accelerations_(accelerations) {
    polygon_.kind = accelerations ? Polygon::Kind::kAcceleration : Polygon::Kind::kVelocity;
    polygon_.title = accelerations ? "Accelerations" : "Velocities";
    polygon_.pole = accelerations ? "o_{a}" : "o_{v}";
  }

  Polygon make() {
    if (row_.status == RowStatus::kNotAssemblable || !row_.all_rates) {
      polygon_.notes.emplace_back("the rates are not defined at this position");
      return polygon_;
    }
    graph_ = make_node_graph(mechanism_, row_);
    add_points();
    for (const Comparison& comparison : graph_.comparisons) add(comparison);
    remove_negligible();
    return polygon_;
  }

private:
  [[nodiscard]] PointMotion motion(std::size_t node) const {
    const Node::Place& place = graph_.nodes[node].places.front();
    return point_motion(body(place.body), place.p_B);
  }
  [[nodiscard]] Vector2d value(std::size_t node) const {
    if (graph_.nodes[node].is_on(0)) return Vector2d::Zero();
    return accelerations_ ? motion(node).a_W : motion(node).v_W;
  }
  [[nodiscard]] const BodyMotion& body(int index) const { return row_.bodies[index]; }
  [[nodiscard]] std::string letter() const { return accelerations_ ? "a" : "v"; }
  [[nodiscard]] std::string symbol(std::size_t node) const {
    return letter() + "_{" + graph_.nodes[node].name + "}";
  }

  // "BA" for B relative to A; names of more than one letter are separated by a stroke.
  [[nodiscard]] std::string symbol(std::size_t to, std::size_t from) const {
    const auto is_letter = [](const std::string& name) {
      return name.size() == 1 || (name.size() > 1 && name.substr(1) == "′");
    };
    const std::string& a = graph_.nodes[to].name;
    const std::string& b = graph_.nodes[from].name;
    return letter() + "_{" + a + (is_letter(a) && is_letter(b) ? "" : "/") + b + "}";
  }
  [[nodiscard]] std::string item(std::size_t to, std::size_t from) const {
    return graph_.nodes[to].item + "/" + graph_.nodes[from].item;
  }

  void add_points() {
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      const Node& node = graph_.nodes[i];
      if (node.is_on(0)) continue;
      std::string name = node.name;
      if (name.size() == 1 || name.substr(1) == "′") {
        name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
      }
      polygon_.points.push_back({name, value(i)});
      polygon_.arrows.push_back({ArrowKind::kAbsolute, symbol(i), node.item, Vector2d::Zero(), value(i)});
    }
  }

  void add(const Comparison& comparison) {
    const std::size_t from = comparison.from;
    const std::size_t to = comparison.to;
    if (comparison.kind == Comparison::Kind::kSlide) {
      add_slide(comparison);
    } else if (comparison.kind == Comparison::Kind::kBody) {
      const BodyMotion& own = body(comparison.body);
      add_rigid(from, to, own.omega, own.alpha, "ω_{" + name_of_body(comparison.body) + "}");
    } else {
      const Vector2d r = motion(to).p_W - motion(from).p_W;
      const double r2 = r.squaredNorm();
      const Vector2d v = motion(to).v_W - motion(from).v_W;
      const Vector2d a = motion(to).a_W - motion(from).a_W;
      add_rigid(from, to, cross(r, v) / r2, cross(r, a) / r2, "ω_{link}");
    }
  }

  [[nodiscard]] const std::string& name_of_body(int index) const { return mechanism_.bodies[index].name; }

  // Compares two points at a fixed distance from each other.
  void add_rigid(std::size_t from, std::size_t to, double omega, double alpha, const std::string& turning) {
    const bool pivot = graph_.nodes[from].is_on(0);
    const Vector2d r = motion(to).p_W - motion(from).p_W;
    const std::string name = pivot ? symbol(to) : symbol(to, from);
    const std::string start = pivot ? "" : symbol(from) + " + ";
    const bool has_parts = graph_.nodes[to].joins;  // other points are shown without components
    if (pivot && !has_parts) return;
    if (!pivot) {
      polygon_.arrows.push_back({ArrowKind::kRelative, name, item(to, from), value(from), value(to)});
    }
    if (!accelerations_ || !has_parts) {
      const std::string between =
          graph_.nodes[from].name + (name_lengths(from, to) == 2 ? "" : " ") + graph_.nodes[to].name;
      polygon_.equations.push_back(pivot ? fmt::format("{} = {} × r_{{{}}}", name, turning, between)
                                         : fmt::format("{} = {}{}", symbol(to), start, name));
      return;
    }
    const Vector2d normal = -omega * omega * r;
    const Vector2d tangential = alpha * perp(r);
    const Vector2d corner = value(from) + normal;
    polygon_.arrows.push_back({ArrowKind::kNormal, name + "^{n}", item(to, from), value(from), corner});
    polygon_.arrows.push_back(
        {ArrowKind::kTangential, name + "^{t}", item(to, from), corner, Vector2d(corner + tangential)});
    polygon_.equations.push_back(fmt::format("{} = {}{}^{{n}} + {}^{{t}}", symbol(to), start, name, name));
  }

  [[nodiscard]] std::size_t name_lengths(std::size_t a, std::size_t b) const {
    return graph_.nodes[a].name.size() + graph_.nodes[b].name.size();
  }

  // A point that slides along a line on a moving body.
  void add_slide(const Comparison& comparison) {
    const std::size_t from = comparison.from;
    const std::size_t to = comparison.to;
    const Vector2d& d = comparison.d_W;
    const std::string name = symbol(to, from);
    const double omega = body(comparison.body).omega;
    const Vector2d sliding = d.dot(motion(to).v_W - motion(from).v_W) * d;
    if (!accelerations_) {
      polygon_.arrows.push_back({ArrowKind::kSliding, name, item(to, from), value(from), value(to)});
      polygon_.equations.push_back(fmt::format("{} = {} + {}", symbol(to), symbol(from), name));
      return;
    }
    const Vector2d corner = value(from) + 2 * omega * perp(sliding);
    polygon_.arrows.push_back({ArrowKind::kCoriolis, name + "^{c}", item(to, from), value(from), corner});
    polygon_.arrows.push_back({ArrowKind::kSliding, name, item(to, from), corner, value(to)});
    polygon_.equations.push_back(
        fmt::format("{} = {} + {}^{{c}} + {}", symbol(to), symbol(from), name, name));
  }

  // The order of magnitude of the bodies' motions: in a dwell all arrows may be mere rounding.
  [[nodiscard]] double usual_length() const {
    const double size = size_of(mechanism_);
    double fastest = 0;
    for (const BodyMotion& body : row_.bodies) {
      fastest = std::max({fastest, std::abs(body.omega) * size, body.v_WB.norm()});
    }
    return accelerations_ ? fastest * fastest / size : fastest;
  }

  // Removes arrows without a length, and components that equal the whole vector.
  void remove_negligible() {
    double longest = usual_length();
    for (const PolygonArrow& arrow : polygon_.arrows)
      longest = std::max(longest, (arrow.to - arrow.from).norm());
    const double least = kNegligibleArrow * longest;
    const auto is_short = [&](const PolygonArrow& arrow) {
      return !((arrow.to - arrow.from).norm() > least);
    };
    const auto is_whole = [&](const PolygonArrow& part) {
      const bool is_part = part.kind == ArrowKind::kNormal || part.kind == ArrowKind::kTangential;
      return is_part &&
             std::any_of(polygon_.arrows.begin(), polygon_.arrows.end(), [&](const PolygonArrow& arrow) {
               return (arrow.kind == ArrowKind::kAbsolute || arrow.kind == ArrowKind::kRelative) &&
                      (arrow.from - part.from).norm() <= least && (arrow.to - part.to).norm() <= least;
             });
    };
    std::vector<PolygonArrow> kept;
    for (const PolygonArrow& arrow : polygon_.arrows) {
      if (!is_short(arrow) && !is_whole(arrow)) kept.push_back(arrow);
    }
    if (kept.empty()) polygon_.notes.emplace_back("all of them are zero");
    polygon_.arrows = std::move(kept);
  }

  const Mechanism& mechanism_;
  const MotionRow& row_;
  bool accelerations_;
  NodeGraph graph_;
  Polygon polygon_;
};

}  // namespace

Polygon velocity_polygon(const Mechanism& mechanism, const MotionRow& row) {
  return MotionPolygon(mechanism, row, false).make();
}

Polygon acceleration_polygon(const Mechanism& mechanism, const MotionRow& row) {
  return MotionPolygon(mechanism, row, true).make();
}

Polygon in_unit(Polygon polygon, double factor, const std::string& unit) {
  polygon.unit = unit;
  for (PolygonPoint& point : polygon.points) point.at *= factor;
  for (PolygonArrow& arrow : polygon.arrows) {
    arrow.from *= factor;
    arrow.to *= factor;
  }
  return polygon;
}

}  // namespace higherpair
