#include "higherpair/io/profile_document.hpp"

#include "document_content.hpp"
#include "names.hpp"
#include "text_file.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>

namespace higherpair {
namespace {

using io_detail::Array;
using io_detail::Entry;
using io_detail::Table;
using io_detail::Value;

void visit_numbers(const Value& value, const std::string& path,
                   const std::function<void(const std::string&, double)>& found) {
  const std::string prefix = path.empty() ? "" : path + ".";
  if (const auto* table = std::get_if<Table>(&value.content)) {
    for (const Entry& entry : *table) {
      visit_numbers(entry.value, prefix + entry.key, found);
    }
  } else if (const auto* items = std::get_if<Array>(&value.content)) {
    for (std::size_t i = 0; i < items->size(); ++i) {
      visit_numbers((*items)[i], fmt::format("{}{}", prefix, i), found);
    }
  } else if (const auto* number = std::get_if<double>(&value.content)) {
    found(path, *number);
  } else if (const auto* integer = std::get_if<std::int64_t>(&value.content)) {
    found(path, static_cast<double>(*integer));
  }
}

}  // namespace

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
      std::make_shared<const Content>(Content{*std::move(root), std::string(text), {}, {source_name}}));
}

tl::expected<ProfileDocument, Diagnostics> ProfileDocument::with(
    std::span<const std::string> overrides) const {
  if (overrides.empty()) {
    return *this;
  }
  Content content = *content_;
  for (const std::string& assignment : overrides) {
    content.overrides.push_back(assignment);
    content.sources.push_back("--set " + io_detail::visible(assignment));
    auto changed = io_detail::apply_override(std::move(content.root), assignment,
                                             static_cast<int>(content.sources.size()) - 1);
    if (!changed) {
      return tl::unexpected(Diagnostics{about(content.sources.back(), changed.error())});
    }
    content.root = *std::move(changed);
  }
  return ProfileDocument(std::make_shared<const Content>(std::move(content)));
}

const std::vector<std::string>& ProfileDocument::overrides() const {
  return content_->overrides;
}

void ProfileDocument::for_each_number(
    const std::function<void(const std::string& path, double value)>& found) const {
  visit_numbers(content_->root, "", found);
}

}  // namespace higherpair
