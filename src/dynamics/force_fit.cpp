#include "force_fit.hpp"

#include "higherpair/contact/step_length.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "numeric/chebyshev.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// Number of positions on the path at which the usual size of the forces is determined; see kForceFloor.
constexpr int kFloorSamples = 64;

std::vector<std::vector<double>> breaks_of(const Boundary& boundary) {
  std::vector<std::vector<double>> breaks;
  for (const SpanPtr& span : boundary.spans()) {
    breaks.push_back(span->breaks());
  }
  return breaks;
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
  breaks_.resize(contacts_);
  parts_.resize(contacts_);
  const Mechanism& mechanism = start.mechanism();
  for (const auto [contact, side] : BoundarySides(mechanism)) {
    breaks_[contact][side] = breaks_of(boundary_of(mechanism, ref_of(mechanism.contacts[contact], side)));
  }
}

std::optional<double> ForceFitter::last_break() const {
  return last_break_ ? std::optional(last_break_at_) : std::nullopt;
}

void ForceFitter::set_floor() {
  floor_.assign(columns_.count(), 0);
  Run probe = position_.run;
  double at = path_.knots.front();
  std::vector<std::vector<double>> largest(columns_.count());
  for (int k = 0; k < kFloorSamples && !is_stopped(probe); ++k) {
    const double share = k / (kFloorSamples - 1.0);
    const double next = path_.knots.front() + share * (path_.knots.back() - path_.knots.front());
    path_.move(probe, at, next);
    at = next;
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
        fit.piece.columns[i][j] = columns_.values()[i];
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
    fit.piece.columns[i] = {columns_.values()[i]};
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

SmoothPart ForceFitter::part_of(const Run& run, std::size_t contact, std::size_t side) const {
  const ContactMotion& motion = run.at.state.contacts[contact];
  if (breaks_[contact][side].empty() || !motion.touches) {
    return {};
  }
  const BoundaryPlace& place = motion.place[side];
  const std::vector<double>& breaks = breaks_[contact][side][static_cast<std::size_t>(place.span)];
  return {place.span, std::upper_bound(breaks.begin(), breaks.end(), place.t) - breaks.begin()};
}

// Keeps a joint on the way from a place if it is the first, or nearer to the middle of the piece.
void ForceFitter::note_joints(double from, ForceFit& fit) const {
  const auto rank = [&](const SmoothJoint& joint) {
    return std::pair(!joint.between_spans, std::abs(joint.from + joint.to - fit.piece.from - fit.piece.to));
  };
  for (std::size_t i = 0; i < contacts_; ++i) {
    for (std::size_t side = 0; side < 2; ++side) {
      const SmoothPart after = part_of(position_.run, i, side), before = parts_[i][side];
      const SmoothJoint joint{i, side, after.first != before.first, before, from, position_.at};
      if (after != before && (!fit.joint || rank(joint) < rank(*fit.joint))) {
        fit.joint = joint;
      }
    }
  }
}

std::optional<double> ForceFitter::place_of(const SmoothJoint& joint, const ForceFit& fit,
                                            Position before) const {
  double low = joint.from, high = joint.to;
  while (high - low > shortest_step(longest_, high) && !is_stopped(before.run)) {
    const double middle = (low + high) / 2;
    path_.move(before.run, before.at, middle);
    before.at = middle;
    (part_of(before.run, joint.contact, joint.side) == joint.before ? low : high) = middle;
  }
  const double near = kAtPieceEnd * longest_;
  const bool within = low > fit.piece.from + near && high < fit.piece.to - near;
  return within ? std::optional(high) : std::nullopt;
}

// Moves the run to `to`. Records the first break on the way that lies within the fit's piece, and where a
// contact passes a joint of its curve.
void ForceFitter::move(double to, ForceFit& fit) {
  const double from = position_.at;
  for (std::size_t i = 0; i < contacts_; ++i) {
    parts_[i] = {part_of(position_.run, i, 0), part_of(position_.run, i, 1)};
  }
  path_.move(position_.run, position_.at, to);
  for (const RunEvent& event : position_.run.events) {
    if (!fit.event && breaks_motion(event.type)) {
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
  if (from >= fit.piece.from) {
    note_joints(from, fit);
  }
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
