#include "assembly.hpp"

#include "coupled_bodies.hpp"
#include "group_solver.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace higherpair {
namespace {

// More tries than this and only the nearer mode of each further group is looked at.
constexpr int kMaxTries = 20000;

constexpr std::size_t kMaxAssemblies = 4096;

const std::string& name_of_body(const Mechanism& mechanism, int index) {
  return mechanism.bodies[static_cast<std::size_t>(index)].name;
}

const Contact& contact_of(const Mechanism& mechanism, int index) {
  return mechanism.contacts[static_cast<std::size_t>(index)];
}

std::string explain(FindStatus status, const Contact& contact) {
  const std::string name = "contacts." + contact.name + ": ";
  switch (status) {
    case FindStatus::kOverlapAtStart:
      return name +
             "the two bodies overlap at the first driver position with the follower in its pose; move the "
             "pose away "
             "from the driver, or use approach = \"nearest\"";
    case FindStatus::kUnbounded:
      return name + "neither body is bounded, so that no safe step towards the contact exists";
    case FindStatus::kNoContact:
    case FindStatus::kFound:
      break;
  }
  return name + "the two bodies do not touch at the first driver position, " +
         (contact.approach == Approach::kNearest
              ? "wherever the follower stands; change driver.start or the pose of the follower"
              : "however far the follower is moved that way from its pose; change its approach or pose, or "
                "driver.start");
}

FindResult first_contact(const ContactPair& pair, Approach approach, double u, double q, double sign) {
  if (approach == Approach::kNearest) {
    return find_nearest_contact(pair, u, q);
  }
  const double sense = (approach == Approach::kPositive ? 1 : -1) * sign;
  return find_contact(pair, u, q, sense > 0 ? 1 : -1, false);
}

// Looks for the assembly of least cost, depth first: nearer modes first, and no further than the best so far.
class Assembler {
public:
  Assembler(Run& run) : run_(run), model_{run.mechanism, run.plan}, posed_(run.state) {}

  std::optional<StartFailure> run() {
    state_ = posed_;
    search(0, 0);
    if (best_cost_ == kNone) {
      return failure_;
    }
    run_.state = best_;
    return std::nullopt;
  }

  // Every assembly, not only the nearest.
  Assemblies run_all() {
    state_ = posed_;
    Assemblies found;
    all_ = &found;
    search(0, 0);
    return found;
  }

private:
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  void fail(std::size_t g, std::string reason) {
    // The reason of the group that came farthest.
    if (g >= failed_group_) {
      failed_group_ = g;
      failure_ = {std::move(reason), std::nullopt};
    }
  }

  // Squared distances of the joint points of a group's bodies from their places in the poses.
  [[nodiscard]] double cost_of(const Group& group) const {
    double cost = 0;
    for (const int index : group.joints) {
      const Joint& joint = run_.mechanism.joints[static_cast<std::size_t>(index)];
      for (const PointRef& ref : {joint.first, joint.second}) {
        const auto body = static_cast<std::size_t>(ref.body);
        const Vector2d p_B = point_of(run_.mechanism, ref);
        cost += (state_.bodies[body].X_WB * p_B - posed_.bodies[body].X_WB * p_B).squaredNorm();
      }
    }
    return cost;
  }

  void search(std::size_t g, double cost) {
    if (cost >= best_cost_ || (all_ != nullptr && !all_->complete)) {
      return;
    }
    if (g == run_.plan.groups.size() && all_ != nullptr) {
      all_->states.push_back(state_);
      all_->complete = all_->states.size() < kMaxAssemblies;
      return;
    }
    if (g == run_.plan.groups.size()) {
      best_cost_ = cost;
      best_ = state_;
      return;
    }
    const std::vector<int> modes = modes_of(g);
    struct Candidate {
      int mode;
      double cost;
    };
    std::vector<Candidate> candidates;
    for (const int mode : modes) {
      if (place(g, mode)) {
        candidates.push_back({mode, cost_of(run_.plan.groups[g])});
      }
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (++tries_ > kMaxTries && best_cost_ != kNone) {
        return;
      }
      if (candidates.size() > 1 || modes.size() > 1) {
        (void)place(g, candidates[i].mode);
      }
      search(g + 1, cost + candidates[i].cost);
    }
  }

  [[nodiscard]] std::vector<int> modes_of(std::size_t g) const {
    const GroupKind& kind = run_.plan.groups[g].kind;
    const bool two = std::holds_alternative<RrrDyad>(kind) || std::holds_alternative<RrpDyad>(kind) ||
                     std::holds_alternative<RprDyad>(kind);
    return two ? std::vector<int>{1, -1} : std::vector<int>{1};
  }

