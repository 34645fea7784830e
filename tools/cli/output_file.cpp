#include "output_file.hpp"

#include "signals.hpp"
#include "tell.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <unistd.h>

namespace higherpair::cli {

namespace fs = std::filesystem;

// Bytes written between two checks for interruption. A pipe takes this many at once, and a signal ends a
// write that waits for its reader.
constexpr std::size_t kBlock = 4096;

std::string target_of(std::string path) {
  constexpr int kMostLinks = 40;
  std::error_code code;
  for (int i = 0; i < kMostLinks; ++i) {
    if (!fs::is_symlink(fs::symlink_status(path, code))) {
      return path;
    }
    const fs::path next = fs::read_symlink(path, code);
    path = (next.is_absolute() ? next : fs::path(path).parent_path() / next).string();
  }
  return "";
}

bool is_direct(const std::string& path) {
  std::error_code code;
  return path == "-" || (fs::exists(path, code) && !fs::is_regular_file(path, code));
}

OutputFile::OutputFile(const std::string& path)
    : refusal_("cannot write " + (path == "-" ? std::string("to standard output") : path)) {
  if (path == "-") {
    file_ = stdout;
    return;
  }
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  const bool direct = fs::exists(status) && !fs::is_regular_file(status);
  if (direct) {
    file_ = std::fopen(path.c_str(), "wb");
  } else {
    target_ = target_of(path);
    if (target_.empty()) {
      errno = ELOOP;
      fail();
      return;
    }
    listen_to_signals();
    temporary_ = target_ + ".part" + std::to_string(getpid());
    file_ = std::fopen(temporary_.c_str(), "wb");
    if (file_ != nullptr && fs::exists(status)) {
      fs::permissions(temporary_, status.permissions(), code);  // what only some may read stays so
    }
  }
  if (file_ == nullptr) {
    fail();
  }
}

OutputFile::~OutputFile() {
  if (file_ != nullptr && file_ != stdout) {
    std::fclose(file_);
  }
  if (!temporary_.empty()) {
    std::remove(temporary_.c_str());
  }
}

void OutputFile::fail() {
  reader_gone_ = reader_gone_ || errno == EPIPE;
  fail_because(std::strerror(errno));
}

void OutputFile::fail_because(const std::string& reason) {
  if (error_.empty()) {
    error_ = refusal_ + ": " + reason;
  }
}

void OutputFile::write(std::string_view text) {
  if (file_ == nullptr || !good()) {
    return;
  }
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
    fail();
  }
}

void OutputFile::finish() {
  if (file_ == nullptr) {
    return;
  }
  if (std::fflush(file_) != 0) {
    fail();
  }
  if (file_ != stdout && std::fclose(file_) != 0) {
    fail();
  }
  file_ = nullptr;
}

void OutputFile::commit() {
  if (temporary_.empty() || !good()) {
    return;
  }
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    fail();
    return;
  }
  temporary_.clear();
}

bool report_failure(const OutputFile& file) {
  if (file.good()) {
    return false;
  }
  if (!file.reader_gone()) {
    tell("higherpair: {}\n", file.error());
  }
  return true;
}

bool commit_all(const std::vector<OutputFile*>& files) {
  const auto failed = [](const OutputFile* file) { return report_failure(*file); };
  if (std::any_of(files.begin(), files.end(), failed)) {
    return false;
  }
  for (OutputFile* file : files) {
    file->commit();
  }
  return std::none_of(files.begin(), files.end(), failed);
}

bool write_files(const std::vector<FileText>& files, const std::atomic<bool>* stop) {
  std::vector<std::unique_ptr<OutputFile>> outputs;
  std::vector<OutputFile*> all;
  for (const FileText& file : files) {
    outputs.push_back(std::make_unique<OutputFile>(file.path));
    all.push_back(outputs.back().get());
  }
  const auto stopped = [stop] { return stop != nullptr && *stop; };
  if (stopped()) {
    return false;
  }
  // Write nothing to standard output if one of the files cannot be opened.
  if (std::any_of(all.begin(), all.end(), [](const OutputFile* file) { return report_failure(*file); })) {
    return false;
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (std::string_view rest = files[i].text; !rest.empty() && !stopped();) {
      all[i]->write(rest.substr(0, kBlock));
      rest.remove_prefix(std::min(kBlock, rest.size()));
    }
    all[i]->finish();
    if (stopped()) {
      return false;
    }
  }
  return commit_all(all);
}

bool write_forms(const std::optional<std::string>& csv, const std::optional<std::string>& json,
                 const Forms& forms, const std::vector<FileText>& pictures) {
  std::vector<FileText> files;
  if (csv) {
    files.push_back({*csv, forms.csv()});
  }
  if (json) {
    files.push_back({*json, forms.json()});
  }
  if (files.empty()) {
    files.push_back({"-", forms.text()});
  }
  files.insert(files.end(), pictures.begin(), pictures.end());
  return !interruption() && write_files(files, &interruption());
}

}  // namespace higherpair::cli
