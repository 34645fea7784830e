#include "module.hpp"

#include <dlfcn.h>

namespace higherpair::cli {

tl::expected<void*, std::string> load_symbol(const std::string& module, const char* name) {
  void* const library = dlopen((module + ".so").c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* const symbol = library != nullptr ? dlsym(library, name) : nullptr;
  if (symbol == nullptr) {
    return tl::unexpected<std::string>(dlerror());
  }
  return symbol;
}

}  // namespace higherpair::cli
