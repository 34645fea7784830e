#include "sweep/block_bytes.hpp"

#include "record_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <utility>

namespace higherpair::cli {
namespace {

struct BlockHead {
  std::int64_t width = 0;
  std::int64_t number = 0;
  std::int64_t variants = 0;
  std::int64_t good = 0;
  std::int64_t rows = 0;
  std::int64_t cause_bytes = 0;
};

struct CauseHead {
  std::int64_t row = 0;
  std::int64_t length = 0;
};

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

// Whether the head is consistent with `width` and with the number of bytes that follow it.
bool has_all_of(const BlockHead& head, std::size_t rest, std::size_t width) {
  const auto bytes = static_cast<std::int64_t>(rest);
  const auto row = static_cast<std::int64_t>(width * sizeof(double));
  return head.width == static_cast<std::int64_t>(width) && head.rows >= 0 && head.cause_bytes >= 0 &&
         head.cause_bytes <= bytes && head.rows <= bytes / row && head.rows * row + head.cause_bytes == bytes;
}

}  // namespace

std::string block_bytes(const SweepBlock& block, std::size_t width) {
  const std::string causes = causes_of(block);
  std::string bytes;
  put(BlockHead{static_cast<std::int64_t>(width), block.number, block.variants, block.good,
                static_cast<std::int64_t>(block.causes.size()), static_cast<std::int64_t>(causes.size())},
      bytes);
  bytes.append(reinterpret_cast<const char*>(block.values.data()), block.values.size() * sizeof(double));
  return bytes + causes;
}

std::optional<SweepBlock> block_of(std::string_view bytes, std::size_t width) {
  if (bytes.size() < sizeof(BlockHead)) {
    return std::nullopt;
  }
  const auto head = take<BlockHead>(bytes);
  if (!has_all_of(head, bytes.size(), width)) {
    return std::nullopt;
  }
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

std::function<bool(std::string_view)> records_as_blocks(std::size_t width, TakeBlock take) {
  return [width, take = std::move(take), number = std::int64_t{0}](std::string_view record) mutable {
    const auto block = block_of(record, width);
    return block && block->number == number++ && take(*block);
  };
}

}  // namespace higherpair::cli
