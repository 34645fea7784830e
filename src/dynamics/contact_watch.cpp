#include "higherpair/dynamics/contact_watch.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/tools/toms748_solve.hpp>

namespace higherpair {
namespace {

constexpr double kLookEvery = kPi / 36;
constexpr double kMostLooks = 10000;
constexpr double kRounding = 1e-9;

bool contains(const std::vector<int>& items, int item) {
  return std::find(items.begin(), items.end(), item) != items.end();
}

bool acts_on(const Mechanism& mechanism, const Spring& spring, int body) {
  if (spring.joint) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(*spring.joint)];
    return joint.first.body == body || joint.second.body == body;
  }
  return spring.first.body == body || spring.second.body == body;
}

std::optional<Preload> spring_on(const Mechanism& mechanism, int body) {
  for (std::size_t i = 0; i < mechanism.springs.size(); ++i) {
    if (acts_on(mechanism, mechanism.springs[i], body)) {
      return Preload{Preload::On::kSpring, static_cast<int>(i)};
    }
  }
  return std::nullopt;
}

std::optional<Preload> carrying_joint(const Mechanism& mechanism, const Group& group) {
  for (const int index : group.joints) {
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(index)];
    if (!contains(group.bodies, joint.first.body) || !contains(group.bodies, joint.second.body)) {
      return Preload{Preload::On::kJoint, index};
    }
  }
  return std::nullopt;
}

// The drivers at a share of the way between two rows.
void between(const std::vector<DriverMotion>& from, const std::vector<DriverMotion>& to, double share,
             std::vector<DriverMotion>& out) {
  const auto mix = [&](double a, double b) { return share == 1 ? b : a + share * (b - a); };
  out.resize(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) {
    out[i] = {mix(from[i].position, to[i].position), mix(from[i].velocity, to[i].velocity),
              mix(from[i].acceleration, to[i].acceleration)};
  }
}

// How many parts of the way between two rows are looked at one by one.
int parts_of(const Run& run, const std::vector<DriverMotion>& from, const std::vector<DriverMotion>& to) {
  double parts = 1;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const auto joint = static_cast<std::size_t>(run.mechanism.drivers[i].joint);
    const bool turns = run.mechanism.joints[joint].type == JointType::kRevolute;
    const double most = turns ? kLookEvery : run.plan.size / 12;
    parts = std::max(parts, std::abs(to[i].position - from[i].position) / most);
  }
  return static_cast<int>(std::ceil(std::min(parts, kMostLooks) - kRounding));
}

}  // namespace

std::optional<double> PreloadNeed::smallest() const {
  if (!(low <= high)) {
    return std::nullopt;
  }
  return low > 0 ? low : high < 0 ? high : 0;
}

std::optional<Preload> preload_of(const Run& run, std::size_t contact) {
  const Mechanism& mechanism = run.mechanism;
  for (const Group& group : run.plan.groups) {
    if (!contains(group.contacts, static_cast<int>(contact))) {
      continue;
    }
    const Contact& touch = mechanism.contacts[contact];
    std::vector<int> bodies = group.bodies;
    const auto follower = std::find_if(bodies.begin(), bodies.end(), [&](int body) {
      return body == touch.first.body || body == touch.second.body;
    });
    std::rotate(bodies.begin(), follower, bodies.end());
    for (const int body : bodies) {
      if (const auto spring = spring_on(mechanism, body)) {
        return spring;
      }
    }
    return carrying_joint(mechanism, group);
  }
  return std::nullopt;
}

ContactWatch::ContactWatch(const Run& run)
    : forces_before_(run.mechanism.contacts.size()), pulled_before_(run.mechanism.contacts.size(), false) {
  for (std::size_t i = 0; i < run.mechanism.contacts.size(); ++i) {
    if (const auto preload = preload_of(run, i)) {
      PreloadNeed need;
      need.contact = i;
      need.preload = *preload;
      needs_.push_back(need);
    }
  }
}

