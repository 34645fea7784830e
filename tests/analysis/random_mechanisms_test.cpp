// Laws that every mechanism obeys, checked on random ones.
#include "analysis/random_mechanism.hpp"
#include "higherpair/analysis/run.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using namespace higherpair::testing;

constexpr unsigned kSeeds = 300;
constexpr double kReach = 0.2;  // range of the driver to either side of the poses

RandomMechanism random_mechanism(unsigned seed) {
  return RandomBuilder(seed, 4 + seed % 9).build();
}

DriverMotion at(double position) {
  return {position, 1.3, -0.7};
}

// Runs through the driver positions; returns the rows up to the first that is not ok.
std::vector<MotionRow> rows_of(const Mechanism& mechanism, double start,
                               const std::vector<double>& positions) {
  std::vector<MotionRow> rows;
  auto run = start_run(mechanism, {start});
  if (!run) {
    ADD_FAILURE() << run.error().reason;
    return rows;
  }
  for (const double position : positions) {
    move_to(*run, {at(position)});
    if (run->row.status != RowStatus::kOk) break;
    rows.push_back(run->row);
  }
  return rows;
}

std::vector<double> spaced(double from, double to, int steps) {
  std::vector<double> positions;
  for (int i = 0; i <= steps; ++i) positions.push_back(i == steps ? to : from + (to - from) * i / steps);
  return positions;
}

std::vector<double> values_of(const std::vector<BodyMotion>& bodies) {
  std::vector<double> values;
  for (const BodyMotion& body : bodies) {
    for (const double value : {body.X_WB.p_WB.x(), body.X_WB.p_WB.y(), body.theta, body.v_WB.x(),
                               body.v_WB.y(), body.omega, body.a_WB.x(), body.a_WB.y(), body.alpha}) {
      values.push_back(value);
    }
  }
  return values;
}

// Largest difference of positions and angles, of velocities and of accelerations (relative to the speed and
// its square).
double difference(const std::vector<BodyMotion>& a, const std::vector<BodyMotion>& b) {
  const std::vector<double> left = values_of(a), right = values_of(b);
  double fastest = 1;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (i % 9 >= 3 && i % 9 < 6) fastest = std::max(fastest, std::abs(left[i]));
  }
  Worst worst;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double scale = i % 9 < 3 ? 1 : i % 9 < 6 ? fastest : fastest * fastest;
    worst.see(std::abs(left[i] - right[i]) / scale);
  }
  return worst.value();
}

std::string seed_name(unsigned seed) {
  return fmt::format("seed {}", seed);
}

TEST(RandomMechanisms, StartInTheirPosesAndCloseToWithinRounding) {
  Worst pose, closure;
  std::size_t rows = 0;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const auto [mechanism, start] = random_mechanism(seed);
    const auto motion = rows_of(mechanism, start, spaced(start, start + kReach, 20));
    ASSERT_FALSE(motion.empty()) << seed_name(seed);
    std::vector<BodyMotion> posed = posed_bodies(mechanism);
    for (std::size_t i = 1; i < posed.size(); ++i) {
      const double error = (posed[i].X_WB.p_WB - motion[0].bodies[i].X_WB.p_WB).norm() +
                           angle_error(posed[i].theta, motion[0].bodies[i].theta);
      EXPECT_AT_MOST(error, 1e-12) << seed_name(seed) << " body " << i;
      pose.see(error);
    }
    for (const MotionRow& row : motion) closure.see(row.residual);
    rows += motion.size();
  }
  EXPECT_AT_MOST(pose.value(), 1e-12);
  EXPECT_AT_MOST(closure.value(), 1e-12);
  // Some reach a limit on the way, but by far the fewest.
  EXPECT_GT(rows, kSeeds * 21 * 2 / 3);
}

// Compares with central differences (sixth order) of positions over one driver coordinate u: with u' and u''
// given, v = p_u u' and a = p_uu u'² + p_u u''.
TEST(RandomMechanisms, HaveVelocitiesAndAccelerationsThatAreDerivativesOfTheirPlaces) {
  Worst velocity, acceleration;
  int compared = 0;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const auto [mechanism, start] = random_mechanism(seed);
    const double middle = start + 0.02;
    const auto row = rows_of(mechanism, start, {middle});
    if (row.empty()) continue;
    const std::vector<double> here = values_of(row[0].bodies);
    double fastest = 1;
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (i % 9 >= 3 && i % 9 < 6) fastest = std::max(fastest, std::abs(here[i]) / 1.3);
    }
    // In chains of groups positions curve more sharply than their rates suggest.
    const double h = 0.001 / fastest;
    std::vector<double> positions;
    for (int k = -3; k <= 3; ++k) positions.push_back(middle + k * h);
    const auto rows = rows_of(mechanism, start, positions);
    if (rows.size() != 7) continue;
    std::array<std::vector<double>, 7> values;
    for (std::size_t k = 0; k < 7; ++k) values[k] = values_of(rows[k].bodies);
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (i % 9 >= 3) continue;
      const auto odd = [&](std::size_t k) { return values[3 + k][i] - values[3 - k][i]; };
      const auto even = [&](std::size_t k) {
        return (values[3 + k][i] - values[3][i]) + (values[3 - k][i] - values[3][i]);
      };
      const double first = (45 * odd(1) - 9 * odd(2) + odd(3)) / (60 * h);
      const double second = (270 * even(1) - 27 * even(2) + 2 * even(3)) / (180 * h * h);
      velocity.see(std::abs(here[i + 3] - 1.3 * first) / fastest);
      acceleration.see(std::abs(here[i + 6] - (1.69 * second - 0.7 * first)) / (fastest * fastest));
    }
    ++compared;
  }
  EXPECT_GT(compared, static_cast<int>(kSeeds) * 9 / 10);
  // Rounding of 1e-15 divided by h² = 1e-6.
  EXPECT_AT_MOST(velocity.value(), 1e-9);
  EXPECT_AT_MOST(acceleration.value(), 1e-6);
}

