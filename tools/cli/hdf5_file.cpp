#include "hdf5_file.hpp"

#include "module.hpp"

namespace higherpair::cli {
namespace {

tl::expected<decltype(higherpair_create_hdf5)*, std::string> creator() {
  return load<decltype(higherpair_create_hdf5)>("higherpair-hdf5", "higherpair_create_hdf5");
}

}  // namespace

std::optional<std::string> hdf5_objection() {
  const auto create = creator();
  return create ? std::nullopt
                : std::optional("this higherpair was built without HDF5, or cannot load it (" +
                                create.error() + ")");
}

std::unique_ptr<Hdf5File> create_hdf5(const std::string& path) {
  std::unique_ptr<Hdf5File> file;
  if (const auto create = creator()) {
    (*create)(path, file);
  }
  return file;
}

}  // namespace higherpair::cli
