#pragma once

#include <string_view>

namespace higherpair {

/// The page of reports without its data, with the mark @REPORT_DATA@ where these belong; empty where the
/// build could not make it.
[[nodiscard]] std::string_view report_page();

/// Why there is none.
[[nodiscard]] std::string_view report_page_missing();

}  // namespace higherpair
