#include "short_motion.hpp"

#include "front/analysis_impl.hpp"
#include "higherpair/io/coordinate.hpp"

#include <cmath>
#include <cstdlib>
#include <vector>

namespace higherpair::fuzz {
namespace {

constexpr std::size_t kMostBodies = 20;

void check(const Run& run, const Row& row) {
  if (row.status == RowStatus::kNotAssemblable) {
    return;
  }
  bool sound = row.status != RowStatus::kOk || run.row.residual <= run.tolerance * run.plan().size;
  for (const BodyMotion& body : run.row.bodies) {
    sound = sound && body.X_WB.p_WB.allFinite() && std::isfinite(body.theta);
    sound = sound && (row.status != RowStatus::kOk || (std::isfinite(body.omega) && body.v_WB.allFinite()));
  }
  if (!sound) {
    std::abort();
  }
}

// The model with drivers that make a few steps from their start.
Result<Model> stepping(const Model& model, const ShortMotion& motion) {
  std::vector<DriverProgram> programs = model.profile().programs;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    DriverProgram& program = programs[i];
    const Driver& driver = model.mechanism().drivers[i];
    const Dimension dimension = coordinate_dimension(model.mechanism().joints[driver.joint]);
    const double step = from_si(dimension, model.units()).apply(motion.step);
    const double start = program.positions.empty() ? program.start : program.positions.front();
    program.positions.clear();
    for (int k = 0; k < motion.rows; ++k) {
      program.positions.push_back(start + step * k);
    }
  }
  return Model::from(model.mechanism(), model.units(), programs);
}

}  // namespace

void run_short_motion(const std::uint8_t* data, std::size_t size, const ShortMotion& motion) {
  const auto model = Model::from_text({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!model || model->mechanism().bodies.size() > kMostBodies || model->mechanism().drivers.empty()) {
    return;
  }
  RunSettings settings;
  settings.forces = motion.forces;
  auto analysis =
      stepping(*model, motion).and_then([&](const Model& steps) { return steps.start(settings); });
  if (!analysis) {
    if (to_string(analysis.error()).empty()) {
      std::abort();
    }
    return;
  }
  Row row;
  while (analysis->next(row)) {
    check(analysis->impl().run, row);
  }
}

}  // namespace higherpair::fuzz
