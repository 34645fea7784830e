#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

// Runs the program as a user does, in a folder of its own.

namespace higherpair::testing {

struct Outcome {
  int code = -1;  ///< of exit; -1: ended by a signal
  std::string out;
  std::string err;
};

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The path of a shipped profile, such as "four_bar.toml".
inline std::string shipped_profile(const std::string& name) {
  return HIGHERPAIR_SOURCE_DIR "/profiles/" + name;
}

class ProgramTest : public ::testing::Test {
protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Runs the program in the folder; the arguments are read as by a shell.
  [[nodiscard]] Outcome run_program(const std::string& arguments) const {
    const auto quoted = [&](const char* name) { return "'" + (folder_ / name).string() + "'"; };
    const std::string command = "cd '" + folder_.string() + "' && " + HIGHERPAIR_PROGRAM + " " + arguments +
                                " >" + quoted("out") + " 2>" + quoted("err");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder_ / "out"),
            read_file(folder_ / "err")};
  }

  /// Runs these lines as a shell script in the folder.
  [[nodiscard]] Outcome run_script(const std::string& script) const {
    std::ofstream(folder_ / "script.sh") << script;
    const int status = std::system(("cd '" + folder_.string() + "' && sh script.sh >out 2>err").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder_ / "out"),
            read_file(folder_ / "err")};
  }

  /// The text of a file of the folder.
  [[nodiscard]] std::string file(const std::string& name) const { return read_file(folder_ / name); }

  /// Copies shipped profiles into the folder, under their own names.
  void copy_profiles(std::initializer_list<const char*> names) const {
    for (const char* name : names) {
      const std::string file = std::string(name) + ".toml";
      std::filesystem::copy_file(shipped_profile(file), folder_ / file,
                                 std::filesystem::copy_options::overwrite_existing);
    }
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("higherpair-tests-" + std::to_string(getpid()));
};

}  // namespace higherpair::testing
