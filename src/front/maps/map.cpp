#include "front/demands.hpp"
#include "front/model_data.hpp"
#include "higherpair/analysis/mapped_contacts.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/contact/contact_map.hpp"
#include "higherpair/front/contacts.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "higherpair/numeric/stop.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Converts the coordinates of the pair to those of the joints.
class Converter {
public:
  Converter(const Profile& profile, const MappedContact& mapped)
      : mapped_(mapped),
        length_(from_si(dimension::kLength, profile.units)),
        angle_(from_si(dimension::kAngle, profile.units)),
        of_driver_(mapped.pair.motion1.turns ? angle_ : length_),
        of_follower_(mapped.pair.motion2.turns ? angle_ : length_) {}

  [[nodiscard]] double driver(double u) const { return plus_zero(of_driver_.apply(mapped_.known.sign * u)); }
  [[nodiscard]] double position(double q) const {
    return plus_zero(of_follower_.apply(mapped_.follower.sign * q));
  }
  [[nodiscard]] double distance(double q) const { return of_follower_.apply(q); }
  [[nodiscard]] bool reverses() const { return mapped_.known.sign < 0; }

  // \param turn  added to q  \param phi  the angle of the normal, in the turn nearest to its former value
  [[nodiscard]] MapRow row(const MapPoint& point, bool opposed, double turn, double& phi) const {
    const bool reversed = !mapped_.known_is_first && opposed;
    phi = nearest_turn(angle_of(reversed ? Vector2d(-point.n_W) : point.n_W), phi);
    MapRow row;
    row.driver = driver(point.u);
    row.position = position(point.q + turn);
    row.x = plus_zero(length_.apply(point.p_W.x()));
    row.y = plus_zero(length_.apply(point.p_W.y()));
    row.normal = plus_zero(angle_.apply(phi));
    row.free = point.free;
    return row;
  }

private:
  const MappedContact& mapped_;
  Scaling length_, angle_, of_driver_, of_follower_;
};

// Whole turns that bring a branch nearest to the pose, at its point nearest to the start.
double turn_of(const MapBranch& branch, const MappedContact& mapped) {
  if (!mapped.pair.motion2.turns || branch.points.empty()) {
    return 0;
  }
  const auto nearest =
      std::min_element(branch.points.begin(), branch.points.end(), [&](const MapPoint& a, const MapPoint& b) {
        return std::abs(a.u - mapped.u) < std::abs(b.u - mapped.u);
      });
  return nearest_turn(nearest->q, mapped.q.value_or(mapped.posed)) - nearest->q;
}

MapEndReport end_of(const MapEnd& end, const Converter& convert, double turn) {
  MapEndReport report;
  report.type = name_of(end.type);
  report.driver = convert.driver(end.u);
  report.position = convert.position(end.q + turn);
  if (end.other >= 0) {
    report.other = end.other + 1;
  }
  return report;
}

MapBranchReport branch_of(const MapBranch& branch, const MappedContact& mapped, const Converter& convert) {
  const double turn = turn_of(branch, mapped);
  MapBranchReport report;
  report.opposed = branch.opposed;
  report.turns = branch.turns;
  report.begin = end_of(branch.begin, convert, turn);
  report.end = end_of(branch.end, convert, turn);
  const auto add = [&](const std::vector<MapPoint>& points, std::vector<MapRow>& rows) {
    double phi = 0;
    for (const MapPoint& point : points) {
      rows.push_back(convert.row(point, branch.opposed, turn, phi));
    }
    if (convert.reverses()) {
      std::reverse(rows.begin(), rows.end());
    }
  };
  add(branch.points, report.rows);
  add(branch.free_changes, report.free_changes);
  add(branch.extremes, report.extremes);
  if (convert.reverses()) {
    std::swap(report.begin, report.end);
  }
  return report;
}

// The coordinates of an event: those of the end of its first branch there, whole turns included, so that one
// place has one pair of coordinates. Without branches, the follower's coordinate is taken nearest to the
// pose.
MapPoint place_of(const ContactMap& map, std::size_t event, const MappedContact& mapped) {
  const MapEvent& here = map.events[event];
  MapPoint point = {{here.at.u, here.at.q, here.at.p_W, here.at.n_W}, false, std::nullopt};
  double near = mapped.q.value_or(mapped.posed);
  if (!here.branches.empty()) {
    const MapBranch& branch = map.branches[here.branches.front()];
    const MapEnd& end = branch.begin.event == static_cast<int>(event) ? branch.begin : branch.end;
    point.u = end.u;
    near = turn_of(branch, mapped) + end.q;
  }
  if (mapped.pair.motion2.turns) {
    point.q = nearest_turn(point.q, near);
  }
  return point;
}

MapEventReport event_of(const ContactMap& map, std::size_t index, const MappedContact& mapped,
                        const Converter& convert) {
  const MapEvent& event = map.events[index];
  MapEventReport report;
  const bool fold = event.at.type == CriticalType::kFold;
  report.type = fold ? "fold" : event.at.type == CriticalType::kCrossing ? "crossing" : "conforming";
  double phi = 0;
  report.at = convert.row(place_of(map, index, mapped), event.at.opposed, 0, phi);
  report.opposed = event.at.opposed;
  for (const int branch : event.branches) {
    report.branches.push_back(branch + 1);
  }
  return report;
}

std::optional<NeighbourReport> neighbour_of(const std::optional<Neighbour>& found, const Converter& convert) {
  if (!found) {
    return std::nullopt;
  }
  return NeighbourReport{found->branch + 1, convert.driver(found->u), convert.distance(found->distance)};
}

