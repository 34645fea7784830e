#pragma once

#include "analysis/groups/group_solver.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <string>
#include <vector>

namespace higherpair {

/// Places the groups of a run one after another at the first driver positions, starting from their poses.
/// Keeps a reference to the run.
class FirstPosition {
public:
  /// \pre run.at.state holds the poses
  explicit FirstPosition(const Run& run);

  /// Places group g in this mode. False where that is not possible. \pre the groups before it are placed
  bool place(std::size_t g, int mode);

  [[nodiscard]] const State& posed() const { return posed_; }
  [[nodiscard]] const State& state() const { return state_; }
  /// Why the last group that was reached cannot be placed.
  [[nodiscard]] const StartFailure& failure() const { return failure_; }

private:
  // \param distance  of the group from its poses, if it was placed
  void fail(std::size_t g, std::string reason, double distance = 0);
  [[nodiscard]] GroupStatus start_rolling_bodies(std::size_t g);
  [[nodiscard]] bool start_tracked(const TrackedPair& tracked, std::size_t g);
  [[nodiscard]] bool start_rolling_pair(const TrackedPair& tracked, std::size_t g, double u, double q,
                                        const FindResult& found);
  [[nodiscard]] bool start_touching(const TouchingBody& touching, std::size_t g);
  [[nodiscard]] bool start_on_boundaries(const TouchingBody& touching, std::size_t g,
                                         const FrozenPair& placed, double posed);
  void start_coupled(const Group& group);

  const Run& run_;
  Planned model_;
  std::vector<DriverMotion> drivers_;
  State posed_;
  State state_;
  State touching_start_;
  std::size_t failed_group_ = 0;
  double failed_distance_ = kInf;
  StartFailure failure_;
};

}  // namespace higherpair
