#include "higherpair/io/profile_variants.hpp"

#include "document_content.hpp"
#include "higherpair/numeric/contains.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace higherpair {

using io_detail::Entry;
using io_detail::Table;
using io_detail::Value;

namespace {

constexpr std::array<std::string_view, 4> kTasks = {"sweep", "design", "fit", "tolerances"};

// The values in a document that a number may replace: numbers, and texts that are quantities with a unit.
class Numbers {
public:
  explicit Numbers(const ProfileDocument& document) : document_(document) {}

  [[nodiscard]] bool has(const Value& value, const std::string& path) {
    if (!std::holds_alternative<std::string>(value.content)) {
      return io_detail::number_in(value).has_value();
    }
    if (!quantities_) quantities_ = document_.quantities();
    return std::any_of(quantities_->begin(), quantities_->end(),
                       [&](const ProfileDocument::Quantity& quantity) { return quantity.path == path; });
  }

private:
  const ProfileDocument& document_;
  std::optional<std::vector<ProfileDocument::Quantity>> quantities_;  // once they are asked for
};

}  // namespace

struct ProfileVariants::Impl {
  std::shared_ptr<ProfileDocument::Content> content;  // own copy, whose numbers are changed
  ProfileDocument document;                           // refers to `content`
  std::vector<Value*> numbers;                        // in `content`
};

ProfileVariants::ProfileVariants(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ProfileVariants::ProfileVariants(ProfileVariants&& other) noexcept = default;
ProfileVariants& ProfileVariants::operator=(ProfileVariants&& other) noexcept = default;
ProfileVariants::~ProfileVariants() = default;

tl::expected<ProfileVariants, Diagnostics> ProfileVariants::of(const ProfileDocument& document,
                                                               std::span<const std::string> paths) {
  auto content = std::make_shared<ProfileDocument::Content>(*document.content_);
  auto& table = std::get<Table>(content->root.content);
  // Tasks cost time to read; one that a path leads into must be there to be changed.
  std::erase_if(table, [&](const Entry& entry) {
    return contains(kTasks, entry.key) &&
           std::none_of(paths.begin(), paths.end(),
                        [&](const std::string& path) { return path.starts_with(entry.key + "."); });
  });
  Numbers possible(document);
  std::vector<Value*> numbers;
  for (const std::string& path : paths) {
    Value* value = io_detail::find_path(content->root, path);
    if (value == nullptr) {
      return tl::unexpected(Diagnostics{about(content->sources.front(), path + ": there is no such key")});
    }
    if (!possible.has(*value, path)) {
      return tl::unexpected(Diagnostics{about(
          content->sources.front(),
          fmt::format("{}: this is {}; expected the path of a number", path, io_detail::kind_of(*value)))});
    }
    numbers.push_back(value);
  }
  const ProfileDocument own(content);
  return ProfileVariants(std::make_unique<Impl>(Impl{std::move(content), own, std::move(numbers)}));
}

tl::expected<Profile, Diagnostics> ProfileVariants::read(std::span<const double> values) {
  assert(values.size() == impl_->numbers.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    impl_->numbers[i]->content = values[i];
  }
  return impl_->document.read(false);
}

}  // namespace higherpair