  bool place(std::size_t g, int mode) {
    const Group& group = run_.plan.groups[g];
    state_.groups[g].mode = mode;
    if (const auto* tracked = std::get_if<TrackedPair>(&group.kind)) {
      return start_tracked(*tracked, g);
    }
    if (const auto* touching = std::get_if<TouchingBody>(&group.kind)) {
      if (!start_touching(*touching, g)) {
        return false;
      }
    }
    if (std::holds_alternative<CoupledBodies>(group.kind)) {
      start_coupled(group);
    }
    std::optional<LimitPosition> limit;
    const State& from = std::holds_alternative<TouchingBody>(group.kind) ? touching_start_ : posed_;
    const GroupStatus status = starts_rolling(group)
                                   ? start_rolling_bodies(g)
                                   : place_group(model_, g, from, 0, run_.drivers, state_, limit);
    if (status != GroupStatus::kOk) {
      fail(g, unreachable(group));
      return false;
    }
    for (const int index : group.contacts) {
      const Contact& contact = contact_of(run_.mechanism, index);
      ContactMotion& motion = state_.contacts[static_cast<std::size_t>(index)];
      if (contact.rolling) {
        motion.arc_difference = arc_difference(run_.mechanism, contact, motion, state_.bodies);
      }
    }
    return true;
  }

  [[nodiscard]] bool starts_rolling(const Group& group) const {
    return std::holds_alternative<CoupledBodies>(group.kind) &&
           std::any_of(group.contacts.begin(), group.contacts.end(),
                       [&](int contact) { return contact_of(run_.mechanism, contact).rolling; });
  }

  // At the start there are no arcs yet: bodies that roll touch, and those that only rolling turns keep their
  // angles.
  GroupStatus start_rolling_bodies(std::size_t g) {
    const Group& group = run_.plan.groups[g];
    Mechanism slipping = run_.mechanism;
    for (const int contact : group.contacts) {
      slipping.contacts[static_cast<std::size_t>(contact)].rolling = false;
    }
    std::vector<int> held;
    std::copy_if(run_.plan.phase_bodies.begin(), run_.plan.phase_bodies.end(), std::back_inserter(held),
                 [&](int body) {
                   return std::find(group.bodies.begin(), group.bodies.end(), body) != group.bodies.end();
                 });
    return place_coupled({slipping, run_.plan}, g, posed_, 0, run_.drivers, state_, held);
  }

  std::string unreachable(const Group& group) const {
    std::string names;
    for (const int body : group.bodies) {
      names += (names.empty() ? "" : ", ") + name_of_body(run_.mechanism, body);
    }
    if (const auto* dyad = std::get_if<RrrDyad>(&group.kind)) {
      const double distance = (state_.bodies[static_cast<std::size_t>(dyad->A.body)].X_WB * dyad->A.p_B -
                               state_.bodies[static_cast<std::size_t>(dyad->B.body)].X_WB * dyad->B.p_B)
                                  .norm();
      const double reach = dyad->length_a + dyad->length_b;
      const bool far = distance > reach;
      const double limit = far ? reach : std::abs(dyad->length_a - dyad->length_b);
      return fmt::format(
          "bodies {} cannot be put together at the first driver position: their outer pins are {:.6g} times "
          "as far "
          "apart as the two links {}; change driver.start or the lengths",
          names, distance / limit, far ? "reach together" : "differ in length");
    }
    return fmt::format(
        "bodies {} cannot be put together at the first driver position near their poses; change "
        "driver.start, the "
        "dimensions or the poses",
        names);
  }

  bool start_tracked(const TrackedPair& tracked, std::size_t g) {
    const Contact& contact = contact_of(run_.mechanism, tracked.contact);
    const double u = tracked.driver_sign * run_.drivers[static_cast<std::size_t>(tracked.driver)];
    const double q = carried_coordinate(tracked.follower, posed_.bodies[0],
                                        posed_.bodies[static_cast<std::size_t>(tracked.follower.body)]);
    const FindResult found = first_contact(tracked.pair, contact.approach, u, q, tracked.follower.sign);
    if (contact.rolling) {
      if (!start_rolling_pair(tracked, g, u, q, found)) {
        return false;
      }
    } else if (found.status != FindStatus::kFound) {
      fail(g, explain(found.status, contact));
      return false;
    } else {
      state_.tracks[g] = start_track(tracked.pair, found.at, found.branch);
    }
    std::optional<LimitPosition> limit;
    const State from = state_;
    return place_group(model_, g, from, 0, run_.drivers, state_, limit) == GroupStatus::kOk;
  }

