#include "reading.hpp"

#include <string_view>

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

template <class Things>
std::vector<Look> read_parts(TableReader& table, const std::string& key, const Things& things, Kind kind,
                             const std::string& none, const std::string& home) {
  std::vector<Look> looks(things.size());
  for_each_table(table.reading(), table.take(key), "what it looks like (a table)",
                 [&](const std::string& name, TableReader& part) {
                   if (const auto index = named_thing(part, name, none, things, home)) {
                     looks[*index] = read_look(part, kind);
                     part.finish();
                   }
                 });
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
  for_each_table(root.reading(), *drawing, "what a body looks like (a table)",
                 [&](const std::string& name, TableReader& table) {
                   const auto index = named_thing(table, name, "there is no body", bodies, "bodies");
                   if (!index) return;
                   BodyLook& look = profile.looks[*index];
                   look.body = read_look(table, Kind::kBody);
                   const std::string home = "bodies." + name;
                   look.points = read_parts(table, "points", bodies[*index].points, Kind::kPoint,
                                            has_no(name, "point"), home + ".points");
                   look.curves = read_parts(table, "curves", bodies[*index].curves, Kind::kCurve,
                                            has_no(name, "curve"), home + ".curves");
                   table.finish();
                 });
}

}  // namespace higherpair::io_detail
