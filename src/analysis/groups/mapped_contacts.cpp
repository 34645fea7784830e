#include "higherpair/analysis/mapped_contacts.hpp"

#include "group_solver.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_sides.hpp"

#include <algorithm>

namespace higherpair {
namespace {

std::optional<int> driver_of(const Mechanism& mechanism, int joint) {
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    if (mechanism.drivers[i].joint == joint) {
      return static_cast<int>(i);
    }
  }
  return std::nullopt;
}

bool is_unbounded(const Curve& curve) {
  return is_line(curve) || (is_conic(curve) && curve.q <= 0);
}

class Mapper {
public:
  Mapper(const Mechanism& mechanism, const Plan& plan, const std::vector<double>& drivers,
         const tl::expected<Run, StartFailure>& run)
      : mechanism_(mechanism), plan_(plan), drivers_(drivers), run_(run), posed_(posed_bodies(mechanism)) {}

  [[nodiscard]] MappedContact map(int index) const {
    MappedContact mapped;
    mapped.contact = index;
    const Contact& contact = mechanism_.contacts[index];
    const auto follower = follower_of(index);
    if (contact.rolling) {
      mapped.refusal = "it rolls: its arcs, not only its tangency, tie the two bodies";
    } else if (!follower) {
      mapped.refusal = "no body is placed by this contact alone: it is solved together with other conditions";
    } else {
      mapped.known_is_first = contact.second.body == *follower;
      set_pair(contact, *follower, mapped);
    }
    return mapped;
  }

private:
  // The body that a contact alone places.
  [[nodiscard]] std::optional<int> follower_of(int contact) const {
    const auto g = group_with_contact(plan_, contact);
    const auto placing = g ? placing_contact(plan_.groups[*g]) : std::nullopt;
    return placing ? std::optional(placing->follower->body) : std::nullopt;
  }

  [[nodiscard]] const std::string& name_of(int body) const { return mechanism_.bodies[body].name; }

  void set_pair(const Contact& contact, int follower, MappedContact& mapped) const {
    const CurveRef& on_known = end_off(contact, follower);
    const CurveRef& on_follower = end_on(contact, follower);
    const auto known_joint = ground_joint(mechanism_, on_known.body);
    const auto follower_joint = ground_joint(mechanism_, follower);
    if (!known_joint || !follower_joint) {
      mapped.refusal = name_of(known_joint ? follower : on_known.body) +
                       " has no revolute or prismatic joint to ground that leaves it one coordinate";
      return;
    }
    const auto joint = [&](int i) { return mechanism_.joints[i]; };
    mapped.known_joint = *known_joint;
    mapped.follower_joint = *follower_joint;
    mapped.known = carried_body(mechanism_, joint(*known_joint), on_known.body);
    mapped.follower = carried_body(mechanism_, joint(*follower_joint), follower);
    mapped.pair = {curve_of(mechanism_, on_known), mapped.known.freedom, curve_of(mechanism_, on_follower),
                   mapped.follower.freedom};
    if (contact.by_boundary) {
      mapped.boundary1 = &boundary_of(mechanism_, on_known);
      mapped.boundary2 = &boundary_of(mechanism_, on_follower);
      mapped.unbounded = {is_unbounded(mapped.pair.curve1), is_unbounded(mapped.pair.curve2)};
    }
    mapped.driver = driver_of(mechanism_, *known_joint);
    mapped.posed = carried_coordinate(mapped.follower, posed_);
    set_position(mapped);
  }

  void set_position(MappedContact& mapped) const {
    if (run_) {
      const State& state = run_->at.state;
      const Vector2d n_W = state.contacts[mapped.contact].at.n_W;
      mapped.q = carried_coordinate(mapped.follower, state.bodies);
      mapped.n_W = mapped.known_is_first ? n_W : Vector2d(-n_W);
    }
    if (mapped.driver) {
      mapped.u = mapped.known.sign * drivers_[*mapped.driver];
    } else if (!mapped.pair.motion1.turns) {
      mapped.refusal = name_of(mapped.known.body) + " slides and is not driven: no range is given for it";
    } else if (run_) {
      mapped.u = carried_coordinate(mapped.known, run_->at.state.bodies);
    } else {
      mapped.u = carried_coordinate(mapped.known, posed_);
    }
  }

  const Mechanism& mechanism_;
  const Plan& plan_;
  const std::vector<double>& drivers_;
  const tl::expected<Run, StartFailure>& run_;
  std::vector<BodyMotion> posed_;
};

}  // namespace

tl::expected<MappedContacts, std::string> mapped_contacts(const Mechanism& mechanism,
                                                          const std::vector<double>& drivers,
                                                          double tolerance) {
  auto plan = make_plan(mechanism);
  if (!plan) {
    return tl::unexpected(plan.error());
  }
  const RunModel model = make_run_model(mechanism, *std::move(plan));
  const auto run = start_run(model, drivers, tolerance);
  MappedContacts found;
  found.not_started = run ? "" : run.error().reason;
  const Mapper mapper(mechanism, *model.plan, drivers, run);
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    found.contacts.push_back(mapper.map(static_cast<int>(i)));
  }
  return found;
}

}  // namespace higherpair
