#pragma once

#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/dynamics/statics.hpp"

#include <vector>

namespace higherpair {

/// Computes the columns of ForcePiece at one position.
class ForceColumns {
public:
  ForceColumns(const Run& run, std::vector<Preload> preloads);

  /// Computes the columns at run.row; false if the row has no rates or cannot be balanced. `run` must be the
  /// one given to the constructor, or a copy.
  [[nodiscard]] bool solve(const Run& run);

  [[nodiscard]] std::size_t count() const { return ForcePiece::kParts + preloads_.size(); }
  [[nodiscard]] double value(std::size_t contact, std::size_t column) const {
    return values_[contact * count() + column];
  }
  /// All of them, in the order of ForcePiece::columns.
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  [[nodiscard]] bool is_known(std::size_t contact) const { return known_[contact]; }
  /// Largest of all multipliers in a column, which their rounding is relative to.
  [[nodiscard]] double largest(std::size_t column) const { return largest_[column]; }

private:
  [[nodiscard]] bool take(std::size_t column);

  Statics statics_;
  std::vector<Preload> preloads_;
  bool damped_ = false;
  std::vector<BodyMotion> still_;  // the row's bodies, at rest
  std::vector<Wrench> wrenches_;   // overwritten by the balance
  std::vector<Wrench> rest_;       // loads of the first column
  std::vector<double> values_;
  std::vector<bool> known_;
  std::vector<double> largest_;
};

}  // namespace higherpair
