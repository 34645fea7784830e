#include "sweep/block_bytes.hpp"

#include "sweep/checksum.hpp"

#include <cstring>

namespace higherpair::cli {
namespace {

constexpr std::uint32_t kBlockMark = 0x4b4c4248;  // "HBLK"

struct BlockHead {
  std::uint32_t mark = kBlockMark;
  std::uint32_t width = 0;
  std::int64_t number = 0;
  std::int64_t variants = 0;
  std::int64_t good = 0;
  std::int64_t rows = 0;
  std::int64_t cause_bytes = 0;
};
static_assert(sizeof(BlockHead) == kBlockHeadSize);

struct CauseHead {
  std::int64_t row = 0;
  std::int64_t length = 0;
};

template <class T>
void put(const T& value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// \pre there are enough bytes
template <class T>
T take(std::string_view& bytes) {
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes.remove_prefix(sizeof value);
  return value;
}

std::string causes_of(const SweepBlock& block) {
  std::string bytes;
  for (std::size_t row = 0; row < block.causes.size(); ++row) {
    if (!block.causes[row].empty()) {
      put(CauseHead{static_cast<std::int64_t>(row), static_cast<std::int64_t>(block.causes[row].size())},
          bytes);
      bytes += block.causes[row];
    }
  }
  return bytes;
}

}  // namespace

std::string block_bytes(const SweepBlock& block, std::size_t width) {
  const std::string causes = causes_of(block);
  std::string bytes;
  put(BlockHead{kBlockMark, static_cast<std::uint32_t>(width), block.number, block.variants, block.good,
                static_cast<std::int64_t>(block.causes.size()), static_cast<std::int64_t>(causes.size())},
      bytes);
  bytes.append(reinterpret_cast<const char*>(block.values.data()), block.values.size() * sizeof(double));
  bytes += causes;
  put(checksum(bytes), bytes);
  return bytes;
}

std::optional<std::size_t> block_size(std::string_view bytes, std::size_t width, std::size_t most) {
  constexpr std::size_t kLeast = kBlockHeadSize + sizeof(std::uint64_t);
  if (bytes.size() < kBlockHeadSize || most < kLeast) {
    return std::nullopt;
  }
  const auto head = take<BlockHead>(bytes);
  const auto rest = static_cast<std::int64_t>(most - kLeast);
  if (head.mark != kBlockMark || head.width != width || head.rows < 0 || head.cause_bytes < 0 ||
      head.cause_bytes > rest ||
      head.rows > (rest - head.cause_bytes) / static_cast<std::int64_t>(width * sizeof(double))) {
    return std::nullopt;
  }
  return kLeast + static_cast<std::size_t>(head.rows) * width * sizeof(double) +
         static_cast<std::size_t>(head.cause_bytes);
}

std::optional<SweepBlock> block_of(std::string_view bytes, std::size_t width) {
  if (block_size(bytes, width, bytes.size()) != bytes.size()) {
    return std::nullopt;
  }
  std::string_view sum = bytes.substr(bytes.size() - sizeof(std::uint64_t));
  bytes.remove_suffix(sizeof(std::uint64_t));
  if (take<std::uint64_t>(sum) != checksum(bytes)) {
    return std::nullopt;
  }
  const auto head = take<BlockHead>(bytes);
  SweepBlock block;
  block.number = head.number;
  block.variants = head.variants;
  block.good = head.good;
  block.values.resize(static_cast<std::size_t>(head.rows) * width);
  block.causes.resize(static_cast<std::size_t>(head.rows));
  std::memcpy(block.values.data(), bytes.data(), block.values.size() * sizeof(double));
  bytes.remove_prefix(block.values.size() * sizeof(double));
  while (bytes.size() >= sizeof(CauseHead)) {
    const auto cause = take<CauseHead>(bytes);
    block.causes.at(static_cast<std::size_t>(cause.row)) =
        bytes.substr(0, static_cast<std::size_t>(cause.length));
    bytes.remove_prefix(static_cast<std::size_t>(cause.length));
  }
  return block;
}

}  // namespace higherpair::cli
