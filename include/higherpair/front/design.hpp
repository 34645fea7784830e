#pragma once

#include "higherpair/design/optimise.hpp"
#include "higherpair/front/model.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// `seed` and `starts`, where set, override [design] of the profile; `evaluations` is 2,000,000 unless set.
/// `seconds` >= 0.
struct DesignSettings : DesignRun {
  std::optional<std::uint64_t> seed;
  std::optional<int> starts;                ///< >= 1
  std::optional<std::int64_t> evaluations;  ///< >= 1
  int best =
      1;  ///< number of different optima for which the text is made as well, if there are as many; >= 1
};

/// A design that was found, and its profile. All numbers in the units of tables or of the profile; NaN where
/// undefined.
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
    double before = 0;  ///< for a path, and for a column that follows values, the sum of squares
    double after = 0;
    /// For a path that may be placed freely: the rotation about ground's origin, the scale, and then the
    /// displacement of the new mechanism that bring its path to where it is wanted.
    struct Placement {
      double turn = 0;
      double scale = 1;
      double x = 0, y = 0;
    };
    std::optional<Placement> placement;
    std::string length_unit, angle_unit;  ///< of the placement
  };
  struct Constraint {
    std::string what;  ///< "max of touch.pressure below 30", as in the profile
    std::string unit;
    double limit = 0;
    double before = 0;
    double after = 0;
    double margin = 0;  ///< >= 0: it holds
    /// How much smaller the objective (the weighted sum of several) would be for each unit by which the limit
    /// is relaxed, to first order, at the design before rounding to steps; 0 if the constraint is inactive.
    double cost = 0;
    std::string cost_unit;  ///< "mm^2/deg"; with several objectives "1/deg"
  };
  struct Alternative {
    std::vector<double> variables;
    double objective = 0;
    bool holds = false;  ///< whether all constraints hold
    /// Whether the text gives it, as DesignReport::as_found; none without a text.
    std::optional<bool> as_found;
    /// The profile, for the first DesignSettings::best of them; for the very first it is DesignReport::text.
    std::string text;
  };

  std::string title;
  std::vector<Variable> variables;
  std::vector<Objective> objectives;
  std::vector<Constraint> constraints;
  /// The whole objective: the weighted squares for paths and targets, and the weighted values to be
  /// minimised.
  double before = 0;
  double after = 0;
  bool starts_good = false;  ///< whether the whole path of the original profile is on one branch
  bool path_good = false;    ///< the same for the new profile
  /// Whether the new profile, started from its poses, is in the assembly that was found. Poses from which
  /// something is taken exactly are kept, and may lead to another one.
  bool as_found = false;
  bool holds = false;               ///< all constraints hold, path_good and as_found
  std::string method;               ///< of the local searches: "least squares", …
  std::vector<Alternative> optima;  ///< distinct results of the searches, best first; at most 10
  int different = 0;
  int starts = 0;
  std::int64_t evaluations = 0;
  DesignEnd end = DesignEnd::kStarts;
  /// The new profile: the text of the old one with new numbers. All numbers above were computed from it and
  /// from the overrides that the model was read with, which it does not contain.
  std::string text;
};

/// Solves the task in [design]: finds the values of its variables with the smallest objective such that the
/// constraints hold and the mechanism assembles along the whole path on one branch. Fails (kInput) for a
/// model without such a task, or one built in C++; for columns, rows and pins that do not suit the task; for
/// variables and objectives without effect; and (kMechanism) if no candidate that was tried can be assembled.
[[nodiscard]] Result<DesignReport> design(const Model& model, const DesignSettings& settings = {});

/// Probable slips in a task that is otherwise valid: targets far from the profile's values that would be near
/// them in another unit. None if design() fails before its search.
[[nodiscard]] Diagnostics design_notes(const Model& model);

/// A self-contained HTML page with the result: the mechanism before and after with the paths of its points,
/// variables, objectives and constraints. Fails if neither mechanism can be drawn.
/// \param before  the model that the design began with
[[nodiscard]] Result<std::string> design_page(const Model& before, const DesignReport& report);

/// The task in the form that optimise() takes, for use with another search: variables in the units of the
/// profile, residuals and costs in those of tables, constraints for the closure of each dyad, for the whole
/// path, and those of the task. Fails as design() does before its search.
[[nodiscard]] Result<DesignProblem> design_problem(const Model& model);

}  // namespace higherpair
