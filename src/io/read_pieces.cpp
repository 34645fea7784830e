#include "higherpair/geometry/involute_span.hpp"
#include "read_boundary.hpp"

#include <cmath>

#include <fmt/format.h>

namespace higherpair::io_detail {
namespace {

constexpr Expected kAngle = {dimension::kAngle};
constexpr Expected kPieceSize = {dimension::kLength, Sign::kPositive};

// What was read, unless there was a mistake since.
class Mistakes {
public:
  explicit Mistakes(const Reading& reading) : reading_(reading), before_(reading.mistakes.size()) {}
  [[nodiscard]] bool none() const { return reading_.mistakes.size() == before_; }

private:
  const Reading& reading_;
  std::size_t before_;
};

// The roll of a flank, both angles > 0.
std::optional<Bounds> read_roll(TableReader& table, const InvoluteTooth* tooth) {
  Reading& reading = table.reading();
  const auto item = tooth != nullptr ? table.take("roll") : table.need("roll", "[from, to], angles of roll");
  if (!item && tooth == nullptr) {
    return std::nullopt;
  }
  if (!item) {
    const Bounds roll = {roll_at_root(*tooth), roll_at_tip(*tooth)};
    if (roll.low <= 0) {
      report_whole(table,
                   "a rack cuts into the base circle of so few teeth (undercut): give the part that is "
                   "left by `roll`, or more `profile_shift`");
    } else if (roll.width() <= 0) {
      report_whole(table, "the tip circle lies inside the root: less negative `profile_shift`");
    }
    return roll;
  }
  const auto list = as_list(reading, *item, kAngle, 2);
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

InvoluteTooth read_tooth(TableReader& table) {
  InvoluteTooth tooth;
  tooth.module = table.need_quantity("module", kPieceSize);
  const auto teeth = table.need("teeth", "a number of teeth");
  const auto count = teeth ? as_integer(table.reading(), *teeth) : std::nullopt;
  if (count && *count < 3) report(table.reading(), *teeth, "must be at least 3");
  tooth.teeth = static_cast<double>(count.value_or(20));
  tooth.pressure_angle = table.quantity("pressure_angle", kAngle, tooth.pressure_angle);
  if (!(tooth.pressure_angle > 0 && tooth.pressure_angle < kPi / 3)) {
    if (const auto item = table.take("pressure_angle")) {
      report(table.reading(), *item, "must be above 0 and below 60 deg");
    }
  }
  tooth.profile_shift = table.quantity("profile_shift", {dimension::kNumber});
  return tooth;
}

void refuse_tooth_keys(TableReader& table) {
  for (const char* key : {"teeth", "pressure_angle", "profile_shift", "tooth"}) {
    table.refuse(key, "goes with `module`, in place of `base_radius`");
  }
}

}  // namespace

std::optional<ContourPiece> arc_piece(TableReader& table) {
  const Mistakes mistakes(table.reading());
  ArcPiece arc;
  arc.center = table.need_vector("center", dimension::kLength);
  arc.radius = table.need_quantity("radius", kPieceSize);
  arc.from = table.need_quantity("from", kAngle);
  const double to = table.need_quantity("to", kAngle);
  if (!mistakes.none()) {
    return std::nullopt;
  }
  const double sweep = to - arc.from;
  constexpr double kRounding = 1e-12;
  if (std::abs(sweep) < kRounding || sweep > 2 * kPi + kRounding) {
    report(table.reading(), *table.take("to"),
           fmt::format("an arc goes counter-clockwise from `from` to `to`: {} from here to there",
                       sweep > 0 ? "more than a turn" : "0 deg"));
    return std::nullopt;
  }
  // From 350 to 10 is 20 degrees.
  arc.sweep = sweep > 2 * kPi - kRounding ? 2 * kPi : sweep - 2 * kPi * std::floor(sweep / (2 * kPi));
  return arc;
}

std::optional<ContourPiece> segment_piece(TableReader& table) {
  const Mistakes mistakes(table.reading());
  const LinePiece line = {table.need_vector("from", dimension::kLength),
                          table.need_vector("to", dimension::kLength)};
  if (mistakes.none() && line.from == line.to) {
    report(table.reading(), *table.take("to"), "is where it begins: a segment has two different ends");
  }
  return mistakes.none() ? std::optional<ContourPiece>(line) : std::nullopt;
}

std::optional<ContourPiece> involute_piece(TableReader& table) {
  const Mistakes mistakes(table.reading());
  Involute involute;
  involute.center_B = table.need_vector("center", dimension::kLength);
  const auto hand = table.take("hand");
  const auto choice = hand ? as_choice(table.reading(), *hand, {"left", "right"}) : std::nullopt;
  involute.hand = choice == 1U ? Hand::kRight : Hand::kLeft;
  std::optional<Bounds> roll;
  if (table.take("module")) {
    table.refuse("base_radius", "follows from `module`, `teeth` and `pressure_angle`: leave it out");
    table.refuse("start", "follows from `tooth`, the angle of the tooth's centre line");
    const InvoluteTooth tooth = read_tooth(table);
    const double middle = table.quantity("tooth", kAngle);
    if (!mistakes.none()) {
      (void)table.take("roll");
      return std::nullopt;
    }
    involute.base_radius = base_radius(tooth);
    involute.start = middle + (choice == 1U ? -1 : 1) * half_angle_at_base(tooth);
    roll = read_roll(table, &tooth);
  } else {
    refuse_tooth_keys(table);
    const auto radius = table.need("base_radius", "the radius of the base circle (or module and teeth)");
    const auto value = radius ? as_quantity(table.reading(), *radius, kPieceSize) : std::nullopt;
    involute.base_radius = value ? value->si : 1;
    involute.start = table.quantity("start", kAngle);
    roll = read_roll(table, nullptr);
  }
  if (!mistakes.none() || !roll) {
    return std::nullopt;
  }
  involute.roll = *roll;
  return involute_span(involute);
}

std::optional<NamedCurve> read_arc(TableReader& table) {
  auto piece = arc_piece(table);
  if (!piece) {
    return std::nullopt;
  }
  const auto& arc = std::get<ArcPiece>(*piece);
  if (arc.sweep < 2 * kPi) {
    return curve_of(table, {{*piece}, false, 0, true});
  }
  // All of a circle keeps its closed forms.
  auto curve = curve_of(table, {{*piece}, true, arc.radius});
  if (curve) {
    const Vector2d n_B = curve->boundary->samples().front().point.n_B;
    const Vector2d arm = curve->boundary->samples().front().point.p_B - arc.center;
    curve->curve = *make_circle(arc.center, arc.radius, n_B.dot(arm) > 0 ? Side::kInside : Side::kOutside);
    curve->boundary = nullptr;
  }
  return curve;
}

std::optional<NamedCurve> read_segment(TableReader& table) {
  auto piece = segment_piece(table);
  return piece ? curve_of(table, {{*std::move(piece)}}) : std::nullopt;
}

std::optional<NamedCurve> read_involute(TableReader& table) {
  auto piece = involute_piece(table);
  return piece ? curve_of(table, {{*std::move(piece)}}) : std::nullopt;
}

}  // namespace higherpair::io_detail
