#include "higherpair/dynamics/contact_forces.hpp"

#include "force_fit.hpp"
#include "numeric/chebyshev.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

namespace higherpair {
namespace {

// Longest piece: of a turning driver [rad], of a sliding one relative to the size. Forces of ordinary cams
// are resolved on pieces between one and a quarter of this.
constexpr double kLongestPieceTurn = kPi / 6;
constexpr double kLongestPieceSlide = 0.25;

// A series has converged when its last coefficients are below this, relative to the largest multiplier.
constexpr double kConverged = 1e-13;
// Near crossings of branches rates have fewer digits: a series whose last coefficients are below this and do
// not fall by kFalls when the piece is halved shows their rounding.
constexpr double kRough = 1e-8;
constexpr double kFalls = 8;

// A force that has grown by this up to where it changes sign without a zero has a pole there.
constexpr double kGrown = 1e3;

// Sum of the parts of a contact's force.
ForceSeries total(const ForcePiece& piece, std::size_t contact) {
  const std::size_t count = piece.columns.size() / piece.known.size();
  ForceSeries sum{};
  for (std::size_t part = 0; part < ForcePiece::kParts; ++part) {
    for (std::size_t k = 0; k < kNodes; ++k) {
      sum[k] += piece.columns[contact * count + part][k];
    }
  }
  return sum;
}

ForceSeries negative(ForceSeries p) {
  for (double& c : p) {
    c = -c;
  }
  return p;
}

// The zero in front of `below`, where p < 0 for the first time after `from`.
double zero_before(const ForceSeries& p, double from, double below) {
  double low = below;
  for (double step = 1e-13; low > from && value_at(p, low) < 0; step *= 4) {
    low = std::max(from, below - step);
  }
  const double at_low = value_at(p, low);
  const double at_below = value_at(p, below);
  if (!(at_low > 0) || !(at_below < 0)) {
    return low;
  }
  std::uintmax_t calls = 100;
  const auto [a, b] =
      boost::math::tools::toms748_solve([&](double t) { return value_at(p, t); }, low, below, at_low,
                                        at_below, boost::math::tools::eps_tolerance<double>(52), calls);
  return (a + b) / 2;
}

class Recorder {
public:
  Recorder(const Run& start, const DriverPath& path, std::vector<Preload> preloads)
      : path_(path), fitter_(start, path, preloads), contacts_(start.mechanism().contacts.size()) {
    forces_.preloads = std::move(preloads);
    forces_.lowest.resize(contacts_.size());
  }

  ContactForces record() {
    std::vector<DriverMotion> from, to;
    path_.motion(path_.knots.front(), from);
    for (std::size_t i = 1; i < path_.knots.size(); ++i) {
      path_.motion(path_.knots[i], to);
      add_stretch(path_.knots[i - 1], path_.knots[i], parts_between(from, to));
      path_.motion(path_.knots[i], from);
    }
    if (!moved_) {
      add_position();
    }
    return std::move(forces_);
  }

private:
  // What is known of a contact at the end of the pieces before.
  struct Watched {
    enum class State { kUnknown, kPressing, kOpen } state = State::kUnknown;
    double end = 0;                                          // its force there [N]
    double least = std::numeric_limits<double>::infinity();  // largest force of the calmest piece so far
  };

  // How many pieces to start with; 0 where nothing changes on the whole path.
  [[nodiscard]] double parts_between(const std::vector<DriverMotion>& from,
                                     const std::vector<DriverMotion>& to) const {
    double parts = 0;
    bool changes = false;
    for (std::size_t i = 0; i < to.size(); ++i) {
      const auto joint = static_cast<std::size_t>(run().mechanism().drivers[i].joint);
      const bool turns = run().mechanism().joints[joint].type == JointType::kRevolute;
      const double longest = turns ? kLongestPieceTurn : kLongestPieceSlide * run().plan().size;
      parts = std::max(parts, std::abs(to[i].position - from[i].position) / longest);
      changes = changes || from[i].position != to[i].position || from[i].velocity != to[i].velocity ||
                from[i].acceleration != to[i].acceleration;
    }
    return changes || path_.knots.size() > 2 ? std::max(1.0, std::ceil(parts * (1 - kAtPieceEnd))) : 0;
  }

  void add_stretch(double from, double to, double parts) {
    if (parts == 0) {
      return;
    }
    moved_ = true;
    longest_ = (to - from) / parts;
    fitter_.set_longest(longest_);
    for (double i = 0; i < parts && !is_stopped(run()); ++i) {
      resolve({i == 0 ? from : from + i * longest_, i + 1 == parts ? to : from + (i + 1) * longest_});
    }
  }

  // A path of one position.
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
    const bool converged =
        fit.tail <= kConverged || (fit.tail <= kRough && fit.tail * kFalls >= stretch.tail);
    if (!fit.event && fit.defined == kNodes && converged) {
      keep(before, std::move(fit.piece));
      return;
    }
    if (!fit.event && fit.defined == 0) {
      for (Watched& contact : contacts_) {
        contact.state = Watched::State::kUnknown;
      }
      left_out_.reset();
      return;
    }
    if (!fit.event && stretch.to - stretch.from <= kShortestPiece * longest_) {
      leave_out(stretch);
      return;
    }
    fitter_.go_back(before);
    const double inf = std::numeric_limits<double>::infinity();
    const double split = fit.event.value_or((stretch.from + stretch.to) / 2);
    const double tail = fit.event ? inf : fit.tail;
    resolve({stretch.from, split, fit.event.has_value(), tail});
    resolve({split, stretch.to, stretch.breaks_at_end, tail});
  }

