#pragma once

#include <gtest/gtest.h>

// TEST, cheaper to compile than GoogleTest's. That one generates a factory class and six functions for each
// test, a twentieth of the time of building all tests. This header is only precompiled, and TEST means the
// same without it.

namespace test_support {

/// Registers a test that calls `body`. Returns true, to initialise a variable with.
bool register_test(const char* suite, const char* name, const char* file, int line, void (*body)());

}  // namespace test_support

#undef TEST
#define TEST(suite, name)                                                                            \
  struct suite##_##name##_Test : ::testing::Test {                                                   \
    static void body();                                                                              \
  };                                                                                                 \
  [[maybe_unused]] static const bool suite##_##name##_is_registered =                                \
      ::test_support::register_test(#suite, #name, __FILE__, __LINE__, suite##_##name##_Test::body); \
  void suite##_##name##_Test::body()
