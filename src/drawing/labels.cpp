#include "labels.hpp"

#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair {
namespace {

constexpr double kLetter = 0.62;  // width of a letter, relative to the font size
constexpr double kSamePlace = 4;  // [px]
constexpr int kDirections = 12;
constexpr std::array kDistances{0.9, 1.4, 2.0, 2.8,
                                4.0};  // relative to the font size, from the position to the text's edge
constexpr double kCoveredText = 1e4, kOutside = 1e4, kCoveredInk = 2;  // costs
constexpr double kNoRoom = 1e4;              // from this cost on a label is left out
constexpr double kFar = 2.5, kFarClose = 5;  // per font size of distance
constexpr double kTurned = 1.5;              // against the preferred direction

struct InkBox {
  Vector2d middle, half;

  [[nodiscard]] bool holds(const Vector2d& p) const {
    return std::abs(p.x() - middle.x()) <= half.x() && std::abs(p.y() - middle.y()) <= half.y();
  }
  [[nodiscard]] bool overlaps(const InkBox& other) const {
    return std::abs(other.middle.x() - middle.x()) < half.x() + other.half.x() &&
           std::abs(other.middle.y() - middle.y()) < half.y() + other.half.y();
  }
};

Vector2d half_size(const Label& label, double font) {
  // Count characters of UTF-8, not bytes.
  const auto letters = std::count_if(label.text.begin(), label.text.end(),
                                     [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
  return {(kLetter * static_cast<double>(letters) * font) / 2 + 2, 0.6 * font};
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
  std::vector<InkBox> boxes;
  std::vector<Label> shown;
  for (Label& label : labels) {
    const Vector2d half = half_size(label, font);
    const Vector2d away = label.away.norm() > 0 ? Vector2d(label.away.normalized()) : Vector2d(0.7, -0.7);
    double least = kInf;
    InkBox best{label.at, half};
    const auto consider = [&](const Vector2d& middle, double cost) {
      const InkBox box{middle, half};
      cost +=
          kCoveredText * static_cast<double>(std::count_if(boxes.begin(), boxes.end(),
                                                           [&](const InkBox& b) { return b.overlaps(box); }));
      const bool outside = (middle - half).minCoeff() < 0 || ((middle + half).array() > size.array()).any();
      cost += outside ? kOutside : 0;
      cost += kCoveredInk * static_cast<double>(std::count_if(
                                ink.begin(), ink.end(), [&](const Vector2d& p) { return box.holds(p); }));
      if (cost < least) {
        least = cost;
        best = box;
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
    label.placed = best.middle;
    boxes.push_back(best);
    shown.push_back(std::move(label));
  }
  labels = std::move(shown);
}

}  // namespace higherpair
