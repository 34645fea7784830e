#pragma once

#include "higherpair/front/sensitivity.hpp"
#include "number_slopes.hpp"
#include "path_results.hpp"

#include <map>
#include <memory>
#include <vector>

namespace higherpair {

/// The exact derivatives of results by numbers: of an extreme those of its column at its places, of a mean
/// those of all rows.
class ExactSlopes {
public:
  /// All of these outlive this. \param slopes  of each number
  ExactSlopes(PathColumns& columns, const std::vector<PathResult>& results,
              const std::vector<Measure>& measures, const std::vector<std::unique_ptr<NumberSlopes>>& slopes,
              int threads);

  /// Goes along the path; ends early where the run is to stop.
  void take();

  /// \pre take() has come to its end
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
  std::map<double, std::size_t> place_index_;                // by the row
  std::vector<std::vector<std::vector<double>>> at_places_;  // of each number at each place all columns
  std::vector<std::vector<double>> means_;                   // of each number of each measure
};

}  // namespace higherpair
