#include "contact/touch/contact_points.hpp"
#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/critical_positions.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "polynomial_roots.hpp"

#include <cmath>
#include <optional>

namespace higherpair {
namespace {

// A point of curve 2 at which ∂gap/∂q is 0, and the outward normal there, in the body's frame.
struct Foot {
  Vector2d p_B = Vector2d::Zero();
  Vector2d n_B = Vector2d::UnitX();  // meaningless for a point
};

// With x = 2 ℓ s²/D, y = 2 ℓ s/D, D = 1 + q s² on the conic y² = 2 ℓ x - q x², the normal at s goes through
// (X, Y) iff  -q² Y s⁴ + (2 q (X + ℓ) - 4 ℓ) s³ + 2 (X - ℓ) s + Y = 0; s = ∞ is the far vertex.
Polynomial foot_polynomial(const Curve& curve, const Vector2d& at) {
  const Extended q = curve.q;
  const Extended l = curve.semi_latus;
  const Extended X = at.x();
  const Extended Y = at.y();
  const auto real = [](const Extended& x) { return Complex<Extended>{x, Extended(0)}; };
  return {real(Y), real(2 * (X - l)), real(Extended(0)), real(2 * q * (X + l) - 4 * l), real(-q * q * Y)};
}

// The foot at the local coordinates (x, y) from the vertex; the gradient there points out of the convex side.
Foot foot_of(const Curve& curve, double x, double y) {
  const Vector2d across_B = perp(curve.axis_B);
  const double side = curve.side == Side::kInside ? 1 : -1;
  const Vector2d gradient = (curve.q * x - curve.semi_latus) * curve.axis_B + y * across_B;
  return {curve.vertex_B + x * curve.axis_B + y * across_B, side * gradient.normalized()};
}

void add_feet(const Curve& curve, const Vector2d& pivot_B, std::vector<Foot>& feet) {
  const Vector2d from_vertex = pivot_B - curve.vertex_B;
  const Vector2d local(from_vertex.dot(curve.axis_B), cross(curve.axis_B, from_vertex));
  if (curve.kind == CurveKind::kCircle) {
    // Both ends of the diameter through the pivot.
    const Vector2d from_center(local.x() - curve.semi_latus, local.y());
    for (const double sign : {1.0, -1.0}) {
      const Vector2d at = sign * curve.semi_latus * from_center.normalized();
      feet.push_back(foot_of(curve, curve.semi_latus + at.x(), at.y()));
    }
    return;
  }
  const double size = curve.semi_latus + local.norm();
  const bool on_axis = std::abs(local.y()) <= kOnAxis * size;
  const Vector2d place(local.x(), on_axis ? 0 : local.y());
  for (const Complex<Extended>& root : roots_of(foot_polynomial(curve, place), RootsAsked::kReal)) {
    if (abs(root.im) > kSplitFoot * (1 + abs(root.re))) {
      continue;
    }
    const Extended s = root.re;
    const Extended D = 1 + Extended(curve.q) * s * s;
    if (D > 0) {  // else on the other branch of the hyperbola
      const Extended scale = 2 * Extended(curve.semi_latus) * s / D;
      feet.push_back(foot_of(curve, to_double(scale * s), to_double(scale)));
    }
  }
  if (on_axis && curve.q > 0) {
    feet.push_back(foot_of(curve, 2 * curve.semi_latus / curve.q, 0));
  }
}

std::vector<Foot> turning_feet(const Curve& curve, const Vector2d& pivot_B) {
  std::vector<Foot> feet;
  if (curve.kind == CurveKind::kPoint) {
    feet.push_back({curve.vertex_B, Vector2d::UnitX()});
  } else if (is_line(curve)) {
    feet.push_back({foot_on(curve.vertex_B, curve.axis_B, pivot_B), -curve.axis_B});
  } else {
    add_feet(curve, pivot_B, feet);
  }
  return feet;
}

std::vector<Foot> sliding_feet(const Curve& curve, const Vector2d& direction_B) {
  std::vector<Foot> feet;
  if (curve.kind == CurveKind::kPoint) {
    feet.push_back({curve.vertex_B, Vector2d::UnitX()});
  }
  if (!is_conic(curve)) {
    return feet;
  }
  const PlacedCurve<double> placed = place(curve, Pose<double>{});
  for (const double sign : {1.0, -1.0}) {
    const Vector2d n_B = sign * perp(direction_B);
    if (has_point(placed, n_B)) {
      feet.push_back({support_point(placed, n_B).p_W, n_B});
    }
  }
  return feet;
}

// The curve that replaces curve 2: a fixed circle (or point) about O2, or a fixed line along d.
std::optional<Curve> stand_in(const OneFreedom& motion, const Vector2d& foot_B, double size) {
  if (!motion.turns) {
    const auto line = make_line(pose_at(motion, 0) * foot_B, perp(motion.direction_W));
    return line ? std::optional(*line) : std::nullopt;
  }
  const double radius = (foot_B - motion.p_BO).norm();
  const auto round = radius > kOnAxis * size ? make_circle(motion.p_WO, radius) : make_point(motion.p_WO);
  return round ? std::optional(*round) : std::nullopt;
}

class FoldFinder {
public:
  explicit FoldFinder(const ContactPair& pair) : pair_(pair) {
    const OneFreedom& follower = pair.motion2;
    size_ = size_of(pair.curve2) + (anchor(pair.curve2) - follower.p_BO).norm();
  }

