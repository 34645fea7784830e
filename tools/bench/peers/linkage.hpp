#pragma once

#include <memory>
#include <string>
#include <vector>

namespace higherpair::peers {

/// A crank that turns at 1 rad/s about the origin, a link of length `link` from its end A to B, and at B a
/// rocker about (ground, 0), or a block that slides along the line y = offset. Lengths of the order of 1, as
/// engines for games want them; every body has mass 1 and turns about the middle of its two pins.
struct Linkage {
  bool slides = false;
  double ground = 0;
  double crank = 0;
  double link = 0;
  double rocker = 0;  ///< of one that turns
  double offset = 0;  ///< of one that slides
};

struct Point {
  double x = 0, y = 0;
};

/// Output of a linkage: the rocker's angle, unwound, or the block's x; and its rate.
struct Output {
  double position = 0;
  double rate = 0;
};

/// The closed form for a crank at `angle`: B above the line from A to the rocker's pivot, or the block ahead.
struct Solution {
  Point A, B;
  Output output;  ///< the angle in (-pi, pi]
};
[[nodiscard]] Solution solution_at(const Linkage& linkage, double angle);

inline constexpr int kStepsPerTurn = 3600;

/// A linkage in somebody's engine, standing with the crank along x. All engines take the same steps.
class PeerRun {
public:
  PeerRun() = default;
  PeerRun(const PeerRun&) = delete;
  PeerRun& operator=(const PeerRun&) = delete;
  virtual ~PeerRun() = default;

  /// On to the crank's next position, a kStepsPerTurn-th of a turn.
  virtual void step() = 0;
  [[nodiscard]] virtual Output output() const = 0;
};

/// Two discs, one on a crank off its centre, the other on an arm, which a torque presses on it. The contact
/// between them gives the arm's angle.
struct Discs {
  double eccentricity = 0, cam = 0;        ///< centre at (eccentricity, 0) of the crank, radius
  double ground = 0, arm = 0, roller = 0;  ///< the arm's pivot at (ground, 0), its length, the disc's radius
};
[[nodiscard]] Output discs_at(const Discs& discs, double angle);

/// An engine.
struct Peer {
  std::string name;
  std::string package;                                            ///< of Debian, if it is not there
  std::unique_ptr<PeerRun> (*linkage)(const Linkage&) = nullptr;  ///< none: not there
  std::unique_ptr<PeerRun> (*discs)(const Discs&) = nullptr;      ///< none: no such contact
};

[[nodiscard]] Peer this_library();
[[nodiscard]] Peer simbody();
[[nodiscard]] Peer ode();
[[nodiscard]] Peer box2d();
[[nodiscard]] Peer chipmunk();

}  // namespace higherpair::peers
