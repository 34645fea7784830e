#include "contact/freedoms.hpp"
#include "contact/pair_follower.hpp"
#include "contact/pair_jerk.hpp"
#include "contact/support_curves.hpp"
#include "contact/touch/stroke_end.hpp"
#include "higherpair/contact/certify.hpp"
#include "higherpair/contact/contact_map.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/contact/rolling.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/geometry/support.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Curves that are given by nothing but their support function pass through everything that follows a contact.

namespace higherpair {
namespace {

using testing::EllipseBySupport;
using testing::LobedCurve;
using testing::pivot;

OneFreedom slide(double x, double y) {
  OneFreedom freedom = pivot(x, y);
  freedom.turns = false;
  freedom.direction_W = Vector2d::UnitY();
  return freedom;
}

const Vector2d kCamCenter(0.008, 0.003);
const Vector2d kShoeCenter(-0.065, 0.002);

// The same pair in four forms: each of its curves as a conic or by its support.
struct Ovals {
  EllipseBySupport cam{kCamCenter, 0.030, 0.020, 0.26};
  EllipseBySupport shoe{kShoeCenter, 0.015, 0.010, 0.52};

  [[nodiscard]] ContactPair pair(bool support1, bool support2) const {
    const Curve cam_conic = make_ellipse(kCamCenter, {0.030, 0.020}, 0.26).value();
    const Curve shoe_conic = make_ellipse(kShoeCenter, {0.015, 0.010}, 0.52).value();
    return {support1 ? make_curve(cam) : cam_conic, pivot(0, 0), support2 ? make_curve(shoe) : shoe_conic,
            pivot(0.08, 0)};
  }
};

// Compares all quantities of a contact, to `tolerance` in their own units.
void expect_same(const ContactPosition& a, const ContactPosition& b, double tolerance) {
  const auto near = [&](double x, double y, double unit) {
    return std::abs(x - y) <= tolerance * (unit + std::abs(y));
  };
  EXPECT_TRUE(near(a.q, b.q, 1)) << a.q << " " << b.q;
  EXPECT_LE((a.n_W - b.n_W).norm(), 10 * tolerance);
  EXPECT_LE((a.p1_W - b.p1_W).norm(), tolerance);
  EXPECT_LE((a.p2_W - b.p2_W).norm(), tolerance);
  EXPECT_TRUE(near(a.rho1, b.rho1, 0.1)) << a.rho1 << " " << b.rho1;
  EXPECT_TRUE(near(a.rho2, b.rho2, 0.1)) << a.rho2 << " " << b.rho2;
  EXPECT_TRUE(near(a.dq, b.dq, 1)) << a.dq << " " << b.dq;
  EXPECT_TRUE(near(a.d2q, b.d2q, 10)) << a.d2q << " " << b.d2q;
  EXPECT_TRUE(near(a.dphi, b.dphi, 10)) << a.dphi << " " << b.dphi;
  EXPECT_TRUE(near(a.gap_q, b.gap_q, 0.1)) << a.gap_q << " " << b.gap_q;
}

TEST(CurvesByTheirSupport, AreFoundFollowedAndDifferentiatedAsTheConicsThatTheyAre) {
  const Ovals ovals;
  const ContactPair conics = ovals.pair(false, false);
  const FindResult wanted = find_nearest_contact(conics, 0, -0.6);
  ASSERT_EQ(wanted.status, FindStatus::kFound);
  for (const auto& [support1, support2] :
       {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
    const ContactPair pair = ovals.pair(support1, support2);
    const FindResult found = find_nearest_contact(pair, 0, -0.6);
    ASSERT_EQ(found.status, FindStatus::kFound);
    EXPECT_EQ(found.branch, wanted.branch);
    FollowedContact track = start_track(pair, found.at, found.branch);
    FollowedContact reference = start_track(conics, wanted.at, wanted.branch);
    const double arc0 = details_of(pair, track.at, track.phi).side1.arc -
                        details_of(conics, reference.at, reference.phi).side1.arc;
    for (int k = 1; k <= 72; ++k) {
      const double u = k * kPi / 36;
      ASSERT_EQ(follow_to(reference, u).status, TrackStatus::kOk);
      ASSERT_EQ(follow_to(track, u).status, TrackStatus::kOk);
      expect_same(track.at, reference.at, 1e-13);
      EXPECT_NEAR(slipping_jerk(pair, track.at)->d3q, slipping_jerk(conics, reference.at)->d3q,
                  1e-11 * (1 + std::abs(slipping_jerk(conics, reference.at)->d3q)));
      // Arcs are measured from another point, and continue over turns.
      EXPECT_NEAR(details_of(pair, track.at, track.phi).side1.arc,
                  details_of(conics, reference.at, reference.phi).side1.arc + arc0, 1e-14);
    }
  }
}

TEST(CurvesByTheirSupport, AreAsFarApartAsTheConicsThatTheyAre) {
  const Ovals ovals;
  const ContactPair conics = ovals.pair(false, false);
  const ContactPair pair = ovals.pair(true, true);
  const Curve ring_conic = make_ellipse(Vector2d(0.002, 0), {0.05, 0.04}, 0.3, Side::kOutside).value();
  const EllipseBySupport ring(Vector2d(0.002, 0), 0.05, 0.04, 0.3, true);
  ASSERT_EQ(make_curve(ring).side, Side::kOutside);
  for (int k = 0; k < 20; ++k) {
    const Pose<double> X_W1 = pose_at(pair.motion1, 0.4 * k);
    const Pose<double> X_W2 = pose_at(pair.motion2, 0.7 * k);
    const auto apart = [&](const Curve& one, const Curve& two) {
      return separation(one, X_W1, two, X_W2, 1e-12).gap;
    };
    EXPECT_NEAR(apart(pair.curve1, pair.curve2), apart(conics.curve1, conics.curve2), 2e-12);
    const auto in_ring = [&](const Curve& body, const Curve& around) {
      return separation(body, X_W1, around, Pose<double>{}, 1e-12).gap;
    };
    EXPECT_NEAR(in_ring(pair.curve1, make_curve(ring)), in_ring(conics.curve1, ring_conic), 2e-12);
  }
}

TEST(CurvesByTheirSupport, HaveTheirContactsListedBySubdivision) {
  const Ovals ovals;
  const CurveContacts wanted = find_curve_contacts(ovals.pair(false, false), 0.3);
  const CurveContacts found = find_curve_contacts(ovals.pair(true, false), 0.3);
  ASSERT_EQ(found.status, ContactsStatus::kComplete);
  ASSERT_EQ(found.contacts.size(), wanted.contacts.size());
  for (std::size_t i = 0; i < wanted.contacts.size(); ++i) {
    const CurveContact& a = found.contacts[i];
    const CurveContact& b = wanted.contacts[i];
    EXPECT_NEAR(a.q, b.q, 1e-12);
    EXPECT_EQ(a.u, 0.3);
    EXPECT_LE((a.p_W - b.p_W).norm(), 1e-13);
    EXPECT_EQ(a.opposed, b.opposed);
    EXPECT_EQ(a.branch, b.branch);
    EXPECT_EQ(a.free, b.free);
  }
}

TEST(CurvesByTheirSupport, SayWhereTheirListIsNotDecided) {
  // A disc about the follower's pivot touches at any angle of the follower.
  const EllipseBySupport disc(Vector2d::Zero(), 0.03, 0.03, 0);
  const ContactPair pair = {make_circle(Vector2d::Zero(), 0.05).value(), pivot(0, 0), make_curve(disc),
                            pivot(0.08, 0)};
  const CurveContacts found = find_curve_contacts(pair, 0);
  EXPECT_EQ(found.status, ContactsStatus::kUndecided);
  EXPECT_EQ(describe(found.status), "there are places at which it is not decided whether the curves touch");
}

TEST(CurvesByTheirSupport, HaveNoMapAndNoCertificateOfConics) {
  const Ovals ovals;
  const ContactPair pair = ovals.pair(true, false);
  const ContactMap map = map_contacts(pair, {});
  EXPECT_EQ(map.status, MapStatus::kNotAlgebraic);
  EXPECT_EQ(describe(map.status), "a curve that is given by its support function has no map");
  EXPECT_EQ(certify_contacts(pair, 0.3, find_curve_contacts(pair, 0.3)).status,
            CertificateStatus::kNotDecided);
}

TEST(CurvesByTheirSupport, RollAsTheEqualEllipsesThatTheyAre) {
  const EllipseBySupport ellipse(Vector2d(3, 0), 5, 4, 0);
  const ContactPair pair = {make_curve(ellipse), pivot(0, 0), make_curve(ellipse), pivot(10, 0)};
  RollingTrack track;
  ASSERT_TRUE(start_rolling(track, pair, 0, 0, Vector2d::UnitX()).converged);
  for (int k = 1; k <= 24; ++k) {
    const double u = k * kPi / 24;
    ASSERT_TRUE(roll_to(track, u).converged) << k;
    EXPECT_NEAR(track.at.q, -2 * std::atan2(4 * std::sin(u / 2), std::cos(u / 2)), 1e-12) << k;
  }
}

// Two-lobed ovals about their centres, 2a apart: r1(φ1) + r2(φ2) = 2a where the waist of one meets the lobe
// of the other, and dφ2/dφ1 = -r1/r2 integrates to tan φ2 = -(1 + e)/(1 - e) tan φ1, measured from a quarter
// turn.
TEST(TwoLobedOvals, RollOnEachOtherAboutTheirCentres) {
  for (const double e : {0.2, 0.3}) {
    const double a = 0.05;
    const testing::LobedOval oval(2, a * (1 - e * e), e);
    const ContactPair pair = {make_curve(oval), pivot(0, 0), make_curve(oval), pivot(2 * a, 0)};
    RollingTrack track;
    ASSERT_TRUE(start_rolling(track, pair, 0, kPi / 2, Vector2d::UnitX()).converged);
    EXPECT_NEAR(track.at.q, kPi / 2, 1e-12);
    double least = 10, most = 0;
    for (int k = 1; k <= 36; ++k) {
      const double u = k * kPi / 36;
      ASSERT_TRUE(roll_to(track, u).converged) << k;
      const double turned = std::atan2((1 + e) * std::sin(u), (1 - e) * std::cos(u));
      EXPECT_NEAR(track.at.q, kPi / 2 - turned, e < 0.25 ? 1e-12 : 1e-9) << k;
      EXPECT_NEAR(track.at.p_W().y(), 0, 1e-9 * a);
      EXPECT_NEAR(track.at.sliding, 0, 1e-9 * a);
      const double r = a * (1 - e * e) / (1 - e * std::cos(2 * u));
      EXPECT_NEAR(track.at.dq, -r / (2 * a - r), 1e-8);
      least = std::min(least, -track.at.dq);
      most = std::max(most, -track.at.dq);
    }
    if (e == 0.3) {
      EXPECT_NEAR(least, 0.538462, 5e-7);
      EXPECT_NEAR(most, 1.857143, 5e-7);
    }
  }
}

// h = a + b cos 3φ under a flat face: the lift is the support itself.
TEST(ALobedCamUnderAFlatFace, LiftsItByItsSupport) {
  const double a = 0.031, b = 0.002;
  const LobedCurve cam(a, b);
  const ContactPair pair = {make_curve(cam), pivot(0, 0),
                            make_line(Vector2d::Zero(), Vector2d(0, -1)).value(), slide(0, 0)};
  const FindResult found = find_contact(pair, 0, 0.1, -1);
  ASSERT_EQ(found.status, FindStatus::kFound);
  FollowedContact track = start_track(pair, found.at, found.branch);
  for (int k = 0; k <= 90; ++k) {
    const double u = k * kPi / 45;
    ASSERT_EQ(follow_to(track, u).status, TrackStatus::kOk);
    const double x = 3 * (kPi / 2 - u);
    EXPECT_NEAR(track.at.q, a + b * std::cos(x), 1e-16);
    EXPECT_NEAR(track.at.dq, 3 * b * std::sin(x), 1e-15);
    EXPECT_NEAR(track.at.d2q, -9 * b * std::cos(x), 1e-14);
    EXPECT_NEAR(slipping_jerk(pair, track.at)->d3q, -27 * b * std::sin(x), 1e-13);
  }
  const auto end = stroke_end(start_track(pair, found.at, found.branch), 0.9);
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->u, kPi / 6, 1e-13);
}

// The roller's centre lies on the pitch curve, the cam's parallel curve.
TEST(ALobedCamWithARoller, KeepsTheRollerTangent) {
  const double a = 0.031, b = 0.002, r = 0.006;
  const LobedCurve cam(a, b);
  const ContactPair pair = {make_curve(cam), pivot(0, 0), make_circle(Vector2d(-0.04, 0), r).value(),
                            pivot(0.05, 0.02)};
  const FindResult found = find_nearest_contact(pair, 0.1, -0.4);
  ASSERT_EQ(found.status, FindStatus::kFound);
  FollowedContact track = start_track(pair, found.at, found.branch);
  for (int k = 0; k <= 60; ++k) {
    const double u = 0.1 + k * kPi / 30;
    ASSERT_EQ(follow_to(track, u).status, TrackStatus::kOk);
    const double psi = angle_of(track.at.n_W) - u;
    const Vector2d n = track.at.n_W;
    const Vector2d p = (a + b * std::cos(3 * psi) + r) * n - 3 * b * std::sin(3 * psi) * perp(n);
    EXPECT_LE((pose_at(pair.motion2, track.at.q) * Vector2d(-0.04, 0) - p).norm(), 1e-15);
  }
}

// An open piece has a limited range of normals, and no points beyond it.
TEST(AnOpenPiece, HasPointsForItsOwnNormalsOnly) {
  const testing::InvoluteBySupport involute(0.02, {0.5, 2});
  const PlacedCurve<double> placed =
      place(make_curve(involute), Pose<double>{Rotation<double>::from_angle(0.3), Vector2d(0.01, 0)});
  EXPECT_TRUE(has_point(placed, unit_vector(0.3 + 1)));
  EXPECT_TRUE(has_point(placed, unit_vector(0.3 + 1 - 2 * kPi)));
  EXPECT_FALSE(has_point(placed, unit_vector(0.3 + 0.49)));
  EXPECT_FALSE(has_point(placed, unit_vector(0.3 + 2.01)));
  EXPECT_NEAR(support_point(placed, unit_vector(0.3 + 1)).rho, 0.02, 1e-17);
  EXPECT_EQ(radius_slope(placed, 0.02, unit_vector(0.3 + 1)), 0.02);
}

}  // namespace
}  // namespace higherpair
