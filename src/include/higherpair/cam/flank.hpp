#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/one_freedom.hpp"

#include <memory>
#include <optional>

#include <tl/expected.hpp>

namespace higherpair {

/// The motion that a flank is to give to its follower: both bodies on a revolute or prismatic joint to
/// ground.
struct CamMotion {
  OneFreedom cam;       ///< its coordinate is cam_sign · the joint's
  double cam_sign = 1;  ///< see CarriedBody
  OneFreedom follower;
  double follower_sign = 1;
  double follower_rest = 0;  ///< coordinate of the follower's joint where the law is 0 [rad or m]
  MotionLaw law;             ///< follower's joint less `follower_rest`, by the cam's joint; SI
};

/// Why there is no flank.
struct FlankFault {
  enum class Kind {
    kTooLong,     ///< a law over more than one turn of a cam that turns
    kStandstill,  ///< the follower does not move against the cam: every point would be one of the flank
    kNoEffect,    ///< the follower moves its curve along itself: the law shapes nothing
    kNoNormal,    ///< the follower's curve, open, has no point that could touch
    kUndercut,    ///< the flank would have a cusp, and cut away what it has shaped before
  } kind = Kind::kStandstill;
  double coordinate = 0;  ///< of the cam's joint [rad or m]
};

/// The curve on the cam that makes the follower move by a law: the envelope of the follower's curve in its
/// motion against the cam. A point of the follower is on it when its velocity against the cam is along its
/// tangent: with the follower's support h(φ), its frame's velocity w against the cam, in that frame, and ω
/// its turning,
///     w·n(φ) - ω h′(φ) = 0,
/// of which Newton's method gives φ as a power series in the cam's coordinate, so that curvature and its rate
/// are exact (Litvin, Theory of Gearing, 1989, on envelopes). Spans end where the law has joins; their
/// parameter is the coordinate of the cam's joint, or minus it. \param curve  of the follower, in its frame:
/// a conic, line or point \param outer  the flank on the follower's far side from the cam's pivot, with its
/// material there (a groove's
///   outer wall); of a line there is one only, and a sliding cam has its near side against the sense in which
///   the follower's coordinate grows
[[nodiscard]] tl::expected<std::vector<SpanPtr>, FlankFault> cam_flank(const CamMotion& motion,
                                                                       const Curve& curve, bool outer);

/// What a span of a flank is shaped by.
struct FlankOrigin {
  CamMotion motion;
  Curve curve;         ///< of the follower, in its frame
  bool outer = false;  ///< as of cam_flank
};

/// The origin of a span that cam_flank has made; none of other spans.
[[nodiscard]] std::optional<FlankOrigin> flank_origin(const Span& span);

/// Whether the flank closes: a turning cam whose law repeats after one turn and ends where it began.
[[nodiscard]] bool closes(const CamMotion& motion);

}  // namespace higherpair
