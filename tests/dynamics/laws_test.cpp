// Laws that the reactions of any mechanism obey, on random mechanisms of many kinds: every single body obeys
// Newton's and Euler's equations, both ways to compute the driving effort agree, and the powers add up to the
// rate of the energy.
#include "dynamics/sketch.hpp"
#include "higherpair/dynamics/inverse_dynamics.hpp"
#include "higherpair/dynamics/reactions.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::Sketch;

using Maker = void (*)(Sketch&);

void four_bar(Sketch& s) {
  const int crank = s.body(), coupler = s.body(), rocker = s.body();
  const Vector2d A = s.near(0, 0), B = s.near(0.03, 0.1), C = s.near(0.25, 0.15), D = s.near(0.2, 0);
  s.drive(s.pin(0, crank, A));
  s.pin(crank, coupler, B);
  s.pin(rocker, coupler, C);
  s.pin(0, rocker, D);
}

void slider_crank_on_a_moving_guide(Sketch& s) {
  const int arm = s.body(), crank = s.body(), rod = s.body(), slider = s.body();
  s.drive(s.pin(0, arm, s.near(0, 0)));
  s.drive(s.pin(arm, crank, s.near(0.1, 0)));
  const Vector2d A = s.near(0.12, 0.08), B = s.near(0.3, 0.03);
  s.pin(crank, rod, A);
  s.pin(slider, rod, B);
  s.slide(slider, arm, B, s.number(-0.3, 0.3));
}

void shaper_with_a_slot(Sketch& s) {
  const int crank = s.body(), lever = s.body();
  const Vector2d pin = s.near(0.08, 0.05);
  s.drive(s.pin(0, crank, s.near(0, 0)));
  s.pin(lever, 0, s.near(0, -0.2));
  s.joint(JointType::kSlot, lever, crank, pin, s.number(0, 3));
}

void lift_by_a_cylinder(Sketch& s) {
  const int cylinder = s.body(), rod = s.body(), boom = s.body();
  s.pin(0, cylinder, s.near(0.1, 0));
  s.drive(s.slide(cylinder, rod, s.near(0.15, 0.1), s.number(0.8, 1.5)));
  s.pin(rod, boom, s.near(0.2, 0.2));
  s.pin(boom, 0, s.near(-0.1, 0.1));
}

void five_bar(Sketch& s) {
  const int left = s.body(), right = s.body(), a = s.body(), b = s.body();
  s.drive(s.pin(0, left, s.near(0, 0)));
  s.drive(s.pin(right, 0, s.near(0.2, 0)));
  const Vector2d C = s.near(0.1, 0.25);
  s.pin(left, a, s.near(-0.02, 0.1));
  s.pin(right, b, s.near(0.22, 0.1));
  s.pin(a, b, C);
}

void scotch_yoke(Sketch& s) {
  const int crank = s.body(), block = s.body(), yoke = s.body();
  const Vector2d A = s.near(0.05, 0.06);
  s.drive(s.pin(0, crank, s.near(0, 0)));
  s.pin(crank, block, A);
  s.slide(yoke, block, A, s.number(1.2, 1.9));
  s.slide(0, yoke, s.near(0.2, 0), s.number(-0.2, 0.2));
}

void cam_and_swinging_follower(Sketch& s) {
  const int cam = s.body(), follower = s.body();
  const Vector2d O = s.near(0, 0, 0.005);
  s.drive(s.pin(0, cam, O));
  s.pin(0, follower, s.near(0.16, 0));
  const CurveRef ellipse = s.curve(cam, make_ellipse(s.near(0.01, 0, 0.004), {0.04, 0.03}, 0.4));
  s.contact(ellipse, s.curve(follower, make_circle(Vector2d(0.03, 0.05), 0.02)));
}

void flat_follower_with_an_arm_behind(Sketch& s) {
  const int cam = s.body(), follower = s.body(), arm = s.body(), link = s.body();
  s.drive(s.pin(cam, 0, Vector2d(0, 0)));
  s.slide(follower, 0, Vector2d(0, 0.05), s.number(1.4, 1.7));
  const CurveRef face = s.curve(follower, make_line(Vector2d(0, 0.045), s.near(0, -1, 0.1)));
  s.contact(face, s.curve(cam, make_circle(s.near(0.01, 0, 0.004), 0.04)));
  s.pin(follower, link, s.near(0, 0.1));
  s.pin(link, arm, s.near(0.1, 0.2));
  s.pin(arm, 0, s.near(0.2, 0.1));
}

