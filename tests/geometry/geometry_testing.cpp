#include "geometry/geometry_testing.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace higherpair::testing {

std::array<double, 6> NaturalConic::coefficients() const {
  using Real = boost::multiprecision::cpp_bin_float_50;
  const Real c = cos(Real(rotation));
  const Real s = sin(Real(rotation));
  const Real x0 = c * origin_B.x() + s * origin_B.y();
  const Real y0 = c * origin_B.y() - s * origin_B.x();
  // along (x - x0)² + across (y - y0)² + linear (x - x0) + constant = 0 in the turned frame
  const bool parabola = kind == CurveKind::kParabola;
  const Real along = parabola ? Real(0) : Real(b) * b;
  const Real across = parabola ? Real(1) : (kind == CurveKind::kHyperbola ? -1 : 1) * Real(a) * a;
  const Real linear = parabola ? -4 * Real(a) : Real(0);
  const Real constant = parabola ? Real(0) : -Real(a) * a * b * b;
  const Real along_x = linear - 2 * along * x0;
  const Real along_y = -2 * across * y0;
  const auto rounded = [](const Real& value) { return value.convert_to<double>(); };
  return {rounded(along * c * c + across * s * s),
          rounded(along * s * s + across * c * c),
          rounded(2 * (along - across) * c * s),
          rounded(along_x * c - along_y * s),
          rounded(along_x * s + along_y * c),
          rounded(along * x0 * x0 + across * y0 * y0 - linear * x0 + constant)};
}

}  // namespace higherpair::testing
