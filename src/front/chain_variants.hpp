#pragma once

#include "higherpair/analysis/dyad_chain.hpp"
#include "higherpair/front/measure.hpp"
#include "higherpair/front/model.hpp"
#include "measure_series.hpp"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace higherpair {

/// How to work out the variants of a linkage of dyads and discs (analysis/dyad_chain.hpp) whose numbers are
/// of its bodies and of what acts on them: they are not followed row by row. Where all are coordinates of
/// points they are written into the mechanism, which is neither read nor planned. Never changes once made.
struct ChainRecipe {
  /// Where a number of the profile lands.
  struct Target {
    std::size_t body = 0;
    std::size_t point = 0;
    Eigen::Index axis = 0;
  };

  Mechanism mechanism;
  Plan plan;
  std::vector<Target> targets;  ///< of the numbers; none where variants have to be read
  Scaling to_si;
  std::vector<DriverMotion> rows;
  std::vector<double> where;  ///< Measured::where of each row
  std::vector<ChainColumn> columns;
  std::vector<Scaling> scales;     ///< of the columns: to the units of the run
  std::vector<Measure> measures;   ///< what is asked
  std::vector<std::size_t> slots;  ///< of each measure: its column

  /// None where numbers are of other things than bodies and what acts on them, a measure is not one of
  /// ChainColumn, or the run is not one for DyadChain.
  /// \param models  of these paths
  /// \param tries   values of the numbers at which the mechanism that is read must be the one that is written
  [[nodiscard]] static std::optional<ChainRecipe> of(const Model& model, std::span<const std::string> paths,
                                                     const RunSettings& run, std::vector<Measure> measures,
                                                     ModelVariants& models,
                                                     std::span<const std::vector<double>> tries);

  /// Whether a variant is what its numbers make of the mechanism, without being read.
  [[nodiscard]] bool writes() const { return !targets.empty(); }
};

/// Variants by a recipe, one after the other; it outlives them.
class ChainVariants {
public:
  /// None where the recipe's mechanism is no chain.
  [[nodiscard]] static std::optional<ChainVariants> of(const ChainRecipe& recipe);

  /// Whether it is certain that every row of the variant with these numbers is `ok` and its path good. Then
  /// value() says what its measures come to; else it has to be read and run. \pre the recipe writes()
  [[nodiscard]] bool solve(std::span<const double> numbers);
  /// The same of a variant that has been read.
  [[nodiscard]] bool solve(const Model& variant);

  /// \param wants_where  false: Measured::where may be left undefined
  [[nodiscard]] Measured value(std::size_t measure, bool wants_where) const;

private:
  ChainVariants(const ChainRecipe& recipe, DyadChain chain)
      : recipe_(&recipe),
        mechanism_(recipe.mechanism),
        chain_(std::move(chain)),
        extremes_(recipe.columns.size()) {}
  [[nodiscard]] bool solve(const Mechanism& mechanism);

  const ChainRecipe* recipe_;
  Mechanism mechanism_;  // of a recipe that writes: the variant solved last
  DyadChain chain_;
  std::vector<Extremes> extremes_;  // of the columns, in the variant solved last
};

}  // namespace higherpair
