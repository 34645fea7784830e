#include "higherpair/io/diagnostic.hpp"

#include <utility>

#include <fmt/core.h>

namespace higherpair {

Diagnostic about(std::string source, std::string message) {
  Diagnostic diagnostic;
  diagnostic.place.source = std::move(source);
  diagnostic.message = std::move(message);
  return diagnostic;
}

std::string to_string(const Diagnostic& diagnostic) {
  const Place& place = diagnostic.place;
  if (place.line == 0) {
    return fmt::format("{}: {}", place.source, diagnostic.message);
  }
  return fmt::format("{}:{}:{}: {}", place.source, place.line, place.column, diagnostic.message);
}

std::string to_string(const Error& error) {
  std::string text;
  for (const Diagnostic& diagnostic : error.diagnostics) {
    text += text.empty() ? "" : "\n";
    text += to_string(diagnostic);
  }
  return text;
}

std::string note_text(const Diagnostic& note) {
  return to_string({note.place, "note: " + note.message});
}

}  // namespace higherpair
