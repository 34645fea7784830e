// Simbody: exact. The crank's motion is prescribed, and the loop is closed by a point on a line across the
// plane. Each step projects the positions onto the constraints and computes velocities and accelerations.
#include "linkage.hpp"

#ifdef PEERS_SIMBODY
#include <Simbody.h>
#include <cmath>

namespace higherpair::peers {
namespace {

constexpr double kPrecision = 1e-12;  // of the projection

// Prescribes an angle equal to the time.
class UnitSpeed : public SimTK::Motion::Custom::Implementation {
public:
  [[nodiscard]] SimTK::Motion::Level getLevel(const SimTK::State& /*state*/) const override {
    return SimTK::Motion::Position;
  }
  void calcPrescribedPosition(const SimTK::State& state, int /*count*/, SimTK::Real* q) const override {
    q[0] = state.getTime();
  }
  void calcPrescribedPositionDot(const SimTK::State& /*state*/, int /*count*/,
                                 SimTK::Real* rate) const override {
    rate[0] = 1;
  }
  void calcPrescribedPositionDotDot(const SimTK::State& /*state*/, int /*count*/,
                                    SimTK::Real* acceleration) const override {
    acceleration[0] = 0;
  }
};

class SimbodyRun : public PeerRun {
public:
  explicit SimbodyRun(const Linkage& linkage) : matter_(system_), slides_(linkage.slides) {
    using namespace SimTK;
    const Solution start = solution_at(linkage, 0);
    const Body::Rigid body(MassProperties(1, Vec3(0), Inertia(0.1)));
    MobilizedBody::Pin crank(matter_.Ground(), Transform(), body, Transform());
    Motion::Custom(crank, new UnitSpeed);  // takes ownership
    MobilizedBody::Pin link(crank, Transform(Vec3(linkage.crank, 0, 0)), body, Transform());
    const double link_angle = std::atan2(start.B.y - start.A.y, start.B.x - start.A.x);
    Vec3 end(linkage.slides ? 0 : linkage.rocker, 0, 0);
    if (slides_) {
      output_ =
          MobilizedBody::Slider(matter_.Ground(), Transform(Vec3(0, linkage.offset, 0)), body, Transform());
    } else {
      output_ =
          MobilizedBody::Pin(matter_.Ground(), Transform(Vec3(linkage.ground, 0, 0)), body, Transform());
    }
    Constraint::PointOnLine(output_, UnitVec3(0, 0, 1), end, link, Vec3(linkage.link, 0, 0));
    state_ = system_.realizeTopology();
    system_.realizeModel(state_);
    crank.setOneQ(state_, 0, 0);
    link.setOneQ(state_, 0, link_angle);
    output_.setOneQ(state_, 0, start.output.position);
    solve();
  }

  void step() override {
    // Extrapolate from the rates, so that the projection starts close to the solution.
    const double h = 2 * SimTK::Pi / kStepsPerTurn;
    state_.updQ() += h * state_.getQDot() + h * h / 2 * state_.getQDotDot();
    state_.setTime(2 * SimTK::Pi * ++number_ / kStepsPerTurn);
    solve();
  }

  [[nodiscard]] Output output() const override {
    return {output_.getOneQ(state_, 0), output_.getOneU(state_, 0)};
  }

private:
  void solve() {
    using namespace SimTK;
    ProjectOptions options(kPrecision);
    options.setOption(ProjectOptions::ForceProjection);
    ProjectResults results;
    Vector no_estimate;
    system_.realize(state_, Stage::Time);
    system_.prescribeQ(state_);
    system_.realize(state_, Stage::Position);
    system_.projectQ(state_, no_estimate, options, results);
    system_.prescribeU(state_);
    system_.realize(state_, Stage::Velocity);
    system_.projectU(state_, no_estimate, options, results);
    system_.realize(state_, Stage::Acceleration);
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::MobilizedBody output_;
  SimTK::State state_;
  int number_ = 0;
  bool slides_;
};

}  // namespace

Peer simbody() {
  return {"Simbody", "libsimbody-dev", [](const Linkage& linkage) -> std::unique_ptr<PeerRun> {
            return std::make_unique<SimbodyRun>(linkage);
          }};
}

}  // namespace higherpair::peers

#else

namespace higherpair::peers {

Peer simbody() {
  return {"Simbody", "libsimbody-dev"};
}

}  // namespace higherpair::peers

#endif
