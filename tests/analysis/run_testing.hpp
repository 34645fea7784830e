#pragma once

#include "higherpair/analysis/row.hpp"
#include "higherpair/higherpair.hpp"
#include "higherpair/io/profile_reader.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace higherpair::testing {

using Complex = std::complex<double>;
using Settings = std::vector<std::string>;

/// The table of a run: values in the profile's units, NaN for an empty field.
class RunTable {
public:
  RunTable(const Profile& profile, const RunSettings& settings) {
    auto model = Model::from(profile.mechanism, profile.units, profile.programs);
    auto motion = model ? model->run(settings) : tl::unexpected(model.error());
    if (!motion) {
      failure_ = motion.error().diagnostics.front().message;
      return;
    }
    motion_ = *std::move(motion);
    for (const Event& event : motion_->events()) {
      RunEvent& made = events_.emplace_back();
      made.type = event.type;
      made.driver = event.driver_si;
      made.joint = event.joint;
      made.contact = event.contact;
      made.cause = event.cause;
      made.value = event.value;
    }
  }

  [[nodiscard]] std::size_t size() const { return motion_ ? motion_->size() : 0; }
  [[nodiscard]] double value(std::size_t row, const std::string& column) const {
    const auto values = motion_->find_column(column);
    if (!values) {
      ADD_FAILURE() << to_string(values.error());
      return NAN;
    }
    return (*values)[row];
  }
  /// An angle or its rates, from degrees.
  [[nodiscard]] double radians(std::size_t row, const std::string& column) const {
    return value(row, column) * (kPi / 180);
  }
  /// The columns `name`x and `name`y as one number: "crank.P." gives the position, "crank.P.v" the velocity.
  [[nodiscard]] Complex vector(std::size_t row, const std::string& name) const {
    return {value(row, name + "x"), value(row, name + "y")};
  }
  [[nodiscard]] const std::vector<RunEvent>& events() const { return events_; }
  [[nodiscard]] const std::string& failure() const { return failure_; }
  [[nodiscard]] std::size_t count(RowStatus status) const {
    return motion_ ? static_cast<std::size_t>(
                         std::count(motion_->statuses().begin(), motion_->statuses().end(), status))
                   : 0;
  }
  [[nodiscard]] RowStatus status(std::size_t row) const { return motion_->statuses()[row]; }

private:
  std::optional<higherpair::Motion> motion_;
  std::vector<RunEvent> events_;  ///< their drivers in SI units
  std::string failure_;           ///< why it could not be started
};

/// What the commands `analyze` and `step` write for a profile.
inline RunTable analyze(const Profile& profile) {
  return {profile, {}};
}
/// The same with so many rows.
inline RunTable analyze_at(const Profile& profile, std::int64_t rows) {
  RunSettings settings;
  settings.samples = rows;
  return {profile, settings};
}
inline RunTable step(const Profile& profile) {
  RunSettings settings;
  settings.in_time = true;
  return {profile, settings};
}

/// A profile of the folder profiles/, with settings "PATH=VALUE".
inline Profile shipped(const std::string& name, const Settings& settings = {}) {
  auto profile =
      read_profile_file(std::string(HIGHERPAIR_SOURCE_DIR "/profiles/") + name + ".toml", settings);
  if (!profile) {
    for (const Diagnostic& diagnostic : profile.error()) ADD_FAILURE() << to_string(diagnostic);
    return {};
  }
  return *profile;
}

/// Names of all shipped profiles whose contacts are between whole conics only.
inline std::vector<std::string> shipped_without_boundaries() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(HIGHERPAIR_SOURCE_DIR "/profiles")) {
    if (file.path().extension() == ".toml") names.push_back(file.path().stem());
  }
  std::erase_if(names, [](const std::string& name) {
    const auto& contacts = shipped(name).mechanism.contacts;
    return std::any_of(contacts.begin(), contacts.end(), [](const Contact& c) { return c.by_boundary; });
  });
  std::sort(names.begin(), names.end());
  return names;
}

inline Profile profile_of(const std::string& text, const Settings& settings = {}) {
  auto profile = read_profile_text(text, "test.toml", settings);
  if (!profile) {
    for (const Diagnostic& diagnostic : profile.error()) ADD_FAILURE() << to_string(diagnostic);
    return {};
  }
  return *profile;
}

/// What `analyze` writes for the text of a profile.
inline RunTable analyze_text(const std::string& text, const Settings& settings = {}) {
  return analyze(profile_of(text, settings));
}

/// Every row has the status `ok`.
inline void expect_all_ok(const RunTable& motion) {
  EXPECT_EQ(motion.failure(), "");
  EXPECT_GT(motion.size(), 0U);
  EXPECT_EQ(motion.count(RowStatus::kOk), motion.size());
}

/// The point at the given distances from A and B, to the left of AB (to the right for side -1).
inline Complex meeting_point(Complex A, double a, Complex B, double b, double side) {
  const double c = std::abs(B - A);
  const double along = (a * a - b * b + c * c) / (2 * c);
  return A + (B - A) / c * Complex(along, side * std::sqrt(a * a - along * along));
}

}  // namespace higherpair::testing
