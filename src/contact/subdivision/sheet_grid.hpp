#pragma once

#include "higherpair/contact/contact_map.hpp"
#include "sheet_cells.hpp"
#include "tangency_sheet.hpp"

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace higherpair {

/// A grid over the places of two boundaries, with the zeros of a sheet's function along its lines. They are
/// zeros of F - 1e-12 size() instead of F, so that curves along grid lines (as those of a dwell) do not cross
/// them by rounding.
class SheetGrid {
public:
  /// A part of a span; `first` and `last` are the nodes at its ends, shared with its neighbours.
  struct Part {
    int span = 0;
    Bounds t;
    bool corner = false;
    int first = 0, last = 0;
  };
  struct Zero {
    int id = 0;
    double t = 0;  ///< parameter along the line
  };

  /// \param range  once it is stopped, zeros are missing
  SheetGrid(const TangencySheet& sheet, const MapRange& range);

  [[nodiscard]] int count1() const { return static_cast<int>(side1_.parts.size()); }
  [[nodiscard]] int count2() const { return static_cast<int>(side2_.parts.size()); }
  [[nodiscard]] const Part& part1(int i) const { return side1_.parts[i]; }
  [[nodiscard]] const Part& part2(int j) const { return side2_.parts[j]; }
  [[nodiscard]] bool has_cell(int i, int j) const {
    return sheet_.opposed() || !(part1(i).corner || part2(j).corner);
  }

  /// The zeros along part j of boundary 2 at a node of boundary 1, and vice versa.
  [[nodiscard]] const std::vector<Zero>& zeros_along2(int node1, int j) const;
  [[nodiscard]] const std::vector<Zero>& zeros_along1(int i, int node2) const;
  /// The zeros along a line on which one of the two is a single place and the other a stretch.
  [[nodiscard]] std::vector<double> zeros_between(StretchNode& one, StretchNode& two) const;
  /// Searches a cell without zeros on its rim.
  [[nodiscard]] CellLook look_into(StretchNode& one, StretchNode& two) const;
  [[nodiscard]] StretchNode& stretch1(int i) { return *side1_.stretches[i]; }
  [[nodiscard]] StretchNode& stretch2(int j) { return *side2_.stretches[j]; }

  /// The boundary, 1 or 2, that ends at a zero; 0: neither.
  [[nodiscard]] int boundary_ending_at(int id) const;
  [[nodiscard]] int new_id() { return ids_++; }
  [[nodiscard]] int ids() const { return ids_; }

private:
  struct Side {
    std::vector<Part> parts;
    std::vector<std::unique_ptr<StretchNode>> stretches;  // one for each part
    std::vector<StretchNode*> nodes;
    std::vector<bool> ends;       // by node: the boundary ends there
    std::vector<bool> at_corner;  // by node: a corner begins or ends there
  };

  // \param length  Parts are halved if longer than twice this and twice their distance from the boundary's
  // middle [m].
  [[nodiscard]] static Side side_of(const Boundary& boundary, double length);
  static void add_parts(const Boundary& boundary, int span, const Bounds& t, double length, int halvings,
                        std::vector<Part>& parts);
  void place_nodes(Side& side, bool is_first);
  void find_zeros(const MapRange& range);
  // Whether curves end at a node; those of equal normals do at corners as well.
  [[nodiscard]] bool ends_at(const Side& side, std::size_t node) const {
    return side.ends[node] || (!sheet_.opposed() && side.at_corner[node]);
  }
  [[nodiscard]] double level(const SheetPlace& one, const SheetPlace& two) const;
  // Along the one of the two that is not a single place.
  // \param low, high  F - level at its ends
  // \param parts  number of parts examined so far
  void add_zeros(StretchNode& one, StretchNode& two, double low, double high, int& parts,
                 std::vector<double>& zeros) const;
  [[nodiscard]] std::optional<double> zero_along(const StretchNode& one, const StretchNode& two, double low,
                                                 double high) const;
  void keep(std::unordered_map<std::int64_t, std::vector<Zero>>& zeros, std::int64_t key,
            const std::vector<double>& found, int ending);

  const TangencySheet& sheet_;
  double lifted_ = 0;
  Side side1_, side2_;
  std::unordered_map<std::int64_t, std::vector<Zero>> along1_, along2_;
  std::vector<int> ending_;  // by id of the zero
  int ids_ = 0;
};

}  // namespace higherpair
