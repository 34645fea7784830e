// Open Dynamics Engine: solves all constraints at once (dWorldStep), first order in the step. In space, with
// all axes parallel. The crank is kinematic.
#include "linkage.hpp"

#ifdef PEERS_ODE
#include <cmath>
#include <ode/ode.h>

namespace higherpair::peers {
namespace {

constexpr double kPi = 3.14159265358979323846;

class OdeRun : public PeerRun {
public:
  explicit OdeRun(const Linkage& linkage) : slides_(linkage.slides) {
    static const int initialised = dInitODE2(0);
    (void)initialised;
    world_ = dWorldCreate();
    dWorldSetERP(world_, 0.8);
    dWorldSetCFM(world_, 1e-10);
    const Solution start = solution_at(linkage, 0);
    dBodyID crank = add({0, 0}, 0);
    dBodySetKinematic(crank);
    dBodySetAngularVel(crank, 0, 0, 1);
    const double link_angle = std::atan2(start.B.y - start.A.y, start.B.x - start.A.x);
    dBodyID link = add({(start.A.x + start.B.x) / 2, (start.A.y + start.B.y) / 2}, link_angle);
    angle_ = slides_ ? 0 : start.output.position;
    const Point middle = slides_ ? start.B : Point{(linkage.ground + start.B.x) / 2, start.B.y / 2};
    output_ = add(middle, angle_);
    hinge(crank, link, start.A);
    hinge(link, output_, start.B);
    if (slides_) {
      dJointID slide = dJointCreateSlider(world_, nullptr);
      dJointAttach(slide, output_, nullptr);
      dJointSetSliderAxis(slide, 1, 0, 0);
    } else {
      hinge(output_, nullptr, {linkage.ground, 0});
    }
  }

  ~OdeRun() override { dWorldDestroy(world_); }

  void step() override {
    dWorldStep(world_, 2 * kPi / kStepsPerTurn);
    const dReal* R = dBodyGetRotation(output_);
    angle_ += std::remainder(std::atan2(R[4], R[0]) - angle_, 2 * kPi);
  }

  [[nodiscard]] Output output() const override {
    return slides_ ? Output{dBodyGetPosition(output_)[0], dBodyGetLinearVel(output_)[0]}
                   : Output{angle_, dBodyGetAngularVel(output_)[2]};
  }

private:
  dBodyID add(const Point& at, double angle) {
    dBodyID body = dBodyCreate(world_);
    dBodySetPosition(body, at.x, at.y, 0);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 0, 0, 1, angle);
    dBodySetRotation(body, R);
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, 0.1, 0.1, 0.1, 0, 0, 0);
    dBodySetMass(body, &mass);
    return body;
  }

  void hinge(dBodyID a, dBodyID b, const Point& at) {
    dJointID joint = dJointCreateHinge(world_, nullptr);
    dJointAttach(joint, a, b);
    dJointSetHingeAnchor(joint, at.x, at.y, 0);
    dJointSetHingeAxis(joint, 0, 0, 1);
  }

  dWorldID world_ = nullptr;
  dBodyID output_ = nullptr;
  double angle_ = 0;
  bool slides_ = false;
};

}  // namespace

Peer ode() {
  return {"ODE", "libode-dev", [](const Linkage& linkage) -> std::unique_ptr<PeerRun> {
            return std::make_unique<OdeRun>(linkage);
          }};
}

}  // namespace higherpair::peers

#else

namespace higherpair::peers {

Peer ode() {
  return {"ODE", "libode-dev"};
}

}  // namespace higherpair::peers

#endif
