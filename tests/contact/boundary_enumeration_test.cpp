#include "higherpair/contact/boundary_enumeration.hpp"

#include "contact/random_boundaries.hpp"
#include "front/mirrored.hpp"
#include "higherpair/geometry/edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::RandomBoundaries;

constexpr double kFar = std::numeric_limits<double>::infinity();

// Forwards to another span, but has no bounds.
class SpanLike : public Span {
public:
  explicit SpanLike(SpanPtr span) : span_(std::move(span)) {}
  [[nodiscard]] SpanPoint at(double t) const override { return span_->at(t); }
  [[nodiscard]] Bounds range() const override { return span_->range(); }
  [[nodiscard]] bool is_corner() const override { return span_->is_corner(); }
  [[nodiscard]] int parts() const override { return span_->parts(); }

protected:
  SpanPtr span_;
};

// The same span, sampled more densely.
class DenseSpan final : public SpanLike {
public:
  DenseSpan(SpanPtr span, int times) : SpanLike(std::move(span)), times_(times) {}
  [[nodiscard]] int parts() const override { return times_ * span_->parts(); }

private:
  int times_;
};

// The same points in another unit of length.
class ScaledSpan final : public SpanLike {
public:
  ScaledSpan(SpanPtr span, double factor) : SpanLike(std::move(span)), factor_(factor) {}
  [[nodiscard]] SpanPoint at(double t) const override {
    const SpanPoint of = span_->at(t);
    const double speed = span_->is_corner() ? of.speed : of.speed * factor_;
    return {of.p_B * factor_, of.n_B, of.kappa / factor_, of.slope / (factor_ * factor_), speed};
  }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    auto of = span_->bounds(t);
    of->speed = {of->speed.low * factor_, of->speed.high * factor_};
    return of;
  }

private:
  double factor_;
};

// The boundary with each span wrapped in a `Like`, made from the span and a number.
template <class Like, class Number>
Boundary boundary_like(const Boundary& boundary, Number number, double size) {
  std::vector<SpanPtr> spans;
  for (const SpanPtr& span : boundary.spans()) {
    spans.push_back(std::make_shared<Like>(span, number));
  }
  return *Boundary::make(std::move(spans), boundary.is_closed(), size);
}

Boundary dense(const Boundary& boundary, int times) {
  return boundary_like<DenseSpan>(boundary, times, boundary.size());
}

Boundary scaled(const Boundary& boundary, double factor) {
  return boundary_like<ScaledSpan>(boundary, factor, boundary.size() * factor);
}

OneFreedom scaled(OneFreedom freedom, double factor) {
  freedom.p_WO *= factor;
  freedom.p_BO *= factor;
  return freedom;
}

OneFreedom slide_along(double direction, double beside) {
  OneFreedom slide;
  slide.turns = false;
  slide.direction_W = unit_vector(direction);
  slide.p_WO = beside * perp(slide.direction_W);
  return slide;
}

Boundary disc(double radius, const Vector2d& center = Vector2d::Zero()) {
  return boundary_of(*make_circle(center, radius), 1);
}

// A disc on an arm that turns about the origin lies on the level face y = -r where the arm points along the
// face.
TEST(BoundaryContacts, LieInTheHalfOpenTurn) {
  for (const double r : {0.007, 0.25}) {
    const double arm = 0.031;
    const Boundary face = *Boundary::make({face_span({0.1, -r}, {-0.1, -r})}, false, 1e-12);
    const Boundary disc = boundary_of(*make_circle({arm, 0}, r), 1);
    const auto contacts = find_boundary_contacts({&face, OneFreedom{}, &disc, OneFreedom{}}, 0);
    ASSERT_EQ(contacts.size(), 2U);
    EXPECT_EQ(contacts[0].q, 0);
    EXPECT_EQ(contacts[1].q, kPi);
  }
}

