#include "higherpair/mechanism/mobility_text.hpp"

#include "front/tolerances.hpp"
#include "higherpair/numeric/contains.hpp"
#include "mobility_parts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace higherpair {
namespace {

using Json = nlohmann::ordered_json;

// The numbers of the JSON, in sentences.
class MobilityWriter {
public:
  explicit MobilityWriter(const MobilityFindings& findings)
      : findings_(findings),
        json_(json_of(findings)),
        length_(unit_text(dimension::kLength, findings.model.units())),
        angle_(unit_text(dimension::kAngle, findings.model.units())) {}

  std::string all() {
    if (!findings_.model.mechanism().title.empty()) {
      add("{}\n", findings_.model.mechanism().title);
    }
    counting();
    drivers();
    plan();
    int number = 0;
    for (const Json& loop : json_["four_bars"]) {
      four_bar(++number, loop);
    }
    number = 0;
    for (const Json& loop : json_["slider_cranks"]) {
      slider_crank(++number, loop);
    }
    text_ += gears_text(json_["gears"], length_, angle_);
    centers();
    return text_;
  }

private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
  }

  static std::string number(double value) {
    return fmt::format("{:.7g}", std::abs(value) < kNoNumber ? 0 : value);
  }
  // A coordinate that is a rounding of the other one is 0.
  static std::string place(double x, double y) {
    const double rounding = kNoNumber * std::hypot(x, y);
    return fmt::format("({}, {})", number(std::abs(x) <= rounding ? 0 : x),
                       number(std::abs(y) <= rounding ? 0 : y));
  }
  static std::string number(const Json& value) { return number(value.get<double>()); }
  [[nodiscard]] std::string length(const Json& value) const { return number(value) + " " + length_; }
  [[nodiscard]] std::string angle(const Json& value) const { return number(value) + " " + angle_; }
  static std::string word(const Json& value) { return value.get<std::string>(); }

  static std::string names(const Json& list) {
    std::string text;
    for (const Json& name : list) {
      text += (text.empty() ? "" : ", ") + word(name);
    }
    return text;
  }

  void counting() {
    const Mobility& mobility = findings_.mobility;
    add("Count: {}", elements_text(mobility.count));
    add("       {}", formula_text(mobility.count));
    for (const Json& pin : json_["count"]["multiple_pins"]) {
      add("       a pin of {} bodies ({}) counts {} times", pin["bodies"].size(), names(pin["bodies"]),
          pin["joints"].size());
    }
    if (!mobility.assembled) {
      add("Rank:  unknown, the mechanism cannot be assembled near its poses");
      return;
    }
    add("Rank:  {} (at {} assembled position{})", rank_text(mobility), mobility.positions,
        mobility.positions == 1 ? "" : "s");
    for (const Json& sentence : json_["explanations"]) {
      add("       {}", word(sentence));
    }
    for (const Json& idle : json_["idle"]) {
      add("Idle:  {}, at ({}, {}) {}", word(idle["text"]), number(idle["x"]), number(idle["y"]), length_);
    }
    if (!mobility.drivers_held && !findings_.model.mechanism().drivers.empty()) {
      add("       (assembled near its poses: it cannot be with the drivers at their first positions)");
    }
  }

  void drivers() {
    const Json& drivers = json_["drivers"];
    if (drivers.is_null()) {
      return;
    }
    add("Drivers: {} needed, {} given", drivers["needed"].get<int>(), drivers["given"].get<int>());
    if (!drivers["objection"].is_null()) {
      add("       {}", word(drivers["objection"]));
    }
  }

  void plan() {
    if (json_["plan"].empty()) {
      return;
    }
    add("\nOrder of solution:");
    int step = 0;
    for (const Json& group : json_["plan"]) {
      add("  {}. {}", ++step, word(group["text"]));
    }
  }

  void link(const Json& loop, const char* name) {
    const Json& limits = loop["limits"][name];
    std::string text = fmt::format("  {}: ", word(loop[name]));
    if (loop["full_turn"][name].get<bool>()) {
      add("{}turns fully, no dead point as driver", text);
      return;
    }
    if (limits.empty()) {
      add("{}no limit position", text);
      return;
    }
    const bool passes = std::all_of(limits.begin(), limits.end(),
                                    [](const Json& limit) { return limit["change_point"].get<bool>(); });
    text += passes ? "turns fully through change points, at " : "limit positions, dead points as driver, at ";
    std::vector<std::string> places;
    for (const Json& limit : limits) {
      std::string place = angle(limit[name]);
      if (std::string(name) != "crank") {
        place += " (crank " + angle(limit["crank"]) + ")";
      }
      place += limit["change_point"].get<bool>() && !passes ? " (change point)" : "";
      if (!contains(places, place)) {  // of another link folded either way
        places.push_back(std::move(place));
      }
    }
    add("{}{}", text, fmt::join(places, "; "));
  }

