#pragma once

#include "cli/program_testing.hpp"

#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <thread>

#include <fmt/core.h>

// Runs the program and sends it a signal, as a user does at a terminal.

namespace higherpair::testing {

/// Whether a process handles HUP, INT and TERM, by the mask that Linux shows of it in /proc. Between its
/// start and that moment each of them ends it with a code that is not its own.
inline bool handles_signals(pid_t process) {
  std::ifstream status(fmt::format("/proc/{}/status", process));
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("SigCgt:", 0) == 0) {
      const auto handled = std::stoull(line.substr(7), nullptr, 16);
      const auto bit = [](int number) { return 1ULL << (number - 1); };
      return (handled & bit(SIGHUP)) != 0 && (handled & bit(SIGINT)) != 0 && (handled & bit(SIGTERM)) != 0;
    }
  }
  return false;
}

/// Whether the condition holds within so many seconds.
template <class Condition>
bool holds_within(double seconds, const Condition& condition) {
  using Clock = std::chrono::steady_clock;
  for (const auto end = Clock::now() + std::chrono::duration<double>(seconds); Clock::now() < end;) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

/// What the program does in this folder when it gets a signal some seconds after it began to handle signals.
/// Code -1: it has not ended 20 seconds later, or another signal has ended it.
inline Outcome interrupted(const std::filesystem::path& folder, int signal, double seconds,
                           const std::string& arguments) {
  const std::string command =
      fmt::format("cd '{}' && exec {} {} >out 2>err", folder.string(), HIGHERPAIR_PROGRAM, arguments);
  const pid_t program = fork();
  if (program == 0) {
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  int status = 0;
  const auto ended = [&] { return waitpid(program, &status, WNOHANG) == program; };
  bool over = false;
  holds_within(60, [&] { return (over = ended()) || handles_signals(program); });
  if (!over) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    kill(program, signal);
    if (!holds_within(20, ended)) {
      kill(program, SIGKILL);
      waitpid(program, &status, 0);
    }
  }
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder / "out"), read_file(folder / "err")};
}

/// A named pipe whose one reader reads nothing.
class UnreadPipe {
public:
  explicit UnreadPipe(const std::filesystem::path& path) {
    EXPECT_EQ(mkfifo(path.c_str(), 0600), 0);
    pipe_ = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    EXPECT_GE(pipe_, 0);
  }
  ~UnreadPipe() { close(pipe_); }
  UnreadPipe(const UnreadPipe&) = delete;
  UnreadPipe& operator=(const UnreadPipe&) = delete;

  /// Leaves no room in it for a single character.
  void fill() const {
    while (write(pipe_, "x", 1) == 1) {
    }
  }

private:
  int pipe_ = -1;
};

}  // namespace higherpair::testing
