#pragma once

#include "higherpair/analysis/status.hpp"
#include "higherpair/design/optimise.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/tasks.hpp"
#include "higherpair/linkage/grashof.hpp"
#include "higherpair/mechanism/description.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace higherpair {

/// The task in [design] of a profile.
struct DesignTask {
  /// A number of the profile that may be chosen, or several that are kept equal or in proportion. A design
  /// needs both bounds; one that is not given is ±infinity.
  struct Variable {
    std::string name;
    std::vector<std::string> paths;  ///< as in --set; at least one
    std::vector<double> factors;     ///< for each path: the number there is this factor times the variable
    DesignVariable range;            ///< in the unit that the number has in the profile
    std::string unit = "1";          ///< that unit as tables show it; "1" for a pure number
    Place place;
  };

  /// The path of a point is wanted to pass through given points.
  struct PointPath {
    std::string point;              ///< "coupler.E"
    PointRef ref;                   ///< the same
    std::vector<Vector2d> through;  ///< in ground [m]; at least two
    /// Each of `through` belongs to a row of the run, in order; else the point may pass it at any time.
    bool timed = false;
    std::vector<double>
        at;  ///< timed: the driver's positions in these rows, in the profile's unit; empty: all rows
    bool ordered = true;  ///< not timed: they are passed one after the other as the driver advances
    bool closed = false;  ///< ordered: any one of them may come first
    /// Whether the whole path may be displaced, rotated or scaled: then only its form counts.
    bool free_position = false, free_turn = false, free_scale = false;

    [[nodiscard]] bool is_free() const { return free_position || free_turn || free_scale; }
  };

  /// A figure of check(): "contacts.touch", "contact_pressure", and if it refers to a curve "cam.disc".
  struct Figure {
    std::string item;
    std::string quantity;
    std::string of;
  };

  /// Margin by which a four-bar is of a Grashof class [length of tables]; > 0: it is.
  struct Grashof {
    std::string wanted;  ///< "crank-rocker", …
    GrashofClass of = GrashofClass::kCrankRocker;
    int coupler = -1;  ///< index of the body; -1: that of the only four-bar
  };

  /// The smallest transmission angle over all rows: the angle between two links that a pin joins, 0 at a dead
  /// point, at most 90°.
  struct Transmission {
    std::string pin;
    int joint = 0;  ///< index into Mechanism::joints
  };

  /// The extent of the mechanism over all rows [length of tables].
  struct Extent {
    enum class Kind {
      kReach,    ///< largest distance of a point from another one
      kWidth,    ///< of the region covered by all its positions, along x of ground
      kHeight,   ///< the same along y
      kLargest,  ///< the larger of both
    };
    Kind kind = Kind::kReach;
    PointRef point, from;     ///< for kReach
    std::vector<int> bodies;  ///< for the others: the bodies that count
    std::string words;        ///< "reach of coupler.E from ground.O", "width"
  };

  /// A column is wanted to have given values where the driver has given positions.
  struct Followed {
    Measure measure;             ///< of kind kAt, at the first of these positions
    std::vector<double> at;      ///< at least one
    std::vector<double> values;  ///< wanted there, in the unit of tables
    bool change = false;         ///< only the change from the first of them on counts
  };

  /// The number of events of these types.
  struct Events {
    std::vector<EventType> types;
  };

  struct Objective {
    std::string path_of_key;  ///< "design.objectives.0"
    std::variant<Measure, Followed, PointPath, Figure, Extent> of;
    std::optional<double>
        target;         ///< of a measure, figure or extent, in the unit of tables; none: it is minimised
    double weight = 1;  ///< > 0; for a path and for a target it multiplies the square
    Place place;

    /// Null where it is of another kind.
    [[nodiscard]] const PointPath* path() const { return std::get_if<PointPath>(&of); }
    [[nodiscard]] const Followed* followed() const { return std::get_if<Followed>(&of); }
  };

  struct Constraint {
    std::string path_of_key;
    std::variant<Measure, Figure, Extent, Transmission, Grashof, Events> of;
    std::optional<double> below, above;  ///< at least one; in the unit of tables
    Place place;

    /// Null where it is of another kind.
    [[nodiscard]] const Transmission* transmission() const { return std::get_if<Transmission>(&of); }
  };

  std::vector<Variable> variables;
  std::vector<Objective> objectives;  ///< a design needs one
  std::vector<Constraint> constraints;
  DesignMethod method = DesignMethod::kAuto;
  bool keep_branch = false;  ///< only designs assembled on the branch of the profile
  std::optional<int> starts;
  std::optional<std::uint64_t> seed;
  std::optional<double> target;  ///< of the objective: the search ends when it is reached
  Place place;

  /// Those of the objectives that are paths, and of the constraints on transmission angles, in their order.
  [[nodiscard]] std::vector<const PointPath*> paths() const {
    std::vector<const PointPath*> paths;
    for (const Objective& objective : objectives) {
      if (objective.path()) paths.push_back(objective.path());
    }
    return paths;
  }
  [[nodiscard]] std::vector<const Transmission*> transmissions() const {
    std::vector<const Transmission*> transmissions;
    for (const Constraint& constraint : constraints) {
      if (constraint.transmission()) transmissions.push_back(constraint.transmission());
    }
    return transmissions;
  }
};

}  // namespace higherpair
