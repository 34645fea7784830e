#include "contact/random_pair.hpp"
#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/contact/subdivision.hpp"

#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

constexpr double kFarReach = 1000;

double difference(double q1, double q2, bool turns) {
  return turns ? std::remainder(q1 - q2, 2 * kPi) : q1 - q2;
}

bool is_same(const CurveContact& algebraic, const CertifiedContact& certified, bool turns) {
  const double off = difference(algebraic.q, (certified.q_bounds.low + certified.q_bounds.high) / 2, turns);
  // Both are rounded to a double.
  const double rounding = 1e-15 * (1 + std::abs(algebraic.q));
  return algebraic.opposed == certified.opposed &&
         std::abs(off) <= certified.q_bounds.width() / 2 + rounding &&
         (algebraic.p_W - certified.p_W).norm() <= 1e-3 * (1 + algebraic.p_W.norm());
}

bool is_within(const CurveContact& algebraic, const PossibleContact& possible, bool turns) {
  const double middle = (possible.q.low + possible.q.high) / 2;
  const double off = difference(algebraic.q, middle, turns);
  return algebraic.opposed == possible.opposed && std::abs(off) <= possible.q.width() / 2 + 1e-12;
}

// Contacts farther out than the reach are not looked for.
bool is_out_of_reach(const testing::RandomPair& random, const CurveContact& c) {
  const Pose<double> X1 = pose_at(random.pair.motion1, random.u);
  const Pose<double> X2 = pose_at(random.pair.motion2, c.q);
  return (X1 * random.pair.curve1.vertex_B - c.p_W).norm() > kFarReach ||
         (X2 * random.pair.curve2.vertex_B - c.p_W).norm() > kFarReach;
}

// Each contact of one list is in the other; returns the worst difference of q of those near the mechanism.
double expect_same_contacts(const testing::RandomPair& random, const SubdivisionContacts& found,
                            const CurveContacts& algebraic) {
  const bool turns = random.pair.motion2.turns;
  std::vector<bool> matched(found.contacts.size(), false);
  double worst = 0;
  for (const CurveContact& c : algebraic.contacts) {
    bool present = false;
    for (std::size_t i = 0; i < found.contacts.size() && !present; ++i) {
      if (!matched[i] && is_same(c, found.contacts[i], turns)) {
        present = matched[i] = true;
        EXPECT_EQ(c.branch, found.contacts[i].branch);
        const double off = std::abs(difference(c.q, found.contacts[i].q, turns));
        worst = c.p_W.norm() <= 30 ? std::max(worst, off / (1 + std::abs(c.q))) : worst;
      }
    }
    for (const PossibleContact& possible : found.possible) present = present || is_within(c, possible, turns);
    EXPECT_TRUE(present || is_out_of_reach(random, c)) << "missed: q = " << c.q << ", opposed " << c.opposed;
  }
  for (std::size_t i = 0; i < matched.size(); ++i) {
    EXPECT_TRUE(matched[i]) << "not in the algebraic list: q = " << found.contacts[i].q;
  }
  return worst;
}

class RandomConics : public ::testing::TestWithParam<int> {};

TEST_P(RandomConics, HaveTheContactsOfTheAlgebraicList) {
  for (int i = 0; i < 36; ++i) {
    const auto random = testing::random_pair(static_cast<unsigned>(36 * GetParam() + i));
    SCOPED_TRACE(random.text);
    const SubdivisionContacts found = find_contacts_by_subdivision(random.pair, random.u, kFarReach);
    EXPECT_EQ(found.status, SubdivisionStatus::kComplete);
    const double worst = expect_same_contacts(random, found, find_curve_contacts(random.pair, random.u));
    EXPECT_LE(worst, 1e-12);
  }
}

// Small whole numbers: limits, coincidences, contacts at infinity. What is not certified is possible, in a
// few small places.
TEST_P(RandomConics, MissNoContactOfADegeneratePair) {
  for (int i = 0; i < 36; ++i) {
    const auto random = testing::grid_pair(static_cast<unsigned>(36 * GetParam() + i));
    SCOPED_TRACE(random.text);
    const CurveContacts algebraic = find_curve_contacts(random.pair, random.u);
    const SubdivisionContacts found = find_contacts_by_subdivision(random.pair, random.u, kFarReach);
    if (algebraic.status != ContactsStatus::kComplete) {
      EXPECT_TRUE(found.contacts.empty());
      EXPECT_EQ(found.possible.empty(), algebraic.status == ContactsStatus::kTouchesNowhere);
      continue;
    }
    EXPECT_NE(found.status, SubdivisionStatus::kExhausted);
    expect_same_contacts(random, found, algebraic);
    for (const PossibleContact& p : found.possible) {
      EXPECT_TRUE(std::any_of(algebraic.contacts.begin(), algebraic.contacts.end(),
                              [&](const CurveContact& c) {
                                return std::abs(difference(c.q, p.q.low, random.pair.motion2.turns)) <= 1e-4;
                              }))
          << "no contact near q = " << p.q.low;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Rounds, RandomConics, ::testing::Range(0, 10));

}  // namespace
}  // namespace higherpair
