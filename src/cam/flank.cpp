#include "higherpair/cam/flank.hpp"

#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/roots.hpp"
#include "higherpair/geometry/support.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace higherpair {
namespace {

using Series = PowerSeries<double, 3>;
using Longer = PowerSeries<double, 4>;
using Vector = Vector2<Series>;

constexpr int kPartsOfSpan = 48;
constexpr std::size_t kMostParts = 312;  // more than that, for the knots of a spline
constexpr int kProbes = 64;              // places of a span at which a cusp is looked for
constexpr int kMaxNewton = 50;
constexpr double kSettled = 1e-14;   // of an angle
constexpr double kNoMotion = 1e-12;  // of the size: a motion against the cam that is none

Series shortened(const Longer& x) {
  Series y;
  std::copy_n(x.c.begin(), y.c.size(), y.c.begin());
  return y;
}

Series derivative(const Longer& x) {
  Series y;
  for (std::size_t k = 0; k < y.c.size(); ++k) {
    y.c[k] = static_cast<double>(k + 1) * x.c[k + 1];
  }
  return y;
}

template <class F>
Vector each(const Vector2<Longer>& v, const F& f) {
  return {f(v.x()), f(v.y())};
}

Vector2<Longer> constant(const Vector2d& v) {
  return {Longer(v.x()), Longer(v.y())};
}

Pose<Longer> pose_of(const OneFreedom& freedom, const Longer& q) {
  if (freedom.turns) {
    const auto R = Rotation<Longer>::from_angle(q);
    return {R, constant(freedom.p_WO) - R * constant(freedom.p_BO)};
  }
  const Rotation<Longer> R{Longer(freedom.R_WB.cos), Longer(freedom.R_WB.sin)};
  return {R, constant(freedom.p_WO - freedom.R_WB * freedom.p_BO) + q * constant(freedom.direction_W)};
}

// The follower's motion against the cam, by the coordinate of the cam's joint.
struct Relative {
  Rotation<Series> R;  // from the follower's frame to the cam's
  Vector p;            // origin of the follower's frame in the cam's
  Vector w;            // its velocity, in the follower's frame
  Series omega;
};

Relative relative_at(const CamMotion& motion, double x, LawSide side) {
  Longer joint(x);
  joint.c[1] = 1;
  Longer s;
  motion.law.expand(x, side, s.c);
  const Pose<Longer> cam = pose_of(motion.cam, motion.cam_sign * joint);
  const Longer q = motion.follower_sign * (motion.follower_rest + s);
  const Pose<Longer> follower = pose_of(motion.follower, q);
  const Rotation<Longer> R = cam.R_WB.inverse() * follower.R_WB;
  const Vector2<Longer> p = cam.inverse_times(follower.p_WB);
  Relative relative;
  relative.R = {shortened(R.cos), shortened(R.sin)};
  relative.p = each(p, shortened);
  relative.w = relative.R.inverse() * each(p, derivative);
  relative.omega = Series(0.0);
  if (motion.follower.turns) {
    relative.omega += derivative(q);
  }
  if (motion.cam.turns) {
    relative.omega -= Series(motion.cam_sign);
  }
  return relative;
}

// A point of the follower and its outward normal, in the follower's frame.
struct Touch {
  Vector p, n;
};

Vector unit_series(const Series& phi) {
  using higherpair::cos;
  using higherpair::sin;
  return {cos(phi), sin(phi)};
}

class Envelope {
public:
  Envelope(CamMotion motion, const Curve& curve, bool outer)
      : motion_(std::move(motion)), curve_(curve), outer_(outer) {}

  [[nodiscard]] FlankOrigin origin() const { return {motion_, curve_, outer_}; }
  void set_sense(double sense) { sense_ = sense; }

  // None where no point of the follower can touch.
  [[nodiscard]] std::optional<SpanPoint> at(double x, LawSide side) const {
    const Relative relative = relative_at(motion_, x, side);
    const auto touch = touch_at(relative);
    if (!touch) {
      return std::nullopt;
    }
    const Vector p = relative.R * touch->p + relative.p;
    const Vector n = relative.R * touch->n;
    return point_of(p, Vector2d(-value_of(n.x()), -value_of(n.y())));
  }

private:
  [[nodiscard]] SpanPoint point_of(const Vector& p, const Vector2d& n) const {
    const auto derivative_of = [&](std::size_t k, double factor) {
      return Vector2d(factor * p.x().c[k], factor * p.y().c[k]);
    };
    // Along the way of the parameter sense · x.
    const Vector2d d1 = sense_ * derivative_of(1, 1);
    const Vector2d d2 = derivative_of(2, 2);
    const Vector2d d3 = sense_ * derivative_of(3, 6);
    const double speed = d1.dot(perp(n));
    const double per2 = 1 / (speed * speed);
    const double turn = cross(d1, d2);
    return {derivative_of(0, 1), n, turn * per2 / speed,
            (cross(d1, d3) * per2 - 3 * turn * d1.dot(d2) * per2 * per2) * per2, speed};
  }

