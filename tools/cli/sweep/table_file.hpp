#pragma once

#include "higherpair/front/sweep.hpp"

#include <functional>
#include <optional>
#include <string>

namespace higherpair::cli {

/// Attributes of the HDF5 file of a sweep.
struct SweepTitle {
  std::string title;    ///< of the mechanism
  std::string profile;  ///< file name of the profile
};

/// Passes every block to its argument, in order; returns false on failure.
using EachBlock = std::function<bool(const std::function<void(const SweepBlock&)>&)>;

/// Whether a path ends in .h5 or .hdf5; otherwise the table is CSV.
[[nodiscard]] bool is_hdf5(const std::string& path);

/// Writes the table of a sweep. A regular file is written under a temporary name and renamed at the end;
/// temporary files left by killed runs are removed. In HDF5 there is a dataset for each column, and `cause`
/// as text.
/// \param threads  number of threads that format CSV; 0: as many as there are cores
/// \return none: the table is written. Otherwise the reason; empty if nobody reads the output any more, or
/// `each` has failed
[[nodiscard]] std::optional<std::string> write_table(const std::string& path, const Sweep& sweep,
                                                     const SweepTitle& title, int threads,
                                                     const EachBlock& each);

}  // namespace higherpair::cli
