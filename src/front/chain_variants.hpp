#pragma once

#include "higherpair/analysis/dyad_chain.hpp"
#include "higherpair/front/measure.hpp"
#include "higherpair/front/model_variants.hpp"
#include "measure_series.hpp"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace higherpair {

/// How to work out the variants of a linkage of dyads whose numbers are coordinates of points: they are
/// written into the mechanism, which is neither read nor planned nor followed (analysis/dyad_chain.hpp).
/// Never changes once made.
struct ChainRecipe {
  /// Where a number of the profile lands.
  struct Target {
    std::size_t body = 0;
    std::size_t point = 0;
    Eigen::Index axis = 0;
  };

  Mechanism mechanism;
  Plan plan;
  std::vector<Target> targets;  ///< of the numbers
  Scaling to_si;
  std::vector<DriverMotion> rows;
  std::vector<double> where;  ///< Measured::where of each row
  std::vector<ChainColumn> columns;
  std::vector<Scaling> scales;     ///< of the columns: to the units of the run
  std::vector<Measure> measures;   ///< what is asked
  std::vector<std::size_t> slots;  ///< of each measure: its column

  /// None where numbers are others, the profile says more with them than where points are, a measure is not
  /// of bodies and points, or the run is not one for DyadChain.
  /// \param models  of these paths
  /// \param tries   values of the numbers at which the mechanism that is read must be the one that is written
  [[nodiscard]] static std::optional<ChainRecipe> of(const Model& model, std::span<const std::string> paths,
                                                     const RunSettings& run, std::vector<Measure> measures,
                                                     ModelVariants& models,
                                                     std::span<const std::vector<double>> tries);
};

/// Variants by a recipe, one after the other; it outlives them.
class ChainVariants {
public:
  /// None where the recipe's mechanism is no chain.
  [[nodiscard]] static std::optional<ChainVariants> of(const ChainRecipe& recipe);

  /// Whether it is certain that every row of the variant with these numbers is `ok` and its path good. Then
  /// value() says what its measures come to; else it has to be read and run.
  [[nodiscard]] bool solve(std::span<const double> numbers);

  /// \param wants_where  false: Measured::where may be left undefined
  [[nodiscard]] Measured value(std::size_t measure, bool wants_where) const;

private:
  ChainVariants(const ChainRecipe& recipe, DyadChain chain)
      : recipe_(&recipe),
        mechanism_(recipe.mechanism),
        chain_(std::move(chain)),
        extremes_(recipe.columns.size()) {}

  const ChainRecipe* recipe_;
  Mechanism mechanism_;
  DyadChain chain_;
  std::vector<Extremes> extremes_;  // of the columns, in the variant solved last
};

}  // namespace higherpair
