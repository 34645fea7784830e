// Computes a row: the motion of all bodies with accelerations, residual and status.
#include "higherpair/analysis/run.hpp"
#include "higherpair/mechanism/description.hpp"
#include "linkage.hpp"

#include <cmath>

namespace higherpair::peers {
namespace {

class OwnRun : public PeerRun {
public:
  OwnRun(const Mechanism& mechanism, int output, bool slides)
      : run_(start_run(mechanism, {0}).value()), output_(static_cast<std::size_t>(output)), slides_(slides) {}

  void step() override {
    drivers_[0] = {2 * kPi * ++number_ / kStepsPerTurn, 1, 0};
    move_to(run_, drivers_);
  }

  [[nodiscard]] Output output() const override {
    const BodyMotion& body = run_.row.bodies[output_];
    return slides_ ? Output{body.X_WB.p_WB.x(), body.v_WB.x()} : Output{body.theta, body.omega};
  }

private:
  Run run_;
  std::vector<DriverMotion> drivers_{1};
  std::size_t output_;
  bool slides_;
  int number_ = 0;
};

std::unique_ptr<PeerRun> linkage_run(const Linkage& linkage) {
  const Solution start = solution_at(linkage, 0);
  Mechanism mechanism;
  const int crank = add_body(mechanism, "crank");
  const double link_angle = std::atan2(start.B.y - start.A.y, start.B.x - start.A.x);
  const int link = add_body(mechanism, "link", {start.A.x, start.A.y}, link_angle);
  const int last = linkage.slides ? add_body(mechanism, "block", {start.B.x, start.B.y})
                                  : add_body(mechanism, "rocker", {linkage.ground, 0}, start.output.position);
  const PointRef O = add_point(mechanism, kGround, "O", {0, 0});
  const int pivot = add_revolute(mechanism, "pivot", O, add_point(mechanism, crank, "O", {0, 0}));
  add_revolute(mechanism, "A", add_point(mechanism, crank, "A", {linkage.crank, 0}),
               add_point(mechanism, link, "A", {0, 0}));
  const PointRef B = add_point(mechanism, last, "B", {linkage.slides ? 0 : linkage.rocker, 0});
  add_revolute(mechanism, "B", add_point(mechanism, link, "B", {linkage.link, 0}), B);
  if (linkage.slides) {
    add_prismatic(mechanism, "slide", add_point(mechanism, kGround, "rail", {0, linkage.offset}), B, {1, 0});
  } else {
    add_revolute(mechanism, "rocker", add_point(mechanism, kGround, "Q", {linkage.ground, 0}),
                 add_point(mechanism, last, "Q", {0, 0}));
  }
  add_driver(mechanism, pivot);
  return std::make_unique<OwnRun>(mechanism, last, linkage.slides);
}

std::unique_ptr<PeerRun> discs_run(const Discs& discs) {
  Mechanism mechanism;
  const int cam = add_body(mechanism, "cam");
  const int arm = add_body(mechanism, "arm", {discs.ground, 0}, discs_at(discs, 0).position);
  const int pivot = add_revolute(mechanism, "pivot", add_point(mechanism, kGround, "O", {0, 0}),
                                 add_point(mechanism, cam, "O", {0, 0}));
  add_revolute(mechanism, "arm", add_point(mechanism, kGround, "Q", {discs.ground, 0}),
               add_point(mechanism, arm, "Q", {0, 0}));
  const CurveRef disc =
      add_curve(mechanism, cam, "disc", make_circle({discs.eccentricity, 0}, discs.cam).value());
  const CurveRef roller =
      add_curve(mechanism, arm, "roller", make_circle({discs.arm, 0}, discs.roller).value());
  add_contact(mechanism, "touch", disc, roller);
  add_driver(mechanism, pivot);
  return std::make_unique<OwnRun>(mechanism, arm, false);
}

}  // namespace

Peer this_library() {
  return {"higherpair", "", linkage_run, discs_run};
}

}  // namespace higherpair::peers
