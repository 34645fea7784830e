#include "boundaries.hpp"

#include "higherpair/higherpair.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/core.h>

namespace higherpair::bench {
namespace {

constexpr int kPoints = 720;
constexpr int kManyPoints = 3600;
constexpr int kEntities = 10000;

Vector2d point_of(const Oval& oval, double t) {
  return oval.center +
         Rotation<double>::from_angle(oval.rotation) * Vector2d(oval.a * std::cos(t), oval.b * std::sin(t));
}

// A profile of a cam `curve` about O and a roller on an arm of 60 mm, in mm and degrees.
std::string profile_with(const std::string& curve, const std::string& follower) {
  return fmt::format(R"(
[bodies.ground]
points.O1 = [0, 0]
points.O2 = [80, 0]
[bodies.cam]
points.O = [0, 0]
curves.edge = {}
{}
[joints.cam_pivot]
type = "revolute"
between = ["ground.O1", "cam.O"]
[contacts.touch]
between = ["cam.edge", "follower.edge"]
[driver]
joint = "cam_pivot"
velocity = "60 rpm"
)",
                     curve, follower);
}

constexpr const char* kSwingingRoller = R"([bodies.follower]
pose = { x = 80, y = 0, angle = -35 }
points.O = [0, 0]
curves.edge = { type = "circle", center = [-65, 0], radius = 12 }
[joints.follower_pivot]
type = "revolute"
between = ["ground.O2", "follower.O"])";

constexpr const char* kFlatTappet = R"([bodies.follower]
pose = { x = 0, y = 60 }
points.O = [0, 0]
curves.edge = { type = "line", point = [0, 0], normal = [0, -1] }
[joints.guide]
type = "prismatic"
between = ["ground.O1", "follower.O"]
direction = [0, 1])";

Run run_of(const std::string& text, const std::string& name) {
  const auto profile = read_profile_text(text, name);
  require(profile.has_value(), profile ? "" : to_string(profile.error().front()));
  auto run = start_run(profile->mechanism, {0});
  require(run.has_value(), run ? "" : name + ": " + run.error().reason);
  return *std::move(run);
}

double follower_place(const Run& run) {
  const BodyMotion& follower = run.row.bodies.back();
  return follower.theta + follower.X_WB.p_WB.y();
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  require(file.flush().good(), "cannot write " + path.string());
}

// r = 24 + 4 cos u + 1.5 cos 2u mm, as in the shipped cam given by points.
Vector2d rounded_heart(double u) {
  return (24 + 4 * std::cos(u) + 1.5 * std::cos(2 * u)) * unit_vector(u);
}

std::string table_of_points() {
  std::string text = "x[mm],y[mm]\n";
  for (int i = 0; i < kManyPoints; ++i) {
    const Vector2d p = rounded_heart(2 * kPi * i / kManyPoints);
    text += fmt::format("{:.9f},{:.9f}\n", p.x(), p.y());
  }
  return text;
}

// A 3-4-5 rise and fall of 10 mm between 120 and 240 degrees.
std::string table_of_lifts() {
  std::string text = "# x, s\n";
  for (int i = 0; i < kManyPoints; ++i) {
    const double x = i * 360.0 / kManyPoints;
    const double t = std::max(0.0, 1 - std::abs(x - 180) / 60);
    text += fmt::format("{:.1f}, {:.6f}\n", x, 10 * t * t * t * (10 - 15 * t + 6 * t * t));
  }
  return text;
}

std::string drawing_of_lines() {
  std::string text = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (int i = 0; i < kEntities; ++i) {
    const Vector2d a = rounded_heart(2 * kPi * i / kEntities);
    const Vector2d b = rounded_heart(2 * kPi * ((i + 1) % kEntities) / kEntities);
    text += fmt::format("0\nLINE\n8\noutline\n10\n{:.9f}\n20\n{:.9f}\n11\n{:.9f}\n21\n{:.9f}\n", a.x(), a.y(),
                        b.x(), b.y());
  }
  return text + "0\nENDSEC\n0\nEOF\n";
}

}  // namespace