  bool start_rolling_pair(const TrackedPair& tracked, std::size_t g, double u, double q,
                          const FindResult& found) {
    const ContactPair& pair = tracked.pair;
    const Separation here = separation(pair.curve1, pose_at(pair.motion1, u), pair.curve2,
                                       pose_at(pair.motion2, q), 1e-6 * run_.plan.size);
    RollingTrack track;
    const RollingResult start = start_rolling(track, pair, u, q, here.n_W);
    if (start.converged && start.mismatch <= run_.tolerance * run_.plan.size) {
      state_.tracks[g] = track;
      return true;
    }
    const Contact& contact = contact_of(run_.mechanism, tracked.contact);
    if (found.status != FindStatus::kFound) {
      fail(g, explain(found.status, contact));
      return false;
    }
    fail(g, "contacts." + contact.name +
                ": this pair cannot roll; set rolling = false, or choose curves and joints whose contact "
                "point stays "
                "at the instant centre");
    failure_.slip =
        Slip{run_.drivers[static_cast<std::size_t>(tracked.driver)], found.at.sliding, tracked.contact};
    return false;
  }

  // Finds the contact of a body that hangs on bodies which stand; place_group then starts from it.
  bool start_touching(const TouchingBody& touching, std::size_t g) {
    const Contact& contact = contact_of(run_.mechanism, touching.contact);
    const CarriedBody& follower = touching.follower;
    touching_start_ = state_;
    const StandingPair placed = standing_pair(model_, touching, state_);
    const double posed =
        carried_coordinate(follower, posed_.bodies[static_cast<std::size_t>(follower.carrier)],
                           posed_.bodies[static_cast<std::size_t>(follower.body)]);
    const double turned =
        follower.freedom.turns ? state_.bodies[static_cast<std::size_t>(follower.carrier)].theta : 0;
    const FindResult found =
        first_contact(placed.pair, contact.approach, placed.u, posed + turned, follower.sign);
    if (found.status != FindStatus::kFound) {
      fail(g, explain(found.status, contact));
      return false;
    }
    state_.groups[g].mode = found.branch;
    touching_start_.bodies[static_cast<std::size_t>(follower.body)] =
        motion_at(placed.pair.motion2, found.at.q, 0, 0);
    ContactMotion& motion = touching_start_.contacts[static_cast<std::size_t>(touching.contact)];
    motion.at.n_W = touching.follower_is_second ? found.at.n_W : Vector2d(-found.at.n_W);
    motion.phi = angle_of(motion.at.n_W);
    return true;
  }

  // The common normal of the bodies in their poses is where Newton's method begins.
  void start_coupled(const Group& group) {
    for (const int index : group.contacts) {
      const Contact& contact = contact_of(run_.mechanism, index);
      const auto pose = [&](const CurveRef& ref) {
        const auto body = static_cast<std::size_t>(ref.body);
        const bool placed =
            std::find(group.bodies.begin(), group.bodies.end(), ref.body) == group.bodies.end();
        return (placed ? state_ : posed_).bodies[body].X_WB;
      };
      const Separation here =
          separation(curve_of(run_.mechanism, contact.first), pose(contact.first),
                     curve_of(run_.mechanism, contact.second), pose(contact.second), 1e-6 * run_.plan.size);
      ContactMotion& motion = posed_.contacts[static_cast<std::size_t>(index)];
      motion.at.n_W = here.n_W;
      motion.phi = angle_of(here.n_W);
    }
  }

  Run& run_;
  Assemblies* all_ = nullptr;
  Model model_;
  State posed_;
  State state_;
  State best_;
  State touching_start_;
  double best_cost_ = kNone;
  int tries_ = 0;
  std::size_t failed_group_ = 0;
  StartFailure failure_;
};

}  // namespace

namespace {

void prepare(Run& run) {
  run.state.bodies = posed_bodies(run.mechanism);
  run.state.contacts.resize(run.mechanism.contacts.size());
  run.state.groups.resize(run.plan.groups.size());
  run.state.tracks.resize(run.plan.groups.size());
}

}  // namespace

tl::expected<Run, StartFailure> planned_run(const Mechanism& mechanism, const std::vector<double>& drivers) {
  auto plan = make_plan(mechanism);
  if (!plan) {
    return tl::unexpected(StartFailure{plan.error(), std::nullopt});
  }
  Run run;
  run.mechanism = mechanism;
  run.plan = *std::move(plan);
  run.drivers = drivers;
  return run;
}

std::optional<StartFailure> assemble(Run& run) {
  prepare(run);
  return Assembler(run).run();
}

Assemblies assemble_all(Run& run) {
  prepare(run);
  return Assembler(run).run_all();
}

}  // namespace higherpair
