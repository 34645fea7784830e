#include "contact/touch/contact_points.hpp"
#include "higherpair/contact/critical_positions.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/numeric/roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include <boost/math/tools/minima.hpp>

namespace higherpair {
namespace {

constexpr int kSamples = 256;  // of each arc

// A point of a conic by its normal on the convex side, in the body's frame.
struct Element {
  Vector2d p_B = Vector2d::Zero();
  Vector2d N_B = Vector2d::UnitX();
};

// \param S  sin² of the angle between axis and normal
Element element_of(const Curve& curve, double S, double sign_x, double sign_y) {
  const Vector2d n(sign_x * std::sqrt(std::max(0.0, 1 - S)), sign_y * std::sqrt(std::max(0.0, S)));
  Curve convex = curve;
  convex.side = Side::kInside;
  const Vector2d N_B = n.x() * curve.axis_B + n.y() * perp(curve.axis_B);
  return {support_point(place(convex, Pose<double>{}), N_B).p_W, N_B};
}

// Where the radii of curvature are equal: a segment of (S1, S2).
struct Segment {
  std::array<double, 2> S1{};
  std::array<double, 2> S2{};
};

// Largest S of points with w > 0.
double largest(const Curve& curve) {
  return curve.q > 0 ? 1 : (1 - kFarthestNormal) / (1 - curve.q);
}

// (1 - q2) S2 = 1 - c² + c² (1 - q1) S1 within [0, largest1] x [0, largest2].
std::optional<Segment> equal_radii(const Curve& first, const Curve& second) {
  const double c2 = std::pow(second.semi_latus / first.semi_latus, 2.0 / 3);
  const double a1 = c2 * (1 - first.q);
  const double a2 = 1 - second.q;
  const double b = 1 - c2;
  const std::array<double, 2> limits{largest(first), largest(second)};
  if (a1 == 0 && a2 == 0) {
    return std::nullopt;  // two circles
  }
  if (a2 == 0) {
    const double S1 = -b / a1;
    return S1 >= 0 && S1 <= limits[0] ? std::optional<Segment>({{S1, S1}, {0, limits[1]}}) : std::nullopt;
  }
  double low = 0;
  double high = limits[0];
  if (a1 == 0) {
    const double S2 = b / a2;
    return S2 >= 0 && S2 <= limits[1] ? std::optional<Segment>({{low, high}, {S2, S2}}) : std::nullopt;
  }
  low = std::max(low, -b / a1);
  high = std::min(high, (limits[1] * a2 - b) / a1);
  if (!(low < high)) {
    return std::nullopt;
  }
  const auto S2 = [&](double S1) { return std::clamp((b + a1 * S1) / a2, 0.0, limits[1]); };
  return Segment{{low, high}, {S2(low), S2(high)}};
}

// The pose at which two elements of equal curvature coincide, and how far the joints are from allowing it.
struct Fit {
  double error = 0;
  double u = 0, q = 0;
  Vector2d N_W = Vector2d::UnitX();
};

Vector2d in_frame(const Vector2d& v, const Vector2d& x_axis) {
  return {v.dot(x_axis), cross(x_axis, v)};
}

Fit fit_turning(const ContactPair& pair, const Element& one, const Element& two) {
  const Vector2d to_pivot1 = in_frame(pair.motion1.p_BO - one.p_B, one.N_B);
  const Vector2d to_pivot2 = in_frame(pair.motion2.p_BO - two.p_B, two.N_B);
  const Vector2d between = to_pivot2 - to_pivot1;
  const Vector2d between_W = pair.motion2.p_WO - pair.motion1.p_WO;
  Fit fit;
  fit.error = between.squaredNorm() - between_W.squaredNorm();
  const double angle = angle_of(between_W) - angle_of(between);
  fit.N_W = unit_vector(angle);
  fit.u = angle - angle_of(one.N_B);
  fit.q = angle - angle_of(two.N_B);
  return fit;
}

// One body turns about O, the other slides: u is the angle of the former, q the displacement of the latter.
Fit fit_mixed(const OneFreedom& turning, const Element& on_turning, const OneFreedom& sliding,
              const Element& on_sliding) {
  Fit fit;
  fit.N_W = sliding.R_WB * on_sliding.N_B;
  const Vector2d arm = in_frame(on_turning.p_B - turning.p_BO, on_turning.N_B);
  const Vector2d p_W = turning.p_WO + arm.x() * fit.N_W + arm.y() * perp(fit.N_W);
  const Vector2d offset = p_W - pose_at(sliding, 0) * on_sliding.p_B;
  fit.error = cross(sliding.direction_W, offset) * (arm.norm() + offset.norm());
  fit.u = angle_of(fit.N_W) - angle_of(on_turning.N_B);
  fit.q = offset.dot(sliding.direction_W);
  return fit;
}

Fit fit_sliding(const ContactPair& pair, const Element& one, const Element& two) {
  Fit fit;
  fit.N_W = pair.motion1.R_WB * one.N_B;
  const Vector2d N2_W = pair.motion2.R_WB * two.N_B;
  const Vector2d offset = pose_at(pair.motion2, 0) * two.p_B - pose_at(pair.motion1, 0) * one.p_B;
  const double size = offset.norm() + size_of(pair.curve1) + size_of(pair.curve2);
  // Opposite normals do not fit: the error is made to jump there instead of passing through 0.
  const double sine = cross(fit.N_W, N2_W);
  fit.error = (fit.N_W.dot(N2_W) > 0 ? sine : std::copysign(2 - std::abs(sine), sine)) * size * size;
  // p1 + u d1 = p2 + q d2
  const Vector2d& d1 = pair.motion1.direction_W;
  const Vector2d& d2 = pair.motion2.direction_W;
  fit.u = cross(offset, d2) / cross(d1, d2);
  fit.q = cross(offset, d1) / cross(d1, d2);
  return fit;
}

Fit fit_of(const ContactPair& pair, const Element& one, const Element& two) {
  if (pair.motion1.turns && pair.motion2.turns) {
    return fit_turning(pair, one, two);
  }
  if (pair.motion1.turns) {
    return fit_mixed(pair.motion1, one, pair.motion2, two);
  }
  if (pair.motion2.turns) {
    Fit fit = fit_mixed(pair.motion2, two, pair.motion1, one);
    std::swap(fit.u, fit.q);
    return fit;
  }
  return fit_sliding(pair, one, two);
}

// One of the mirror images of the segment, by an angle χ in [0, π/2] on which everything depends smoothly.
struct Arc {
  const ContactPair& pair;
  Segment segment;
  std::array<double, 4> signs;  // of N_x and N_y on curve 1, then on curve 2

