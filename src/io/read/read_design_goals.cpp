#include "higherpair/analysis/status.hpp"
#include "higherpair/io/column_dimension.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/numeric/overload.hpp"
#include "laws.hpp"
#include "number_unit.hpp"
#include "read_design.hpp"
#include "read_measure.hpp"

#include <string>
#include <utility>
#include <variant>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// The dimension of a column that can follow a law.
std::optional<Dimension> lawful_dimension(const Measure& measure, const Mechanism& mechanism) {
  const auto ends = [&](std::string_view ending) { return measure.column.ends_with(ending); };
  return ends(".angle") || ends(".x") || ends(".y") || ends(".position")
             ? column_dimension(mechanism, measure.column)
             : std::nullopt;
}

// `follow = "LAW"`: the change of the column since the first row is compared with the law at every row.
void follow_law(Reading& reading, const Item& follow, Profile& profile, LawBook& laws,
                DesignTask::Followed& followed) {
  const auto value = lawful_dimension(followed.measure, profile.mechanism);
  if (!value) {
    report(reading, follow,
           "a law is of an angle or of a coordinate: BODY.angle, BODY.POINT.x, JOINT.position");
    return;
  }
  if (!reading.mistakes.empty()) {
    return;  // the driver or its joint may have one of them
  }
  if (profile.mechanism.drivers.size() != 1) {
    report(reading, follow,
           "a law is a function of one driver's position: expected a mechanism with one driver");
    return;
  }
  const LawQuantities quantities{driver_dimension(profile.mechanism), *value};
  const auto index = laws.find(follow, quantities, profile.mechanism);
  const auto schedule = DriverSchedule::analyze(profile);
  if (!index || !schedule) return;
  const MotionLaw& law = laws.made(*index);
  followed.change = true;
  for (std::int64_t k = 0; k < schedule->size(); ++k) {
    followed.at.push_back(schedule->state(k).profile.position);
    law.expand(followed.at.back(), LawSide::kBefore, std::span(&followed.values.emplace_back(), 1));
  }
}

void follow_pairs(Reading& reading, const Item& follow, const Mechanism& mechanism,
                  DesignTask::Followed& followed) {
  const auto items = as_items(reading, follow,
                              "a list of at least two pairs, [[driver, value], …], or the name of a law", 2);
  for (const Item& item : items.value_or(std::vector<Item>{})) {
    const auto pair = as_items(reading, item, "[driver, value], two numbers", 2, 2);
    if (!pair) return;
    const auto at = as_number_in(reading, (*pair)[0], unit_of_driver(mechanism));
    const auto value =
        as_number_in(reading, (*pair)[1], unit_of_column(reading, mechanism, followed.measure.column));
    if (!at || !value) return;
    followed.at.push_back(*at);
    followed.values.push_back(*value);
  }
}

// `follow`: the values wanted of a column at given positions of the driver.
std::optional<DesignTask::Followed> read_follow(TableReader& table, const Item& follow, Profile& profile,
                                                LawBook& laws) {
  Reading& reading = table.reading();
  table.refuse("of", "the column is followed at the positions in `follow`");
  table.refuse("at", "the positions are those in `follow`");
  table.refuse("target", "the values are those in `follow`");
  DesignTask::Followed followed;
  Measure& measure = followed.measure;
  if (const auto column = table.need("column", "the name of a column, such as \"follower.angle\"")) {
    measure.place = place_of(reading, column->value->mark);
    measure.path = path_of(reading, *column);
    measure.column = as_text(reading, *column).value_or("");
  }
  measure.of = MeasureKind::kAt;
  measure.followed = true;
  if (std::holds_alternative<std::string>(follow.value->content)) {
    follow_law(reading, follow, profile, laws, followed);
  } else {
    followed.change = table.flag("change", false);
    follow_pairs(reading, follow, profile.mechanism, followed);
  }
  if (followed.at.empty()) return std::nullopt;
  measure.at = followed.at.front();
  return followed;
}

