#include "sweep/table_file.hpp"

#include "hdf5_file.hpp"
#include "output_file.hpp"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <future>
#include <memory>
#include <thread>
#include <vector>

namespace higherpair::cli {
namespace {

namespace fs = std::filesystem;

// Removes incomplete tables left by killed runs. No other run can be writing them while this one holds the
// journal.
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

// Ends a file; returns why it failed, "" if it is not to be kept.
std::optional<std::string> closed(OutputFile& file, bool all) {
  file.finish();
  if (all) file.commit();
  if (file.good()) {
    return all ? std::nullopt : std::optional(std::string());
  }
  return file.reader_gone() ? "" : file.error();
}

// Formatting numbers takes most of the time: several blocks are formatted at once and written in order.
std::optional<std::string> write_csv(const std::string& path, const Sweep& sweep, std::size_t threads,
                                     const EachBlock& each) {
  OutputFile file(path);
  file.write(sweep_csv_header(sweep));
  std::deque<std::future<std::string>> texts;
  const auto write_first = [&] {
    file.write(texts.front().get());
    texts.pop_front();
  };
  const bool all = each([&](const SweepBlock& block) {
    if (texts.size() == threads) write_first();
    texts.push_back(std::async(std::launch::async, [&sweep, block] {
      std::string text;
      append_sweep_csv(sweep, block, text);
      return text;
    }));
  });
  while (!texts.empty()) write_first();
  return closed(file, all);
}

std::optional<std::string> write_h5(const std::string& path, const Sweep& sweep, const SweepTitle& title,
                                    const EachBlock& each) {
  OutputFile file(path);
  if (!file.good()) {
    return file.error();
  }
  const std::unique_ptr<Hdf5File> data = create_hdf5(file.place());
  data->set_attribute("title", title.title);
  data->set_attribute("profile", title.profile);
  const std::size_t table = data->add_table("", {sweep.columns(), {"variant"}, {"cause"}, sweep.size()});
  const bool all = each([&](const SweepBlock& block) { data->append(table, block.values, {block.causes}); });
  data->close();
  if (!data->error().empty()) file.fail_because(data->error());
  return closed(file, all);
}

}  // namespace

bool is_hdf5(const std::string& path) {
  return path.ends_with(".h5") || path.ends_with(".hdf5");
}

std::optional<std::string> write_table(const std::string& path, const Sweep& sweep, const SweepTitle& title,
                                       int threads, const EachBlock& each) {
  if (!is_direct(path)) {
    remove_torn_tables(target_of(path));
  }
  const auto at_once =
      threads > 0 ? static_cast<unsigned>(threads) : std::max(std::thread::hardware_concurrency(), 1U);
  return is_hdf5(path) ? write_h5(path, sweep, title, each) : write_csv(path, sweep, at_once, each);
}

}  // namespace higherpair::cli
