#pragma once

#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/contact_pair.hpp"
#include "higherpair/contact/critical_positions.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/numeric/stop.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace higherpair {

inline constexpr double kTurn = 2 * kPi;  ///< of the driver or the follower [rad]

struct BoundaryPair;
class BoundaryTrace;

/// The driver coordinates that a map covers: one whole turn from `start`, or the range from `start` to `end`.
struct MapRange {
  double start = 0;  ///< [rad or m]
  /// End of a sliding driver's range [m], either side of start; ignored for a turning driver.
  double end = 0;
  /// Overlap, relative to the bodies' size, up to which a contact counts as free.
  double tolerance = kDefaultOverlap;
  std::int64_t samples = 361;               ///< points over the range, both ends included, >= 2
  const std::atomic<bool>* stop = nullptr;  ///< once true, the map is abandoned: MapStatus::kStopped
};

/// Whether the map has been asked to stop.
[[nodiscard]] inline bool is_stopped(const MapRange& range) {
  return is_raised(range.stop);
}

/// One position on a branch.
struct MapPoint : TangentPosition {    ///< q is continuous along the branch
  bool free = false;                   ///< opposed, and the interiors of the bodies are disjoint
  std::optional<std::int64_t> sample;  ///< u = start + sample·spacing; none at the end of a branch
};

enum class MapEndType {
  kFold,        ///< ∂gap/∂q = 0: the limit position, where another branch merges with this one
  kConforming,  ///< κ1 + κ2 = 0: the same with a common tangent, a cusp
  kInfinity,    ///< the contact runs off to infinity along an open curve
  kEnd,         ///< the contact reaches an end of a boundary, or a concave corner of one
  kRange,       ///< the end of a sliding driver's range
  kClosed,      ///< no end: the branch returns to its beginning after whole turns of the driver
  kLost,        ///< not followed further: the map is not complete
};

/// The name as results print it: "fold".
[[nodiscard]] std::string_view name_of(MapEndType type);

struct MapEnd {
  MapEndType type = MapEndType::kLost;
  double u = 0;    ///< position of the end [rad or m]
  double q = 0;    ///< [rad or m], continuous along the branch; at infinity that of the last point
  int event = -1;  ///< for kFold and kConforming: index into ContactMap::events
  int other = -1;  ///< the branch that merges there
};

/// Contacts that form one smooth curve q(u).
struct MapBranch {
  bool opposed = true;           ///< the outward normals are opposed along the whole branch
  std::vector<MapPoint> points;  ///< by rising u, including the two ends where they are finite
  MapEnd begin;
  MapEnd end;
  int turns = 0;                       ///< turns of the driver after which a closed branch repeats; else 0
  std::vector<MapPoint> free_changes;  ///< where another contact of the same bodies appears or disappears
  std::vector<MapPoint> extremes;      ///< dq/du = 0: the follower reverses
};

/// A position in the map where branches merge or cross.
struct MapEvent {
  CriticalPosition at;
  std::vector<int> branches;  ///< that end here; empty where branches cross, or merely touch
};

enum class MapStatus {
  kOk,
  kNoPair,             ///< two lines or two points
  kNotAlgebraic,       ///< a curve given by its support function: its critical positions are not known
  kTouchesEverywhere,  ///< the distance of the curves does not depend on q, and they touch
  kTouchesNowhere,     ///< it does not depend on q, and they do not touch
  kTangentAtInfinity,  ///< hyperbolas that share an asymptote at every relative position
  kLimitEverywhere,    ///< the driver does not move the follower, which is at a limit position
  kOnlyRelative,       ///< boundaries of bodies on one pivot, or on parallel slides
  kTooManyParts,       ///< boundaries with so many spans that a map would take minutes
  kStopped,            ///< by MapRange::stop
};

/// The status as a sentence.
[[nodiscard]] std::string_view describe(MapStatus status);