  // Next to a singular position.
  void leave_out(const ForceStretch& stretch) {
    if (left_out_) {
      return;
    }
    left_out_ = stretch.from;
    if (!forces_.pieces.empty() && forces_.pieces.back().to == stretch.from) {
      forces_.pieces.back().singular_to = true;
    }
    for (auto& lowest : forces_.lowest) {
      if (lowest && lowest->at == stretch.from) {
        lowest->is_minimum = false;
      }
    }
  }

  void keep(const ForceFitter::Position& before, ForcePiece piece) {
    piece.singular_from = left_out_.has_value();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (piece.known[i]) {
        const ForceSeries force = total(piece, i);
        find_openings(before, piece, i, force);
        find_lowest(piece, i, force);
        contacts_[i].end = value_at(force, 1);
        contacts_[i].least = std::min(contacts_[i].least, std::abs(force[0]) + spread(force));
      } else {
        contacts_[i].state = Watched::State::kUnknown;
      }
    }
    left_out_.reset();
    forces_.complete = forces_.complete && forces_.pieces.size() < ContactForces::kMostPieces;
    if (forces_.complete) {
      forces_.pieces.push_back(std::move(piece));
    }
  }

  // Where the forces of a piece begin: at the break that something was left out next to.
  [[nodiscard]] double beginning_of(const ForcePiece& piece) const {
    if (!left_out_) {
      return piece.from;
    }
    const std::optional<double> last_break = fitter_.last_break();
    const bool is_between = last_break && *last_break >= *left_out_ && *last_break <= piece.from;
    return is_between ? *last_break : (*left_out_ + piece.from) / 2;
  }

  void find_openings(const ForceFitter::Position& before, const ForcePiece& piece, std::size_t i,
                     const ForceSeries& force) {
    using State = Watched::State;
    using Kind = ContactOpening::Kind;
    Watched& contact = contacts_[i];
    const double level = -piece.noise;
    const double begin = value_at(force, -1);
    if (contact.state != State::kOpen && begin < level) {
      const bool jumps = contact.end > 1e-6 * (std::abs(force[0]) + spread(force)) + piece.noise;
      const bool grown = left_out_ && contact.end > kGrown * contact.least;
      add_opening(i, beginning_of(piece),
                  contact.state == State::kUnknown ? Kind::kPulled
                  : grown                          ? Kind::kPole
                  : jumps                          ? Kind::kPulled
                                                   : Kind::kRoot);
      contact.state = State::kOpen;
    } else if (contact.state != State::kOpen || begin > piece.noise) {
      contact.state = State::kPressing;
    }
    const ForceSeries pull = negative(force);
    for (double t = -1;;) {
      const bool open = contact.state == State::kOpen;
      const auto next = first_below(open ? pull : force, level, t);
      if (!next) {
        return;
      }
      if (!open) {
        const double zero = parameter(piece, zero_before(force, t, *next));
        add_opening(i, polished(before, piece, i, force, zero), Kind::kRoot);
      }
      contact.state = open ? State::kPressing : State::kOpen;
      t = *next;
    }
  }

  // Newton's method with the force itself and the slope of its series, from the series' zero.
  double polished(const ForceFitter::Position& before, const ForcePiece& piece, std::size_t i,
                  const ForceSeries& force, double zero) {
    const ForceSeries slope = derivative(force);
    const double half_length = (piece.to - piece.from) / 2;
    Run probe = before.run;
    std::vector<DriverMotion> drivers;
    double at = zero;
    for (int pass = 0; pass < 2 && half_length > 0 && at > before.at; ++pass) {
      path_.motion(at, drivers);
      move_to(probe, drivers);
      if (!fitter_.columns().solve(probe) || !fitter_.columns().is_known(i)) {
        return zero;
      }
      double value = 0;
      for (std::size_t part = 0; part < ForcePiece::kParts; ++part) {
        value += fitter_.columns().value(i, part);
      }
      const double t = (at - piece.from) / half_length - 1;
      const double step = -value / value_at(slope, t) * half_length;
      if (!(std::abs(step) < 1e-6 * half_length)) {
        return zero;
      }
      at = std::clamp(at + step, piece.from, piece.to);
    }
    return at;
  }

  void add_opening(std::size_t contact, double at, ContactOpening::Kind kind) {
    forces_.openings.push_back({contact, kind, at, driver_at(at)});
  }

  void find_lowest(const ForcePiece& piece, std::size_t i, const ForceSeries& force) {
    std::optional<LowestForce>& lowest = forces_.lowest[i];
    if (lowest && !(force[0] - spread(force) < lowest->force - piece.noise)) {
      return;
    }
    LowestValue best{-1, std::numeric_limits<double>::infinity()};
    find_lower(force, 1e-15 * (std::abs(force[0]) + spread(force)), best);
    if (!lowest || best.value < lowest->force - piece.noise) {
      const double t = settled_minimum(force, best.t);
      const double at = parameter(piece, t);
      lowest = LowestForce{value_at(force, t), at, driver_at(at), t != -1 || !piece.singular_from};
    }
  }

  [[nodiscard]] double driver_at(double at) const {
    std::vector<DriverMotion> there;
    path_.motion(at, there);
    return there.front().position;
  }

  [[nodiscard]] const Run& run() const { return fitter_.position().run; }

  const DriverPath& path_;
  ForceFitter fitter_;
  std::vector<Watched> contacts_;
  ContactForces forces_;
  bool moved_ = false;              // the path has more than one position
  double longest_ = 0;              // first pieces of this stretch
  std::optional<double> left_out_;  // from where on something singular is left out since the last piece
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

ContactForces follow_contact_forces(const Run& start, const DriverPath& path, std::vector<Preload> preloads) {
  return Recorder(start, path, std::move(preloads)).record();
}

}  // namespace higherpair