  [[nodiscard]] Fit at(double chi) const {
    const double share = std::sin(chi) * std::sin(chi);
    const auto S = [&](const std::array<double, 2>& ends) { return ends[0] + share * (ends[1] - ends[0]); };
    return fit_of(pair, element_of(pair.curve1, S(segment.S1), signs[0], signs[1]),
                  element_of(pair.curve2, S(segment.S2), signs[2], signs[3]));
  }
};

// Without a change of sign the better end is the root, to within rounding.
double bracketed_root(const std::function<double(double)>& f, double low, double high) {
  const double f_low = f(low);
  const double f_high = f(high);
  const auto x = root_between([&](double distance) { return f(low + distance); }, f_low, high - low, f_high);
  return x ? low + *x : std::abs(f_low) < std::abs(f_high) ? low : high;
}

// The roots of the condition along an arc.
std::vector<double> roots_on(const Arc& arc) {
  const auto f = [&](double chi) { return arc.at(chi).error; };
  const double step = kPi / 2 / kSamples;
  std::vector<double> values;
  for (int i = 0; i <= kSamples; ++i) {
    values.push_back(f(i * step));
  }
  std::vector<double> roots;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    const double low = static_cast<double>(i) * step;
    const double a = values[i];
    const double b = values[i + 1];
    if (a * b <= 0) {
      roots.push_back(bracketed_root(f, low, low + step));
      continue;
    }
    if (i + 2 >= values.size() || values[i + 2] * b <= 0 || std::abs(b) > std::abs(a) ||
        std::abs(b) > std::abs(values[i + 2])) {
      continue;
    }
    // |f| has a minimum here, about which there may be two roots.
    const double sign = b > 0 ? 1 : -1;
    const auto [lowest, value] = boost::math::tools::brent_find_minima(
        [&](double chi) { return sign * f(chi); }, low, low + 2 * step, 40);
    if (value < 0) {
      roots.push_back(bracketed_root(f, low, lowest));
      roots.push_back(bracketed_root(f, lowest, low + 2 * step));
    }
  }
  return roots;
}

class ConformingFinder {
public:
  explicit ConformingFinder(const ContactPair& pair) : pair_(pair) {
    opposed_ = pair.curve1.side != pair.curve2.side;
    size_ = size_of_pair(pair) + std::max(size_of(pair.curve1), size_of(pair.curve2));
  }

