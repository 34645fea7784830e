// Random mechanisms whose first limit is hard to find: two limits close together, a limit just after the
// start, contacts in chains, bodies that only contacts hold. Where the limit lies must not depend on the
// rows.
#include "analysis/reference_follower.hpp"
#include "analysis/run_testing.hpp"
#include "higherpair/io/driver_schedule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using namespace higherpair::testing;

/// A profile of tests/data/follow and the first driver's coordinate at the first limit, in the profile's
/// units; none: the motion reaches its end. Computed by reference_motion; an independent tracker with 42
/// digits gave the same to within its step (2e-5).
struct Followed {
  const char* name;
  std::optional<double> limit;
};

constexpr std::array kFollowed{
    Followed{"dyad10030", -5.71798734831527},     Followed{"dyad10061", -192.3677769860363},
    Followed{"dyad10117", -93.57198489259473},    Followed{"dyad10299", 3.0532849385301417},
    Followed{"dyad16695", 2.2549300199092537},    Followed{"dyad16756", -0.22795721982573},
    Followed{"triad10095", 49.74782543950054},    Followed{"triad10111", 0.007154767523500876},
    Followed{"closed10032", std::nullopt},        Followed{"closed10125", 164.83622300166107},
    Followed{"closed10196", -96.76071811608004},  Followed{"closed10236", 0.2992794239744907},
    Followed{"chainc10012", 132.86210440231605},  Followed{"chainc10033", -0.10702744515321688},
    Followed{"chainc10044", -1.4602563053938293}, Followed{"chainc10081", 48.99027613613797},
    Followed{"chainc10094", 127.21874548367964},  Followed{"chainc10277", std::nullopt},
    Followed{"coupled5", std::nullopt},           Followed{"coupled31", std::nullopt},
    Followed{"coupled44", std::nullopt},          Followed{"coupled45", 145.12608254094022},
    Followed{"coupled136", std::nullopt}};

// Known failures, "NAME at ROWS". Remove an entry when it is fixed: the test also fails where a listed one
// passes.
const std::set<std::string> kKnown{};

Profile followed(const std::string& name) {
  auto profile = read_profile_file(HIGHERPAIR_TEST_DATA "/follow/" + name + ".toml");
  EXPECT_TRUE(profile) << name;
  return profile ? *profile : Profile{};
}

double to_profile_units(const Profile& profile, double driver) {
  const Mechanism& mechanism = profile.mechanism;
  const Joint& joint = mechanism.joints[mechanism.drivers.front().joint];
  return from_si(has_angle(joint.type) ? dimension::kAngle : dimension::kLength, profile.units).apply(driver);
}

// What is wrong with a run; empty if nothing.
std::string objection(const Profile& profile, const Followed& wanted, std::int64_t rows) {
  const DriverSchedule schedule = DriverSchedule::analyze(profile, rows).value();
  const double first = schedule.state(0).profile.position;
  const double range = schedule.state(rows - 1).profile.position - first;
  const RunTable motion = analyze_at(profile, rows);
  if (!motion.failure().empty()) return motion.failure();
  const auto found = std::find_if(motion.events().begin(), motion.events().end(), [](const RunEvent& event) {
    return event.type == EventType::kLimitPosition;
  });
  const bool limited = found != motion.events().end();
  const double at = limited ? to_profile_units(profile, found->driver) : first + range;
  if (limited != wanted.limit.has_value()) {
    return limited ? fmt::format("a limit at {} where there is none", at) : "the limit is missed";
  }
  if (limited && !(std::abs(at - *wanted.limit) <= 1e-9 * std::abs(range))) {
    return fmt::format("the limit is found at {}, not at {}", at, *wanted.limit);
  }
  for (std::size_t k = 0; k < motion.size(); ++k) {
    const double share = (schedule.state(static_cast<std::int64_t>(k)).profile.position - first) / range;
    if (share < (at - first) / range && motion.status(k) != RowStatus::kOk) {
      return fmt::format("row {} before the limit is not ok", k);
    }
  }
  return {};
}

