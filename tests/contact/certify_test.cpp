#include "higherpair/contact/certify.hpp"

#include "contact/oracle_case.hpp"
#include "contact/random_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::OracleCase;

TEST(CertifyOracle, AgreesWithTheListAndHoldsEachContactInAnInterval) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    SCOPED_TRACE(reference.id);
    const double u = reference.data.at("th1_start_deg").get<double>() * kPi / 180;
    const CurveContacts list = find_curve_contacts(reference.pair, u);
    const Certificate certificate = certify_contacts(reference.pair, u, list);
    EXPECT_EQ(certificate.status, CertificateStatus::kCertified);
    ASSERT_EQ(certificate.intervals.size(), list.contacts.size());
    for (std::size_t i = 0; i < list.contacts.size(); ++i) {
      ASSERT_TRUE(certificate.intervals[i].has_value());
      const auto [low, high] = *certificate.intervals[i];
      EXPECT_LE(low, list.contacts[i].q);
      EXPECT_GE(high, list.contacts[i].q);
      EXPECT_LE(high - low, 1e-10 * (1 + std::abs(low)));
    }
  }
}

TEST(CertifyOracle, HoldsTheAnswerForTheDecimalsOfTheFileInAnInterval) {
  for (const OracleCase& reference : testing::oracle_cases()) {
    SCOPED_TRACE(reference.id);
    // The reference is solved with the decimals as written; the pair holds the nearest doubles.
    const nlohmann::json& row = reference.data.at("rows").at(0);
    const double u = row.at("th1_deg").get<double>() * kPi / 180;
    const CurveContacts list = find_curve_contacts(reference.pair, u);
    const Certificate certificate = certify_contacts(reference.pair, u, list);
    const double q =
        row.at("q2").is_string() ? std::stod(row.at("q2").get<std::string>()) : row.at("q2").get<double>();
    const auto held = std::count_if(certificate.intervals.begin(), certificate.intervals.end(),
                                    [&](const auto& each) { return (*each)[0] <= q && q <= (*each)[1]; });
    EXPECT_EQ(held, 1) << q;
  }
}

TEST(CertifyRandom, AgreesWithTheList) {
  for (unsigned number = 0; number < 72; ++number) {
    const testing::RandomPair random = testing::random_pair(number);
    SCOPED_TRACE(random.text);
    const CurveContacts list = find_curve_contacts(random.pair, random.u);
    const Certificate certificate = certify_contacts(random.pair, random.u, list);
    EXPECT_EQ(certificate.status, CertificateStatus::kCertified);
    for (std::size_t i = 0; i < list.contacts.size(); ++i) {
      ASSERT_TRUE(certificate.intervals[i].has_value());
      EXPECT_LE((*certificate.intervals[i])[0], list.contacts[i].q);
      EXPECT_GE((*certificate.intervals[i])[1], list.contacts[i].q);
    }
  }
}

TEST(CertifyRandom, AgreesWithTheListAtAnyScale) {
  for (unsigned number = 0; number < 72; ++number) {
    const testing::RandomPair random = testing::random_pair(number);
    SCOPED_TRACE(random.text);
    for (const double scale : {1e-6, 1e6}) {
      const ContactPair pair = testing::scaled(random.pair, scale);
      const CurveContacts list = find_curve_contacts(pair, random.u);
      EXPECT_EQ(certify_contacts(pair, random.u, list).status, CertificateStatus::kCertified);
    }
  }
}

TEST(CertifyRandom, DoesNotPassAListWithAMistake) {
  for (unsigned number = 0; number < 72; ++number) {
    const testing::RandomPair random = testing::random_pair(number);
    SCOPED_TRACE(random.text);
    const CurveContacts list = find_curve_contacts(random.pair, random.u);
    const auto status = [&](const CurveContacts& changed) {
      return certify_contacts(random.pair, random.u, changed).status;
    };
    if (list.contacts.empty()) {
      CurveContacts invented = list;
      invented.contacts.emplace_back();
      EXPECT_EQ(status(invented), CertificateStatus::kDisagreement);
      continue;
    }
    CurveContacts missing = list;
    missing.contacts.erase(missing.contacts.begin());
    EXPECT_EQ(status(missing), CertificateStatus::kDisagreement);
    CurveContacts twice = list;
    twice.contacts.push_back(list.contacts.back());
    EXPECT_EQ(status(twice), CertificateStatus::kDisagreement);
    CurveContacts moved = list;
    moved.contacts.front().q += 1e-7 * (1 + std::abs(moved.contacts.front().q));
    EXPECT_EQ(status(moved), CertificateStatus::kDisagreement);
    CurveContacts turned = list;
    turned.contacts.front().opposed = !turned.contacts.front().opposed;
    EXPECT_EQ(status(turned), CertificateStatus::kDisagreement);
  }
}

