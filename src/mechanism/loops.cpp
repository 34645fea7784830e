#include "higherpair/mechanism/loops.hpp"

#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/pins.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace higherpair {
namespace {

// A pin on a body.
struct PinOnBody {
  std::size_t pin = 0;
  Vector2d p_B = Vector2d::Zero();
};

// A pin that joins two bodies, and where it is on each of them.
struct SharedPin {
  std::size_t pin = 0;
  Vector2d on_one = Vector2d::Zero(), on_two = Vector2d::Zero();
};

class PinGraph {
public:
  explicit PinGraph(const Mechanism& mechanism) : pins_(find_pins(mechanism)), on_(mechanism.bodies.size()) {
    for (std::size_t i = 0; i < pins_.size(); ++i) {
      for (const BodyPoint& end : pins_[i].ends) {
        on_[end.body].push_back({i, end.p_B});
      }
    }
  }

  [[nodiscard]] const std::vector<PinOnBody>& on(int body) const { return on_[body]; }

  [[nodiscard]] const std::vector<BodyPoint>& bodies_at(std::size_t pin) const { return pins_[pin].ends; }

  // The pins that join two bodies.
  [[nodiscard]] std::vector<SharedPin> joining(int one, int two) const {
    std::vector<SharedPin> shared;
    for (const PinOnBody& a : on(one)) {
      for (const PinOnBody& b : on(two)) {
        if (a.pin == b.pin) {
          shared.push_back({a.pin, a.p_B, b.p_B});
        }
      }
    }
    return shared;
  }

private:
  std::vector<Pin> pins_;
  std::vector<std::vector<PinOnBody>> on_;
};

// Lowers distances of bodies, in joints from some of them, until none is more than a joint's step above
// another one's. No way leads through a body at a distance below 0.
void spread(const Mechanism& mechanism, double driven_step, std::vector<double>& distance) {
  const auto reach = [&](int from, int to, double step) {
    const double by = distance[from] + step;
    const bool nearer = distance[from] >= 0 && by < distance[to];
    if (nearer) distance[to] = by;
    return nearer;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
      const Joint& joint = mechanism.joints[i];
      if (couples_turning(joint.type)) {
        continue;
      }
      const double step = is_driven(mechanism, static_cast<int>(i)) ? driven_step : 1;
      changed = reach(joint.first.body, joint.second.body, step) || changed;
      changed = reach(joint.second.body, joint.first.body, step) || changed;
    }
  }
}

// How near bodies are to ground, a driven joint counting half, so that its body becomes link 2; and to the
// driven joints, by ways that do not lead over ground. Neither depends on the order of the file.
class Nearness {
public:
  explicit Nearness(const Mechanism& mechanism)
      : ground_(mechanism.bodies.size(), static_cast<double>(mechanism.bodies.size())), driver_(ground_) {
    ground_.front() = 0;
    spread(mechanism, 0.5, ground_);
    driver_.front() = -1;
    for (const Driver& driver : mechanism.drivers) {
      for (const int body :
           {mechanism.joints[driver.joint].first.body, mechanism.joints[driver.joint].second.body}) {
        if (body != kGround) driver_[body] = 0;
      }
    }
    spread(mechanism, 1, driver_);
  }

  [[nodiscard]] std::pair<double, double> of(int body) const { return {ground_[body], driver_[body]}; }

private:
  std::vector<double> ground_, driver_;
};

// A ring of four bodies and the distances between their two pins.
struct Ring {
  std::array<int, 4> body{};
  std::array<double, 4> length{};
};

// A body of a ring, between two of its pins.
struct Side {
  int body = 0;
  PinOnBody in;
  PinOnBody out;
};

Ring ring_of(const std::vector<Side>& chain) {
  Ring ring;
  for (std::size_t i = 0; i < 4; ++i) {
    ring.body[i] = chain[i].body;
    ring.length[i] = (chain[i].out.p_B - chain[i].in.p_B).norm();
  }
  return ring;
}

// Extends a chain of bodies across each other pin of its last body. Rings begin at their lowest body, in the
// sense in which the lower of its two neighbours comes first.
void go_round(const PinGraph& graph, int body, const PinOnBody& in, std::vector<Side>& chain,
              std::vector<Ring>& rings) {
  const bool last = chain.size() == 3;
  for (const PinOnBody& out : graph.on(body)) {
    const bool closes = !chain.empty() && out.pin == chain.front().in.pin;
    const bool used =
        std::any_of(chain.begin(), chain.end(), [&](const Side& side) { return side.out.pin == out.pin; });
    if (out.pin == in.pin || used || closes != last) {
      continue;
    }
    chain.push_back({body, in, out});
    if (last && chain[1].body < body) {
      rings.push_back(ring_of(chain));
    }
    for (const BodyPoint& next : graph.bodies_at(out.pin)) {
      const bool visited =
          std::any_of(chain.begin(), chain.end(), [&](const Side& side) { return side.body == next.body; });
      if (!last && !visited && next.body > chain.front().body) {
        go_round(graph, next.body, {out.pin, next.p_B}, chain, rings);
      }
    }
    chain.pop_back();
  }
}

std::vector<Ring> rings_from(const PinGraph& graph, int lowest) {
  std::vector<Ring> rings;
  std::vector<Side> chain;
  for (const PinOnBody& in : graph.on(lowest)) {
    go_round(graph, lowest, in, chain, rings);
  }
  return rings;
}