void follower_with_a_roller(Sketch& s) {
  const Vector2d Q(0.03, 0.05);
  const int cam = s.body(), follower = s.body(), roller = s.roller(Q);
  s.drive(s.pin(0, cam, Vector2d(0, 0)));
  s.pin(0, follower, s.near(0.16, 0));
  s.pin(follower, roller, Q);
  s.contact(s.curve(cam, make_ellipse(Vector2d(0.01, 0), {0.04, 0.03}, 0.4)),
            s.curve(roller, make_circle(Q, 0.02)));
}

void crank_with_a_roller(Sketch& s) {
  const Vector2d Q(0.03, 0.01);
  const int crank = s.body(), follower = s.body(), roller = s.roller(Q);
  s.drive(s.pin(0, crank, Vector2d(0, 0)));
  s.slide(0, follower, Vector2d(0, 0.05), s.number(1.4, 1.7));
  s.pin(crank, roller, Q);
  s.contact(s.curve(roller, make_circle(Q, 0.02)),
            s.curve(follower, make_line(Vector2d(0, 0.033), s.near(0, -1, 0.1))));
}

void coupler_driven_four_bar(Sketch& s) {
  const int left = s.body(), coupler = s.body(), right = s.body();
  s.pin(0, left, s.near(0, 0));
  s.drive(s.pin(left, coupler, s.near(0.03, 0.1)));
  s.pin(coupler, right, s.near(0.2, 0.15));
  s.pin(right, 0, s.near(0.25, 0));
}

struct Kind {
  const char* name;
  Maker make;
};

const Kind kKinds[] = {{"FourBar", four_bar},
                       {"SliderCrankOnAMovingGuide", slider_crank_on_a_moving_guide},
                       {"ShaperWithASlot", shaper_with_a_slot},
                       {"LiftByACylinder", lift_by_a_cylinder},
                       {"FiveBar", five_bar},
                       {"ScotchYoke", scotch_yoke},
                       {"CamAndSwingingFollower", cam_and_swinging_follower},
                       {"FlatFollowerWithAnArmBehind", flat_follower_with_an_arm_behind},
                       {"FollowerWithARoller", follower_with_a_roller},
                       {"CrankWithARoller", crank_with_a_roller},
                       {"CouplerDrivenFourBar", coupler_driven_four_bar}};

const Vector2d& p_of(const Mechanism& mechanism, const PointRef& ref) {
  return mechanism.bodies[ref.body].points[ref.point].p_B;
}

// Force and moment about the centre of mass that act on one body, summed independently.
struct Sum {
  Vector2d force = Vector2d::Zero();
  double moment = 0;
  double largest = 0;

  void add(const Vector2d& f, const Vector2d& arm) {
    force += f;
    moment += arm.x() * f.y() - arm.y() * f.x();
    largest = std::max(largest, f.norm());
  }
};

// Residual of Newton's and Euler's equations of one body, relative to the largest force.
class BodyBalance {
public:
  BodyBalance(const Run& run, const Reactions& reactions, int body)
      : run_(run), mechanism_(run.mechanism()), body_(body) {
    const auto& mass = mechanism_.bodies[body].mass;
    const PointMotion G = point_motion(motion(body), mass ? mass->center_of_mass_B : Vector2d(0.1, 0));
    G_ = G.p_W;
    if (mass) {
      sum_.add(mass->mass * (mechanism_.gravity_W - G.a_W), Vector2d::Zero());
      sum_.moment -= mass->inertia * motion(body).alpha;
    }
    add_loads();
    add_springs();
    add_joints(reactions);
    add_contacts(reactions);
  }

  [[nodiscard]] double left() const {
    return std::max(sum_.force.norm(), std::abs(sum_.moment) / run_.plan().size) / sum_.largest;
  }

private:
  [[nodiscard]] const BodyMotion& motion(int body) const { return run_.row.bodies[body]; }

  // A force on the second of two bodies, and its reaction on the first.
  void act(int first, int second, const Vector2d& force, const Vector2d& p) {
    if (second == body_) {
      sum_.add(force, p - G_);
    } else if (first == body_) {
      sum_.add(-force, p - G_);
    }
  }

  void turn(int first, int second, double moment) {
    sum_.moment += second == body_ ? moment : first == body_ ? -moment : 0;
  }

  void add_loads() {
    for (const Load& load : mechanism_.loads) {
      if (load.body == body_) {
        const Pose<double>& X = motion(body_).X_WB;
        sum_.add(load.frame == LoadFrame::kBody ? X.R_WB * load.force : load.force, X * load.p_B - G_);
        sum_.moment += load.torque;
      }
    }
  }

