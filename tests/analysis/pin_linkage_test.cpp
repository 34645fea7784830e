// Pin linkages in closed form compared with the ordinary solution, and their derivatives with differences.
#include "higherpair/analysis/pin_linkage.hpp"

#include "analysis/run_testing.hpp"
#include "higherpair/analysis/direct_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "higherpair/numeric/stencil.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::shipped;

Mechanism with_numbers(Mechanism mechanism, const std::vector<double>& numbers) {
  for_each_number(mechanism, [&, k = std::size_t{0}](double& number) mutable { number = numbers[k++]; });
  return mechanism;
}

// Slightly perturbed, so that no number is 0 and no two are equal.
std::vector<double> shaken(std::vector<double> numbers, unsigned seed, double size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-0.03, 0.03);
  for (double& number : numbers) number += share(random) * size;
  return numbers;
}

// For a name that begins with ~ every joint names its bodies in the opposite order.
Mechanism mechanism_of(const std::string& name) {
  if (name.front() != '~') return shipped(name).mechanism;
  Mechanism mechanism = shipped(name.substr(1)).mechanism;
  for (Joint& joint : mechanism.joints) std::swap(joint.first, joint.second);
  return mechanism;
}

class PinLinkages : public ::testing::TestWithParam<std::string> {
protected:
  Mechanism mechanism_ = mechanism_of(GetParam());
  Plan plan_ = make_plan(mechanism_).value();
  PinLinkage linkage_ = PinLinkage::of(mechanism_, plan_).value();
};

TEST_P(PinLinkages, HaveThePositionsOfTheOrdinarySolution) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const std::vector<double> numbers = shaken(numbers_of(mechanism_), seed, plan_.size);
    const Mechanism mechanism = with_numbers(mechanism_, numbers);
    linkage_.set_numbers(numbers);
    for (int branch = 0; branch < branch_count(plan_); ++branch) {
      linkage_.set_branch(branch);
      DirectMotion direct(mechanism, redimensioned(plan_, mechanism), branch);
      for (double q = 0.1; q < 2 * kPi; q += 0.37) {
        const Rotation<double> turn = Rotation<double>::from_angle(q);
        const bool placed = linkage_.place(std::span(&turn, 1));
        ASSERT_EQ(placed, direct.move_to({{q, 0, 0}}, false));
        std::size_t dyad = 0;
        for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
          if (!std::holds_alternative<RrrDyad>(plan_.groups[g].kind)) continue;
          EXPECT_EQ(dyad < linkage_.known_gaps(), direct.gaps()[g].has_value());
          if (direct.gaps()[g]) {
            EXPECT_NEAR(linkage_.gap(dyad), *direct.gaps()[g], 1e-13 * plan_.size);
          }
          ++dyad;
        }
        for (std::size_t i = 0; placed && i < mechanism.bodies.size(); ++i) {
          const Pose<double>& ours = linkage_.pose(static_cast<int>(i));
          const Pose<double>& theirs = direct.bodies()[i].X_WB;
          EXPECT_NEAR((ours.p_WB - theirs.p_WB).norm(), 0, 1e-11 * plan_.size);
          EXPECT_NEAR(ours.R_WB.cos, theirs.R_WB.cos, 1e-11);
          EXPECT_NEAR(ours.R_WB.sin, theirs.R_WB.sin, 1e-11);
        }
      }
    }
  }
}

TEST_P(PinLinkages, ChangeAsDifferencesSay) {
  const std::vector<double> numbers = shaken(numbers_of(mechanism_), 7, plan_.size);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> slopes;
  for (std::size_t k = 0; k < numbers.size(); ++k) slopes.push_back(normal(random));
  const double h = 1e-4 * plan_.size;
  int tried = 0;
  for (double q = 0.1; q < 2 * kPi; q += 0.41) {
    const Rotation<double> turn = Rotation<double>::from_angle(q);
    bool placed = true;
    // Positions of all points, gaps and transmissions, one after the other.
    const auto values = [&](double step) -> Eigen::VectorXd {
      std::vector<double> at = numbers;
      for (std::size_t k = 0; k < at.size(); ++k) at[k] += step * slopes[k];
      linkage_.set_numbers(at);
      placed = linkage_.place(std::span(&turn, 1)) && placed;
      std::vector<double> all;
      for (std::size_t b = 1; b < mechanism_.bodies.size(); ++b) {
        for (std::size_t p = 0; p < mechanism_.bodies[b].points.size(); ++p) {
          const Vector2d place = linkage_.place_of({static_cast<int>(b), static_cast<int>(p)});
          all.insert(all.end(), {place.x(), place.y()});
        }
      }
      for (std::size_t k = 0; k < linkage_.known_gaps(); ++k) all.push_back(linkage_.gap(k));
      for (std::size_t k = 0; placed && k < linkage_.dyads(); ++k) all.push_back(linkage_.transmission(k));
      return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
    };
    (void)values(4 * h);
    (void)values(-4 * h);
    if (!placed) continue;
    const Eigen::VectorXd expected = eighth_order_difference(values, h);
    (void)values(0);
    linkage_.differentiate(slopes);
    Eigen::Index i = 0;
    double least_sine = 1;
    for (std::size_t k = 0; k < linkage_.dyads(); ++k) {
      least_sine = std::min(least_sine, std::abs(linkage_.transmission(k)));
    }
    if (least_sine < 0.1) continue;  // differences are inaccurate next to a dead point
    const double near = 1e-8 * expected.lpNorm<Eigen::Infinity>();
    for (std::size_t b = 1; b < mechanism_.bodies.size(); ++b) {
      for (std::size_t p = 0; p < mechanism_.bodies[b].points.size(); ++p) {
        const Vector2d slope = linkage_.place_slope({static_cast<int>(b), static_cast<int>(p)});
        EXPECT_NEAR(slope.x(), expected(i++), near);
        EXPECT_NEAR(slope.y(), expected(i++), near);
      }
    }
    for (std::size_t k = 0; k < linkage_.dyads(); ++k) {
      EXPECT_NEAR(linkage_.gap_slope(k), expected(i++), near);
    }
    for (std::size_t k = 0; k < linkage_.dyads(); ++k) {
      EXPECT_NEAR(linkage_.transmission_slope(k), expected(i++), near);
    }
    ++tried;
  }
  EXPECT_GE(tried, 3);
}

INSTANTIATE_TEST_SUITE_P(Shipped, PinLinkages,
                         ::testing::Values("four_bar", "straight_line", "watt_sixbar", "~watt_sixbar"));

TEST(PinLinkage, IsOfPinsAlone) {
  for (const char* name : {"slider_crank", "ellipse_cam_roller", "quick_return", "geared_five_bar"}) {
    const Mechanism mechanism = shipped(name).mechanism;
    EXPECT_FALSE(PinLinkage::of(mechanism, make_plan(mechanism).value())) << name;
  }
}

TEST(PinLinkage, ALinkOfNoLengthDoesNotReach) {
  const Mechanism mechanism = shipped("four_bar").mechanism;
  PinLinkage linkage = PinLinkage::of(mechanism, make_plan(mechanism).value()).value();
  linkage.set_numbers(std::vector<double>(numbers_of(mechanism).size(), 0.0));
  const Rotation<double> turn;
  EXPECT_FALSE(linkage.place(std::span(&turn, 1)));
  linkage.differentiate(std::vector<double>(numbers_of(mechanism).size(), 1.0));
  EXPECT_TRUE(std::isfinite(linkage.gap_slope(0)));
}

}  // namespace
}  // namespace higherpair
