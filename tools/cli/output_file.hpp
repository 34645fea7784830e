#pragma once

#include <atomic>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::cli {

/// The file that a chain of links names, whether it exists or not; empty where the links form a loop.
[[nodiscard]] std::string target_of(std::string path);

/// Whether an output is written directly: standard output ("-"), a device or a pipe.
[[nodiscard]] bool is_direct(const std::string& path);

/// Where a table goes: standard output ("-"), a device or pipe (written directly), or a regular file, which
/// is written beside its place and renamed by commit(): what is not committed leaves no trace, and a signal
/// only sets interruption() from then on. Several
/// outputs of one command are finished first and committed when all are good.
class OutputFile {
public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// False on any failure so far; error() says which.
  [[nodiscard]] bool good() const { return error_.empty(); }
  [[nodiscard]] const std::string& error() const { return error_; }
  /// Whether nobody reads the pipe any more.
  [[nodiscard]] bool reader_gone() const { return reader_gone_; }

  void write(std::string_view text);
  /// Of a regular file, where it is written: for whoever writes it himself, and says with fail_because what
  /// went wrong.
  [[nodiscard]] const std::string& place() const { return temporary_; }
  void fail_because(const std::string& reason);
  /// Nothing is written after this.
  void finish();
  /// Puts the finished file into its place.
  void commit();

private:
  void fail();

  std::string refusal_;    ///< "cannot write" it
  std::string target_;     ///< the file that a link names
  std::string temporary_;  ///< empty: written directly
  std::FILE* file_ = nullptr;
  std::string error_;
  bool reader_gone_ = false;
};

/// Whether a file has failed; says so on standard error, but for a reader that has read enough.
[[nodiscard]] bool report_failure(const OutputFile& file);

/// Puts finished files into their places, all or none; false, with the reason on standard error, where one
/// has failed.
[[nodiscard]] bool commit_all(const std::vector<OutputFile*>& files);

struct FileText {
  std::string path;
  std::string text;
};

/// Writes whole files, all or none; false, with the reason on standard error, where that fails, and without a
/// word where `stop` has become true before all have been written.
[[nodiscard]] bool write_files(const std::vector<FileText>& files, const std::atomic<bool>* stop = nullptr);

/// What a command has found, each form made where it is asked for.
struct Forms {
  std::function<std::string()> csv;
  std::function<std::string()> json;
  std::function<std::string()> text;
};

/// Writes CSV and JSON to the files named, readable text to standard output where neither is, and the
/// pictures; as write_files. False as well where interruption() came while a form was made or written.
[[nodiscard]] bool write_forms(const std::optional<std::string>& csv, const std::optional<std::string>& json,
                               const Forms& forms, const std::vector<FileText>& pictures = {});

}  // namespace higherpair::cli
