#include "higherpair/dynamics/contact_forces.hpp"

#include "force_columns.hpp"
#include "numeric/chebyshev.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

namespace higherpair {
namespace {

// Multipliers are balances of forces that may be much larger: below this share of the largest they are
// rounding.
constexpr double kMultiplierRounding = 1e-11;

// Longest piece: of a turning driver [rad], of a sliding one relative to the size. Forces of ordinary cams
// are resolved on pieces between one and a quarter of this.
constexpr double kLongestPieceTurn = kPi / 6;
constexpr double kLongestPieceSlide = 0.25;

// Shortest piece, relative to the longest; next to a pole or a root of the driver no piece converges.
constexpr double kShortestPiece = 0x1p-16;
// Events nearer to the end of a piece, relative to the longest, are at the end.
constexpr double kAtEnd = 1e-9;

// A series has converged when its last coefficients are below this, relative to the largest multiplier.
constexpr double kConverged = 1e-13;
// Near crossings of branches rates have fewer digits: a series whose last coefficients are below this and do
// not fall by kFalls when the piece is halved shows their rounding.
constexpr double kRough = 1e-8;
constexpr double kFalls = 8;

// Forces are resolved relative to the largest in their piece, but no smaller than kFloor of what they are on
// all but the worst tenth of the path, which may be next to a pole.
constexpr int kFloorSamples = 64;
constexpr double kUsual = 0.9;
constexpr double kFloor = 0.1;

// A force that has grown by this up to where it changes sign without a zero has a pole there.
constexpr double kGrown = 1e3;

// Forces or their rates may be discontinuous there.
bool breaks_forces(const RunEvent& event) {
  return event.type == EventType::kLimitPosition || event.type == EventType::kDeadPoint ||
         event.type == EventType::kConforming || event.type == EventType::kSecondContact ||
         event.type == EventType::kCurvatureJump || event.type == EventType::kCorner ||
         event.type == EventType::kEnd || event.type == EventType::kEngage ||
         event.type == EventType::kRelease;
}

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

double parameter(const ForcePiece& piece, double t) {
  return t == -1  ? piece.from
         : t == 1 ? piece.to
                  : (piece.from + piece.to) / 2 + t * (piece.to - piece.from) / 2;
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
      : path_(path), run_(start), columns_(start, preloads), contacts_(start.mechanism().contacts.size()) {
    forces_.preloads = std::move(preloads);
    forces_.lowest.resize(contacts_.size());
  }

  ContactForces record() {
    set_floor();
    at_ = path_.knots.front();
    path_.motion(at_, drivers_);
    std::vector<DriverMotion> from = drivers_;
    for (std::size_t i = 1; i < path_.knots.size(); ++i) {
      path_.motion(path_.knots[i], drivers_);
      add_stretch(path_.knots[i - 1], path_.knots[i], parts_between(from, drivers_));
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

  struct Fit {
    ForcePiece piece;
    std::size_t defined = 0;      // at how many nodes there are forces
    double tail = 0;              // last coefficients, relative to the largest multiplier
    std::optional<double> event;  // a break strictly within
  };

  // A stretch to be resolved.
  struct Span {
    double from = 0;
    double to = 0;
    bool breaks_at_end = false;  // where forces may be discontinuous, so that no row belongs there
    double tail = std::numeric_limits<double>::infinity();  // of the span that it is a half of
  };

  // What the forces are of the order of on most of the path: in a dwell they may be nothing but rounding,
  // which no series resolves.
  void set_floor() {
    floor_.assign(columns_.count(), 0);
    Run probe = run_;
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
            values.begin() + static_cast<std::ptrdiff_t>(kUsual * static_cast<double>(values.size()));
        std::nth_element(values.begin(), usual, values.end());
        floor_[column] = kFloor * *usual;
      }
    }
  }

  // How many pieces to start with; 0 where nothing changes on the whole path.
  [[nodiscard]] double parts_between(const std::vector<DriverMotion>& from,
                                     const std::vector<DriverMotion>& to) const {
    double parts = 0;
    bool changes = false;
    for (std::size_t i = 0; i < to.size(); ++i) {
      const auto joint = static_cast<std::size_t>(run_.mechanism().drivers[i].joint);
      const bool turns = run_.mechanism().joints[joint].type == JointType::kRevolute;
      const double longest = turns ? kLongestPieceTurn : kLongestPieceSlide * run_.plan().size;
      parts = std::max(parts, std::abs(to[i].position - from[i].position) / longest);
      changes = changes || from[i].position != to[i].position || from[i].velocity != to[i].velocity ||
                from[i].acceleration != to[i].acceleration;
    }
    return changes || path_.knots.size() > 2 ? std::max(1.0, std::ceil(parts * (1 - kAtEnd))) : 0;
  }

  void add_stretch(double from, double to, double parts) {
    if (parts == 0) {
      return;
    }
    moved_ = true;
    longest_ = (to - from) / parts;
    for (double i = 0; i < parts && !is_stopped(run_); ++i) {
      resolve({i == 0 ? from : from + i * longest_, i + 1 == parts ? to : from + (i + 1) * longest_});
    }
  }

  // A path of one position.
  void add_position() {
    Fit fit = start_fit({at_, at_});
    if (!sample(at_, fit)) {
      return;
    }
    for (std::size_t i = 0; i < fit.piece.columns.size(); ++i) {
      fit.piece.columns[i] = {columns_.value(i / columns_.count(), i % columns_.count())};
    }
    keep(run_, at_, std::move(fit.piece));
  }

  void resolve(const Span& span) {
    const Run before = run_;
    const double was_at = at_;
    Fit fit = fitted(span);
    if (is_stopped(run_)) {
      return;
    }
    const bool converged = fit.tail <= kConverged || (fit.tail <= kRough && fit.tail * kFalls >= span.tail);
    if (!fit.event && fit.defined == kNodes && converged) {
      keep(before, was_at, std::move(fit.piece));
      return;
    }
    if (!fit.event && fit.defined == 0) {
      for (Watched& contact : contacts_) {
        contact.state = Watched::State::kUnknown;
      }
      left_out_.reset();
      return;
    }
    if (!fit.event && span.to - span.from <= kShortestPiece * longest_) {
      leave_out(span);
      return;
    }
    run_ = before;
    at_ = was_at;
    const double inf = std::numeric_limits<double>::infinity();
    const double split = fit.event.value_or((span.from + span.to) / 2);
    const double tail = fit.event ? inf : fit.tail;
    resolve({span.from, split, fit.event.has_value(), tail});
    resolve({split, span.to, span.breaks_at_end, tail});
  }

  // Next to a singular position.
  void leave_out(const Span& span) {
    if (left_out_) {
      return;
    }
    left_out_ = span.from;
    if (!forces_.pieces.empty() && forces_.pieces.back().to == span.from) {
      forces_.pieces.back().singular_to = true;
    }
    for (auto& lowest : forces_.lowest) {
      if (lowest && lowest->at == span.from) {
        lowest->is_minimum = false;
      }
    }
  }

  Fit start_fit(const Span& span) {
    Fit fit;
    fit.piece.from = span.from;
    fit.piece.to = span.to;
    fit.piece.known.assign(contacts_.size(), true);
    fit.piece.columns.resize(contacts_.size() * columns_.count());
    scales_ = floor_;
    return fit;
  }

  Fit fitted(const Span& span) {
    Fit fit = start_fit(span);
    for (std::size_t j = 0; j < kNodes; ++j) {
      if (sample(parameter(fit.piece, node(j)), fit)) {
        for (std::size_t i = 0; i < fit.piece.columns.size(); ++i) {
          fit.piece.columns[i][j] = columns_.value(i / columns_.count(), i % columns_.count());
        }
      }
      if (fit.event || is_stopped(run_)) {
        return fit;
      }
    }
    if (!span.breaks_at_end) {
      move(span.to, fit);
    }
    if (fit.defined == kNodes) {
      converge(fit);
    }
    return fit;
  }

  void converge(Fit& fit) {
    for (std::size_t i = 0; i < fit.piece.columns.size(); ++i) {
      ForceSeries& series = fit.piece.columns[i];
      series = interpolate(series);
      const double last = std::max(
          {std::abs(series[kNodes - 1]), std::abs(series[kNodes - 2]), std::abs(series[kNodes - 3])});
      const double scale = scales_[i % columns_.count()];
      fit.tail = std::max(fit.tail, scale > 0 ? last / scale : 0);
    }
    fit.piece.noise *= std::max(1.0, 4 * fit.tail / kMultiplierRounding);
  }

  // Moves there; a break on the way that lies within the fit's piece is noted, the first one.
  void move(double to, Fit& fit) {
    path_.motion(at_, was_);
    path_.motion(to, drivers_);
    move_to(run_, drivers_);
    for (const RunEvent& event : run_.events) {
      if (!fit.event && breaks_forces(event)) {
        const double at = place_of(event.share, to);
        const double near = kAtEnd * longest_;
        const bool again =
            last_break_ == event.type && std::abs(at - last_break_at_) < kShortestPiece * longest_;
        if (at > fit.piece.from + near && at < fit.piece.to - near && !again) {
          fit.event = at;
          last_break_ = event.type;
          last_break_at_ = at;
        }
      }
    }
    at_ = to;
  }

  // The parameter at which the drivers have gone a share of their straight way from at_ to `to`.
  [[nodiscard]] double place_of(double share, double to) {
    std::size_t most = 0;
    const auto way = [&](std::size_t i) { return drivers_[i].position - was_[i].position; };
    for (std::size_t i = 1; i < drivers_.size(); ++i) {
      most = std::abs(way(i)) > std::abs(way(most)) ? i : most;
    }
    const double target = was_[most].position + share * way(most);
    const double sense = way(most) < 0 ? -1 : 1;
    std::vector<DriverMotion> there;
    const auto ahead = [&](double at) {
      path_.motion(at, there);
      return sense * (there[most].position - target);
    };
    const double guess = at_ + share * (to - at_);
    const double at_from = ahead(at_), at_to = ahead(to);
    if (!(at_from < 0) || !(at_to > 0) || ahead(guess) == 0) {
      return guess;
    }
    std::uintmax_t calls = 100;
    const auto [a, b] = boost::math::tools::toms748_solve(
        ahead, at_, to, at_from, at_to, boost::math::tools::eps_tolerance<double>(52), calls);
    return (a + b) / 2;
  }

  bool sample(double at, Fit& fit) {
    move(at, fit);
    if (is_stopped(run_) || !columns_.solve(run_)) {
      return false;
    }
    ++fit.defined;
    for (std::size_t column = 0; column < columns_.count(); ++column) {
      scales_[column] = std::max(scales_[column], columns_.largest(column));
    }
    // The parts of a force are known as well as the largest of them.
    const double largest = *std::max_element(scales_.begin(), scales_.begin() + ForcePiece::kParts);
    std::fill(scales_.begin(), scales_.begin() + ForcePiece::kParts, largest);
    fit.piece.noise = kMultiplierRounding * largest;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      fit.piece.known[i] = fit.piece.known[i] && columns_.is_known(i);
    }
    return true;
  }

