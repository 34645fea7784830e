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
    const BodyAt<double>& first = at.bodies[contact.first];
    const BodyAt<double>& second = at.bodies[contact.second];
    const double phi = at.phi[arcs.size()];
    arcs.push_back(arc_difference(contact.curve1, first, contact.curve2, second,
                                  facing_points(contact.curve1, first, contact.curve2, second, phi)));
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
  const ConditionSystem system(dimensions_of(run.mechanism()), all_conditions(run), run.plan().size);
  const std::vector<double> arcs = arcs_at(system.dimensions(), coordinates_of(run.row, drivers_at(0)));
  const std::vector<double> drivers = drivers_at(schedule.size() / 7);
  std::vector<DriverMotion> motions;
  for (const double driver : drivers) motions.push_back({driver, 1, 0});
  move_to(run, motions);
  EXPECT_EQ(run.row.status, RowStatus::kOk) << name;
  Coordinates<double> at = coordinates_of(run.row, drivers);
  at.arcs = arcs;
  return {system, at};
}

void expect_jacobian_of_differences(const ConditionSystem& system, const Coordinates<double>& at) {
  Eigen::VectorXd values, alone, before, after;
  Eigen::MatrixXd J;
  ASSERT_TRUE(system.evaluate(at, values, J));
  ASSERT_TRUE(system.evaluate(at, alone));
  EXPECT_LE((values - alone).lpNorm<Eigen::Infinity>(), 1e-15 * system.size());
  const double h = 1e-6 * system.size();
  for (Eigen::Index column = 0; column < system.column_count(); ++column) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(system.column_count(), column);
    ASSERT_TRUE(system.evaluate(displaced(system, at, -step), before));
    ASSERT_TRUE(system.evaluate(displaced(system, at, step), after));
    const Eigen::VectorXd difference = (after - before) / (2 * h);
    for (Eigen::Index row = 0; row < difference.size(); ++row) {
      EXPECT_NEAR(J(row, column), difference(row), 1e-8 * (1 + std::abs(J(row, column))))
          << "row " << row << ", column " << column;
    }
  }
  for (const int driver : system.set().drivers) {
    Coordinates<double> moved = at;
    moved.drivers[driver] += 1;
    ASSERT_TRUE(system.evaluate(moved, after));
    const Eigen::VectorXd expected =
        system.by_driver(driver) * Eigen::VectorXd::Unit(values.size(), system.driver_row(driver));
    EXPECT_LE((after - values - expected).lpNorm<Eigen::Infinity>(), 1e-14 * (1 + system.size()));
  }
}

class Conditions : public ::testing::TestWithParam<std::string> {};

TEST_P(Conditions, HoldWhereTheRowsWereSolvedAndHaveTheJacobianOfDifferences) {
  const auto [system, at] = placed(GetParam());
  Eigen::VectorXd values;
  ASSERT_TRUE(system.evaluate(at, values));
  EXPECT_LE(values.lpNorm<Eigen::Infinity>(), 1e-9 * system.size());
  expect_jacobian_of_differences(system, at);
}

// Away from the solution no term of the Jacobian is hidden by a gap of 0.
TEST_P(Conditions, HaveTheJacobianOfDifferencesBesideTheSolution) {
  const auto [system, at] = placed(GetParam());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-0.02, 0.02);
  Eigen::VectorXd change(system.column_count());
  for (double& coordinate : change) coordinate = share(random) * system.size();
  expect_jacobian_of_differences(system, displaced(system, at, change));
}

INSTANTIATE_TEST_SUITE_P(OfShippedProfiles, Conditions,
                         ::testing::ValuesIn(testing::shipped_without_boundaries()),
                         [](const auto& name) { return name.param; });

TEST(ConditionSystems, LabelTheirRowsInTheOrderOfJointsContactsDriversAndIdleBodies) {
  using Of = ConditionLabel::Of;
  const auto system = placed("roller_body").system;
  std::size_t joints = 0;
  std::vector<ConditionLabel> others;
  for (const ConditionLabel& label : system.labels()) {
    if (label.of == Of::kJoint) {
      EXPECT_TRUE(others.empty());
      ++joints;
    } else {
      others.push_back(label);
    }
  }
  EXPECT_EQ(joints, 6U);  // three joints
  const int roller = system.set().idle_bodies.at(0);
  EXPECT_EQ(others, (std::vector<ConditionLabel>{
                        {Of::kContact, 0}, {Of::kContact, 0}, {Of::kDriver, 0}, {Of::kIdleBody, roller}}));
}

}  // namespace
}  // namespace higherpair
