#include "higherpair/analysis/mapped_contacts.hpp"

#include "analysis/mechanism_builder.hpp"
#include "higherpair/contact/contact_map.hpp"
#include "support/texts.hpp"

#include <gmock/gmock.h>

namespace higherpair {
namespace {

using testing::Builder;
using testing::contains;
using ::testing::IsEmpty;

// A disc on a crank pushes the disc of an arm; the crank is driven.
struct Pair {
  Builder builder;
  int crank = builder.body("crank", {0, 0}, 0.2);
  int arm = builder.body("arm", {0.08, 0}, 2.5);

  explicit Pair(bool crank_second = true) {
    const int pivot = crank_second ? builder.revolute(0, crank, {0, 0}) : builder.revolute(crank, 0, {0, 0});
    (void)builder.revolute(0, arm, {0.08, 0});
    builder.mechanism.drivers.push_back({"", pivot});
    const Vector2d c1(0.01, 0);
    const Vector2d c2 = c1 + 0.035 * unit_vector(1.1);
    builder.contact(builder.circle(crank, c1, 0.02), builder.circle(arm, c2, 0.015));
  }
};

TEST(MappedContacts, HaveThePositionsOfTheMechanism) {
  const Pair pair;
  const auto mapped = mapped_contacts(pair.builder.mechanism, {0.2}, kDefaultClosure);
  ASSERT_TRUE(mapped);
  EXPECT_THAT(mapped->not_started, IsEmpty());
  const MappedContact& contact = mapped->contacts.at(0);
  ASSERT_THAT(contact.refusal, IsEmpty());
  EXPECT_EQ(contact.known.body, pair.crank);
  EXPECT_EQ(contact.follower.body, pair.arm);
  EXPECT_EQ(contact.driver, 0);
  EXPECT_NEAR(contact.u, 0.2, 1e-15);
  EXPECT_NEAR(contact.q.value(), 2.5, 1e-14);
  EXPECT_NEAR((contact.n_W - unit_vector(1.1)).norm(), 0, 1e-14);
  MapRange range;
  range.start = contact.u;
  const ContactMap map = map_contacts(contact.pair, range);
  EXPECT_TRUE(branch_of(map, contact.u, *contact.q, contact.n_W));
}

TEST(MappedContacts, TakeTheDriversSignFromItsJoint) {
  const Pair pair(false);
  const auto mapped = mapped_contacts(pair.builder.mechanism, {-0.2}, kDefaultClosure);
  ASSERT_TRUE(mapped);
  EXPECT_EQ(mapped->contacts.at(0).known.sign, -1);
  EXPECT_NEAR(mapped->contacts.at(0).u, 0.2, 1e-15);
}

TEST(MappedContacts, OfRollingBodiesAreRefused) {
  Pair pair;
  pair.builder.mechanism.contacts.front().rolling = true;
  const auto mapped = mapped_contacts(pair.builder.mechanism, {0.2}, kDefaultClosure);
  ASSERT_TRUE(mapped);
  EXPECT_TRUE(contains(mapped->contacts.at(0).refusal, "rolls"));
}

// A cam on the planet of a planetary gear with a fixed ring: gears join it to ground, but it turns on the
// arm.
TEST(MappedContacts, OfABodyThatGearsAloneJoinToGroundAreRefused) {
  Builder builder;
  const int arm = builder.body("arm", {0, 0}, 0);
  const int planet = builder.body("planet", {0.027, 0}, 0);
  const int follower = builder.body("follower", {0.043, 0}, 0);
  builder.drive(builder.revolute(0, arm, {0, 0}));
  (void)builder.revolute(arm, planet, {0.027, 0});
  Joint ring;
  ring.name = "ring";
  ring.type = JointType::kGears;
  ring.first = builder.point(0, {0, 0});
  ring.second = builder.point(planet, {0.027, 0});
  ring.carrier = arm;
  ring.turning_ratio = 4;
  builder.mechanism.joints.push_back(ring);
  (void)builder.prismatic(0, follower, {0.043, 0}, {1, 0}, -0.05);
  builder.contact(builder.circle(planet, {0.029, 0}, 0.009), builder.circle(follower, {0.043, 0}, 0.005));
  const auto mapped = mapped_contacts(builder.mechanism, {0}, kDefaultClosure);
  ASSERT_TRUE(mapped) << mapped.error();
  EXPECT_TRUE(
      contains(mapped->contacts.at(0).refusal, "planet has no revolute or prismatic joint to ground"));
}

TEST(MappedContacts, OfAMechanismThatLacksADriverSayWhatIsMissing) {
  Pair pair;
  const int loose = pair.builder.body("loose", {0.3, 0}, 0);
  (void)pair.builder.revolute(0, loose, {0.3, 0});
  const auto mapped = mapped_contacts(pair.builder.mechanism, {0.2}, kDefaultClosure);
  ASSERT_FALSE(mapped);
  EXPECT_TRUE(contains(mapped.error(), "driver"));
}

}  // namespace
}  // namespace higherpair
