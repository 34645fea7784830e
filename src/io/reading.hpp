#pragma once

#include "higherpair/io/profile.hpp"
#include "higherpair/mechanism/description.hpp"
#include "laws.hpp"
#include "table_reader.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair::io_detail {

/// The parts of a profile, each read by its own function and in this order: every one may refer to names that
/// an earlier one has put into the mechanism. Mistakes go to the reading; a thing with a mistake in it still
/// gets its name and place, so that references to it are understood.

/// \name References
/// @{
[[nodiscard]] std::optional<int> as_body(Reading& reading, const Item& item, const Mechanism& mechanism);
[[nodiscard]] std::optional<int> as_joint(Reading& reading, const Item& item, const Mechanism& mechanism);

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
/// `between = ["body.curve", "body.curve"]`, on different bodies. "body" alone is all of its curves,
/// "body.start*" those whose names begin so: they are added to the body as one.
[[nodiscard]] std::optional<CurvePair> as_curve_pair(Reading& reading, const Item& item,
                                                     Mechanism& mechanism);
/// @}

/// The base units; kept at their defaults where they are wrong.
void read_units(TableReader& root);

/// Curves that cannot be made before joints, contacts and laws are known.
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
    TableReader table;
  };
  std::vector<Flank> flanks;
  std::vector<Offset> offsets;  ///< each after its source
};

/// Bodies with their points, curves, poses and masses; adds ground as bodies[0].
void read_bodies(TableReader& root, Mechanism& mechanism, LateCurves& late);

/// `curves.NAME` of a body. One with a mistake becomes a circle of radius 0, which fits everywhere.
void read_curves(Reading& reading, const Item& item, Body& body, LateCurves& late);

/// Makes the flanks of cams, and their offsets.
void make_late_curves(Reading& reading, LateCurves& late, LawBook& laws, Mechanism& mechanism);

/// \return for each joint of the mechanism whether its type is known: units of what refers to it depend on
/// it.
[[nodiscard]] std::vector<bool> read_joints(TableReader& root, Mechanism& mechanism);

/// Gears or a belt whose carrier is found when all pins are known.
struct PendingGears {
  std::size_t joint = 0;  ///< index into Mechanism::joints
  Item between;
  std::optional<Item> carrier;  ///< the key, if it is there
  std::optional<Item> module;
};

/// `ratio` (ω2/ω1 relative to the carrier, without sign) and `internal` of gears or `crossed` of a belt.
void read_ratio(TableReader& table, Joint& joint);

/// `pressure_angle` and `module` of gears, if they are there.
void read_teeth(TableReader& table, Joint& joint);

/// The body on which both wheels are pinned, and the angle between them from the poses. Teeth of wheels with
/// one centre are an error, parts of teeth are noted.
void set_carriers(Reading& reading, const std::vector<PendingGears>& pending, Mechanism& mechanism);

void read_contacts(TableReader& root, Mechanism& mechanism);

/// Loads and springs.
void read_loads(TableReader& root, Mechanism& mechanism);
void read_springs(TableReader& root, Mechanism& mechanism, const std::vector<bool>& joint_type_known);

/// How bodies, points and curves are drawn.
void read_drawing(TableReader& root, Profile& profile);

/// What `check` holds the mechanism to.
void read_limits(TableReader& root, Profile& profile);

/// The paths that [sweep], [tolerances] and [design] vary, to be known before all else is read.
void note_varied(const Table& document, Reading& reading);

/// What [sweep] asks for; its variables name numbers of the whole document. To be read last.
void read_sweep(TableReader& root, const Table& document, Profile& profile);

/// [tolerances]; likewise.
void read_tolerances(TableReader& root, const Table& document, Profile& profile);

/// Drivers and what they are to do; needs at least one.
void read_drivers(TableReader& root, Profile& profile, const std::vector<bool>& joint_type_known,
                  LawBook& laws);

/// [design]: what may be chosen, and for what purpose. \param document  the whole profile, for paths into it
void read_design(TableReader& root, const Table& document, LawBook& laws, Profile& profile);

}  // namespace higherpair::io_detail