  [[nodiscard]] std::optional<Touch> touch_at(const Relative& relative) const {
    if (is_line(curve_)) {
      return touch_of_line(relative);
    }
    if (const auto centre = round_center(curve_)) {
      return touch_of_circle(relative, *centre);
    }
    return touch_of_conic(relative);
  }

  [[nodiscard]] std::optional<Touch> touch_of_line(const Relative& relative) const {
    if (value_of(relative.omega) == 0) {
      return std::nullopt;
    }
    const Vector2d n = -curve_.axis_B;
    const Vector2d t = perp(n);
    const Series along = (relative.w.x() * n.x() + relative.w.y() * n.y()) / relative.omega;
    const Vector2d foot = curve_.vertex_B - curve_.vertex_B.dot(t) * t;
    return Touch{{foot.x() + along * t.x(), foot.y() + along * t.y()}, {Series(n.x()), Series(n.y())}};
  }

  // The normal is across the velocity of the centre.
  [[nodiscard]] std::optional<Touch> touch_of_circle(const Relative& relative, const Vector2d& centre) const {
    const Vector W(relative.w.x() - centre.y() * relative.omega,
                   relative.w.y() + centre.x() * relative.omega);
    const Series length = sqrt(W.x() * W.x() + W.y() * W.y());
    if (!(value_of(length) > 0)) {
      return std::nullopt;
    }
    Vector n(-W.y() / length, W.x() / length);
    if (faces_away(relative, centre, {value_of(n.x()), value_of(n.y())})) {
      n = -n;
    }
    const double r = curve_.semi_latus * (curve_.side == Side::kInside ? 1 : -1);
    return Touch{{centre.x() + r * n.x(), centre.y() + r * n.y()}, n};
  }

  // Newton's method for the normal's angle, in numbers and then in series.
  [[nodiscard]] std::optional<Touch> touch_of_conic(const Relative& relative) const {
    const PlacedCurve<double> placed = place(curve_, Pose<double>{});
    const Vector2d w(value_of(relative.w.x()), value_of(relative.w.y()));
    const double omega = value_of(relative.omega);
    const auto equation = [&](double phi) {
      const Vector2d n = unit_vector(phi);
      const SupportPoint<double> point = support_point(placed, n);
      const double h = point.p_W.dot(n);
      return std::array{w.dot(n) - omega * point.p_W.dot(perp(n)), w.dot(perp(n)) - omega * (point.rho - h)};
    };
    std::optional<double> root;
    for (const double guess : guesses(placed, equation)) {
      double phi = guess;
      for (int i = 0; i < kMaxNewton; ++i) {
        const auto [f, df] = equation(phi);
        const double step = -f / df;
        phi += std::clamp(step, -0.3, 0.3);
        if (!(std::abs(step) > kSettled)) {
          break;
        }
      }
      const Vector2d n = unit_vector(phi);
      if (has_point(placed, n) && !faces_away(relative, support_point(placed, n).p_W, n)) {
        root = phi;
        break;
      }
    }
    return root ? std::optional(series_of_conic(relative, *root)) : std::nullopt;
  }

  [[nodiscard]] Touch series_of_conic(const Relative& relative, double phi_at) const {
    PlacedCurve<Series> placed;
    placed.vertex_W = {Series(curve_.vertex_B.x()), Series(curve_.vertex_B.y())};
    placed.axis_W = {Series(curve_.axis_B.x()), Series(curve_.axis_B.y())};
    placed.semi_latus = curve_.semi_latus;
    placed.q = curve_.q;
    placed.side = curve_.side == Side::kInside ? 1 : -1;
    Series phi(phi_at);
    Touch touch;
    // Each pass doubles the number of right terms.
    for (int pass = 0; pass < 4; ++pass) {
      touch.n = unit_series(phi);
      const Vector t(-touch.n.y(), touch.n.x());
      const SupportPoint<Series> point = support_point(placed, touch.n);
      touch.p = point.p_W;
      const Series h = dot(touch.p, touch.n);
      const Series f = dot(relative.w, touch.n) - relative.omega * dot(touch.p, t);
      phi -= f / (dot(relative.w, t) - relative.omega * (point.rho - h));
    }
    return touch;
  }

  [[nodiscard]] static Series dot(const Vector& a, const Vector& b) { return a.x() * b.x() + a.y() * b.y(); }

