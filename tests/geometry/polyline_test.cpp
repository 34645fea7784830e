#include "higherpair/geometry/polyline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

class RandomPolylines {
public:
  explicit RandomPolylines(unsigned seed) : engine_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

  /// A walk of random steps, in several spans.
  Polyline polyline(int count) {
    Features features;
    Vector2d at(between(-1, 1), between(-1, 1));
    for (int i = 0; i < count; ++i) {
      at += Vector2d(between(-0.3, 0.3), between(-0.3, 0.3));
      features.push_back({at, {i / 10, static_cast<double>(i % 10)}});
    }
    return Polyline(std::move(features));
  }

  Pose<double> pose() {
    return {Rotation<double>::from_angle(between(-3, 3)), Vector2d(between(-1, 1), between(-1, 1))};
  }

private:
  std::mt19937 engine_;
};

std::size_t parts_of(int count) {
  return static_cast<std::size_t>(count -
                                  (count + 9) / 10);  // none joins the last point of a span to the next
}

double distance_to_part(const Polyline& line, std::size_t part, const Vector2d& p) {
  const Vector2d a = line.from(part).at;
  const Vector2d along = line.to(part).at - a;
  return (a + std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) * along - p).norm();
}

TEST(Polyline, NearestPlaceIsThatOfAllParts) {
  RandomPolylines random(3);
  for (const int count : {2, 7, 40, 333}) {
    const Polyline line = random.polyline(count);
    for (int i = 0; i < 50; ++i) {
      const Vector2d p(random.between(-3, 3), random.between(-3, 3));
      double least = 1e9;
      for (std::size_t part = 0; part < parts_of(count); ++part) {
        least = std::min(least, distance_to_part(line, part, p));
      }
      const Feature found = line.nearest(p);
      EXPECT_NEAR((found.at - p).norm(), least, 1e-14);
      // Its parameter, too, is between those of the ends of the part.
      const auto index = static_cast<std::size_t>(found.place.span * 10 + static_cast<int>(found.place.t));
      const Feature& from = line.features()[index];
      const double share = found.place.t - std::floor(found.place.t);
      const Feature& to = line.features()[share == 0 ? index : index + 1];
      EXPECT_LT((found.at - from.at - share * (to.at - from.at)).norm(), 1e-12);
    }
  }
}

// Whatever the pose, and in order.
TEST(Polyline, CrossingsOfAllPartsAreFound) {
  RandomPolylines random(4);
  for (int round = 0; round < 40; ++round) {
    const int count1 = 2 + round * 3;
    const int count2 = 90 - round;
    const Polyline one = random.polyline(count1);
    const Polyline two = random.polyline(count2);
    const Pose<double> X_12 = random.pose();
    std::vector<std::array<std::size_t, 2>> found;
    for (const PolylineCrossing& at : polyline_crossings(one, two, X_12)) {
      found.push_back(at.parts);
    }
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (std::size_t i = 0; i < parts_of(count1); ++i) {
      for (std::size_t k = 0; k < parts_of(count2); ++k) {
        const Vector2d a = one.from(i).at;
        const Vector2d b = one.to(i).at;
        const Vector2d c = X_12 * two.from(k).at;
        const Vector2d d = X_12 * two.to(k).at;
        const auto side = [](const Vector2d& from, const Vector2d& to, const Vector2d& p) {
          return cross(Vector2d(to - from), Vector2d(p - from));
        };
        const bool cross_each_other = side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
        const bool is_found = std::binary_search(found.begin(), found.end(), std::array{i, k});
        EXPECT_TRUE(is_found || !cross_each_other);
        const double far = ((a + b) / 2 - (c + d) / 2).norm();
        EXPECT_FALSE(is_found && far > (b - a).norm() + (d - c).norm());
      }
    }
  }
}

}  // namespace
}  // namespace higherpair
