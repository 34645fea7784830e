#pragma once

#include <atomic>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::cli {

/// The target of a chain of symbolic links, whether it exists or not; empty if the links form a loop.
[[nodiscard]] std::string target_of(std::string path);

/// Whether an output is written directly: standard output ("-"), a device or a pipe.
[[nodiscard]] bool is_direct(const std::string& path);

/// An output: standard output ("-"), a device or pipe, which are written directly, or a regular file. This is
/// written under a temporary name and renamed by commit(), so that an uncommitted file leaves no trace; from
/// its construction on a signal only sets interruption(). Several outputs of one command are all finished
/// before they are committed.
class OutputFile {
public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// False after any failure; error() gives the first one.
  [[nodiscard]] bool good() const { return error_.empty(); }
  [[nodiscard]] const std::string& error() const { return error_; }
  /// Whether the pipe's reader is gone.
  [[nodiscard]] bool reader_gone() const { return reader_gone_; }

  void write(std::string_view text);
  /// The temporary path of a regular file, for a library that writes the file itself; it reports its failures
  /// by fail_because().
  [[nodiscard]] const std::string& place() const { return temporary_; }
  void fail_because(const std::string& reason);
  /// Nothing may be written after this.
  void finish();
  /// Renames the finished file to its final name.
  void commit();

private:
  void fail();

  std::string refusal_;    ///< beginning of messages: "cannot write" the path
  std::string target_;     ///< the file's path, with links resolved
  std::string temporary_;  ///< empty: written directly
  std::FILE* file_ = nullptr;
  std::string error_;
  bool reader_gone_ = false;
};

/// Whether a file has failed; reports it on standard error, unless the pipe's reader is gone.
[[nodiscard]] bool report_failure(const OutputFile& file);

/// Commits finished files, none if one of them has failed. False on failure, with the reason on standard
/// error; if it is a renaming that fails, files renamed before it stay.
[[nodiscard]] bool commit_all(const std::vector<OutputFile*>& files);

struct FileText {
  std::string path;
  std::string text;
};

/// Writes whole files and commits them, see commit_all(). False on failure, with the reason on standard
/// error, or silently if `stop` becomes true before all are written.
[[nodiscard]] bool write_files(const std::vector<FileText>& files, const std::atomic<bool>* stop = nullptr);

/// The results of a command, each form made only if it is needed.
struct Forms {
  std::function<std::string()> csv;
  std::function<std::string()> json;
  std::function<std::string()> text;
};

/// Writes CSV and JSON to the files given, or readable text to standard output if neither is, and the
/// pictures; see write_files. Also false if interruption() occurs while a form is made or written.
[[nodiscard]] bool write_forms(const std::optional<std::string>& csv, const std::optional<std::string>& json,
                               const Forms& forms, const std::vector<FileText>& pictures = {});

}  // namespace higherpair::cli
