#include "signals.hpp"

#include "outcome.hpp"

#include <csignal>
#include <ctime>
#include <unistd.h>

namespace higherpair::cli {
namespace {

// A signal handler may only touch lock-free atomics, and call few functions.
std::atomic<bool> signalled = false;
std::atomic<std::time_t> first_signal = 0;  // [s]
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<std::time_t>::is_always_lock_free);

void end_at_once(int) {
  _exit(kExitInterrupted);
}

// The second signal ends the program, in case no loop heeds the first one. Not within a second or two:
// timeout(1) sends the same signal twice.
void on_interrupt(int number) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  signalled = true;
  std::time_t first = 0;
  if (!first_signal.compare_exchange_strong(first, now.tv_sec) && now.tv_sec > first + 1) {
    end_at_once(number);
  }
}

void on_signals(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    sigaction(number, &action, nullptr);
  }
}

}  // namespace

void end_on_signals() {
  on_signals(end_at_once);
  std::signal(SIGPIPE, SIG_IGN);
}

// A write that waits for a reader is not restarted after a signal but fails.
void listen_to_signals() {
  on_signals(on_interrupt);
}

const std::atomic<bool>& interruption() {
  return signalled;
}

}  // namespace higherpair::cli
