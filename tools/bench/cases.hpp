#pragma once

#include "front/columns/column_set.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/io/profile.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace higherpair::bench {

inline constexpr int kStepsPerTurn = 3600;

[[nodiscard]] inline double driver_position(int step) {
  return 2 * kPi * step / kStepsPerTurn;
}

/// The difference of two angles, modulo whole turns.
[[nodiscard]] inline double angle_difference(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * kPi));
}

/// An ellipse (or circle) in its body's frame, whose origin is the pivot [m, rad].
struct Oval {
  Vector2d center;
  double a;
  double b;
  double rotation;
};

/// A contact pair whose motion is known independently of the library.
struct Case {
  std::string name;
  Oval cam;
  std::vector<Oval> follower;  ///< curve of a turning follower; empty for the flat face that slides along y
  Vector2d follower_pivot;     ///< in the frame of ground
  Profile profile;
  Run run;  ///< at driver position 0

  [[nodiscard]] const ContactPair& pair() const;
};

/// The track of the contact in a run of a pair.
[[nodiscard]] const ContactTrack& track_of(const Run& run);

/// Circle on circle, ellipse on circle, ellipse on ellipse (turning followers), and ellipse on a sliding flat
/// face.
[[nodiscard]] std::vector<Case> make_cases();

/// All columns of the profile's motion table.
[[nodiscard]] ColumnSet table_of(const Profile& profile);

/// Ends the program with a message unless the condition holds.
void require(bool condition, const std::string& message);

}  // namespace higherpair::bench
