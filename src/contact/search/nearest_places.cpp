#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/boundary_places.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <Eigen/Core>

// The nearest places of two boundaries as lines in the space of points and normals. Between samples these
// lines are taken as straight, which an edge is: where it is touched does not depend on how far apart its
// samples are.

namespace higherpair {
namespace {

using Eigen::Vector4d;

// A boundary between two neighbouring samples of a span: point and scaled normal are middle ± half.
struct Piece {
  Vector4d middle, half;
  double length = 0;  // of `half`
  int span = -1;
  Bounds t;

  // The place at middle + x·half.
  [[nodiscard]] BoundaryPlace at(double x) const { return {span, t.low + (1 + x) / 2 * t.width()}; }
};

// \param scale  length by which normals are multiplied [m]; < 0 opposes them
std::vector<Piece> pieces_of(const Boundary& boundary, const Pose<double>& X_WB, double scale) {
  std::vector<Piece> pieces;
  Vector4d last = Vector4d::Zero();
  BoundaryPlace from;
  for (const auto& [place, point] : boundary.samples()) {
    Vector4d at;
    at << X_WB * point.p_B, scale * (X_WB.R_WB * point.n_B);
    if (place.span == from.span) {
      const Vector4d half = (at - last) / 2;
      pieces.push_back({last + half, half, half.norm(), place.span, {from.t, place.t}});
    }
    last = at;
    from = place;
  }
  return pieces;
}

struct Nearest {
  double x = 0, y = 0;  // along the two pieces, in [-1, 1]
  double distance = kInf;
};

// The least distance |d + y b - x a|, with d from one middle to the other and the halves a and b: a convex
// function on a square. Along parallel pieces the first is taken at its middle.
Nearest nearest_on(const Piece& one, const Piece& two) {
  const Vector4d& a = one.half;
  const Vector4d& b = two.half;
  const Vector4d d = two.middle - one.middle;
  const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b), ad = a.dot(d), bd = b.dot(d);
  const double determinant = aa * bb - ab * ab;
  const auto within = [](double x) { return std::clamp(x, -1.0, 1.0); };
  Nearest nearest;
  nearest.x = determinant > kEps * aa * bb ? within((ad * bb - ab * bd) / determinant) : 0;
  nearest.y = within((nearest.x * ab - bd) / bb);
  nearest.x = within((ad + nearest.y * ab) / aa);
  nearest.distance = (d + nearest.y * b - nearest.x * a).norm();
  return nearest;
}

}  // namespace

std::array<BoundaryPlace, 2> nearest_places(const Boundary& boundary1, const Pose<double>& X_W1,
                                            const Boundary& boundary2, const Pose<double>& X_W2) {
  const double scale = std::max(boundary1.size(), boundary2.size());
  const std::vector<Piece> pieces2 = pieces_of(boundary2, X_W2, -scale);
  std::array<BoundaryPlace, 2> best;
  double least = kInf;
  for (const Piece& one : pieces_of(boundary1, X_W1, scale)) {
    for (const Piece& two : pieces2) {
      const double most = least + one.length + two.length;
      if ((two.middle - one.middle).squaredNorm() >= most * most) {
        continue;
      }
      const Nearest nearest = nearest_on(one, two);
      if (nearest.distance < least) {
        least = nearest.distance;
        best = {one.at(nearest.x), two.at(nearest.y)};
      }
    }
  }
  return best;
}

}  // namespace higherpair