  void keep(const Run& before, double was_at, ForcePiece piece) {
    piece.singular_from = left_out_.has_value();
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (piece.known[i]) {
        const ForceSeries force = total(piece, i);
        find_openings(before, was_at, piece, i, force);
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
    const bool is_between = last_break_ && last_break_at_ >= *left_out_ && last_break_at_ <= piece.from;
    return is_between ? last_break_at_ : (*left_out_ + piece.from) / 2;
  }

  void find_openings(const Run& before, double was_at, const ForcePiece& piece, std::size_t i,
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
        add_opening(i, polished(before, was_at, piece, i, force, zero), Kind::kRoot);
      }
      contact.state = open ? State::kPressing : State::kOpen;
      t = *next;
    }
  }

  // Newton's method with the force itself and the slope of its series, from the series' zero.
  double polished(const Run& before, double was_at, const ForcePiece& piece, std::size_t i,
                  const ForceSeries& force, double zero) {
    const ForceSeries slope = derivative(force);
    const double half_length = (piece.to - piece.from) / 2;
    Run probe = before;
    std::vector<DriverMotion> drivers;
    double at = zero;
    for (int pass = 0; pass < 2 && half_length > 0 && at > was_at; ++pass) {
      path_.motion(at, drivers);
      move_to(probe, drivers);
      if (!columns_.solve(probe) || !columns_.is_known(i)) {
        return zero;
      }
      double value = 0;
      for (std::size_t part = 0; part < ForcePiece::kParts; ++part) {
        value += columns_.value(i, part);
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

  const DriverPath& path_;
  Run run_;
  ForceColumns columns_;
  std::vector<Watched> contacts_;
  ContactForces forces_;
  double at_ = 0;                   // where run_ is
  bool moved_ = false;              // the path has more than one position
  double longest_ = 0;              // first pieces of this stretch
  std::optional<double> left_out_;  // from where on something singular is left out since the last piece
  std::optional<EventType> last_break_;
  double last_break_at_ = 0;
  std::vector<double> floor_;   // least of `scales_`
  std::vector<double> scales_;  // of the columns of a fit
  std::vector<DriverMotion> drivers_;
  std::vector<DriverMotion> was_;
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
