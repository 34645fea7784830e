// Accelerations and jerks of the bodies that move on ground.
#include "check_parts.hpp"
#include "front/columns/path_columns.hpp"
#include "front/tolerances.hpp"
#include "higherpair/analysis/jerk.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"

#include <cmath>
#include <memory>

namespace higherpair {
namespace {

constexpr Dimension kJerk = rate_of(dimension::kLength, 3);
constexpr Dimension kAngularJerk = rate_of(dimension::kAngle, 3);

// Accelerations and jerks of the joints on which bodies move against ground, driven ones included.
class CheckedJoints {
public:
  explicit CheckedJoints(const CheckedPath& checked)
      : drivers_(checked.profile, checked.schedule),
        size_(checked.start.plan().size),
        rate_(largest_rate(checked.schedule, checked.start)) {
    const Mechanism& mechanism = checked.start.mechanism();
    for (const DriverProgram& program : checked.profile.programs) {
      known_ = known_ && (!program.law || checked.schedule.is_timed());
    }
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
      const Joint& joint = mechanism.joints[i];
      if ((joint.first.body == 0) == (joint.second.body == 0) || !can_be_driven(joint.type)) continue;
      const int index = static_cast<int>(i);
      joints_.push_back({index, end_off(joint, kGround).body, joint.type == JointType::kRevolute,
                         is_driven(mechanism, index), joint.name});
    }
  }

  /// \param order  of the derivative \param rounding  relative to size · rate^order
  [[nodiscard]] std::vector<Sought> sought(int order, double rounding) const {
    std::vector<Sought> all;
    for (const Moving& joint : joints_) {
      all.push_back({true, true, rounding * std::pow(rate_, order) * (joint.turns ? 1 : size_)});
    }
    return all;
  }

  void fill_accelerations(const Run& run, std::span<double> out) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const Joint& joint = run.mechanism().joints[joints_[i].joint];
      if (run.row.has_rates[joints_[i].body]) {
        out[i] = joint_motion(run.mechanism(), joint, run.row.bodies).acceleration;
      }
    }
  }

  void fill_jerks(const Run& run, double at, std::span<double> out) const {
    if (!known_ || !run.row.all_rates) {
      return;
    }
    const auto bodies = true_jerks_of(run, driver_jerks(at));
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      out[i] = joint_jerk(run, joints_[i].joint, bodies).value_or(out[i]);
    }
  }

  void read(const PathRanges& accelerations, const PathRanges& jerks, CheckFigures& figures) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const auto joint = static_cast<std::size_t>(joints_[i].joint);
      const bool turns = joints_[i].turns;
      figures.about("joints." + joints_[i].name);
      const auto add = [&](const std::string& quantity, const Dimension& of, const PathRange& range,
                           LimitKey key) {
        const auto peak = peak_of(range);
        const GivenLimit* limit = figures.of_joint(joint, key);
        // That a driver runs evenly is worth a figure only where it is limited.
        const bool worth = peak && (!joints_[i].driven || peak->value != 0 || limit != nullptr);
        if (worth) add_peak(quantity, of, range, limit, figures);
      };
      add("acceleration", turns ? dimension::kAngularAcceleration : dimension::kAcceleration,
          accelerations[i], turns ? LimitKey::kMaxAngularAcceleration : LimitKey::kMaxAcceleration);
      add("jerk", turns ? kAngularJerk : kJerk, jerks[i],
          turns ? LimitKey::kMaxAngularJerk : LimitKey::kMaxJerk);
    }
  }

private:
  struct Moving {
    int joint;
    int body;  // that moves against ground
    bool turns;
    bool driven;
    std::string name;
  };

  // Third time derivatives of the drivers: 0 for those without a law.
  [[nodiscard]] std::vector<HigherRates> driver_jerks(double time) const {
    std::vector<HigherRates> jerks(drivers_.schedule().driver_count(), HigherRates{});
    if (drivers_.schedule().is_timed()) {
      const std::vector<DriverState> states = drivers_.at_time(time);
      for (std::size_t i = 0; i < jerks.size(); ++i) jerks[i][0] = states[i].higher_si[0];
    }
    return jerks;
  }

  std::vector<Moving> joints_;
  DriverPlaces drivers_;
  bool known_ = true;  // whether the drivers' jerks are: those of laws only in time
  double size_;        // of the mechanism
  double rate_;        // largest of the drivers
};

}  // namespace

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
