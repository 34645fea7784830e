#pragma once

#include "higherpair/front/motion.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace higherpair::cli {

/// Whether this program was built with HDF5.
[[nodiscard]] bool has_hdf5();

/// Datasets of equal length, each named after its column.
struct Hdf5Columns {
  std::vector<Column> columns;        ///< numbers with the attribute `unit`, words as an enumeration
  std::vector<std::string> integers;  ///< names of the columns whose numbers are integers
  std::vector<std::string> texts;     ///< names of columns of text
  std::int64_t rows = 0;              ///< number of rows to come, about; 0: unknown
};

/// An HDF5 file with tables that grow. Its content depends only on what is given here, not on the time of
/// day. After the first failure (see error()) nothing more is written.
class Hdf5File {
public:
  /// Creates the file, or empties an existing one.
  explicit Hdf5File(const std::string& path);
  ~Hdf5File();
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;

  /// An attribute of the file.
  void set_attribute(const std::string& name, const std::string& text);

  /// Adds a table in a group of the file; empty: in the file itself.
  /// \return its index
  std::size_t add_table(const std::string& group, const Hdf5Columns& columns);

  /// Appends rows to a table.
  /// \param values  row after row, one for each of Hdf5Columns::columns; NaN where undefined
  /// \param texts   values for each of Hdf5Columns::texts
  void append(std::size_t table, std::span<const double> values,
              const std::vector<std::span<const std::string>>& texts);

  /// To be called at the end: only then is everything in the file, unless error() is set.
  void close();

  /// The first failure; empty: none.
  [[nodiscard]] const std::string& error() const { return error_; }

private:
  struct Impl;

  template <class Work>
  void attempt(const Work& work);

  std::unique_ptr<Impl> impl_;
  std::string error_;
};

}  // namespace higherpair::cli
