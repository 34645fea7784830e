// Writes a design as a profile.
#include "analysis_impl.hpp"
#include "design_setup.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using NewValue = ProfileDocument::NewValue;

constexpr int kPoseDigits = 6;  // of a pose, which is an estimate

bool stand_alike(const Run& a, const Run& b) {
  for (std::size_t i = 0; i < a.at.state.bodies.size(); ++i) {
    const BodyMotion& one = a.at.state.bodies[i];
    const BodyMotion& other = b.at.state.bodies[i];
    const double turned = std::abs(nearest_turn(one.theta - other.theta, 0));
    if ((one.X_WB.p_WB - other.X_WB.p_WB).norm() > kSamePose * a.plan().size || turned > kSamePose)
      return false;
  }
  return true;
}

// Poses of the bodies whose assembly depends on the branch. Other poses are left alone: they may be more than
// an estimate, such as the coordinate at which a driver starts.
std::vector<NewValue> poses_of(const Run& run, const Units& units) {
  std::vector<NewValue> poses;
  const double length = from_si(dimension::kLength, units).apply(1);
  const double angle = from_si(dimension::kAngle, units).apply(1);
  const auto rounded = [](double value, double size) {
    const double unit = std::pow(10.0, std::ceil(std::log10(size)) - kPoseDigits);
    const double near = unit * std::round(value / unit);
    return fmt::format("{:.{}g}", near == 0 ? 0.0 : near, kPoseDigits + 3);
  };
  for (const Group& group : run.plan().groups) {
    const bool chosen = traits_of(group).two_modes || placing_contact(group) || traits_of(group).coupled;
    if (!chosen || !group.drivers.empty()) continue;
    for (const int index : group.bodies) {
      const BodyMotion& body = run.at.state.bodies[index];
      const Vector2d p = length * body.X_WB.p_WB;
      poses.push_back(
          {fmt::format("bodies.{}.pose", run.mechanism().bodies[index].name),
           fmt::format("{{ x = {}, y = {}, angle = {} }}", rounded(p.x(), length * run.plan().size),
                       rounded(p.y(), length * run.plan().size),
                       rounded(angle * nearest_turn(body.theta, 0), angle * 2 * kPi))});
    }
  }
  return poses;
}

}  // namespace

Result<std::string> text_of_design(const DesignSetup& setup, std::span<const double> x, int branch) {
  const DesignTask& task = setup.numbers.task();
  const Model::Data& model = setup.numbers.model().data();
  std::vector<NewValue> values;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const DesignTask::Variable& variable = task.variables[i];
    for (std::size_t k = 0; k < variable.paths.size(); ++k) {
      const double value = variable.factors[k] * x[i];
      values.push_back({variable.paths[k], fmt::format("{}", value == 0 ? 0.0 : value)});
    }
  }
  const auto written = [&]() -> Result<std::string> {
    auto text = model.document->text_with(values);
    if (!text) return wrong(model, std::move(text.error()));
    return *std::move(text);
  };
  const auto text = written();
  if (!text) {
    return text;
  }
  // If the profile's poses lead to another assembly, those of the design are written.
  const auto read = Model::from_text(*text, model.name, model.document->overrides());
  const auto data = setup.numbers.data_of(x);
  if (!read || !data || !data->plan) {
    return text;
  }
  const auto schedule = schedule_of(*data, setup.settings);
  const auto run =
      schedule ? start_on_branch(run_model(*data), schedule->first_positions(), branch) : std::nullopt;
  const auto started = read->start(setup.settings);
  if (!run || (started && stand_alike(*run, started->impl().run))) {
    return text;
  }
  for (NewValue& pose : poses_of(*run, model.profile.units)) {
    // Variables may be numbers of the pose themselves.
    if (std::none_of(values.begin(), values.end(),
                     [&](const NewValue& value) { return value.path.rfind(pose.path, 0) == 0; })) {
      values.push_back(std::move(pose));
    }
  }
  const auto posed = written();
  return posed ? posed : text;
}

}  // namespace higherpair
