#pragma once

#include "higherpair/front/sensitivity.hpp"
#include "number_slopes.hpp"
#include "path_results.hpp"

#include <map>
#include <memory>
#include <vector>

namespace higherpair {

/// Exact derivatives of results by numbers: that of an extreme from its column at the extreme's places, that
/// of a mean from all rows. Where a column keeps to its extreme on a stretch of the path, the result follows
/// the place at which it changes most.
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
  // A run that has moved to a place.
  struct Stop {
    PathPlace place;
    Run run;
    RatesAsked rates;
  };
  [[nodiscard]] Stop stop_at(const PathPlace& place, const Run& run) const;

  void take_places();
  void take_rows();
  // Slopes of all columns at a place; NaN where there are none.
  struct PlaceSlopes {
    std::vector<SidedSlope> of;
    bool diverges = false;  // NaN because they grow without bounds there
  };
  [[nodiscard]] PlaceSlopes slopes_at(std::size_t number, const Stop& stop) const;
  [[nodiscard]] SidedSlope of_part(std::size_t number, std::size_t measure,
                                   const std::vector<ExtremePlace>& part) const;
  [[nodiscard]] double gain_between(std::size_t number, std::size_t column, const ExtremePlace& first,
                                    const ExtremePlace& last, double side) const;
  void add_means(std::size_t number, const Stop& stop, const std::vector<double>& values);
  [[nodiscard]] bool diverges(std::size_t number, std::size_t measure) const;
  [[nodiscard]] bool vanishes(std::size_t measure) const;
  [[nodiscard]] bool stopped() const;

  PathColumns& columns_;
  const std::vector<PathResult>& results_;
  const std::vector<Measure>& measures_;
  const std::vector<std::unique_ptr<NumberSlopes>>& slopes_;
  int threads_;
  std::vector<Stop> stops_;                          // at the places of all extremes
  std::map<double, std::size_t> place_index_;        // in stops_, by row
  std::vector<std::vector<PlaceSlopes>> at_places_;  // for each number and place
  std::vector<std::vector<SidedSlope>> extremes_;    // for each number and measure
  std::vector<std::vector<SidedSlope>> means_;       // for each number and measure
  std::vector<char> means_diverge_;                  // for each number: at some row
};

}  // namespace higherpair