FourBarInMechanism as_four_bar(const Ring& ring, const Nearness& near) {
  const auto order_of = [&](std::size_t i) {
    return std::pair(near.of(ring.body[i % 4]), ring.length[i % 4]);
  };
  std::size_t ground = 0;
  for (std::size_t i = 1; i < 4; ++i) {
    ground = order_of(i) < order_of(ground) ? i : ground;
  }
  const std::size_t step = order_of(ground + 3) < order_of(ground + 1) ? 3 : 1;
  const auto at = [&](std::size_t k) { return (ground + k * step) % 4; };
  FourBarInMechanism found;
  found.ground = ring.body[at(0)];
  found.crank = ring.body[at(1)];
  found.coupler = ring.body[at(2)];
  found.rocker = ring.body[at(3)];
  found.linkage = {ring.length[at(0)], ring.length[at(1)], ring.length[at(2)], ring.length[at(3)], 0};
  return found;
}

// The line along which the point C of a body on a slide moves on the other body; p_G is where the joint's
// coordinate is 0.
struct GuideLine {
  Vector2d p_G = Vector2d::Zero();
  Vector2d along_G = Vector2d::UnitX();
};

GuideLine line_of(const CarriedBody& slider, const Vector2d& p_C) {
  const OneFreedom& freedom = slider.freedom;
  return {freedom.p_WO + freedom.R_WB * Vector2d(p_C - freedom.p_BO), freedom.direction_W};
}

SliderCrankInversion inversion_of(const SliderCrankInMechanism& found) {
  return found.guide == 0     ? SliderCrankInversion::kGuide
         : found.crank == 0   ? SliderCrankInversion::kCrank
         : found.coupler == 0 ? SliderCrankInversion::kCoupler
                              : SliderCrankInversion::kMoving;
}

// Adds the loops whose crank joins the guide to a pin of the coupler.
void add_cranks(const PinGraph& graph, const GuideLine& line, const Vector2d& p_C, std::size_t pin_C,
                const SliderCrankInMechanism& known, std::vector<SliderCrankInMechanism>& found) {
  for (const PinOnBody& A : graph.on(known.coupler)) {
    for (const BodyPoint& end : graph.bodies_at(A.pin)) {
      const int crank = end.body;
      if (A.pin == pin_C || crank == known.coupler || crank == known.guide || crank == known.slider) {
        continue;
      }
      for (const SharedPin& O : graph.joining(known.guide, crank)) {
        const double r2 = (end.p_B - O.on_two).norm();
        const double r3 = (p_C - A.p_B).norm();  // 0 where the point that runs in a slot is the pin A
        if (O.pin == A.pin || O.pin == pin_C || r3 == 0) {
          continue;
        }
        SliderCrankInMechanism loop = known;
        loop.crank = crank;
        loop.linkage = {r2, r3, cross(line.along_G, Vector2d(line.p_G - O.on_one)), 0};
        loop.inversion = inversion_of(loop);
        loop.at_foot = line.along_G.dot(O.on_one - line.p_G);
        loop.along_G = line.along_G;
        loop.coupler_AC = p_C - A.p_B;
        found.push_back(loop);
      }
    }
  }
}

void add_of_slide(const Mechanism& mechanism, const PinGraph& graph, const Nearness& near, int index,
                  std::vector<SliderCrankInMechanism>& found) {
  const Joint& joint = mechanism.joints[index];
  SliderCrankInMechanism known;
  known.joint = index;
  const bool first_guides = near.of(joint.first.body).first <= near.of(joint.second.body).first;
  known.guide = first_guides ? joint.first.body : joint.second.body;
  known.slider = first_guides ? joint.second.body : joint.first.body;
  const CarriedBody carried = carried_body(mechanism, joint, known.slider);
  for (const PinOnBody& C : graph.on(known.slider)) {
    for (const BodyPoint& end : graph.bodies_at(C.pin)) {
      if (end.body != known.slider && end.body != known.guide) {
        known.coupler = end.body;
        add_cranks(graph, line_of(carried, C.p_B), end.p_B, C.pin, known, found);
      }
    }
  }
}

}  // namespace

AssemblyMode mode_of(const SliderCrankInMechanism& loop, const std::vector<BodyMotion>& bodies) {
  const auto turned = [&](int body, const Vector2d& v_B) { return Vector2d(bodies[body].X_WB.R_WB * v_B); };
  const bool ahead = turned(loop.guide, loop.along_G).dot(turned(loop.coupler, loop.coupler_AC)) > 0;
  return ahead ? AssemblyMode::kPlus : AssemblyMode::kMinus;
}

std::vector<FourBarInMechanism> find_four_bars(const Mechanism& mechanism) {
  const PinGraph graph(mechanism);
  const Nearness near(mechanism);
  std::vector<FourBarInMechanism> found;
  for (int body = 0; body < static_cast<int>(mechanism.bodies.size()); ++body) {
    for (const Ring& ring : rings_from(graph, body)) {
      if (std::all_of(ring.length.begin(), ring.length.end(), [](double r) { return r > 0; })) {
        found.push_back(as_four_bar(ring, near));
      }
    }
  }
  return found;
}

std::vector<SliderCrankInMechanism> find_slider_cranks(const Mechanism& mechanism) {
  const PinGraph graph(mechanism);
  const Nearness near(mechanism);
  std::vector<SliderCrankInMechanism> found;
  for (int i = 0; i < static_cast<int>(mechanism.joints.size()); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.type == JointType::kPrismatic) {
      add_of_slide(mechanism, graph, near, i, found);
    } else if (joint.type == JointType::kSlot) {
      SliderCrankInMechanism known;
      known.joint = i;
      known.guide = joint.first.body;
      known.coupler = joint.second.body;
      add_cranks(graph, {point_of(mechanism, joint.first), joint.direction_A},
                 point_of(mechanism, joint.second), static_cast<std::size_t>(-1), known, found);
    }
  }
  return found;
}

}  // namespace higherpair
