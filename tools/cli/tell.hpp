#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include <fmt/core.h>

namespace higherpair::cli {

/// Writes to standard error. Where that cannot be written (a closed pipe, a full disk) the text is lost, and
/// nothing else: results and the exit code are those of the command.
template <class... Args>
void tell(fmt::format_string<Args...> format, Args&&... args) {
  const std::string text = fmt::format(format, std::forward<Args>(args)...);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace higherpair::cli
