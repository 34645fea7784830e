#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <cmath>
#include <random>
#include <string>

namespace higherpair::testing {

struct RandomPair {
  ContactPair pair;
  double u = 0;
  std::string text;
};

/// A curve of the given kind (0 … 5 in the order of CurveKind), of a size near 1 and about 2 from the origin.
inline Curve random_curve(int kind, std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const Vector2d at(between(-2, 2), between(-2, 2));
  const double rotation = between(-kPi, kPi);
  const Side side = between(0, 1) < 0.75 ? Side::kInside : Side::kOutside;
  switch (kind) {
    case 0:
      return make_circle(at, between(0.3, 3), side).value();
    case 1:
      return make_ellipse(at, {between(0.3, 3), between(0.3, 3)}, rotation, side).value();
    case 2:
      return make_parabola(at, between(0.1, 2), rotation, side).value();
    case 3:
      return make_hyperbola(at, {between(0.2, 2), between(0.2, 2)}, rotation, side).value();
    case 4:
      return make_line(at, unit_vector(rotation)).value();
    default:
      return make_point(at).value();
  }
}

/// The kinds cycle with the number, so that any 36 consecutive numbers contain every combination (two lines
/// and two points are replaced by two ellipses). In a third of the pairs, over all combinations, the follower
/// slides.
inline RandomPair random_pair(unsigned number) {
  std::mt19937 random(1000 + number);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int kind1 = static_cast<int>(number % 6);
  int kind2 = static_cast<int>(number / 6 % 6);
  if (kind1 == kind2 && kind1 >= 4) {
    kind1 = kind2 = 1;
  }
  RandomPair result;
  result.pair.curve1 = random_curve(kind1, random);
  result.pair.curve2 = random_curve(kind2, random);
  result.pair.motion1.p_WO = {between(-1, 1), between(-1, 1)};
  OneFreedom& follower = result.pair.motion2;
  follower.turns = (number + number / 6) % 3 != 2;
  follower.p_WO = {between(1, 4), between(-1, 1)};
  follower.p_BO = {between(-1, 1), between(-1, 1)};
  if (!follower.turns) {
    follower.direction_W = unit_vector(between(-kPi, kPi));
    follower.theta = between(-kPi, kPi);
    follower.R_WB = Rotation<double>::from_angle(follower.theta);
  }
  result.u = between(-kPi, kPi);
  result.text = "pair " + std::to_string(number) + ", kinds " + std::to_string(kind1) + " and " +
                std::to_string(kind2) + (follower.turns ? ", turning" : ", sliding");
  return result;
}

/// As random_pair, but with small whole numbers and quarter turns, which give many coinciding contacts,
/// tangents at infinity, coincidences and limits.
inline RandomPair grid_pair(unsigned number) {
  RandomPair result = random_pair(number);
  std::mt19937 random(50000 + number);
  const auto whole = [&](int low, int high) {
    return static_cast<double>(std::uniform_int_distribution<int>(low, high)(random));
  };
  for (Curve* curve : {&result.pair.curve1, &result.pair.curve2}) {
    const double turn = whole(0, 3);
    curve->vertex_B = {whole(-2, 2), whole(-2, 2)};
    curve->axis_B = turn < 2 ? Vector2d(1 - 2 * turn, 0) : Vector2d(0, 2 * turn - 5);
    if (is_conic(*curve)) {
      curve->semi_latus = whole(1, 4) / 2;
    }
    if (curve->kind == CurveKind::kEllipse) {
      curve->q = whole(1, 3) / 4;
    }
    if (curve->kind == CurveKind::kHyperbola) {
      curve->q = -whole(1, 3) / 2;
    }
  }
  result.pair.motion1.p_WO = {whole(-1, 1), whole(-1, 1)};
  OneFreedom& follower = result.pair.motion2;
  follower.p_WO = {whole(-2, 3), whole(-1, 1)};
  follower.p_BO = {whole(-1, 1), whole(-1, 1)};
  if (!follower.turns) {
    follower.direction_W = whole(0, 1) > 0 ? Vector2d(0, 1) : Vector2d(-0.6, 0.8);
    follower.R_WB = whole(0, 1) > 0 ? Rotation<double>{0, 1} : Rotation<double>{-1, 0};
    follower.theta = follower.R_WB.sin > 0 ? kPi / 2 : kPi;
  }
  result.u = whole(0, 3) * kPi / 2;
  return result;
}

/// As random_pair; in every fourth one the driver slides.
inline RandomPair mapped_pair(unsigned number) {
  RandomPair random = random_pair(number);
  if (number % 4 == 3) {
    OneFreedom& driver = random.pair.motion1;
    driver.turns = false;
    driver.direction_W = unit_vector(random.u);
    driver.theta = 2 * random.u;
    driver.R_WB = Rotation<double>::from_angle(driver.theta);
    random.text += ", sliding driver";
  }
  return random;
}

/// Difference of two positions of the follower: up to whole turns, or relative to 1 + |b|.
inline double follower_difference(const ContactPair& pair, double a, double b) {
  return std::abs(pair.motion2.turns ? nearest_turn(a - b, 0) : (a - b) / (1 + std::abs(b)));
}

/// The same pair with all lengths multiplied.
inline ContactPair scaled(ContactPair pair, double scale) {
  for (Curve* curve : {&pair.curve1, &pair.curve2}) {
    curve->vertex_B *= scale;
    curve->semi_latus *= scale;
  }
  for (OneFreedom* motion : {&pair.motion1, &pair.motion2}) {
    motion->p_WO *= scale;
    motion->p_BO *= scale;
  }
  return pair;
}

}  // namespace higherpair::testing
