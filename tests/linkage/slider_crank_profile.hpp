#pragma once

#include <string>

#include <fmt/core.h>

namespace higherpair::testing {

/// The tables of a profile of a slider-crank on the x axis, with the crank at 0° and no driver: bodies crank
/// (O, A), rod (A, B) and piston (B); joints main, big_end, small_end and cylinder. Lengths in the profile's
/// unit.
/// \param piston    further keys of the piston
/// \param cylinder  further keys of the cylinder
inline std::string slider_crank_profile(double crank, double rod, const std::string& piston = "",
                                        const std::string& cylinder = "") {
  return fmt::format(R"(
[bodies.ground]
points.O = [0, 0]
[bodies.crank]
points = {{ O = [0, 0], A = [{0}, 0] }}
[bodies.rod]
pose = {{ x = {0} }}
points = {{ A = [0, 0], B = [{1}, 0] }}
[bodies.piston]
pose = {{ x = {2} }}
points.B = [0, 0]
{3}
[joints]
main      = {{ type = "revolute", between = ["ground.O", "crank.O"] }}
big_end   = {{ type = "revolute", between = ["crank.A", "rod.A"] }}
small_end = {{ type = "revolute", between = ["rod.B", "piston.B"] }}
[joints.cylinder]
type = "prismatic"
between = ["ground.O", "piston.B"]
direction = [1, 0]
{4}
)",
                     crank, rod, crank + rod, piston, cylinder);
}

}  // namespace higherpair::testing
