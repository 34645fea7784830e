#pragma once

#include "analysis/tolerances.hpp"
#include "path_events.hpp"

#include <cstddef>
#include <optional>

namespace higherpair {

/// A limit on a path, and the group that reaches it.
struct PathLimit {
  std::size_t group = 0;
  double s = 0;
};

/// Places run.work.trial at a limit ahead of run.at.state, which is at s, if the positions of its group turn
/// back there: their rates are unbounded. False at other limits, as at the end of a curve.
[[nodiscard]] bool place_at_limit(Run& run, const Path& path, const PathLimit& limit, double s);

/// The first known limit on a path ahead of run.at.state, which is at s.
class LimitAhead {
public:
  /// \param scale  one unit of the path's coordinate
  LimitAhead(Run& run, const Path& path, double scale) : run_(run), path_(path), scale_(scale) {}

  [[nodiscard]] bool is_known() const { return limit_.has_value(); }
  /// \pre is_known()
  [[nodiscard]] const PathLimit& known() const { return *limit_; }
  void forget() {
    limit_.reset();
    far_.reset();
  }

  /// Called where a step from s has failed or a limit is known. If a contact or coupled bodies are far away
  /// and on their way to infinity, keeps run.at.state: the last such position whose rates still have their
  /// digits. Forgets it where they have come back from there.
  void look_how_far(double s);
  /// Restores the state that look_how_far() has kept, if any, and returns its s.
  std::optional<double> go_back_from_far();

  /// The largest step from s: a fraction of the distance to the limit; infinite where none is known.
  [[nodiscard]] double longest_step(double s) const;
  [[nodiscard]] bool is_reached(double s) const { return is_within(kReachesLimit, s); }
  /// Whether the limit is so near that rates may be too inexact to go on.
  [[nodiscard]] bool is_near(double s) const;
  /// The group that is lost between s and the limit, if it is not the limit's own. \pre is_known()
  [[nodiscard]] std::optional<std::size_t> lost_before(double s) const;
  /// Whether the limit comes before the end of the path. \pre is_known()
  [[nodiscard]] bool is_on_path() const;

  /// Looks for the limit of group g after a step of `h` from s has failed; it becomes the known one if it
  /// comes first. True if it is at the end of the path: it is then reported, run.at.beside is set to the
  /// position there, which has no rates, and run.at.inputs to where run.at.state is, short of it.
  [[nodiscard]] bool look_for(std::size_t g, double s, double h);

  /// Whether the end of the path is just before the limit, so near that no step to it can be verified:
  /// run.at.beside is then set to the position there, and run.at.inputs to where run.at.state is, at s. \pre
  /// is_known()
  [[nodiscard]] bool rests_before(double s);

  /// The limit of group g, or of one before it, to be assumed where none is found although no step from s
  /// succeeds. Where bodies run off to infinity there is no last position; its distance is extrapolated from
  /// their speed. At an end of a curve or of a guide it is the shortest step ahead.
  [[nodiscard]] PathLimit assumed(std::size_t g, double s) const;

private:
  struct Far {
    State state;
    double s = 0;
  };

  [[nodiscard]] bool is_within(double share, double s) const;
  /// Where the asymptotes of a contact of group g, or of one before it, coincide; none if that is not near s,
  /// from where no step succeeds.
  [[nodiscard]] std::optional<PathLimit> asymptotes_coincide(std::size_t g, double s) const;

  Run& run_;
  const Path& path_;
  double scale_;
  std::optional<PathLimit> limit_;
  std::optional<Far> far_;
};

}  // namespace higherpair
