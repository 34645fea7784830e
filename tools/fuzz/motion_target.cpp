// Whatever can be read as a mechanism starts or says why not, and moves: its rows are finite, and those that
// count as ok close.
#include "higherpair/analysis/run.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "target.hpp"

#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace {

using namespace higherpair;

constexpr std::size_t kMostBodies = 20;
constexpr int kRows = 6;
constexpr double kStep = 0.1;  // of a driver from row to row [rad or m]

void check(const Run& run, const Reactions& reactions) {
  if (run.row.status == RowStatus::kNotAssemblable) {
    return;
  }
  bool sound = run.row.status != RowStatus::kOk || run.row.residual <= run.tolerance * run.plan.size;
  for (const BodyMotion& body : run.row.bodies) {
    sound = sound && body.X_WB.p_WB.allFinite() && std::isfinite(body.theta);
    sound =
        sound && (run.row.status != RowStatus::kOk || (std::isfinite(body.omega) && body.v_WB.allFinite()));
  }
  if (!sound || (reactions.defined && reactions.drivers.empty())) {
    std::abort();
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto profile = read_profile_text({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!profile || profile->mechanism.bodies.size() > kMostBodies) {
    return 0;
  }
  const auto schedule = DriverSchedule::analyze(*profile);
  if (!schedule) {
    return 0;
  }
  std::vector<double> starts;
  for (std::size_t i = 0; i < schedule->driver_count(); ++i) {
    starts.push_back(schedule->state(0, i).si.position);
  }
  auto run = start_run(profile->mechanism, starts);
  if (!run) {
    if (run.error().reason.empty()) {
      std::abort();
    }
    return 0;
  }
  InverseDynamics dynamics(*run);
  for (int k = 0; k < kRows; ++k) {
    std::vector<DriverMotion> drivers;
    for (const double start : starts) {
      drivers.push_back({start + kStep * k, 1, 0});
    }
    move_to(*run, drivers);
    check(*run, dynamics.solve(*run));
  }
  return 0;
}
