#include "assembly.hpp"

#include "analysis/tolerances.hpp"
#include "first_position.hpp"
#include "higherpair/analysis/branch_run.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

// After this many tries the search ends with the best assembly so far, if there is one.
constexpr int kMaxTries = 20000;

constexpr std::size_t kMaxAssemblies = 4096;

// How far the bodies of a group are turned from their poses, each at most 1. A lever that is turned by half a
// turn about its pivot, which a slide passes as well, has all its joint points where it had them.
double turned_from_poses(const Group& group, const std::vector<BodyMotion>& bodies,
                         const std::vector<BodyMotion>& posed) {
  double turned = 0;
  for (const int index : group.bodies) {
    const auto body = static_cast<std::size_t>(index);
    turned += (1 - std::cos(bodies[body].theta - posed[body].theta)) / 2;
  }
  return turned;
}

std::vector<int> modes_of(const Group& group) {
  return traits_of(group).two_modes ? std::vector<int>{1, -1} : std::vector<int>{1};
}

// A choice of groups of a plan.
using Groups = std::vector<bool>;

void add(const Groups& more, Groups& groups) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g] = groups[g] || more[g];
  }
}

// For each group, those with two modes on whose modes its place depends, directly or through known bodies.
std::vector<Groups> decisive_groups(const Mechanism& mechanism, const Plan& plan) {
  std::vector<Groups> decisive;
  std::vector<std::optional<std::size_t>> placed_by(mechanism.bodies.size());
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    const Group& group = plan.groups[g];
    Groups own(plan.groups.size());
    for_each_joined_body(mechanism, group, [&](int body) {
      if (const auto other = placed_by[body]) {
        add(decisive[*other], own);
        own[*other] = own[*other] || traits_of(plan.groups[*other]).two_modes;
      }
    });
    for (const int body : group.bodies) {
      placed_by[body] = g;
    }
    decisive.push_back(std::move(own));
  }
  return decisive;
}

// Depth-first search for the assembly of least cost: nearer modes first, and no deeper where the cost exceeds
// the best so far. Where a group cannot be placed, it goes back to the last group in whose other mode it
// might be: the modes of those in between do not matter (conflict-directed backjumping; P. Prosser, Hybrid
// algorithms for the constraint satisfaction problem, Computational Intelligence 9, 1993).
class Assembler {
public:
  explicit Assembler(Run& run)
      : run_(run), position_(run), decisive_(decisive_groups(run.mechanism(), run.plan())) {}

  std::optional<StartFailure> run() {
    search(0, 0);
    if (best_cost_ == kInf) {
      return position_.failure();
    }
    run_.at.state = best_;
    return std::nullopt;
  }

  // Finds every assembly, not only the nearest.
  Assemblies run_all() {
    all_.emplace();
    search(0, 0);
    return *std::move(all_);
  }

private:
  struct Candidate {
    int mode;
    double cost;
  };

  // Searches on from the groups before g in their places. If these places allow no assembly: the groups on
  // whose modes that depends. None where there is one, or where the search has been cut short.
  std::optional<Groups> search(std::size_t g, double cost) {
    if (cost >= best_cost_ || (all_ && !all_->complete) || is_stopped(run_)) {
      return std::nullopt;
    }
    if (g == run_.plan().groups.size()) {
      keep_assembly(cost);
      return std::nullopt;
    }
    const std::vector<Candidate> candidates = candidates_of(g);
    std::optional<Groups> blamed = decisive_[g];
    for (const Candidate& candidate : candidates) {
      if (++tries_ > kMaxTries && best_cost_ != kInf) {
        return std::nullopt;
      }
      if (traits_of(run_.plan().groups[g]).two_modes) {
        (void)position_.place(g, candidate.mode);
      }
      std::optional<Groups> beyond = search(g + 1, cost + candidate.cost);
      if (beyond && !(*beyond)[g]) {
        return beyond;
      }
      if (beyond && blamed) {
        add(*beyond, *blamed);
      } else {
        blamed.reset();
      }
    }
    if (blamed) {
      (*blamed)[g] = false;
    }
    return blamed;
  }

  void keep_assembly(double cost) {
    if (all_) {
      all_->states.push_back(position_.state());
      all_->complete = all_->states.size() < kMaxAssemblies;
    } else {
      best_cost_ = cost;
      best_ = position_.state();
    }
  }

