#include "rows_law.hpp"

#include "higherpair/analysis/run.hpp"
#include "higherpair/front/motion.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/row_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/core.h>

namespace higherpair::fire {
namespace {

constexpr std::array<std::int64_t, 3> kSamples{7, 61, 601};  // each includes the rows of the one before

constexpr double kPlaceTolerance = 1e-8;  // of an event, as a fraction of the path
constexpr double kLimitTolerance = 1e-9;  // of a limit; known to within rounding, because u' = 0
constexpr double kDwellNoise = 1e-4;      // relative to the square of velocities (in m and rad)
constexpr double kValueTolerance = 1e-9;  // relative to the size of positions, or of rates

RowValues values_of(const Run& run) {
  RowValues values;
  values.status = run.row.status;
  values.rates = run.row.all_rates;
  for (std::size_t i = 1; i < run.row.bodies.size(); ++i) {
    const BodyMotion& B = run.row.bodies[i];
    const auto add = [](std::vector<double>& to, const Vector2d& linear, double angular) {
      to.insert(to.end(), {linear.x(), linear.y(), angular});
    };
    add(values.place, B.X_WB.p_WB, B.theta);
    add(values.velocity, B.v_WB, B.omega);
    add(values.acceleration, B.a_WB, B.alpha);
  }
  return values;
}

// Records a run row by row.
class Recorder {
public:
  Recorder(const Profile& profile, const DriverSchedule& schedule) : profile_(profile), schedule_(schedule) {}

  RunRecord record();

private:
  void move(Run& run, std::int64_t k);
  void note(const Run& run, std::int64_t k, double from, double to);

  const Profile& profile_;
  const DriverSchedule& schedule_;
  RunRecord record_;
};

void Recorder::note(const Run& run, std::int64_t k, double from, double to) {
  const auto rows = static_cast<double>(schedule_.size() - 1);
  for (const RunEvent& event : run.events) {
    Happening happening{std::string(name_of(event.type)), "", 0, event.driver, static_cast<std::size_t>(k)};
    if (event.contact) {
      happening.item = profile_.mechanism.contacts[*event.contact].name;
    } else if (event.joint) {
      happening.item = profile_.mechanism.joints[*event.joint].name;
    }
    happening.is_limit = event.type == EventType::kLimitPosition ||
                         (event.type == EventType::kEnd && event.joint && !event.contact);
    const double share = std::lerp(from, to, event.share);
    happening.share = (static_cast<double>(k - 1) + share) / rows;
    if (schedule_.is_timed() && schedule_.driver_count() == 1) {
      const Dimension unit = driver_dimension(profile_.mechanism);
      const double position = from_si(unit, profile_.units).apply(event.driver);
      happening.share = schedule_.passing_time(k, position, share) / schedule_.time(schedule_.size() - 1);
    }
    record_.events.push_back(happening);
  }
}

void Recorder::move(Run& run, std::int64_t k) {
  move_to_row(run, schedule_, k, drivers_in(schedule_, k),
              [&](double from, double to) { note(run, k, from, to); });
}

RunRecord Recorder::record() {
  auto run = start_run(profile_.mechanism, schedule_.first_positions());
  if (!run) {
    record_.not_started = run.error().reason;
    return record_;
  }
  for (std::int64_t k = 0; k < schedule_.size(); ++k) {
    move(*run, k);
    record_.rows.push_back(values_of(*run));
  }
  return record_;
}

const Happening* first_limit(const RunRecord& run) {
  const auto found = std::find_if(run.events.begin(), run.events.end(),
                                  [](const Happening& event) { return event.is_limit; });
  return found == run.events.end() ? nullptr : &*found;
}

}  // namespace

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) {
    most = std::max(most, std::abs(value));
  }
  return most;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double one = std::abs(a[i] - b[i]);
    if (std::isnan(one)) return std::numeric_limits<double>::infinity();
    most = std::max(most, one);
  }
  return most;
}

namespace {

// Compares two runs of one mechanism.
class Comparison {
public:
  Comparison(const RunRecord& coarse, const RunRecord& fine) : coarse_(coarse), fine_(fine) {}

  Failure compare();
  /// Of rows alone, before the first limit or beyond it. \pre both runs have two rows
  Failure rows(bool beyond);

private:
  [[nodiscard]] std::string at(std::size_t k) const {
    return fmt::format("row {} of {} and {}", k, coarse_.rows.size(), fine_.rows.size());
  }
  Failure limits();
  Failure events(bool beyond);
  Failure row(std::size_t k, const RowValues& a, const RowValues& b);

