#pragma once

#include "io/profile_testing.hpp"

#include <filesystem>
#include <fstream>

namespace higherpair::testing {

/// Reads profiles that refer to files beside them, in a folder of their own.
class ProfileWithFiles : public ::testing::Test {
protected:
  ProfileWithFiles() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("higherpair_") + info->test_suite_name() + "_" + info->name());
    std::filesystem::create_directories(folder_);
  }
  ~ProfileWithFiles() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  /// The crank's profile with the curve `c`, whose table begins at 13:5.
  [[nodiscard]] tl::expected<Profile, Diagnostics> read_curve(const std::string& table) const {
    return read_profile_text(crank_profile("[bodies.crank.curves]\nc = " + table + "\n"),
                             (folder_ / "test.toml").string());
  }

  [[nodiscard]] NamedCurve curve(const std::string& table) const {
    const auto profile = read_curve(table);
    if (!profile) {
      for (const Diagnostic& diagnostic : profile.error()) ADD_FAILURE() << to_string(diagnostic);
      return {};
    }
    return profile->mechanism.bodies[1].curves[0];
  }

  /// The messages, without the name of the folder.
  [[nodiscard]] std::vector<std::string> messages_of(const std::string& table) const {
    const auto profile = read_curve(table);
    return profile ? std::vector<std::string>{} : lines(profile.error());
  }

  /// The notes, without those about curves that no contact uses.
  [[nodiscard]] std::vector<std::string> notes_of(const std::string& table) const {
    const auto profile = read_curve(table);
    std::vector<std::string> found;
    for (const std::string& line : profile ? lines(profile->notes) : std::vector<std::string>{"not read"}) {
      if (line.find("no contact names") == std::string::npos) found.push_back(line);
    }
    return found;
  }

  std::filesystem::path folder_;

private:
  [[nodiscard]] std::vector<std::string> lines(const Diagnostics& diagnostics) const {
    std::vector<std::string> texts;
    for (const Diagnostic& diagnostic : diagnostics) {
      std::string text = to_string(diagnostic);
      for (std::size_t at = 0; (at = text.find(folder_.string() + "/")) != std::string::npos;) {
        text.erase(at, folder_.string().size() + 1);
      }
      texts.push_back(text);
    }
    return texts;
  }
};

}  // namespace higherpair::testing
