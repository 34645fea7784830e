#pragma once

#include "higherpair/front/model.hpp"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair::cli {

/// The output of an option: what is written, for its help, and the path given.
struct Output {
  std::string what;
  std::optional<std::string>& path;
};

/// Adds --csv and --json, without any check.
void add_forms(CLI::App& command, const Output& csv, const Output& json);

/// Paths of further outputs: of --output, --events and --hdf5. Null: the command has no such option.
struct OtherOutputs {
  const std::optional<std::string>* picture = nullptr;
  const std::optional<std::string>* events = nullptr;
  const std::optional<std::string>* hdf5 = nullptr;
};

/// Adds --csv and --json to a command that reads `profile`, and a final callback that checks all its outputs:
/// check_files().
void add_output_options(CLI::App& command, const std::string& profile, const Output& csv, const Output& json,
                        const OtherOutputs& others = {});

/// A file given on the command line, and the argument that gives it.
struct NamedFile {
  std::string name;  ///< "--csv", "FILE"
  std::string path;  ///< "-": standard output
};

/// Throws CLI::ValidationError if an output is also an input or another output (devices and pipes may be
/// given twice). Before hours are spent on computing what could not be kept also, with kExitMachine as its
/// exit code, if an output is a folder or a link that leads to itself, or if its folder does not exist.
void check_files(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// The file of an optional option.
struct OptionalFile {
  const char* name;
  const std::optional<std::string>& path;
};

/// The files whose options were given.
[[nodiscard]] std::vector<NamedFile> given(std::initializer_list<OptionalFile> files);

/// The error if one of the outputs is a file that the profile reads (points, tables, outlines).
[[nodiscard]] std::optional<Error> refused_output(const Model& model, const std::vector<NamedFile>& outputs);

/// What the commands that analyse a profile have in common.
struct ProfileOptions {
  std::string profile;
  std::vector<std::string> overrides;  ///< PATH=VALUE
  bool quiet = false;
};

/// Opens the model of the profile; prints its notes unless `quiet`.
/// \param outputs  files to be written; refused if the profile reads one of them
[[nodiscard]] Result<Model> open_model(const ProfileOptions& options, const std::vector<NamedFile>& outputs);

/// Adds FILE, --set and --quiet. \param what  FILE is, for the help
void add_profile_options(CLI::App& command, ProfileOptions& options,
                         const std::string& what = "profile of the mechanism (TOML)");

/// Adds --tolerance: the largest closure error of a row that is ok.
void add_tolerance_option(CLI::App& command, double& tolerance);

/// Adds --threads.
void add_threads_option(CLI::App& command, int& threads);

/// Adds --samples, without effect, to a command that has no rows: all commands accept it.
/// \param what_counts  what is used instead, for the help
void add_unused_samples(CLI::App& command, const std::string& what_counts);

}  // namespace higherpair::cli
