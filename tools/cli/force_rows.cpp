#include "force_rows.hpp"

#include <utility>

namespace higherpair::cli {
namespace {

Dimension driver_dimension(const Mechanism& mechanism) {
  const auto joint = static_cast<std::size_t>(mechanism.drivers.front().joint);
  return mechanism.joints[joint].type == JointType::kRevolute ? dimension::kAngle : dimension::kLength;
}

}  // namespace

ForceRows::ForceRows(const Profile& profile, const Run& run, ForceTable table)
    : profile_(profile), dynamics_(run), watch_(run), table_(std::move(table)) {}

const std::vector<Cell>& ForceRows::row(const Run& run, const std::vector<DriverMotion>& drivers,
                                        const std::vector<Cell>& motion, std::vector<Event>& events) {
  const Reactions& reactions = dynamics_.solve(run);
  opened_ = opened_ || reactions.opens();
  const Scaling scale = from_si(driver_dimension(profile_.mechanism), profile_.units);
  for (const ContactOpening& opening : watch_.look(run, drivers, dynamics_, reactions)) {
    openings_.emplace_back(events.size(), opening);
    events.push_back({"contact_open", scale.apply(opening.driver), std::nullopt,
                      profile_.mechanism.contacts[opening.contact].name, ""});
  }
  return table_.cells(reactions, motion);
}

void ForceRows::finish(std::vector<Event>& events) const {
  for (const auto& [event, opening] : openings_) {
    const PreloadNeed* own = nullptr;
    for (const PreloadNeed& need : watch_.needs()) {
      own = need.contact == opening.contact ? &need : own;
    }
    events[event].cause = describe(opening, own, profile_);
  }
}

}  // namespace higherpair::cli
