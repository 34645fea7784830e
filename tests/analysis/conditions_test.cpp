// The general form of the conditions holds at positions that were found by other means, and its Jacobian
// agrees with differences.
#include "analysis/run_testing.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/mechanism/condition_system.hpp"

#include <filesystem>
#include <numeric>
#include <random>

namespace higherpair {
namespace {

using testing::shipped;

Coordinates<double> coordinates_of(const MotionRow& row, const std::vector<double>& drivers) {
  Coordinates<double> at;
  for (const BodyMotion& body : row.bodies) {
    at.bodies.push_back({body.X_WB, body.theta});
    at.held_angles.push_back(body.theta);
  }
  for (const ContactMotion& contact : row.contacts) at.phi.push_back(contact.phi);
  at.drivers = drivers;
  return at;
}

// The arc differences that rolling contacts keep from this position on.
std::vector<double> arcs_at(const Dimensions<double>& dimensions, const Coordinates<double>& at) {
  std::vector<double> arcs;
  for (const auto& contact : dimensions.contacts) {
    arcs.push_back(arc_difference(contact, at.bodies, at.phi[arcs.size()]));
  }
  return arcs;
}

// All bodies but ground, all joints, contacts and drivers.
ConditionSet all_conditions(const Run& run) {
  const Mechanism& mechanism = run.mechanism();
  ConditionSet set;
  const auto fill = [](std::vector<int>& indices, std::size_t size, int first) {
    indices.resize(size);
    std::iota(indices.begin(), indices.end(), first);
  };
  fill(set.bodies, mechanism.bodies.size() - 1, 1);
  fill(set.joints, mechanism.joints.size(), 0);
  fill(set.contacts, mechanism.contacts.size(), 0);
  fill(set.drivers, mechanism.drivers.size(), 0);
  set.idle_bodies = run.plan().idle_bodies;
  return set;
}

// The position that differs from `at` by `change` of the unknowns.
Coordinates<double> displaced(const ConditionSystem& system, Coordinates<double> at,
                              const Eigen::VectorXd& change) {
  for (const int index : system.set().bodies) {
    BodyAt<double>& body = at.bodies[index];
    const Eigen::Vector3d step = change.segment<3>(system.body_column(index));
    body.theta += step.z() / system.size();
    body.X_WB = {Rotation<double>::from_angle(body.theta), body.X_WB.p_WB + step.head<2>()};
  }
  for (const int contact : system.set().contacts)
    at.phi[contact] += change(system.contact_column(contact)) / system.size();
  return at;
}

struct Placed {
  Dimensions<double> dimensions;
  ConditionSystem system;
  Coordinates<double> at;
};

// All conditions of a shipped profile at a row far from its start.
Placed placed(const std::string& name) {
  const Profile profile = shipped(name);
  const DriverSchedule schedule = DriverSchedule::analyze(profile).value();
  const auto drivers_at = [&](std::int64_t k) {
    std::vector<double> drivers;
    for (std::size_t i = 0; i < schedule.driver_count(); ++i)
      drivers.push_back(schedule.state(k, i).si.position);
    return drivers;
  };
  auto run = start_run(profile.mechanism, drivers_at(0)).value();
  const Dimensions<double> dimensions = dimensions_of(run.mechanism());
  const ConditionSystem system(dimensions, all_conditions(run), run.plan().size);
  const std::vector<double> arcs = arcs_at(dimensions, coordinates_of(run.row, drivers_at(0)));
  const std::vector<double> drivers = drivers_at(schedule.size() / 7);
  std::vector<DriverMotion> motions;
  for (const double driver : drivers) motions.push_back({driver, 1, 0});
  move_to(run, motions);
  EXPECT_EQ(run.row.status, RowStatus::kOk) << name;
  Coordinates<double> at = coordinates_of(run.row, drivers);
  at.arcs = arcs;
  return {dimensions, system, at};
}

// The values of the conditions without their derivatives.
Eigen::VectorXd values_at(const Placed& placed, const Coordinates<double>& at) {
  std::vector<double> values;
  EXPECT_TRUE(append_conditions(placed.dimensions, placed.system.set(), at, placed.system.size(), values));
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// The numbers of rows of joints, contacts, drivers and idle bodies, which follow each other in this order.
struct RowCounts {
  Eigen::Index joints = 0, contacts = 0, drivers = 0, idle_bodies = 0;
};

RowCounts row_counts(const Placed& placed) {
  const ConditionSet& set = placed.system.set();
  RowCounts counts{0, 0, std::ssize(set.drivers), std::ssize(set.idle_bodies)};
  for (const int joint : set.joints) {
    counts.joints += condition_count(placed.dimensions.joints[joint].of.type);
  }
  for (const int contact : set.contacts)
    counts.contacts += placed.dimensions.contacts[contact].rolling ? 3 : 2;
  return counts;
}

void expect_jacobian_of_differences(const Placed& placed, const Coordinates<double>& at) {
  const ConditionSystem& system = placed.system;
  Eigen::VectorXd values;
  Eigen::MatrixXd J;
  ASSERT_TRUE(system.evaluate(at, values, J));
  ASSERT_EQ(values.size(), system.row_count());
  const Eigen::VectorXd alone = values_at(placed, at);
  ASSERT_EQ(values.size(), alone.size());
  EXPECT_LE((values - alone).lpNorm<Eigen::Infinity>(), 1e-15 * system.size());
  const double h = 1e-6 * system.size();
  for (Eigen::Index column = 0; column < system.column_count(); ++column) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(system.column_count(), column);
    const Eigen::VectorXd difference =
        (values_at(placed, displaced(system, at, step)) - values_at(placed, displaced(system, at, -step))) /
        (2 * h);
    for (Eigen::Index row = 0; row < difference.size(); ++row) {
      EXPECT_NEAR(J(row, column), difference(row), 1e-8 * (1 + std::abs(J(row, column))))
          << "row " << row << ", column " << column;
    }
  }
  // The row of a driver is the only one that depends on its position.
  const RowCounts counts = row_counts(placed);
  Eigen::Index row = counts.joints + counts.contacts;
  for (const int driver : system.set().drivers) {
    Coordinates<double> moved = at;
    moved.drivers[driver] += 1;
    const bool turns = has_angle(placed.dimensions.joints[placed.dimensions.drivers[driver]].of.type);
    const Eigen::VectorXd expected =
        (turns ? -system.size() : -1) * Eigen::VectorXd::Unit(values.size(), row++);
    EXPECT_LE((values_at(placed, moved) - values - expected).lpNorm<Eigen::Infinity>(),
              1e-14 * (1 + system.size()));
  }
}

TEST(Conditions, HoldWhereTheRowsWereSolvedAndHaveTheJacobianOfDifferences) {
  for (const std::string& name : testing::shipped_without_boundaries()) {
    SCOPED_TRACE(name);
    const Placed row = placed(name);
    EXPECT_LE(values_at(row, row.at).lpNorm<Eigen::Infinity>(), 1e-9 * row.system.size());
    expect_jacobian_of_differences(row, row.at);
  }
}

// Away from the solution no term of the Jacobian is hidden by a gap of 0.
TEST(Conditions, HaveTheJacobianOfDifferencesBesideTheSolution) {
  for (const std::string& name : testing::shipped_without_boundaries()) {
    SCOPED_TRACE(name);
    const Placed row = placed(name);
    const ConditionSystem& system = row.system;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-0.02, 0.02);
    Eigen::VectorXd change(system.column_count());
    for (double& coordinate : change) coordinate = share(random) * system.size();
    expect_jacobian_of_differences(row, displaced(system, row.at, change));
  }
}

TEST(ConditionSystems, HaveTheRowsOfJointsContactsDriversAndIdleBodiesInThisOrder) {
  const Placed row = placed("roller_body");
  Eigen::VectorXd values, moved;
  Eigen::MatrixXd J;
  ASSERT_TRUE(row.system.evaluate(row.at, values, J));
  const RowCounts counts = row_counts(row);
  EXPECT_EQ(counts.joints, 6);  // three joints
  EXPECT_EQ(counts.contacts, 2);
  EXPECT_EQ(counts.drivers, 1);
  EXPECT_EQ(counts.idle_bodies, 1);
  ASSERT_EQ(values.size(), 10);
  // Only the rows of the contact depend on the angle of its normal, and only the last on the angle that the
  // roller keeps; that of the driver is the one before (see above).
  const auto by_phi = J.col(row.system.contact_column(0));
  EXPECT_EQ(by_phi.head(6).norm() + by_phi.tail(2).norm(), 0);
  EXPECT_GT(by_phi.segment(6, 2).norm(), 0);
  Coordinates<double> turned = row.at;
  turned.held_angles.at(row.system.set().idle_bodies.at(0)) += 1;
  ASSERT_TRUE(row.system.evaluate(turned, moved, J));
  EXPECT_EQ((moved - values).head(9).norm(), 0);
  EXPECT_NE(moved(9), values(9));
}

// In the steps of a search a rolling contact may run off along an asymptote. Beyond the normals of the
// hyperbola there are those of its other branch, with finite points but arcs of neither curve.
TEST(ContactConditions, HaveNoArcBeyondTheNormalsOfAHyperbola) {
  const CurveDimensions<double> hyperbola =
      dimensions_of(make_hyperbola(Vector2d::Zero(), {0.05, 0.04}, 0, Side::kInside).value());
  const CurveDimensions<double> circle = dimensions_of(make_circle({-0.02, 0}, 0.02, Side::kInside).value());
  const std::optional<double> held(0.0);
  for (const double off : {0.0, 0.5, 1.5, 2.0}) {
    const auto values = contact_conditions<double>(hyperbola, {}, circle, {}, kPi + off, held, 0.1);
    EXPECT_EQ(values.exist, off < std::atan(0.05 / 0.04)) << off;
    EXPECT_EQ(values.count, 3);
  }
  const auto other_branch = contact_conditions<double>(hyperbola, {}, circle, {}, kPi + 2.5, held, 0.1);
  EXPECT_FALSE(other_branch.exist);
  EXPECT_EQ(other_branch.value[2], other_branch.value[1]);
}

}  // namespace
}  // namespace higherpair
