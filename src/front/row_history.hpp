#pragma once

#include "higherpair/analysis/run.hpp"

#include <array>
#include <optional>
#include <vector>

namespace higherpair {

/// What the columns of a row take from the rows before it: where the arcs of contacts begin.
class RowHistory {
public:
  /// To be called with every row, in order, before its columns are filled.
  void note(const Run& run);

  /// The path of the contact point along both curves since the first row in which the contact touched [m];
  /// none on and after a row that breaks the path, and of contacts by_boundary.
  /// \param arcs  now, of ContactDetails
  [[nodiscard]] std::optional<std::array<double, 2>> ways(const Run& run, std::size_t contact,
                                                          const std::array<double, 2>& arcs) const;

  /// Whether one of the rows on the path on which `run` has come to where it is may have been one to note:
  /// else none of them need be looked at.
  [[nodiscard]] bool may_change_by(const Run& run) const;

  /// Whether both say the same to within rounding: two runs that go on alike.
  /// \param size  of the mechanism [m]
  [[nodiscard]] bool is_like(const RowHistory& other, double size) const;

private:
  struct Arcs {
    std::optional<std::array<double, 2>> start;
    bool broken = false;
  };

  std::vector<Arcs> arcs_;  // of Mechanism::contacts
};

}  // namespace higherpair
