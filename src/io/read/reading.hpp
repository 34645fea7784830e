#pragma once

#include "higherpair/io/profile.hpp"
#include "higherpair/mechanism/description.hpp"
#include "io/document/table_reader.hpp"
#include "laws.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair::io_detail {

/// The functions that read the parts of a profile. They are called in an order in which each may refer to
/// names that an earlier one has added to the mechanism. Mistakes are collected in the Reading; an item with
/// a mistake still gets its name and index, so that references to it can be resolved.

/// \name References
/// @{
[[nodiscard]] std::optional<int> as_body(Reading& reading, const Item& item, const Mechanism& mechanism);
[[nodiscard]] std::optional<int> as_joint(Reading& reading, const Item& item, const Mechanism& mechanism);

/// A point, "body.point".
[[nodiscard]] std::optional<PointRef> as_point(Reading& reading, const Item& item,
                                               const Mechanism& mechanism);

/// A point of a body by its name alone.
[[nodiscard]] std::optional<int> as_point_of(Reading& reading, const Item& item, const Body& body);

struct PointPair {
  PointRef first;
  PointRef second;
};

struct CurvePair {
  CurveRef first;
  CurveRef second;
};

/// `between = ["body.point", "body.point"]`, on different bodies.
[[nodiscard]] std::optional<PointPair> as_point_pair(Reading& reading, const Item& item,
                                                     const Mechanism& mechanism);
/// `between = ["body.curve", "body.curve"]`, on different bodies. "body" alone means all of its curves,
/// "body.start*" those whose names begin with "start": they are added to the body as one joined curve.
[[nodiscard]] std::optional<CurvePair> as_curve_pair(Reading& reading, const Item& item,
                                                     Mechanism& mechanism);
/// @}

/// Reads the base units; a wrong one keeps its default.
void read_units(TableReader& root);

/// Curves that cannot be made before joints, contacts and laws have been read.
struct LateCurves {
  struct Flank {
    std::string body;
    std::size_t curve = 0;  ///< index in the body
    Item law;
    Item contact;
    TableReader table;
  };
  struct Offset {
    std::string body;
    std::size_t curve = 0;
    std::size_t source = 0;  ///< the curve of the same body that it is an offset of
    double by = 0;
    TableReader table;
  };
  std::vector<Flank> flanks;
  std::vector<Offset> offsets;  ///< each follows its source
};

/// Bodies with their points, curves, poses and masses; adds ground as bodies[0].
void read_bodies(TableReader& root, Mechanism& mechanism, LateCurves& late);

/// Reads `curves.NAME` of a body. A curve with a mistake becomes a circle of radius 0, which is valid
/// anywhere.
void read_curves(Reading& reading, const Item& item, Body& body, LateCurves& late);

/// Makes the flanks of cams, and their offsets.
void make_late_curves(Reading& reading, LateCurves& late, LawBook& laws, Mechanism& mechanism);

/// \return for each joint of the mechanism whether its type is known: the units of values that refer to the
/// joint depend on it.
[[nodiscard]] std::vector<bool> read_joints(TableReader& root, Mechanism& mechanism);

/// Gears or a belt whose carrier is determined once all pins are known.
struct PendingGears {
  std::size_t joint = 0;  ///< index into Mechanism::joints
  Item between;
  std::optional<Item> carrier;  ///< the key `carrier`, if given
  std::optional<Item> module;
};

/// Reads `ratio` (ω2/ω1 relative to the carrier, without sign) and `internal` of gears or `crossed` of a
/// belt.
void read_ratio(TableReader& table, Joint& joint);

/// Reads `pressure_angle` and `module` of gears, if given.
void read_teeth(TableReader& table, Joint& joint);

/// Determines the body on which both wheels are pinned, and the angle between the wheels in the poses. Gear
/// teeth on two wheels with a common centre are an error; fractional numbers of teeth are noted.
void set_carriers(Reading& reading, const std::vector<PendingGears>& pending, Mechanism& mechanism);

void read_contacts(TableReader& root, Mechanism& mechanism);

/// Loads and springs.
void read_loads(TableReader& root, Mechanism& mechanism);
void read_springs(TableReader& root, Mechanism& mechanism, const std::vector<bool>& joint_type_known);

/// How bodies, points and curves are drawn.
void read_drawing(TableReader& root, Profile& profile);

/// Reads the limits against which `check` tests the mechanism.
void read_limits(TableReader& root, Profile& profile);

/// Notes the paths that [sweep], [tolerances] and [design] vary; to be called before anything else is read.
void note_varied(const Table& document, Reading& reading);

/// Reads [sweep]. Its variables name numbers anywhere in the document, so it is read after everything else.
void read_sweep(TableReader& root, const Table& document, Profile& profile);

/// Reads [tolerances]; likewise.
void read_tolerances(TableReader& root, const Table& document, Profile& profile);

/// Reads the drivers and their motions; at least one driver is required.
void read_drivers(TableReader& root, Profile& profile, const std::vector<bool>& joint_type_known,
                  LawBook& laws);

/// Reads [design]: the variables, and the goals they are chosen for.
/// \param document  the whole profile, for paths into it
void read_design(TableReader& root, const Table& document, LawBook& laws, Profile& profile);

}  // namespace higherpair::io_detail
