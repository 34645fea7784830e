// Where HDF5 was not there when the program was built.
#include "sweep/table_file.hpp"

namespace higherpair::cli {

bool has_hdf5() {
  return false;
}

std::string write_hdf5(const std::string& /*path*/, const Sweep& /*sweep*/, const SweepTitle& /*title*/,
                       const EachBlock& /*each*/) {
  return "this higherpair was built without HDF5";
}

}  // namespace higherpair::cli
