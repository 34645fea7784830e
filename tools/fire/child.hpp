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

/// Does the work in a process of its own, so that neither a crash nor a loop without end stops the trial;
/// ended after so many seconds.
[[nodiscard]] ChildResult in_child(const std::function<std::string()>& work, unsigned seconds);

}  // namespace higherpair::fire