TEST(BoundaryEnumeration, ListsWhateverSamplesThirtyTimesAsDenseFind) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const double scale = std::pow(10, static_cast<double>(seed % 9) - 6);
    RandomBoundaries random(seed, scale);
    const Boundary first = random.boundary();
    const Boundary second = random.boundary();
    const Boundary dense1 = dense(first, 30);
    const Boundary dense2 = dense(second, 30);
    const OneFreedom cam = random.freedom();
    const OneFreedom follower = random.freedom();
    const double u = cam.turns ? random.between(-3, 3) : random.between(-1, 1) * scale;
    const BoundaryContacts all = enumerate_boundary_contacts({&first, cam, &second, follower}, u);
    EXPECT_TRUE(all.has_bounds);
    EXPECT_TRUE(all.undecided.empty()) << "seed " << seed;
    const auto expected = find_boundary_contacts({&dense1, cam, &dense2, follower}, u);
    ASSERT_EQ(all.contacts.size(), expected.size()) << "seed " << seed;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(all.contacts[i].q, expected[i].q, 1e-9 * (follower.turns ? 1 : scale)) << "seed " << seed;
    }
  }
}

TEST(BoundaryEnumeration, OfACopyInAnotherUnitIsTheSame) {
  for (unsigned seed = 1000; seed < 1060; ++seed) {
    RandomBoundaries random(seed, 1);
    const Boundary first = random.boundary();
    const Boundary second = random.boundary();
    const OneFreedom cam = random.freedom();
    const OneFreedom follower = random.freedom();
    const double u = random.between(-1, 1);
    const auto all = enumerate_boundary_contacts({&first, cam, &second, follower}, u);
    for (const double factor : {1e-6, 1e3}) {
      const Boundary copy1 = scaled(first, factor);
      const Boundary copy2 = scaled(second, factor);
      const auto copies = enumerate_boundary_contacts(
          {&copy1, scaled(cam, factor), &copy2, scaled(follower, factor)}, cam.turns ? u : factor * u);
      EXPECT_EQ(copies.undecided.size(), all.undecided.size()) << "seed " << seed;
      ASSERT_EQ(copies.contacts.size(), all.contacts.size()) << "seed " << seed;
      for (std::size_t i = 0; i < all.contacts.size(); ++i) {
        EXPECT_NEAR(copies.contacts[i].q, all.contacts[i].q * (follower.turns ? 1 : factor),
                    1e-9 * (follower.turns ? 1 : factor))
            << "seed " << seed;
      }
    }
  }
}

OneFreedom mirrored(OneFreedom freedom) {
  freedom.p_WO = testing::mirrored(freedom.p_WO);
  freedom.p_BO = testing::mirrored(freedom.p_BO);
  freedom.direction_W = testing::mirrored(freedom.direction_W);
  freedom.theta = -freedom.theta;
  freedom.R_WB = freedom.R_WB.inverse();
  return freedom;
}

TEST(BoundaryEnumeration, OfAMirroredCopyIsTheMirroredList) {
  for (unsigned seed = 2000; seed < 2060; ++seed) {
    RandomBoundaries random(seed, 1);
    const Boundary first = random.boundary();
    const Boundary second = random.boundary();
    const OneFreedom cam = random.freedom();
    const OneFreedom follower = random.freedom();
    const double u = random.between(-1, 1);
    const Boundary copy1 = testing::mirrored(first);
    const Boundary copy2 = testing::mirrored(second);
    const auto all = enumerate_boundary_contacts({&first, cam, &second, follower}, u);
    auto copies =
        enumerate_boundary_contacts({&copy1, mirrored(cam), &copy2, mirrored(follower)}, cam.turns ? -u : u);
    if (follower.turns) {
      std::reverse(copies.contacts.begin(), copies.contacts.end());
    }
    EXPECT_EQ(copies.undecided.size(), all.undecided.size()) << "seed " << seed;
    ASSERT_EQ(copies.contacts.size(), all.contacts.size()) << "seed " << seed;
    for (std::size_t i = 0; i < all.contacts.size(); ++i) {
      EXPECT_NEAR(copies.contacts[i].q, all.contacts[i].q * (follower.turns ? -1 : 1), 1e-10)
          << "seed " << seed;
    }
  }
}