std::optional<OwnBranch> own_of(const ContactMap& map, const MappedContact& mapped,
                                const Converter& convert) {
  if (!mapped.q) {
    return std::nullopt;
  }
  const auto branch = higherpair::branch_of(map, mapped.u, *mapped.q, mapped.n_W);
  if (!branch) {
    return std::nullopt;
  }
  OwnBranch own;
  own.branch = *branch + 1;
  own.driver = convert.driver(mapped.u);
  own.position = convert.position(*mapped.q);
  own.at_start = neighbour_of(neighbour_at(map, *branch, mapped.u), convert);
  own.nearest = neighbour_of(nearest_neighbour(map, *branch), convert);
  return own;
}

ContactMapReport map_report(const Profile& profile, const MappedContact& mapped, const ContactMap& map) {
  const Mechanism& mechanism = profile.mechanism;
  const Converter convert(profile, mapped);
  const auto unit = [&](bool turns) { return unit_text(coordinate_dimension(turns), profile.units); };
  ContactMapReport report;
  report.contact = mechanism.contacts[mapped.contact].name;
  report.driver_joint = mechanism.joints[mapped.known_joint].name;
  report.position_joint = mechanism.joints[mapped.follower_joint].name;
  report.driver_unit = unit(mapped.pair.motion1.turns);
  report.position_unit = unit(mapped.pair.motion2.turns);
  report.start = convert.driver(map.range.start);
  report.end = convert.driver(mapped.pair.motion1.turns ? map.range.start + 2 * kPi : map.range.end);
  report.complete = map.complete;
  if (map.status != MapStatus::kOk) {
    report.refusal = describe(map.status);
    return report;
  }
  for (const MapBranch& branch : map.branches) {
    report.branches.push_back(branch_of(branch, mapped, convert));
  }
  for (std::size_t i = 0; i < map.events.size(); ++i) {
    report.events.push_back(event_of(map, i, mapped, convert));
  }
  std::stable_sort(report.events.begin(), report.events.end(),
                   [](const auto& a, const auto& b) { return a.at.driver < b.at.driver; });
  report.own = own_of(map, mapped, convert);
  return report;
}

// A whole turn from the start; for a slide the range over which the profile drives it.
MapRange range_of(const MappedContact& mapped, const DriverSchedule& schedule, const MapSettings& settings) {
  MapRange range;
  range.start = mapped.u;
  range.tolerance = settings.tolerance;
  range.stop = settings.stop;
  range.samples = settings.samples.value_or(schedule.size() > 1 ? schedule.size() : kDefaultSamples);
  if (mapped.pair.motion1.turns) {
    return range;
  }
  double low = mapped.u;
  double high = mapped.u;
  for (std::int64_t k = 0; k < schedule.size(); ++k) {
    const double u =
        mapped.known.sign * schedule.state(k, static_cast<std::size_t>(*mapped.driver)).si.position;
    low = std::min(low, u);
    high = std::max(high, u);
  }
  range.start = low;
  range.end = high;
  return range;
}

ContactMapReport report_of(const Profile& profile, const MappedContact& mapped,
                           const DriverSchedule& schedule, const MapSettings& settings) {
  ContactMapReport refused;
  refused.contact = profile.mechanism.contacts[mapped.contact].name;
  refused.refusal = mapped.refusal;
  if (!refused.refusal.empty()) {
    return refused;
  }
  const MapRange range = range_of(mapped, schedule, settings);
  if (!mapped.pair.motion1.turns && range.start == range.end) {
    refused.refusal = "the driver slides and stays where it is: give driver.end";
    return refused;
  }
  if (mapped.boundary1 == nullptr) {
    return map_report(profile, mapped, map_contacts(mapped.pair, range));
  }
  const BoundaryPair pair{mapped.boundary1, mapped.pair.motion1, mapped.boundary2, mapped.pair.motion2};
  return map_report(profile, mapped, map_contacts(pair, range, mapped.unbounded));
}

// Why no contact has a map.
std::string refusal_of(const MapReport& report) {
  if (report.contacts.empty()) {
    return "the mechanism has no contact to map";
  }
  std::string text = "no contact has a map";
  for (const ContactMapReport& contact : report.contacts) {
    text += "; contacts." + contact.contact + ": " + contact.refusal;
  }
  return text;
}

}  // namespace

Result<MapReport> map_of(const Model& model, const MapSettings& settings) {
  const Model::Data& data = model.data();
  if (std::string fault =
          first_unmet({positive("setting tolerance", settings.tolerance),
                       within(2, kMostMapRows, "setting samples", settings.samples.value_or(2))});
      !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  const auto schedule = first_schedule(data);
  if (!schedule) {
    return tl::unexpected(schedule.error());
  }
  const auto mapped =
      mapped_contacts(data.profile.mechanism, schedule->first_positions(), settings.tolerance);
  if (!mapped) {
    return tl::unexpected(error_about(data, ErrorKind::kMechanism, mapped.error()));
  }
  MapReport report;
  report.title = data.profile.mechanism.title;
  report.length_unit = unit_text(dimension::kLength, data.profile.units);
  report.angle_unit = unit_text(dimension::kAngle, data.profile.units);
  report.not_started = mapped->not_started;
  for (const MappedContact& contact : mapped->contacts) {
    report.contacts.push_back(report_of(data.profile, contact, *schedule, settings));
  }
  report.stopped = is_raised(settings.stop);
  if (report.stopped) {
    report.contacts.clear();
    return report;
  }
  if (std::all_of(report.contacts.begin(), report.contacts.end(),
                  [](const ContactMapReport& contact) { return !contact.refusal.empty(); })) {
    return tl::unexpected(error_about(data, ErrorKind::kMechanism, refusal_of(report)));
  }
  return report;
}

}  // namespace higherpair
