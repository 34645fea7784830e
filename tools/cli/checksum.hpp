#pragma once

#include <cstdint>
#include <lzma.h>
#include <string_view>

namespace higherpair::cli {

/// CRC-64 (as in XZ): detects incomplete and changed records.
[[nodiscard]] inline std::uint64_t checksum(std::string_view bytes) {
  return lzma_crc64(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(), 0);
}

}  // namespace higherpair::cli
