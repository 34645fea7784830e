#include "output_options.hpp"

#include "hdf5_file.hpp"
#include "option_checks.hpp"
#include "outcome.hpp"
#include "output_file.hpp"
#include "picture.hpp"

#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace higherpair::cli {
namespace {

namespace fs = std::filesystem;

// Standard output may itself be redirected into a file.
bool is_same_file(const std::string& a, const std::string& b) {
  const auto opened = [](const std::string& path) { return path == "-" ? "/dev/stdout" : target_of(path); };
  std::error_code code;
  if (fs::exists(opened(a), code) && fs::exists(opened(b), code)) {
    return fs::is_regular_file(opened(a), code) && fs::equivalent(opened(a), opened(b), code);
  }
  const auto place = [&](const std::string& path) {
    return fs::weakly_canonical(fs::absolute(opened(path), code), code);
  };
  return place(a) == place(b);
}

// A file that cannot be written is a failure of the machine, though it is found with the arguments.
struct NoPlaceError : CLI::ValidationError {
  NoPlaceError(const std::string& option, const std::string& text)
      : ValidationError("NoPlaceError", option + ": " + text, kExitMachine) {}
};

// What no output can be. Whether the machine lets the file be written shows only when it is.
std::string place_objection(const std::string& path) {
  if (path == "-") {
    return "";
  }
  const std::string target = target_of(path);
  if (target.empty()) {
    return " is a link that leads round in a circle";
  }
  std::error_code code;
  if (fs::is_directory(path, code)) {
    return " is a folder; name a file in it";
  }
  const fs::path folder = fs::path(target).parent_path();
  if (!is_direct(path) && !folder.empty() && !fs::is_directory(folder, code)) {
    return ": there is no folder " + folder.string() + "; make it first (mkdir -p), or name another";
  }
  return "";
}

// \param what  "FILE", "part of the profile"
std::string input_objection(const std::string& path, const std::string& what) {
  return path + " is the file that is read as " + what + "; give the output a name of its own";
}

void refuse_shared_files(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const NamedFile& output = outputs[i];
    for (const NamedFile& input : inputs) {
      if (is_same_file(output.path, input.path)) {
        throw CLI::ValidationError(output.name, input_objection(output.path, input.name));
      }
    }
    for (std::size_t k = 0; k < i; ++k) {
      const std::string& other = outputs[k].path;
      if ((output.path == "-" && other == "-") || is_same_file(output.path, other)) {
        throw CLI::ValidationError(outputs[k].name + " and " + output.name,
                                   "both name " + output.path + "; give each a file of its own");
      }
    }
  }
}

}  // namespace

void check_files(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  refuse_shared_files(inputs, outputs);
  for (const NamedFile& output : outputs) {
    const std::string objection = place_objection(output.path);
    if (!objection.empty()) throw NoPlaceError(output.name, output.path + objection);
  }
}

std::vector<NamedFile> given(std::initializer_list<OptionalFile> files) {
  std::vector<NamedFile> all;
  for (const OptionalFile& file : files) {
    if (file.path) all.push_back({file.name, *file.path});
  }
  return all;
}

std::optional<Error> refused_output(const Model& model, const std::vector<NamedFile>& outputs) {
  for (const std::string& file : model.profile().files) {
    for (const NamedFile& output : outputs) {
      if (!is_same_file(file, output.path)) continue;
      return Error{ErrorKind::kInput,
                   {about(output.name, input_objection(output.path, "part of the profile"))}};
    }
  }
  return std::nullopt;
}

Result<Model> open_model(const ProfileOptions& options, const std::vector<NamedFile>& outputs) {
  auto model = Model::open(options.profile, options.overrides);
  if (!model) {
    return model;
  }
  std::vector<NamedFile> all = outputs;
  all.push_back({"standard output", "-"});
  if (auto refused = refused_output(*model, all)) {
    return tl::unexpected(*std::move(refused));
  }
  print_notes(model->notes(), options.quiet);
  return model;
}

namespace {

void check_hdf5(const std::string& path) {
  if (const auto objection = hdf5_objection()) {
    throw CLI::ValidationError("--hdf5", *objection + "; choose --csv or --json");
  }
  if (is_direct(path)) {
    throw CLI::ValidationError("--hdf5", path + ": HDF5 needs a regular file");
  }
}

}  // namespace

void add_forms(CLI::App& command, const Output& csv, const Output& json) {
  command.add_option("--csv", csv.path, "write " + csv.what + " as CSV to this file (-: standard output)");
  command.add_option("--json", json.path,
                     "write " + json.what + " as JSON to this file (-: standard output)");
}

void add_output_options(CLI::App& command, const std::string& profile, const Output& csv, const Output& json,
                        const OtherOutputs& others) {
  add_forms(command, csv, json);
  command.final_callback([&profile, &csv_path = csv.path, &json_path = json.path, others] {
    const auto is_given = [](const std::optional<std::string>* path) { return path != nullptr && *path; };
    std::vector<NamedFile> outputs = given({{"--csv", csv_path}, {"--json", json_path}});
    if (is_given(others.hdf5)) {
      check_hdf5(**others.hdf5);
      outputs.push_back({"--hdf5", **others.hdf5});
    }
    if (outputs.empty()) outputs.push_back({"standard output", "-"});
    if (is_given(others.picture)) outputs.push_back({"--output", **others.picture});
    if (is_given(others.events)) outputs.push_back({"--events", **others.events});
    check_files({{"FILE", profile}}, outputs);
    if (is_given(others.picture)) check_picture(**others.picture);
  });
}

void add_profile_options(CLI::App& command, ProfileOptions& options, const std::string& what) {
  command.add_option("FILE", options.profile, what)->required();
  command
      .add_option("--set", options.overrides, "PATH=VALUE: override or add a key of the profile; repeatable")
      ->allow_extra_args(false);
  command.add_flag("--quiet", options.quiet, "no events, notes and progress on standard error");
}

void add_tolerance_option(CLI::App& command, double& tolerance) {
  command.add_option("--tolerance", tolerance, "largest closure error of an ok row, relative to the size")
      ->check(positive_number());
}

void add_threads_option(CLI::App& command, int& threads) {
  command
      .add_option(
          "--threads", threads,
          "number of threads; otherwise as many as there are cores; they make no difference to the result")
      ->check(CLI::Range(1, 100'000));
}

void add_unused_samples(CLI::App& command, const std::string& what_counts) {
  command.add_option_function<std::int64_t>(
      "--samples", [](std::int64_t) {}, fmt::format("no effect: {}", what_counts));
}

}  // namespace higherpair::cli
