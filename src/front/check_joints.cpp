// Accelerations and jerks of the bodies that move on ground.
#include "check_parts.hpp"
#include "higherpair/analysis/jerk.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace higherpair {
namespace {

using Bound = CheckFigures::Bound;

constexpr Dimension kJerk = dimension::kAcceleration / dimension::kTime;
constexpr Dimension kAngularJerk = dimension::kAngularAcceleration / dimension::kTime;

// Third time derivatives of the drivers: 0 without a law; with a law, known only for a run in time.
class DriverJerks {
public:
  DriverJerks(const Profile& profile, const DriverSchedule& schedule) {
    for (std::size_t i = 0; i < profile.programs.size(); ++i) {
      const Dimension of = has_angle(driven_joint(profile.mechanism, i).type) ? kAngularJerk : kJerk;
      laws_.push_back({profile.programs[i].law, to_si(of, profile.units)});
      known_ = known_ && (!profile.programs[i].law || schedule.is_timed());
    }
    time_ = from_si(dimension::kTime, profile.units);
  }

  [[nodiscard]] bool known() const { return known_; }

  [[nodiscard]] std::vector<HigherRates> at(double time) const {
    std::vector<HigherRates> rates;
    for (const auto& [law, scale] : laws_) {
      rates.push_back({law ? scale.apply(law->derivative(3, time_.apply(time))) : 0, 0, 0, 0});
    }
    return rates;
  }

private:
  std::vector<std::pair<std::optional<MotionLaw>, Scaling>> laws_;
  Scaling time_;
  bool known_ = true;
};

// Accelerations and jerks of the joints on which bodies move against ground.
class CheckedJoints {
public:
  explicit CheckedJoints(const CheckedPath& checked)
      : outputs_(checked.start.at.outputs),
        jerks_(checked.profile, checked.schedule),
        size_(checked.start.plan().size),
        rate_(driver_rate(checked)) {
    for (const OutputJoint& output : outputs_) {
      names_.push_back(checked.start.mechanism().joints[output.joint].name);
    }
  }

  /// \param order  of the derivative \param rounding  relative to size · rate^order
  [[nodiscard]] std::vector<Sought> sought(int order, double rounding) const {
    std::vector<Sought> all;
    for (const OutputJoint& output : outputs_) {
      all.push_back({true, true, rounding * std::pow(rate_, order) * (output.turns ? 1 : size_)});
    }
    return all;
  }

  void fill_accelerations(const Run& run, std::span<double> out) const {
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      const Joint& joint = run.mechanism().joints[outputs_[i].joint];
      if (run.row.has_rates[outputs_[i].body]) {
        out[i] = joint_motion(run.mechanism(), joint, run.row.bodies).acceleration;
      }
    }
  }

  void fill_jerks(const Run& run, double at, std::span<double> out) const {
    if (!jerks_.known() || !run.row.all_rates) {
      return;
    }
    const auto bodies = true_jerks_of(run, jerks_.at(at));
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      out[i] = joint_jerk(run, outputs_[i].joint, bodies).value_or(out[i]);
    }
  }

  void read(const PathRanges& accelerations, const PathRanges& jerks, CheckFigures& figures) const {
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      const auto joint = static_cast<std::size_t>(outputs_[i].joint);
      const bool turns = outputs_[i].turns;
      figures.about("joints." + names_[i]);
      const auto add = [&](const std::string& quantity, const Dimension& of, const PathRange& range,
                           LimitKey key) {
        if (const auto peak = peak_of(range)) {
          mark_growing(figures.add(quantity, of, peak->value, peak->driver, figures.of_joint(joint, key),
                                   Bound::kMost),
                       *peak);
        }
      };
      add("acceleration", turns ? dimension::kAngularAcceleration : dimension::kAcceleration,
          accelerations[i], turns ? LimitKey::kMaxAngularAcceleration : LimitKey::kMaxAcceleration);
      add("jerk", turns ? kAngularJerk : kJerk, jerks[i],
          turns ? LimitKey::kMaxAngularJerk : LimitKey::kMaxJerk);
    }
  }

private:
  std::vector<OutputJoint> outputs_;
  std::vector<std::string> names_;
  DriverJerks jerks_;
  double size_;  // of the mechanism
  double rate_;  // largest of the drivers
};

}  // namespace

double driver_rate(const CheckedPath& checked) {
  double rate = 0;
  for (std::size_t i = 0; i < checked.schedule.driver_count(); ++i) {
    const double velocity = std::abs(checked.schedule.state(0, i).si.velocity);
    const bool turns = has_angle(driven_joint(checked.start.mechanism(), i).type);
    rate = std::max(rate, turns ? velocity : velocity / checked.start.plan().size);
  }
  return rate;
}

JointCheck joint_check(const CheckedPath& checked) {
  const auto joints = std::make_shared<CheckedJoints>(checked);
  JointCheck check;
  check.accelerations = {
      joints->sought(2, kTravelRounding),
      [joints](const Run& run, double, std::span<double> out) { joints->fill_accelerations(run, out); }};
  check.jerks = {
      joints->sought(3, kRoundingOfJerk),
      [joints](const Run& run, double at, std::span<double> out) { joints->fill_jerks(run, at, out); }};
  check.read = [joints](const PathRanges& accelerations, const PathRanges& jerks, CheckFigures& figures) {
    joints->read(accelerations, jerks, figures);
  };
  return check;
}

}  // namespace higherpair
