#pragma once

#include "force_fit.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace higherpair {

/// Watches the forces of all contacts, piece after piece along a path: where contacts open, and how low the
/// forces become. Results are added to `forces`.
class ForceWatch {
public:
  ForceWatch(const DriverPath& path, ForceFitter& fitter, ContactForces& forces)
      : path_(path),
        fitter_(fitter),
        forces_(forces),
        contacts_(fitter.position().run.mechanism().contacts.size()) {}

  /// \param before  position of the run before the piece
  /// \param behind  where the piece's forces begin, if something singular before it was left out; else none
  void pass(const ForceFitter::Position& before, const ForcePiece& piece, std::optional<double> behind);

  /// Called after a stretch without forces: nothing is known of the contacts any more.
  void forget();

private:
  enum class State { kUnknown, kPressing, kOpen };

  // What is known of a contact at the end of the previous piece.
  struct Watched {
    State state = State::kUnknown;
    double end = 0;       // its force there [N]
    double least = kInf;  // the least of the pieces' largest forces so far
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
