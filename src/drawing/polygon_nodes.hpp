#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/description.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace higherpair {

/// A point whose motion a polygon shows, and its positions on the bodies that it belongs to.
struct Node {
  struct Place {
    int body = 0;
    Vector2d p_B = Vector2d::Zero();
  };
  std::string name;  ///< "B", "touch.C1"
  std::string item;  ///< "link3.B"
  std::vector<Place> places;
  bool joins = false;  ///< the point of a joint or contact

  [[nodiscard]] bool is_on(int body) const;
};

/// Two points whose motions are compared.
struct Comparison {
  enum class Kind {
    kBody,   ///< both on `body`
    kLink,   ///< ends of the equivalent link of a contact
    kSlide,  ///< `to` slides along the direction d_W of `body`; `from` is the coincident point of that body
  };
  Kind kind = Kind::kBody;
  std::size_t from = 0;  ///< the point whose motion is known first
  std::size_t to = 0;
  int body = 0;
  Vector2d d_W = Vector2d::Zero();
};

struct NodeGraph {
  std::vector<Node> nodes;
  std::vector<Comparison> comparisons;  ///< in the order in which the motion is transmitted
};

[[nodiscard]] NodeGraph make_node_graph(const Mechanism& mechanism, const MotionRow& row);

}  // namespace higherpair
