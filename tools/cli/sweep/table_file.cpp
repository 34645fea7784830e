#include "sweep/table_file.hpp"

#include "output_file.hpp"

#include <filesystem>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>

namespace higherpair::cli {
namespace {

namespace fs = std::filesystem;

// A table that a killed run has begun: nobody else writes it while this one has the journal.
void remove_torn_tables(const std::string& target) {
  const std::string prefix = fs::path(target).filename().string() + ".part";
  const fs::path folder = fs::path(target).parent_path();
  std::error_code code;
  std::vector<fs::path> torn;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, code)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > prefix.size() && name.starts_with(prefix) &&
        name.find_first_not_of("0123456789", prefix.size()) == std::string::npos) {
      torn.push_back(entry.path());
    }
  }
  for (const fs::path& path : torn) fs::remove(path, code);
}

std::optional<std::string> write_csv(const std::string& path, const Sweep& sweep, const EachBlock& each) {
  OutputFile file(path);
  file.write(sweep_csv_header(sweep));
  std::string text;
  const bool all = each([&](const SweepBlock& block) {
    text.clear();
    append_sweep_csv(sweep, block, text);
    file.write(text);
  });
  file.finish();
  if (all) file.commit();
  if (file.good()) {
    return all ? std::nullopt : std::optional(std::string());
  }
  return file.reader_gone() ? "" : file.error();
}

std::optional<std::string> write_h5(const std::string& path, const Sweep& sweep, const SweepTitle& title,
                                    const EachBlock& each) {
  const std::string target = target_of(path);
  const std::string temporary = fmt::format("{}.part{}", target, getpid());
  std::string failure = write_hdf5(temporary, sweep, title, each);
  std::error_code code;
  if (failure.empty()) {
    fs::rename(temporary, target, code);
    failure = code ? code.message() : "";
  }
  fs::remove(temporary, code);
  return failure.empty() ? std::nullopt : std::optional(fmt::format("cannot write {}: {}", path, failure));
}

}  // namespace

bool is_hdf5(const std::string& path) {
  return path.ends_with(".h5") || path.ends_with(".hdf5");
}

bool is_direct(const std::string& path) {
  std::error_code code;
  return path == "-" || (fs::exists(path, code) && !fs::is_regular_file(path, code));
}

std::optional<std::string> write_table(const std::string& path, const Sweep& sweep, const SweepTitle& title,
                                       const EachBlock& each) {
  if (!is_direct(path)) {
    remove_torn_tables(target_of(path));
  }
  return is_hdf5(path) ? write_h5(path, sweep, title, each) : write_csv(path, sweep, each);
}

}  // namespace higherpair::cli
