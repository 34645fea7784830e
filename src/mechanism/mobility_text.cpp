#include "higherpair/mechanism/mobility_text.hpp"

#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/plan_text.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

namespace higherpair {
namespace {

std::string number_of(int n, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

std::string freedoms(int n) {
  return number_of(n, "freedom", "freedoms");
}

std::string drivers(int n) {
  return number_of(n, "driver", "drivers");
}

std::string driver_text(const Mechanism& mechanism, int index) {
  const auto i = static_cast<std::size_t>(index);
  const std::string& name = mechanism.drivers[i].name;
  const std::string& joint = driven_joint(mechanism, i).name;
  return name.empty() ? fmt::format("driver (of {})", joint) : fmt::format("drivers.{} (of {})", name, joint);
}

std::string repeated(const Redundancy& set) {
  return number_of(set.conditions, "condition is redundant", "conditions are redundant");
}

std::string everything_in(const Mechanism& mechanism, const Redundancy& set) {
  std::string names = names_of(mechanism.joints, set.joints);
  if (!set.contacts.empty()) {
    names += (names.empty() ? "contacts " : ", contacts ") + names_of(mechanism.contacts, set.contacts);
  }
  return names;
}

std::string explain(const Mechanism& mechanism, const Redundancy& set) {
  switch (set.cause) {
    case RedundancyCause::kSamePin:
      return fmt::format("{}: the joints {} hold the same pin; k bodies on a pin need k - 1 joints",
                         repeated(set), names_of(mechanism.joints, set.joints));
    case RedundancyCause::kParallelCranks:
      return fmt::format(
          "{}: the links {} are equal and parallel, and two of them lead the others along the same circles",
          repeated(set), names_of(mechanism.bodies, set.bodies));
    case RedundancyCause::kRollingOnPivots:
      return fmt::format(
          "{}: {} is rolling between pivots: {} keep the curves in touch already, so the contact removes "
          "only the slip",
          repeated(set), names_of(mechanism.contacts, set.contacts), names_of(mechanism.joints, set.joints));
    case RedundancyCause::kSlidingOnPivots:
      return fmt::format(
          "{}: {} is sliding between pivots: {} keep the discs in touch already, so the contact removes "
          "nothing",
          repeated(set), names_of(mechanism.contacts, set.contacts), names_of(mechanism.joints, set.joints));
    case RedundancyCause::kSlidesAlone:
      return fmt::format(
          "{}: {} are a loop of slides alone, in which nothing turns: the last one says so again",
          repeated(set), names_of(mechanism.joints, set.joints));
    case RedundancyCause::kMember:
      break;
  }
  return fmt::format("{} among {}: a member or joint more than it takes, which fits only by its dimensions",
                     repeated(set), everything_in(mechanism, set));
}

std::string structure_text(const Mobility& mobility) {
  const bool indeterminate = mobility.rank < mobility.conditions;
  return fmt::format(
      "it is a structure: nothing moves; statically {}",
      indeterminate ? fmt::format("indeterminate ({} more than the forces can be found for)",
                                  number_of(mobility.conditions - mobility.rank, "condition", "conditions"))
                    : "determinate");
}

std::string missing_text(const Mechanism& mechanism, const Mobility& mobility) {
  std::string text =
      fmt::format("more freedom than drivers: {} left by the drivers, in which {} can move; add {}",
                  freedoms(mobility.missing_drivers), names_of(mechanism.bodies, mobility.loose_bodies),
                  drivers(mobility.missing_drivers));
  if (!mobility.joints_to_drive.empty()) {
    text += fmt::format(" ({}: {})", mobility.missing_drivers == 1 ? "of one of the joints" : "of the joints",
                        names_of(mechanism.joints, mobility.joints_to_drive));
  }
  return text + ", or joints or contacts that hold them";
}

std::string useless_text(const Mechanism& mechanism, const Mobility& mobility) {
  std::vector<std::string> names;
  for (const int driver : mobility.useless_drivers) {
    names.push_back(driver_text(mechanism, driver));
  }
  if (mobility.freedom == 0) {
    return fmt::format("more drivers than freedom: {}; remove {}, or a joint, contact or member",
                       mobility.singular ? "it moves infinitesimally only" : "nothing can move",
                       joined_words(names));
  }
  return fmt::format("more drivers than freedom: remove {}: the other drivers and the joints set {} already",
                     joined_words(names), names.size() == 1 ? "its joint" : "their joints");
}

}  // namespace

std::string elements_text(const MobilityCount& count) {
  std::vector<std::string> kinds;
  const auto add = [&](int n, const std::string& name, int freedom) {
    if (n > 0) {
      kinds.push_back(fmt::format("{} of {}", number_of(n, name, name + "s"), freedoms(freedom)));
    }
  };
  add(count.revolutes, "revolute joint", 1);
  add(count.prismatics, "prismatic joint", 1);
  add(count.slots, "slot", 2);
  add(count.slipping, "slipping contact", 2);
  add(count.rolling, "rolling contact", 1);
  add(count.gears, "gear pair", 2);
  add(count.belts, "belt", 2);
  return fmt::format("n = {} with ground, j = {}{}, sum f = {}", number_of(count.bodies, "body", "bodies"),
                     number_of(count.joints(), "joint or contact", "joints and contacts"),
                     kinds.empty() ? "" : " (" + joined_words(kinds) + ")", count.freedoms());
}

std::string formula_text(const MobilityCount& count) {
  return fmt::format("M = 3 (n - j - 1) + sum f = 3 ({} - {} - 1) + {} = {}", count.bodies, count.joints(),
                     count.freedoms(), count.mobility());
}

std::string rank_text(const Mobility& mobility) {
  const int coordinates = 3 * (mobility.count.bodies - 1);
  return fmt::format("{} on {} have rank {}: freedom {} - {}{} = {}",
                     number_of(mobility.conditions, "condition", "conditions"),
                     number_of(coordinates, "coordinate", "coordinates"), mobility.rank, coordinates,
                     mobility.rank, mobility.shaky > 0 ? fmt::format(" - {} (shaky)", mobility.shaky) : "",
                     mobility.freedom);
}

std::vector<std::string> explanations(const Mechanism& mechanism, const Mobility& mobility) {
  std::vector<std::string> sentences;
  if (!mobility.assembled) {
    return sentences;
  }
  if (mobility.freedom != mobility.count.mobility()) {
    sentences.push_back(fmt::format("the count gives {}, the rank {}, and the rank decides",
                                    mobility.count.mobility(), mobility.freedom));
  }
  for (const Redundancy& set : mobility.redundancies) {
    sentences.push_back(explain(mechanism, set));
  }
  if (mobility.shaky > 0) {
    sentences.push_back(fmt::format(
        "it is shaky: {} of the null space lead nowhere; it gives within its clearances, under large forces",
        freedoms(mobility.shaky)));
  } else if (mobility.singular) {
    sentences.push_back(fmt::format(
        "the start is singular: {} there and {} nearby; it is a change point, where ways of moving cross",
        freedoms(mobility.start_freedom), mobility.freedom));
  }
  if (mobility.freedom == 0) {
    sentences.push_back(structure_text(mobility));
  }
  return sentences;
}

std::vector<std::string> idle_texts(const Mechanism& mechanism, const Mobility& mobility) {
  std::vector<std::string> sentences;
  for (const IdleFreedom& idle : mobility.idle) {
    sentences.push_back(fmt::format("{} turns freely about its centre and changes nothing else",
                                    mechanism.bodies[idle.body].name));
  }
  return sentences;
}

std::optional<std::string> driver_objection(const Mechanism& mechanism, const Mobility& mobility) {
  if (!mobility.assembled || mobility.drivers_fit()) {
    return std::nullopt;
  }
  const int given = static_cast<int>(mechanism.drivers.size());
  std::string text =
      fmt::format("wrong mobility for its drivers: {} by rank ({} by the count, {})",
                  freedoms(mobility.freedom), mobility.count.mobility(), formula_text(mobility.count));
  if (!mobility.idle.empty()) {
    text += fmt::format(", {} of them idle", mobility.idle.size());
  }
  text += fmt::format(", {} needed, {} given", drivers(mobility.useful()), given);
  if (mobility.missing_drivers > 0) {
    text += "; " + missing_text(mechanism, mobility);
  }
  if (!mobility.useless_drivers.empty()) {
    text += "; " + useless_text(mechanism, mobility);
  }
  return text;
}

std::optional<std::string> surplus_objection(const Mechanism& mechanism, const Plan& plan,
                                             const std::vector<double>& drivers) {
  const bool rolls = std::any_of(plan.groups.begin(), plan.groups.end(), [&](const Group& group) {
    const auto placing = placing_contact(group);
    return placing && mechanism.contacts[placing->contact].rolling;
  });
  return plan.surplus == 0 || rolls ? std::nullopt : driver_objection(mechanism, drivers);
}

std::optional<std::string> driver_objection(const Mechanism& mechanism, const std::vector<double>& drivers) {
  MobilityQuestion question;
  question.drivers = drivers;
  return driver_objection(mechanism, analyse_mobility(mechanism, question));
}

}  // namespace higherpair
