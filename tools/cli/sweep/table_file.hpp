#pragma once

#include "higherpair/front/sweep.hpp"

#include <functional>
#include <optional>
#include <string>

namespace higherpair::cli {

/// What stands at the head of an HDF5 file of a sweep.
struct SweepTitle {
  std::string title;    ///< of the mechanism
  std::string profile;  ///< name of the file
};

/// Whether HDF5 was there when the program was built.
[[nodiscard]] bool has_hdf5();

/// Calls its argument with every block, in order; false where that fails.
using EachBlock = std::function<bool(const std::function<void(const SweepBlock&)>&)>;

/// Whether a name is one of HDF5, .h5 or .hdf5; else the table is CSV.
[[nodiscard]] bool is_hdf5(const std::string& path);

/// Whether an output is written directly: standard output ("-"), a device or a pipe.
[[nodiscard]] bool is_direct(const std::string& path);

/// Writes the table of a sweep: a regular file beside its place, and renamed at the end. What a killed run
/// has left beside it is removed. \return none: it is written. Else why not; empty where nobody wants to read
/// it, or `each` has failed
[[nodiscard]] std::optional<std::string> write_table(const std::string& path, const Sweep& sweep,
                                                     const SweepTitle& title, const EachBlock& each);

/// Writes the table of a sweep as HDF5 to a new file: a dataset for each column, named after it, with its
/// unit as the attribute `unit`; `status` is an enumeration, `cause` a text. \return what went wrong; empty:
/// nothing
[[nodiscard]] std::string write_hdf5(const std::string& path, const Sweep& sweep, const SweepTitle& title,
                                     const EachBlock& each);

}  // namespace higherpair::cli