// The same mechanism with bodies, joints and contacts in another order; `place` gives the new index of each
// body.
struct Shuffled {
  Mechanism mechanism;
  std::vector<std::size_t> place;
};

template <class T>
std::vector<T> reordered(const std::vector<T>& items, const std::vector<std::size_t>& place) {
  std::vector<T> result(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) result[place[i]] = items[i];
  return result;
}

std::vector<std::size_t> permutation(std::size_t count, std::size_t fixed, std::mt19937& engine) {
  std::vector<std::size_t> place(count);
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin() + static_cast<std::ptrdiff_t>(fixed), place.end(), engine);
  return place;
}

Shuffled shuffled(const Mechanism& mechanism, unsigned seed) {
  std::mt19937 engine(seed);
  Shuffled result{mechanism, permutation(mechanism.bodies.size(), 1, engine)};
  Mechanism& copy = result.mechanism;
  const auto move = [&](int& body) { body = static_cast<int>(result.place[body]); };
  for (Joint& joint : copy.joints) {
    move(joint.first.body);
    move(joint.second.body);
  }
  for (Contact& contact : copy.contacts) {
    move(contact.first.body);
    move(contact.second.body);
  }
  const auto joint_places = permutation(copy.joints.size(), 0, engine);
  for (Driver& driver : copy.drivers) driver.joint = static_cast<int>(joint_places[driver.joint]);
  copy.bodies = reordered(copy.bodies, result.place);
  copy.joints = reordered(copy.joints, joint_places);
  copy.contacts = reordered(copy.contacts, permutation(copy.contacts.size(), 0, engine));
  return result;
}

TEST(RandomMechanisms, GiveExactlyTheSameNumbersInAnyOrderOfTheirDescription) {
  int different = 0;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const auto [mechanism, start] = random_mechanism(seed);
    const auto positions = spaced(start, start + kReach, 7);
    const auto original = rows_of(mechanism, start, positions);
    const Shuffled copy = shuffled(mechanism, seed);
    const auto rows = rows_of(copy.mechanism, start, positions);
    ASSERT_EQ(rows.size(), original.size()) << seed_name(seed);
    bool same = true;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      same = same && values_of(reordered(original[i].bodies, copy.place)) == values_of(rows[i].bodies);
    }
    different += same ? 0 : 1;
    if (!same && different < 5) ADD_FAILURE() << seed_name(seed);
  }
  EXPECT_EQ(different, 0);
}

// p -> scale·R·M·p + shift, M the mirror at the x axis if `sense` is -1.
struct Similarity {
  double scale = 1;
  double sense = 1;
  double angle = 0;
  Vector2d shift = Vector2d::Zero();

  [[nodiscard]] Vector2d reflected(const Vector2d& v) const { return {v.x(), sense * v.y()}; }
  [[nodiscard]] Vector2d direction(const Vector2d& v) const {
    return Rotation<double>::from_angle(angle) * reflected(v);
  }
  [[nodiscard]] BodyMotion motion(const BodyMotion& body) const {
    BodyMotion image;
    image.X_WB.p_WB = scale * direction(body.X_WB.p_WB) + shift;
    image.theta = sense * body.theta + angle;
    image.v_WB = scale * direction(body.v_WB);
    image.omega = sense * body.omega;
    image.a_WB = scale * direction(body.a_WB);
    image.alpha = sense * body.alpha;
    return image;
  }
};

