#include "higherpair/contact/details.hpp"

#include "contact/freedoms.hpp"
#include "higherpair/contact/dwell_contact.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::pivot;
using testing::slide;

Curve circle_at(double x, double y, double radius, Side side = Side::kInside) {
  return make_circle({x, y}, radius, side).value();
}

// Two circles, where their normal is n_W; they need not touch.
ContactDetails details_between(const ContactPair& pair, double u, double q, double rho1, double rho2,
                               const Vector2d& n_W) {
  ContactPosition at;
  at.u = u;
  at.q = q;
  at.n_W = n_W;
  at.rho1 = rho1;
  at.rho2 = rho2;
  at.p1_W = pose_at(pair.motion1, u) * center(pair.curve1) + rho1 * n_W;
  at.p2_W = pose_at(pair.motion2, q) * center(pair.curve2) - rho2 * n_W;
  return details_of(pair, at, angle_of(n_W));
}

// The cranks are the arms of the centres, the coupler is as long as the centres are apart where the discs
// touch.
TEST(ContactDetails, OfDiscsOnPivotsHaveTheFourBar) {
  const Vector2d n_W = unit_vector(0.3);
  for (const bool ring : {false, true}) {
    const ContactPair pair = {circle_at(0.01, 0, 0.02), pivot(0, 0),
                              circle_at(-0.06, 0, 0.05, ring ? Side::kOutside : Side::kInside),
                              pivot(0.08, 0)};
    const ContactDetails details = details_between(pair, 1, 2, 0.02, ring ? -0.05 : 0.05, n_W);
    EXPECT_EQ(details.linkage, "four-bar");
    EXPECT_NEAR(details.lengths[0].value(), 0.08, 1e-16);
    EXPECT_NEAR(details.lengths[1].value(), 0.01, 1e-16);
    EXPECT_NEAR(details.lengths[2].value(), ring ? 0.05 - 0.02 : 0.05 + 0.02, 1e-16);
    EXPECT_NEAR(details.lengths[3].value(), 0.06, 1e-16);
  }
}

// A disc slides along x with its centre at the height 3, about a pivot at the height 5: on the left of the
// slide.
TEST(ContactDetails, OfASlidingAndATurningDiscHaveTheOffsetOfThePivot) {
  const OneFreedom along_x = slide(0, 3, 0), turn = pivot(7, 5);
  for (const bool slides_first : {false, true}) {
    const ContactPair pair = slides_first
                                 ? ContactPair{circle_at(0, 0, 1), along_x, circle_at(2, 0, 1), turn}
                                 : ContactPair{circle_at(2, 0, 1), turn, circle_at(0, 0, 1), along_x};
    const ContactDetails details = details_between(pair, 0.4, 0.7, 1, 1, unit_vector(0.2));
    EXPECT_EQ(details.linkage, "slider-crank");
    EXPECT_NEAR(details.lengths[0].value(), 2, 1e-15);
    EXPECT_NEAR(details.lengths[1].value(), 2, 1e-15);
    EXPECT_NEAR(details.lengths[2].value(), 2, 1e-15);
    EXPECT_FALSE(details.lengths[3]);
  }
}

// Where the centre is the pivot there is no arm to measure the angle from, whatever rounding makes of it.
TEST(ContactDetails, OfADiscAboutItsPivotHaveNoTransmissionAngle) {
  OneFreedom turn = pivot(0.1, 0.7);
  turn.p_BO = {0.3, 0.1};
  int rounded = 0;
  for (int k = 0; k < 20; ++k) {
    const ContactPair pair = {circle_at(0, 0, 0.2), pivot(0, 0), circle_at(0.3, 0.1, 0.2), turn};
    const ContactDetails details = details_between(pair, 0, 0.37 * k, 0.2, 0.2, unit_vector(1.1 * k));
    EXPECT_FALSE(details.transmission) << k;
    rounded += details.lengths[3].value() > 0 ? 1 : 0;
  }
  EXPECT_GT(rounded, 0);
}

// The point (0.3, 0.4) of a body that moves by (1, 0) and turns at 2: its velocity is (0.2, 0.6).
TEST(PressureAngle, OfABodyWithoutAJointToGroundIsThatOfItsVelocity) {
  BodyMotion body;
  body.v_WB = {1, 0};
  body.omega = 2;
  EXPECT_NEAR(pressure_angle(body, nullptr, {0.3, 0.4}, Vector2d::UnitX()).value(), std::atan(3.0), 1e-15);
  EXPECT_FALSE(pressure_angle({}, nullptr, {0.3, 0.4}, Vector2d::UnitX()));
}

// A disc about its centre, over which another one slides at right angles to the normal.
TEST(DwellContact, IsOneOfCurvesThatTouchToWithinTheTolerance) {
  for (const double gap : {1e-7, -1e-7, 1e-5, -1e-5}) {
    const ContactPair pair = {circle_at(0, 0, 1), pivot(0, 0), circle_at(0, 0, 0.5), slide(0, 1.5 + gap, 0)};
    EXPECT_EQ(dwell_contact(pair, 0, 0, 1e-6).has_value(), std::abs(gap) < 1e-6) << gap;
  }
}

}  // namespace
}  // namespace higherpair
