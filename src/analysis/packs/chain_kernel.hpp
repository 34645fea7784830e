#pragma once

#include "chain_group.hpp"
#include "higherpair/linkage/rpr_dyad.hpp"
#include "higherpair/linkage/rrp_dyad.hpp"
#include "higherpair/linkage/rrr_dyad.hpp"
#include "higherpair/mechanism/description.hpp"
#include "higherpair/numeric/overload.hpp"
#include "higherpair/numeric/special_values.hpp"

// The closed forms of a plan's groups for one position (T = double) or for several at once (T = Pack): the
// same kernels that a Run uses, without branches. Rates are those for a unit velocity of the driver.

namespace higherpair {

/// Which derivatives are computed.
enum class ChainRates { kNone, kVelocities, kAccelerations };

template <class T>
struct ChainPoint {
  Vector2<T> p_W, v_W, a_W;
};

template <class T>
struct ChainBody {
  Rotation<T> R_WB;
  Vector2<T> p_WB = Vector2<T>(T(0), T(0));
  Vector2<T> v_WB = Vector2<T>(T(0), T(0));
  Vector2<T> a_WB = Vector2<T>(T(0), T(0));
  T omega{0};
  T alpha{0};
  bool placed = true;  ///< false: only its rotation is needed
};

/// Extremes of a group's quantities over all positions, for the proof that its branch was not left.
template <class T>
struct ChainWatch {
  /// The largest of: |cos| of the angle between the links of an RRR dyad, or |sin| of that between link and
  /// line of an RRP dyad, above 1 where it cannot be assembled; -s² of an RPR dyad; -|∂gap/∂q| of a contact.
  T margin{-kInf};
  T sum{0};   ///< sum of these: keeps a NaN, which a maximum may lose
  T far2{0};  ///< largest squared distance of the two known points, or of a contact from its pivot

