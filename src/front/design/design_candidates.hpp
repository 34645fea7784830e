#pragma once

#include "design_pins.hpp"
#include "design_runs.hpp"
#include "design_slopes.hpp"

#include <span>

namespace higherpair {

/// Number of groups of a plan with two modes.
[[nodiscard]] std::size_t closure_count(const Plan& plan);

/// Evaluates candidates one after the other, each by the fastest method that yields what the task asks for.
/// For use by one thread.
class DesignCandidates {
public:
  /// \param setup  must outlive this
  explicit DesignCandidates(const DesignSetup& setup);

  /// Computes the rows of the candidate x on a branch.
  void work_out(std::span<const double> x, int branch);
  /// Those of the last candidate.
  [[nodiscard]] const DesignRows& rows() const { return rows_; }
  [[nodiscard]] DesignRows& rows() { return rows_; }

  /// For a linkage of pins: exact derivatives of the last rows by the variables, except those of measures;
  /// else null.
  [[nodiscard]] PinnedRows* pins() { return pins_ ? &*pins_ : nullptr; }
  /// Exact derivatives of the last rows, of everything that pins() does not cover; none where they are not
  /// available. \param places  for each path; empty with pins()
  [[nodiscard]] std::optional<DesignSlopes> slopes(std::span<const double> x, int branch,
                                                   std::span<const std::vector<SlopePlace>> places) const;

private:
  void work_out_rows(std::span<const double> x, int branch);
  [[nodiscard]] Result<Model> model_of(std::span<const double> x, int branch) const;
  [[nodiscard]] std::optional<Mechanism> mechanism_of(std::span<const double> x) const;
  void add_quantities(std::span<const double> x, int branch);
  [[nodiscard]] std::optional<DesignCandidate> candidate_of(std::span<const double> x, bool with_data) const;
  void place_directly(std::span<const double> x, int branch);
  void add_extents(std::span<const double> x, int branch);
  void fail();

  const DesignSetup* setup_;
  std::optional<PinnedRows> pins_;
  std::optional<RunSlopes> run_slopes_;
  bool direct_ = false;        // positions of any row are known in closed form
  bool any_position_ = false;  // places between rows are needed
  DesignRows rows_;
};

}  // namespace higherpair
