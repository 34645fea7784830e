#include "higherpair/cam/flank.hpp"

#include "envelope.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"
#include "worst_place.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace higherpair {
namespace {

constexpr std::size_t kPartsOfSpan = 48, kMostParts = 360;
constexpr std::size_t kPartsOfStretch = 4;  // where the law oscillates

// A spline through many points may vary in shape between any two of them, though hardly much.
int parts_for(std::size_t knots, std::size_t stretches) {
  return static_cast<int>(std::min(std::max(kPartsOfSpan + knots, kPartsOfStretch * stretches), kMostParts));
}

// Parameters of a span at its places within the law.
std::vector<double> breaks_at(const std::vector<double>& places, double sense) {
  std::vector<double> breaks;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    breaks.push_back(sense * places[i]);
  }
  std::sort(breaks.begin(), breaks.end());
  return breaks;
}

// The flank between two joins of the law; at the knots of a spline curvature and its rate are continuous.
class FlankSpan final : public Span {
public:
  /// \param places  its ends and the places between which the law is smooth and monotonic, ascending
  FlankSpan(std::shared_ptr<const Envelope> envelope, double sense, const std::vector<double>& places)
      : envelope_(std::move(envelope)),
        sense_(sense),
        joint_{places.front(), places.back()},
        low_(*envelope_->at(joint_.low, LawSide::kAfter, sense)),
        high_(*envelope_->at(joint_.high, LawSide::kBefore, sense)),
        breaks_(breaks_at(places, sense)) {
    const CamMotion& motion = envelope_->origin().motion;
    parts_ = parts_for(motion.law.breaks(joint_.low, joint_.high).size(), places.size() - 1);
    const LawExtremes velocity = motion.law.extremes(1, joint_.low, joint_.high);
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
                              : *envelope_->at(x, LawSide::kAfter, sense_);
  }
  [[nodiscard]] std::optional<CurvatureRates> curvature_rates(double t) const override {
    if (dwell_) {
      return CurvatureRates{};
    }
    const double x = std::clamp(sense_ * t, joint_.low, joint_.high);
    return envelope_->curvature_rates(x, x < joint_.high ? LawSide::kAfter : LawSide::kBefore, sense_);
  }
  [[nodiscard]] Bounds range() const override { return sense_ > 0 ? joint_ : -joint_; }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    return envelope_->bounds(sense_ > 0 ? t : -t, sense_);
  }
  [[nodiscard]] int parts() const override { return parts_; }
  [[nodiscard]] std::vector<double> breaks() const override { return breaks_; }
  [[nodiscard]] FlankOrigin origin() const { return envelope_->origin(); }
  [[nodiscard]] double coordinate(double t) const { return sense_ * t; }

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
  std::vector<double> breaks_;
  int parts_ = 1;
};

// Whether the joint moves the follower's curve within itself: a circle or point on the follower's pivot, a
// face along its guide.
bool moves_along_itself(const OneFreedom& follower, const Curve& curve, double size) {
  if (follower.turns) {
    const auto center = round_center(curve);
    return center && (*center - follower.p_BO).norm() <= kNoMotionOnCam * size;
  }
  return is_line(curve) && std::abs(follower.direction_W.dot(follower.R_WB * curve.axis_B)) <= kNoMotionOnCam;
}

// The sense of the cam's coordinate in which the flank runs along its tangent. With the follower's curvature
// κ_f, the velocity w of its centre of curvature relative to the cam, and its angular velocity ω,
//     (κ + κ_f) ds/dx = -κ_f w·t, or ω for a line,
// and two bodies that touch do not cut into each other if κ + κ_f > 0. A hollow follower may also lie on the
// other side: then its first place decides.
double sense_of(const Envelope& envelope, double x, const SpanPoint& first) {
  const auto& [motion, curve, outer] = envelope.origin();
  if (is_conic(curve) && curve.side == Side::kOutside) {
    return first.speed > 0 ? 1 : -1;
  }
  if (!is_line(curve)) {
    return -envelope.slip();
  }
  const double omega = (motion.follower.turns ? motion.follower_sign * motion.law.derivative(1, x) : 0) -
                       (motion.cam.turns ? motion.cam_sign : 0);
  return omega > 0 ? 1 : -1;
}

// The first place in a stretch at which the flank runs backwards, stands still, or does not exist.
std::optional<FlankFault> fault_within(const Envelope& envelope, double sense, const LawSearch& search,
                                       double slowest) {
  const auto backwards = [&](double x, LawSide side) {
    const auto point = envelope.at(x, side, sense);
    return point && point->p_B.allFinite() ? -point->speed : kNoValue;
  };
  const auto x = search.first_above(-slowest, backwards);
  if (!x) {
    return std::nullopt;
  }
  return FlankFault{!envelope.at(*x, LawSide::kAfter, sense) ? FlankFault::Kind::kNoNormal
                    : is_point(envelope.origin().curve)      ? FlankFault::Kind::kStandstill
                                                             : FlankFault::Kind::kUndercut,
                    *x};
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
  const auto envelope = std::make_shared<const Envelope>(FlankOrigin{motion, curve, outer});
  const double middle = (ends[0] + ends[1]) / 2;
  const auto first = envelope->at(middle, LawSide::kAfter, 1);
  if (!first) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kNoNormal, middle});
  }
  if (!(std::abs(first->speed) > kNoMotionOnCam * first->p_B.norm())) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kStandstill, middle});
  }
  if (moves_along_itself(motion.follower, curve, first->p_B.norm())) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kNoEffect, middle});
  }
  const double sense = sense_of(*envelope, middle, *first);
  const double slowest = kNoMotionOnCam * first->p_B.norm();
  std::vector<SpanPtr> spans;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const LawSearch search(motion.law, ends[i], ends[i + 1]);
    if (const auto fault = fault_within(*envelope, sense, search, slowest)) {
      return tl::unexpected(*fault);
    }
    spans.push_back(std::make_shared<FlankSpan>(envelope, sense, search.places()));
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

std::optional<double> flank_coordinate(const Span& span, double t) {
  const auto* flank = dynamic_cast<const FlankSpan*>(&span);
  return flank != nullptr ? std::optional(flank->coordinate(t)) : std::nullopt;
}

MotionLaw flank_law(const MotionLaw& law, bool cam_turns) {
  const double over = law.end() - law.begin();
  const double lobes = std::round(2 * kPi / over);
  const bool is_turn = lobes >= 2 && std::abs(lobes * over - 2 * kPi) <= kOnceRound;
  return cam_turns && is_turn && law.repeats() && law.advance() == 0 ? law.repeated(static_cast<int>(lobes))
                                                                     : law;
}

bool closes(const CamMotion& motion) {
  return motion.cam.turns && motion.law.repeats() &&
         std::abs(motion.law.end() - motion.law.begin() - 2 * kPi) <= kOnceRound;
}

}  // namespace higherpair
