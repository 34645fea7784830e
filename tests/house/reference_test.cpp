// docs/profiles.md and docs/results.md are complete: they name every key that the reader accepts, and every
// column, status, event and JSON key of the output. The library and the program themselves list what there
// is.
#include "higherpair/contact/certify.hpp"
#include "higherpair/higherpair.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "house/tree.hpp"
#include "support/texts.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace higherpair::house {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using testing::contains;
using ::testing::IsSupersetOf;
using ::testing::SizeIs;

using Strings = std::vector<std::string>;

// The texts between single backticks on a page; for `a = 1` and `[a]` also the word a.
std::set<std::string> words_on(const std::string& page) {
  const std::string text = read_file(root() / page);
  const std::regex quoted("`([^`\n]+)`");
  const std::regex word("[\\w.]+");
  std::set<std::string> words;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), quoted); match != std::sregex_iterator();
       ++match) {
    const std::string inner = (*match)[1].str();
    words.insert(inner);
    for (auto part = std::sregex_iterator(inner.begin(), inner.end(), word); part != std::sregex_iterator();
         ++part) {
      words.insert(part->str());
    }
  }
  return words;
}

Strings split(const std::string& text, const std::string& separator) {
  Strings parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + separator.size()) {
    end = text.find(separator, begin);
    parts.push_back(text.substr(begin, end - begin));
  }
  return parts;
}

const char* const kProfile = R"([bodies.ground]
points.O = [0, 0]
[bodies.b]
points.O = [0, 0]
curves.c = { type = "circle", center = [0, 0], radius = 1 }
[joints.j]
type = "revolute"
between = ["ground.O", "b.O"]
[driver]
joint = "j"
)";

// The list that follows `words` in the reader's message about the profile with these changes.
Strings list_after(const std::string& words, const Strings& overrides) {
  const auto profile = read_profile_text(kProfile, "test.toml", overrides);
  if (profile) {
    return {};
  }
  for (const Diagnostic& diagnostic : profile.error()) {
    const std::size_t at = diagnostic.message.find(words);
    if (at != std::string::npos) {
      return split(diagnostic.message.substr(at + words.size()), ", ");
    }
  }
  return {};
}

// Resembles no key, so that the reader lists those that exist.
const std::string kNoKey = "qqqqqqqqqqqq";

Strings keys_of(const std::string& table, Strings overrides = {}) {
  overrides.push_back(table + kNoKey + "=1");
  return list_after("unknown key; there are ", overrides);
}

Strings types_of(const std::string& thing) {
  return list_after("expected one of ", {thing + ".type=" + kNoKey});
}

// Every key that the reader knows, table by table.
std::vector<Strings> all_keys() {
  std::vector<Strings> tables = {
      keys_of(""),
      keys_of("units."),
      keys_of("bodies.b."),
      keys_of("bodies.b.pose."),
      keys_of("contacts.k.", {R"(contacts.k.between=["b.c", "ground.e"])"}),
      keys_of("driver."),
      keys_of("loads.l.", {"loads.l.body=b", "loads.l.force=[1, 0]", "loads.l.point=O"}),
      keys_of("springs.s.", {"springs.s.joint=j"}),
      keys_of("springs.s.", {R"(springs.s.between=["b.O", "ground.O"])"})};
  const std::string objective = R"(design.objectives=[{ path = { point = "b.O" } }])";
  tables.push_back(keys_of("design."));
  tables.push_back(keys_of("design.variables.v.", {"design.variables.v.min=1"}));
  tables.push_back(keys_of("design.objectives.0.", {R"(design.objectives=[{ column = "b.x" }])"}));
  tables.push_back(keys_of("design.objectives.0.path.", {objective}));
  tables.push_back(keys_of("design.constraints.0.", {R"(design.constraints=[{ column = "b.x" }])"}));
  for (const std::string& type : types_of("bodies.b.curves.c")) {
    tables.push_back(keys_of("bodies.b.curves.c.", {"bodies.b.curves.c.type=" + type}));
  }
  for (const std::string& type : types_of("joints.j")) {
    tables.push_back(keys_of("joints.j.", {"joints.j.type=" + type}));
  }
  return tables;
}

