#pragma once

#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/dynamics/statics.hpp"

#include <vector>

namespace higherpair {

/// The columns of ForcePiece at one position.
class ForceColumns {
public:
  ForceColumns(const Run& run, std::vector<Preload> preloads);

  /// Takes those of run.row; false where it has no rates or no balance. `run` must be the one of the
  /// constructor, or a copy.
  [[nodiscard]] bool solve(const Run& run);

  [[nodiscard]] std::size_t count() const { return ForcePiece::kParts + preloads_.size(); }
  [[nodiscard]] double value(std::size_t contact, std::size_t column) const {
    return values_[contact * count() + column];
  }
  [[nodiscard]] bool is_known(std::size_t contact) const { return known_[contact]; }
  /// Largest of all multipliers in a column: what its rounding is relative to.
  [[nodiscard]] double largest(std::size_t column) const { return largest_[column]; }

private:
  [[nodiscard]] bool take(std::size_t column);

  Statics statics_;
  std::vector<Preload> preloads_;
  bool damped_ = false;
  std::vector<BodyMotion> still_;  // the row's bodies, at rest
  std::vector<Wrench> wrenches_;   // used up by the balance
  std::vector<Wrench> rest_;       // of the first column
  std::vector<double> values_;
  std::vector<bool> known_;
  std::vector<double> largest_;
};

}  // namespace higherpair
