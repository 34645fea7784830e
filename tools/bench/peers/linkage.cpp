#include "linkage.hpp"

#include <cmath>

namespace higherpair::peers {
namespace {

Solution sliding(const Linkage& linkage, double angle) {
  Solution solution;
  solution.A = {linkage.crank * std::cos(angle), linkage.crank * std::sin(angle)};
  const double across = linkage.offset - solution.A.y;
  const double along = std::sqrt(linkage.link * linkage.link - across * across);
  solution.B = {solution.A.x + along, linkage.offset};
  solution.output = {solution.B.x, -solution.A.y + across * solution.A.x / along};
  return solution;
}

// The intersection of two circles about P and Q on the left of the direction from P to Q.
Point left_of(const Point& P, double p, const Point& Q, double q) {
  const double dx = Q.x - P.x, dy = Q.y - P.y;
  const double d2 = dx * dx + dy * dy;
  const double along = (p * p - q * q + d2) / (2 * d2);
  const double across = std::sqrt(p * p / d2 - along * along);
  return {P.x + along * dx - across * dy, P.y + along * dy + across * dx};
}

// Output of a rocker whose end B is held by a link from A, which turns about the origin at unit rate.
Output rocking(const Point& A, const Point& B, double ground) {
  const double bx = B.x - A.x, by = B.y - A.y;
  const double cx = B.x - ground, cy = B.y;
  return {std::atan2(cy, cx), (A.y * bx - A.x * by) / (bx * cy - by * cx)};
}

}  // namespace

Solution solution_at(const Linkage& linkage, double angle) {
  if (linkage.slides) {
    return sliding(linkage, angle);
  }
  Solution solution;
  solution.A = {linkage.crank * std::cos(angle), linkage.crank * std::sin(angle)};
  solution.B = left_of(solution.A, linkage.link, {linkage.ground, 0}, linkage.rocker);
  solution.output = rocking(solution.A, solution.B, linkage.ground);
  return solution;
}

// The line of centres acts as a link.
Output discs_at(const Discs& discs, double angle) {
  const Point A{discs.eccentricity * std::cos(angle), discs.eccentricity * std::sin(angle)};
  const Point B = left_of(A, discs.cam + discs.roller, {discs.ground, 0}, discs.arm);
  return rocking(A, B, discs.ground);
}

}  // namespace higherpair::peers
