#include "front/analysis_impl.hpp"
#include "front/model_data.hpp"
#include "front/tolerances.hpp"
#include "higherpair/drawing/scene_maker.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"
#include "higherpair/front/pictures.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "numeric/joined_words.hpp"
#include "reach.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr std::int64_t kLeastDrawnRows = 181,
                       kMostDrawnRows = 721;  // from which a picture is laid out; paths are smooth
constexpr double kMostScenes = 200;           // of `every`

struct DrawnRows {
  std::vector<MotionRow> rows;
  std::vector<Reactions> reactions;  ///< of these rows, in a run with forces
  std::vector<double> drivers;       ///< of each row, in its unit
  std::vector<Event> faults;         ///< events that make the path bad
};

Result<DrawnRows> rows_of(const Model& model, const RunSettings& settings) {
  auto analysis = model.start(settings);
  if (!analysis) {
    return tl::unexpected(analysis.error());
  }
  DrawnRows rows;
  Row row;
  while (analysis->next(row)) {
    rows.rows.push_back(analysis->impl().run.row);
    if (const Reactions* reactions = analysis->impl().reactions) rows.reactions.push_back(*reactions);
    rows.drivers.push_back(row.values.front());
  }
  if (analysis->stopped()) {
    return wrong(model, "interrupted");
  }
  rows.faults = analysis->impl().faults_before(row.number);
  if (auto error = nothing_to_draw(model, rows.rows)) {
    return tl::unexpected(*std::move(error));
  }
  return rows;
}

// The positions with equally many more between each two of them.
std::vector<double> with_more_between(const std::vector<double>& positions, std::size_t parts) {
  std::vector<double> all = {positions.front()};
  for (std::size_t i = 1; i < positions.size(); ++i) {
    for (std::size_t k = 1; k < parts; ++k) {
      all.push_back(
          std::lerp(positions[i - 1], positions[i], static_cast<double>(k) / static_cast<double>(parts)));
    }
    all.push_back(positions[i]);
  }
  return all;
}

// As many rows as a picture needs: between a few given positions the points move on curves, not on chords.
Result<DrawnRows> rows_of_run(const Model& model, RunSettings settings) {
  const auto schedule = first_schedule(model.data());
  if (!schedule || schedule->size() < 2) {
    return rows_of(model, settings);
  }
  std::vector<DriverProgram> programs = model.profile().programs;
  const bool listed = std::all_of(programs.begin(), programs.end(), [](const DriverProgram& program) {
    return program.positions.size() > 1 && !program.law;
  });
  if (listed && schedule->size() < kLeastDrawnRows) {
    const auto parts = static_cast<std::size_t>((kLeastDrawnRows - 1) / (schedule->size() - 1)) + 1;
    for (DriverProgram& program : programs) program.positions = with_more_between(program.positions, parts);
    const auto denser = Model::from(model.mechanism(), model.units(), programs);
    if (denser) {
      if (auto rows = rows_of(*denser, settings)) return rows;
    }
  } else if (programs.front().positions.empty()) {
    settings.samples = std::clamp(schedule->size(), kLeastDrawnRows, kMostDrawnRows);
  }
  return rows_of(model, settings);
}

// "driver = 45 deg", of several drivers each by its name.
std::string caption_of(const Model& model, const MotionRow& row, const Box& view) {
  const Mechanism& mechanism = model.mechanism();
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    const Joint& joint = driven_joint(mechanism, i);
    const double size = has_angle(joint.type) ? 1 : view.size().norm() / kMillimetresPerMetre;
    const double position = joint_motion(mechanism, joint, row.bodies).position;
    const double shown = std::abs(position) < kCaptionNoise * size ? 0 : position;
    texts.push_back(fmt::format("{} = {}", driver_name(mechanism.drivers[i]),
                                with_unit(shown, driver_dimension(mechanism, i), model.units())));
  }
  return joined_words(texts);
}

Result<Scenes> scene_at(const Model& model, const RunSettings& settings, double at, SceneMaker& maker) {
  const auto reached = reach(model, settings, at);
  if (!reached) {
    return tl::unexpected(reached.error());
  }
  Scenes scenes;
  if (settings.forces) {
    InverseDynamics dynamics(reached->run);
    scenes.scenes.push_back(maker.at(reached->run.row, &dynamics.solve(reached->run)));
  } else {
    scenes.scenes.push_back(maker.at(reached->run.row));
  }
  scenes.scenes.back().caption = caption_of(model, reached->run.row, scenes.scenes.back().view);
  if (reached->limit) {
    scenes.limit = reached->limit->driver;
    scenes.cause = reached->limit->cause;
  }
  scenes.passed = reached->passed;
  return scenes;
}

