#pragma once

#include "higherpair/io/motion_table.hpp"
#include "output_file.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace higherpair::cli {

/// An event of a run in the profile's units.
struct Event {
  std::string type;
  double driver = 0;
  std::optional<double> time;
  std::string item;  ///< empty: none
  std::string cause;
};

/// Writes a motion table row by row, as CSV or as JSON.
class RowWriter {
public:
  enum class Format { kCsv, kJson };

  RowWriter(const std::string& path, Format format);

  void begin(const std::string& title, const std::vector<Column>& columns);
  void row(const std::vector<Cell>& cells);
  /// Nothing is written after this.
  void end(const std::vector<Event>& events);

  [[nodiscard]] OutputFile& file() const { return *file_; }

private:
  void flush(std::size_t limit);
  void append_json_row(const std::vector<Cell>& cells);

  Format format_;
  std::unique_ptr<OutputFile> file_;
  std::string buffer_;
  bool first_row_ = true;
};

}  // namespace higherpair::cli