BoundaryCase checked_spline_cam(const Case& ellipse) {
  std::string points;
  for (int i = 0; i < kPoints; ++i) {
    const Vector2d p = 1e3 * point_of(ellipse.cam, 2 * kPi * i / kPoints);
    points += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", p.x(), p.y());
  }
  const std::string name = "spline_of_720_on_circle";
  BoundaryCase made{
      name, run_of(profile_with("{ type = \"spline\", points = [" + points + "] }", kSwingingRoller), name)};
  Run spline = made.run;
  Run conic = ellipse.run;
  for (int k = 0; k < kStepsPerTurn; ++k) {
    move_to(spline, {{driver_position(k), 1, 0}});
    move_to(conic, {{driver_position(k), 1, 0}});
    const double error = std::abs(follower_place(spline) - follower_place(conic));
    require(spline.row.status == RowStatus::kOk && error <= 1e-11,
            fmt::format("{}: off by {} at step {}", name, error, k));
  }
  return made;
}

JointCase checked_joint() {
  // Base circle 20, flanks 38, nose 8; the face touches the flank first.
  Run run = run_of(profile_with(R"({ type = "chain", spans = [
  { type = "arc", center = [24, 0], radius = 8, from = -36.86989764584402, to = 36.86989764584402 },
  { type = "arc", center = [0, -18], radius = 38, from = 36.86989764584402, to = 90 },
  { type = "arc", center = [0, 0], radius = 20, from = 90, to = 270 },
  { type = "arc", center = [0, 18], radius = 38, from = 270, to = 323.13010235415598 }] })",
                                kFlatTappet),
                   "four_arcs");
  JointCase made;
  made.step = 2 * driver_position(1);
  const double joint = std::atan2(24, 18);  // from flank to nose
  const auto lift = [&](double u) {
    return u < joint ? 0.038 - 0.018 * std::cos(u) : 0.024 * std::sin(u) + 0.008;
  };
  for (int k = -2; k <= 1; ++k) {
    const double u = joint + (k + 0.5) * made.step;
    move_to(run, {{u, 1, 0}});
    require(std::abs(run.row.bodies.back().X_WB.p_WB.y() - lift(u)) <= 1e-15, "four_arcs: a wrong lift");
    (k == -2 ? made.before_that : made.before_joint) = k < 0 ? run : made.before_joint;
  }
  return made;
}

LargeFiles::LargeFiles() {
  namespace fs = std::filesystem;
  std::string name = (fs::temp_directory_path() / "higherpair_bench_XXXXXX").string();
  require(mkdtemp(name.data()) != nullptr, "cannot make a folder for files");
  folder_ = name;
  const auto add = [&](const std::string& what, const std::string& file, const std::string& content,
                       const std::string& profile, bool check) {
    write(fs::path(folder_) / file, content);
    const fs::path path = fs::path(folder_) / (what + ".toml");
    write(path, profile);
    files_.push_back({what, path.string(), check});
  };
  add("spline_of_3600", "points.csv", table_of_points(),
      profile_with("{ type = \"spline\", file = \"points.csv\" }", kSwingingRoller), true);
  add("law_of_3600", "lifts.csv", table_of_lifts(),
      profile_with("{ type = \"cam\", law = \"lift\", contact = \"touch\" }", kFlatTappet) +
          "[laws.lift]\nfile = \"lifts.csv\"\nsmoothing = 0.000001\n",
      true);
  add("dxf_of_10000", "outline.dxf", drawing_of_lines(),
      profile_with("{ type = \"dxf\", file = \"outline.dxf\" }", kSwingingRoller), false);
}

LargeFiles::~LargeFiles() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void require_right(const LargeFiles& large) {
  for (const LargeFiles::File& file : large.files()) {
    const auto model = Model::open(file.profile);
    require(model.has_value(), model ? "" : to_string(model.error()));
    if (!file.check) {
      continue;
    }
    const auto report = check(*model);
    require(report.has_value() && report->good, file.name + ": the check is not good");
  }
}

}  // namespace higherpair::bench
