#pragma once

#include "contact_arcs.hpp"
#include "higherpair/analysis/run.hpp"

#include <optional>
#include <vector>

namespace higherpair {

/// What the columns of a row need from the rows before it: where the arcs of contacts begin.
class RowHistory {
public:
  /// Call with every row, in order, before its columns are filled.
  void note(const Run& run);

  /// Where a contact was in the first row in which it touched; null in and after a row that interrupts the
  /// path.
  [[nodiscard]] const ArcPoint* start_of(const Run& run, std::size_t contact) const;

  /// Whether one of the rows on the path to the present position of `run` could have changed the history; if
  /// not, none of them needs to be noted.
  [[nodiscard]] bool may_change_by(const Run& run) const;

  /// Whether both histories are the same to within rounding.
  /// \param size  of the mechanism [m]
  [[nodiscard]] bool is_like(const RowHistory& other, double size) const;

private:
  struct Arcs {
    std::optional<ArcPoint> start;
    bool broken = false;
  };

  std::vector<Arcs> arcs_;  // of Mechanism::contacts
};

}  // namespace higherpair
