#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/profile.hpp"
#include "higherpair/io/units.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// The parsed text of a profile with the overrides so far, not yet checked for its meaning. A value, cheap to
/// copy. Errors are those of read_profile_text.
class ProfileDocument {
public:
  /// \param source_name  name of the text in messages
  [[nodiscard]] static tl::expected<ProfileDocument, Diagnostics> parse(std::string_view text,
                                                                        const std::string& source_name);
  [[nodiscard]] static tl::expected<ProfileDocument, Diagnostics> open(const std::string& path);

  /// The document with these overrides "PATH=VALUE" applied, one after the other.
  [[nodiscard]] tl::expected<ProfileDocument, Diagnostics> with(std::span<const std::string> overrides) const;

  /// The profile that the document describes.
  [[nodiscard]] tl::expected<Profile, Diagnostics> read() const;

  /// Calls `found` with path and value, as written, of every number in the order of the file.
  void for_each_number(const std::function<void(const std::string& path, double value)>& found) const;

  /// A physical quantity in the profile, with or without a unit of its own; counts, flags and names are none.
  struct Quantity {
    std::string path;
    Dimension dimension;
    double value = 0;  ///< in the profile's unit
  };
  /// All of them, each once, in the order in which a profile is read. \pre read() succeeds
  [[nodiscard]] std::vector<Quantity> quantities() const;

  /// A value that replaces one in the text of a profile.
  struct NewValue {
    std::string path;  ///< as in overrides; of a number in the text, or `bodies.NAME.pose`
    std::string text;  ///< as TOML writes it
  };

  /// The parsed text with all overrides and then these values written into it; everything else stays the same
  /// byte for byte, comments and spaces too. An override that adds a key is written below the heading of its
  /// table, and so is a pose that is missing; where an override has no such place, the table at the top of
  /// its path is written anew at the end of the text, without its comments. The error names a path whose
  /// value cannot be found, or an override that cannot be written.
  [[nodiscard]] tl::expected<std::string, std::string> text_with(std::span<const NewValue> values) const;

private:
  friend class ProfileVariants;
  struct Content;
  [[nodiscard]] tl::expected<Profile, Diagnostics> read(bool with_notes) const;
  explicit ProfileDocument(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

  std::shared_ptr<const Content> content_;
};

}  // namespace higherpair
