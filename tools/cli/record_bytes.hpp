#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace higherpair::cli {

/// Appends a value in the machine's representation.
template <class T>
void put(const T& value, std::string& bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Removes a value from the front and returns it. \pre there are enough bytes
template <class T>
[[nodiscard]] T take(std::string_view& bytes) {
  static_assert(std::is_trivially_copyable_v<T>);
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return value;
}

}  // namespace higherpair::cli
