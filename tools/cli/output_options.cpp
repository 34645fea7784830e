#include "output_options.hpp"

#include <filesystem>

namespace higherpair::cli {
namespace {

namespace fs = std::filesystem;

// Devices and pipes may well take both.
bool is_same_file(const std::string& a, const std::string& b) {
  if (a == "-" || b == "-") {
    return a == b;
  }
  std::error_code code;
  const fs::file_status status = fs::status(a, code);
  const bool device = fs::exists(status) && !fs::is_regular_file(status);
  const auto place = [&](const std::string& path) { return fs::weakly_canonical(fs::absolute(path), code); };
  return !device && place(a) == place(b);
}

}  // namespace

void add_output_options(CLI::App& command, const Output& csv, const Output& json) {
  command.add_option("--csv", csv.path, "write " + csv.what + " as CSV to this file (-: standard output)");
  command.add_option("--json", json.path,
                     "write " + json.what + " as JSON to this file (-: standard output)");
  command.final_callback([&csv_path = csv.path, &json_path = json.path] {
    if (csv_path && json_path && is_same_file(*csv_path, *json_path)) {
      throw CLI::ValidationError("--csv and --json",
                                 "both name " + *csv_path + "; give each a file of its own");
    }
  });
}

void add_unused_samples(CLI::App& command) {
  command.add_option_function<std::int64_t>(
      "--samples", [](std::int64_t) {}, "no effect: the first driver position only is looked at");
}

}  // namespace higherpair::cli
