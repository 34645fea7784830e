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

/// Calls its argument with every block, in order; false where that fails.
using EachBlock = std::function<bool(const std::function<void(const SweepBlock&)>&)>;

/// Whether a name is one of HDF5, .h5 or .hdf5; else the table is CSV.
[[nodiscard]] bool is_hdf5(const std::string& path);

/// Writes the table of a sweep: a regular file beside its place, and renamed at the end. What a killed run
/// has left beside it is removed. \return none: it is written. Else why not; empty where nobody wants to read
/// it, or `each` has failed. \param threads  so many make lines of CSV; 0: as many as there are cores. As
/// HDF5: a dataset for each column, and `cause` as text
[[nodiscard]] std::optional<std::string> write_table(const std::string& path, const Sweep& sweep,
                                                     const SweepTitle& title, int threads,
                                                     const EachBlock& each);

}  // namespace higherpair::cli
