#pragma once

#include "higherpair/design/optimise.hpp"
#include "higherpair/front/model.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Each that is set replaces what [design] of the profile says.
struct DesignSettings {
  std::optional<std::uint64_t> seed;
  std::optional<int> starts;
  std::optional<std::int64_t> evaluations;
  double seconds = 0;  ///< > 0: no further search after so long
  int threads = 0;     ///< 0: all; makes no difference to the result
  int best = 1;        ///< of so many different optima the text is made as well, where there are so many
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const DesignProgress&)> progress;
  /// As DesignOptions has them: a search goes on where another one was killed. \pre of the same profile and
  /// seed
  std::vector<DesignSearchEnd> known;
  std::function<void(const DesignSearchEnd&)> ended;
};

/// A design that was found, and the profile with which it was made. All numbers in the units of tables or of
/// the profile; NaN where undefined.
struct DesignReport {
  struct Variable {
    std::string name;
    std::vector<std::string> paths;
    double before = 0;
    double after = 0;
    double low = 0;
    double high = 0;
    double step = 0;  ///< 0: none
    bool at_bound = false;
  };
  struct Objective {
    std::string what;  ///< "path of coupler.E", "rms of follower.alpha"
    std::string unit;
    std::optional<double> target;
    double before = 0;  ///< of a path, and of a column that follows values, the sum of all squares
    double after = 0;
    /// Of a path that is free to be placed: what the new mechanism has to be turned by about ground's origin,
    /// scaled by, and moved by then for its path to lie where it is wanted.
    struct Placement {
      double turn = 0;
      double scale = 1;
      double x = 0, y = 0;
    };
    std::optional<Placement> placement;
    std::string length_unit, angle_unit;  ///< of the placement
  };
  struct Constraint {
    std::string what;  ///< "max of touch.pressure below 30", as the profile has it
    std::string unit;
    double limit = 0;
    double before = 0;
    double after = 0;
    double margin = 0;  ///< >= 0: it holds
    /// How much smaller the objective, of several their weighted sum, would be for each unit by which the
    /// limit is moved outwards, to first order, at the design before it was rounded to steps; 0 where it is
    /// not active.
    double cost = 0;
    std::string cost_unit;  ///< "mm^2/deg"; of several objectives "1/deg"
  };
  struct Alternative {
    std::vector<double> variables;
    double objective = 0;
    bool holds = false;  ///< all constraints
    /// The profile, of the first DesignSettings::best; of the first one it is DesignReport::text.
    std::string text;
  };

  std::string title;
  std::vector<Variable> variables;
  std::vector<Objective> objectives;
  std::vector<Constraint> constraints;
  /// The whole objective: paths and targets by their squares, times their weights, and what has to be small.
  double before = 0;
  double after = 0;
  bool starts_good = false;         ///< whether the whole path of the profile as it was is on one branch
  bool path_good = false;           ///< whether the new one does
  bool holds = false;               ///< whether all constraints hold, and path_good
  std::string method;               ///< of the local searches: "least squares", …
  std::vector<Alternative> optima;  ///< different ends of searches, the best first; at most 10
  int different = 0;
  int starts = 0;
  std::int64_t evaluations = 0;
  DesignEnd end = DesignEnd::kStarts;
  /// The new profile: the old one's text with other numbers in it. All numbers above were worked out from it,
  /// and from the overrides that the model was read with, which are not in it.
  std::string text;
};

/// Looks for the numbers that serve the task in [design] best: that its rows have the smallest objective
/// while the constraints hold and the mechanism assembles all the way on one branch. Fails (kInput) for a
/// model without such a task, or one that was built; for columns, rows and pins that the task cannot mean;
/// for variables and objectives that change nothing; and where nothing that was tried can be assembled
/// (kMechanism).
[[nodiscard]] Result<DesignReport> design(const Model& model, const DesignSettings& settings = {});

/// What looks like a slip of a task that can be worked on: targets far from what the profile has, but like it
/// if they were in another unit. None where design() fails before its search.
[[nodiscard]] Diagnostics design_notes(const Model& model);

/// A page (HTML, nothing else needed) with what was found: the mechanism before and after with the paths of
/// its points, variables, objectives and constraints. Fails where neither can be drawn.
/// \param before  the model that the design began with
[[nodiscard]] Result<std::string> design_page(const Model& before, const DesignReport& report);

/// The task as the engine takes it (design/problem.hpp), for a search of one's own: variables in the units of
/// the profile, residuals and costs in those of tables, constraints of the closure of each dyad, of the whole
/// path, and of the task. Fails as design() does before its search.
[[nodiscard]] Result<DesignProblem> design_problem(const Model& model);

}  // namespace higherpair
