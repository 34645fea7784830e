#pragma once

#include "higherpair/front/motion.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace higherpair::cli {

/// Whether HDF5 was there when the program was built.
[[nodiscard]] bool has_hdf5();

/// Datasets of one length, each called after its column.
struct Hdf5Columns {
  std::vector<Column> columns;        ///< of numbers, with the attribute `unit`; of words, as an enumeration
  std::vector<std::string> integers;  ///< names of those of the numbers that are whole
  std::vector<std::string> texts;     ///< names of columns of text
};

/// A file of HDF5 with tables that grow. What is written depends on nothing but what is given here, not on
/// the time of day. After the first failure, which error() tells, nothing is written any more.
class Hdf5File {
public:
  /// Makes the file, or empties the one that is there.
  explicit Hdf5File(const std::string& path);
  ~Hdf5File();
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;

  /// An attribute of the file.
  void set_attribute(const std::string& name, const std::string& text);

  /// A table in a group of the file; empty: in the file itself. \return its number
  std::size_t add_table(const std::string& group, const Hdf5Columns& columns);

  /// Rows behind those of the table.
  /// \param values  row after row, one for each of Hdf5Columns::columns; NaN where undefined
  /// \param texts   of each of Hdf5Columns::texts
  void append(std::size_t table, std::span<const double> values,
              const std::vector<std::span<const std::string>>& texts);

  /// To be called at the end: only then all of it is in the file, or error() says why not.
  void close();

  /// What went wrong; empty: nothing.
  [[nodiscard]] const std::string& error() const { return error_; }

private:
  struct Impl;

  template <class Work>
  void attempt(const Work& work);

  std::unique_ptr<Impl> impl_;
  std::string error_;
};

}  // namespace higherpair::cli
