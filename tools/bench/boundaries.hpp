#pragma once

#include "cases.hpp"

#include <string>
#include <vector>

namespace higherpair::bench {

/// A composite cam whose motion is known.
struct BoundaryCase {
  std::string name;
  Run run;  ///< at driver position 0
};

/// The ellipse of a case from make_cases() as a spline through 720 of its points, with the roller of that
/// case. Ends the program if it moves differently from the ellipse.
[[nodiscard]] BoundaryCase checked_spline_cam(const Case& ellipse);

/// A cam with a flat follower at two positions: one step before a joint of its arcs, so that the next step
/// passes it, and one step earlier. Ends the program if the lift is not that of the arcs.
struct JointCase {
  Run before_joint;
  Run before_that;
  double step = 0;  ///< of the driver [rad]
};
[[nodiscard]] JointCase checked_joint();

/// A temporary folder of files that take long to read or check.
class LargeFiles {
public:
  LargeFiles();
  ~LargeFiles();
  LargeFiles(const LargeFiles&) = delete;
  LargeFiles& operator=(const LargeFiles&) = delete;

  struct File {
    std::string name;
    std::string profile;  ///< path
    bool check = false;   ///< the file is checked as well as read
  };
  [[nodiscard]] const std::vector<File>& files() const { return files_; }

private:
  std::string folder_;
  std::vector<File> files_;
};

/// Ends the program if a file cannot be read or does not have the content it was made from.
void require_right(const LargeFiles& large);

}  // namespace higherpair::bench
