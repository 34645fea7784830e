#include "assembly.hpp"

#include "first_position.hpp"
#include "higherpair/analysis/branch_run.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

// Depth-first search for the assembly of least cost: nearer modes first, and no deeper where the cost exceeds
// the best so far.
class Assembler {
public:
  explicit Assembler(Run& run) : run_(run), position_(run) {}

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
  void search(std::size_t g, double cost) {
    if (cost >= best_cost_ || (all_ && !all_->complete)) {
      return;
    }
    if (g == run_.plan().groups.size() && all_) {
      all_->states.push_back(position_.state());
      all_->complete = all_->states.size() < kMaxAssemblies;
      return;
    }
    if (g == run_.plan().groups.size()) {
      best_cost_ = cost;
      best_ = position_.state();
      return;
    }
    const std::vector<int> modes = modes_of(g);
    struct Candidate {
      int mode;
      double cost;
    };
    std::vector<Candidate> candidates;
    for (const int mode : modes) {
      if (position_.place(g, mode)) {
        const Group& group = run_.plan().groups[g];
        const auto& bodies = position_.state().bodies;
        const auto& posed = position_.posed().bodies;
        const double turned =
            kAsNear * run_.plan().size * run_.plan().size * turned_from_poses(group, bodies, posed);
        candidates.push_back({mode, distance_from_poses(run_.mechanism(), group, bodies, posed) + turned});
      }
    }
    std::sort(candidates.begin(), candidates.end(),
              [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (++tries_ > kMaxTries && best_cost_ != kInf) {
        return;
      }
      if (candidates.size() > 1 || modes.size() > 1) {
        (void)position_.place(g, candidates[i].mode);
      }
      search(g + 1, cost + candidates[i].cost);
    }
  }

  [[nodiscard]] std::vector<int> modes_of(std::size_t g) const {
    return traits_of(run_.plan().groups[g]).two_modes ? std::vector<int>{1, -1} : std::vector<int>{1};
  }

  Run& run_;
  FirstPosition position_;
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
  run.at.drivers = drivers;
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
  int bit = 0;
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    if (traits_of(plan.groups[g]).two_modes && bit < kMostBranchModes) {
      state.groups[g].mode = ((branch >> bit++) & 1) == 0 ? 1 : -1;
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