TEST(ReferenceOfProfiles, NamesEveryKeyOfTheReader) {
  const std::set<std::string> words = words_on("docs/profiles.md");
  const std::vector<Strings> tables = all_keys();
  EXPECT_GE(tables.size(), 9U + 7U + 5U);
  for (const Strings& keys : tables) {
    EXPECT_GE(keys.size(), 2U) << ::testing::PrintToString(keys);
    for (const std::string& key : keys) {
      // The list of the top level is longer than what the reader prints of it.
      EXPECT_TRUE(key == "…" || words.contains(key)) << key;
    }
  }
  EXPECT_THAT(words, Contains("extra"));
}

TEST(ReferenceOfProfiles, NamesEveryTypeAndUnit) {
  const std::set<std::string> words = words_on("docs/profiles.md");
  EXPECT_THAT(types_of("bodies.b.curves.c"), SizeIs(::testing::Ge(7U)));
  EXPECT_THAT(types_of("joints.j"), SizeIs(::testing::Ge(5U)));
  for (const std::string thing : {"bodies.b.curves.c", "joints.j"}) {
    EXPECT_THAT(words, IsSupersetOf(types_of(thing)));
  }
  const std::string page = read_file(root() / "docs/profiles.md");
  for (const std::string unit : {"length", "angle", "mass", "time", "force"}) {
    const Strings names = list_after("expected one of ", {fmt::format("units.{}={}", unit, kNoKey)});
    ASSERT_GE(names.size(), 3U) << unit;
    std::string list = names.front();
    for (std::size_t i = 1; i < names.size(); ++i) {
      list += ", " + names[i];
    }
    EXPECT_TRUE(contains(page, "# " + list + "\n")) << unit;
  }
}

std::vector<Profile> shipped_profiles() {
  std::vector<Profile> profiles;
  for (const fs::path& file : project_files()) {
    if (file.parent_path() == "profiles" && file.extension() == ".toml") {
      profiles.push_back(read_profile_file((root() / file).string()).value());
    }
  }
  return profiles;
}

template <class Things>
bool has_name(const Things& things, const std::string& name) {
  return std::any_of(things.begin(), things.end(), [&](const auto& thing) { return thing.name == name; });
}

// The way in which the page writes a column: "B.P.vx" for "follower.E.vx". Names that several things share
// give several patterns.
Strings patterns_of(const Column& column, const Mechanism& mechanism) {
  const std::size_t dot = column.name.rfind('.');
  if (dot == std::string::npos || column.name.starts_with("driver.")) {
    return {dot == std::string::npos ? column.name : "driver" + column.name.substr(dot)};
  }
  const std::string owner = column.name.substr(0, dot);
  const std::string quantity = column.name.substr(dot);
  if (owner.find('.') != std::string::npos) {
    return {"B.P" + quantity};
  }
  Strings patterns;
  if (has_name(mechanism.bodies, owner)) patterns.push_back("B" + quantity);
  if (has_name(mechanism.joints, owner)) patterns.push_back("J" + quantity);
  if (has_name(mechanism.contacts, owner)) patterns.push_back("K" + quantity);
  return patterns;
}

std::vector<Column> all_columns(const Profile& profile) {
  std::vector<DriverProgram> programs = profile.programs;
  for (DriverProgram& program : programs) {
    program.duration = 1;
    program.time_step = 1;
  }
  RunSettings settings;
  settings.in_time = true;
  settings.forces = true;
  settings.jerk = true;
  return Model::from(profile.mechanism, profile.units, programs).value().start(settings).value().columns();
}

TEST(ReferenceOfResults, ExplainsEveryColumn) {
  const std::set<std::string> words = words_on("docs/results.md");
  std::set<std::string> seen;
  for (const Profile& profile : shipped_profiles()) {
    for (const Column& column : all_columns(profile)) {
      // A driver may have the name of a body, and with several drivers each has a name of its own.
      const Strings patterns = patterns_of(column, profile.mechanism);
      const bool explained = std::any_of(patterns.begin(), patterns.end(),
                                         [&](const std::string& pattern) { return words.contains(pattern); });
      const bool driver = column.name.starts_with("driver.");
      EXPECT_TRUE(explained || driver) << profile.mechanism.title << ": " << column.name;
      seen.insert(patterns.begin(), patterns.end());
    }
  }
  EXPECT_THAT(seen, IsSupersetOf(Strings{"time", "driver.effort", "B.alpha", "B.P.jx", "J.m", "K.rho2",
                                         "K.jerk_linkage", "K.friction", "status"}));
}

