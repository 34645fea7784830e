#include "higherpair/geometry/gear_outline.hpp"
#include "higherpair/geometry/gear_pair.hpp"
#include "io/tolerances.hpp"
#include "read_boundary.hpp"

#include <cmath>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr Expected kRollAngle = {dimension::kAngle};
constexpr std::int64_t kMostTeeth = 1000;  // of an outline: each tooth has spans and samples of its own
constexpr Expected kInvoluteSize = {dimension::kLength, Sign::kPositive};

// The roll of the flanks that a rack cuts. None if it is empty or the rack undercuts them, which is reported.
std::optional<Bounds> whole_roll(TableReader& table, const InvoluteTooth& tooth,
                                 const std::string& otherwise) {
  const Bounds roll = {roll_at_root(tooth), roll_at_tip(tooth)};
  if (roll.low <= 0) {
    const double shift = 1 - tooth.teeth / least_teeth(tooth.pressure_angle);
    report_whole(
        table,
        fmt::format("a rack cuts into the base circle of so few teeth (undercut, below {:.4f} teeth without "
                    "profile shift): a `profile_shift` of {} at least{}",
                    least_teeth(tooth.pressure_angle), std::ceil(1e4 * shift) / 1e4, otherwise));
    return std::nullopt;
  }
  if (roll.width() <= 0) {
    report_whole(table, "the tip circle lies inside the root: less negative `profile_shift`");
    return std::nullopt;
  }
  return roll;
}

// The roll of a flank, both angles > 0. \param tooth  null: `roll` is required, for there is no default
std::optional<Bounds> read_roll(TableReader& table, const InvoluteTooth* tooth) {
  Reading& reading = table.reading();
  const auto item = tooth != nullptr ? table.take("roll") : table.need("roll", "[from, to], angles of roll");
  if (!item && tooth == nullptr) {
    return std::nullopt;
  }
  if (!item) {
    return whole_roll(table, *tooth, ", or give the part that is left by `roll`");
  }
  const auto list = as_list(reading, *item, kRollAngle, 2);
  if (!list) {
    return std::nullopt;
  }
  const Bounds roll = {(*list)[0].si, (*list)[1].si};
  if (!(roll.low > 0)) {
    report(reading, *item,
           "must begin above 0: on the base circle the involute has a cusp, its radius of curvature is 0");
  } else if (!(roll.width() > 0)) {
    report(reading, *item, "must end above where it begins");
  }
  return roll;
}

InvoluteTooth read_tooth(TableReader& table, std::optional<std::int64_t> most = std::nullopt) {
  InvoluteTooth tooth;
  tooth.module = table.need_quantity("module", kInvoluteSize);
  const auto teeth = table.need("teeth", "a number of teeth");
  const auto count = teeth ? as_integer(table.reading(), *teeth) : std::nullopt;
  if (count && *count < 3) report(table.reading(), *teeth, "must be at least 3");
  if (count && most && *count > *most) {
    report(table.reading(), *teeth,
           fmt::format("must be at most {}: the flanks that work are curves of type `involute`", *most));
  }
  tooth.teeth = static_cast<double>(count.value_or(20));
  tooth.pressure_angle = table.quantity("pressure_angle", kRollAngle, tooth.pressure_angle);
  if (!(tooth.pressure_angle > 0 && tooth.pressure_angle < kPi / 3)) {
    if (const auto item = table.take("pressure_angle")) {
      report(table.reading(), *item, "must be above 0 and below 60 deg");
    }
  }
  tooth.profile_shift = table.quantity("profile_shift", {dimension::kNumber});
  tooth.backlash = table.quantity("backlash", {dimension::kLength, Sign::kNotNegative});
  return tooth;
}

void refuse_tooth_keys(TableReader& table) {
  for (const char* key : {"teeth", "pressure_angle", "profile_shift", "backlash", "tooth"}) {
    table.refuse(key, "goes with `module`, in place of `base_radius`", "module");
  }
}

}  // namespace

std::optional<ContourPiece> involute_piece(TableReader& table) {
  const Mistakes mistakes(table.reading());
  Involute involute;
  involute.center_B = table.need_vector("center", dimension::kLength);
  const auto choice = table.take("hand", as_choice, {"left", "right"});
  involute.hand = choice == 1U ? Hand::kRight : Hand::kLeft;
  std::optional<Bounds> roll;
  if (table.take("module")) {
    table.refuse("base_radius", "follows from `module`, `teeth` and `pressure_angle`: leave it out");
    table.refuse("start", "follows from `tooth`, the angle of the tooth's centre line");
    const InvoluteTooth tooth = read_tooth(table);
    const double middle = table.quantity("tooth", kRollAngle);
    if (!mistakes.none()) {
      table.knows({"roll"});
      return std::nullopt;
    }
    involute.base_radius = base_radius(tooth);
    involute.start = middle + (choice == 1U ? -1 : 1) * half_angle_at_base(tooth);
    roll = read_roll(table, &tooth);
  } else {
    refuse_tooth_keys(table);
    table.instead({"module"});
    const auto value = table.need("base_radius", "the radius of the base circle (or module and teeth)",
                                  as_quantity, kInvoluteSize);
    involute.base_radius = value ? value->si : 1;
    involute.start = table.quantity("start", kRollAngle);
    roll = read_roll(table, nullptr);
  }
  if (!mistakes.none() || !roll) {
    return std::nullopt;
  }
  involute.roll = *roll;
  return involute_span(involute);
}

std::optional<NamedCurve> read_involute(TableReader& table) {
  auto piece = involute_piece(table);
  return piece ? curve_of(table, {{*std::move(piece)}}) : std::nullopt;
}

std::optional<NamedCurve> read_gear(TableReader& table) {
  const Mistakes mistakes(table.reading());
  GearShape gear;
  gear.center_B = table.need_vector("center", dimension::kLength);
  gear.tooth = read_tooth(table, kMostTeeth);
  gear.angle = table.quantity("tooth", kRollAngle);
  if (!mistakes.none()) {
    return std::nullopt;
  }
  const auto roll = whole_roll(table, gear.tooth, "");
  if (!roll) {
    return std::nullopt;
  }
  if (!(half_angle_at_roll(gear.tooth, roll->high) > 0)) {
    report_whole(table,
                 "the teeth are pointed, their flanks meet inside the tip circle: less `profile_shift` or "
                 "`backlash`");
    return std::nullopt;
  }
  if (!(half_angle_at_roll(gear.tooth, roll->low) < kPi / gear.tooth.teeth)) {
    report_whole(table, "there is no space between the teeth at their root: less `profile_shift`");
    return std::nullopt;
  }
  Outline outline;
  const auto spans = gear_outline(gear);
  outline.pieces.assign(spans.begin(), spans.end());
  outline.closed = true;
  outline.tolerance = kDefaultGap * size_of(outline.pieces);
  return curve_of(table, std::move(outline));
}

}  // namespace higherpair::io_detail