// `figure`: one of the values that `check` computes, "contacts.touch.contact_pressure".
std::optional<DesignTask::Figure> read_figure(TableReader& table, const Item& item) {
  table.refuse("column", "this is a figure of `check`: one of the two");
  table.refuse("of", "a figure is an extreme already");
  const std::string curve = table.text("curve");
  const auto name = as_text(table.reading(), item);
  if (!name) return std::nullopt;
  const std::string& text = *name;
  const std::size_t dot = text.rfind('.');
  if (dot == std::string::npos || dot + 1 == text.size()) {
    report(table.reading(), item,
           "expected a figure of `check`, such as \"contacts.touch.contact_pressure\"");
    return std::nullopt;
  }
  return DesignTask::Figure{text.substr(0, dot), text.substr(dot + 1), curve};
}

std::optional<Measure> read_column_goal(TableReader& table, const Mechanism& mechanism) {
  table.knows({"figure", "reach", "size"});
  bool is_part = false;  // of something whose own key is missing
  for (const auto& [key, owner] :
       {std::pair("change", "follow"), std::pair("curve", "figure"), std::pair("from", "reach"),
        std::pair("bodies", "size"), std::pair("coupler", "grashof")}) {
    is_part = is_part || (table.has(key) && !table.has("column"));
    table.refuse(key, fmt::format("belongs to `{}`", owner), owner);
  }
  if (is_part) {
    table.knows({"column", "of", "at"});
    return std::nullopt;
  }
  if (!table.has("column")) {
    table.instead({"path", "follow", "figure", "reach", "size", "transmission", "grashof", "without"});
  }
  return read_measure(table, unit_of_driver(mechanism));
}

// Of the target of an objective, or the limits of a constraint.
template <class Kind>
NumberUnit unit_of_goal(const Reading& reading, const std::optional<Kind>& of, const Mechanism& mechanism) {
  if (!of) return {};
  NumberUnit length{dimension::kLength, ""};
  return std::visit(
      Overload{[&](const Measure& measure) { return unit_of_column(reading, mechanism, measure.column); },
               [&](const DesignTask::Figure& figure) {
                 return unit_of_figure(mechanism, figure.item, figure.quantity);
               },
               [&](const DesignTask::Transmission&) {
                 return NumberUnit{dimension::kAngle, ""};
               },
               [&](const auto&) { return length; }},
      *of);
}

std::optional<DesignTask::Grashof> read_grashof(TableReader& table, const Item& item,
                                                const Mechanism& mechanism) {
  static const std::vector<std::pair<std::string, GrashofClass>> classes = {
      {"crank-rocker", GrashofClass::kCrankRocker},   {"rocker-crank", GrashofClass::kRockerCrank},
      {"double-crank", GrashofClass::kDoubleCrank},   {"double-rocker", GrashofClass::kDoubleRocker},
      {"triple-rocker", GrashofClass::kTripleRocker},
  };
  std::vector<std::string> names;
  for (const auto& [name, of] : classes) names.push_back(name);
  const auto choice = as_choice(table.reading(), item, names);
  if (!choice) return std::nullopt;
  DesignTask::Grashof grashof{names[*choice], classes[*choice].second, -1};
  if (const auto coupler = table.take("coupler")) {
    std::vector<std::string> bodies;
    for (const Body& body : mechanism.bodies) bodies.push_back(body.name);
    const auto body = as_choice(table.reading(), *coupler, bodies);
    if (!body) return std::nullopt;
    grashof.coupler = static_cast<int>(*body);
  }
  return grashof;
}

// A limit of a transmission angle, in the unit of tables.
void check_transmission_limit(TableReader& table, const std::optional<double>& limit, const Units& units) {
  const double right = from_si(dimension::kAngle, units).apply(kPi / 2);
  if (limit && !(*limit >= 0 && *limit <= right)) {
    report_whole(table, fmt::format("a transmission angle is from 0 to {}, not {}",
                                    with_unit(kPi / 2, dimension::kAngle, units), *limit));
  }
}

std::vector<EventType> read_events(Reading& reading, const Item& item) {
  constexpr EventType kTypes[] = {
      EventType::kDeadPoint,  EventType::kStrokeEnd,     EventType::kContactOpen, EventType::kSecondContact,
      EventType::kConforming, EventType::kCurvatureJump, EventType::kCorner,      EventType::kLawJump};
  std::vector<std::string> names;
  for (const EventType type : kTypes) names.emplace_back(name_of(type));
  std::vector<EventType> events;
  const auto items = as_items(reading, item, "a list of events, such as [\"dead_point\"]");
  for (const Item& one : items.value_or(std::vector<Item>{})) {
    if (const auto choice = as_choice(reading, one, names)) events.push_back(kTypes[*choice]);
  }
  return events;
}

}  // namespace

