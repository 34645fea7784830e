#include "higherpair/io/profile_document.hpp"

#include "document_content.hpp"
#include "higherpair/io/names.hpp"
#include "text_file.hpp"

#include <memory>
#include <utility>

namespace higherpair {
using io_detail::Table;

tl::expected<ProfileDocument, Diagnostics> ProfileDocument::open(const std::string& path) {
  auto text = io_detail::read_text_file(path, "profile");
  if (!text) {
    return tl::unexpected(Diagnostics{about(path, text.error())});
  }
  return parse(*text, path);
}

tl::expected<ProfileDocument, Diagnostics> ProfileDocument::parse(std::string_view text,
                                                                  const std::string& source_name) {
  auto root = io_detail::parse_document(text, source_name);
  if (!root) {
    return tl::unexpected(Diagnostics{root.error()});
  }
  return ProfileDocument(
      std::make_shared<const Content>(Content{*std::move(root), std::string(text), {}, {source_name}, {}}));
}

tl::expected<ProfileDocument, Diagnostics> ProfileDocument::with(
    std::span<const std::string> overrides) const {
  if (overrides.empty()) {
    return *this;
  }
  Content content = *content_;
  for (const std::string& assignment : overrides) {
    content.overrides.push_back(assignment);
    content.sources.push_back("override " + io_detail::visible(assignment));
    auto changed = io_detail::apply_override(std::move(content.root), assignment,
                                             static_cast<int>(content.sources.size()) - 1);
    if (!changed) {
      return tl::unexpected(Diagnostics{about(content.sources.back(), changed.error())});
    }
    content.root = std::move(changed->document);
    content.doubts.push_back(std::move(changed->doubt));
  }
  return ProfileDocument(std::make_shared<const Content>(std::move(content)));
}

void ProfileDocument::for_each_number(
    const std::function<void(const std::string& path, double value)>& found) const {
  io_detail::for_each_number(std::get<Table>(content_->root.content), found);
}

}  // namespace higherpair
