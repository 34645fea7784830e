#pragma once

#include "run_identity.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace higherpair::cli {

/// What a long run has done so far, record by record, on disk: appended one by one, each with its checksum.
/// Whatever kills the program, the file holds every record that was appended and at most one torn one, which
/// is cut off when the file is opened again. The bytes are those of the machine: a journal is gone on with
/// where it was begun.
class Journal {
public:
  /// Gets a record; false: no more of them.
  using Take = std::function<bool(std::string_view record)>;

  /// \param path  empty: a file without a name, which is gone with the program
  /// \param run   what it is of, in messages: "sweep"
  Journal(std::string path, std::string run) : path_(std::move(path)), run_(std::move(run)) {}
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Makes the file, or goes on with one that is there. Where that is not possible error() says why.
  /// \param resume  a file that is there is gone on with; else it is left alone, and refused, unless it has
  /// no record \param take    gets every record that is there; from one that it refuses on they are cut off
  /// \return false: failed
  [[nodiscard]] bool open(const RunIdentity& identity, bool resume, const Take& take);

  /// Appends a record, or leaves the file as it is, and error() says why.
  [[nodiscard]] bool append(std::string_view record);

  /// Gives every record to `take`; false where that wants no more, or one cannot be read, which error() says.
  [[nodiscard]] bool read(const Take& take);

  /// The file is needed no longer.
  void remove();

  [[nodiscard]] std::int64_t records() const { return records_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& error() const { return error_; }
  /// Whether `error` is a mistake of the user (another run's file), not of the machine.
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
  std::int64_t start_ = 0;   ///< of the first record in the file
  std::int64_t length_ = 0;  ///< of all whole records and what is before them
  std::int64_t records_ = 0;
  std::string error_;
  bool refused_ = false;
};

/// Prints why a journal cannot be gone on with; returns the exit code.
[[nodiscard]] int report_journal(const Journal& journal);

}  // namespace higherpair::cli
