#include "program.hpp"
#include "run_command.hpp"

#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include <fmt/format.h>

namespace {

// What was printed may still be on its way.
int flushed(int code) {
  std::cout.flush();
  const bool good = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (good || code != higherpair::cli::kExitOk) {
    return code;
  }
  fmt::print(stderr, "higherpair: cannot write to standard output\n");
  return higherpair::cli::kExitMachine;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return flushed(higherpair::cli::run_program(argc, argv));
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "higherpair: out of memory\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "higherpair: {}\n", error.what());
  }
  return higherpair::cli::kExitMachine;
}
