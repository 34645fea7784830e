#include "higherpair/dynamics/contact_forces.hpp"

#include "force_fit.hpp"
#include "force_watch.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/roots.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/chebyshev.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// Pieces left out of a first piece before its shortest length is doubled. Normally a first piece has one or
// two singular positions, with a few of the shortest pieces next to each.
constexpr int kManyLeftOut = 16;

class Recorder {
public:
  Recorder(const Run& start, const DriverPath& path, std::vector<Preload> preloads)
      : path_(path), fitter_(start, path, preloads), watch_(path, fitter_, forces_) {
    forces_.preloads = std::move(preloads);
    forces_.lowest.resize(start.mechanism().contacts.size());
  }

  ContactForces record() {
    for (std::size_t i = 1; i < path_.knots.size(); ++i) {
      const double from = path_.knots[i - 1], to = path_.knots[i];
      add_stretch(from, to, first_pieces(path_.at(from), path_.at(to)));
    }
    if (!moved_) {
      add_position();
    }
    return std::move(forces_);
  }

private:
  // Number of pieces to start with; 0 if nothing changes on the whole path.
  [[nodiscard]] double first_pieces(const std::vector<DriverMotion>& from,
                                    const std::vector<DriverMotion>& to) const {
    const double parts = largest_move(run(), from, to, kLongestPieceTurn, kLongestPieceSlide);
    return from != to || path_.knots.size() > 2 ? std::max(1.0, std::ceil(parts * (1 - kAtPieceEnd))) : 0;
  }

  void add_stretch(double from, double to, double parts) {
    if (parts == 0) {
      return;
    }
    moved_ = true;
    longest_ = (to - from) / parts;
    fitter_.set_longest(longest_);
    for (double i = 0; i < parts && !is_stopped(run()); ++i) {
      times_left_out_ = 0;
      resolve({i == 0 ? from : from + i * longest_, i + 1 == parts ? to : from + (i + 1) * longest_});
    }
  }

  // Handles a path of one position.
  void add_position() {
    if (auto piece = fitter_.here()) {
      keep(fitter_.position(), *std::move(piece));
    }
  }

  void resolve(const ForceStretch& stretch) {
    const ForceFitter::Position before = fitter_.position();
    ForceFit fit = fitter_.fit(stretch);
    if (is_stopped(run())) {
      return;
    }
    const bool shortest = stretch.to - stretch.from <= shortest_length();
    const bool slow = fit.tail * kSeriesFall >= stretch.tail;
    const bool converged = fit.tail <= kSeriesConverged || (fit.tail <= kRoughSeries && (slow || shortest));
    // A series over a joint converges slowly, which looks like rounding. Over the milder joints within a
    // spline it is good enough as soon as it looks so.
    const bool divides = !fit.event && fit.joint && fit.tail > kSeriesConverged &&
                         (fit.joint->between_spans || (slow && !converged));
    const auto joint = divides ? fitter_.place_of(*fit.joint, fit, before) : std::nullopt;
    if (!fit.event && !joint && fit.defined == kNodes && converged) {
      keep(before, std::move(fit.piece));
      return;
    }
    if (!fit.event && fit.defined == 0) {
      watch_.forget();
      left_out_.reset();
      return;
    }
    if (!fit.event && !joint && shortest) {
      leave_out(stretch);
      return;
    }
    fitter_.go_back(before);
    const double split = fit.event.value_or(joint.value_or((stretch.from + stretch.to) / 2));
    const double tail = fit.event || (joint && fit.joint->between_spans) ? kInf : fit.tail;
    resolve({stretch.from, split, fit.event.has_value(), tail});
    resolve({split, stretch.to, stretch.breaks_at_end, tail});
  }

  // Shortest length to which a first piece is divided; doubled whenever kManyLeftOut more pieces have been
  // left out, as where forces are noise.
  [[nodiscard]] double shortest_length() const {
    return std::ldexp(kShortestForcePiece * longest_, times_left_out_ / kManyLeftOut);
  }

  // Leaves out a stretch next to a singular position.
  void leave_out(const ForceStretch& stretch) {
    ++times_left_out_;
    if (left_out_) {
      return;
    }
    left_out_ = stretch.from;
    if (!forces_.pieces.empty() && forces_.pieces.back().to == stretch.from) {
      forces_.pieces.back().singular_to = true;
    }
  }

