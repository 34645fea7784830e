#include "child.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace higherpair::fire {
namespace {

[[noreturn]] void answer(const std::function<std::string()>& work, int to) {
  int code = 1;
  try {
    const std::string text = work();
    code = write(to, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1;
  } catch (...) {
    code = 1;
  }
  _exit(code);  // no destructors: they belong to the parent
}

std::string read_all(int from) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(from, buffer.data(), buffer.size());
    if (count <= 0) {
      return text;
    }
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace

ChildResult in_child(const std::function<std::string()>& work, unsigned seconds) {
  std::array<int, 2> ends{};
  std::fflush(stdout);
  if (pipe(ends.data()) != 0) {
    return {};
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    // Limits processor time, which does not depend on how busy the machine is. The kernel sends SIGXCPU.
    const rlimit limit{seconds, seconds + 1};
    setrlimit(RLIMIT_CPU, &limit);
    answer(work, ends[1]);
  }
  close(ends[1]);
  ChildResult result;
  result.answer = child > 0 ? read_all(ends[0]) : "";
  close(ends[0]);
  int status = 0;
  if (child <= 0 || waitpid(child, &status, 0) != child) {
    return result;
  }
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL)) {
    result.end = ChildResult::End::kLate;
  } else if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
    result.end = ChildResult::End::kAnswered;
  }
  return result;
}

}  // namespace higherpair::fire
