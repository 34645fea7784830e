#pragma once

#include "higherpair/front/motion.hpp"
#include "output_file.hpp"

#include <memory>
#include <string>
#include <vector>

namespace higherpair::cli {

/// Writes a motion table row by row, as CSV or as JSON.
class RowWriter {
public:
  enum class Format { kCsv, kJson };

  RowWriter(const std::string& path, Format format);

  void begin(const std::string& title, const std::vector<Column>& columns);
  void row(const Row& row);
  /// Nothing is written after this.
  void end(const std::vector<Event>& events, bool good);

  [[nodiscard]] OutputFile& file() const { return *file_; }

private:
  void flush(std::size_t limit);
  void append_json_row(const Row& row);

  Format format_;
  std::unique_ptr<OutputFile> file_;
  std::string buffer_;
  std::vector<Column> columns_;
};

}  // namespace higherpair::cli
