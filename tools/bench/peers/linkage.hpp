#pragma once

#include <memory>
#include <string>
#include <vector>

namespace higherpair::peers {

/// A crank that turns at 1 rad/s about the origin, a link of length `link` from its end A to B, and at B a
/// rocker about (ground, 0) or a block that slides along the line y = offset. Lengths are of the order of 1,
/// as game engines require; every body has mass 1, centred between its two pins.
struct Linkage {
  bool slides = false;
  double ground = 0;
  double crank = 0;
  double link = 0;
  double rocker = 0;  ///< length of the rocker, if it turns
  double offset = 0;  ///< of the slide's line, if it slides
};

struct Point {
  double x = 0, y = 0;
};

/// Output of a linkage: the rocker's angle, counted over whole turns, or the block's x; and its rate.
struct Output {
  double position = 0;
  double rate = 0;
};

/// The closed form for a crank at `angle`: B is above the line from A to the rocker's pivot, or the block is
/// ahead.
struct Solution {
  Point A, B;
  Output output;  ///< the angle in (-pi, pi]
};
[[nodiscard]] Solution solution_at(const Linkage& linkage, double angle);

inline constexpr int kStepsPerTurn = 3600;

/// A linkage in some engine, starting with the crank along x. All engines take the same steps.
class PeerRun {
public:
  PeerRun() = default;
  PeerRun(const PeerRun&) = delete;
  PeerRun& operator=(const PeerRun&) = delete;
  virtual ~PeerRun() = default;

  /// Moves the crank by 1/kStepsPerTurn of a turn.
  virtual void step() = 0;
  [[nodiscard]] virtual Output output() const = 0;
};

/// Two discs, one mounted eccentrically on a crank, the other on an arm and pressed against it by a torque.
/// Their contact determines the arm's angle.
struct Discs {
  double eccentricity = 0, cam = 0;        ///< centre at (eccentricity, 0) of the crank, radius
  double ground = 0, arm = 0, roller = 0;  ///< the arm's pivot at (ground, 0), its length, the disc's radius
};
[[nodiscard]] Output discs_at(const Discs& discs, double angle);

/// An engine.
struct Peer {
  std::string name;
  std::string package;                                            ///< Debian package that provides the engine
  std::unique_ptr<PeerRun> (*linkage)(const Linkage&) = nullptr;  ///< none: the engine is not installed
  std::unique_ptr<PeerRun> (*discs)(const Discs&) = nullptr;      ///< none: no such contact
};

[[nodiscard]] Peer this_library();
[[nodiscard]] Peer simbody();
[[nodiscard]] Peer ode();
[[nodiscard]] Peer box2d();
[[nodiscard]] Peer chipmunk();

}  // namespace higherpair::peers
