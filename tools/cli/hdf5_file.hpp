#pragma once

#include "higherpair/front/motion.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace higherpair::cli {

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
  virtual ~Hdf5File() = default;

  /// An attribute of the file.
  virtual void set_attribute(const std::string& name, const std::string& text) = 0;

  /// Adds a table in a group of the file; empty: in the file itself.
  /// \return its index
  virtual std::size_t add_table(const std::string& group, const Hdf5Columns& columns) = 0;

  /// Appends rows to a table.
  /// \param values  row after row, one for each of Hdf5Columns::columns; NaN where undefined
  /// \param texts   values for each of Hdf5Columns::texts
  virtual void append(std::size_t table, std::span<const double> values,
                      const std::vector<std::span<const std::string>>& texts) = 0;

  /// To be called at the end: only then is everything in the file, unless error() is set.
  virtual void close() = 0;

  /// The first failure; empty: none.
  [[nodiscard]] virtual const std::string& error() const = 0;
};

/// Why no HDF5 can be written: the module that does it cannot be loaded; none if it can.
[[nodiscard]] std::optional<std::string> hdf5_objection();

/// Creates a file, or empties an existing one. Without an objection it is never null.
[[nodiscard]] std::unique_ptr<Hdf5File> create_hdf5(const std::string& path);

}  // namespace higherpair::cli

/// What the module higherpair-hdf5 exports: create_hdf5().
extern "C" void higherpair_create_hdf5(const std::string& path,
                                       std::unique_ptr<higherpair::cli::Hdf5File>& file);
