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

inline constexpr double kTurn = 2 * kPi;  ///< of the driver [rad]

struct BoundaryPair;
class BoundaryTrace;

/// The driver coordinates that a map covers: one whole turn from `start`, or the range from `start` to `end`.
struct MapRange {
  double start = 0;                         ///< [rad or m]
  double end = 0;                           ///< of a sliding driver [m], either side of start; else ignored
  double tolerance = kDefaultOverlap;       ///< of the bodies' size: overlap of a contact that counts as free
  std::int64_t samples = 361;               ///< points over the range, both ends included, >= 2
  const std::atomic<bool>* stop = nullptr;  ///< once true, the map is given up: MapStatus::kStopped
};

/// Whether whoever asked for a map wants it no longer.
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
  kEnd,         ///< the contact comes to an end of a boundary, or to a concave corner of one
  kRange,       ///< the end of a sliding driver's range
  kClosed,      ///< none: the branch comes back to its beginning after whole turns of the driver
  kLost,        ///< not followed further: the map is not complete
};

[[nodiscard]] std::string_view name_of(MapEndType type);

struct MapEnd {
  MapEndType type = MapEndType::kLost;
  double u = 0;    ///< where [rad or m]
  double q = 0;    ///< [rad or m], continuous along the branch; at infinity that of the last point
  int event = -1;  ///< of kFold and kConforming: index into ContactMap::events
  int other = -1;  ///< the branch that merges there
};

/// Contacts that form one smooth curve q(u).
struct MapBranch {
  bool opposed = true;           ///< the outward normals are opposed along the whole of it
  std::vector<MapPoint> points;  ///< by rising u, the two ends included where they are finite
  MapEnd begin;
  MapEnd end;
  int turns = 0;                       ///< of the driver after which a closed branch is back; else 0
  std::vector<MapPoint> free_changes;  ///< where another contact of the same bodies appears or vanishes
  std::vector<MapPoint> extremes;      ///< dq/du = 0: the follower turns back
};

/// A map entry where branches merge or cross.
struct MapEvent {
  CriticalPosition at;
  std::vector<int> branches;  ///< that end here; none where branches cross, or merely touch
};

enum class MapStatus {
  kOk,
  kNoPair,             ///< two lines or two points
  kNotAlgebraic,       ///< a curve by its support: its critical positions are not known
  kTouchesEverywhere,  ///< the distance of the curves does not depend on q, and they touch
  kTouchesNowhere,     ///< it does not depend on q, and they do not touch
  kTangentAtInfinity,  ///< hyperbolas that share an asymptote at every relative position
  kLimitEverywhere,    ///< the driver does not move the follower, which is at a limit position
  kOnlyRelative,       ///< boundaries of bodies on one pivot, or on parallel slides
  kTooManyParts,       ///< boundaries of so many spans that a map would take minutes
  kStopped,            ///< by MapRange::stop
};

/// What the status means, as a sentence.
[[nodiscard]] std::string_view describe(MapStatus status);

/// All contacts of a pair over the range of its driver: the configuration space of the pair.
struct ContactMap {
  ContactPair pair;                            ///< of boundaries its motions only
  double size = 0;                             ///< of the pair [m]
  std::shared_ptr<const BoundaryTrace> trace;  ///< of boundaries: the curves of contacts, else null
  MapRange range;
  MapStatus status = MapStatus::kNoPair;
  bool complete = true;  ///< false: a branch was lost between two positions at which all contacts are known
  std::vector<MapBranch> branches;  ///< by their beginnings; kOk only
  std::vector<MapEvent> events;     ///< by rising u
};

/// The set M of all (u, q) at which the curves are tangent, as branches q(u).
///
/// Where M cannot be written as q(u) is known beforehand (critical_positions.hpp): these u cut the range into
/// intervals in each of which the number of contacts is constant and every one moves smoothly. In the middle
/// of each interval all contacts are listed (find_curve_contacts); each is followed to the middle of the next
/// and has to be met by its counterpart followed back. What has no counterpart ends at the cut between.
/// A turning driver's branches go on past the ends of the range, so that u of a branch that holds
/// `range.start` begins below it; every other begins within the range.
/// Folds and cusps are exact to within rounding, divided by the slope of the conditions there; those nearer
/// together than 1e-10 (of a radian, of the size) are not told apart: an island smaller than that is two
/// events without branches. Cost: some 10 ms for each interval and each fold's circle, for two conics.
/// \pre samples >= 2
[[nodiscard]] ContactMap map_contacts(const ContactPair& pair, const MapRange& range);

/// The same of two boundaries, which have to outlive the map.
///
/// The set M is the zeros of one function of the places along the two boundaries (TangencySheet), which is
/// smooth where q(u) is not: at folds and conforming contacts, and where a contact goes over from span to
/// span. It is followed on a grid of the boundaries' samples (sheet_curves.hpp) and then cut into branches
/// where ∂gap/∂q or κ1 + κ2 changes its sign; the curvature's sum may do so by a jump. Folds, conforming
/// contacts and points are exact to within rounding; that no branch is missed is not proven: closed ones that
/// lie between the samples of both boundaries may be. Where two faces lie on each other, or two corners meet,
/// the branch goes on with another slope. Branches that cross are followed as two that do not quite touch.
/// \param unbounded  whether the ends of a boundary are those at which an unbounded curve has been cut off
[[nodiscard]] ContactMap map_contacts(const BoundaryPair& pair, const MapRange& range,
                                      const std::array<bool, 2>& unbounded = {false, false});

/// The contact of a branch at a driver coordinate between its ends; none elsewhere.
[[nodiscard]] std::optional<MapPoint> point_at(const ContactMap& map, int branch, double u);

/// One contact of a map.
struct MapContact {
  int branch = 0;
  MapPoint point;  ///< its u may be whole turns from that asked for
};

/// All contacts of a map at a driver coordinate (of a turning driver up to whole turns), by branches.
[[nodiscard]] std::vector<MapContact> contacts_at(const ContactMap& map, double u);

/// The branch that a contact lies on; none if no branch comes within 1e-6 (of a radian, of the size).
[[nodiscard]] std::optional<int> branch_of(const ContactMap& map, double u, double q, const Vector2d& n_W);

/// The opposed contact of another branch that is nearest to a branch at the same driver position.
struct Neighbour {
  int branch = -1;
  double u = 0;
  double distance = 0;  ///< |difference of q| [rad or m], of a turning follower up to whole turns
};

/// At the driver coordinate u, between the ends of the branch.
[[nodiscard]] std::optional<Neighbour> neighbour_at(const ContactMap& map, int branch, double u);

/// The nearest over all points of the branch; 0 at an end where another branch merges.
[[nodiscard]] std::optional<Neighbour> nearest_neighbour(const ContactMap& map, int branch);

}  // namespace higherpair
