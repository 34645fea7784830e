#include "trial.hpp"

#include "contact/contact_laws.hpp"
#include "contact/differences.hpp"
#include "contact/pair_follower.hpp"
#include "front/analysis_impl.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "round_numbers.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::fire {
namespace {

using testing::Difference;

bool finite(const ContactPosition& at) {
  return std::isfinite(at.q) && std::isfinite(at.dq) && std::isfinite(at.d2q) && std::isfinite(at.dphi) &&
         std::isfinite(at.sliding);
}

// Tests a contact position. \param at_limit  rates are not defined there
Failure laws(const ContactPair& pair, const ContactPosition& at, int row, bool at_limit = false) {
  if (!finite(at)) {
    return {"finite numbers", "", row};
  }
  const testing::ContactLaws held(pair, at);
  for (const std::string& broken : held.broken) {
    const std::size_t colon = broken.find(':');
    // If the curves nearly conform, rates are as uncertain as κ1 + κ2, whose relative error is 1e-16 κ/(κ1 +
    // κ2).
    const bool rate = broken.starts_with("acceleration") || broken.starts_with("velocity");
    if (!rate || (!at_limit && std::abs(held.conforming_) > 1e-4L)) {
      return {broken.substr(0, colon), broken, row};
    }
  }
  return {};
}

// The relative error of a difference that is due to rounding of the driver positions u ± h/4.
double position_noise(double u, double h) {
  return 1e-8 + 4e-15 * std::abs(u / h);
}

// Tests a rate against a difference; passes if the difference is itself too uncertain. `noise` is relative.
Failure compare(const char* law, double rate, const Difference& difference, double noise, double rounding,
                int row) {
  if (!(difference.error < 1e-4 * std::abs(difference.value))) {
    return {};
  }
  // Close to a limit the series in h² converges slowly, and its error is of the order of the last step.
  const double tolerance = 4 * difference.error + noise * std::abs(difference.value) + rounding;
  if (std::abs(rate - difference.value) <= tolerance) {
    return {};
  }
  return {law, fmt::format("{} but a difference gives {} ± {}", rate, difference.value, tolerance), row};
}

// The effect of rounding of the pair's numbers on q and dq. A gap of rounding size changes q by it divided by
// ∂gap/∂q, and dq by d²q/dq per unit of q. An angle moves the contact point along the curves by z, and so
// changes both levers in dq = (n·v1)/(n·v2).
struct Doubt {
  double q = 0;
  double dq = 0;
};

Doubt doubt_of(const ContactPair& pair, const ContactPosition& at) {
  constexpr double kRounding = 1e-15;
  const double length = testing::length_scale(pair, at);
  const double turns1 = pair.motion1.turns ? 1 : 0;
  const double turns2 = pair.motion2.turns ? 1 : 0;
  const double per_gap = 1 / std::abs(at.gap_q);
  const bool face = pair.curve1.kind == CurveKind::kLine || pair.curve2.kind == CurveKind::kLine;
  const double z = face ? at.rho1 + at.rho2 : at.rho1 * at.rho2 / (at.rho1 + at.rho2);
  const double angles = 1 + turns1 * std::abs(at.u) + turns2 * std::abs(at.q);
  const double along = length + std::abs(z) * angles;
  const double lever = velocity_per_q(pair.motion2, at.p2_W).norm() + turns2 * length;
  Doubt doubt;
  doubt.q = kRounding * (std::abs(at.q) + length * per_gap);
  doubt.dq = kRounding * per_gap * (along * std::abs(turns1 - at.dq * turns2) + lever * std::abs(at.dq)) +
             (at.d2q == 0 ? 0 : std::abs(at.d2q / at.dq) * doubt.q);
  return doubt;
}

Failure rates_over(const FollowedContact& track, double h, int row) {
  const auto beside = [&](auto of) {
    return [&track, of](double offset) -> std::optional<double> {
      FollowedContact moved = track;
      if (follow_to(moved, track.at.u + offset).status != TrackStatus::kOk) {
        return std::nullopt;
      }
      return of(moved.at);
    };
  };
  const ContactPosition& at = track.at;
  const double noise = position_noise(at.u, h);
  const auto q_of = [](const ContactPosition& place) { return place.q; };
  const auto dq_of = [](const ContactPosition& place) { return place.dq; };
  const double unit = track.pair.motion2.turns ? 1 : testing::length_scale(track.pair, at);
  const double u_unit = track.pair.motion1.turns ? 1 : testing::length_scale(track.pair, at);
  const Doubt doubt = doubt_of(track.pair, at);
  const double rounding = (1e-13 * (std::abs(at.q) + unit) + doubt.q) / std::abs(h);
  if (auto f = compare("dq", at.dq, testing::difference(h, beside(q_of)), noise, rounding, row)) {
    return f;
  }
  const double second = (1e-12 * std::abs(at.dq) + doubt.dq) / std::abs(h) + rounding / u_unit;
  return compare("d2q", at.d2q, testing::difference(h, beside(dq_of)), noise, second, row);
}

// The motion may change within less than h, which a difference does not notice. Rates that are really wrong
// differ from narrower differences as well.
Failure rates(const FollowedContact& track, double h, int row) {
  const Failure wide = rates_over(track, h, row);
  return wide && rates_over(track, h / 8, row) ? rates_over(track, h / 64, row) : Failure{};
}

Failure track_pair(const Case& one, const ContactPair& pair, Counts& counts) {
  const FindResult found = find_nearest_contact(pair, one.u, one.q);
  // Without a branch there is nothing to follow: two contacts merge here, possibly at every driver position.
  if (found.status != FindStatus::kFound || found.branch == 0) {
    return {};
  }
  ++counts.found;
  if (auto f = laws(pair, found.at, 0)) {
    return f;
  }
  FollowedContact track = start_track(pair, found.at, found.branch);
  int lost = 0;  // consecutive rows; each further one takes a new search, so only some are tried
  for (int k = 1; k <= one.rows; ++k) {
    if (lost > 2 && k % 8 != 0 && k != one.rows) {
      continue;
    }
    ++counts.rows;
    const TrackResult followed = follow_to(track, one.u + k * one.step);
    if (followed.status != TrackStatus::kOk) {
      ++counts.flagged;
      ++lost;
      continue;
    }
    lost = 0;
    const bool at_limit = followed.limit && track.at.gap_q == 0;
    if (auto f = laws(pair, track.at, k, at_limit)) {
      return f;
    }
    if (at_limit) {
      ++counts.flagged;
      continue;
    }
    if (track.branch * track.at.gap_q < 0) {
      return {"branch", fmt::format("gap_q = {}", track.at.gap_q), k};
    }
    if (k % 10 == 0 || one.rows < 10) {
      ++counts.compared;
      if (auto f = rates(track, 0.03 * one.step, k)) {
        return f;
      }
    }
  }
  return {};
}

// Both points of a joint coincide and move alike; in a slide or slot only across its line.
Failure joint_laws(const Mechanism& m, const Joint& joint, const MotionRow& row, int k) {
  const BodyMotion& A = row.bodies[joint.first.body];
  const PointMotion a = point_motion(A, point_of(m, joint.first));
  const PointMotion b = point_motion(row.bodies[joint.second.body], point_of(m, joint.second));
  const double length = a.p_W.norm() + b.p_W.norm() + point_of(m, joint.first).norm() +
                        point_of(m, joint.second).norm() + A.X_WB.p_WB.norm();
  Vector2d error = b.p_W - a.p_W;
  Vector2d v = b.v_W - a.v_W;
  if (joint.type != JointType::kRevolute) {
    const Vector2d across = A.X_WB.R_WB * perp(joint.direction_A);
    error = across * across.dot(error);
    v = across * (across.dot(v) - A.omega * (A.X_WB.R_WB * joint.direction_A).dot(b.p_W - a.p_W));
  }
  if (!(error.norm() <= 1e-12 * length)) {
    return {"joint " + joint.name + " closed", fmt::format("{} of {}", error.norm(), length), k};
  }
  const double speed = a.v_W.norm() + b.v_W.norm() +
                       (std::abs(A.omega) + std::abs(row.bodies[joint.second.body].omega)) * length;
  if (!(v.norm() <= 1e-10 * speed)) {
    return {"velocity of joint " + joint.name, fmt::format("{} of {}", v.norm(), speed), k};
  }
  return {};
}

testing::Standing stand(const Mechanism& m, const CurveRef& at, const MotionRow& row) {
  const Body& owner = m.bodies[at.body];
  const BodyMotion& motion = row.bodies[at.body];
  OneFreedom fixed;
  fixed.turns = false;
  fixed.p_WO = motion.X_WB.p_WB;
  fixed.theta = motion.theta;
  return {owner.curves[at.curve].curve, fixed, 0};
}

// The contact point is on both curves, and both bodies have the same normal velocity there.
Failure contact_laws(const Mechanism& m, const MotionRow& row, double size, int k) {
  const Contact& contact = m.contacts.front();
  const CommonNormal& at = row.contacts.front().at;
  const auto one = stand(m, contact.first, row);
  const auto two = stand(m, contact.second, row);
  const double length = size + at.p1_W.norm() + one.curve.vertex_B.norm() + two.curve.vertex_B.norm() +
                        one.freedom.p_WO.norm() + two.freedom.p_WO.norm();
  const auto d1 = one.shape_at(testing::wide(at.p1_W)).distance;
  const auto d2 = two.shape_at(testing::wide(at.p2_W)).distance;
  const double gap = (at.p2_W - at.p1_W).norm();
  if (!(std::abs(d1) <= 1e-12L * length) || !(std::abs(d2) <= 1e-12L * length) || !(gap <= 1e-11 * length)) {
    return {"contact of the run", fmt::format("{} {} {} of {}", double(d1), double(d2), gap, length), k};
  }
  const auto speed = [&](const CurveRef& ref) {
    const BodyMotion& B = row.bodies[ref.body];
    return Vector2d(B.v_WB + B.omega * perp(Vector2d(at.p1_W - B.X_WB.p_WB)));
  };
  const Vector2d v1 = speed(contact.first);
  const Vector2d v2 = speed(contact.second);
  const double arms =
      (std::abs(row.bodies[contact.first.body].omega) + std::abs(row.bodies[contact.second.body].omega)) *
      length;
  if (!(std::abs(at.n_W.dot(v2 - v1)) <= 1e-10 * (v1.norm() + v2.norm()) + 1e-12 * arms)) {
    return {"normal speeds of the run", fmt::format("{} {}", at.n_W.dot(v1), at.n_W.dot(v2)), k};
  }
  return {};
}

Failure row_laws(const Run& run, int k) {
  for (const Joint& joint : run.mechanism().joints) {
    if (auto f = joint_laws(run.mechanism(), joint, run.row, k)) {
      return f;
    }
  }
  return contact_laws(run.mechanism(), run.row, run.plan().size, k);
}

// A difference for an unknown distance from a limit: other half-widths show the errors due to the limit and
// to rounding.
template <class At>
Difference steady_difference(double h, const At& at) {
  Difference best = testing::difference(h, at);
  for (const double share : {0.7, 0.45}) {
    const Difference other = testing::difference(share * h, at);
    best.error = std::max({best.error, other.error, 2 * std::abs(other.value - best.value)});
  }
  return best;
}

// Tests the angular rates of every body against differences of the run.
Failure run_rates(const Run& run, const DriverMotion& driver, double h, int k) {
  const double noise = position_noise(driver.position, h);
  for (std::size_t i = 1; i < run.row.bodies.size(); ++i) {
    const auto beside = [&](bool second) {
      return [&, second](double offset) -> std::optional<double> {
        Run moved = run;
        move_to(moved, {{driver.position + offset, driver.velocity, 0}});
        if (moved.row.status != RowStatus::kOk) {
          return std::nullopt;
        }
        return second ? moved.row.bodies[i].omega : moved.row.bodies[i].theta;
      };
    };
    const BodyMotion& B = run.row.bodies[i];
    const std::string& name = run.mechanism().bodies[i].name;
    const double rounding = 1e-13 * (1 + std::abs(B.theta)) / std::abs(h);
    if (auto f = compare("omega", B.omega, steady_difference(h, beside(false)), noise, rounding, k)) {
      f.detail = name + ": " + f.detail;
      return f;
    }
    const double second = 1e-12 * std::abs(B.omega) / std::abs(h) + rounding;
    if (auto f = compare("alpha", B.alpha, steady_difference(h, beside(true)), noise, second, k)) {
      f.detail = name + ": " + f.detail;
      return f;
    }
  }
  return {};
}

Failure run_profile(const Case& one, Counts& counts) {
  const auto model = Model::from_text(profile_of(one, "case"), "case");
  if (!model) {
    ++counts.refused;  // for good reason: the reader has tests of its own
    return {};
  }
  RunSettings settings;
  settings.columns = {"driver", "driver.velocity"};
  settings.units = kSiUnits;
  auto analysis = model->start(settings);
  if (!analysis) {
    return {};
  }
  ++counts.runs;
  Row row;
  while (analysis->next(row)) {
    ++counts.rows;
    if (row.status != RowStatus::kOk) {
      ++counts.flagged;
      continue;
    }
    const Run& run = analysis->impl().run;
    const int number = static_cast<int>(row.number);
    if (auto f = row_laws(run, number)) {
      return f;
    }
    if (one.crank && (number % 20 == 10 || one.rows < 10)) {
      ++counts.compared;
      if (auto f = run_rates(run, {row.values[0], row.values[1], 0}, 0.03 * one.step, number)) {
        return f;
      }
    }
  }
  return {};
}

}  // namespace

