#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace higherpair {
class Model;
struct Error;
}  // namespace higherpair

namespace higherpair::cli {

/// What an option writes, and where to.
struct Output {
  std::string what;
  std::optional<std::string>& path;
};

/// Adds --csv and --json to a command that reads `profile`. Both into one file, or both to standard output,
/// are refused, and so is either into the profile.
/// \param picture, events, hdf5  other outputs, if the command has them: of --output, --events and --hdf5
void add_output_options(CLI::App& command, const std::string& profile, const Output& csv, const Output& json,
                        const std::optional<std::string>* picture = nullptr,
                        const std::optional<std::string>* events = nullptr,
                        const std::optional<std::string>* hdf5 = nullptr);

/// A file that the command line names, and what names it there.
struct NamedFile {
  std::string name;  ///< "--csv", "FILE"
  std::string path;  ///< "-": standard output
};

/// Whether both name one regular file, which need not exist yet, by whatever path or link.
[[nodiscard]] bool is_same_file(const std::string& a, const std::string& b);

/// Throws CLI::ValidationError where an output is an input, or two outputs are one, by whatever path or link:
/// writing would destroy what was to be read. Devices and pipes may be named twice.
void refuse_shared_files(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// A file of an option that need not be given.
struct OptionalFile {
  const char* name;
  const std::optional<std::string>& path;
};

/// Those that are.
[[nodiscard]] std::vector<NamedFile> given(std::initializer_list<OptionalFile> files);

/// What is wrong where one of the outputs is a file that the profile reads: points, tables, outlines.
[[nodiscard]] std::optional<Error> refused_output(const Model& model, const std::vector<NamedFile>& outputs);

/// Throws CLI::ValidationError where the folder of a file is not there: before hours are spent on what is to
/// be written.
void refuse_missing_folder(const NamedFile& output);

/// Adds --set: keys of the profile that are overridden or added.
void add_set_option(CLI::App& command, std::vector<std::string>& overrides);

/// Adds --tolerance: when a row is ok.
void add_tolerance_option(CLI::App& command, double& tolerance);

/// Adds --threads.
void add_threads_option(CLI::App& command, int& threads);

/// Adds --samples to a command that has no rows, as all commands take it.
/// \param what_counts  in their place, for its help
void add_unused_samples(CLI::App& command, const std::string& what_counts);

}  // namespace higherpair::cli
