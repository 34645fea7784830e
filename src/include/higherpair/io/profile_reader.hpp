#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/profile.hpp"

#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace higherpair {

/// The newest version of the profile format (key `format`) that this library reads.
inline constexpr int kProfileFormat = 1;

/// Reads a profile: TOML text that describes one mechanism.
/// \param text        UTF-8, with or without byte order mark, lines ended by LF or CR LF.
/// \param source_name its name in diagnostics.
/// \param overrides   "PATH=VALUE" each: sets or adds the key at the dotted path (items of arrays by number,
///                    from 0) before anything is checked; VALUE is TOML, or else a string. They apply in
///                    their order, and diagnostics about what they set name `--set PATH=VALUE` as the place.
/// Bodies, points, curves, joints, contacts, drivers, loads and springs keep the order of the file; bodies[0]
/// is always ground. All semantic mistakes are reported at once, but only the first syntax error.
[[nodiscard]] tl::expected<Profile, Diagnostics> read_profile_text(
    std::string_view text, const std::string& source_name, std::span<const std::string> overrides = {});

/// The same for a file; one that cannot be read gives a diagnostic with the reason of the operating system.
[[nodiscard]] tl::expected<Profile, Diagnostics> read_profile_file(
    const std::string& path, std::span<const std::string> overrides = {});

}  // namespace higherpair