std::optional<DesignTask::Objective> read_objective(TableReader& table, Profile& profile, LawBook& laws) {
  Reading& reading = table.reading();
  DesignTask::Objective objective;
  objective.path_of_key = table.path();
  objective.place = place_of(reading, table.mark());
  std::optional<decltype(objective.of)> of;
  if (const auto path = table.take_kind("path")) {
    table.refuse("column", "this objective is a path: make an objective of its own of the column");
    table.refuse("of", "belongs to `column`");
    table.refuse("target", "a path is met as well as it can be");
    if (auto reader = as_reader(reading, path, "a path, { point = …, through = … }")) {
      of = read_point_path(*reader, profile.mechanism);
      reader->finish();
    }
  } else if (const auto follow = table.take_kind("follow")) {
    of = read_follow(table, *follow, profile, laws);
  } else if (const auto figure = table.take_kind("figure")) {
    of = read_figure(table, *figure);
  } else if (is_extent(table)) {
    of = read_extent(table, profile.mechanism);
  } else {
    table.knows({"path", "follow", "target"});
    of = read_column_goal(table, profile.mechanism);
  }
  if (of && !std::holds_alternative<DesignTask::PointPath>(*of) &&
      !std::holds_alternative<DesignTask::Followed>(*of)) {
    objective.target = table.take("target", as_number_in, unit_of_goal(reading, of, profile.mechanism));
  }
  objective.weight = table.take("weight", as_positive_in, no_unit()).value_or(1);
  if (!of) return std::nullopt;
  objective.of = *std::move(of);
  return objective;
}

std::optional<DesignTask::Constraint> read_constraint(TableReader& table, const Profile& profile) {
  Reading& reading = table.reading();
  DesignTask::Constraint constraint;
  constraint.path_of_key = table.path();
  constraint.place = place_of(reading, table.mark());
  std::optional<decltype(constraint.of)> of;
  if (const auto pin = table.take_kind("transmission")) {
    table.refuse("column", "this constraint is one of a transmission angle");
    table.refuse("of", "a transmission angle counts where it is least");
    const auto joint = as_joint(reading, *pin, profile.mechanism);
    if (joint && profile.mechanism.joints[*joint].type != JointType::kRevolute) {
      report(reading, *pin, "expected a revolute joint, the pin between two links");
    } else if (joint) {
      of = DesignTask::Transmission{as_text(reading, *pin).value_or(""), *joint};
    }
  } else if (const auto grashof = table.take_kind("grashof")) {
    of = read_grashof(table, *grashof, profile.mechanism);
    constraint.above = 0;
  } else if (const auto without = table.take_kind("without")) {
    table.refuse("below", "none of these events is to happen");
    table.refuse("above", "none of these events is to happen");
    DesignTask::Events events{read_events(reading, *without)};
    if (!events.types.empty()) of = std::move(events);
    constraint.below = 0;
  } else if (const auto figure = table.take_kind("figure")) {
    of = read_figure(table, *figure);
  } else if (is_extent(table)) {
    of = read_extent(table, profile.mechanism);
  } else {
    table.knows({"transmission", "grashof", "without"});
    of = read_column_goal(table, profile.mechanism);
  }
  const Mistakes mistakes(reading);
  const NumberUnit unit = unit_of_goal(reading, of, profile.mechanism);
  if (const auto below = table.take("below", as_number_in, unit)) constraint.below = below;
  if (const auto above = table.take("above", as_number_in, unit)) constraint.above = above;
  const bool may_be_refused = !unit.dimension && unit.objection.empty();
  if (!constraint.below && !constraint.above && mistakes.none() && !may_be_refused) {
    report_whole(table, "a limit is missing: below = … or above = …",
                 {table.path_to("below"), table.path_to("above")});
  } else if (constraint.below && constraint.above && !(*constraint.above < *constraint.below)) {
    report_whole(table,
                 fmt::format("nothing is above {} and below {}", *constraint.above, *constraint.below));
  }
  if (!of) return std::nullopt;
  constraint.of = *std::move(of);
  if (constraint.transmission()) {
    check_transmission_limit(table, constraint.above, profile.units);
    check_transmission_limit(table, constraint.below, profile.units);
  }
  return constraint;
}

}  // namespace higherpair::io_detail
