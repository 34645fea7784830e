// Writes a design as a profile.
#include "design_setup.hpp"
#include "front/analysis_impl.hpp"
#include "front/tolerances.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "numeric/decimal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using NewValue = ProfileDocument::NewValue;

constexpr std::array kPoseNumbers = {"x", "y", "angle"};

bool same_poses(const Run& a, const Run& b) {
  for (std::size_t i = 0; i < a.at.state.bodies.size(); ++i) {
    const BodyMotion& one = a.at.state.bodies[i];
    const BodyMotion& other = b.at.state.bodies[i];
    if ((one.X_WB.p_WB - other.X_WB.p_WB).norm() > kSamePose * a.plan().size ||
        std::abs(one.theta - other.theta) > kSamePose)
      return false;
  }
  return true;
}

bool same_boundary(const NamedCurve& a, const NamedCurve& b) {
  if (!a.boundary || !b.boundary) return a.boundary == b.boundary;
  return std::equal(a.boundary->samples().begin(), a.boundary->samples().end(), b.boundary->samples().begin(),
                    b.boundary->samples().end(),
                    [](const auto& p, const auto& q) { return p.point.p_B == q.point.p_B; });
}

// Whether two profiles that differ in poses have everything else in common, also what is taken from the
// poses.
bool same_but_for_poses(const Profile& a, const Profile& b) {
  const auto without_poses = [](Mechanism mechanism) {
    for (Body& body : mechanism.bodies) {
      body.guess_p_WB = Vector2d::Zero();
      body.guess_theta = 0;
    }
    return numbers_of(mechanism);
  };
  return same_programs(a.programs, b.programs) && without_poses(a.mechanism) == without_poses(b.mechanism) &&
         std::equal(a.mechanism.bodies.begin(), a.mechanism.bodies.end(), b.mechanism.bodies.begin(),
                    b.mechanism.bodies.end(), [](const Body& one, const Body& other) {
                      return std::equal(one.curves.begin(), one.curves.end(), other.curves.begin(),
                                        other.curves.end(), same_boundary);
                    });
}

// The middle of a body's joints, which the choice of an assembly compares with the poses [m].
Vector2d middle_of_joints(const Mechanism& mechanism, int body) {
  Vector2d sum = Vector2d::Zero();
  int count = 0;
  for (const Joint& joint : mechanism.joints) {
    for (const PointRef& ref : {joint.first, joint.second}) {
      if (ref.body != body) continue;
      sum += point_of(mechanism, ref);
      ++count;
    }
  }
  return count > 0 ? Vector2d(sum / count) : sum;
}

// Whether the pose of the group's bodies chooses one of several assemblies, near which it is.
bool is_near_pose(const Group& group, const Mechanism& mechanism) {
  if (const auto placing = placing_contact(group)) {
    return mechanism.contacts[placing->contact].approach == Approach::kNearest;
  }
  return traits_of(group).two_modes || traits_of(group).coupled;
}

// Replaces poses in a profile by those of a run. A number of a pose from which something is taken exactly,
// such as the fixed angle of a slide, is kept.
class Poses {
public:
  /// \param read  the profile with the new values, but with the old poses
  Poses(const ProfileDocument& document, const Model& read, const Run& run, std::vector<NewValue>& values)
      : read_(read), run_(run), values_(values) {
    document.for_each_number([&](const std::string& path, double) { in_text_.insert(path); });
    for (const ProfileDocument::Quantity& quantity : read.data().document->quantities()) {
      present_[quantity.path] = quantity.value;
    }
  }

  void replace() {
    for (const Group& group : run_.plan().groups) {
      if (!is_near_pose(group, run_.mechanism())) continue;
      for (const int body : group.bodies) replace(body);
    }
  }

private:
  void replace(int body) {
    const std::string pose = fmt::format("bodies.{}.pose", run_.mechanism().bodies[body].name);
    const BodyMotion& wanted = run_.at.state.bodies[body];
    const double length = from_si(dimension::kLength, read_.units()).apply(1);
    const double angle = from_si(dimension::kAngle, read_.units()).apply(1);
    std::array<std::optional<double>, 3> changed;
    changed[2] = change(pose + ".angle", angle * wanted.theta, angle);
    // Where the angle is kept, the joints are brought as near as the position can bring them.
    const double theta = changed[2] ? wanted.theta : read_.mechanism().bodies[body].guess_theta;
    const Vector2d middle_B = middle_of_joints(run_.mechanism(), body);
    const Vector2d p = wanted.X_WB * middle_B - Rotation<double>::from_angle(theta) * middle_B;
    changed[0] = change(pose + ".x", length * p.x(), length * run_.plan().size);
    changed[1] = change(pose + ".y", length * p.y(), length * run_.plan().size);
    write(pose, changed);
  }

