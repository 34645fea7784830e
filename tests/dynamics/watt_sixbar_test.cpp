// The reactions of the Watt six-bar at all seven pins and its driving torque, in three load cases and both
// fully turning assemblies, against an independent solution in extended precision.
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace higherpair {
namespace {

struct LoadCase {
  const char* key;
  std::vector<std::string> overrides;
};

const LoadCase kCases[] = {
    {"printed_loads_T6_20Nm", {}},
    {"printed_loads_T6_0.02Nm", {"loads.twist.torque=\"0.02 N m\""}},
    {"no_external_load",
     {"loads.on_coupler.force=[0, 0]", "loads.on_triangle.force=[0, 0]", "loads.on_rocker.force=[0, 0]",
      "loads.twist.torque=0"}},
};

double number(const nlohmann::json& text) {
  return std::stod(text.get<std::string>());
}

// The poses of the first row, which select the assembly.
std::vector<std::string> poses(const nlohmann::json& row) {
  const auto pose = [](const std::string& body, double x, double y, double angle) {
    const std::string key = "bodies." + body + ".pose.";
    return std::vector<std::string>{key + "x=" + std::to_string(1000 * x),
                                    key + "y=" + std::to_string(1000 * y),
                                    key + "angle=" + std::to_string(180 / kPi * angle)};
  };
  std::vector<std::string> all;
  const double x = number(row.at("D").at(0)), y = number(row.at("D").at(1));
  for (const auto& part :
       {pose("link", x, y, number(row.at("theta5"))), pose("rocker", x, y, number(row.at("theta6")))}) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

double largest_error(Run& run, InverseDynamics& dynamics, const nlohmann::json& row,
                     const nlohmann::json& expected) {
  move_to(run, {{row.at("theta2_deg").get<double>() * kPi / 180, 1, 0}});
  const Reactions& reactions = dynamics.solve(run);
  EXPECT_TRUE(reactions.defined);
  double error = 0;
  double largest = 0;
  for (std::size_t i = 0; i < run.mechanism().joints.size(); ++i) {
    const nlohmann::json& pin = expected.at(run.mechanism().joints[i].name);
    const double fx = number(pin.at(0)), fy = number(pin.at(1));
    largest = std::max({largest, std::abs(fx), std::abs(fy)});
    error = std::max({error, std::abs(reactions.joints[i].fx.value() - fx),
                      std::abs(reactions.joints[i].fy.value() - fy)});
  }
  const double torque = number(expected.at("T2"));
  // A torque counts as a force at a lever of one metre, which is stricter than at the crank's length.
  error = std::max(error, std::abs(reactions.drivers[0].effort.value() - torque));
  error = std::max(error, std::abs(reactions.drivers[0].by_power.value() - torque));
  return error / largest;
}

TEST(WattSixbar, HasTheReactionsOfTheReferenceInEveryRow) {
  for (const int assembly : {0, 1}) {
    SCOPED_TRACE(assembly);
    std::ifstream file(HIGHERPAIR_TEST_DATA "/watt_sixbar.json");
    const nlohmann::json data = nlohmann::json::parse(file);
    const nlohmann::json& branch = data.at("branches").at(static_cast<std::size_t>(assembly));
    ASSERT_TRUE(branch.at("full_rotation").get<bool>());
    const nlohmann::json& rows = branch.at("rows");
    ASSERT_EQ(rows.size(), 37U);
    for (const LoadCase& load : kCases) {
      std::vector<std::string> overrides = poses(rows.at(0));
      overrides.insert(overrides.end(), load.overrides.begin(), load.overrides.end());
      const auto profile =
          read_profile_file(HIGHERPAIR_SOURCE_DIR "/profiles/watt_sixbar_forces.toml", overrides);
      ASSERT_TRUE(profile) << to_string(profile.error().front());
      higherpair::Run run = start_run(profile->mechanism, {135 * kPi / 180}).value();
      InverseDynamics dynamics(run);
      for (const nlohmann::json& row : rows) {
        // The reference has 18 digits; the least favourable transmission angle costs two or three of a
        // double's 16.
        EXPECT_LE(largest_error(run, dynamics, row, row.at(load.key)), 1e-12)
            << load.key << " at " << row.at("theta2_deg");
      }
    }
  }
}

}  // namespace
}  // namespace higherpair
