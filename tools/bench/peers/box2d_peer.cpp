// Box2D: impulses by Gauss-Seidel iteration, first order in the step. The crank is kinematic and so turns
// exactly.
#include "linkage.hpp"

#ifdef PEERS_BOX2D
#include <box2d/box2d.h>
#include <cmath>

namespace higherpair::peers {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kVelocityIterations = 8;  // as the manual recommends
constexpr int kPositionIterations = 3;

b2Vec2 vec(const Point& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

class Box2dRun : public PeerRun {
public:
  explicit Box2dRun(const Linkage& linkage) : slides_(linkage.slides) {
    const Solution start = solution_at(linkage, 0);
    b2Body* crank = add(b2_kinematicBody, {0, 0}, 0);
    const double link_angle = std::atan2(start.B.y - start.A.y, start.B.x - start.A.x);
    b2Body* link =
        add(b2_dynamicBody, {(start.A.x + start.B.x) / 2, (start.A.y + start.B.y) / 2}, link_angle);
    const double angle = slides_ ? 0 : start.output.position;
    const Point middle = slides_ ? start.B : Point{(linkage.ground + start.B.x) / 2, start.B.y / 2};
    output_ = add(b2_dynamicBody, middle, angle);
    pin(crank, link, start.A);
    pin(link, output_, start.B);
    if (slides_) {
      b2PrismaticJointDef slide;
      slide.Initialize(ground(), output_, vec(start.B), {1, 0});
      world_.CreateJoint(&slide);
    } else {
      pin(ground(), output_, {linkage.ground, 0});
    }
  }

  explicit Box2dRun(const Discs& discs) {
    b2Body* cam = add(b2_kinematicBody, {0, 0}, 0);
    disc(cam, {discs.eccentricity, 0}, discs.cam);
    const double angle = discs_at(discs, 0).position;
    output_ = add(b2_dynamicBody, {discs.ground, 0}, angle);
    disc(output_, {discs.arm, 0}, discs.roller);
    pin(ground(), output_, {discs.ground, 0});
    torque_ = 20;  // turns the arm towards the cam
  }

  void step() override {
    if (torque_ != 0) {
      output_->ApplyTorque(static_cast<float>(torque_), true);
    }
    world_.Step(static_cast<float>(2 * kPi / kStepsPerTurn), kVelocityIterations, kPositionIterations);
  }

  [[nodiscard]] Output output() const override {
    return slides_ ? Output{output_->GetPosition().x, output_->GetLinearVelocity().x}
                   : Output{output_->GetAngle(), output_->GetAngularVelocity()};
  }

private:
  b2Body* ground() {
    if (ground_ == nullptr) {
      const b2BodyDef definition;
      ground_ = world_.CreateBody(&definition);
    }
    return ground_;
  }

  b2Body* add(b2BodyType type, const Point& at, double angle) {
    b2BodyDef definition;
    definition.type = type;
    definition.position = vec(at);
    definition.angle = static_cast<float>(angle);
    definition.angularVelocity = type == b2_kinematicBody ? 1 : 0;
    definition.allowSleep = false;
    b2Body* body = world_.CreateBody(&definition);
    const b2MassData mass{1, {0, 0}, 0.1F};
    body->SetMassData(&mass);
    return body;
  }

  void pin(b2Body* a, b2Body* b, const Point& at) {
    b2RevoluteJointDef joint;
    joint.Initialize(a, b, vec(at));
    world_.CreateJoint(&joint);
  }

  static void disc(b2Body* body, const Point& center, double radius) {
    b2CircleShape shape;
    shape.m_p = vec(center);
    shape.m_radius = static_cast<float>(radius);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = 0;
    fixture.density = 0.1F;
    body->CreateFixture(&fixture);
  }

  b2World world_{{0, 0}};
  b2Body* ground_ = nullptr;
  b2Body* output_ = nullptr;
  double torque_ = 0;
  bool slides_ = false;
};

}  // namespace

Peer box2d() {
  return {
      "Box2D", "libbox2d-dev",
      [](const Linkage& linkage) -> std::unique_ptr<PeerRun> { return std::make_unique<Box2dRun>(linkage); },
      [](const Discs& discs) -> std::unique_ptr<PeerRun> { return std::make_unique<Box2dRun>(discs); }};
}

}  // namespace higherpair::peers

#else

namespace higherpair::peers {

Peer box2d() {
  return {"Box2D", "libbox2d-dev"};
}

}  // namespace higherpair::peers

#endif
