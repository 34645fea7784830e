#pragma once

#include "higherpair/io/profile_document.hpp"

#include <memory>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace higherpair {

/// One profile read again and again with other numbers: no text is taken apart, no path is looked for twice,
/// and nothing is noted that may be a slip. One thread at a time; a profile that is read is the caller's.
class ProfileVariants {
public:
  /// What is asked of variants ([sweep], [design], [tolerances]) is not part of them.
  /// \param paths  of numbers of the document; fails for one that leads to none
  [[nodiscard]] static tl::expected<ProfileVariants, Diagnostics> of(const ProfileDocument& document,
                                                                     std::span<const std::string> paths);
  ProfileVariants(ProfileVariants&& other) noexcept;
  ProfileVariants& operator=(ProfileVariants&& other) noexcept;
  ~ProfileVariants();

  /// The profile with these numbers at the paths, in their order. Mistakes are reported where the paths lead.
  [[nodiscard]] tl::expected<Profile, Diagnostics> read(std::span<const double> values);

private:
  struct Impl;
  explicit ProfileVariants(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace higherpair
