#pragma once

#include <string_view>

namespace higherpair {

/// The report page without its data, with the mark @REPORT_DATA@ in their place; empty where the build could
/// not make it.
[[nodiscard]] std::string_view report_page();

/// Why there is no report page.
[[nodiscard]] std::string_view report_page_missing();

}  // namespace higherpair
