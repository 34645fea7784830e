#include "truth_law.hpp"

#include "analysis/reference_follower.hpp"
#include "higherpair/analysis/run.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "rows_law.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::fire {
namespace {

constexpr std::int64_t kTruthSamples = 61;
constexpr double kTruthTolerance = 1e-9;  // fraction of the path
constexpr double kTwinTolerance = 1e-11;
constexpr double kPositionTolerance = 1e-8;  // relative to the size of positions

// Whether contacts change over to others, which the reference does not notice.
bool changes_contact(const RunRecord& run, double before) {
  return std::any_of(run.events.begin(), run.events.end(), [&](const Happening& event) {
    return event.share <= before && (event.type == "second_contact" || event.type == "conforming");
  });
}

// The reference follows the drawn pose; if bodies overlap in that, the run starts in another assembly.
bool starts_elsewhere(const RunRecord& run, const testing::ReferenceMotion& reference) {
  constexpr double kSamePlace = 1e-6;
  return !reference.places.empty() && difference(run.rows[0].place, reference.places[0]) > kSamePlace;
}

Failure compare_rows(const RunRecord& run, const testing::ReferenceMotion& reference) {
  for (std::size_t k = 0; k < reference.places.size(); ++k) {
    const RowValues& row = run.rows[k];
    if (row.status != RowStatus::kOk) {
      continue;  // overlaps, say: that there is no limit has been compared
    }
    const double error = difference(row.place, reference.places[k]);
    const double size = std::max(1.0, largest(row.place));
    // Near a limit, and near almost crossing branches, rounding errors grow with the rates.
    if (!(error <= kPositionTolerance * size + 1e-13 * largest(row.velocity))) {
      return {"truth: position", fmt::format("row {} of {}: off by {}", k, run.rows.size(), error),
              static_cast<int>(k)};
    }
  }
  return {};
}

}  // namespace

Failure truth_law(const Profile& profile) {
  const RunRecord run = record_run(profile, false, kTruthSamples);
  if (!run.not_started.empty()) {
    return {};
  }
  const auto& contacts = profile.mechanism.contacts;
  if (std::any_of(contacts.begin(), contacts.end(), [](const Contact& c) { return c.by_boundary; })) {
    return {"", "gave up: a curve of several parts", 0};
  }
  const auto schedule = DriverSchedule::analyze(profile, kTruthSamples);
  std::vector<double> to;
  std::vector<double> stations;
  for (std::size_t i = 0; i < schedule->driver_count(); ++i) {
    to.push_back(schedule->state(kTruthSamples - 1, i).si.position);
  }
  for (std::int64_t k = 0; k < kTruthSamples; ++k) {
    stations.push_back(static_cast<double>(k) / (kTruthSamples - 1));
  }
  const auto reference =
      testing::reference_motion(profile.mechanism, schedule->first_positions(), to, stations);
  if (starts_elsewhere(run, reference)) {
    return {"", "gave up: the run starts in another assembly than the drawn one", 0};
  }
  using End = testing::ReferenceMotion::End;
  const auto limit = std::find_if(run.events.begin(), run.events.end(),
                                  [](const Happening& event) { return event.type == "limit_position"; });
  const double found = limit == run.events.end() ? 2 : limit->share;
  const double wanted = reference.end == End::kLimit ? reference.share : 2;
  if (reference.end == End::kGaveUp || changes_contact(run, std::min(found, wanted))) {
    return {"", "gave up: " + reference.why, 0};
  }
  if (!(std::abs(found - wanted) <= kTruthTolerance)) {
    const auto text = [](double share) { return share > 1 ? std::string("none") : fmt::format("{}", share); };
    return {found > 1    ? "truth: limit missed"
            : wanted > 1 ? "truth: limit where there is none"
                         : "truth: limit elsewhere",
            fmt::format("{} of the path, true {}", text(found), text(wanted)), 0};
  }
  return compare_rows(run, reference);
}

Failure twin_law(const Profile& profile, const Profile& twin) {
  const RunRecord run = record_run(profile, false, kTruthSamples);
  const RunRecord other = record_run(twin, false, kTruthSamples);
  if (!run.not_started.empty() || !other.not_started.empty()) {
    const bool same = run.not_started.empty() == other.not_started.empty();
    return {same ? "" : "twin: start", same ? "cannot be started" : run.not_started + other.not_started, 0};
  }
  for (std::size_t k = 0; k < run.rows.size(); ++k) {
    const RowValues& a = run.rows[k];
    const RowValues& b = other.rows[k];
    if (a.status != b.status) {
      return {"twin: status", fmt::format("row {}: {} and {}", k, name_of(a.status), name_of(b.status)),
              static_cast<int>(k)};
    }
    if (a.status != RowStatus::kOk) {
      return {};
    }
    // Near a limit every derivative amplifies rounding of the driver's coordinate.
    const double V = largest(b.velocity);
    const double A = largest(b.acceleration);
    const double J = V > 0 ? A * A / V : 0;
    const auto differs = [&](const char* what, const std::vector<double>& x, const std::vector<double>& y,
                             double size, double steep) -> Failure {
      const double error = difference(x, y);
      const double tolerance = kTwinTolerance * size + 1e-14 * steep;
      return error <= tolerance
                 ? Failure{}
                 : Failure{what, fmt::format("row {}: off by {} of {}", k, error, size), static_cast<int>(k)};
    };
    if (auto f = differs("twin: position", a.place, b.place, 1 + largest(b.place), V)) {
      return f;
    }
    if (!a.rates || !b.rates) {
      continue;
    }
    if (auto f = differs("twin: velocity", a.velocity, b.velocity, V, A)) {
      return f;
    }
    if (auto f = differs("twin: acceleration", a.acceleration, b.acceleration, A + 0.01 * V * V, J)) {
      return f;
    }
  }
  return {};
}

}  // namespace higherpair::fire
