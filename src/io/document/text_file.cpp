#include "text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 28;  // 256 MB; protects against devices without an end

}  // namespace

tl::expected<std::string, std::string> read_text_file(const std::string& path, const std::string& what) {
  const auto reason = [] { return std::generic_category().message(errno); };
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (file == nullptr) {
    return tl::unexpected(fmt::format("cannot be opened: {}", reason()));
  }
  std::string text;
  constexpr std::size_t kBlock = std::size_t{1} << 16;
  std::size_t got = kBlock;
  while (got == kBlock && text.size() <= kLargestFile) {
    const std::size_t before = text.size();
    text.resize(before + kBlock);
    got = std::fread(text.data() + before, 1, kBlock, file.get());
    text.resize(before + got);
  }
  if (std::ferror(file.get()) != 0) {
    return tl::unexpected(fmt::format("cannot be read: {}", reason()));
  }
  if (text.size() > kLargestFile) {
    return tl::unexpected(fmt::format("is larger than {} MB: not a {}", kLargestFile >> 20, what));
  }
  return text;
}

std::string beside(const std::string& profile, const std::string& file) {
  return (std::filesystem::path(profile).parent_path() / file).string();
}

}  // namespace higherpair::io_detail
