#include "higherpair/io/profile_variants.hpp"

#include "document_content.hpp"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

namespace higherpair {

using io_detail::Entry;
using io_detail::Table;
using io_detail::Value;

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
  std::erase_if(table, [](const Entry& entry) {
    return entry.key == "sweep" || entry.key == "design" || entry.key == "tolerances";
  });
  std::vector<Value*> numbers;
  for (const std::string& path : paths) {
    Value* value = io_detail::find_path(content->root, path);
    if (value == nullptr) {
      return tl::unexpected(Diagnostics{about(content->sources.front(), path + ": there is no such key")});
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