  const RunRecord& coarse_;
  const RunRecord& fine_;
  double end_ = 2;  ///< fraction of the path at which the first limit is
};

Failure Comparison::limits() {
  const Happening* a = first_limit(coarse_);
  const Happening* b = first_limit(fine_);
  const auto text = [](const Happening* limit) {
    return limit == nullptr ? std::string("none")
                            : fmt::format("{} ({} of the path)", limit->driver, limit->share);
  };
  if (a == nullptr && b == nullptr) {
    return {};
  }
  const auto numbers =
      fmt::format("{} at {} rows, {} at {}", text(a), coarse_.rows.size(), text(b), fine_.rows.size());
  if (a == nullptr || b == nullptr) {
    return {"limit in one run only", numbers, 0};
  }
  end_ = std::min(a->share, b->share);
  if (!(std::abs(a->share - b->share) <= kLimitTolerance)) {
    return {"limit elsewhere", numbers, 0};
  }
  return {};
}

Failure Comparison::events(bool beyond) {
  const auto chosen = [&](const RunRecord& run) {
    std::vector<Happening> events;
    for (const Happening& event : run.events) {
      const bool behind = event.share > end_ + kPlaceTolerance;
      if (behind == beyond && (beyond || !event.is_limit)) {
        events.push_back(event);
      }
    }
    return events;
  };
  const std::vector<Happening> few = chosen(coarse_);
  std::vector<Happening> many = chosen(fine_);
  const auto differs = [&](const Happening& event, const RunRecord& in) {
    return Failure{fmt::format("{}event {}", beyond ? "beyond: " : "", event.type),
                   fmt::format("{} at {} ({} of the path) only at {} rows", event.item, event.driver,
                               event.share, in.rows.size()),
                   0};
  };
  for (const Happening& event : few) {
    const auto twin = std::find_if(many.begin(), many.end(), [&](const Happening& other) {
      return other.type == event.type && other.item == event.item &&
             std::abs(other.share - event.share) <= kPlaceTolerance;
    });
    if (twin == many.end()) {
      return differs(event, coarse_);
    }
    many.erase(twin);
  }
  return many.empty() ? Failure{} : differs(many.front(), fine_);
}

Failure Comparison::row(std::size_t k, const RowValues& a, const RowValues& b) {
  if (a.status != b.status) {
    return {"status", fmt::format("{}: {} and {}", at(k), name_of(a.status), name_of(b.status)),
            static_cast<int>(k)};
  }
  if (a.status == RowStatus::kNotAssemblable) {
    return {};
  }
  // Drivers' coordinates are rounded to eps. Near a limit the derivatives of position grow like δ^(-1/2),
  // δ^(-3/2), δ^(-5/2), and so does the effect of eps on position, velocity and acceleration.
  constexpr double kDriverRounding = 1e-14;
  const double V = largest(b.velocity);
  const double A = largest(b.acceleration);
  const double J = V > 0 ? A * A / V : 0;
  const auto check = [&](const char* what, const std::vector<double>& x, const std::vector<double>& y,
                         double size, double steep) -> Failure {
    const double tolerance = kValueTolerance * size + kDriverRounding * steep;
    const double error = difference(x, y);
    return error <= tolerance
               ? Failure{}
               : Failure{what, fmt::format("{}: differ by {}, tolerance {}", at(k), error, tolerance),
                         static_cast<int>(k)};
  };
  if (auto f = check("value: position", a.place, b.place, 1 + largest(b.place), V)) {
    return f;
  }
  if (!a.rates || !b.rates) {
    return a.rates == b.rates ? Failure{} : Failure{"value: rates defined", at(k), static_cast<int>(k)};
  }
  if (auto f = check("value: velocity", a.velocity, b.velocity, V, A)) {
    return f;
  }
  // For a follower at rest A is merely the noise of its velocities.
  return check("value: acceleration", a.acceleration, b.acceleration, A + kDwellNoise * V * V, J);
}

Failure Comparison::rows(bool beyond) {
  const std::size_t stride = (fine_.rows.size() - 1) / (coarse_.rows.size() - 1);
  for (std::size_t k = 0; k < coarse_.rows.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(coarse_.rows.size() - 1);
    // A row that is at a limit to within rounding may be on either side of it.
    if ((share > end_) != beyond || std::abs(share - end_) < kLimitTolerance) {
      continue;
    }
    if (auto f = row(k, coarse_.rows[k], fine_.rows[k * stride])) {
      f.law = (beyond ? "beyond: " : "") + f.law;
      return f;
    }
  }
  return {};
}

Failure Comparison::compare() {
  if (coarse_.not_started.empty() != fine_.not_started.empty()) {
    return {"start", coarse_.not_started + fine_.not_started, 0};
  }
  if (!coarse_.not_started.empty()) {
    return {};
  }
  if (auto f = limits()) {
    return f;
  }
  for (const bool beyond : {false, true}) {
    if (auto f = rows(beyond)) {
      return f;
    }
    if (auto f = events(beyond)) {
      return f;
    }
  }
  return {};
}

// Conditions that no run may violate.
Failure sound(const RunRecord& run) {
  const Happening* limit = first_limit(run);
  for (std::size_t k = 0; k < run.rows.size(); ++k) {
    const RowStatus status = run.rows[k].status;
    const auto fail = [&](const char* law) {
      return Failure{law, fmt::format("row {} of {}", k, run.rows.size()), static_cast<int>(k)};
    };
    if (status == RowStatus::kNotConverged) {
      return fail("not converged");
    }
    const double share = static_cast<double>(k) / static_cast<double>(run.rows.size() - 1);
    // Right before a limit at infinity rows cannot be computed either.
    const bool is_before = limit == nullptr || (limit->share > share + kLimitTolerance && limit->row > k);
    if (status == RowStatus::kNotAssemblable && is_before) {
      return fail("not assemblable without a limit");
    }
  }
  return {};
}

// Rows right before and behind what happens on the path, each reached at once and among many others.
class RowsAtEvents {
public:
  RowsAtEvents(const Profile& profile, const DriverSchedule& schedule, const RunRecord& fine)
      : profile_(profile),
        from_(schedule.state(0, 0).si.position),
        to_(schedule.state(schedule.size() - 1, 0).si.position) {
    const Happening* limit = first_limit(fine);
    for (const Happening& event : fine.events) {
      if (limit != nullptr && event.share >= limit->share) break;
      if (events_.empty() || event.driver != events_.back()) events_.push_back(event.driver);
      if (events_.size() == kMostEvents) break;
    }
  }

