#pragma once

#include <functional>
#include <string>

namespace higherpair::fire {

/// How a piece of work in a process of its own ended.
struct ChildResult {
  enum class End { kAnswered, kCrashed, kLate };
  End end = End::kCrashed;
  std::string answer;
};

/// Does the work in a child process, so that neither a crash nor an infinite loop stops the trial. It is
/// ended after `seconds` of processor time.
[[nodiscard]] ChildResult in_child(const std::function<std::string()>& work, unsigned seconds);

}  // namespace higherpair::fire
