#include "outcome.hpp"
#include "program.hpp"
#include "tell.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include <fmt/core.h>

namespace {

// Reports a failed write to standard output, unless its reader has closed the pipe.
void say_unwritten(int reason) {
  if (reason != EPIPE) {
    const std::string why = reason == 0 ? "" : fmt::format(": {}", std::strerror(reason));
    higherpair::cli::tell("higherpair: cannot write to standard output{}\n", why);
  }
}

// Flushes standard output; the reason of an earlier failure is still in errno.
int flushed(int code) {
  using namespace higherpair::cli;
  std::cout.flush();
  const bool good = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (good || code == kExitMachine || code == kExitInterrupted) {
    return code;
  }
  say_unwritten(errno);
  return kExitMachine;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return flushed(higherpair::cli::run_program(argc, argv));
  } catch (const std::bad_alloc&) {
    higherpair::cli::tell("higherpair: out of memory\n");
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) {
      say_unwritten(error.code().value());
    } else {
      higherpair::cli::tell("higherpair: {}\n", error.what());
    }
  } catch (const std::exception& error) {
    higherpair::cli::tell("higherpair: {}\n", error.what());
  }
  return higherpair::cli::kExitMachine;
}