  // Where the equation changes its sign round the normals of the curve.
  template <class F>
  [[nodiscard]] static std::vector<double> guesses(const PlacedCurve<double>& placed, const F& equation) {
    const NormalArc all = normals_of(placed).value_or(NormalArc{});
    std::vector<double> found;
    double last = 0;
    for (int i = 1; i < kProbes; ++i) {
      const double phi = all.middle + all.half * (2.0 * i / kProbes - 1);
      const double f = equation(phi)[0];
      if (last * f < 0) {
        found.push_back(phi - all.half / kProbes);
      }
      last = f;
    }
    // Of a closed curve one may lie across the cut.
    found.push_back(all.middle + all.half);
    return found;
  }

  // Whether a point of the follower with the outward normal n, in its frame, is on the side that is not
  // wanted.
  [[nodiscard]] bool faces_away(const Relative& relative, const Vector2d& p, const Vector2d& n) const {
    Vector2d to_cam;
    if (motion_.cam.turns) {
      const Vector2d p_cam(value_of(relative.p.x()), value_of(relative.p.y()));
      const Rotation<double> R{value_of(relative.R.cos), value_of(relative.R.sin)};
      to_cam = R.inverse() * Vector2d(motion_.cam.p_BO - p_cam) - p;
    } else {
      const Vector2d rise = motion_.follower.turns
                                ? perp(Vector2d(p - motion_.follower.p_BO))
                                : motion_.follower.R_WB.inverse() * motion_.follower.direction_W;
      to_cam = -motion_.follower_sign * rise;
    }
    return (n.dot(to_cam) < 0) != outer_;
  }

  CamMotion motion_;
  Curve curve_;
  bool outer_;
  double sense_ = 1;
};

// A spline through many points may have a shape between any two of them, if hardly a large one.
int parts_for(std::size_t knots) {
  return kPartsOfSpan + static_cast<int>(std::min<std::size_t>(knots, kMostParts));
}

// Between two joins of the law: over the knots of a spline curvature and its rate are continuous.
class FlankSpan final : public Span {
public:
  /// \param knots  of the law within
  FlankSpan(std::shared_ptr<const Envelope> envelope, double sense, const Bounds& joint, std::size_t knots)
      : envelope_(std::move(envelope)),
        sense_(sense),
        joint_(joint),
        low_(*envelope_->at(joint.low, LawSide::kAfter)),
        high_(*envelope_->at(joint.high, LawSide::kBefore)),
        parts_(parts_for(knots)) {}

  [[nodiscard]] SpanPoint at(double t) const override {
    const double x = sense_ * t;
    return x <= joint_.low ? low_ : x >= joint_.high ? high_ : *envelope_->at(x, LawSide::kAfter);
  }
  [[nodiscard]] Bounds range() const override {
    return sense_ > 0 ? joint_ : Bounds{-joint_.high, -joint_.low};
  }
  [[nodiscard]] int parts() const override { return parts_; }
  [[nodiscard]] FlankOrigin origin() const { return envelope_->origin(); }

private:
  std::shared_ptr<const Envelope> envelope_;
  double sense_;
  Bounds joint_;
  SpanPoint low_, high_;  // its ends, which steps along a boundary ask for again and again
  int parts_;
};

// Where the flank begins to run backwards: its speed is 0.
double cusp_before(const Envelope& envelope, double from, double to, double speed_to) {
  const auto speed = [&](double x) {
    const auto point = envelope.at(x, LawSide::kAfter);
    return point ? point->speed : std::nan("");
  };
  const auto root = root_between([&](double x) { return speed(from + x); }, speed(from), to - from, speed_to);
  return root ? from + *root : to;
}

// The first place in a stretch at which the flank runs backwards, or cannot be.
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
  if (motion.cam.turns && motion.law.end() - motion.law.begin() > 2 * kPi * (1 + kSettled)) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kTooLong, motion.law.end()});
  }
  std::vector<double> ends;
  for (const LawJoin& join : motion.law.joins()) {
    ends.push_back(join.x);
  }
  auto envelope = std::make_shared<Envelope>(motion, curve, outer);
  const double middle = (ends[0] + ends[1]) / 2;
  const auto first = envelope->at(middle, LawSide::kAfter);
  if (!first) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kNoNormal, middle});
  }
  if (!(std::abs(first->speed) > kNoMotion * first->p_B.norm())) {
    return tl::unexpected(FlankFault{FlankFault::Kind::kStandstill, middle});
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
         std::abs(motion.law.end() - motion.law.begin() - 2 * kPi) <= 1e-12;
}

}  // namespace higherpair
