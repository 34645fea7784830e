#pragma once

#include "chain_rows.hpp"
#include "higherpair/analysis/run.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// A chain and its driver in the first row.
struct ChainStart {
  const Mechanism& mechanism;
  Plan& plan;  ///< its size has to be set before it is given to a Run
  std::span<const ChainGroup> groups;
  ChainDriver<double> driver;
};

/// The assembly of a chain that is nearest to the poses of its bodies: the mode of every dyad, and the place
/// of every contact of ovals. The object can be used for one mechanism after another, which saves
/// allocations.
class ChainAssembly {
public:
  ChainAssembly() = default;
  /// \param with_links  number of bodies, including the links that contacts add
  ChainAssembly(std::size_t bodies, std::size_t with_links, std::size_t groups);

  /// False where there is no assembly that a chain could follow.
  [[nodiscard]] bool find(const ChainStart& start);

  /// The mode of every group.
  [[nodiscard]] const std::vector<double>& modes() const { return best_modes_; }
  /// The first row of every group that is a contact of ovals; following rows start from it.
  [[nodiscard]] std::vector<OvalRow>& ovals() { return ovals_; }
  /// Angle of a body in its pose; 0 for links.
  [[nodiscard]] double posed_angle(std::size_t body) const {
    return body < posed_angles_.size() ? posed_angles_[body] : 0;
  }

private:
  void take_poses(const Mechanism& mechanism);
  [[nodiscard]] double cost_of(const ChainStart& start, const Group& group) const;
  void try_modes(const ChainStart& start, std::size_t g, double cost);
  [[nodiscard]] bool assemble_by_run(const ChainStart& start);
  [[nodiscard]] bool take_modes(const ChainStart& start, const Run& run);
  [[nodiscard]] bool take_mode_of_disc(const ChainStart& start, const Run& run, std::size_t g);
  void place_as(const Run& run, const Group& group);

  std::vector<ChainBody<double>> posed_;   // the poses
  std::vector<double> posed_angles_;       // angles in the poses
  std::vector<ChainBody<double>> bodies_;  // bodies in the first row
  std::vector<double> modes_;              // modes of the assembly that is tried
  std::vector<double> best_modes_;         // modes of the nearest assembly so far
  double best_cost_ = 0;
  double next_cost_ = 0;  // cost of the second nearest assembly
  std::vector<OvalRow> ovals_;
};

}  // namespace higherpair
