#pragma once

#include "front/columns/path_columns.hpp"
#include "numeric/peaks.hpp"

#include <vector>

namespace higherpair {

/// All columns at equally spaced places of a path, to find where else than at its extreme a column is large.
class SampledColumns {
public:
  /// Both must outlive this.
  SampledColumns(PathColumns& columns, const DriverPath& path);

  /// A stretch of the path on which a column keeps to its extreme.
  struct Stretch {
    double from = 0, to = 0;     ///< all of it, to within `noise`
    std::vector<double> places;  ///< without what is only nearly at the extreme, at its ends
  };

  /// Stretches on which sign times a column is `value` to within `noise`.
  [[nodiscard]] std::vector<Stretch> stretches(std::size_t column, double sign, double value,
                                               double noise) const;

  /// Local maxima of sign times a column away from a place, the largest first.
  /// \param flat  values from here on are not sought where they are those of a whole stretch
  [[nodiscard]] std::vector<Peak> others(std::size_t column, double sign, double at, double least,
                                         double flat, double noise) const;

private:
  struct Edge;

  [[nodiscard]] bool is_flat(std::size_t k, std::size_t column, double sign, double least) const;
  [[nodiscard]] Edge edge(std::size_t column, double sign, double value, double noise, std::size_t inside,
                          std::size_t outside) const;
  [[nodiscard]] double fallen_by(std::size_t column, double sign, double value, double fall,
                                 std::size_t inside, std::size_t outside) const;
  [[nodiscard]] Peak refined(std::size_t column, double sign, std::size_t k, double noise) const;

  PathColumns& columns_;
  const DriverPath& path_;
  std::vector<double> at_;
  std::vector<std::vector<double>> values_;
  std::vector<bool> assembled_;
  std::vector<PathWalk> marks_;
};

}  // namespace higherpair
