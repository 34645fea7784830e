#pragma once

#include "front/columns/measure_series.hpp"
#include "higherpair/analysis/dyad_chain.hpp"
#include "higherpair/front/measure.hpp"
#include "higherpair/front/model.hpp"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace higherpair {

/// How to compute the variants of a linkage of dyads and discs (analysis/dyad_chain.hpp) that differ only in
/// numbers of bodies, loads, springs and gravity, without following each variant row by row. If all these
/// numbers are coordinates of points, they are written straight into the mechanism, and no variant has to be
/// read or planned. Immutable.
struct ChainRecipe {
  /// Where a number of the profile belongs in the mechanism.
  struct Target {
    std::size_t body = 0;
    std::size_t point = 0;
    Eigen::Index axis = 0;
  };

  Mechanism mechanism;
  Plan plan;
  std::vector<Target> targets;  ///< one for each number; empty where variants have to be read
  Scaling to_si;
  std::vector<DriverMotion> rows;
  std::vector<double> where;  ///< Measured::where of each row
  std::vector<ChainColumn> columns;
  std::vector<Scaling> scales;     ///< for each column: to the units of the run
  std::vector<Measure> measures;   ///< to be evaluated
  std::vector<std::size_t> slots;  ///< for each measure: its column

  /// None where other numbers vary, a measure is not of a ChainColumn, or the run does not suit DyadChain.
  /// \param models  for these paths
  /// \param tries   values of the numbers for which the variant that is read must equal the one that is
  /// written
  [[nodiscard]] static std::optional<ChainRecipe> of(const Model& model, std::span<const std::string> paths,
                                                     const RunSettings& run, std::vector<Measure> measures,
                                                     ModelVariants& models,
                                                     std::span<const std::vector<double>> tries);

  /// Whether variants are made by writing their numbers into the mechanism, without reading the profile.
  [[nodiscard]] bool writes() const { return !targets.empty(); }
};

/// Variants by a recipe, one after the other; the recipe must outlive them.
class ChainVariants {
public:
  /// None where the recipe's mechanism is not a chain.
  [[nodiscard]] static std::optional<ChainVariants> of(const ChainRecipe& recipe);

  /// Whether it is certain that every row of the variant with these numbers is `ok` and its path good. If so,
  /// value() gives its measures; otherwise the variant has to be read and run. \pre the recipe writes()
  [[nodiscard]] bool solve(std::span<const double> numbers);
  /// The same for a variant that has been read.
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
  Mechanism mechanism_;  // of a recipe that writes: the last variant solved
  DyadChain chain_;
  std::vector<Extremes> extremes_;  // for each column, in the last variant solved
};

}  // namespace higherpair
