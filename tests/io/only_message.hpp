#pragma once

#include "io/profile_testing.hpp"

#include <string>

#include <gtest/gtest.h>

namespace higherpair::testing {

/// The single message about `text`; the test fails if there are more, or none.
inline std::string only_message(const std::string& text, const Overrides& overrides = {}) {
  const auto all = messages(text, overrides);
  EXPECT_EQ(all.size(), 1U) << ::testing::PrintToString(all);
  return all.empty() ? "" : all.front();
}

}  // namespace higherpair::testing
