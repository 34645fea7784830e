#pragma once

#include "higherpair/front/model.hpp"
#include "higherpair/io/tasks.hpp"

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// What is checked, and against which limits.
struct CheckSettings {
  bool in_time = false;                       ///< the motion in time, as RunSettings::in_time
  double tolerance = 1e-9;                    ///< as RunSettings::tolerance
  std::shared_ptr<const CheckLimits> limits;  ///< null: those of the profile
  const std::atomic<bool>* stop = nullptr;    ///< as RunSettings::stop
};

/// How a figure compares with its limit.
enum class Verdict {
  kNoLimit,
  kKept,
  kExceeded,
  kUndecided,  ///< it still grows (or falls) towards a singular position, beside which nothing is known
};

/// One figure by which a cam or mechanism is judged, in the profile's units: an extreme over the whole path,
/// or a dimension that would keep a limit.
struct CheckFigure {
  std::string item;             ///< "contacts.touch", "joints.guide", "cam.flank", "driver"
  std::string quantity;         ///< "pressure_angle"; docs/check.md has all
  std::string of;               ///< the curve that it refers to, "cam.flank"; empty: the item itself
  std::optional<double> value;  ///< none: unbounded
  bool by_size = false;         ///< the value is the largest by size, with its sign; limits are for its size
  std::string unit;             ///< "1" for a pure number
  std::optional<double> at;     ///< position of the (first) driver at which it is reached
  std::optional<double> limit;
  Verdict verdict = Verdict::kNoLimit;
  std::string remark;  ///< what is special about it, or empty
};

struct CheckReport {
  std::string title;
  std::string driver_unit;           ///< of CheckFigure::at
  std::vector<CheckFigure> figures;  ///< grouped by item
  std::vector<Event> events;         ///< as Motion::events: what keeps the path from being good
  /// Every limit is kept, no contact opens, and the whole path is good. False if stopped.
  bool good = true;
  bool stopped = false;  ///< stopped early: figures are missing
  Diagnostics notes;     ///< about limits that apply to nothing, and those of Analysis::notes
};

/// Computes for every contact, follower and driver the figures by which a cam is judged, and compares them
/// with the limits: pressure angles, radii of curvature, the width of flat faces, sliding and rolling speeds,
/// contact forces and Hertzian pressure, accelerations and jerks, driving efforts, the speed up to which no
/// contact opens; for flanks generated from a law also the dimensions that would keep the limits. Extremes
/// are taken over the whole path, between its rows too. Fails as Model::run does, and for limits that are not
/// finite or not as many as the mechanism has contacts, joints or bodies.
[[nodiscard]] Result<CheckReport> check(const Model& model, const CheckSettings& settings = {});

/// "exceeded", "kept", "undecided", "" as results print it.
[[nodiscard]] std::string_view name_of(Verdict verdict);

}  // namespace higherpair
