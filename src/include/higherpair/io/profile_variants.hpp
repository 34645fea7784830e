#pragma once

#include "higherpair/io/profile_document.hpp"

#include <memory>
#include <span>
#include <string>

#include <tl/expected.hpp>

namespace higherpair {

/// Reads one profile many times with different numbers: the text is not parsed again, paths are looked up
/// only once, and the profiles have no notes. One thread at a time may use it; the caller owns the profiles.
class ProfileVariants {
public:
  /// The variants have only those of the tasks [sweep], [design] and [tolerances] that a path leads into.
  /// \param paths  of numbers of the document; fails for one that leads to no number
  /// \pre document.read() succeeds
  [[nodiscard]] static tl::expected<ProfileVariants, Diagnostics> of(const ProfileDocument& document,
                                                                     std::span<const std::string> paths);
  ProfileVariants(ProfileVariants&& other) noexcept;
  ProfileVariants& operator=(ProfileVariants&& other) noexcept;
  ~ProfileVariants();

  /// The profile with these numbers at the paths, in their order. Mistakes are reported at the places to
  /// which the paths lead.
  [[nodiscard]] tl::expected<Profile, Diagnostics> read(std::span<const double> values);

private:
  struct Impl;
  explicit ProfileVariants(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace higherpair
