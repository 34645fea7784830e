#include "higherpair/io/suggestion.hpp"
#include "reading.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace higherpair::io_detail {
namespace {

bool is_colour(std::string_view text) {
  return (text.size() == 4 || text.size() == 7) && text.front() == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

enum class Kind { kBody, kPoint, kCurve };

Look read_look(TableReader& table, Kind kind) {
  Look look;
  if (kind == Kind::kCurve) {
    table.refuse("name", "curves bear no name in pictures");
  } else {
    look.name = table.text("name");
  }
  if (const auto item = table.take("colour")) {
    const auto colour = as_text(table.reading(), *item);
    if (colour && !is_colour(*colour)) {
      report(table.reading(), *item, "expected a colour as \"#rrggbb\", such as \"#0072b2\"");
    }
    look.colour = colour.value_or("");
  }
  look.hide = table.flag("hide", false);
  if (kind == Kind::kPoint) {
    table.refuse("outline", "a point has none");
  } else {
    look.outline = table.flag("outline", false);
  }
  return look;
}

// The place of a name among those of `things`; reports that there is none.
template <class Things>
std::optional<std::size_t> find(TableReader& table, const std::string& name, const Things& things,
                                std::string_view what) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(thing.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  table.reading().mistakes.push_back({table.mark(), fmt::format("{}: there is no {} `{}`; {}", table.path(),
                                                                what, name, suggestion(name, names))});
  return std::nullopt;
}

template <class Things>
std::vector<Look> read_parts(TableReader& table, const std::string& key, const Things& things, Kind kind,
                             const std::string& what) {
  std::vector<Look> looks(things.size());
  if (const auto item = table.take(key)) {
    for_each_table(table.reading(), *item, "what it looks like (a table)",
                   [&](const std::string& name, TableReader& part) {
                     if (const auto index = find(part, name, things, what)) {
                       looks[*index] = read_look(part, kind);
                       part.finish();
                     }
                   });
  }
  return looks;
}

}  // namespace

void read_drawing(TableReader& root, Profile& profile) {
  const auto drawing = root.take("drawing");
  if (!drawing) {
    return;
  }
  const std::vector<Body>& bodies = profile.mechanism.bodies;
  for (const Body& body : bodies) {
    profile.looks.push_back(
        {{}, std::vector<Look>(body.points.size()), std::vector<Look>(body.curves.size())});
  }
  for_each_table(
      root.reading(), *drawing, "what a body looks like (a table)",
      [&](const std::string& name, TableReader& table) {
        const auto index = find(table, name, bodies, "body");
        if (!index) return;
        BodyLook& look = profile.looks[*index];
        look.body = read_look(table, Kind::kBody);
        const std::string of = " of `" + name + "`";
        look.points = read_parts(table, "points", bodies[*index].points, Kind::kPoint, "point" + of);
        look.curves = read_parts(table, "curves", bodies[*index].curves, Kind::kCurve, "curve" + of);
        table.finish();
      });
}

}  // namespace higherpair::io_detail