  void note(const T& value) {
    using std::max;
    margin = max(margin, value);
    sum = sum + value;
  }
};

/// The position of the driver.
template <class T>
struct ChainDriver {
  T position{0};     ///< [rad or m]
  Rotation<T> turn;  ///< rotation by the position as an angle
};

template <class T>
[[nodiscard]] inline Vector2<T> all_lanes(const Vector2d& v) {
  return Vector2<T>(T(v.x()), T(v.y()));
}

template <class T>
[[nodiscard]] inline Rotation<T> all_lanes(const Rotation<double>& R) {
  return {T(R.cos), T(R.sin)};
}

template <ChainRates kRates, class T>
[[nodiscard]] inline ChainPoint<T> chain_point(const ChainBody<T>& body, const Vector2d& p_B) {
  const Vector2<T> r = body.R_WB * all_lanes<T>(p_B);
  ChainPoint<T> point;
  point.p_W = Vector2<T>(body.p_WB.x() + r.x(), body.p_WB.y() + r.y());
  if constexpr (kRates >= ChainRates::kVelocities) {
    point.v_W = Vector2<T>(body.v_WB.x() - body.omega * r.y(), body.v_WB.y() + body.omega * r.x());
  }
  if constexpr (kRates >= ChainRates::kAccelerations) {
    const T square = body.omega * body.omega;
    point.a_W = Vector2<T>(body.a_WB.x() - body.alpha * r.y() - square * r.x(),
                           body.a_WB.y() + body.alpha * r.x() - square * r.y());
  }
  return point;
}

template <ChainRates kRates, class T>
[[nodiscard]] inline ChainPoint<T> chain_point(const ChainBody<T>* bodies, const BodyPoint& point) {
  if (point.body == kGround) {
    return {all_lanes<T>(point.p_B), Vector2<T>(T(0), T(0)), Vector2<T>(T(0), T(0))};
  }
  return chain_point<kRates>(bodies[point.body], point.p_B);
}

// Positions a body, whose rotation is known, so that its point p_B moves as `point`.
template <ChainRates kRates, class T>
inline void attach(ChainBody<T>& body, const ChainPoint<T>& point, const Vector2d& p_B) {
  if (!body.placed) {
    return;
  }
  const Vector2<T> r = body.R_WB * all_lanes<T>(Vector2d(-p_B));
  body.p_WB = Vector2<T>(point.p_W.x() + r.x(), point.p_W.y() + r.y());
  if constexpr (kRates >= ChainRates::kVelocities) {
    body.v_WB = Vector2<T>(point.v_W.x() - body.omega * r.y(), point.v_W.y() + body.omega * r.x());
  }
  if constexpr (kRates >= ChainRates::kAccelerations) {
    const T square = body.omega * body.omega;
    body.a_WB = Vector2<T>(point.a_W.x() - body.alpha * r.y() - square * r.x(),
                           point.a_W.y() + body.alpha * r.x() - square * r.y());
  }
}

template <ChainRates kRates, class T>
inline void solve_group(const DrivenBody& driven, const ChainDriver<T>& driver, ChainBody<T>* bodies) {
  const CarriedBody& carried = driven.carried;
  const OneFreedom& freedom = carried.freedom;
  ChainBody<T>& body = bodies[carried.body];
  const T sign(carried.sign);
  ChainPoint<T> joint{all_lanes<T>(freedom.p_WO), Vector2<T>(T(0), T(0)), Vector2<T>(T(0), T(0))};
  if (freedom.turns) {
    body.R_WB = {driver.turn.cos, sign * driver.turn.sin};
    body.omega = sign;
  } else {
    body.R_WB = all_lanes<T>(freedom.R_WB);
    const Vector2<T> along = all_lanes<T>(freedom.direction_W);
    const T q = sign * driver.position;
    joint.p_W = Vector2<T>(joint.p_W.x() + q * along.x(), joint.p_W.y() + q * along.y());
    joint.v_W = Vector2<T>(sign * along.x(), sign * along.y());
    body.omega = T(0);
  }
  body.alpha = T(0);
  attach<kRates>(body, joint, freedom.p_BO);
}

template <ChainRates kRates, class T>
inline void ride(const Rider& rider, const ChainPoint<T>& point, ChainBody<T>* bodies) {
  const ChainBody<T>& carrier = bodies[rider.carrier];
  ChainBody<T>& body = bodies[rider.body];
  body.R_WB = carrier.R_WB * all_lanes<T>(rider.relative);
  body.omega = carrier.omega;
  body.alpha = carrier.alpha;
  attach<kRates>(body, point, rider.p_B);
}

template <class T>
[[nodiscard]] inline CosineLine<T> all_lanes(const CosineLine<double>& line) {
  return {T(line.at_0), T(line.at_mid), T(line.at_pi), T(line.half_swing)};
}

template <ChainRates kRates, class T>
inline void solve_group(const RrrDyad& dyad, double mode, ChainBody<T>* bodies, ChainWatch<T>& watch) {
  const ChainPoint<T> A = chain_point<kRates>(bodies, dyad.A);
  const ChainPoint<T> B = chain_point<kRates>(bodies, dyad.B);
  const Vector2<T> D(B.p_W.x() - A.p_W.x(), B.p_W.y() - A.p_W.y());
  const T length_a(dyad.length_a);
  const T length_b(dyad.length_b);
  Reach<T> reach;
  if (dyad.loop) {
    const Rotation<T> arm = bodies[dyad.arm.body].R_WB * all_lanes<T>(dyad.arm.u_B);
    const Rotation<T> ground = bodies[dyad.ground.body].R_WB * all_lanes<T>(dyad.ground.u_B);
    reach = reach_at(all_lanes<T>(dyad.loop->stretch), all_lanes<T>(dyad.loop->fold), arm * ground.inverse());
  } else {
    reach = rrr_reach(D, length_a, length_b, T(0));
  }
  const RrrPosition<T> position = rrr_position(D, length_a, length_b, reach, T(mode));
  watch.note(T(1) - reach.slack() * T(0.5 / (dyad.length_a * dyad.length_b)));
  ChainBody<T>& a = bodies[dyad.link_a];
  ChainBody<T>& b = bodies[dyad.link_b];
  a.R_WB = position.u_a * all_lanes<T>(dyad.along_a.inverse());
  b.R_WB = position.u_b * all_lanes<T>(dyad.along_b.inverse());
  if constexpr (kRates >= ChainRates::kVelocities) {
    const Vector2<T> D_dot(B.v_W.x() - A.v_W.x(), B.v_W.y() - A.v_W.y());
    Vector2<T> D_ddot(T(0), T(0));
    if constexpr (kRates >= ChainRates::kAccelerations) {
      D_ddot = Vector2<T>(B.a_W.x() - A.a_W.x(), B.a_W.y() - A.a_W.y());
    }
    const RrrRates<T> rates = rrr_rates(position, length_a, length_b, D_dot, D_ddot);
    a.omega = rates.omega_a;
    b.omega = rates.omega_b;
    if constexpr (kRates >= ChainRates::kAccelerations) {
      a.alpha = rates.alpha_a;
      b.alpha = rates.alpha_b;
    }
  }
  attach<kRates>(a, A, dyad.a_pA);
  attach<kRates>(b, B, dyad.b_pB);
}

// The motion of A relative to the line: see seen_from.
template <ChainRates kRates, class T>
[[nodiscard]] inline ChainPoint<T> seen_from_line(const Rotation<T>& u, const ChainBody<T>& carrier,
                                                  const ChainPoint<T>& P, const ChainPoint<T>& A) {
  const Rotation<T> R = u.inverse();
  ChainPoint<T> seen;
  seen.p_W = R * Vector2<T>(A.p_W.x() - P.p_W.x(), A.p_W.y() - P.p_W.y());
  if constexpr (kRates >= ChainRates::kVelocities) {
    const Vector2<T> v = R * Vector2<T>(A.v_W.x() - P.v_W.x(), A.v_W.y() - P.v_W.y());
    seen.v_W = Vector2<T>(v.x() + carrier.omega * seen.p_W.y(), v.y() - carrier.omega * seen.p_W.x());
  }
  if constexpr (kRates >= ChainRates::kAccelerations) {
    const Vector2<T> a = R * Vector2<T>(A.a_W.x() - P.a_W.x(), A.a_W.y() - P.a_W.y());
    const T square = carrier.omega * carrier.omega;
    const T twice = T(2) * carrier.omega;
    seen.a_W =
        Vector2<T>(a.x() + carrier.alpha * seen.p_W.y() + square * seen.p_W.x() + twice * seen.v_W.y(),
                   a.y() - carrier.alpha * seen.p_W.x() + square * seen.p_W.y() - twice * seen.v_W.x());
  }
  return seen;
}

template <ChainRates kRates, class T>
inline void solve_group(const RrpDyad& dyad, double mode, ChainBody<T>* bodies, ChainWatch<T>& watch) {
  using std::max;
  const ChainBody<T>& carrier = bodies[dyad.line.body];
  const ChainPoint<T> A = chain_point<kRates>(bodies, dyad.A);
  const ChainPoint<T> P = chain_point<kRates>(carrier, dyad.line.p_B);
  const Rotation<T> u = carrier.R_WB * all_lanes<T>(dyad.line.u_B);
  const ChainPoint<T> seen = seen_from_line<kRates>(u, carrier, P, A);
  const T length(dyad.length);
  const Reach<T> reach{length + seen.p_W.y(), length - seen.p_W.y(), T(0)};
  const RrpPosition<T> position = rrp_position(seen.p_W.x(), length, reach, T(mode));
  watch.note(T(1) - reach.slack() * T(1 / dyad.length));
  watch.far2 = max(watch.far2, seen.p_W.x() * seen.p_W.x() + seen.p_W.y() * seen.p_W.y());
  ChainBody<T>& link = bodies[dyad.link];
  link.R_WB = u * position.u_leg * all_lanes<T>(dyad.along.inverse());
  if constexpr (kRates >= ChainRates::kVelocities) {
    const Vector2<T> a = kRates >= ChainRates::kAccelerations ? seen.a_W : Vector2<T>(T(0), T(0));
    const RrpRates<T> rates = rrp_rates(position, length, seen.v_W, a);
    link.omega = carrier.omega + rates.omega_leg;
    if constexpr (kRates >= ChainRates::kAccelerations) {
      link.alpha = carrier.alpha + rates.alpha_leg;
    }
  }
  attach<kRates>(link, A, dyad.pA);
  if (dyad.slider) {
    ride<kRates>(*dyad.slider, chain_point<kRates>(link, dyad.pC), bodies);
  }
}

template <ChainRates kRates, class T>
inline void solve_group(const RprDyad& dyad, double mode, ChainBody<T>* bodies, ChainWatch<T>& watch) {
  using std::max;
  const ChainPoint<T> A = chain_point<kRates>(bodies, dyad.A);
  const ChainPoint<T> B = chain_point<kRates>(bodies, dyad.B);
  const Vector2<T> D(B.p_W.x() - A.p_W.x(), B.p_W.y() - A.p_W.y());
  const T offset(slot_offset(dyad));
  const Reach<T> reach = rpr_reach(D, offset, T(0));
  const RprPosition<T> position = rpr_position(D, offset, reach, T(mode));
  watch.note(-reach.fold);
  watch.far2 = max(watch.far2, D.x() * D.x() + D.y() * D.y());
  ChainBody<T>& link = bodies[dyad.link];
  link.R_WB = position.u * all_lanes<T>(dyad.line.u_B.inverse());
  if constexpr (kRates >= ChainRates::kVelocities) {
    const Vector2<T> D_dot(B.v_W.x() - A.v_W.x(), B.v_W.y() - A.v_W.y());
    Vector2<T> D_ddot(T(0), T(0));
    if constexpr (kRates >= ChainRates::kAccelerations) {
      D_ddot = Vector2<T>(B.a_W.x() - A.a_W.x(), B.a_W.y() - A.a_W.y());
    }
    const RprRates<T> rates = rpr_rates(position, offset, D_dot, D_ddot);
    link.omega = rates.omega;
    if constexpr (kRates >= ChainRates::kAccelerations) {
      link.alpha = rates.alpha;
    }
  }
  attach<kRates>(link, A, dyad.pA);
  if (dyad.slider) {
    ride<kRates>(*dyad.slider, B, bodies);
  }
}

/// Places the bodies of a group. \pre the group is not an OvalContact
template <ChainRates kRates, class T>
inline void solve_group(const ChainGroup& group, double mode, const ChainDriver<T>& driver,
                        ChainBody<T>* bodies, ChainWatch<T>& watch) {
  visit_links(group, Overload{[&](const DrivenBody& driven) { solve_group<kRates>(driven, driver, bodies); },
                              [&](const auto& dyad) { solve_group<kRates>(dyad, mode, bodies, watch); }});
}

}  // namespace higherpair