  // Adds a driver's effort along the coordinate of its joint.
  void drive(const Joint& joint, double effort) {
    if (joint.type == JointType::kRevolute) {
      turn(joint.first.body, joint.second.body, effort);
    } else {
      act(joint.first.body, joint.second.body,
          effort * (motion(joint.first.body).X_WB.R_WB * joint.direction_A),
          motion(joint.second.body).X_WB * p_of(mechanism_, joint.second));
    }
  }

  void add_springs() {
    for (const Spring& spring : mechanism_.springs) {
      if (spring.joint) {
        const Joint& joint = mechanism_.joints[*spring.joint];
        const JointMotion at = joint_motion_by_hand(joint);
        drive(joint, -spring.stiffness * (at.position - spring.free) - spring.damping * at.velocity);
        continue;
      }
      const PointMotion a = point_motion(motion(spring.first.body), p_of(mechanism_, spring.first));
      const PointMotion b = point_motion(motion(spring.second.body), p_of(mechanism_, spring.second));
      const Vector2d u = (b.p_W - a.p_W).normalized();
      const double tension =
          spring.stiffness * ((b.p_W - a.p_W).norm() - spring.free) + spring.damping * u.dot(b.v_W - a.v_W);
      // Each end is pulled at its own point.
      if (spring.first.body == body_) {
        sum_.add(tension * u, a.p_W - G_);
      }
      if (spring.second.body == body_) {
        sum_.add(-tension * u, b.p_W - G_);
      }
    }
  }

  struct JointMotion {
    double position = 0;
    double velocity = 0;
  };

  [[nodiscard]] JointMotion joint_motion_by_hand(const Joint& joint) const {
    const BodyMotion& first = motion(joint.first.body);
    const BodyMotion& second = motion(joint.second.body);
    if (joint.type == JointType::kRevolute) {
      return {second.theta - first.theta, second.omega - first.omega};
    }
    // Relative to the first body.
    const Vector2d p_A = first.X_WB.inverse_times(second.X_WB * p_of(mechanism_, joint.second));
    const Vector2d v_W =
        point_motion(second, p_of(mechanism_, joint.second)).v_W - point_motion(first, p_A).v_W;
    return {(p_A - p_of(mechanism_, joint.first)).dot(joint.direction_A),
            (first.X_WB.R_WB.inverse() * v_W).dot(joint.direction_A)};
  }

  void add_joints(const Reactions& reactions) {
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
      const Joint& joint = mechanism_.joints[i];
      const JointReaction& reaction = reactions.joints[i];
      act(joint.first.body, joint.second.body, {*reaction.fx, reaction.fy.value()},
          motion(joint.second.body).X_WB * p_of(mechanism_, joint.second));
      turn(joint.first.body, joint.second.body, reaction.moment.value_or(0));
    }
    for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) {
      drive(mechanism_.joints[mechanism_.drivers[i].joint], reactions.drivers[i].effort.value());
    }
  }

  void add_contacts(const Reactions& reactions) {
    for (std::size_t i = 0; i < mechanism_.contacts.size(); ++i) {
      const ContactMotion& contact = run_.row.contacts[i];
      act(mechanism_.contacts[i].first.body, mechanism_.contacts[i].second.body,
          reactions.contacts[i].force.value() * contact.at.n_W, contact.at.p1_W);
    }
  }

  const Run& run_;
  const Mechanism& mechanism_;
  int body_;
  Vector2d G_ = Vector2d::Zero();
  Sum sum_;
};

void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

class Laws : public ::testing::TestWithParam<Kind> {
protected:
  static constexpr int kSeeds = 12;

  // Calls check(run, drivers, reactions) at some rows of several random mechanisms.
  template <class Check>
  static void at_random_rows(Check check) {
    int rows = 0;
    for (unsigned seed = 1; seed <= kSeeds; ++seed) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed);
      Sketch sketch(seed);
      GetParam().make(sketch);
      sketch.load_randomly();
      auto run = start_run(sketch.mechanism, std::vector<double>(sketch.mechanism.drivers.size(), 0.0));
      if (!run) {
        continue;
      }
      InverseDynamics dynamics(*run);
      for (int k = 0; k < 5; ++k) {
        std::vector<DriverMotion> drivers;
        for (std::size_t i = 0; i < sketch.mechanism.drivers.size(); ++i) {
          drivers.push_back({0.01 * k * (i == 0 ? 1 : -0.7), sketch.number(-2, 2), sketch.number(-3, 3)});
        }
        move_to(*run, drivers);
        if (run->row.status != RowStatus::kOk) {
          break;
        }
        ++rows;
        const Reactions& reactions = dynamics.solve(*run);
        ASSERT_TRUE(reactions.defined);
        check(*run, drivers, reactions);
      }
    }
    EXPECT_GE(rows, 4 * kSeeds) << "too few mechanisms could be assembled to say anything";
  }
};