// A roller that slides at almost the largest offset at which it can touch a disc: the contacts are 2 sqrt((R
// + r)² - e²) apart, so that for half of all directions both lie on the same part of the disc between
// samples.
TEST(BoundaryEnumeration, TellsContactsApartThatAreFarNearerThanTheSamples) {
  const Boundary cam = disc(0.03);
  const Boundary roller = disc(0.011);
  const double reach = 0.03 + 0.011;
  RandomBoundaries random(7, 1);
  int missed_by_samples = 0;
  for (const double apart : {1e-2, 1e-4, 1e-6}) {
    for (int k = 0; k < 20; ++k) {
      const double q = apart / 2 * reach;
      const OneFreedom slide = slide_along(random.between(-3, 3), std::sqrt(reach * reach - q * q));
      const BoundaryPair pair{&cam, OneFreedom{}, &roller, slide};
      const double u = random.between(-3, 3);
      const BoundaryContacts all = enumerate_boundary_contacts(pair, u);
      EXPECT_TRUE(all.undecided.empty()) << apart;
      ASSERT_EQ(all.contacts.size(), 2U) << apart;
      // The rounding of e² is divided by q.
      EXPECT_NEAR(all.contacts[0].q, -q, 1e-9 * q + 4e-15 * reach * reach / q) << apart;
      EXPECT_NEAR(all.contacts[1].q, q, 1e-9 * q + 4e-15 * reach * reach / q) << apart;
      missed_by_samples += find_boundary_contacts(pair, u).size() < 2 ? 1 : 0;
    }
  }
  EXPECT_GT(missed_by_samples, 10);
}

TEST(BoundaryEnumeration, LeavesOpenWhereContactsMerge) {
  const Boundary cam = disc(0.03);
  const Boundary roller = disc(0.011);
  for (const double direction : {0.2, 1.7, -2.3}) {
    const BoundaryContacts all =
        enumerate_boundary_contacts({&cam, OneFreedom{}, &roller, slide_along(direction, 0.041)}, 0.4);
    EXPECT_TRUE(all.has_bounds);
    ASSERT_EQ(all.undecided.size(), 1U);
    EXPECT_NEAR(all.undecided[0].low, 0, 1e-7);
    EXPECT_NEAR(all.undecided[0].high, 0, 1e-7);
    EXPECT_LE(all.contacts.size(), 1U);
  }
}

// Base circle, tangent, nose: the roller touches at a joint where the curvature jumps, and at the end of a
// corner.
TEST(BoundaryEnumeration, CountsAContactOnAJointOnce) {
  const double base = 0.02, nose = 0.008, distance = 0.025;
  const double t = std::acos((base - nose) / distance);
  const Vector2d C(distance, 0);
  for (const double radius : {nose, 0.0}) {
    const double side = std::acos((base - radius) / distance);
    std::vector<SpanPtr> spans;
    if (radius > 0) {
      spans.push_back(conic_span(*make_circle(C, radius), -t, t));
    }
    spans.push_back(face_span(C + radius * unit_vector(side), base * unit_vector(side)));
    spans.push_back(conic_span(*make_circle(Vector2d::Zero(), base), side, 2 * kPi - side));
    spans.push_back(face_span(base * unit_vector(-side), C + radius * unit_vector(-side)));
    const Boundary cam = *Boundary::make(std::move(spans), true, 1e-12);
    const Boundary roller = disc(0.01);
    const Vector2d nose_end = C + (radius + 0.01) * unit_vector(side);
    for (const double joint : {side, angle_of(nose_end)}) {
      for (const double sense : {1.0, -1.0}) {
        const BoundaryContacts all =
            enumerate_boundary_contacts({&cam, OneFreedom{}, &roller, slide_along(0, 0)}, -sense * joint);
        EXPECT_TRUE(all.undecided.empty()) << radius << " " << joint;
        ASSERT_EQ(all.contacts.size(), 2U) << radius << " " << joint;
        EXPECT_NEAR(all.contacts[1].q, joint == side ? base + 0.01 : nose_end.norm(), 1e-15);
      }
    }
  }
}

