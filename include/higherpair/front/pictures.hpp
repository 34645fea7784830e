#pragma once

#include "higherpair/drawing/picture.hpp"
#include "higherpair/front/contacts.hpp"
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
  std::optional<double> at;         ///< the (first) driver's position, in its unit; none: the first position
  std::optional<double> every;      ///< instead: positions of the driver at this spacing, from the first to
                                    ///< the last
  std::vector<std::string> traces;  ///< "BODY.POINT": further points whose paths are drawn
  bool forces = false;              ///< with the forces of joints, contacts and drivers
  double tolerance = 1e-9;          ///< as RunSettings::tolerance
  const std::atomic<bool>* stop = nullptr;  ///< as RunSettings::stop
};

/// The scenes of a picture.
struct Scenes {
  std::vector<Scene> scenes;  ///< at least one
  /// If `at` cannot be reached: the limit position before it, in the driver's unit, which the scene shows
  /// instead.
  std::optional<double> limit;
  std::string cause;  ///< of the limit, as a sentence
  /// Positions of `every` that cannot be assembled and are left out, in the driver's unit.
  std::vector<double> left_out;
  /// Events on the path to a scene that keep it from being good: limit positions, overlaps.
  std::vector<Event> passed;
};

/// Settings for a picture in these units.
[[nodiscard]] DrawSettings draw_settings(const Units& units);

/// The scenes of a model. The extent of the picture and the traces of points come from all rows of the
/// profile's own run, thinned to a few hundred. With several drivers the row nearest to `at` is drawn. Fails
/// as Model::run does, if a trace names no point, if forces are requested but has_forces() is false, if `at`
/// or `every` do not suit the drivers, and, with kInput, once stopped.
[[nodiscard]] Result<Scenes> scenes_of(const Model& model, const SceneSettings& settings = {});

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
  double driver = 0;              ///< the driver's position to which they belong, in its unit
  std::string driver_unit;
  /// If `at` cannot be reached: the reason, as a sentence; `driver` is then the limit position before it.
  std::optional<std::string> limit;
  /// Else the events on the path there that keep it from being good: limit positions, overlaps.
  std::vector<Event> passed;
};

/// The polygons where the driver, coming from its first position, is at `at`. With several drivers they are
/// those of the row in which the first driver is nearest to it. Fails as Model::run does, and, with kInput,
/// once stopped.
[[nodiscard]] Result<Polygons> polygons_of(const Model& model, const PolygonSettings& settings);

/// What a report shows.
struct ReportSettings {
  bool in_time = false;                 ///< rows in time, as RunSettings::in_time
  std::optional<std::int64_t> samples;  ///< instead of that of the profile
  double tolerance = 1e-9;              ///< largest closure error of an ok row, relative to the size of
                                        ///< the mechanism
  std::int64_t most_rows = 1441;        ///< >= 2; of a longer run the page holds every n-th row and the last
  std::string source;                   ///< text of the profile, shown at the foot; empty: none
  const std::atomic<bool>* stop = nullptr;  ///< once true, the run ends and there is no page
  /// Called after every row; may be empty.
  std::function<void(std::int64_t row, std::int64_t size)> progress;
};

/// An interactive page about a run, and how the run went.
struct Report {
  std::string html;           ///< one self-contained file that needs no network; empty if stopped
  bool good = true;           ///< as Analysis::good
  bool stopped = false;       ///< by ReportSettings::stop
  std::int64_t size = 0;      ///< rows of the run
  std::int64_t every = 1;     ///< the page holds one of this many rows, and the last
  Diagnostics notes;          ///< as Analysis::notes
  std::vector<Event> events;  ///< as Analysis::events
};

/// Runs the model once, with forces if it has masses, loads or springs, and makes a page of the result. Fails
/// for invalid settings or in a build without the page (kInput), and if the mechanism cannot be started
/// (kMechanism).
[[nodiscard]] Result<Report> report_of(const Model& model, const ReportSettings& settings = {});

}  // namespace higherpair