  void four_bar(int index, const Json& loop) {
    const Json& r = loop["lengths"];
    add("\nFour-bar {}: frame {}, crank {}, coupler {}, rocker {}", index, word(loop["ground"]),
        word(loop["crank"]), word(loop["coupler"]), word(loop["rocker"]));
    add("  r1 = {}, r2 = {}, r3 = {}, r4 = {} {}; angles from the line of the frame's pins", number(r[0]),
        number(r[1]), number(r[2]), number(r[3]), length_);
    add("  Grashof: {}, p + q - s - l = {}", word(loop["grashof"]), length(loop["margin"]));
    link(loop, "crank");
    link(loop, "coupler");
    link(loop, "rocker");
    const Json& transmission = loop["transmission"];
    if (!transmission.is_null()) {
      add("  transmission angle: smallest {} at crank {}, largest {} at crank {}",
          angle(transmission["smallest"]), angle(transmission["at_smallest"]), angle(transmission["largest"]),
          angle(transmission["at_largest"]));
    }
  }

  void quick_return(int index, const Json& loop) {
    const Json& parts = loop["quick_return"];
    const bool oscillating = loop["inversion"].get<std::string>().starts_with("coupler");
    std::string names = fmt::format("frame {}, crank {}", word(parts["frame"]), word(parts["crank"]));
    if (oscillating) {
      names += fmt::format(", oscillating cylinder {}, rod {}",
                           parts["lever"].is_null() ? "-" : word(parts["lever"]), word(loop["guide"]));
    } else {
      names += ", slotted lever " + word(parts["lever"]);
      names += loop["slider"].is_null() ? "" : ", block " + word(loop["slider"]);
    }
    names += parts["ram"].is_null() ? "" : ", ram " + word(parts["ram"]);
    add("\nQuick return {}: {}", index, names);
    add("  frame {}, crank {}, offset of the slot {} {}", number(parts["frame_length"]),
        number(parts["crank_length"]), number(loop["offset"]), length_);
    if (parts["time_ratio"].is_null()) {
      add("  the crank does not turn fully: of frame and crank the longer must exceed the shorter and the "
          "offset");
    } else if (parts["lever_turns"].get<bool>()) {
      add("  the lever turns fully (Whitworth); time ratio {} of its half turns between the positions square "
          "to the "
          "frame",
          number(parts["time_ratio"]));
    } else {
      add("  the lever swings by {}; time ratio {} of its slow stroke to the fast one", angle(parts["swing"]),
          number(parts["time_ratio"]));
    }
  }

  void slider_crank(int index, const Json& loop) {
    if (!loop["quick_return"].is_null()) {
      quick_return(index, loop);
      return;
    }
    add("\nSlider-crank {}: guide {}, crank {}, coupler {}, {}; {}", index, word(loop["guide"]),
        word(loop["crank"]), word(loop["coupler"]),
        loop["slider"].is_null() ? "slot " + word(loop["joint"]) : "slider " + word(loop["slider"]),
        word(loop["inversion"]));
    add("  r2 = {}, r3 = {}, offset {} {}; crank angles from the line of sliding", number(loop["r2"]),
        number(loop["r3"]), number(loop["offset"]), length_);
    const Json& stroke = loop["stroke"];
    const double slack =
        loop["r3"].get<double>() - loop["r2"].get<double>() - std::abs(loop["offset"].get<double>());
    if (stroke.is_null() && std::abs(slack) <= kChangePointSlack * loop["r3"].get<double>()) {
      add("  the crank turns fully only through a change point: r3 = r2 + |offset|");
    } else if (stroke.is_null()) {
      add("  the crank does not turn fully against the guide: r3 must exceed r2 + |offset|");
    } else {
      add("  stroke {}, time ratio {}; from outer to inner dead centre the crank turns {}",
          length(stroke["length"]), number(stroke["time_ratio"]), angle(stroke["turn_in"]));
      add("  dead centres: outer at crank {}, slider {}; inner at crank {}, slider {}",
          angle(stroke["outer"]["crank"]), length(stroke["outer"]["slider"]), angle(stroke["inner"]["crank"]),
          length(stroke["inner"]["slider"]));
    }
    const Json& harmonic = loop["harmonic"];
    if (!harmonic.is_null()) {
      add("  two harmonics err by at most {} r, {} r w, {} r w^2 in position, velocity, acceleration",
          number(harmonic["position"]), number(harmonic["velocity"]), number(harmonic["acceleration"]));
    }
  }

  void centers() {
    if (json_["instant_centers"].empty()) {
      return;
    }
    add("\nInstant centres at the start, in {}:", length_);
    for (const Json& center : json_["instant_centers"]) {
      const std::string pair = names(center["bodies"]);
      if (center["kind"] == "point") {
        add("  {}: {}", pair, place(center["x"].get<double>(), center["y"].get<double>()));
      } else if (center["kind"] == "at_infinity") {
        add("  {}: at infinity along ({}, {})", pair, number(center["x"]), number(center["y"]));
      } else {
        add("  {}: undefined, they are at rest against each other", pair);
      }
    }
  }

  const MobilityFindings& findings_;
  Json json_;
  std::string length_;
  std::string angle_;
  std::string text_;
};

}  // namespace

std::string mobility_text(const MobilityFindings& findings) {
  return MobilityWriter(findings).all();
}

}  // namespace higherpair
