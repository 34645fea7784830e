#include "point_labels.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace higherpair {
namespace {

constexpr double kHeight = 14;                                          // of a line of text [px]
constexpr double kTextGap = 3;                                          // between texts [px]
constexpr double kPointRoom = 5;                                        // kept clear around a point [px]
constexpr std::array<double, 5> kPointDistances = {7, 16, 28, 42, 60};  // from a point to its text [px]

// Upper right, upper left, lower right, lower left, above, below, right, left; y down.
constexpr std::array<std::pair<double, double>, 8> kPointDirections = {
    {{1, -0.7}, {-1, -0.7}, {1, 0.7}, {-1, 0.7}, {0, -1}, {0, 1}, {1, 0}, {-1, 0}}};

TextBox box_at(const LabelledPoint& point, double distance, const std::pair<double, double>& direction) {
  const double x = point.x + direction.first * distance;
  const double y = point.y + direction.second * distance;
  const double left = direction.first > 0 ? x : direction.first < 0 ? x - point.width : x - point.width / 2;
  const double top = direction.second > 0 ? y : direction.second < 0 ? y - kHeight : y - kHeight / 2;
  return {left, top, left + point.width, top + kHeight};
}

}  // namespace

void place_labels(std::vector<LabelledPoint>& points, const TextBox& frame,
                  const std::vector<TextBox>& taken) {
  std::vector<TextBox> covered = taken;
  for (const LabelledPoint& point : points) {
    covered.push_back(
        {point.x - kPointRoom, point.y - kPointRoom, point.x + kPointRoom, point.y + kPointRoom});
  }
  const auto try_place = [&](LabelledPoint& point) {
    for (const double distance : kPointDistances) {
      for (const auto& direction : kPointDirections) {
        const TextBox box = box_at(point, distance, direction);
        const auto covers = [&](const TextBox& other) { return box.overlaps(other); };
        if (box.is_within(frame) && std::none_of(covered.begin(), covered.end(), covers)) {
          point.box = box;
          point.far = distance > kPointDistances[1];
          point.shown = true;
          covered.push_back({box.left - kTextGap, box.top, box.right + kTextGap, box.bottom});
          return;
        }
      }
    }
  };
  for (LabelledPoint& point : points) {
    if (point.width > 0) try_place(point);
  }
}

}  // namespace higherpair