// The image of a mechanism: moving bodies get new poses; ground keeps its frame, and its points and lines are
// moved.
Mechanism image_of(const Mechanism& mechanism, const Similarity& map) {
  Mechanism image = mechanism;
  for (std::size_t i = 0; i < image.bodies.size(); ++i) {
    const bool ground = i == 0;
    const auto point = [&](const Vector2d& p) -> Vector2d {
      return ground ? Vector2d(map.scale * map.direction(p) + map.shift)
                    : Vector2d(map.scale * map.reflected(p));
    };
    Body& body = image.bodies[i];
    if (!ground) {
      body.guess_p_WB = map.scale * map.direction(body.guess_p_WB) + map.shift;
      body.guess_theta = map.sense * body.guess_theta + map.angle;
    }
    for (NamedPoint& named : body.points) named.p_B = point(named.p_B);
    for (NamedCurve& named : body.curves) {
      named.curve.vertex_B = point(named.curve.vertex_B);
      named.curve.axis_B = ground ? map.direction(named.curve.axis_B) : map.reflected(named.curve.axis_B);
      named.curve.semi_latus *= map.scale;
    }
  }
  for (Joint& joint : image.joints) {
    joint.direction_A =
        joint.first.body == 0 ? map.direction(joint.direction_A) : map.reflected(joint.direction_A);
    joint.relative_angle = map.sense * joint.relative_angle +
                           map.angle * ((joint.first.body == 0 ? 1 : 0) - (joint.second.body == 0 ? 1 : 0));
  }
  return image;
}

double difference_of_image(const std::vector<BodyMotion>& bodies, const std::vector<BodyMotion>& image,
                           const Similarity& map) {
  std::vector<BodyMotion> expected = bodies, found = image;
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    expected[i] = map.motion(bodies[i]);
    for (auto* body : {&expected[i], &found[i]}) {
      body->X_WB.p_WB /= map.scale;
      body->v_WB /= map.scale;
      body->a_WB /= map.scale;
    }
  }
  expected[0] = found[0] = {};
  return difference(expected, found);
}

TEST(RandomMechanisms, HaveMirroredMovedAndScaledCopiesWithTheImageOfTheirMotion) {
  Worst worst;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const auto [mechanism, start] = random_mechanism(seed);
    const auto positions = spaced(start, start + kReach, 4);
    const auto original = rows_of(mechanism, start, positions);
    Random random(seed);
    const double scale = std::pow(10, random.between(-6, 6));
    const Similarity map{scale, seed % 2 == 0 ? 1.0 : -1.0, random.angle(),
                         scale * Vector2d(random.between(-1, 1), random.between(-1, 1))};
    const Mechanism image = image_of(mechanism, map);
    const Joint& driven = mechanism.joints[mechanism.drivers[0].joint];
    const bool turns = driven.type == JointType::kRevolute;
    auto run = start_run(image, {turns ? map.sense * start + map.angle : scale * start});
    ASSERT_TRUE(run) << seed_name(seed) << run.error().reason;
    for (std::size_t i = 0; i < original.size(); ++i) {
      const double factor = turns ? map.sense : scale;
      const DriverMotion driver = at(positions[i]);
      move_to(*run, {{factor * driver.position + (turns ? map.angle : 0), factor * driver.velocity,
                      factor * driver.acceleration}});
      ASSERT_EQ(run->row.status, RowStatus::kOk) << seed_name(seed);
      const double error = difference_of_image(original[i].bodies, run->row.bodies, map);
      EXPECT_AT_MOST(error, 1e-10) << seed_name(seed) << " row " << i;
      worst.see(error);
    }
  }
  RecordProperty("worst", fmt::format("{}", worst.value()));
}

TEST(RandomMechanisms, MoveAlikeHoweverManyRowsLeadThere) {
  Worst worst;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const auto [mechanism, start] = random_mechanism(seed);
    const auto many = rows_of(mechanism, start, spaced(start, start + 3 * kReach, 500));
    const auto few = rows_of(mechanism, start, spaced(start, start + 3 * kReach, 5));
    // Rows that cannot be assembled may lie between the coarse ones, but no coarse row may be lost earlier.
    EXPECT_GE(100 * few.size(), many.size()) << seed_name(seed);
    for (std::size_t i = 0; i < few.size() && 100 * i < many.size(); ++i) {
      const double error = difference(many[100 * i].bodies, few[i].bodies);
      EXPECT_AT_MOST(error, 1e-9) << seed_name(seed) << " row " << i;
      worst.see(error);
    }
  }
  RecordProperty("worst", fmt::format("{}", worst.value()));
}

TEST(RandomMechanisms, ReturnToWhereTheyStarted) {
  unsigned returned = 0;
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    const auto [mechanism, start] = random_mechanism(seed);
    std::vector<double> positions = spaced(start, start + 2 * kReach, 3);
    for (const double back : spaced(start + 2 * kReach, start - kReach, 4)) positions.push_back(back);
    positions.push_back(start);
    const auto rows = rows_of(mechanism, start, positions);
    if (rows.size() != positions.size()) continue;
    EXPECT_AT_MOST(difference(rows.front().bodies, rows.back().bodies), 1e-10) << seed_name(seed);
    ++returned;
  }
  EXPECT_GT(returned, kSeeds / 2);
}

}  // namespace
}  // namespace higherpair
