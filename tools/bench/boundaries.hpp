#pragma once

#include "cases.hpp"

#include <string>
#include <vector>

namespace higherpair::bench {

/// A cam of several parts whose answer is known.
struct BoundaryCase {
  std::string name;
  Run run;  ///< standing at driver position 0
};

/// The ellipse of a case of make_cases() as a spline through 720 of its points, with the case's roller. Ends
/// the program where it moves otherwise than the ellipse.
[[nodiscard]] BoundaryCase checked_spline_cam(const Case& ellipse);

/// A cam with a flat follower in two places: one step in front of a joint of its arcs, so that the next one
/// goes over it, and one step farther in front. Ends the program where the lift is not that of the arcs.
struct JointCase {
  Run before_joint;
  Run before_that;
  double step = 0;  ///< of the driver [rad]
};
[[nodiscard]] JointCase checked_joint();

/// A folder of files that take their time to read or check, and is removed again.
class LargeFiles {
public:
  LargeFiles();
  ~LargeFiles();
  LargeFiles(const LargeFiles&) = delete;
  LargeFiles& operator=(const LargeFiles&) = delete;

  struct File {
    std::string name;
    std::string profile;  ///< path
    bool check = false;   ///< besides reading it
  };
  [[nodiscard]] const std::vector<File>& files() const { return files_; }

private:
  std::string folder_;
  std::vector<File> files_;
};

/// Ends the program where a file is not read, or is not what it has been written from.
void require_right(const LargeFiles& large);

}  // namespace higherpair::bench