TEST(FollowProfiles, ComeToTheirFirstLimitHoweverManyRowsLeadThere) {
  for (const Followed& one : kFollowed) {
    const Profile profile = followed(one.name);
    for (const std::int64_t rows : {13, 41, 361}) {
      const std::string name = fmt::format("{} at {}", one.name, rows);
      const std::string wrong = objection(profile, one, rows);
      if (kKnown.count(name) == 0) {
        EXPECT_EQ(wrong, "") << name;
      } else {
        EXPECT_NE(wrong, "") << name << " is right now: take it off the list";
      }
    }
  }
}

TEST(FollowProfiles, HaveTheirLimitsFromTheReferenceFollower) {
  for (const Followed& one : kFollowed) {
    const Profile profile = followed(one.name);
    const DriverSchedule schedule = DriverSchedule::analyze(profile, 2).value();
    std::vector<double> to;
    for (std::size_t i = 0; i < schedule.driver_count(); ++i) to.push_back(schedule.state(1, i).si.position);
    const std::vector<double> from = schedule.first_positions();
    const ReferenceMotion motion = reference_motion(profile.mechanism, from, to);
    ASSERT_EQ(motion.end, one.limit ? ReferenceMotion::End::kLimit : ReferenceMotion::End::kReached)
        << one.name << motion.why;
    if (one.limit) {
      const double at = std::lerp(from[0], to[0], motion.share);
      EXPECT_NEAR(to_profile_units(profile, at), *one.limit, 1e-12 * (1 + std::abs(*one.limit))) << one.name;
    }
  }
}

// Coupled bodies beyond their first limit, which they come to at 74.4 and 35.5 degrees: where they can be
// assembled again, and whether they are taken up there, was once decided by how near to the limit the steps
// had come.
TEST(FollowProfiles, GoOnBeyondALimitHoweverManyRowsLeadThere) {
  for (const char* name : {"closed20402", "coupled20355"}) {
    const Profile profile = followed(name);
    const RunTable few = analyze_at(profile, 41);
    for (const std::int64_t rows : {81, 361, 1441}) {
      const RunTable many = analyze_at(profile, rows);
      for (std::size_t k = 0; k < few.size(); ++k) {
        const std::size_t same = k * static_cast<std::size_t>((rows - 1) / 40);
        EXPECT_EQ(few.status(k), many.status(same)) << name << ", row " << k << " of 41, and " << rows;
      }
    }
  }
}

// In the first the contact k1 comes back from infinity, and later a link fails to reach its slide: from
// there, not from where the contact was far away, the motion is looked for again. In the second it can be
// assembled again for 0.08 degrees, and right behind that a contact is found at another place.
TEST(FollowProfiles, HaveTheSameLimitsBeyondTheFirstHoweverManyRowsLeadThere) {
  for (const auto& [name, limits] : {std::pair("chain128", 9U), std::pair("ring220", 3U)}) {
    const Profile profile = followed(name);
    const RunTable many = analyze_at(profile, 601);
    ASSERT_EQ(many.events().size(), limits);
    for (const std::int64_t rows : {4, 7, 13, 61}) {
      SCOPED_TRACE(fmt::format("{} at {}", name, rows));
      const RunTable few = analyze_at(profile, rows);
      ASSERT_EQ(few.events().size(), limits);
      for (std::size_t i = 0; i < limits; ++i) {
        EXPECT_EQ(few.events()[i].type, many.events()[i].type);
        EXPECT_NEAR(few.events()[i].driver, many.events()[i].driver, 1e-9);
      }
      for (std::size_t k = 0; k < few.size(); ++k) {
        EXPECT_EQ(few.status(k), many.status(k * static_cast<std::size_t>(600 / (rows - 1)))) << k;
      }
    }
  }
}

}  // namespace
}  // namespace higherpair