  Failure compare() {
    std::vector<double> places;
    for (const double event : events_) {
      for (const double distance : kDistances) {
        for (const double at : {event - distance * (to_ - from_), event + distance * (to_ - from_)}) {
          if ((at - from_) * (to_ - at) > 0) places.push_back(at);
        }
      }
    }
    std::sort(places.begin(), places.end(),
              [&](double a, double b) { return std::abs(a - from_) < std::abs(b - from_); });
    if (places.size() < 2) {
      return {};
    }
    const RunRecord among_others = all_of(places);
    RunRecord at_once;
    for (const double place : places) {
      at_once.rows.push_back(all_of({place}).rows.back());
    }
    Failure failure = Comparison(at_once, among_others).rows(false);
    if (failure) {
      failure.law = "at events: " + failure.law;
      failure.detail += fmt::format(", driver at {}", places[failure.row]);
    }
    return failure;
  }

private:
  static constexpr std::size_t kMostEvents = 6;
  static constexpr std::array<double, 5> kDistances{1e-2, 1e-3, 1e-4, 1e-6, 1e-8};  // fractions of the path

  // Their rows in one run.
  [[nodiscard]] RunRecord all_of(const std::vector<double>& places) const {
    RunRecord record;
    auto run = start_run(profile_.mechanism, {from_});
    for (const double place : places) {
      move_to(*run, {{place, 1, 0}});
      record.rows.push_back(values_of(*run));
    }
    return record;
  }

  const Profile& profile_;
  double from_, to_;
  std::vector<double> events_;  // positions of the driver
};

}  // namespace

RunRecord record_run(const Profile& profile, bool timed, std::int64_t samples) {
  const auto schedule =
      timed ? DriverSchedule::step(profile, samples) : DriverSchedule::analyze(profile, samples);
  if (!schedule) {
    return {to_string(schedule.error().front()), {}, {}};
  }
  return Recorder(profile, *schedule).record();
}

Failure rows_law(const Profile& profile, bool timed) {
  std::vector<RunRecord> runs;
  for (const std::int64_t samples : kSamples) {
    runs.push_back(record_run(profile, timed, samples));
  }
  for (const RunRecord& run : {runs[2], runs[1], runs[0]}) {
    if (auto f = sound(run)) {
      return f;
    }
  }
  for (const std::size_t few : {1U, 0U}) {
    if (auto f = Comparison(runs[few], runs[2]).compare()) {
      return f;
    }
  }
  const auto schedule = DriverSchedule::analyze(profile, 2);
  return timed || !schedule || schedule->driver_count() != 1 || !runs[2].not_started.empty()
             ? Failure{}
             : RowsAtEvents(profile, *schedule, runs[2]).compare();
}

}  // namespace higherpair::fire
