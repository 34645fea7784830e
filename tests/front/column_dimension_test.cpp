// What io knows of the units of columns and figures is what the tables have.
#include "higherpair/io/column_dimension.hpp"

#include "higherpair/front/check.hpp"
#include "higherpair/higherpair.hpp"

#include <filesystem>
#include <functional>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace higherpair {
namespace {

void for_each_shipped(const std::function<void(const Model&)>& take) {
  for (const auto& entry : std::filesystem::directory_iterator(HIGHERPAIR_SOURCE_DIR "/profiles")) {
    if (entry.path().extension() != ".toml") continue;
    const auto model = Model::open(entry.path().string());
    ASSERT_TRUE(model) << to_string(model.error());
    take(*model);
  }
}

TEST(ColumnDimensions, AreThoseOfTheTablesOfEveryShippedProfile) {
  std::size_t count = 0;
  for_each_shipped([&](const Model& model) {
    for (const bool in_time : {false, true}) {
      RunSettings settings;
      settings.in_time = in_time;
      settings.forces = settings.jerk = true;
      settings.derivatives = 4;
      const auto analysis = model.start(settings);
      if (!analysis) continue;
      for (const Column& column : analysis->columns()) {
        if (!column.words.empty()) continue;
        const auto dimension = column_dimension(model.mechanism(), column.name);
        ASSERT_TRUE(dimension) << column.name;
        EXPECT_EQ(unit_text(*dimension, model.units()), column.unit) << column.name;
        ++count;
      }
    }
  });
  EXPECT_GT(count, 1000U);
}

TEST(FigureDimensions, AreThoseOfTheChecksOfShippedProfiles) {
  std::set<std::string> quantities;
  for (const char* name : {"law_cam_roller", "checked_cam", "valve_train", "gear_teeth", "four_bar"}) {
    const auto model = Model::open(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + name + ".toml");
    ASSERT_TRUE(model) << name;
    const auto report = check(*model);
    ASSERT_TRUE(report) << name;
    for (const CheckFigure& figure : report->figures) {
      const auto dimension = figure_dimension(model->mechanism(), figure.item, figure.quantity);
      ASSERT_TRUE(dimension) << figure.quantity;
      EXPECT_EQ(unit_text(*dimension, model->units()), figure.unit) << figure.quantity;
      quantities.insert(figure.quantity);
    }
  }
  EXPECT_GT(quantities.size(), 12U);
  EXPECT_FALSE(figure_dimension({}, "contacts.touch", "pressure"));
}

}  // namespace
}  // namespace higherpair
