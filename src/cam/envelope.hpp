#pragma once

#include "higherpair/cam/flank.hpp"

#include <optional>

namespace higherpair {

/// The envelope of a follower's curve in its motion relative to a cam: see cam_flank(). The parameter of
/// tangents, curvature rates and bounds is `sense` times the cam's coordinate: +1 or -1.
class Envelope {
public:
  explicit Envelope(FlankOrigin origin);

  [[nodiscard]] const FlankOrigin& origin() const { return origin_; }

  /// Sign, where the follower touches, of the velocity of its centre of curvature relative to the cam, along
  /// its t, for a unit rate of the cam's joint: see side_of().
  [[nodiscard]] double slip() const { return slip_; }

  /// The point of the cam that touches at the coordinate x of the cam's joint, with the derivatives of the
  /// law on one side of it. None where no point of the follower can touch.
  [[nodiscard]] std::optional<SpanPoint> at(double x, LawSide side, double sense) const;

  /// Rates of the cam's curvature there, along its tangent.
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double x, LawSide side, double sense) const;

  /// Bounds of the span over a range of the cam's coordinate within one piece of the law. None where they
  /// cannot be determined.
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& x, double sense) const;

private:
  FlankOrigin origin_;
  double slip_ = 1;
};

}  // namespace higherpair