Counts& Counts::operator+=(const Counts& other) {
  cases += other.cases;
  found += other.found;
  rows += other.rows;
  flagged += other.flagged;
  compared += other.compared;
  runs += other.runs;
  refused += other.refused;
  failed += other.failed;
  return *this;
}

Trial try_case(const Case& one, Depth depth) {
  Trial trial;
  ++trial.counts.cases;
  const auto pair = pair_of(one);
  if (!pair) {
    return trial;
  }
  trial.failure = track_pair(one, *pair, trial.counts);
  if (!trial.failure && depth == Depth::kWhole) {
    trial.failure = run_profile(one, trial.counts);
  }
  trial.counts.failed += trial.failure ? 1 : 0;
  return trial;
}

Case shrink(Case one, const std::string& law, Depth depth) {
  const auto keep = [&](const Case& smaller) {
    if (try_case(smaller, depth).failure.law != law) {
      return false;
    }
    one = smaller;
    return true;
  };
  for (int rows = 1; rows < one.rows; rows *= 2) {
    Case smaller = one;
    smaller.rows = rows;
    if (keep(smaller)) {
      break;
    }
  }
  Case smaller = one;
  smaller.crank.reset();
  keep(smaller);
  round_numbers(one, 12, keep);
  return one;
}

}  // namespace higherpair::fire