TEST(Certify, AgreesWithTheListOnPairsOfWholeNumbers) {
  std::array<int, 4> seen = {};
  std::vector<unsigned> numbers(720);
  std::iota(numbers.begin(), numbers.end(), 0);
  // Contacts at the common origin, contacts at infinity to within a rounding, and a fourfold contact.
  numbers.insert(numbers.end(), {925, 2145, 4018, 5747, 5991});
  for (const unsigned number : numbers) {
    const testing::RandomPair random = testing::grid_pair(number);
    SCOPED_TRACE(random.text);
    const CurveContacts list = find_curve_contacts(random.pair, random.u);
    const Certificate certificate = certify_contacts(random.pair, random.u, list);
    ++seen.at(static_cast<std::size_t>(certificate.status));
    EXPECT_NE(certificate.status, CertificateStatus::kDisagreement);
    EXPECT_EQ(certificate.status == CertificateStatus::kNotDecided, list.status != ContactsStatus::kComplete);
    for (std::size_t i = 0; i < list.contacts.size(); ++i) {
      const CurveContact& contact = list.contacts[i];
      const bool fragile = contact.at_limit || contact.conforming || contact.coincident;
      EXPECT_EQ(certificate.intervals[i].has_value(), !fragile);
    }
  }
  // Every answer occurs often enough.
  EXPECT_GT(seen[0], 300);
  EXPECT_GT(seen[1], 10);
  EXPECT_GT(seen[2], 5);
}

// The list of contacts and the certificate of a pair with the driver at 0.
struct Both {
  CurveContacts list;
  Certificate certificate;
};

Both both(const ContactPair& pair) {
  Both result;
  result.list = find_curve_contacts(pair, 0);
  result.certificate = certify_contacts(pair, 0, result.list);
  return result;
}

TEST(Certify, SaysAtALimitWhereADoubleRootDependsOnRounding) {
  for (int i = 0; i < 12; ++i) {
    ContactPair pair;
    pair.curve1 = make_circle({0, 0}, 0.7).value();
    pair.curve2 = make_circle({1.9, 0}, 0.4).value();
    pair.motion2.p_WO = 3.0 * unit_vector(0.1 + i * 0.52);
    const Both result = both(pair);
    EXPECT_EQ(result.certificate.status, CertificateStatus::kAtLimit);
    ASSERT_EQ(result.certificate.intervals.size(), 1U);
    EXPECT_FALSE(result.certificate.intervals[0].has_value());
  }
}

// A disc of any radius has one tangent line for each sense of the normal on either side; as the disc shrinks,
// the two merge.
TEST(Certify, AgreesWithTheListOnDiscsThatAreAlmostPoints) {
  for (const double radius : {1e-20, 1e-30, 1e-45, 1e-60, 1e-120, 1e-250}) {
    for (const bool first : {true, false}) {
      const Curve disc = make_circle({0.008, 0.001}, radius).value();
      const Curve face = make_line({0, 0.003}, {0, -1}).value();
      ContactPair pair = {first ? disc : face, {}, first ? face : disc, {}};
      pair.motion2.p_WO = {0.06, 0};
      const Both result = both(pair);
      EXPECT_EQ(result.certificate.status, CertificateStatus::kCertified) << radius;
      ASSERT_EQ(result.list.contacts.size(), 4U) << radius;
      const auto opposed = [](const CurveContact& contact) { return contact.opposed; };
      EXPECT_EQ(std::count_if(result.list.contacts.begin(), result.list.contacts.end(), opposed), 2);
      pair.curve1 = first ? make_point({0.008, 0.001}).value() : face;
      pair.curve2 = first ? face : make_point({0.008, 0.001}).value();
      const CurveContacts of_point = find_curve_contacts(pair, 0);
      ASSERT_EQ(of_point.contacts.size(), 2U);
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(result.list.contacts[i].q, of_point.contacts[i / 2].q, 1e-15);
      }
    }
  }
}

TEST(Certify, DecidesHalfATurnByAnotherChart) {
  // A point on a circle about the pivot crosses the ellipse x²/4 + y² = 1 exactly at q = π, and at one other
  // position.
  ContactPair pair;
  pair.curve1 = make_ellipse({0, 0}, {2, 1}, 0).value();
  pair.curve2 = make_point({2.5, 0}).value();
  pair.motion2.p_WO = {2.5, 1};
  const Both result = both(pair);
  EXPECT_EQ(result.certificate.status, CertificateStatus::kCertified);
  ASSERT_EQ(result.list.contacts.size(), 2U);
  const auto& [low, high] = result.certificate.intervals[1].value();
  EXPECT_LE(low, kPi);
  EXPECT_GE(high, kPi);
  EXPECT_LE(high - low, 1e-13);
}

