#include "house/include_rules.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <sstream>

namespace higherpair::house {
namespace fs = std::filesystem;

namespace {

// The room whose private headers every room may include.
constexpr const char* kShared = "numeric";

// The rooms (folders) of the library, each with the rooms below it, whose headers it may include.
const std::map<std::string, std::vector<std::string>>& rooms() {
  static const std::map<std::string, std::vector<std::string>> table = {
      {"numeric", {}},
      {"geometry", {"numeric"}},
      {"cam", {"numeric", "geometry"}},
      {"linkage", {"numeric", "geometry", "cam"}},
      {"contact", {"numeric", "geometry", "cam", "linkage"}},
      {"mechanism", {"numeric", "geometry", "cam", "linkage", "contact"}},
      {"analysis", {"numeric", "geometry", "cam", "linkage", "contact", "mechanism"}},
      {"dynamics", {"numeric", "geometry", "cam", "linkage", "contact", "mechanism", "analysis"}},
      {"drawing", {"numeric", "geometry", "cam", "linkage", "contact", "mechanism", "analysis", "dynamics"}},
      {"design", {"numeric", "geometry", "cam", "linkage", "contact", "mechanism", "analysis"}},
      {"sweep", {"numeric", "geometry", "cam", "linkage", "contact", "mechanism", "analysis"}},
      {"io",
       {"numeric", "geometry", "cam", "linkage", "contact", "mechanism", "analysis", "dynamics", "drawing",
        "design", "sweep"}},
      {"front",
       {"numeric", "geometry", "cam", "linkage", "contact", "mechanism", "analysis", "dynamics", "drawing",
        "design", "sweep", "io"}},
  };
  return table;
}

// Libraries that only the listed rooms may include; an empty list: only the tools.
const std::map<std::string, std::vector<std::string>>& owned_libraries() {
  static const std::map<std::string, std::vector<std::string>> table = {
      {"CGAL", {"contact"}},        {"CLI", {}},        {"nlohmann", {"front"}}, {"nlopt.h", {"design"}},
      {"nlopt.hpp", {"design"}},    {"toml++", {"io"}}, {"toml.hpp", {"io"}},    {"Random123", {"sweep"}},
      {"tbb", {"numeric", "front"}}};
  return table;
}

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::vector<std::string> parts(const fs::path& path) {
  std::vector<std::string> names;
  for (const fs::path& part : path) {
    names.push_back(part.string());
  }
  return names;
}

// In include/, which is installed, or in src/include, which all rooms share.
bool is_public(const fs::path& file) {
  const std::vector<std::string> names = parts(file);
  return !names.empty() && (names[0] == "include" || (names.size() > 1 && names[1] == "include"));
}

// The room of a file of the library, "" if it is in none; nullopt for a file outside the library.
std::optional<std::string> room_of(const fs::path& file) {
  const std::vector<std::string> names = parts(file);
  const std::size_t at = !is_public(file) ? 1 : names[0] == "include" ? 2 : 3;
  if (names.size() < 2 || (names[0] != "include" && names[0] != "src")) {
    return std::nullopt;
  }
  return names.size() > at + 1 ? names[at] : "";
}

struct Include {
  int line = 0;
  bool quoted = false;
  std::string header;
};

std::vector<Include> includes_of(std::string_view text) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> found;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_match(line, match, pattern)) {
      found.push_back({number, match[1] == "\"", match[2]});
    }
  }
  return found;
}

// The path in the tree of a header of the project; nullopt for any other header.
std::optional<fs::path> own_header(const fs::path& file, const Include& include) {
  const fs::path header = include.header;
  if (*header.begin() == "higherpair") {
    return ("include" / header).lexically_normal();
  }
  if (!include.quoted) {
    return std::nullopt;
  }
  if (rooms().contains(header.begin()->string())) {
    return ("src" / header).lexically_normal();
  }
  return (file.parent_path() / header).lexically_normal();
}

std::string own_header_violation(const fs::path& file, const std::string& room, const fs::path& header) {
  const std::optional<std::string> other = room_of(header);
  if (!other) {
    return "the library does not include what is outside of it";
  }
  if (!rooms().contains(*other)) {
    return "the header stands in no room that we know";
  }
  if (is_public(file) && !is_public(header)) {
    return "a public header includes a private one";
  }
  if (*other != room && !contains(rooms().at(room), *other)) {
    return room + " may not use " + *other;
  }
  if (*other != room && !is_public(header) && *other != kShared) {
    return "this header is private to " + *other;
  }
  return "";
}

std::string foreign_header_violation(const fs::path& file, const std::string& room, const fs::path& header) {
  const std::string library = header.begin()->string();
  const bool standard = !header.has_parent_path() && !header.has_extension();
  if (is_public(file) && !standard && library != "Eigen" && library != "tl" && library != "experimental") {
    return "a public header includes only the standard library, Eigen and tl::expected";
  }
  const auto owner = owned_libraries().find(library);
  if (owner != owned_libraries().end() && !contains(owner->second, room)) {
    return owner->second.empty() ? "this library is for tools"
                                 : "this library belongs to " + owner->second.front();
  }
  return "";
}

}  // namespace

std::vector<std::string> include_violations(const fs::path& file, std::string_view text) {
  const std::optional<std::string> room = room_of(file);
  if (!room) {
    return {};
  }
  if (file == "include/higherpair/higherpair.hpp") {
    return {};  // the umbrella header itself, which only collects headers
  }
  if (!rooms().contains(*room)) {
    return {file.generic_string() + ": the file stands in no room that we know"};
  }
  std::vector<std::string> violations;
  for (const Include& include : includes_of(text)) {
    const std::optional<fs::path> own = own_header(file, include);
    const std::string what =
        own ? own_header_violation(file, *room, *own) : foreign_header_violation(file, *room, include.header);
    if (!what.empty()) {
      violations.push_back(file.generic_string() + ":" + std::to_string(include.line) + ": " +
                           include.header + ": " + what);
    }
  }
  return violations;
}

}  // namespace higherpair::house
