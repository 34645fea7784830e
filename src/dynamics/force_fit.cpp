#include "force_fit.hpp"

#include "numeric/chebyshev.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// Number of positions on the path at which the usual size of the forces is determined; see kForceFloor.
constexpr int kFloorSamples = 64;

// Whether forces or their rates may be discontinuous at an event.
bool breaks_forces(const RunEvent& event) {
  return event.type == EventType::kLimitPosition || event.type == EventType::kDeadPoint ||
         event.type == EventType::kConforming || event.type == EventType::kSecondContact ||
         event.type == EventType::kCurvatureJump || event.type == EventType::kCorner ||
         event.type == EventType::kEnd || event.type == EventType::kEngage ||
         event.type == EventType::kRelease;
}

}  // namespace

double parameter(const ForcePiece& piece, double t) {
  return t == -1  ? piece.from
         : t == 1 ? piece.to
                  : (piece.from + piece.to) / 2 + t * (piece.to - piece.from) / 2;
}

ForceFitter::ForceFitter(const Run& start, const DriverPath& path, const std::vector<Preload>& preloads)
    : path_(path),
      position_{start, 0},
      columns_(start, preloads),
      contacts_(start.mechanism().contacts.size()) {
  set_floor();
  position_.at = path_.knots.front();
  path_.motion(position_.at, drivers_);
}

std::optional<double> ForceFitter::last_break() const {
  return last_break_ ? std::optional(last_break_at_) : std::nullopt;
}

void ForceFitter::set_floor() {
  floor_.assign(columns_.count(), 0);
  Run probe = position_.run;
  std::vector<std::vector<double>> largest(columns_.count());
  for (int k = 0; k < kFloorSamples && !is_stopped(probe); ++k) {
    const double share = k / (kFloorSamples - 1.0);
    path_.motion(path_.knots.front() + share * (path_.knots.back() - path_.knots.front()), drivers_);
    move_to(probe, drivers_);
    if (columns_.solve(probe)) {
      for (std::size_t column = 0; column < largest.size(); ++column) {
        largest[column].push_back(columns_.largest(column));
      }
    }
  }
  for (std::size_t column = 0; column < largest.size(); ++column) {
    if (std::vector<double>& values = largest[column]; !values.empty()) {
      const auto usual =
          values.begin() + static_cast<std::ptrdiff_t>(kUsualShare * static_cast<double>(values.size()));
      std::nth_element(values.begin(), usual, values.end());
      floor_[column] = kForceFloor * *usual;
    }
  }
}

ForceFit ForceFitter::start_fit(const ForceStretch& stretch) {
  ForceFit fit;
  fit.piece.from = stretch.from;
  fit.piece.to = stretch.to;
  fit.piece.known.assign(contacts_, true);
  fit.piece.columns.resize(contacts_ * columns_.count());
  scales_ = floor_;
  return fit;
}

ForceFit ForceFitter::fit(const ForceStretch& stretch) {
  ForceFit fit = start_fit(stretch);
  for (std::size_t j = 0; j < kNodes; ++j) {
    if (sample(parameter(fit.piece, node(j)), fit)) {
      for (std::size_t i = 0; i < fit.piece.columns.size(); ++i) {
        fit.piece.columns[i][j] = columns_.value(i / columns_.count(), i % columns_.count());
      }
    }
    if (fit.event || is_stopped(position_.run)) {
      return fit;
    }
  }
  if (!stretch.breaks_at_end) {
    move(stretch.to, fit);
  }
  if (fit.defined == kNodes) {
    converge(fit);
  }
  return fit;
}

std::optional<ForcePiece> ForceFitter::here() {
  ForceFit fit = start_fit({position_.at, position_.at});
  if (!sample(position_.at, fit)) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < fit.piece.columns.size(); ++i) {
    fit.piece.columns[i] = {columns_.value(i / columns_.count(), i % columns_.count())};
  }
  return std::move(fit.piece);
}

// Converts the values at the nodes into series and determines how far these have converged.
void ForceFitter::converge(ForceFit& fit) {
  for (std::size_t i = 0; i < fit.piece.columns.size(); ++i) {
    ForceSeries& series = fit.piece.columns[i];
    series = interpolate(series);
    const double last =
        std::max({std::abs(series[kNodes - 1]), std::abs(series[kNodes - 2]), std::abs(series[kNodes - 3])});
    const double scale = scales_[i % columns_.count()];
    fit.tail = std::max(fit.tail, scale > 0 ? last / scale : 0);
  }
  fit.piece.noise *= std::max(1.0, 4 * fit.tail / kMultiplierRounding);
}

// Moves the run to `to`. Records the first break on the way that lies within the fit's piece.
void ForceFitter::move(double to, ForceFit& fit) {
  path_.motion(to, drivers_);
  move_to(position_.run, drivers_);
  for (const RunEvent& event : position_.run.events) {
    if (!fit.event && breaks_forces(event)) {
      const double at = path_.place_of(event.share, position_.at, to);
      const double near = kAtPieceEnd * longest_;
      const bool again =
          last_break_ == event.type && std::abs(at - last_break_at_) < kShortestForcePiece * longest_;
      if (at > fit.piece.from + near && at < fit.piece.to - near && !again) {
        fit.event = at;
        last_break_ = event.type;
        last_break_at_ = at;
      }
    }
  }
  position_.at = to;
}

bool ForceFitter::sample(double at, ForceFit& fit) {
  move(at, fit);
  if (is_stopped(position_.run) || !columns_.solve(position_.run)) {
    return false;
  }
  ++fit.defined;
  for (std::size_t column = 0; column < columns_.count(); ++column) {
    scales_[column] = std::max(scales_[column], columns_.largest(column));
  }
  // The parts of a force are all known to the accuracy of the largest of them.
  const double largest = *std::max_element(scales_.begin(), scales_.begin() + ForcePiece::kParts);
  std::fill(scales_.begin(), scales_.begin() + ForcePiece::kParts, largest);
  fit.piece.noise = kMultiplierRounding * largest;
  for (std::size_t i = 0; i < contacts_; ++i) {
    fit.piece.known[i] = fit.piece.known[i] && columns_.is_known(i);
  }
  return true;
}

}  // namespace higherpair
