// Mirrored and scaled copies of mechanisms whose curves have ends or several parts, and of contacts that may
// separate.
#include "mirrored.hpp"

#include "front/analysis_impl.hpp"
#include "higherpair/front/check.hpp"
#include "higherpair/front/export.hpp"
#include "sliding_cam.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::mirrored;
using testing::motion_of;
using testing::shipped_model;

struct Copied {
  const char* profile;
  double start = 3.7;
  double end = 363.7;
  const char* pose = nullptr;  // that fits the start
};

class Copies : public ::testing::TestWithParam<Copied> {
protected:
  Copies() : model_(shipped_model(GetParam().profile, settings())) {}

  // Few rows: what happens between them must be found all the same. No event is at the ends of the path.
  static std::vector<std::string> settings() {
    std::vector<std::string> all = {"driver.samples=25", fmt::format("driver.start={}", GetParam().start),
                                    fmt::format("driver.end={}", GetParam().end)};
    if (GetParam().pose != nullptr) {
      all.emplace_back(GetParam().pose);
    }
    return all;
  }

  Model model_;
};

double size_of(const Model& model) {
  double size = 0;
  for (const Body& body : model.mechanism().bodies) {
    size = std::max(size, body.guess_p_WB.norm());
    for (const NamedPoint& point : body.points) {
      size = std::max(size, point.p_B.norm());
    }
  }
  return size;
}

void expect_mirrored(const BodyMotion& image, const BodyMotion& body, double size) {
  EXPECT_LE((image.X_WB.p_WB - mirrored(body.X_WB.p_WB)).norm(), 1e-11 * size);
  EXPECT_NEAR(image.theta, -body.theta, 1e-10);
  const double speed = 1 + std::abs(body.omega);
  EXPECT_LE((image.v_WB - mirrored(body.v_WB)).norm(), 1e-8 * (size * speed + body.v_WB.norm()));
  EXPECT_NEAR(image.omega, -body.omega, 1e-8 * speed);
  EXPECT_LE((image.a_WB - mirrored(body.a_WB)).norm(), 1e-6 * (size * speed * speed + body.a_WB.norm()));
  EXPECT_NEAR(image.alpha, -body.alpha, 1e-6 * (speed * speed + std::abs(body.alpha)));
}

TEST_P(Copies, MoveAsTheMirrorShowsThem) {
  const Model copy = mirrored(model_);
  const double size = size_of(model_);
  Analysis original = model_.start().value();
  Analysis image = copy.start().value();
  Row row, image_row;
  while (original.next(row)) {
    ASSERT_TRUE(image.next(image_row));
    const MotionRow& a = original.impl().run.row;
    const MotionRow& b = image.impl().run.row;
    ASSERT_EQ(b.status, a.status) << row.values[0];
    for (std::size_t i = 0; i < a.bodies.size(); ++i) {
      expect_mirrored(b.bodies[i], a.bodies[i], size);
    }
    for (std::size_t i = 0; i < a.contacts.size(); ++i) {
      ASSERT_EQ(b.contacts[i].touches, a.contacts[i].touches);
      if (a.contacts[i].touches) {
        EXPECT_LE((b.contacts[i].at.p_W() - mirrored(a.contacts[i].at.p_W())).norm(), 1e-9 * size);
        EXPECT_LE((b.contacts[i].at.n_W - mirrored(a.contacts[i].at.n_W)).norm(), 1e-9);
      }
    }
  }
  ASSERT_EQ(image.events().size(), original.events().size());
  for (std::size_t i = 0; i < original.events().size(); ++i) {
    EXPECT_EQ(image.events()[i].type, original.events()[i].type);
    EXPECT_EQ(image.events()[i].item, original.events()[i].item);
    EXPECT_NEAR(std::abs(image.events()[i].driver), std::abs(original.events()[i].driver), 1e-7);
  }
}