TEST(BoundaryEnumeration, LeavesOpenWhereFlatsLieOnEachOther) {
  const double a = 0.02;
  const Boundary square = *Boundary::make({face_span({-a, -a}, {a, -a}), face_span({a, -a}, {a, a}),
                                           face_span({a, a}, {-a, a}), face_span({-a, a}, {-a, -a})},
                                          true, 1e-12);
  const Boundary face = with_edges(boundary_of(*make_line({0, 0}, {0, -1}), 0.05));
  const BoundaryPair pair{&square, OneFreedom{}, &face, slide_along(kPi / 2, 0)};
  const BoundaryContacts flat = enumerate_boundary_contacts(pair, 0);
  ASSERT_EQ(flat.undecided.size(), 1U);
  EXPECT_TRUE(flat.undecided[0].contains(a));
  EXPECT_LT(flat.undecided[0].width(), 1e-12);
  const BoundaryContacts tilted = enumerate_boundary_contacts(pair, 0.1);
  EXPECT_TRUE(tilted.undecided.empty());
  ASSERT_EQ(tilted.contacts.size(), 1U);
  EXPECT_NEAR(tilted.contacts[0].q, a * (std::cos(0.1) + std::sin(0.1)), 1e-15);
}

// Two faces that the digits of a drawing have turned against each other by less than a corner: convex, where
// the roller touches at the joint and neither face has its normal; and concave, where it touches both.
TEST(BoundaryEnumeration, DoesNotOverlookAContactInTheGapOfAJoint) {
  for (const double kink : {3e-8, -3e-8, 3e-10, -3e-10, 3e-14, -3e-14}) {
    const double a = 0.03;
    const Boundary cam = *Boundary::make(
        {face_span(a * unit_vector(-kink / 2), {0, 0}), face_span({0, 0}, -a * unit_vector(kink / 2))}, false,
        1e-12);
    ASSERT_EQ(cam.spans().size(), 2U);
    const Boundary roller = disc(0.01);
    for (const double direction : {kPi / 2, 1.2}) {
      const BoundaryContacts all = enumerate_boundary_contacts(
          {&cam, OneFreedom{}, &roller, slide_along(direction, 0.01 * std::cos(direction))}, 0);
      const double q = 0.01 * std::sin(direction);
      EXPECT_TRUE(all.contacts.size() == 1 || !all.undecided.empty()) << kink;
      for (const BoundaryContact& contact : all.contacts) {
        EXPECT_NEAR(contact.q, q, 1e-9);
      }
      for (const Bounds& open : all.undecided) {
        EXPECT_NEAR(open.low, q, 1e-8);
        EXPECT_NEAR(open.high, q, 1e-8);
      }
      EXPECT_TRUE(std::abs(kink) > 1e-12 || all.undecided.empty()) << kink;
    }
  }
}

// A disc in a hollow of its own radius touches along the whole hollow.
TEST(BoundaryEnumeration, LeavesOpenWhereArcsLieOnEachOther) {
  const double r = 0.01, a = 0.03;
  std::vector<SpanPtr> spans = {face_span({a, 0}, {r, 0}),
                                conic_span(*make_circle({0, 0}, r, Side::kOutside), 0, kPi),
                                face_span({-r, 0}, {-a, 0})};
  const Boundary hollow = *Boundary::make(std::move(spans), false, 1e-12);
  const Boundary plug = disc(r);
  const BoundaryContacts all =
      enumerate_boundary_contacts({&hollow, OneFreedom{}, &plug, slide_along(kPi / 2, 0)}, 0);
  EXPECT_TRUE(std::any_of(all.undecided.begin(), all.undecided.end(),
                          [](const Bounds& q) { return q.low <= 1e-9 && q.high >= -1e-9; }));
}

TEST(BoundaryEnumeration, SaysOfAKindWithoutBoundsThatNothingIsProven) {
  const Boundary cam = disc(0.03);
  const Boundary plain = dense(cam, 1);
  const Boundary roller = disc(0.011);
  const auto proven = enumerate_boundary_contacts({&cam, {}, &roller, slide_along(0.3, 0.01)}, 0.4);
  const auto listed = enumerate_boundary_contacts({&plain, {}, &roller, slide_along(0.3, 0.01)}, 0.4);
  EXPECT_TRUE(proven.has_bounds);
  EXPECT_TRUE(proven.undecided.empty());
  EXPECT_FALSE(listed.has_bounds);
  ASSERT_EQ(listed.undecided.size(), 1U);
  EXPECT_EQ(listed.undecided[0].width(), kFar);
  EXPECT_EQ(listed.contacts.size(), proven.contacts.size());
}

}  // namespace
}  // namespace higherpair
