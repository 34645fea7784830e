#pragma once

#include "higherpair/front/sensitivity.hpp"
#include "number_slopes.hpp"
#include "path_results.hpp"

#include <map>
#include <memory>
#include <vector>

namespace higherpair {

/// Exact derivatives of results by numbers: that of an extreme from its column at the extreme's places, that
/// of a mean from all rows.
class ExactSlopes {
public:
  /// All arguments must outlive this. \param slopes  for each number
  ExactSlopes(PathColumns& columns, const std::vector<PathResult>& results,
              const std::vector<Measure>& measures, const std::vector<std::unique_ptr<NumberSlopes>>& slopes,
              int threads);

  /// Computes the derivatives along the path; ends early if the run is to stop.
  void take();

  /// \pre take() has run to its end
  [[nodiscard]] Slope of(std::size_t number, std::size_t measure) const;

private:
  struct Stop;

  void take_places();
  void take_rows();
  [[nodiscard]] std::vector<double> slopes_at(std::size_t number, const Stop& stop) const;
  void add_means(std::size_t number, const Stop& stop, const std::vector<double>& values);
  [[nodiscard]] bool stopped() const;

  PathColumns& columns_;
  const std::vector<PathResult>& results_;
  const std::vector<Measure>& measures_;
  const std::vector<std::unique_ptr<NumberSlopes>>& slopes_;
  int threads_;
  std::map<double, std::size_t> place_index_;                // by row
  std::vector<std::vector<std::vector<double>>> at_places_;  // for each number, place and column
  std::vector<std::vector<double>> means_;                   // for each number and measure
};

}  // namespace higherpair
