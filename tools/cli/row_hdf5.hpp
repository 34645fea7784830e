#pragma once

#include "hdf5_file.hpp"
#include "higherpair/front/motion.hpp"
#include "output_file.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace higherpair::cli {

/// Attributes of a run's HDF5 file, and the units of its events.
struct RowTitle {
  std::string title;        ///< of the mechanism
  std::string profile;      ///< file name of the profile
  std::string driver_unit;  ///< of the first driver's position
  std::string time_unit;
};

/// Writes a motion table as HDF5: a dataset for each column, and a group `events` with a dataset for each of
/// the events' columns. Failures are reported by file().
class RowHdf5 {
public:
  /// \param path  a regular file
  /// \param rows  number of rows to come
  RowHdf5(const std::string& path, RowTitle title, const std::vector<Column>& columns, std::int64_t rows);

  void write(const RowBlock& block);
  /// Writes the events; nothing may be written after this.
  /// \param lines  the events as they are printed
  void end(const std::vector<Event>& events, const std::vector<std::string>& lines, bool good);

  [[nodiscard]] OutputFile& file() const { return *file_; }

private:
  void check();

  RowTitle title_;
  std::unique_ptr<OutputFile> file_;
  std::unique_ptr<Hdf5File> data_;
  std::size_t rows_ = 0;  ///< index of their table
};

}  // namespace higherpair::cli
