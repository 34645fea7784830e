#pragma once

#include "run_identity.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace higherpair::cli {

/// The progress of a long run on disk: records appended one by one, each with a checksum. However the program
/// is killed, the file contains all records that were appended and at most one incomplete one, which is cut
/// off when the file is opened again. Records are in the machine's representation, so a run can be resumed
/// only on the same kind of machine.
class Journal {
public:
  /// Receives a record; returns false to get no more.
  using Take = std::function<bool(std::string_view record)>;

  /// \param path  empty: an unnamed temporary file, which disappears with the program
  /// \param run   kind of run, for messages: "sweep"
  Journal(std::string path, std::string run) : path_(std::move(path)), run_(std::move(run)) {}
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Creates the file, or continues an existing one. On failure error() gives the reason.
  /// \param resume  whether an existing file is continued; otherwise it is left alone and refused, unless it
  /// has no records
  /// \param take    receives every existing record; the first one that it refuses and all after it are cut
  /// off
  /// \return false: failed
  [[nodiscard]] bool open(const RunIdentity& identity, bool resume, const Take& take);

  /// Appends a record. On failure leaves the file as it was, and error() gives the reason.
  [[nodiscard]] bool append(std::string_view record);

  /// Passes every record to `take`. False if that wants no more, or if a record cannot be read (see error()).
  [[nodiscard]] bool read(const Take& take);

  /// Deletes the file, when it is not needed any more.
  void remove();

  [[nodiscard]] std::int64_t records() const { return records_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& error() const { return error_; }
  /// Whether error() is a mistake of the user (a file of another run), not a failure of the machine.
  [[nodiscard]] bool is_refused() const { return refused_; }

private:
  bool fail(const std::string& what);
  bool refuse(const std::string& why);
  bool begin(const std::string& header);
  bool check_header(const RunIdentity& identity, const std::string& header, bool resume);
  bool write(const std::string& bytes);
  std::int64_t read_records(const Take& take);
  [[nodiscard]] std::string magic() const;
  [[nodiscard]] std::string read_header() const;
  [[nodiscard]] bool holds_nothing() const;

  std::string path_;
  std::string run_;
  int file_ = -1;
  std::int64_t start_ = 0;   ///< position of the first record
  std::int64_t length_ = 0;  ///< end of the last complete record
  std::int64_t records_ = 0;
  std::string error_;
  bool refused_ = false;
};

/// Prints why a run cannot be resumed or recorded; returns the exit code.
[[nodiscard]] int report_journal(const Journal& journal);

}  // namespace higherpair::cli
