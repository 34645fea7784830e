#include "polygon_nodes.hpp"

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "higherpair/numeric/contains.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace higherpair {
namespace {

const NamedPoint& named(const Mechanism& mechanism, const PointRef& ref) {
  return mechanism.bodies[ref.body].points[ref.point];
}

class GraphMaker {
public:
  GraphMaker(const Mechanism& mechanism, const MotionRow& row)
      : mechanism_(mechanism), row_(row), size_(size_of(mechanism)) {}

  NodeGraph make() {
    order_bodies();
    for (const int body : order_) add_points(body);
    join_pins();
    add_slot_pins_of_ground();
    name_nodes();
    add_slides();
    add_contacts();
    add_bodies();
    return std::move(graph_);
  }

private:
  // Orders the bodies as the motion is transmitted: from the drivers across joints and contacts.
  void order_bodies() {
    for (const Driver& driver : mechanism_.drivers) {
      const Joint& joint = mechanism_.joints[driver.joint];
      discover(joint.first.body);
      discover(joint.second.body);
    }
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const auto go_over = [&](int a, int b) {
        if (a == order_[k]) discover(b);
        if (b == order_[k]) discover(a);
      };
      for (const Joint& joint : mechanism_.joints) go_over(joint.first.body, joint.second.body);
      for (const Contact& contact : mechanism_.contacts) go_over(contact.first.body, contact.second.body);
    }
    for (std::size_t i = 1; i < mechanism_.bodies.size(); ++i) discover(static_cast<int>(i));
  }

  void discover(int body) {
    if (body != 0 && !contains(order_, body)) order_.push_back(body);
  }

  [[nodiscard]] std::size_t rank(int body) const {
    return static_cast<std::size_t>(std::find(order_.begin(), order_.end(), body) - order_.begin());
  }

  void add_points(int body) {
    for (const NamedPoint& point : mechanism_.bodies[body].points) add_point(body, point);
  }

  void add_point(int body, const NamedPoint& point) {
    const std::size_t node = node_at(body, point.p_B);
    if (graph_.nodes[node].name.empty()) {
      graph_.nodes[node].name = point.name;
      graph_.nodes[node].item = mechanism_.bodies[body].name + "." + point.name;
    }
  }

  void add_slot_pins_of_ground() {
    for (const Joint& joint : mechanism_.joints) {
      if (joint.type == JointType::kSlot && joint.second.body == 0) {
        add_point(0, named(mechanism_, joint.second));
      }
    }
  }

