#pragma once

#include "hdf5_file.hpp"
#include "higherpair/front/motion.hpp"
#include "output_file.hpp"

#include <memory>
#include <string>
#include <vector>

namespace higherpair::cli {

/// What stands at the head of a run's HDF5 file.
struct RowTitle {
  std::string title;        ///< of the mechanism
  std::string profile;      ///< name of the file
  std::string driver_unit;  ///< of the first driver's position
  std::string time_unit;
};

/// Writes a motion table as HDF5: a dataset for each column, and the group `events` with a dataset for each
/// of their columns. A failure is one of file().
class RowHdf5 {
public:
  /// \param path  of a regular file
  RowHdf5(const std::string& path, RowTitle title, const std::vector<Column>& columns);

  void write(const RowBlock& block);
  /// Nothing is written after this. \param lines  the events as they are printed
  void end(const std::vector<Event>& events, const std::vector<std::string>& lines, bool good);

  [[nodiscard]] OutputFile& file() const { return *file_; }

private:
  void check();

  RowTitle title_;
  std::unique_ptr<OutputFile> file_;
  Hdf5File data_;
  std::size_t rows_ = 0;  ///< their table
};

}  // namespace higherpair::cli