const std::vector<ContactOpening>& ContactWatch::look(const Run& run,
                                                      const std::vector<DriverMotion>& drivers,
                                                      InverseDynamics& dynamics, const Reactions& reactions) {
  openings_.clear();
  look_between(run, drivers);
  look_at(run, drivers, dynamics, reactions);
  return openings_;
}

void ContactWatch::look_between(const Run& run, const std::vector<DriverMotion>& drivers) {
  const bool jumped = std::any_of(run.events.begin(), run.events.end(), [](const RunEvent& event) {
    return event.type == EventType::kSecondContact || event.type == EventType::kLimitPosition;
  });
  // What lies on the other side of a gap or a jump is not on the way back.
  if (!run.held || drivers_before_.empty() || jumped) {
    return;
  }
  const int parts = parts_of(run, drivers_before_, drivers);
  if (parts == 1) {
    return;
  }
  Run probe = run;
  InverseDynamics dynamics(probe);
  const std::vector<DriverMotion> from = drivers_before_;
  std::vector<DriverMotion> there;
  for (int i = 1; i < parts; ++i) {
    between(from, drivers, static_cast<double>(i) / parts, there);
    move_to(probe, there);
    look_at(probe, there, dynamics, dynamics.solve(probe));
  }
}

void ContactWatch::look_at(const Run& run, const std::vector<DriverMotion>& drivers,
                           InverseDynamics& dynamics, const Reactions& reactions) {
  for (std::size_t i = 0; i < reactions.contacts.size(); ++i) {
    const ContactReaction& contact = reactions.contacts[i];
    if (contact.pulls && !pulled_before_[i]) {
      openings_.push_back(locate(run, drivers, i, *contact.force));
    }
    forces_before_[i] = contact.force;
    pulled_before_[i] = contact.pulls;
  }
  bound(run, dynamics, reactions);
  drivers_before_ = drivers;
}

ContactOpening ContactWatch::locate(const Run& run, const std::vector<DriverMotion>& drivers,
                                    std::size_t contact, double force) const {
  ContactOpening opening{contact, ContactOpening::Kind::kPulled, drivers.front().position};
  const std::optional<double> before = forces_before_[contact];
  if (!before) {
    return opening;
  }
  if (!(*before > 0)) {
    // It was at 0 there, to rounding.
    opening.kind = ContactOpening::Kind::kRoot;
    opening.driver = drivers_before_.front().position;
    return opening;
  }
  // The branch is the same on the way back.
  Run probe = run;
  InverseDynamics dynamics(probe);
  std::vector<DriverMotion> tried;
  bool defined = true;
  const auto force_at = [&](double share) {
    between(drivers_before_, drivers, share, tried);
    move_to(probe, tried);
    const auto there = dynamics.solve(probe).contacts[contact].force;
    defined = defined && there.has_value();
    return there.value_or(0);
  };
  std::uintmax_t calls = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      force_at, 0.0, 1.0, *before, force, boost::math::tools::eps_tolerance<double>(52), calls);
  const double share = (low + high) / 2;
  const double there = force_at(share);
  if (!defined || std::abs(there) > std::max(*before, -force)) {
    opening.kind = ContactOpening::Kind::kPole;
  } else {
    opening.kind = ContactOpening::Kind::kRoot;
  }
  between(drivers_before_, drivers, share, tried);
  opening.driver = tried.front().position;
  return opening;
}

// force + preload·(force per preload) >= 0
void ContactWatch::bound(const Run& run, InverseDynamics& dynamics, const Reactions& reactions) {
  for (PreloadNeed& need : needs_) {
    const ContactReaction& contact = reactions.contacts[need.contact];
    if (!contact.force) {
      continue;
    }
    need.opened = need.opened || contact.pulls;
    const double per_preload = dynamics.force_per_preload(run, need.contact, need.preload).value_or(0);
    const double limit = -*contact.force / per_preload;
    if (per_preload > 0) {
      need.low = std::max(need.low, limit);
    } else if (per_preload < 0) {
      need.high = std::min(need.high, limit);
    } else if (contact.pulls) {
      need.low = std::numeric_limits<double>::infinity();
    }
  }
}

}  // namespace higherpair
