#pragma once

#include "higherpair/front/motion.hpp"
#include "output_file.hpp"

#include <memory>
#include <string>
#include <vector>

namespace higherpair::cli {

/// Writes a motion table as CSV or JSON. The text of a block of rows may be made on any thread; it is written
/// in the order of the rows.
class RowWriter {
public:
  enum class Format { kCsv, kJson };

  RowWriter(const std::string& path, Format format, const std::string& title,
            const std::vector<Column>& columns);

  /// May be called from several threads at once.
  void append_text(const RowBlock& block, std::string& out) const;
  void write(const std::string& rows) { file_->write(rows); }
  /// Nothing may be written after this.
  void end(const std::vector<Event>& events, bool good);

  [[nodiscard]] OutputFile& file() const { return *file_; }

private:
  void begin(const std::string& title);
  void append_json_row(const RowBlock& block, std::size_t row, std::string& out) const;

  Format format_;
  std::unique_ptr<OutputFile> file_;
  std::vector<Column> columns_;
};

}  // namespace higherpair::cli
