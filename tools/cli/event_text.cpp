#include "event_text.hpp"

#include "tell.hpp"

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

std::string quoted(const std::string& text) {
  std::string doubled;
  for (const char c : text) {
    doubled += c;
    if (c == '"') doubled += c;
  }
  return fmt::format("\"{}\"", doubled);
}

// The value of an event at which a joint reverses: " = -45.88 deg"; empty for other events.
std::string value_text(const Event& event, const Model& model) {
  if (!event.value || !event.joint) {
    return "";
  }
  const Joint& joint = model.mechanism().joints[*event.joint];
  const Dimension& of = has_angle(joint.type) ? dimension::kAngle : dimension::kLength;
  return fmt::format(" = {:.10g} {}", *event.value, unit_text(of, model.units()));
}

}  // namespace

std::string driver_unit(const Model& model) {
  const Mechanism& mechanism = model.mechanism();
  const Joint& driven = mechanism.joints[mechanism.drivers.front().joint];
  return unit_text(has_angle(driven.type) ? dimension::kAngle : dimension::kLength, model.units());
}

std::string events_csv(const std::vector<Event>& events, const Model& model) {
  std::string text = fmt::format("type,driver[{}],time[{}],item,row,cause\n", driver_unit(model),
                                 unit_text(dimension::kTime, model.units()));
  for (const Event& event : events) {
    text += fmt::format("{},{},{},{},{},{}\n", name_of(event.type), event.driver,
                        event.time ? fmt::format("{}", *event.time) : "", event.item, event.row,
                        quoted(event.cause));
  }
  return text;
}

std::vector<std::string> event_lines(const std::vector<Event>& events, const Model& model) {
  const std::string unit = driver_unit(model), time_unit = unit_text(dimension::kTime, model.units());
  std::vector<std::string> lines;
  for (const Event& event : events) {
    const std::string item = event.item.empty() ? "" : ": " + event.item;
    const std::string time = event.time ? fmt::format(", time = {:.15g} {}", *event.time, time_unit) : "";
    lines.push_back(fmt::format("{} at driver = {:.15g} {}{}{}{}: {}", name_of(event.type), event.driver,
                                unit, time, item, value_text(event, model), event.cause));
  }
  return lines;
}

void print_events(const std::vector<Event>& events, const Model& model) {
  for (const std::string& line : event_lines(events, model)) {
    tell("{}\n", line);
  }
}

void print_passed(const std::vector<Event>& passed, const Model& model) {
  if (!passed.empty()) {
    tell("higherpair: the motion from the first position to what is drawn goes over\n");
    print_events(passed, model);
  }
}

}  // namespace higherpair::cli