TEST_P(Laws, EveryBodyByItselfObeysNewtonAndEuler) {
  at_random_rows([](const higherpair::Run& run, const auto&, const Reactions& reactions) {
    for (std::size_t i = 1; i < run.mechanism().bodies.size(); ++i) {
      EXPECT_LE(BodyBalance(run, reactions, static_cast<int>(i)).left(), 1e-11) << "body " << i;
    }
  });
}

TEST_P(Laws, EffortsOfTheBalanceAreThoseOfVirtualPower) {
  at_random_rows([](const higherpair::Run&, const auto&, const Reactions& reactions) {
    double largest = 0;
    for (const DriverEffort& driver : reactions.drivers) {
      largest = std::max(largest, std::abs(driver.effort.value()));
    }
    for (const DriverEffort& driver : reactions.drivers) {
      EXPECT_NEAR(driver.effort.value(), driver.by_power.value(), 1e-10 * largest);
    }
  });
}

TEST_P(Laws, EffortsDoNotNeedTheMechanismToMove) {
  at_random_rows([](const higherpair::Run& run, const auto& drivers, const Reactions&) {
    higherpair::Run still = run;
    InverseDynamics dynamics(still);
    std::vector<DriverMotion> at_rest = drivers;
    for (DriverMotion& driver : at_rest) {
      driver.velocity = 0;
      driver.acceleration = 0;
    }
    move_to(still, at_rest);
    const Reactions& reactions = dynamics.solve(still);
    for (const DriverEffort& driver : reactions.drivers) {
      EXPECT_NEAR(driver.effort.value(), driver.by_power.value(),
                  1e-10 * (1 + std::abs(driver.effort.value())));
    }
  });
}

// Kinetic energy plus the potential energy of gravity and springs.
double energy(const Run& run) {
  const Mechanism& mechanism = run.mechanism();
  double sum = 0;
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    if (const auto& mass = mechanism.bodies[i].mass) {
      const PointMotion G = point_motion(run.row.bodies[i], mass->center_of_mass_B);
      const double omega = run.row.bodies[i].omega;
      sum += mass->mass * (G.v_W.squaredNorm() / 2 - mechanism.gravity_W.dot(G.p_W)) +
             mass->inertia * omega * omega / 2;
    }
  }
  for (Spring spring : mechanism.springs) {
    const double k = spring.stiffness;
    spring.stiffness = 1;
    spring.damping = 0;
    const double stretch = spring_tension(mechanism, spring, run.row.bodies);
    sum += k * stretch * stretch / 2;
  }
  return sum;
}

// Power of drivers, loads and dampers.
double power(const Run& run, const std::vector<DriverMotion>& drivers, const Reactions& reactions) {
  double sum = 0;
  for (std::size_t i = 0; i < drivers.size(); ++i) {
    sum += reactions.drivers[i].effort.value() * drivers[i].velocity;
  }
  for (const Load& load : run.mechanism().loads) {
    const BodyMotion& body = run.row.bodies[load.body];
    const Vector2d force = load.frame == LoadFrame::kBody ? body.X_WB.R_WB * load.force : load.force;
    sum += force.dot(point_motion(body, load.p_B).v_W) + load.torque * body.omega;
  }
  for (Spring spring : run.mechanism().springs) {
    spring.stiffness = 0;
    const double damping = spring_tension(run.mechanism(), spring, run.row.bodies);
    sum -= spring.damping > 0 ? damping * damping / spring.damping : 0;
  }
  return sum;
}

TEST_P(Laws, PowersSumUpToTheRateOfTheEnergy) {
  at_random_rows(
      [](const higherpair::Run& run, const std::vector<DriverMotion>& drivers, const Reactions& reactions) {
        higherpair::Run probe = run;
        const double h = 1e-4;
        const auto energy_at = [&](double t) {
          std::vector<DriverMotion> then = drivers;
          for (DriverMotion& driver : then) {
            driver.position += t * (driver.velocity + t / 2 * driver.acceleration);
            driver.velocity += t * driver.acceleration;
          }
          move_to(probe, then);
          return energy(probe);
        };
        const double rate = (energy_at(h) - energy_at(-h)) / (2 * h);
        double scale = 1;
        for (std::size_t i = 0; i < drivers.size(); ++i) {
          scale += std::abs(reactions.drivers[i].effort.value() * drivers[i].velocity);
        }
        // Error of central differences: h² times the third derivative.
        EXPECT_NEAR(power(run, drivers, reactions), rate, 3e-5 * scale);
      });
}

INSTANTIATE_TEST_SUITE_P(Kinds, Laws, ::testing::ValuesIn(kKinds),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace higherpair
