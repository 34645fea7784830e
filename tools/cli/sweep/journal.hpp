#pragma once

#include "higherpair/front/sweep.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace higherpair::cli {

/// What a sweep is, thing by thing: two journals are of one sweep where all of it is equal. Values are short
/// texts without line ends.
using SweepIdentity = std::map<std::string, std::string>;

/// All of it as lines of text.
[[nodiscard]] std::string identity_text(const SweepIdentity& identity);

/// The blocks of a sweep in the order of their numbers, on disk: appended one by one, each with its checksum.
/// Whatever kills the program, the file holds every block that was appended and at most one torn one, which
/// is cut off when the file is opened again.
class Journal {
public:
  using Take = std::function<bool(const SweepBlock&)>;  ///< false: no more of them

  /// \param path  empty: a file without a name, which is gone with the program
  explicit Journal(std::string path) : path_(std::move(path)) {}
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Makes the file, or goes on with one that is there. Where that is not possible error() says why.
  /// \param resume  a file that is there is gone on with; else it is left alone, and refused
  /// \param width   values in each row
  /// \param take    gets every block that is there
  /// \return false: failed
  [[nodiscard]] bool open(const SweepIdentity& identity, std::size_t width, bool resume, const Take& take);

  /// Appends a block, or leaves the file as it is, and error() says why.
  [[nodiscard]] bool append(const SweepBlock& block);

  /// Gives every block to `take`; false where that wants no more, or one cannot be read, which error() says.
  [[nodiscard]] bool read(const Take& take);

  /// The file is needed no longer.
  void remove();

  [[nodiscard]] std::int64_t blocks() const { return blocks_; }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] const std::string& error() const { return error_; }
  /// Whether `error` is a mistake of the user (another sweep's file), not of the machine.
  [[nodiscard]] bool is_refused() const { return refused_; }

private:
  bool fail(const std::string& what);
  bool refuse(const std::string& why);
  bool begin(const std::string& header);
  bool check_header(const SweepIdentity& identity, const std::string& header, bool resume);
  bool write(const std::string& bytes);
  std::int64_t read_blocks(const Take& take);

  std::string path_;
  int file_ = -1;
  std::size_t width_ = 0;
  std::int64_t start_ = 0;   ///< of the first block in the file
  std::int64_t length_ = 0;  ///< of all whole blocks and what is before them
  std::int64_t blocks_ = 0;
  std::string error_;
  bool refused_ = false;
};

}  // namespace higherpair::cli
