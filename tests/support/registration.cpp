#include "support/registration.hpp"

namespace test_support {
namespace {

class CallingTest final : public ::testing::Test {
public:
  explicit CallingTest(void (*body)()) : body_(body) {}

private:
  void TestBody() override { body_(); }

  void (*body_)();
};

}  // namespace

bool register_test(const char* suite, const char* name, const char* file, int line, void (*body)()) {
  ::testing::RegisterTest(suite, name, nullptr, nullptr, file, line,
                          [body]() -> ::testing::Test* { return new CallingTest(body); });
  return true;
}

}  // namespace test_support
