#include "higherpair/io/profile_reader.hpp"

#include "document.hpp"
#include "names.hpp"
#include "reading.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace higherpair {
namespace {

using io_detail::Reading;
using io_detail::Table;
using io_detail::TableReader;
using io_detail::Value;

constexpr std::size_t kLargestFile = std::size_t{1} << 28;  // 256 MB; an endless device is no profile

tl::expected<std::string, std::string> read_text(const std::string& path) {
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
    return tl::unexpected(fmt::format("is larger than {} MB: not a profile", kLargestFile >> 20));
  }
  return text;
}

// False for a version that cannot be understood: then nothing else is worth a message.
bool read_format(TableReader& root) {
  const auto item = root.take("format");
  const auto format = item ? io_detail::as_integer(root.reading(), *item) : std::nullopt;
  if (!format) {
    return true;
  }
  if (*format > kProfileFormat) {
    report(root.reading(), *item,
           fmt::format("this profile needs a newer higherpair; this one reads format {}", kProfileFormat));
    return false;
  }
  if (*format < 1) {
    report(root.reading(), *item, fmt::format("expected format {}", kProfileFormat));
  }
  return true;
}

Profile read_root(TableReader& root) {
  Profile profile;
  if (!read_format(root)) {
    return profile;
  }
  Mechanism& mechanism = profile.mechanism;
  read_units(root);
  profile.units = root.reading().units;
  mechanism.title = root.text("title");
  mechanism.description = root.text("description");
  if (const auto gravity = root.take("gravity")) {
    mechanism.gravity_W =
        io_detail::as_vector(root.reading(), *gravity, dimension::kAcceleration).value_or(Vector2d::Zero());
  }
  read_bodies(root, mechanism);
  const std::vector<bool> joint_type_known = read_joints(root, mechanism);
  read_contacts(root, mechanism);
  read_drivers(root, profile, joint_type_known);
  read_loads(root, mechanism);
  read_springs(root, mechanism, joint_type_known);
  (void)root.take("extra");
  root.finish();
  return profile;
}

Diagnostics diagnostics_of(Reading reading) {
  std::stable_sort(reading.mistakes.begin(), reading.mistakes.end(),
                   [](const io_detail::Mistake& a, const io_detail::Mistake& b) { return a.mark < b.mark; });
  Diagnostics diagnostics;
  for (const io_detail::Mistake& mistake : reading.mistakes) {
    diagnostics.push_back({place_of(reading, mistake.mark), io_detail::visible(mistake.message)});
  }
  return diagnostics;
}

}  // namespace

tl::expected<Profile, Diagnostics> read_profile_text(std::string_view text, const std::string& source_name,
                                                     std::span<const std::string> overrides) {
  auto document = io_detail::parse_document(text, source_name);
  if (!document) {
    return tl::unexpected(Diagnostics{document.error()});
  }
  Reading reading;
  reading.sources = {source_name};
  for (const std::string& assignment : overrides) {
    reading.sources.push_back("--set " + io_detail::visible(assignment));
    auto changed =
        apply_override(std::move(*document), assignment, static_cast<int>(reading.sources.size()) - 1);
    if (!changed) {
      return tl::unexpected(Diagnostics{about(reading.sources.back(), changed.error())});
    }
    *document = std::move(*changed);
  }
  TableReader root(reading, std::get<Table>(document->content), document->mark, "");
  Profile profile = read_root(root);
  if (!reading.mistakes.empty()) {
    return tl::unexpected(diagnostics_of(std::move(reading)));
  }
  return profile;
}

tl::expected<Profile, Diagnostics> read_profile_file(const std::string& path,
                                                     std::span<const std::string> overrides) {
  const auto text = read_text(path);
  if (!text) {
    return tl::unexpected(Diagnostics{about(path, text.error())});
  }
  return read_profile_text(*text, path, overrides);
}

}  // namespace higherpair
