#include "cases.hpp"

#include "higherpair/io/profile_reader.hpp"

#include <cstdlib>

#include <fmt/core.h>

namespace higherpair::bench {
namespace {

constexpr double kDegree = kPi / 180;

std::string curve_text(const Oval& oval) {
  return fmt::format("{{ type = \"ellipse\", center = [{}, {}], semi_axes = [{}, {}], rotation = {} }}",
                     oval.center.x(), oval.center.y(), oval.a, oval.b, oval.rotation / kDegree);
}

// A profile in metres and degrees.
std::string profile_text(const Oval& cam, const std::string& follower, const std::string& joint) {
  return fmt::format(R"(
[units]
length = "m"
[bodies.ground]
points.O1 = [0, 0]
points.O2 = [0.08, 0]
[bodies.cam]
points.O = [0, 0]
curves.edge = {}
[bodies.follower]
points.O = [0, 0]
{}
[joints.cam_pivot]
type = "revolute"
between = ["ground.O1", "cam.O"]
[joints.follower_joint]
between = ["ground.O2", "follower.O"]
{}
[contacts.touch]
between = ["cam.edge", "follower.edge"]
[driver]
joint = "cam_pivot"
velocity = "1 rad/s"
)",
                     curve_text(cam), follower, joint);
}

Case make_case(const std::string& name, const Oval& cam, const std::vector<Oval>& follower) {
  const std::string body =
      follower.empty()
          ? "pose = { x = 0.08, y = 0.06, angle = 0 }\n"
            "curves.edge = { type = \"line\", point = [0, 0], normal = [0, -1] }"
          : "pose = { x = 0.08, y = 0, angle = -35 }\ncurves.edge = " + curve_text(follower.front());
  const std::string joint =
      follower.empty() ? "type = \"prismatic\"\ndirection = [0, 1]" : "type = \"revolute\"";
  const auto profile = read_profile_text(profile_text(cam, body, joint), name);
  require(profile.has_value(), profile ? "" : to_string(profile.error().front()));
  auto run = start_run(profile->mechanism, {0});
  require(run.has_value(), run ? "" : name + ": " + run.error().reason);
  return {name, cam, follower, Vector2d(0.08, 0), *profile, *run};
}

}  // namespace

const ContactTrack& track_of(const Run& run) {
  for (const PairTrack& track : run.at.state.tracks) {
    if (const auto* contact = std::get_if<ContactTrack>(&track)) {
      return *contact;
    }
  }
  require(false, "the mechanism has no tracked contact");
  std::abort();
}

const ContactPair& Case::pair() const {
  return track_of(run).pair;
}

ColumnSet table_of(const Profile& profile) {
  ColumnSet table(profile.units, {});
  add_motion_columns(table, profile, profile.units, false);
  add_status_columns(table);
  require(table.finish("bench").has_value(), "two columns of one name");
  return table;
}

void require(bool condition, const std::string& message) {
  if (!condition) {
    fmt::print(stderr, "bench: {}\n", message);
    std::abort();
  }
}

std::vector<Case> make_cases() {
  const Oval disc{{0.01, 0}, 0.02, 0.02, 0};
  const Oval roller{{-0.06, 0}, 0.015, 0.015, 0};
  const Oval cam{{0.008, 0.003}, 0.030, 0.020, 15 * kDegree};
  const Oval small_roller{{-0.065, 0}, 0.012, 0.012, 0};
  const Oval shoe{{-0.065, 0.002}, 0.015, 0.010, 30 * kDegree};
  return {make_case("circle_on_circle", disc, {roller}), make_case("ellipse_on_circle", cam, {small_roller}),
          make_case("ellipse_on_ellipse", cam, {shoe}), make_case("ellipse_on_flat_face", cam, {})};
}

}  // namespace higherpair::bench