/// All contacts of a pair over the range of its driver: the configuration space of the pair.
struct ContactMap {
  ContactPair pair;                            ///< for boundaries its motions only
  double size = 0;                             ///< of the pair [m]
  std::shared_ptr<const BoundaryTrace> trace;  ///< for boundaries: the curves of contacts; else null
  MapRange range;
  MapStatus status = MapStatus::kNoPair;
  /// False: a branch was lost between two positions at which all contacts are known, or points of it are
  /// missing.
  bool complete = true;
  std::vector<MapBranch> branches;  ///< by their beginnings; kOk only
  std::vector<MapEvent> events;     ///< by rising u
};

/// The set M of all (u, q) at which the curves are tangent, as branches q(u).
///
/// The u at which M cannot be written as q(u) are known beforehand (critical_positions.hpp): they cut the
/// range into intervals in each of which the number of contacts is constant and every contact moves smoothly.
/// All contacts are listed in the middle of each interval (find_curve_contacts); each is followed to the
/// middle of the next interval, and the counterpart found there must lead back to it when followed in
/// reverse. A contact without counterpart ends at the cut in between. Branches of a turning driver continue
/// past the ends of the range: a branch that contains `range.start` begins below it; every other begins
/// within the range.
/// Folds and cusps are exact to within rounding divided by the slope of the conditions there. Those closer
/// together than 1e-10 (of a radian, or relative to the size) are not distinguished: a smaller island is
/// reported as two events without branches. Cost: some 10 ms for each interval and for each circle that
/// replaces curve 2 in the search for folds, for two conics.
/// \pre samples >= 2
[[nodiscard]] ContactMap map_contacts(const ContactPair& pair, const MapRange& range);

/// The same for two boundaries, which must outlive the map.
///
/// M is the zero set of one function of the places along the two boundaries (TangencySheet), which is smooth
/// even where q(u) is not: at folds and conforming contacts, and where a contact passes from span to span. It
/// is followed on a grid of the boundaries' samples (sheet_curves.hpp) and then cut into branches where
/// ∂gap/∂q or κ1 + κ2 changes sign (the sum of curvatures possibly by a jump). Folds, conforming contacts and
/// points are exact to within rounding. Completeness is not proven: closed branches that lie between the
/// samples of both boundaries may be missed. Where two faces coincide, or two corners meet, the branch
/// continues with another slope. Branches that cross are followed as two that do not quite touch.
/// \param unbounded  whether the ends of a boundary are where an unbounded curve has been cut off
[[nodiscard]] ContactMap map_contacts(const BoundaryPair& pair, const MapRange& range,
                                      const std::array<bool, 2>& unbounded = {false, false});

/// The contact of a branch at a driver coordinate between its ends; none elsewhere.
[[nodiscard]] std::optional<MapPoint> point_at(const ContactMap& map, int branch, double u);

/// One contact of a map.
struct MapContact {
  int branch = 0;
  MapPoint point;  ///< its u may differ by whole turns from the requested one
};

/// All contacts of a map at a driver coordinate (for a turning driver up to whole turns), by branches.
[[nodiscard]] std::vector<MapContact> contacts_at(const ContactMap& map, double u);

/// The branch that a contact lies on; none if no branch comes within 1e-6 (rad, or relative to the size).
[[nodiscard]] std::optional<int> branch_of(const ContactMap& map, double u, double q, const Vector2d& n_W);

/// The opposed contact on another branch that is nearest to a branch at the same driver position.
struct Neighbour {
  int branch = -1;
  double u = 0;
  double distance = 0;  ///< |difference of q| [rad or m], for a turning follower up to whole turns
};

/// At the driver coordinate u, between the ends of the branch.
[[nodiscard]] std::optional<Neighbour> neighbour_at(const ContactMap& map, int branch, double u);

/// The nearest neighbour over all points of the branch; at distance 0 at an end where another branch merges.
[[nodiscard]] std::optional<Neighbour> nearest_neighbour(const ContactMap& map, int branch);

}  // namespace higherpair
