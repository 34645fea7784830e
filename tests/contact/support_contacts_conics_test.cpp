#include "contact/random_pair.hpp"
#include "contact/subdivision/support_contacts.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

// Compares two methods that share nothing: the algebra of the pencil, and enumeration over chains of spans.

namespace higherpair {
namespace {

double difference(double q1, double q2, bool turns) {
  return turns ? std::remainder(q1 - q2, 2 * kPi) : q1 - q2;
}

bool is_same(const CurveContact& a, const CurveContact& b, bool turns) {
  return a.opposed == b.opposed && std::abs(difference(a.q, b.q, turns)) <= 1e-9 * (1 + std::abs(a.q)) &&
         (a.p_W - b.p_W).norm() <= 1e-3 * (1 + a.p_W.norm());
}

bool is_singular(const CurveContact& contact) {
  return contact.at_limit || contact.conforming;
}

// Contacts farther out, where open conics and faces end or are too nearly straight, are not compared.
bool is_far(const CurveContact& contact, bool turns) {
  return contact.p_W.norm() > 100 || (!turns && std::abs(contact.q) > 100);
}

// Checks that each contact of one list is in the other; returns the largest difference of q near the
// mechanism.
double expect_same_contacts(const CurveContacts& found, const CurveContacts& algebraic, bool turns) {
  std::vector<bool> matched(found.contacts.size(), false);
  double worst = 0;
  bool left_open = false;
  bool may_be_open = false;
  for (const CurveContact& c : algebraic.contacts) {
    bool present = false;
    for (std::size_t i = 0; i < found.contacts.size() && !present; ++i) {
      if (!matched[i] && is_same(c, found.contacts[i], turns)) {
        present = matched[i] = true;
        EXPECT_EQ(c.branch, found.contacts[i].branch);
        EXPECT_EQ(c.free, found.contacts[i].free);
        const double off = std::abs(difference(c.q, found.contacts[i].q, turns));
        worst = c.p_W.norm() <= 30 ? std::max(worst, off / (1 + std::abs(c.q))) : worst;
      }
    }
    EXPECT_TRUE(present || is_singular(c) || is_far(c, turns)) << "missed: q = " << c.q;
    left_open = left_open || (!present && !is_far(c, turns));
    may_be_open = may_be_open || !present;
  }
  const bool complete = found.status == ContactsStatus::kComplete;
  EXPECT_TRUE(complete ? !left_open : may_be_open);
  for (std::size_t i = 0; i < matched.size(); ++i) {
    EXPECT_TRUE(matched[i]) << "not in the algebraic list: q = " << found.contacts[i].q;
  }
  return worst;
}

TEST(RandomConics, HaveTheContactsOfTheAlgebraicList) {
  for (int round = 0; round < 10; ++round) {
    SCOPED_TRACE(round);
    for (int i = 0; i < 36; ++i) {
      const auto random = testing::random_pair(static_cast<unsigned>(36 * round + i));
      SCOPED_TRACE(random.text);
      const CurveContacts algebraic = find_curve_contacts(random.pair, random.u);
      for (const CurveContact& contact : algebraic.contacts) {
        EXPECT_FALSE(is_singular(contact));
      }
      const double worst = expect_same_contacts(list_support_contacts(random.pair, random.u), algebraic,
                                                random.pair.motion2.turns);
      EXPECT_LE(worst, 1e-12);
    }
  }
}

// Small whole numbers: limits, coincidences, contacts at infinity.
TEST(RandomConics, MissNoContactOfADegeneratePair) {
  for (int round = 0; round < 10; ++round) {
    SCOPED_TRACE(round);
    for (int i = 0; i < 36; ++i) {
      const auto random = testing::grid_pair(static_cast<unsigned>(36 * round + i));
      SCOPED_TRACE(random.text);
      const CurveContacts algebraic = find_curve_contacts(random.pair, random.u);
      const CurveContacts found = list_support_contacts(random.pair, random.u);
      if (algebraic.status == ContactsStatus::kComplete) {
        expect_same_contacts(found, algebraic, random.pair.motion2.turns);
      } else {
        EXPECT_TRUE(found.contacts.empty());
        EXPECT_EQ(found.status == ContactsStatus::kComplete,
                  algebraic.status == ContactsStatus::kTouchesNowhere);
      }
    }
  }
}

}  // namespace
}  // namespace higherpair