// Numbers that are no binary fractions of small denominators.
TEST(Certify, DecidesAnEdgeOnAFaceThatSlides) {
  const double u = kPi / 6, c = std::cos(u), s = std::sin(u);
  ContactPair face_slides;
  face_slides.curve1 = make_point({0.02, 0}).value();
  face_slides.curve2 = make_line({0.03, 0}, {-1, 0}).value();
  ContactPair edge_slides;
  edge_slides.curve1 = make_line({0.0055, 0}, {1, 0}).value();
  edge_slides.curve2 = make_point({0.01, 0.002}).value();
  for (auto& [pair, q] :
       {std::pair(face_slides, 0.02 * c - 0.03), std::pair(edge_slides, (0.0055 - 0.002 * s) / c - 0.01)}) {
    ContactPair sliding = pair;
    sliding.motion2.turns = false;
    sliding.motion2.direction_W = {1, 0};
    const CurveContacts list = find_curve_contacts(sliding, u);
    const Certificate certificate = certify_contacts(sliding, u, list);
    EXPECT_EQ(certificate.status, CertificateStatus::kCertified);
    ASSERT_EQ(list.contacts.size(), 1U);
    EXPECT_NEAR(list.contacts[0].q, q, 1e-17);
    const auto& [low, high] = certificate.intervals[0].value();
    EXPECT_LE(low, q);
    EXPECT_GE(high, q);
    EXPECT_LE(high - low, 1e-15);
  }
}

TEST(Certify, CountsTwoContactsAtOnePosition) {
  // The numbers of the disc and the parabola are exact in binary: a double root that is not a limit.
  ContactPair pair;
  pair.curve1 = make_parabola({0, 0}, 0.25, kPi / 2, Side::kOutside).value();
  pair.curve1.axis_B = {0, 1};
  pair.curve2 = make_circle({0, 0}, 1.25).value();
  pair.motion2.turns = false;
  pair.motion2.direction_W = {0, 1};
  const Both result = both(pair);
  EXPECT_EQ(result.certificate.status, CertificateStatus::kCertified);
  const auto count = std::count_if(result.list.contacts.begin(), result.list.contacts.end(),
                                   [](const CurveContact& c) { return c.free; });
  EXPECT_EQ(count, 2);
}

TEST(Certify, KeepsConformingAndCoincidentContactsApart) {
  ContactPair pair;
  pair.curve1 = make_parabola({0, 0}, 0.35, kPi / 2, Side::kOutside).value();
  pair.curve2 = make_circle({0, 0}, 0.7).value();
  pair.motion2.turns = false;
  pair.motion2.direction_W = {0, 1};
  EXPECT_EQ(both(pair).certificate.status, CertificateStatus::kAtLimit);
  pair.curve1 = make_circle({0, 0}, 0.7, Side::kOutside).value();
  EXPECT_EQ(both(pair).certificate.status, CertificateStatus::kAtLimit);
}

TEST(Certify, CountsOnlyTheBranchOfAHyperbolaThatExists) {
  ContactPair pair;
  pair.curve1 = make_hyperbola({0, 0}, {1, 1}, 0).value();
  pair.curve2 = make_circle({0, 0}, 0.25).value();
  pair.motion2.turns = false;
  const Both result = both(pair);
  EXPECT_EQ(result.list.contacts.size(), 2U);
  EXPECT_EQ(result.certificate.status, CertificateStatus::kCertified);
}

TEST(Certify, HoldsWithALeverAMillionTimesTheBodies) {
  ContactPair pair;
  pair.curve1 = make_circle({0, 0}, 0.731).value();
  pair.curve2 = make_circle({1e6, 0}, 0.447).value();
  pair.motion2.p_WO = {1e6 + 0.6, 0};
  const Both result = both(pair);
  EXPECT_EQ(result.list.contacts.size(), 2U);
  EXPECT_EQ(result.certificate.status, CertificateStatus::kCertified);
}

TEST(Certify, DoesNotDecideWhereThereIsNoList) {
  ContactPair pair;
  pair.curve1 = make_line({0, 0}, {0, 1}).value();
  pair.curve2 = pair.curve1;
  EXPECT_EQ(both(pair).certificate.status, CertificateStatus::kNotDecided);
}

TEST(Certify, DecidesAtQuarterTurnsOfTheDriverExactly) {
  // At 90 degrees the ellipse is upright and the disc above it touches its end. This is not a limit for a
  // follower that slides upwards; its position is 2 + 0.25.
  ContactPair pair;
  pair.curve1 = make_ellipse({0, 0}, {2, 1}, 0).value();
  pair.curve2 = make_circle({0, 0}, 0.25).value();
  pair.motion2.turns = false;
  pair.motion2.direction_W = {0, 1};
  const CurveContacts list = find_curve_contacts(pair, kPi / 2);
  const Certificate certificate = certify_contacts(pair, kPi / 2, list);
  EXPECT_EQ(certificate.status, CertificateStatus::kCertified);
  const auto& [low, high] = certificate.intervals.back().value();
  EXPECT_LE(low, 2.25);
  EXPECT_GE(high, 2.25);
  EXPECT_LE(high - low, 1e-13);
}

}  // namespace
}  // namespace higherpair