  [[nodiscard]] CriticalPositions run() {
    const OneFreedom& follower = pair_.motion2;
    const auto feet = follower.turns
                          ? turning_feet(pair_.curve2, follower.p_BO)
                          : sliding_feet(pair_.curve2, follower.R_WB.inverse() * follower.direction_W);
    for (const Foot& foot : feet) {
      if (const auto curve = stand_in(follower, foot.p_B, size_)) {
        add_contacts(foot, *curve);
      }
    }
    return result_;
  }

private:
  void add_contacts(const Foot& foot, const Curve& fixed) {
    const CurveContacts list = find_curve_contacts({fixed, OneFreedom{}, pair_.curve1, pair_.motion1}, 0);
    if (list.status == ContactsStatus::kTouchesEverywhere) {
      result_.everywhere = true;
    }
    for (const CurveContact& contact : list.contacts) {
      // Outward normal of curve 1; if that is a point, add() takes it from curve 2.
      const bool fixed_is_point = fixed.kind == CurveKind::kPoint;
      const Vector2d n_W = fixed_is_point || contact.opposed ? Vector2d(-contact.n_W) : contact.n_W;
      CriticalPosition at;
      at.u = contact.q;
      at.p_W = contact.p_W;
      at.n_W = n_W;
      // Where a round curve 1 coincides with its substitute, every q is a contact.
      at.type = contact.coincident ? CriticalType::kCrossing : CriticalType::kFold;
      place_follower(foot, fixed_is_point, at);
    }
  }

  void place_follower(const Foot& foot, bool at_pivot, CriticalPosition at) {
    const OneFreedom& follower = pair_.motion2;
    if (!follower.turns) {
      at.q = (at.p_W - pose_at(follower, 0) * foot.p_B).dot(follower.direction_W);
      add(foot, at);
      return;
    }
    if (!at_pivot) {
      at.q = principal_angle(angle_of(at.p_W - follower.p_WO) - angle_of(foot.p_B - follower.p_BO));
      add(foot, at);
      return;
    }
    // Curve 2 passes through its pivot, which is on curve 1: it may be tangent there in either direction.
    for (const double turn : {0.0, kPi}) {
      at.q = principal_angle(angle_of(at.n_W) - angle_of(foot.n_B) + turn);
      add(foot, at);
    }
  }

  void add(const Foot& foot, CriticalPosition at) {
    const Rotation<double> R = pair_.motion2.turns ? Rotation<double>::from_angle(at.q) : pair_.motion2.R_WB;
    const Vector2d n2_W = R * foot.n_B;
    if (pair_.curve1.kind == CurveKind::kPoint) {
      at.n_W = -n2_W;
    } else if (pair_.curve2.kind != CurveKind::kPoint) {
      at.opposed = at.n_W.dot(n2_W) < 0;
    }
    const Vector2d v1 = velocity_per_q(pair_.motion1, at.p_W);
    if (std::abs(v1.dot(at.n_W)) <= kGapQMayVanish * v1.norm()) {
      at.type = CriticalType::kCrossing;
    }
    result_.found.push_back(at);
  }

  const ContactPair& pair_;
  double size_ = 0;
  CriticalPositions result_;
};

}  // namespace

CriticalPositions find_folds(const ContactPair& pair) {
  return FoldFinder(pair).run();
}

ContactPair with_other_side(ContactPair pair) {
  Curve& curve = pair.curve2;
  if (is_line(curve)) {
    curve.axis_B = -curve.axis_B;
  } else if (is_conic(curve)) {
    curve.side = curve.side == Side::kInside ? Side::kOutside : Side::kInside;
  }
  return pair;
}

}  // namespace higherpair