  void keep(const ForceFitter::Position& before, ForcePiece piece) {
    piece.singular_from = left_out_.has_value();
    watch_.pass(before, piece, left_out_ ? std::optional(beginning_of(piece)) : std::nullopt);
    left_out_.reset();
    forces_.complete = forces_.complete && forces_.pieces.size() < ContactForces::kMostPieces;
    if (forces_.complete) {
      forces_.pieces.push_back(std::move(piece));
    }
  }

  // Where the forces of a piece begin after something was left out: at the break that it was next to, or else
  // in its middle.
  [[nodiscard]] double beginning_of(const ForcePiece& piece) const {
    const std::optional<double> last_break = fitter_.last_break();
    const bool is_between = last_break && *last_break >= *left_out_ && *last_break <= piece.from;
    return is_between ? *last_break : (*left_out_ + piece.from) / 2;
  }

  [[nodiscard]] const Run& run() const { return fitter_.position().run; }

  const DriverPath& path_;
  ForceFitter fitter_;
  ContactForces forces_;
  ForceWatch watch_;
  bool moved_ = false;              // whether the path has more than one position
  double longest_ = 0;              // length of the first pieces of this stretch
  int times_left_out_ = 0;          // in the present first piece
  std::optional<double> left_out_;  // start of what was left out since the last piece
};

}  // namespace

DriverPath straight_path(std::vector<DriverMotion> from, std::vector<DriverMotion> to, double length) {
  DriverPath path;
  path.knots = {0, length};
  path.motion = [from = std::move(from), to = std::move(to), length](double at,
                                                                     std::vector<DriverMotion>& drivers) {
    const auto mix = [&](double a, double b) { return at == length ? b : a + at / length * (b - a); };
    drivers.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
      drivers[i] = {mix(from[i].position, to[i].position), mix(from[i].velocity, to[i].velocity),
                    mix(from[i].acceleration, to[i].acceleration)};
    }
  };
  return path;
}

void DriverPath::move(Run& run, double from, double to) const {
  motion(to, run.work.at_row);
  if (curve) {
    move_along(run, curve, from, to, run.work.at_row);
  } else {
    move_to(run, run.work.at_row);
  }
}

double DriverPath::place_of(double share, double from, double to) const {
  if (curve) {
    return std::lerp(from, to, share);
  }
  const std::vector<DriverMotion> first = at(from), last = at(to);
  const auto travel = [&](std::size_t i) { return last[i].position - first[i].position; };
  std::size_t most = 0;
  for (std::size_t i = 1; i < first.size(); ++i) {
    most = std::abs(travel(i)) > std::abs(travel(most)) ? i : most;
  }
  const double target = first[most].position + share * travel(most);
  std::vector<DriverMotion> there;
  const auto ahead = [&](double x) {
    motion(from + x, there);
    return there[most].position - target;
  };
  const double guess = std::lerp(from, to, share);
  const double before = ahead(0), after = ahead(to - from);
  if (!(before * after < 0) || ahead(guess - from) == 0) {
    return guess;
  }
  return from + root_between(ahead, before, to - from, after).value_or(guess - from);
}

double largest_move(const Run& run, const std::vector<DriverMotion>& from,
                    const std::vector<DriverMotion>& to, double turn, double slide) {
  double most = 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const bool turns = driven_joint(run.mechanism(), i).type == JointType::kRevolute;
    const double unit = turns ? turn : slide * run.plan().size;
    most = std::max(most, std::abs(to[i].position - from[i].position) / unit);
  }
  return most;
}

ForceSeries weighted_force(const ForcePiece& piece, std::size_t contact, std::span<const double> weights) {
  const std::size_t count = piece.columns.size() / piece.known.size();
  ForceSeries sum{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const ForceSeries& column = piece.columns[contact * count + i];
    for (std::size_t k = 0; k < kNodes; ++k) {
      sum[k] += weights[i] * column[k];
    }
  }
  return sum;
}

ContactForces follow_contact_forces(const Run& start, const DriverPath& path, std::vector<Preload> preloads) {
  return Recorder(start, path, std::move(preloads)).record();
}

}  // namespace higherpair