  // The modes in which group g can be placed, the nearer to the poses first.
  std::vector<Candidate> candidates_of(std::size_t g) {
    const Group& group = run_.plan().groups[g];
    std::vector<Candidate> candidates;
    for (const int mode : modes_of(group)) {
      if (position_.place(g, mode)) {
        const auto& bodies = position_.state().bodies;
        const auto& posed = position_.posed().bodies;
        const double turned =
            kAsNear * run_.plan().size * run_.plan().size * turned_from_poses(group, bodies, posed);
        candidates.push_back({mode, distance_from_poses(run_.mechanism(), group, bodies, posed) + turned});
      }
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    return candidates;
  }

  Run& run_;
  FirstPosition position_;
  std::vector<Groups> decisive_;
  std::optional<Assemblies> all_;  // set if every assembly is wanted
  State best_;
  double best_cost_ = kInf;
  int tries_ = 0;
};

}  // namespace

double distance_from_poses(const Mechanism& mechanism, const Group& group,
                           const std::vector<BodyMotion>& bodies, const std::vector<BodyMotion>& posed) {
  double distance = 0;
  for (const int index : group.joints) {
    const Joint& joint = mechanism.joints[index];
    for (const PointRef& ref : {joint.first, joint.second}) {
      const auto body = static_cast<std::size_t>(ref.body);
      const Vector2d p_B = point_of(mechanism, ref);
      distance += (bodies[body].X_WB * p_B - posed[body].X_WB * p_B).squaredNorm();
    }
  }
  return distance;
}

int branch_count(const Plan& plan) {
  int modes = 0;
  for (const Group& group : plan.groups) {
    modes += traits_of(group).two_modes ? 1 : 0;
  }
  return 1 << std::min(modes, kMostBranchModes);
}

int branch_of(const Run& run) {
  int branch = 0;
  int bit = 0;
  for (std::size_t g = 0; g < run.plan().groups.size(); ++g) {
    if (traits_of(run.plan().groups[g]).two_modes && bit < kMostBranchModes) {
      branch |= (run.at.state.groups[g].mode < 0 ? 1 : 0) << bit++;
    }
  }
  return branch;
}

tl::expected<RunModel, StartFailure> planned_model(const Mechanism& mechanism) {
  auto plan = make_plan(mechanism);
  if (!plan) {
    return tl::unexpected(StartFailure{std::move(plan.error()), std::nullopt});
  }
  return make_run_model(mechanism, *std::move(plan));
}

tl::expected<Run, StartFailure> planned_run(const Mechanism& mechanism, const std::vector<double>& drivers) {
  return planned_model(mechanism).map([&](RunModel model) { return planned_run(std::move(model), drivers); });
}

Run planned_run(RunModel model, const std::vector<double>& drivers) {
  Run run;
  run.model = std::move(model);
  const auto& contacts = run.mechanism().contacts;
  if (std::any_of(contacts.begin(), contacts.end(), [](const Contact& one) { return one.by_boundary; })) {
    run.local = *run.model.mechanism;
  }
  run.at.inputs = drivers;
  return run;
}

std::optional<StartFailure> assemble(Run& run) {
  run.at.state = posed_state(run.mechanism(), run.plan(), 0);
  return Assembler(run).run();
}

State posed_state(const Mechanism& mechanism, const Plan& plan, int branch) {
  State state;
  state.bodies = posed_bodies(mechanism);
  state.turns.resize(state.bodies.size());
  state.contacts.resize(mechanism.contacts.size());
  state.groups.resize(plan.groups.size());
  state.tracks.resize(plan.groups.size());
  std::size_t k = 0;
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    if (traits_of(plan.groups[g]).two_modes) {
      state.groups[g].mode = mode_on(branch, k++);
    }
  }
  return state;
}

bool assemble_on(Run& run, int branch) {
  run.at.state = posed_state(run.mechanism(), run.plan(), branch);
  FirstPosition position(run);
  bool placed = true;
  for (std::size_t g = 0; placed && g < run.plan().groups.size(); ++g) {
    placed = position.place(g, run.at.state.groups[g].mode);
  }
  run.at.state = position.state();
  return placed;
}

Assemblies assemble_all(Run& run) {
  run.at.state = posed_state(run.mechanism(), run.plan(), 0);
  return Assembler(run).run_all();
}

}  // namespace higherpair
