#include "coupled_crossing.hpp"

#include "higherpair/contact/step_agreement.hpp"
#include "root_between.hpp"
#include "step.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/math/tools/roots.hpp>

namespace higherpair {
namespace {

// Of the driver's scale: how far before the crossing a closer look begins, one after the other. Steps are
// short enough for their predictions to lie far nearer to their own branch than to the other one.
constexpr std::array kDistances{1e-2, 1e-3, 1e-4, 1e-5};

// A run that walks up to a crossing; what it stood at comes back at the end.
class WayToCrossing {
public:
  WayToCrossing(Run& run, const Path& path, std::size_t g, double s, double h)
      : run_(run), path_(path), g_(g), start_(run.state), s_(s), end_(h), unit_(unit_of(run, path)) {}
  WayToCrossing(const WayToCrossing&) = delete;
  WayToCrossing& operator=(const WayToCrossing&) = delete;
  ~WayToCrossing() { run_.state = start_; }

  // Goes to `distance` before the crossing; false where the motion does not lead there.
  bool come_to(double distance) {
    const double d = std::copysign(distance * unit_, end_);
    const auto x = crossing(std::abs(d) / 10);
    if (!x || !place(*x - d) || mode() != start_.groups[g_].mode) {
      return false;
    }
    std::swap(run_.state, run_.trial);
    s_ += *x - d;
    end_ = 2 * d;
    return true;
  }

  // Whether a step to as far beyond the crossing leads straight on.
  bool passes() {
    return place(end_) && mode() != start_.groups[g_].mode &&
           agrees(run_, run_.plan.groups[g_], end_, kCrossingAgreement);
  }

  double sine(double x) { return place(x) ? run_.trial.groups[g_].sine : NAN; }
  [[nodiscard]] double here() const { return s_; }
  [[nodiscard]] double end() const { return end_; }

private:
  [[nodiscard]] int mode() const { return run_.trial.groups[g_].mode; }

  // The groups up to g, with their rates.
  bool place(double x) { return solve_before(run_, path_, g_ + 1, s_, x); }

  // The change of sign, to a tolerance. Where the group cannot be solved the crossing is too near to matter.
  std::optional<double> crossing(double tolerance) {
    const double before = run_.state.groups[g_].sine;
    if (!(before * sine(end_) < 0)) {
      return std::nullopt;
    }
    const auto value = [&](double x) {
      const double there = x == 0 ? before : sine(x);
      return std::isfinite(there) ? there : 0;
    };
    std::uintmax_t calls = 100;
    const auto bracket = boost::math::tools::bisect(
        value, std::min(0.0, end_), std::max(0.0, end_),
        [tolerance](double a, double b) { return std::abs(a - b) <= tolerance; }, calls);
    return (bracket.first + bracket.second) / 2;
  }

  Run& run_;
  const Path& path_;
  std::size_t g_;
  State start_;
  double s_;    // where run.state stands
  double end_;  // of the step that crosses, from there
  double unit_;
};

}  // namespace

bool passes_crossing(Run& run, const Path& path, std::size_t g, double s, double h) {
  WayToCrossing way(run, path, g, s, h);
  return std::all_of(kDistances.begin(), kDistances.end(),
                     [&](double distance) { return way.come_to(distance); }) &&
         way.passes();
}

std::optional<double> place_of_crossing(Run& run, const Path& path, std::size_t g, double s, double h) {
  WayToCrossing way(run, path, g, s, h);
  if (!way.come_to(kDistances[0]) || !way.come_to(kDistances[1])) {
    return std::nullopt;
  }
  const double d = way.end() / 4;
  const double middle = 2 * d;
  const auto t = root_of_cubic(way.sine(middle - 3 * d), way.sine(middle - d), way.sine(middle + d),
                               way.sine(middle + 3 * d));
  return t ? std::optional(way.here() + middle + *t * d) : std::nullopt;
}

}  // namespace higherpair
