#pragma once

#include <string>

#include <tl/expected.hpp>

namespace higherpair::cli {

/// The function `name`, of C linkage, of a module: a part of the program that is a library of its own,
/// because what it depends on takes longer to load than most mechanisms to analyse. It is looked for where
/// the program's run path says (cmake/module.cmake), and stays loaded.
/// \return the loader's message if there is no such module, or if a library that it depends on is missing
[[nodiscard]] tl::expected<void*, std::string> load_symbol(const std::string& module, const char* name);

/// The same as a function whose declaration the program shares with the module:
/// `load<decltype(higherpair_pdf_of)>("higherpair-pictures", "higherpair_pdf_of")`.
template <class Function>
[[nodiscard]] tl::expected<Function*, std::string> load(const std::string& module, const char* name) {
  return load_symbol(module, name).map([](void* symbol) { return reinterpret_cast<Function*>(symbol); });
}

}  // namespace higherpair::cli