  [[nodiscard]] std::vector<CriticalPosition> run() {
    const auto segment = equal_radii(pair_.curve1, pair_.curve2);
    for (int i = 0; segment && i < 16; ++i) {
      const auto sign = [&](int bit) { return (i >> bit & 1) != 0 ? 1.0 : -1.0; };
      const Arc arc{pair_, *segment, {sign(0), sign(1), sign(2), sign(3)}};
      // The normals of an open curve have N_x < 0.
      const bool exists =
          (pair_.curve1.q > 0 || arc.signs[0] < 0) && (pair_.curve2.q > 0 || arc.signs[2] < 0);
      if (!exists) {
        continue;
      }
      for (const double chi : roots_on(arc)) {
        add(arc.at(chi));
      }
    }
    drop_coincident();
    return found_;
  }

private:
  [[nodiscard]] bool is_same(const OneFreedom& motion, double a, double b) const {
    return coordinate_distance(motion, size_, a, b) <= kSameConforming;
  }

  void add(const Fit& fit) {
    const bool jump = std::abs(fit.error) > kConformingRoot * size_ * size_;
    if (jump || !std::isfinite(fit.u) || !std::isfinite(fit.q)) {
      return;
    }
    CriticalPosition position;
    position.type = CriticalType::kConforming;
    position.u = pair_.motion1.turns ? principal_angle(fit.u) : fit.u;
    position.q = pair_.motion2.turns ? principal_angle(fit.q) : fit.q;
    position.n_W = pair_.curve1.side == Side::kInside ? fit.N_W : Vector2d(-fit.N_W);
    const PlacedCurve<double> first = place_on(pair_.curve1, pair_.motion1, position.u);
    position.p_W = support_point(first, position.n_W).p_W;
    position.opposed = opposed_;
    // The mirror images share their edges: a root there is found more than once.
    const bool known = std::any_of(found_.begin(), found_.end(), [&](const CriticalPosition& other) {
      return is_same(pair_.motion1, position.u, other.u) &&
             (other.p_W - position.p_W).norm() <= kSameConforming * size_ &&
             (other.n_W - position.n_W).norm() <= kSameConforming;
    });
    if (!known) {
      found_.push_back(position);
    }
  }

  // Two conics have at most four such contacts at one position, unless they coincide; then one represents
  // all.
  void drop_coincident() {
    std::vector<CriticalPosition> kept;
    for (const CriticalPosition& at : found_) {
      const auto here = [&](const CriticalPosition& other) {
        return is_same(pair_.motion1, at.u, other.u) && is_same(pair_.motion2, at.q, other.q);
      };
      const bool coincide = std::count_if(found_.begin(), found_.end(), here) > 4;
      if (!coincide || std::none_of(kept.begin(), kept.end(), here)) {
        kept.push_back(at);
        kept.back().type = coincide ? CriticalType::kCrossing : at.type;
      }
    }
    found_ = std::move(kept);
  }

  const ContactPair& pair_;
  bool opposed_ = false;
  double size_ = 0;
  std::vector<CriticalPosition> found_;
};

}  // namespace

std::vector<CriticalPosition> find_conforming(const ContactPair& pair) {
  if (!is_conic(pair.curve1) || !is_conic(pair.curve2)) {
    return {};
  }
  return ConformingFinder(pair).run();
}

}  // namespace higherpair
