#pragma once

#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/one_freedom.hpp"
#include "higherpair/geometry/spline_span.hpp"

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace higherpair::testing {

/// Random boundaries of all kinds, and ground joints.
class RandomBoundaries {
public:
  /// \param scale  approximate size of the boundaries and their distances
  RandomBoundaries(unsigned seed, double scale) : engine_(seed), scale_(scale) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vector2d place(double far) { return scale_ * Vector2d(between(-far, far), between(-far, far)); }

  Boundary boundary() {
    const double size = scale_ * between(0.3, 1);
    switch (engine_() % 7) {
      case 0:
        return rounded_polygon(size);
      case 1:
        return spline(size, 0.03);
      case 2:
        return spline(size, 0.1);  // has concave parts
      case 3:
        return sharp_polygon(size);
      case 4:
        return boundary_of(
            *make_ellipse(place(0.2), {size * between(0.2, 1), size * between(0.2, 1)}, between(0, 3)), size);
      case 5:
        return boundary_of(*make_circle(place(1), size * between(0.05, 0.8)), size);
      default:
        return *Boundary::make(*offset_spans(rounded_polygon(size), 0.1 * size), true, 1e-9 * size);
    }
  }

  OneFreedom freedom() {
    OneFreedom freedom;
    freedom.turns = engine_() % 2 == 0;
    freedom.p_WO = place(2);
    freedom.p_BO = place(2);
    freedom.theta = between(-3, 3);
    freedom.R_WB = Rotation<double>::from_angle(freedom.theta);
    freedom.direction_W = unit_vector(between(-3, 3));
    return freedom;
  }

private:
  std::vector<Vector2d> corners(double size, double least) {
    const std::size_t count = 3 + engine_() % 5;
    std::vector<Vector2d> corners;
    for (std::size_t i = 0; i < count; ++i) {
      const double at = 2 * kPi * (static_cast<double>(i) + between(-0.2, 0.2)) / static_cast<double>(count);
      corners.emplace_back(size * between(least, 1) * unit_vector(at));
    }
    return corners;
  }

  Boundary sharp_polygon(double size) {
    const std::vector<Vector2d> c = corners(size, 0.4);
    std::vector<SpanPtr> spans;
    for (std::size_t i = 0; i < c.size(); ++i) {
      spans.push_back(face_span(c[i], c[(i + 1) % c.size()]));
    }
    return *Boundary::make(std::move(spans), true, 1e-9 * size);
  }

  // Convex, with the middle inside.
  Boundary rounded_polygon(double size) {
    const double radius = size * between(0.02, 0.3);
    const std::vector<Vector2d> c = corners(size, 0.9);
    const auto normal = [&](std::size_t i) {
      return angle_of(-perp(Vector2d(c[(i + 1) % c.size()] - c[i % c.size()])));
    };
    std::vector<SpanPtr> spans;
    for (std::size_t i = 0; i < c.size(); ++i) {
      const double from = normal(i + c.size() - 1);
      const double to = from + std::remainder(normal(i) - from, 2 * kPi);
      const Vector2d out = radius * unit_vector(to);
      if (!(to > from)) {
        return rounded_polygon(size);
      }
      spans.push_back(conic_span(*make_circle(c[i], radius), from, to));
      spans.push_back(face_span(c[i] + out, c[(i + 1) % c.size()] + out));
    }
    return *Boundary::make(std::move(spans), true, 1e-9 * size);
  }

  Boundary spline(double size, double wave) {
    const double at1 = between(0, 6);
    const double at2 = between(0, 6);
    const auto waves = static_cast<double>(2 + engine_() % 5);
    std::vector<Vector2d> points;
    for (int i = 0; i < 40; ++i) {
      const double a = 2 * kPi * i / 40;
      points.emplace_back(size * (0.8 + 0.1 * std::cos(a + at1) + wave * std::cos(waves * a + at2)) *
                          unit_vector(a));
    }
    SplineOptions options;
    options.closed = true;
    return *Boundary::make({*spline_span(points, options)}, true, 1e-9 * size);
  }

  std::mt19937 engine_;
  double scale_;
};

}  // namespace higherpair::testing
