// A step of a running analysis allocates no heap memory.
#include "analysis/counting_allocator.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/contact/finder.hpp"
#include "higherpair/contact/tracker.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::allocation_count;

struct PairCase {
  std::string name;
  ContactPair pair;
  double q = 0;  ///< near the follower's first coordinate

  friend void PrintTo(const PairCase& pair_case, std::ostream* out) { *out << pair_case.name; }
};

OneFreedom pivot(double x, double y) {
  OneFreedom freedom;
  freedom.p_WO = {x, y};
  return freedom;
}

OneFreedom slide_along_y() {
  OneFreedom freedom;
  freedom.turns = false;
  freedom.direction_W = Vector2d::UnitY();
  return freedom;
}

std::vector<PairCase> pair_cases() {
  const Curve disc = make_circle({0.010, 0}, 0.020).value();
  const Curve oval = make_ellipse({0.008, 0.003}, {0.030, 0.020}, 0.26).value();
  const Curve roller = make_circle({-0.065, 0}, 0.012).value();
  const Curve shoe = make_ellipse({-0.065, 0.002}, {0.015, 0.010}, 0.5).value();
  const Curve face = make_line({0, 0}, {0, -1}).value();
  const OneFreedom O1 = pivot(0, 0);
  const OneFreedom O2 = pivot(0.080, -0.010);
  return {{"CircleOnCircle", {disc, O1, roller, O2}, -0.6},
          {"EllipseOnCircle", {oval, O1, roller, O2}, -0.6},
          {"EllipseOnEllipse", {oval, O1, shoe, O2}, -0.6},
          {"EllipseOnFlatFace", {oval, O1, face, slide_along_y()}, 0.04}};
}

class Allocation : public ::testing::TestWithParam<PairCase> {};

TEST_P(Allocation, ATrackedStepMakesNone) {
  const ContactPair& pair = GetParam().pair;
  const FindResult found = find_nearest_contact(pair, 0, GetParam().q);
  ASSERT_EQ(found.status, FindStatus::kFound);
  ContactTrack track = start_track(pair, found.at, found.branch);
  const std::size_t before = allocation_count();
  int lost = 0;
  double reach = 0;
  for (int step = 0; step < 2 * 3600; ++step) {
    lost += step_to(track, 2 * kPi * step / 3600, track.branch) == ContactStatus::kOk ? 0 : 1;
    reach = std::max(reach, details_of(track.pair, track.at, track.phi).side1.arc);
  }
  EXPECT_EQ(allocation_count() - before, 0U);
  EXPECT_EQ(lost, 0);
  EXPECT_GT(reach, 0);
}

TEST_P(Allocation, AStepOfAWholeQuarterTurnMakesNone) {
  const ContactPair& pair = GetParam().pair;
  const FindResult found = find_nearest_contact(pair, 0, GetParam().q);
  ASSERT_EQ(found.status, FindStatus::kFound);
  ContactTrack track = start_track(pair, found.at, found.branch);
  const std::size_t before = allocation_count();
  for (int step = 1; step <= 8; ++step) {
    EXPECT_TRUE(walk_to(track, step * kPi / 2));
  }
  EXPECT_EQ(allocation_count() - before, 0U);
}

INSTANTIATE_TEST_SUITE_P(Pairs, Allocation, ::testing::ValuesIn(pair_cases()),
                         [](const auto& test) { return test.param.name; });

// A counter that never counts would pass every test above.
TEST(CountingAllocator, SeesVectorsStringsArraysAndAlignedMemory) {
  struct alignas(64) Wide {
    double values[8];
  };
  const auto count_of = [](const auto& allocate) {
    const std::size_t before = allocation_count();
    allocate();
    return allocation_count() - before;
  };
  // A compiler may remove allocations that it sees to be unused.
  const volatile std::size_t size = 100;
  const void* volatile seen = nullptr;
  EXPECT_EQ(count_of([&] {
              const std::vector<double> values(size);
              seen = values.data();
            }),
            1U);
  EXPECT_EQ(count_of([&] {
              const std::string text(size, 'x');
              seen = text.data();
            }),
            1U);
  EXPECT_EQ(count_of([&] {
              const std::vector<Wide> values(size);
              seen = values.data();
            }),
            1U);
  double* volatile values = nullptr;
  EXPECT_EQ(count_of([&] { values = new double[size]; }), 1U);
  delete[] values;
  EXPECT_GT(count_of([] { (void)make_plan(Mechanism{}); }), 0U) << "the library uses another operator new";
  EXPECT_EQ(count_of([] {}), 0U);
}

}  // namespace
}  // namespace higherpair
