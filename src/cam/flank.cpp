#include "higherpair/cam/flank.hpp"

#include "envelope.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/roots.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace higherpair {
namespace {

constexpr int kPartsOfSpan = 48;
constexpr std::size_t kMostParts = 312;  // largest number of parts added for the knots of a spline
constexpr int kProbes = 64;              // places of a span that are checked for a cusp

// A spline through many points may vary in shape between any two of them, though hardly much.
int parts_for(std::size_t knots) {
  return kPartsOfSpan + static_cast<int>(std::min<std::size_t>(knots, kMostParts));
}

// The flank between two joins of the law; at the knots of a spline curvature and its rate are continuous.
class FlankSpan final : public Span {
public:
  /// \param knots  number of knots of the law within it
  FlankSpan(std::shared_ptr<const Envelope> envelope, double sense, const Bounds& joint, std::size_t knots)
      : envelope_(std::move(envelope)),
        sense_(sense),
        joint_(joint),
        low_(*envelope_->at(joint.low, LawSide::kAfter)),
        high_(*envelope_->at(joint.high, LawSide::kBefore)),
        parts_(parts_for(knots)) {
    const CamMotion& motion = envelope_->origin().motion;
    const LawExtremes velocity = motion.law.extremes(1, joint.low, joint.high);
    if (motion.cam.turns && velocity.least == 0 && velocity.greatest == 0) {
      dwell_ = Dwell{motion.cam.p_BO, motion.cam_sign};
      low_.slope = high_.slope = 0;
      high_.kappa = low_.kappa;
    }
  }

  [[nodiscard]] SpanPoint at(double t) const override {
    const double x = sense_ * t;
    return x <= joint_.low    ? low_
           : x >= joint_.high ? high_
           : dwell_           ? on_dwell(x)
                              : *envelope_->at(x, LawSide::kAfter);
  }
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double t) const override {
    if (dwell_) {
      return CurvatureRates{};
    }
    const double x = std::clamp(sense_ * t, joint_.low, joint_.high);
    return envelope_->curvature_rates(x, x < joint_.high ? LawSide::kAfter : LawSide::kBefore);
  }
  [[nodiscard]] Bounds range() const override { return sense_ > 0 ? joint_ : -joint_; }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    return envelope_->bounds(sense_ > 0 ? t : -t);
  }
  [[nodiscard]] int parts() const override { return parts_; }
  [[nodiscard]] FlankOrigin origin() const { return envelope_->origin(); }

private:
  // While the follower of a turning cam rests, the flank is an arc about the cam's pivot.
  struct Dwell {
    Vector2d pivot_B;
    double cam_sign = 1;
  };

  [[nodiscard]] SpanPoint on_dwell(double x) const {
    const auto R = Rotation<double>::from_angle(-dwell_->cam_sign * (x - joint_.low));
    SpanPoint point = low_;
    point.p_B = dwell_->pivot_B + R * (low_.p_B - dwell_->pivot_B);
    point.n_B = R * low_.n_B;
    return point;
  }

  std::shared_ptr<const Envelope> envelope_;
  std::optional<Dwell> dwell_;
  double sense_;
  Bounds joint_;
  SpanPoint low_, high_;  // its ends, cached because steps along a boundary need them often
  int parts_;
};

// Whether the joint moves the follower's curve within itself: a circle or point on the follower's pivot, a
// face along its guide.
bool moves_along_itself(const OneFreedom& follower, const Curve& curve, double size) {
  if (follower.turns) {
    const auto centre = round_center(curve);
    return centre && (*centre - follower.p_BO).norm() <= kNoMotionOnCam * size;
  }
  return is_line(curve) && std::abs(follower.direction_W.dot(follower.R_WB * curve.axis_B)) <= kNoMotionOnCam;
}

// Where the flank begins to run backwards, at speed 0.
double cusp_before(const Envelope& envelope, double from, double to, double speed_to) {
  const auto speed = [&](double x) {
    const auto point = envelope.at(x, LawSide::kAfter);
    return point ? point->speed : std::nan("");
  };
  const auto root = root_between([&](double x) { return speed(from + x); }, speed(from), to - from, speed_to);
  return root ? from + *root : to;
}

// The first place in a stretch at which the flank runs backwards, or does not exist.
std::optional<FlankFault> fault_within(const Envelope& envelope, double from, double to, std::size_t knots) {
  const int probes = kProbes + static_cast<int>(knots);
  double last = from;
  for (int i = 0; i <= probes; ++i) {
    const double x = i == probes ? to : from + i * ((to - from) / probes);
    const auto point = envelope.at(x, i == probes ? LawSide::kBefore : LawSide::kAfter);
    if (!point || !point->p_B.allFinite()) {
      return FlankFault{FlankFault::Kind::kNoNormal, x};
    }
    if (!(point->speed > 0)) {
      return FlankFault{FlankFault::Kind::kUndercut,
                        i == 0 ? x : cusp_before(envelope, last, x, point->speed)};
    }
    last = x;
  }
  return std::nullopt;
}

}  // namespace

tl::expected<std::vector<SpanPtr>, FlankFault> cam_flank(const CamMotion& motion, const Curve& curve,
                                                         bool outer) {
  if (motion.cam.turns && motion.law.end() - motion.law.begin() > 2 * kPi * (1 + kTurnRounding)) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kTooLong, motion.law.end()});
  }
  std::vector<double> ends;
  for (const LawJoin& join : motion.law.joins()) {
    ends.push_back(join.x);
  }
  auto envelope = std::make_shared<Envelope>(FlankOrigin{motion, curve, outer});
  const double middle = (ends[0] + ends[1]) / 2;
  const auto first = envelope->at(middle, LawSide::kAfter);
  if (!first) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kNoNormal, middle});
  }
  if (!(std::abs(first->speed) > kNoMotionOnCam * first->p_B.norm())) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kStandstill, middle});
  }
  if (moves_along_itself(motion.follower, curve, first->p_B.norm())) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kNoEffect, middle});
  }
  const double sense = first->speed > 0 ? 1 : -1;
  envelope->set_sense(sense);
  std::vector<SpanPtr> spans;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const std::size_t knots = motion.law.breaks(ends[i], ends[i + 1]).size();
    if (const auto fault = fault_within(*envelope, ends[i], ends[i + 1], knots)) {
      return tl::unexpected(*fault);
    }
    spans.push_back(std::make_shared<FlankSpan>(envelope, sense, Bounds{ends[i], ends[i + 1]}, knots));
  }
  if (sense < 0) {
    std::reverse(spans.begin(), spans.end());
  }
  return spans;
}

std::optional<FlankOrigin> flank_origin(const Span& span) {
  const auto* flank = dynamic_cast<const FlankSpan*>(&span);
  return flank != nullptr ? std::optional(flank->origin()) : std::nullopt;
}

bool closes(const CamMotion& motion) {
  return motion.cam.turns && motion.law.repeats() &&
         std::abs(motion.law.end() - motion.law.begin() - 2 * kPi) <= kOnceRound;
}

}  // namespace higherpair