  // The number to write, rounded; none where it is the present one or has to be kept.
  [[nodiscard]] std::optional<double> change(const std::string& path, double value, double size) const {
    const double unit = std::pow(10.0, std::ceil(std::log10(size)) - kPoseDigits);
    const double rounded = rounded_to(unit * std::round(value / unit), kPoseDigits + 3);
    const bool is_variable =
        std::any_of(values_.begin(), values_.end(), [&](const NewValue& one) { return one.path == path; });
    if (is_variable || std::abs(value - present(path)) <= unit) return std::nullopt;
    const auto moved = read_.with({Setting(path, rounded)});
    const bool is_estimate = moved && same_but_for_poses(read_.profile(), moved->profile());
    return is_estimate ? std::optional(rounded == 0 ? 0.0 : rounded) : std::nullopt;
  }

  [[nodiscard]] double present(const std::string& path) const {
    const auto found = present_.find(path);
    return found == present_.end() ? 0 : found->second;
  }

  // Numbers that the text has are replaced one by one; else the pose as a whole.
  void write(const std::string& pose, const std::array<std::optional<double>, 3>& changed) {
    bool all_in_text = true;
    std::array<double, 3> whole = {};
    for (std::size_t k = 0; k < changed.size(); ++k) {
      const std::string path = pose + "." + kPoseNumbers[k];
      all_in_text = all_in_text && (!changed[k] || in_text_.count(path) > 0);
      whole[k] = changed[k].value_or(present(path));
    }
    if (!all_in_text) {
      std::erase_if(values_, [&](const NewValue& one) { return one.path.starts_with(pose + "."); });
      values_.push_back(
          {pose, fmt::format("{{ x = {}, y = {}, angle = {} }}", whole[0], whole[1], whole[2])});
      return;
    }
    for (std::size_t k = 0; k < changed.size(); ++k) {
      if (changed[k]) values_.push_back({pose + "." + kPoseNumbers[k], fmt::format("{}", *changed[k])});
    }
  }

  const Model& read_;
  const Run& run_;
  std::vector<NewValue>& values_;
  std::set<std::string> in_text_;          // paths of the numbers of the text
  std::map<std::string, double> present_;  // with their values, in the profile's units
};

std::optional<Run> run_of(const DesignNumbers& numbers, const RunSettings& settings,
                          std::span<const double> x, int branch) {
  const auto data = numbers.data_of(x);
  if (!data || !data->plan) return std::nullopt;
  const auto schedule = schedule_of(*data, settings);
  if (!schedule) return std::nullopt;
  return start_on_branch(run_model(*data), schedule->first_positions(), branch);
}

bool starts_like(const Run& run, const Model& read, const RunSettings& settings) {
  const auto started = read.start(settings);
  return started && same_poses(run, started->impl().run);
}

}  // namespace

Result<std::string> text_of_design(const DesignNumbers& numbers, const RunSettings& settings,
                                   std::span<const double> x, int branch) {
  const Model::Data& model = numbers.model().data();
  std::vector<NewValue> values;
  const std::vector<std::string> paths = numbers.paths();
  const std::vector<double> at = numbers.values_of(x);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    values.push_back({paths[i], fmt::format("{}", at[i] == 0 ? 0.0 : at[i])});
  }
  const auto written = [&]() -> Result<std::string> {
    auto text = model.document->text_with(values);
    if (!text) return wrong(model, std::move(text.error()));
    return *std::move(text);
  };
  auto text = written();
  if (!text) {
    return text;
  }
  // If the profile's poses lead to another assembly, those of the design are written.
  const auto read = Model::from_text(*text, model.profile.source);
  const auto run = run_of(numbers, settings, x, branch);
  if (!read || !run || starts_like(*run, *read, settings)) {
    return text;
  }
  Poses(*model.document, *read, *run, values).replace();
  const auto posed = written();
  return posed ? posed : text;
}

bool starts_as_designed(const DesignNumbers& numbers, const RunSettings& settings, std::span<const double> x,
                        int branch, const Model& read) {
  const auto run = run_of(numbers, settings, x, branch);
  return run && starts_like(*run, read, settings);
}

}  // namespace higherpair
