// Passes files, all files of folders, and any number of inputs made from them to a target, so that what a
// fuzzer once found is tested in every build with any compiler.
#include "mutation.hpp"
#include "target.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> paths;
  std::uint64_t mutations = 0;
  std::uint64_t seed = 1;
  std::string last;
};

std::vector<fs::path> files_in(const std::vector<std::string>& paths) {
  std::vector<fs::path> files;
  for (const std::string& path : paths) {
    if (!fs::is_directory(path)) {
      files.emplace_back(path);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
      if (entry.is_regular_file()) {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::runtime_error("cannot read " + path.string());
  }
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void feed(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

// Keeps the input under test in a file, because a fault ends the program at once. The file stays open and is
// not truncated before each write: ext4 writes a truncated file to disk when it is closed, which takes longer
// than most inputs.
class Last {
public:
  explicit Last(const std::string& path) : path_(path) {
    if (!path.empty()) file_.open(path, std::ios::binary | std::ios::trunc);
  }

  void keep(const std::string& input) {
    if (!file_.is_open()) return;
    file_.seekp(0);
    file_ << input << std::flush;
    fs::resize_file(path_, input.size());
  }

private:
  fs::path path_;
  std::ofstream file_;
};

int replay(const Options& options) {
  std::vector<std::string> inputs;
  for (const fs::path& file : files_in(options.paths)) {
    std::fprintf(stderr, "%s\n", file.c_str());  // the last file named is the one that fails
    inputs.push_back(read(file));
    feed(inputs.back());
  }
  if (inputs.empty()) {
    std::fprintf(stderr, "replay: no files\n");
    return 2;
  }
  Last last(options.last);
  for (std::uint64_t i = 0; i < options.mutations; ++i) {
    const std::string input = higherpair::fuzz::mutated(inputs, options.seed + i);
    last.keep(input);
    feed(input);
  }
  std::fprintf(stderr, "%zu files, %llu inputs made from them\n", inputs.size(),
               static_cast<unsigned long long>(options.mutations));
  return 0;
}

int start(int argc, char** argv) {
  Options options;
  CLI::App app("Feeds files to a fuzz target, and inputs made from them.", "replay");
  app.add_option("paths", options.paths, "files, and folders of them")->required()->check(CLI::ExistingPath);
  app.add_option("--mutations", options.mutations, "how many inputs to make from the files");
  app.add_option("--seed", options.seed, "of the first of these; the same inputs for a seed everywhere");
  app.add_option("--last", options.last, "a file for the made input that is being tried: the one that fails");
  CLI11_PARSE(app, argc, argv);
  return replay(options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return start(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "replay: %s\n", error.what());
    return 1;
  }
}
