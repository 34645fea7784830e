#pragma once

#include "higherpair/contact/contact_map.hpp"
#include "sheet_cells.hpp"
#include "tangency_sheet.hpp"

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace higherpair {

/// A grid over the places of two boundaries, and the zeros of a sheet's function on its lines. So that curves
/// along lines of the grid (a dwell's are) cross none by rounding, it is the zeros of F - 1e-12 of its size.
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

  /// \param range  where is_stopped(range) zeros are missing
  SheetGrid(const TangencySheet& sheet, const MapRange& range);

  [[nodiscard]] int count1() const { return static_cast<int>(side1_.parts.size()); }
  [[nodiscard]] int count2() const { return static_cast<int>(side2_.parts.size()); }
  [[nodiscard]] const Part& part1(int i) const { return side1_.parts[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const Part& part2(int j) const { return side2_.parts[static_cast<std::size_t>(j)]; }
  [[nodiscard]] bool has_cell(int i, int j) const {
    return sheet_.opposed() || !(part1(i).corner || part2(j).corner);
  }

  /// The zeros along part j of boundary 2 at a node of boundary 1, and the other way round.
  [[nodiscard]] const std::vector<Zero>& zeros_along2(int node1, int j) const;
  [[nodiscard]] const std::vector<Zero>& zeros_along1(int i, int node2) const;
  /// The zeros along a line between two places, of which either both are on one place of boundary 1 or both
  /// on one of boundary 2.
  [[nodiscard]] std::vector<double> zeros_between(StretchNode& one, StretchNode& two) const;
  /// Looks into a cell without zeros on its rim.
  [[nodiscard]] CellLook look_into(StretchNode& one, StretchNode& two) const;
  [[nodiscard]] StretchNode& stretch1(int i) { return *side1_.stretches[static_cast<std::size_t>(i)]; }
  [[nodiscard]] StretchNode& stretch2(int j) { return *side2_.stretches[static_cast<std::size_t>(j)]; }

  /// The boundary, 1 or 2, that ends at a zero; 0: none does.
  [[nodiscard]] int boundary_ending_at(int id) const;
  [[nodiscard]] int new_id() { return ids_++; }
  [[nodiscard]] int ids() const { return ids_; }

private:
  struct Side {
    std::vector<Part> parts;
    std::vector<std::unique_ptr<StretchNode>> stretches;  // the parts
    std::vector<StretchNode*> nodes;
    std::vector<bool> ends;       // of the nodes: the boundary ends there
    std::vector<bool> at_corner;  // of the nodes: a corner begins or ends there
  };

  // \param length  what is long for a part near the middle of its boundary [m]
  [[nodiscard]] static Side side_of(const Boundary& boundary, double length);
  static void add_parts(const Boundary& boundary, int span, const Bounds& t, double length, int halvings,
                        std::vector<Part>& parts);
  void place_nodes(Side& side, bool is_first);
  void find_zeros(const MapRange& range);
  // Whether curves end at a node: normals that are equal do not pass corners.
  [[nodiscard]] bool ends_at(const Side& side, std::size_t node) const {
    return side.ends[node] || (!sheet_.opposed() && side.at_corner[node]);
  }
  [[nodiscard]] double level(const SheetPlace& one, const SheetPlace& two) const;
  // Along the one of the two that is no place. \param low, high  the level at its ends
  // \param parts  how many have been looked at
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
  std::vector<int> ending_;  // by ids
  int ids_ = 0;
};

}  // namespace higherpair
