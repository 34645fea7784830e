#include "short_way.hpp"

#include "analysis/tolerances.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace higherpair {
namespace {

class ShortWay {
public:
  ShortWay(const std::vector<Group>& groups, const State& lost, const State& begin)
      : groups_(groups), lost_(lost), begin_(begin), turns_(begin.bodies.size(), 0.0) {}

  void add(const SlideDyad& dyad) {
    for (const Rider& rider : dyad.riders) {
      add_rider(rider);
    }
    add_rider(dyad.pinned);
  }

  void add(const TouchingBody& touching) {
    if (touching.follower.freedom.turns) {
      add_own(touching.follower.body);
    } else {
      turn_of(touching.follower.body) = turn_of(touching.follower.carrier);
    }
    const auto i = static_cast<std::size_t>(touching.contact);
    normals_.push_back({i, short_way(begin_.contacts[i].phi, lost_.contacts[i].phi)});
  }

  void add(const TrackedPair& tracked) {
    if (tracked.follower.freedom.turns) {
      add_own(tracked.follower.body);
    }
    const auto i = static_cast<std::size_t>(tracked.contact);
    normals_.push_back({i, short_way(begin_.contacts[i].phi, lost_.contacts[i].phi)});
  }

  // A body that a driver turns follows the driver.
  template <class Kind>
  void add(const Kind& kind) {
    if constexpr (requires { kind.links(); }) {
      for (const int link : kind.links()) {
        add_own(link);
      }
    }
    if constexpr (requires { kind.slider; }) {
      add_rider(kind.slider);
    }
  }

  void take(State& state) const {
    for (std::size_t i = 0; i < turns_.size(); ++i) {
      state.bodies[i].theta += turns_[i];
    }
    for (const auto& [contact, turn] : normals_) {
      state.contacts[contact].phi += turn;
    }
    for (std::size_t g = 0; g < state.tracks.size(); ++g) {
      if (auto* track = std::get_if<ContactTrack>(&state.tracks[g])) {
        turn_track(std::get<TrackedPair>(groups_[g].kind), *track);
      }
    }
  }

private:
  struct NormalTurn {
    std::size_t contact;
    double turn;
  };

  void turn_track(const TrackedPair& tracked, ContactTrack& track) const {
    if (tracked.follower.freedom.turns) {
      track.at.q += turns_[tracked.follower.body];
      track.follower = {};
    }
    for (const auto& [contact, turn] : normals_) {
      track.phi += contact == static_cast<std::size_t>(tracked.contact) ? turn : 0;
    }
  }

  // Across a pole the difference may be exactly half a turn; it then counts as one backwards, whatever its
  // rounding.
  static double short_way(double angle, double reference) {
    return nearest_turn(angle, reference - kHalfTurn) - angle;
  }

  double& turn_of(int body) { return turns_[body]; }

  void add_own(int body) {
    const auto i = static_cast<std::size_t>(body);
    turns_[i] = short_way(begin_.bodies[i].theta, lost_.bodies[i].theta);
  }

  void add_rider(const std::optional<Rider>& rider) {
    if (rider) {
      turn_of(rider->body) = turn_of(rider->carrier);
    }
  }

  const std::vector<Group>& groups_;
  const State& lost_;
  const State& begin_;
  std::vector<double> turns_;  // of the bodies [rad]
  std::vector<NormalTurn> normals_;
};

}  // namespace

void take_short_way(Run& run, const State& lost, const State& begin) {
  const bool geared = std::any_of(run.plan().groups.begin(), run.plan().groups.end(), [](const Group& group) {
    return std::holds_alternative<GearedBody>(group.kind);
  });
  if (geared) {
    return;
  }
  ShortWay way(run.plan().groups, lost, begin);
  for (const Group& group : run.plan().groups) {
    std::visit([&](const auto& kind) { way.add(kind); }, group.kind);
  }
  way.take(run.at.state);
}

}  // namespace higherpair
