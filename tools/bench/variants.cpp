#include "variants.hpp"

#include "cases.hpp"
#include "higherpair/front/model.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/core.h>

namespace higherpair::bench {
namespace {

struct Varied {
  const char* path;
  double low, high;
};

// A [sweep] table; `columns` are three names; in degrees and the profile's length unit.
std::string sweep_text(std::span<const Varied> variables, std::span<const char* const> columns) {
  std::string text = "\n[sweep]\nmethod = \"random\"\ncount = 100000\nseed = 1\n[sweep.variables]\n";
  for (const Varied& variable : variables) {
    text += fmt::format("\"v{}\" = {{ path = \"{}\", min = {}, max = {} }}\n", &variable - variables.data(),
                        variable.path, variable.low, variable.high);
  }
  text += "[sweep.results]\n";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (const char* of : {"max", "min"}) {
      text += fmt::format("{}{} = {{ column = \"{}\", of = \"{}\" }}\n", of, i, columns[i], of);
    }
  }
  return text;
}

VariantCase variants_of(const std::string& name, std::span<const Varied> variables,
                        std::span<const char* const> columns) {
  std::ifstream file(std::string(HIGHERPAIR_PROFILES) + "/" + name + ".toml");
  std::ostringstream text;
  text << file.rdbuf() << sweep_text(variables, columns);
  const std::vector<std::string> positions{"driver.start=0",
                                           fmt::format("driver.end={}", 360.0 - 360.0 / kVariantPositions),
                                           fmt::format("driver.samples={}", kVariantPositions)};
  const auto model = Model::from_text(text.str(), name, positions);
  require(model.has_value(), model ? "" : to_string(model.error()));
  const auto sweep = Sweep::of(*model);
  require(sweep.has_value(), sweep ? "" : to_string(sweep.error()));
  return {name, *sweep};
}

constexpr Varied kFourBarVariables[] = {{"bodies.ground.points.O4.0", 0.99, 1.01},
                                        {"bodies.crank.points.A.0", 1.95, 2.05},
                                        {"bodies.coupler.points.B.0", 3.45, 3.55},
                                        {"bodies.rocker.points.B.0", 3.95, 4.05}};
constexpr const char* kFourBarColumns[] = {"rocker.angle", "rocker.omega", "coupler.E.y"};

// Columns of the block: variant, four lengths, then highest and lowest value of each result. The profile
// turns at 10 rad/s and is in centimetres; E is at (2, 1) on the coupler.
void check_four_bar_variants(const Sweep& sweep) {
  const DriverTable driver = driver_table();
  const SweepBlock block = sweep.block(0);
  const std::size_t width = sweep.columns().size();
  for (std::size_t k = 0; k < 100; ++k) {
    const double* row = &block.values[k * width];
    const ByHandResults by_hand = variant_by_hand({row[1], row[2], row[3], row[4], 2, 1}, driver, 10);
    for (std::size_t i = 0; i < 3; ++i) {
      const double unit = i < 2 ? 180 / kPi : 1;
      require(std::abs(row[5 + 2 * i] - unit * by_hand.highest[i]) <= 1e-10 &&
                  std::abs(row[6 + 2 * i] - unit * by_hand.lowest[i]) <= 1e-10,
              fmt::format("variant {} of the four-bar differs from the one by hand", k));
    }
  }
}

}  // namespace

DriverTable driver_table() {
  DriverTable table;
  for (int k = 0; k < kVariantPositions; ++k) {
    table.cosine.push_back(std::cos(2 * kPi * k / kVariantPositions));
    table.sine.push_back(std::sin(2 * kPi * k / kVariantPositions));
  }
  return table;
}

std::vector<VariantCase> checked_variants() {
  std::vector<VariantCase> cases;
  cases.push_back(variants_of("four_bar", kFourBarVariables, kFourBarColumns));
  check_four_bar_variants(cases.back().sweep);
  constexpr Varied kSlider[] = {{"bodies.crank.points.A.0", 1.9, 2.1}, {"bodies.rod.points.B.0", 4.9, 5.1}};
  constexpr const char* kSliderColumns[] = {"rod.angle", "piston.vx", "piston.x"};
  cases.push_back(variants_of("slider_crank", kSlider, kSliderColumns));
  constexpr Varied kLever[] = {{"bodies.crank.points.P.0", 38, 42}, {"bodies.ground.points.O2.1", 88, 92}};
  constexpr const char* kLeverColumns[] = {"lever.angle", "lever.omega", "lever.T.x"};
  cases.push_back(variants_of("quick_return", kLever, kLeverColumns));
  constexpr Varied kWatt[] = {{"bodies.link2.points.B.0", 39, 41},
                              {"bodies.link3.points.C.0", 98, 102},
                              {"bodies.ground.points.F.0", 275, 285}};
  constexpr const char* kWattColumns[] = {"link6.angle", "link6.omega", "link5.D.y"};
  cases.push_back(variants_of("watt_sixbar", kWatt, kWattColumns));
  constexpr Varied kLoaded[] = {{"bodies.crank.points.B.0", 39, 41},
                                {"bodies.coupler.points.C.0", 98, 102},
                                {"bodies.ground.points.F.0", 275, 285}};
  constexpr const char* kForceColumns[] = {"driver.effort", "D.fx", "F.fy"};
  cases.push_back(variants_of("watt_sixbar_forces", kLoaded, kForceColumns));
  constexpr Varied kDiscs[] = {{"bodies.cam.curves.disc.radius", 19, 21},
                               {"bodies.follower.curves.roller.center.0", -61, -59}};
  constexpr const char* kFollowerColumns[] = {"follower.angle", "follower.omega", "follower.alpha"};
  cases.push_back(variants_of("eccentric_disc_oscillating_roller", kDiscs, kFollowerColumns));
  constexpr Varied kOval[] = {{"bodies.cam.curves.oval.semi_axes.0", 29, 31},
                              {"bodies.follower.curves.roller.radius", 11, 13}};
  cases.push_back(variants_of("ellipse_cam_roller", kOval, kFollowerColumns));
  return cases;
}

}  // namespace higherpair::bench
