// Replaces hdf5_file.cpp in builds without HDF5.
#include "hdf5_file.hpp"

namespace higherpair::cli {

struct Hdf5File::Impl {};

Hdf5File::Hdf5File(const std::string& /*path*/) : error_("this higherpair was built without HDF5") {}
Hdf5File::~Hdf5File() = default;
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;
void Hdf5File::set_attribute(const std::string& /*name*/, const std::string& /*text*/) {}
std::size_t Hdf5File::add_table(const std::string& /*group*/, const Hdf5Columns& /*columns*/) {
  return 0;
}
void Hdf5File::append(std::size_t /*table*/, std::span<const double> /*values*/,
                      const std::vector<std::span<const std::string>>& /*texts*/) {}
void Hdf5File::close() {}

bool has_hdf5() {
  return false;
}

}  // namespace higherpair::cli
