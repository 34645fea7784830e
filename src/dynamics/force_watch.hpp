#pragma once

#include "force_fit.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace higherpair {

/// Watches the forces of all contacts, piece after piece along a path: where contacts open, and how low the
/// forces come. What it sees it puts into `forces`.
class ForceWatch {
public:
  ForceWatch(const DriverPath& path, ForceFitter& fitter, ContactForces& forces)
      : path_(path),
        fitter_(fitter),
        forces_(forces),
        contacts_(fitter.position().run.mechanism().contacts.size()) {}

  /// \param before  where the run was in front of the piece
  /// \param behind  where its forces begin behind something singular that was left out; none: nothing was
  void pass(const ForceFitter::Position& before, const ForcePiece& piece, std::optional<double> behind);

  /// Behind a stretch without forces nothing is known of the contacts.
  void forget();

private:
  enum class State { kUnknown, kPressing, kOpen };

  // What is known of a contact at the end of the pieces before.
  struct Watched {
    State state = State::kUnknown;
    double end = 0;                                          // its force there [N]
    double least = std::numeric_limits<double>::infinity();  // largest force of the calmest piece so far
  };

  void find_openings(const ForceFitter::Position& before, const ForcePiece& piece, std::size_t i,
                     const ForceSeries& force, std::optional<double> behind);
  [[nodiscard]] double polished(const ForceFitter::Position& before, const ForcePiece& piece, std::size_t i,
                                const ForceSeries& force, double zero);
  void add_opening(std::size_t contact, double at, ContactOpening::Kind kind);
  void find_lowest(const ForcePiece& piece, std::size_t i, const ForceSeries& force);
  [[nodiscard]] double driver_at(double at) const;

  const DriverPath& path_;
  ForceFitter& fitter_;
  ContactForces& forces_;
  std::vector<Watched> contacts_;
};

}  // namespace higherpair
