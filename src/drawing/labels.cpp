#include "labels.hpp"

#include "higherpair/numeric/special_values.hpp"
#include "text_layout.hpp"

#include <algorithm>
#include <array>

namespace higherpair {
namespace {

constexpr double kSamePlace = 4;  // [px]
constexpr int kDirections = 12;
constexpr std::array kDistances{0.9, 1.4, 2.0, 2.8,
                                4.0};  // relative to the font size, from the position to the text's edge
constexpr double kCoveredText = 1e4, kOutside = 1e4, kCoveredInk = 3;  // costs
constexpr double kNoRoom = 1e4;              // from this cost on a label is left out
constexpr double kFar = 2.5, kFarClose = 5;  // per font size of distance
constexpr double kTurned = 1.5;              // against the preferred direction

TextBox box_about(const Vector2d& middle, const Vector2d& half) {
  return {middle.x() - half.x(), middle.y() - half.y(), middle.x() + half.x(), middle.y() + half.y()};
}

void remove_repeated(std::vector<Label>& labels) {
  std::vector<Label> kept;
  for (Label& label : labels) {
    const bool repeated = std::any_of(kept.begin(), kept.end(), [&](const Label& other) {
      return other.is_body == label.is_body && (other.at - label.at).norm() < kSamePlace;
    });
    if (!repeated) kept.push_back(std::move(label));
  }
  labels = std::move(kept);
}

}  // namespace

void place_labels(std::vector<Label>& labels, const std::vector<Vector2d>& ink, const Vector2d& size,
                  double font) {
  remove_repeated(labels);
  std::stable_partition(labels.begin(), labels.end(), [](const Label& label) { return label.stays_close; });
  const TextBox picture = {0, 0, size.x(), size.y()};
  std::vector<TextBox> boxes;
  std::vector<Label> shown;
  for (Label& label : labels) {
    const Vector2d half(text_width(label.text, font) / 2 + 2, 0.6 * font);
    const Vector2d away = label.away.norm() > 0 ? Vector2d(label.away.normalized()) : Vector2d(0.7, -0.7);
    double least = kInf;
    label.placed = label.at;
    const auto consider = [&](const Vector2d& middle, double cost) {
      const TextBox box = box_about(middle, half);
      cost +=
          kCoveredText * static_cast<double>(std::count_if(
                             boxes.begin(), boxes.end(), [&](const TextBox& b) { return b.overlaps(box); }));
      cost += box.is_within(picture) ? 0 : kOutside;
      cost += kCoveredInk * static_cast<double>(std::count_if(
                                ink.begin(), ink.end(), [&](const Vector2d& p) { return box.holds(p); }));
      if (cost < least) {
        least = cost;
        label.placed = middle;
      }
    };
    if (label.is_body) consider(label.at, 0);
    for (const double distance : kDistances) {
      for (int i = 0; i < kDirections; ++i) {
        const Vector2d d = unit_vector(2 * kPi * i / kDirections);
        const Vector2d edge(half.x() * d.x(), half.y() * d.y());
        consider(label.at + distance * font * d + edge,
                 (label.stays_close ? kFarClose : kFar) * distance + kTurned * (1 - d.dot(away)));
      }
    }
    if (least >= kNoRoom) continue;
    boxes.push_back(box_about(label.placed, half));
    shown.push_back(std::move(label));
  }
  labels = std::move(shown);
}

}  // namespace higherpair