Result<Scenes> scenes_every(const Model& model, RunSettings settings, double step, const DrawnRows& run,
                            SceneMaker& maker) {
  const double from = run.drivers.front(), to = run.drivers.back();
  if (model.mechanism().drivers.size() > 1) {
    return wrong(model, "pictures at every so much of the driver are for a single driver");
  }
  if (!(step > 0) || !(std::abs(to - from) / step <= kMostScenes)) {
    return wrong(model, fmt::format("every {} from {} to {}: give a step > 0 that makes at most {} pictures",
                                    step, from, to, kMostScenes));
  }
  for (double k = 0; k * step <= std::abs(to - from) * (1 + kLastScene); ++k) {
    settings.positions.push_back(from + std::copysign(k * step, to - from));
  }
  const auto rows = rows_of(model, settings);
  if (!rows) {
    return tl::unexpected(rows.error());
  }
  const std::string unit = unit_text(driver_dimension(model.mechanism()), model.units());
  Scenes scenes;
  scenes.passed = rows->faults;
  for (std::size_t i = 0; i < rows->rows.size(); ++i) {
    const Reactions* reactions = settings.forces ? &rows->reactions[i] : nullptr;
    if (has_place(rows->rows[i])) {
      scenes.scenes.push_back(maker.at(rows->rows[i], reactions));
      const double driver = std::abs(rows->drivers[i]) < kLastScene * step ? 0 : rows->drivers[i];
      scenes.scenes.back().caption = fmt::format("driver = {:.6g} {}", driver, unit);
    } else {
      scenes.left_out.push_back(rows->drivers[i]);
    }
  }
  return scenes;
}

// The point that "BODY.POINT" names; the error suggests similar names.
Result<PointRef> find_point(const Model& model, const std::string& name) {
  std::vector<std::string> names;
  const auto& bodies = model.mechanism().bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t p = 0; p < bodies[b].points.size(); ++p) {
      names.push_back(bodies[b].name + "." + bodies[b].points[p].name);
      if (names.back() == name) {
        return PointRef{static_cast<int>(b), static_cast<int>(p)};
      }
    }
  }
  return wrong(model, fmt::format("there is no point {}; {}", name, suggestion(name, names)));
}

}  // namespace

DrawSettings draw_settings(const Units& units) {
  const auto unit = [&](const Dimension& of) {
    return PictureUnit{unit_text(of, units), 1 / from_si(of, units).apply(1)};
  };
  DrawSettings settings;
  settings.length = unit(dimension::kLength);
  settings.velocity = unit(dimension::kVelocity);
  settings.acceleration = unit(dimension::kAcceleration);
  settings.force = unit(dimension::kForce);
  settings.torque = unit(dimension::kTorque);
  return settings;
}

Result<Scenes> scenes_of(const Model& model, const SceneSettings& settings) {
  std::vector<PointRef> traces;
  for (const std::string& name : settings.traces) {
    const auto point = find_point(model, name);
    if (!point) {
      return tl::unexpected(point.error());
    }
    traces.push_back(*point);
  }
  if (settings.forces && !has_forces(model.mechanism())) {
    return wrong(model, "there are no forces to draw: give bodies a mass, or add [loads] or [springs]");
  }
  RunSettings alone = driver_alone(model, settings.tolerance, settings.stop);
  alone.forces = settings.forces;
  const auto run = rows_of_run(model, alone);
  if (!run) {
    return tl::unexpected(run.error());
  }
  SceneMaker maker(model.mechanism(), run->rows, traces, run->reactions, model.profile().looks);
  if (settings.every) {
    return scenes_every(model, alone, *settings.every, *run, maker);
  }
  if (settings.at) {
    return scene_at(model, alone, *settings.at, maker);
  }
  Scenes scenes{{maker.scene()}, std::nullopt, "", {}, {}};  // of the first row with a position
  const auto first = std::find_if(run->rows.begin(), run->rows.end(), has_place);
  scenes.scenes.back().caption = caption_of(model, *first, scenes.scenes.back().view);
  return scenes;
}

}  // namespace higherpair
