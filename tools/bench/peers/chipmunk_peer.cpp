// Chipmunk: impulses by Gauss-Seidel iteration, first order in the step. The crank is kinematic.
#include "linkage.hpp"

#ifdef PEERS_CHIPMUNK
#include <chipmunk/chipmunk.h>
#include <cmath>

namespace higherpair::peers {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kIterations = 10;  // the default

cpVect vec(const Point& p) {
  return cpv(p.x, p.y);
}

class ChipmunkRun : public PeerRun {
public:
  explicit ChipmunkRun(const Linkage& linkage) : ChipmunkRun() {
    slides_ = linkage.slides;
    const Solution start = solution_at(linkage, 0);
    cpBody* crank = add_crank();
    const double link_angle = std::atan2(start.B.y - start.A.y, start.B.x - start.A.x);
    cpBody* link = add({(start.A.x + start.B.x) / 2, (start.A.y + start.B.y) / 2}, link_angle, 0.1);
    if (slides_) {
      output_ = add(start.B, 0, INFINITY);  // does not turn
      constraint(cpGrooveJointNew(cpSpaceGetStaticBody(space_), output_, cpv(-100, linkage.offset),
                                  cpv(100, linkage.offset), cpvzero));
    } else {
      output_ = add({(linkage.ground + start.B.x) / 2, start.B.y / 2}, start.output.position, 0.1);
      pin(cpSpaceGetStaticBody(space_), output_, {linkage.ground, 0});
    }
    pin(crank, link, start.A);
    pin(link, output_, start.B);
  }

  explicit ChipmunkRun(const Discs& discs) : ChipmunkRun() {
    disc(add_crank(), {discs.eccentricity, 0}, discs.cam);
    output_ = add({discs.ground, 0}, discs_at(discs, 0).position, 0.1);
    disc(output_, {discs.arm, 0}, discs.roller);
    pin(cpSpaceGetStaticBody(space_), output_, {discs.ground, 0});
    torque_ = 20;
  }

  ~ChipmunkRun() override {
    for (cpShape* shape : shapes_) cpShapeFree(shape);
    for (cpConstraint* constraint : constraints_) cpConstraintFree(constraint);
    for (cpBody* body : bodies_) cpBodyFree(body);
    cpSpaceFree(space_);
  }

  void step() override {
    if (torque_ != 0) cpBodySetTorque(output_, torque_);
    cpSpaceStep(space_, 2 * kPi / kStepsPerTurn);
  }

  [[nodiscard]] Output output() const override {
    return slides_ ? Output{cpBodyGetPosition(output_).x, cpBodyGetVelocity(output_).x}
                   : Output{cpBodyGetAngle(output_), cpBodyGetAngularVelocity(output_)};
  }

private:
  ChipmunkRun() : space_(cpSpaceNew()) {
    cpSpaceSetIterations(space_, kIterations);
    cpSpaceSetCollisionSlop(space_, 0);
  }

  cpBody* add_crank() {
    cpBody* crank = cpBodyNewKinematic();
    bodies_.push_back(cpSpaceAddBody(space_, crank));
    cpBodySetAngularVelocity(crank, 1);
    return crank;
  }

  cpBody* add(const Point& at, double angle, double inertia) {
    cpBody* body = cpSpaceAddBody(space_, cpBodyNew(1, inertia));
    bodies_.push_back(body);
    cpBodySetPosition(body, vec(at));
    cpBodySetAngle(body, angle);
    return body;
  }

  void constraint(cpConstraint* constraint) {
    constraints_.push_back(cpSpaceAddConstraint(space_, constraint));
  }

  void pin(cpBody* a, cpBody* b, const Point& at) {
    constraint(cpPivotJointNew2(a, b, cpBodyWorldToLocal(a, vec(at)), cpBodyWorldToLocal(b, vec(at))));
  }

  void disc(cpBody* body, const Point& center, double radius) {
    cpShape* shape = cpSpaceAddShape(space_, cpCircleShapeNew(body, radius, vec(center)));
    cpShapeSetFriction(shape, 0);
    shapes_.push_back(shape);
  }

  cpSpace* space_;
  std::vector<cpBody*> bodies_;
  std::vector<cpConstraint*> constraints_;
  std::vector<cpShape*> shapes_;
  cpBody* output_ = nullptr;
  double torque_ = 0;
  bool slides_ = false;
};

}  // namespace

Peer chipmunk() {
  return {
      "Chipmunk", "libchipmunk-dev",
      [](const Linkage& linkage) -> std::unique_ptr<PeerRun> {
        return std::make_unique<ChipmunkRun>(linkage);
      },
      [](const Discs& discs) -> std::unique_ptr<PeerRun> { return std::make_unique<ChipmunkRun>(discs); }};
}

}  // namespace higherpair::peers

#else

namespace higherpair::peers {

Peer chipmunk() {
  return {"Chipmunk", "libchipmunk-dev"};
}

}  // namespace higherpair::peers

#endif
