#include "ground_jerks.hpp"

#include "higherpair/contact/jerk.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "series_motion.hpp"

#include <cmath>
#include <utility>
#include <variant>

namespace higherpair {
namespace {

using Jerks = std::vector<std::optional<BodyJerk>>;

// Jerk of a body whose coordinate at its joint to ground has this third derivative.
BodyJerk jerk_on(const OneFreedom& freedom, const BodyMotion& body, double coordinate) {
  if (!freedom.turns) {
    return {coordinate * freedom.direction_W, 0};
  }
  const BodyJerk turning{Vector2d::Zero(), coordinate};
  return {-point_jerk(body, turning, freedom.p_BO), coordinate};  // the pivot is fixed
}

// Computes the jerks of the bodies, group by group.
class GroundJerks {
public:
  GroundJerks(const Run& run, std::span<const HigherRates> higher) : run_(run), higher_(higher) {
    jerks_.resize(run.row.bodies.size());
    jerks_.front() = BodyJerk{};
  }

  bool add(const Group& group) {
    if (const auto* driven = std::get_if<DrivenBody>(&group.kind)) {
      const auto driver = static_cast<std::size_t>(driven->driver);
      const double rate = higher_.empty() ? 0.0 : higher_[driver][0];
      return set(driven->carried, driven->carried.sign * rate);
    }
    const auto placing = placing_contact(group);
    if (!placing) {
      return false;
    }
    const auto& [contact, follower] = *placing;
    return run_.row.contacts[contact].touches ? add_touching(contact, *follower) : set(*follower, 0);
  }

  [[nodiscard]] Jerks take() { return std::move(jerks_); }

private:
  [[nodiscard]] const BodyMotion& motion(int body) const { return run_.row.bodies[body]; }

  bool set(const CarriedBody& carried, double coordinate) {
    if (carried.carrier != 0 || !std::isfinite(coordinate)) {
      return false;
    }
    jerks_[carried.body] = jerk_on(carried.freedom, motion(carried.body), coordinate);
    return true;
  }

  // The contact prescribes n·(j2 - j1); the follower's coordinate is the only unknown in it.
  bool add_touching(int index, const CarriedBody& follower) {
    const Mechanism& mechanism = run_.mechanism();
    const Contact& contact = mechanism.contacts[index];
    const int other = end_off(contact, follower.body).body;
    const auto& known = jerks_[other];
    if (contact.rolling || follower.carrier != 0 || !known) {
      return false;
    }
    const CommonNormal& at = run_.row.contacts[index].at;
    const BodyMotion& body = motion(follower.body);
    const Vector2d p_W = at.p_W();
    const auto along = [&](const BodyMotion& of, const BodyJerk& jerk) {
      return point_jerk(of, jerk, of.X_WB.inverse_times(p_W)).dot(at.n_W);
    };
    const double wanted =
        contact_jerk(curve_of(mechanism, contact.first), curve_of(mechanism, contact.second), at,
                     motion(contact.first.body), motion(contact.second.body))
            .normal_jerk();
    const double apart = along(motion(other), *known) - along(body, jerk_on(follower.freedom, body, 0));
    const Vector2d by_q = velocity_per_q(follower.freedom, p_W);
    const double per_q = by_q.dot(at.n_W);
    if (rounding_shows(std::abs(per_q) / by_q.norm(), 3)) {
      return false;
    }
    return set(follower, (apart + (other == contact.first.body ? wanted : -wanted)) / per_q);
  }

  const Run& run_;
  std::span<const HigherRates> higher_;
  Jerks jerks_;
};

}  // namespace

std::optional<Jerks> jerks_on_ground(const Run& run, std::span<const HigherRates> higher) {
  if (!run.row.all_rates) {
    return std::nullopt;
  }
  GroundJerks jerks(run, higher);
  for (const Group& group : run.plan().groups) {
    if (!jerks.add(group)) {
      return std::nullopt;
    }
  }
  return jerks.take();
}

}  // namespace higherpair
