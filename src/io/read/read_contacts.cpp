#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "reading.hpp"

#include <array>
#include <string_view>

namespace higherpair::io_detail {
namespace {

constexpr std::array<Approach, 3> kApproaches = {Approach::kNearest, Approach::kPositive,
                                                 Approach::kNegative};

void read_ends(TableReader& table, Mechanism& mechanism, Contact& contact) {
  const auto item = table.need("between", "two curves, [\"body.curve\", \"body.curve\"]");
  const auto pair = item ? as_curve_pair(table.reading(), *item, mechanism) : std::nullopt;
  if (!pair) {
    return;
  }
  contact.first = pair->first;
  contact.second = pair->second;
  const auto is_in_parts = [&](const CurveRef& ref) {
    return curve_of(mechanism, ref).kind == CurveKind::kChain;
  };
  if (contact.rolling && (is_in_parts(contact.first) || is_in_parts(contact.second))) {
    report(table.reading(), *item,
           "curves with ends or of several parts slip: leave `rolling` out, roll whole conics, or join "
           "wheels by gears");
  }
  const std::string_view objection =
      why_no_contact(curve_of(mechanism, pair->first), curve_of(mechanism, pair->second));
  if (!objection.empty()) {
    report(table.reading(), *item, objection);
  }
}

void read_approach(TableReader& table, Contact& contact) {
  contact.approach = kApproaches[table.take("approach", as_choice, {"nearest", "+", "-"}).value_or(0)];
}

void read_keep(TableReader& table, Contact& contact) {
  const auto item = table.take("keep");
  const auto choice = item ? as_choice(table.reading(), *item, {"touch", "gap"}) : std::nullopt;
  contact.keep = choice == 1U ? Keep::kGap : Keep::kTouching;
  if (contact.keep == Keep::kGap && contact.rolling) {
    report(table.reading(), *item, "curves that may part slip: leave `rolling` out");
  }
  if (contact.keep == Keep::kGap && contact.approach != Approach::kNearest) {
    note_whole(table,
               "a contact that may part is open at the start unless the bodies touch in the pose: its "
               "`approach` has no effect");
  }
  contact.both_sides = table.flag("both_sides", false);
}

}  // namespace

void read_contacts(TableReader& root, Mechanism& mechanism) {
  for_each_table(root.reading(), root.take("contacts"), "a contact (a table)",
                 [&](const std::string& name, TableReader& table) {
                   Contact contact;
                   contact.name = name;
                   contact.rolling = table.flag("rolling", false);
                   read_ends(table, mechanism, contact);
                   read_approach(table, contact);
                   read_keep(table, contact);
                   contact.jump = table.flag("jump", true);
                   table.finish();
                   mechanism.contacts.push_back(contact);
                 });
}

}  // namespace higherpair::io_detail
