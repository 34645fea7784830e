#pragma once

#include <cstdint>
#include <string_view>

#include <boost/crc.hpp>

namespace higherpair::cli {

/// CRC-64 (that of XZ): it tells a torn or changed block from a whole one.
[[nodiscard]] inline std::uint64_t checksum(std::string_view bytes) {
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693ULL, ~0ULL, ~0ULL, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

}  // namespace higherpair::cli
