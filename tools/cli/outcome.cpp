#include "outcome.hpp"

#include "signals.hpp"
#include "tell.hpp"

#include <string>
#include <string_view>

namespace higherpair::cli {
namespace {

// What the library calls the setting `columns`, or an override, is an option here: "setting columns driver"
// is `--columns driver`, "override driver.end=3" is `--set driver.end=3`.
std::string in_options(const std::string& source) {
  constexpr std::string_view kSetting = "setting ";
  constexpr std::string_view kOverride = "override ";
  return source.starts_with(kSetting)    ? "--" + source.substr(kSetting.size())
         : source.starts_with(kOverride) ? "--set " + source.substr(kOverride.size())
                                         : source;
}

}  // namespace

int exit_unwritten() {
  return interruption() ? kExitInterrupted : kExitMachine;
}

int report_error(const Error& error) {
  Error said = error;
  for (Diagnostic& diagnostic : said.diagnostics) {
    diagnostic.place.source = in_options(diagnostic.place.source);
  }
  tell("{}\n", to_string(said));
  switch (error.kind) {
    case ErrorKind::kInput:
      return kExitInput;
    case ErrorKind::kMechanism:
      return kExitMechanism;
    case ErrorKind::kInternal:
      break;
  }
  return kExitMachine;
}

int exit_failed(const Error& error) {
  return interruption() ? kExitInterrupted : report_error(error);
}

void print_notes(const Diagnostics& notes, bool quiet) {
  if (quiet) return;
  for (Diagnostic note : notes) {
    note.place.source = in_options(note.place.source);
    tell("{}\n", note_text(note));
  }
}

}  // namespace higherpair::cli
