#pragma once

#include "chain_rows.hpp"
#include "higherpair/analysis/run.hpp"

#include <span>
#include <vector>

namespace higherpair {

/// A chain in its first row.
struct ChainStart {
  const Mechanism& mechanism;
  Plan& plan;  ///< a Run that is asked wants its size set
  std::span<const ChainGroup> groups;
  ChainDriver<double> driver;
};

/// The assembly of a chain that is nearest to the poses of its bodies: the mode of every dyad, and where
/// contacts of ovals are. Its storage serves one mechanism after the other.
class ChainAssembly {
public:
  ChainAssembly() = default;
  /// \param with_links  bodies, and links between the centres of contacts
  ChainAssembly(std::size_t bodies, std::size_t with_links, std::size_t groups);

  /// False where there is none that a chain could follow.
  [[nodiscard]] bool find(const ChainStart& start);

  /// Of the groups.
  [[nodiscard]] const std::vector<double>& modes() const { return best_modes_; }
  /// Of the groups that are such contacts; the rows to come go on from there.
  [[nodiscard]] std::vector<OvalRow>& ovals() { return ovals_; }
  /// Of a body; 0 of links.
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
  std::vector<double> posed_angles_;       // in them
  std::vector<ChainBody<double>> bodies_;  // in the first row
  std::vector<double> modes_;              // of the assembly that is tried
  std::vector<double> best_modes_;         // of the nearest one so far
  double best_cost_ = 0;
  double next_cost_ = 0;  // of the nearest of the others
  std::vector<OvalRow> ovals_;
};

}  // namespace higherpair