TEST(ReferenceOfResults, ExplainsEveryStatusAndEvent) {
  const std::set<std::string> words = words_on("docs/results.md");
  for (const RowStatus status : {RowStatus::kOk, RowStatus::kNotAssemblable, RowStatus::kSingular,
                                 RowStatus::kOverlap, RowStatus::kNotConverged, RowStatus::kContactOpen}) {
    EXPECT_THAT(words, Contains(std::string(name_of(status))));
  }
  for (const EventType type :
       {EventType::kLimitPosition, EventType::kDeadPoint, EventType::kStrokeEnd, EventType::kConforming,
        EventType::kSecondContact, EventType::kOverlap, EventType::kContactOpen, EventType::kLawJump,
        EventType::kCurvatureJump, EventType::kCorner, EventType::kEnd, EventType::kEngage,
        EventType::kRelease}) {
    EXPECT_THAT(words, Contains(std::string(name_of(type))));
  }
}

void collect_keys(const nlohmann::json& json, std::set<std::string>& keys) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      keys.insert(key);
    }
  }
  for (const auto& value : json) {
    if (value.is_structured()) {
      collect_keys(value, keys);
    }
  }
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string output;
  char block[4096];
  for (std::size_t got = 1; pipe != nullptr && got > 0;) {
    got = std::fread(block, 1, sizeof block, pipe.get());
    output.append(block, got);
  }
  return output;
}

// Keys that are names of the profile's joints: every assembly lists its joints by name.
const std::set<std::string>& own_names() {
  static const std::set<std::string> names = {"cam_pivot", "follower_pivot"};
  return names;
}

TEST(ReferenceOfTasks, NamesEveryKeyOfJson) {
  const std::string program = (fs::path(HIGHERPAIR_PROGRAM_DIR) / "higherpair").string();
  if (!fs::exists(program)) {
    GTEST_SKIP() << "the program is not part of this build";
  }
  const std::string profiles = (root() / "profiles").string() + "/";
  for (const auto& [page, arguments] :
       {std::pair("sensitivity", "sensitivity {}toleranced_linkage.toml --variants 1000"),
        {"design", "design {}design_eccentric.toml --starts 2 --evaluations 300 -o /dev/null"},
        {"fit", "fit {0}sixbar_measured.toml {0}sixbar_measured.csv -o /dev/null"},
        {"fit", "fit {}disc_points.csv --curve circle"},
        {"check", "check {}checked_cam.toml"}}) {
    const std::string command = fmt::format(fmt::runtime(arguments), profiles);
    const auto json = nlohmann::json::parse(output_of(program + " " + command + " --json - 2>/dev/null"));
    std::set<std::string> keys;
    collect_keys(json, keys);
    EXPECT_GE(keys.size(), 8U) << command;
    EXPECT_THAT(words_on(fmt::format("docs/{}.md", page)), IsSupersetOf(keys)) << command;
  }
}

TEST(ReferenceOfResults, NamesEveryKeyOfJson) {
  const fs::path program = fs::path(HIGHERPAIR_PROGRAM_DIR) / "higherpair";
  if (!fs::exists(program)) {
    GTEST_SKIP() << "the program is not part of this build";
  }
  if (!has_exact_arithmetic()) {
    GTEST_SKIP() << "the program cannot certify";
  }
  const std::set<std::string> words = words_on("docs/results.md");
  std::set<std::string> keys;
  const auto collect = [&](const std::string& arguments) {
    collect_keys(nlohmann::json::parse(output_of(program.string() + " " + arguments + " --quiet --json -")),
                 keys);
  };
  const std::string profiles = (root() / "profiles").string() + "/";
  for (const std::string name : {"four_bar", "slider_crank", "lock_up", "rolling_ellipses", "roller_body",
                                 "planetary_gear", "toggle_press"}) {
    collect(fmt::format("mobility {}{}.toml", profiles, name));
  }
  collect("branches --certify " + profiles + "ellipse_cam_roller.toml");
  collect("analyze " + profiles + "lock_up.toml");
  collect("verify");
  EXPECT_THAT(keys, IsSupersetOf(Strings{"events", "instant_centers", "time_ratio", "idle", "certified",
                                         "bound", "cause", "at_smallest", "multiple_pins"}));
  for (const std::string& key : keys) {
    EXPECT_TRUE(words.contains(key) || own_names().contains(key)) << key;
  }
}

}  // namespace
}  // namespace higherpair::house