  // The node of a body's point; a new one if there is none.
  std::size_t node_at(int body, const Vector2d& p_B) {
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      for (const Node::Place& place : graph_.nodes[i].places) {
        if (place.body == body && (place.p_B - p_B).norm() <= kSameNode * size_) return i;
      }
    }
    Node& node = graph_.nodes.emplace_back();
    node.places.push_back({body, p_B});
    return graph_.nodes.size() - 1;
  }

  void join_pins() {
    for (const Joint& joint : mechanism_.joints) {
      if (joint.type != JointType::kRevolute) continue;
      const std::size_t a = node_at(joint.first.body, point_of(mechanism_, joint.first));
      const std::size_t b = node_at(joint.second.body, point_of(mechanism_, joint.second));
      const auto [kept, gone] = std::minmax(a, b);
      Node& node = graph_.nodes[kept];
      node.joins = true;
      const bool alike = named(mechanism_, joint.first).name == named(mechanism_, joint.second).name;
      node.name = alike ? named(mechanism_, joint.first).name : joint.name;
      if (kept == gone) continue;
      const std::vector<Node::Place> places = graph_.nodes[gone].places;
      node.places.insert(node.places.end(), places.begin(), places.end());
      graph_.nodes.erase(graph_.nodes.begin() + static_cast<std::ptrdiff_t>(gone));
    }
  }

  // A name that several points share is replaced by "body.point".
  void name_nodes() {
    std::vector<std::string> names;
    for (const Node& node : graph_.nodes) names.push_back(node.name);
    for (Node& node : graph_.nodes) {
      if (std::count(names.begin(), names.end(), node.name) > 1 && !node.item.empty()) node.name = node.item;
    }
  }

  void add_slides() {
    for (const Joint& joint : mechanism_.joints) {
      if (joint.type != JointType::kPrismatic && joint.type != JointType::kSlot) continue;
      // All points of a body that slides on ground move alike: none is compared.
      const bool translates = joint.type == JointType::kPrismatic && joint.second.body == 0;
      const PointRef& point = translates ? joint.first : joint.second;
      const std::size_t to = node_at(point.body, point_of(mechanism_, point));
      graph_.nodes[to].joins = true;
      if (translates || joint.first.body == 0) continue;
      add_slide(joint.first.body, to, motion_of(joint.first.body).X_WB.R_WB * joint.direction_A);
    }
  }

  void add_slide(int guide, std::size_t to, const Vector2d& d_W) {
    const std::string name = graph_.nodes[to].name;
    const std::string item = graph_.nodes[to].item;
    const std::size_t from = node_at(guide, on_body(guide, position(to)));
    graph_.nodes[to].joins = true;
    graph_.nodes[from].joins = true;
    if (from == to) return;
    if (graph_.nodes[from].name.empty()) {
      graph_.nodes[from].name = name + "′";
      graph_.nodes[from].item = item + "@" + mechanism_.bodies[guide].name;
    }
    graph_.comparisons.push_back({Comparison::Kind::kSlide, from, to, guide, d_W});
  }

  void add_contacts() {
    for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) {
      if (!row_.contacts[i].touches) continue;
      const Contact& contact = mechanism_.contacts[i];
      const CommonNormal& at = row_.contacts[i].at;
      const auto first = center_node(contact, contact.first, at.p1_W - at.rho1 * at.n_W, "C1");
      const auto second = center_node(contact, contact.second, at.p2_W + at.rho2 * at.n_W, "C2");
      if (first && second && *first != *second) {
        const bool forward = rank(contact.first.body) <= rank(contact.second.body) || contact.first.body == 0;
        graph_.comparisons.push_back({Comparison::Kind::kLink, forward ? *first : *second,
                                      forward ? *second : *first, 0, Vector2d::Zero()});
      } else if (first && !second) {
        add_slide(contact.second.body, *first, perp(at.n_W));
      } else if (second && !first) {
        add_slide(contact.first.body, *second, perp(at.n_W));
      }
    }
  }

  // The centre of curvature as a point of the body; none for a line.
  std::optional<std::size_t> center_node(const Contact& contact, const CurveRef& ref,
                                         const Vector2d& center_W, const std::string& name) {
    if (is_line(curve_of(mechanism_, ref)) || !center_W.allFinite()) return std::nullopt;
    const std::size_t node = node_at(ref.body, on_body(ref.body, center_W));
    graph_.nodes[node].joins = true;
    if (graph_.nodes[node].name.empty()) {
      graph_.nodes[node].name = mechanism_.contacts.size() == 1 ? name : contact.name + "." + name;
      graph_.nodes[node].item = contact.name + "." + name;
    }
    return node;
  }

  // Compares all points of a body with the one that is known first; a pivot on ground is known at once.
  void add_bodies() {
    std::vector<Comparison> all;
    std::vector<Comparison> others = std::move(graph_.comparisons);
    for (const int body : order_) {
      const auto reference = reference_of(body);
      if (!reference) continue;
      for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
        if (i != *reference && graph_.nodes[i].is_on(body)) {
          all.push_back({Comparison::Kind::kBody, *reference, i, body, Vector2d::Zero()});
        }
      }
    }
    all.insert(all.end(), others.begin(), others.end());
    graph_.comparisons = std::move(all);
  }

  [[nodiscard]] std::optional<std::size_t> reference_of(int body) const {
    std::optional<std::size_t> best;
    std::size_t best_rank = 0;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      if (!graph_.nodes[i].is_on(body)) continue;
      std::size_t earliest = order_.size() + 1;
      for (const Node::Place& place : graph_.nodes[i].places) {
        earliest = std::min(earliest, place.body == 0 ? 0 : rank(place.body) + 1);
      }
      if (!best || earliest < best_rank) {
        best = i;
        best_rank = earliest;
      }
    }
    return best;
  }

  [[nodiscard]] const BodyMotion& motion_of(int body) const { return row_.bodies[body]; }
  [[nodiscard]] Vector2d position(std::size_t node) const {
    const Node::Place& place = graph_.nodes[node].places.front();
    return motion_of(place.body).X_WB * place.p_B;
  }
  [[nodiscard]] Vector2d on_body(int body, const Vector2d& p_W) const {
    return motion_of(body).X_WB.inverse_times(p_W);
  }

  const Mechanism& mechanism_;
  const MotionRow& row_;
  double size_;  // of the mechanism [m]
  std::vector<int> order_;
  NodeGraph graph_;
};

}  // namespace

bool Node::is_on(int body) const {
  return std::any_of(places.begin(), places.end(), [&](const Place& place) { return place.body == body; });
}

NodeGraph make_node_graph(const Mechanism& mechanism, const MotionRow& row) {
  return GraphMaker(mechanism, row).make();
}

}  // namespace higherpair
