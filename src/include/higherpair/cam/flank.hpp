#pragma once

#include "higherpair/cam/motion_law.hpp"
#include "higherpair/geometry/boundary.hpp"
#include "higherpair/geometry/one_freedom.hpp"

#include <optional>

#include <tl/expected.hpp>

namespace higherpair {

/// The motion that a flank has to give to its follower; both bodies are on a revolute or prismatic joint to
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
    kTooLong,  ///< a law over more than one turn of a cam that turns
    /// The follower, or a knife edge at one place, does not move relative to the cam: there is no normal.
    kStandstill,
    kNoEffect,  ///< the follower's joint moves its curve along itself: the law has no effect on the shape
    kNoNormal,  ///< the follower's open curve has no point that could touch
    kUndercut,  ///< from there on the flank would run backwards and undercut what has been shaped before
  } kind = Kind::kStandstill;
  double coordinate = 0;  ///< of the cam's joint [rad or m]
};

/// The curve on the cam that makes the follower move by a law: the envelope of the follower's curve in its
/// motion relative to the cam. A point of the follower is on it when its velocity relative to the cam is
/// along its tangent: with the follower's support h(φ), the velocity w of its frame relative to the cam, in
/// that frame, and its angular velocity ω,
///     w·n(φ) - ω h′(φ) = 0,
/// from which Newton's method gives φ as a power series in the cam's coordinate, so that curvature and its
/// rate are exact (Litvin, Theory of Gearing, 1989, on envelopes). Spans end at the joins of the law; their
/// parameter is the coordinate of the cam's joint, or minus it. A fault is the first along the law.
/// \param curve  of the follower, in its frame: a conic, line or point
/// \param outer  the flank on the follower's far side from the cam's pivot, with its material there (a
/// groove's outer wall). A line has only one flank. For a sliding cam the near side is the one against the
/// sense in which the follower's coordinate grows
[[nodiscard]] tl::expected<std::vector<SpanPtr>, FlankFault> cam_flank(const CamMotion& motion,
                                                                       const Curve& curve, bool outer);

/// What a span of a flank was made from.
struct FlankOrigin {
  CamMotion motion;
  Curve curve;         ///< of the follower, in its frame
  bool outer = false;  ///< as in cam_flank
};

/// The origin of a span made by cam_flank; none for other spans.
[[nodiscard]] std::optional<FlankOrigin> flank_origin(const Span& span);

/// The coordinate of the cam's joint at a parameter of a span made by cam_flank; none for other spans.
[[nodiscard]] std::optional<double> flank_coordinate(const Span& span, double t);

/// The law of a flank: of a turning cam all of its repetitions in one turn, where a whole number of them
/// makes one and each begins as high as the first. A cam of several equal lobes is described by one of them.
[[nodiscard]] MotionLaw flank_law(const MotionLaw& law, bool cam_turns);

/// Whether the flank is closed: a turning cam whose law repeats after one turn and ends where it began.
[[nodiscard]] bool closes(const CamMotion& motion);

}  // namespace higherpair
