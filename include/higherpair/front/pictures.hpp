#pragma once

#include "higherpair/drawing/picture.hpp"
#include "higherpair/front/branches.hpp"
#include "higherpair/front/model.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
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
  /// Positions of `every` that cannot be assembled and are left out, in the driver's unit.
  std::vector<double> left_out;
  /// What lies on the way to a scene and keeps the path from being good: limit positions, overlaps.
  std::vector<Event> passed;
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

/// What is plotted against what.
struct PlotSettings {
  std::vector<std::string> y;    ///< names or globs of columns, at least one
  std::optional<std::string> x;  ///< a column; none: the (first) driver, in time the time
  RunSettings run;  ///< `columns` is set from the above; `forces` and `jerk` where columns need it
};

/// Columns of a run as a plot, with its events and the rows that are not ok.
struct MotionPlot {
  PlotData data;
  bool good = false;     ///< as Motion::good
  bool stopped = false;  ///< as Motion::stopped: rows are missing
  Diagnostics notes;     ///< as Analysis::notes
};

/// Runs the model and plots columns of its table. Fails as Model::run does, for a name that no column has,
/// and for columns of words.
[[nodiscard]] Result<MotionPlot> plot_of(const Model& model, const PlotSettings& settings);

/// The configuration spaces of a map's contacts, one plot each: all branches over the driver, folds marked,
/// the mechanism's own branch emphasised. A contact without a map is left out.
[[nodiscard]] std::vector<PlotData> plots_of(const MapReport& map);

/// Which polygons of which position.
struct PolygonSettings {
  double at = 0;                            ///< position of the (first) driver, in its unit
  bool forces = false;                      ///< also the force polygon of every body
  double tolerance = 1e-9;                  ///< as RunSettings::tolerance
  const std::atomic<bool>* stop = nullptr;  ///< as RunSettings::stop
};

/// The polygons of one position, in the profile's units.
struct Polygons {
  std::vector<Polygon> polygons;  ///< of velocities, of accelerations, of the forces on each body
  double driver = 0;              ///< position that they are of, in the driver's unit
  std::string driver_unit;
  /// Where `at` cannot be reached: `driver` is the limit position before it, and this is why, a sentence.
  std::optional<std::string> limit;
  /// Else what lies on the way there and keeps the path from being good: limit positions, overlaps.
  std::vector<Event> passed;
};

/// Converts polygons from SI units to those of tables.
void to_units(std::vector<Polygon>& polygons, const Units& units);

/// The polygons where the driver, coming from its first position, is at `at`. With several drivers they are
/// of the row in which the first one is nearest to it. Fails as Model::run does.
[[nodiscard]] Result<Polygons> polygons_of(const Model& model, const PolygonSettings& settings);

/// What a report is to show.
struct ReportSettings {
  bool in_time = false;                 ///< rows in time, as RunSettings::in_time
  std::optional<std::int64_t> samples;  ///< in place of that of the profile
  double tolerance = 1e-9;              ///< largest closure error of an ok row, of the size of the mechanism
  std::int64_t most_rows = 1441;        ///< >= 2; of a longer run the page holds every n-th row and the last
  std::string source;                   ///< text of the profile, shown at the foot; empty: none
  const std::atomic<bool>* stop = nullptr;  ///< once true, the run ends and there is no page
  /// Called after every row; may be empty.
  std::function<void(std::int64_t row, std::int64_t size)> progress;
};

/// An interactive page about a run, and how the run went.
struct Report {
  std::string html;           ///< one self-contained file; asks nothing of any network; empty once stopped
  bool good = true;           ///< as Analysis::good
  bool stopped = false;       ///< by ReportSettings::stop
  std::int64_t size = 0;      ///< rows of the run
  std::int64_t every = 1;     ///< the page holds one row in so many of them, and the last
  Diagnostics notes;          ///< as Analysis::notes
  std::vector<Event> events;  ///< as Analysis::events
};

/// Runs the model once, with forces where it has masses, loads or springs, and puts what it does into a page.
/// Fails for settings that are wrong or where the page was not built in (kInput), and where the mechanism
/// cannot be started (kMechanism).
[[nodiscard]] Result<Report> report_of(const Model& model, const ReportSettings& settings = {});

}  // namespace higherpair