// In metres everything is a thousand times as large, with the same numbers for lengths.
TEST_P(Copies, MoveInTheSameWayAThousandTimesAsLarge) {
  if (GetParam().profile == std::string("spline_cam")) {
    GTEST_SKIP() << "its points come from a file in millimetres";
  }
  std::vector<std::string> in_metres = settings();
  in_metres.emplace_back("units.length=\"m\"");
  const Model large = shipped_model(GetParam().profile, in_metres);
  const Motion small_motion = motion_of(model_);
  const Motion large_motion = motion_of(large);
  ASSERT_EQ(large_motion.size(), small_motion.size());
  for (const Column& column : small_motion.columns()) {
    const ColumnValues small = small_motion.column(column.name);
    const ColumnValues values = large_motion.column(column.name);
    double largest = 1;
    for (const double value : small) {
      largest = std::isnan(value) ? largest : std::max(largest, std::abs(value));
    }
    for (std::size_t k = 0; column.name != "residual" && k < small_motion.size(); ++k) {
      ASSERT_EQ(std::isnan(values[k]), std::isnan(small[k])) << column.name << ' ' << k;
      if (!std::isnan(small[k])) {
        EXPECT_NEAR(values[k], small[k], 1e-7 * largest) << column.name << ' ' << k;
      }
    }
  }
  ASSERT_EQ(large_motion.events().size(), small_motion.events().size());
  for (std::size_t i = 0; i < small_motion.events().size(); ++i) {
    EXPECT_EQ(large_motion.events()[i].type, small_motion.events()[i].type);
    EXPECT_NEAR(large_motion.events()[i].driver, small_motion.events()[i].driver, 1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(OfProfiles, Copies,
                         ::testing::Values(Copied{"geneva_four_slots"}, Copied{"geneva_six_slots"},
                                           Copied{"valve_train"}, Copied{"groove_cam"},
                                           Copied{"involute_pair", -19.3, 9.1},
                                           Copied{"gear_teeth", 12, 100, "bodies.wheel.pose.angle=178.5"},
                                           Copied{"tangent_cam"}, Copied{"four_arc_cam"}, Copied{"cam_chain"},
                                           Copied{"spline_cam"}, Copied{"law_cam_roller"},
                                           Copied{"law_cam_flat"}),
                         [](const auto& given) { return std::string(given.param.profile); });

// Coupled bodies beyond their first limit: whether they are taken up again, and where, was once decided by
// rounding errors, and differed in copies.
TEST(BeyondALimit, CopiesGoOnAsTheOriginalDoes) {
  for (const char* name : {"closed20402", "coupled20355"}) {
    const auto opened = [&](const char* length) {
      const std::string file = fmt::format("{}/follow/{}.toml", HIGHERPAIR_TEST_DATA, name);
      return Model::open(file, std::vector{fmt::format("units.length=\"{}\"", length)}).value();
    };
    const Model model = opened("m");
    const Motion original = motion_of(model, 121);
    for (const Model& copy : {mirrored(model), opened("mm")}) {
      const Motion motion = motion_of(copy, 121);
      ASSERT_EQ(motion.size(), original.size()) << name;
      for (std::size_t k = 0; k < motion.size(); ++k) {
        EXPECT_EQ(motion.statuses()[k], original.statuses()[k]) << name << " row " << k;
      }
    }
  }
}

// Two pairs of teeth touch at the start: rounding must not decide which of them is followed.
TEST(GearTeeth, ThatTouchAtTheStartAreTheSameInAnyUnit) {
  for (const double start : {0.0, 1.5, 5.5, 16.5}) {
    const auto contact_in = [&](const char* unit) {
      const Model model = shipped_model(
          "gear_teeth", {fmt::format("units.length=\"{}\"", unit), fmt::format("driver.start={}", start),
                         "driver.end=20", fmt::format("bodies.wheel.pose.angle={}", 184.5 - start / 2)});
      const Motion motion = motion_of(model, 2);
      return std::array{motion.column("mesh.x").values[0], motion.column("mesh.y").values[0]};
    };
    const auto in_mm = contact_in("mm");
    for (const char* unit : {"um", "cm", "in", "m", "km"}) {
      const auto other = contact_in(unit);
      EXPECT_NEAR(other[0], in_mm[0], 1e-9) << unit << ' ' << start;
      EXPECT_NEAR(other[1], in_mm[1], 1e-9) << unit << ' ' << start;
    }
  }
}

// Compared by item, curve and quantity: mirrored cams have the same figures, except for the sense of
// rotation.
TEST(MirroredCams, HaveTheSameFigures) {
  for (const char* name : {"checked_cam", "valve_train", "four_arc_cam", "geneva_four_slots"}) {
    const Model model = shipped_model(name);
    CheckSettings settings;
    const CheckReport report = check(model, settings).value();
    settings.limits = model.profile().limits;
    const CheckReport image = check(mirrored(model), settings).value();
    std::map<std::string, double> figures;
    for (const CheckFigure& figure : image.figures) {
      figures[figure.item + figure.of + figure.quantity] = figure.value.value_or(0);
    }
    int compared = 0;
    for (const CheckFigure& figure : report.figures) {
      const auto found = figures.find(figure.item + figure.of + figure.quantity);
      if (found != figures.end()) {
        EXPECT_NEAR(std::abs(found->second), std::abs(figure.value.value_or(0)),
                    1e-7 * (1e-3 + std::abs(figure.value.value_or(0))))
            << name << ' ' << found->first;
        ++compared;
      }
    }
    EXPECT_GE(compared, 5) << name;
  }
}

// The bounding box of the points of a CSV, and the length along them.
std::array<double, 5> extent_of(const Model& model, const std::string& curve) {
  ExportSettings settings;
  settings.curves = {curve};
  const auto curves = exported_curves(model, settings).value();
  ExportAccuracy accuracy;
  accuracy.points = 2001;
  std::istringstream csv(curve_csv(model, curves.at(0), accuracy, Units()).value());
  std::string line;
  std::getline(csv, line);
  std::array<double, 5> extent{INFINITY, -INFINITY, INFINITY, -INFINITY, 0};
  while (std::getline(csv, line)) {
    std::istringstream fields(line);
    std::vector<double> values;
    for (std::string field; std::getline(fields, field, ',');) {
      values.push_back(field.empty() ? 0 : std::stod(field));
    }
    extent = {std::min(extent[0], values[0]), std::max(extent[1], values[0]), std::min(extent[2], values[1]),
              std::max(extent[3], values[1]), std::max(extent[4], values[5])};
  }
  return extent;
}

TEST(MirroredCurves, GoOutMirrored) {
  for (const auto& [name, curve] :
       {std::pair("tangent_cam", "cam.outline"), std::pair("law_cam_roller", "cam.flank"),
        std::pair("gear_teeth", "pinion.teeth")}) {
    const Model model = shipped_model(name);
    const auto own = extent_of(model, curve);
    const auto image = extent_of(mirrored(model), curve);
    const double apart = own[4] / 2000;  // spacing of the points: the two curves begin at different ones
    EXPECT_NEAR(image[0], own[0], apart) << name;
    EXPECT_NEAR(image[1], own[1], apart) << name;
    EXPECT_NEAR(image[2], -own[3], apart) << name;
    EXPECT_NEAR(image[3], -own[2], apart) << name;
    EXPECT_NEAR(image[4], own[4], 1e-9 * own[4]) << name;
  }
}

}  // namespace
}  // namespace higherpair
