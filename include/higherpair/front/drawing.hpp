#pragma once

#include "higherpair/drawing/draw.hpp"
#include "higherpair/front/model.hpp"

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Which positions of a mechanism a picture shows.
struct SceneSettings {
  std::optional<double> at;     ///< the (first) driver's position, in its unit; none: the first position
  std::optional<double> every;  ///< instead: every so much of the driver from the first to the last position
  std::vector<std::string> traces;          ///< "BODY.POINT": also these points leave traces
  bool forces = false;                      ///< with the forces of joints, contacts and drivers
  double tolerance = 1e-9;                  ///< as RunSettings::tolerance
  const std::atomic<bool>* stop = nullptr;  ///< as RunSettings::stop
};

/// The scenes of a picture.
struct Scenes {
  std::vector<Scene> scenes;  ///< at least one
  /// Where `at` cannot be reached: the limit position before it, in the driver's unit, which the scene shows.
  std::optional<double> limit;
  std::string cause;  ///< of the limit, a sentence
};

/// How a picture is drawn in these units.
[[nodiscard]] DrawSettings draw_settings(const Units& units);

/// Whether there is anything that could load the joints: masses, loads or springs.
[[nodiscard]] bool has_forces(const Mechanism& mechanism);

/// The scenes of a model. All rows of the profile's own run, thinned to a few hundred, decide how much room
/// the picture has and which paths points trace. Fails as Model::run does, where a trace names no point,
/// where forces are wanted but has_forces says no, and where `at` or `every` do not suit the drivers: several
/// are drawn at the row nearest to `at`.
[[nodiscard]] Result<Scenes> scenes_of(const Model& model, const SceneSettings& settings = {});

/// The point that "BODY.POINT" names; the error names those that are like it.
[[nodiscard]] Result<PointRef> find_point(const Model& model, const std::string& name);

}  // namespace higherpair
