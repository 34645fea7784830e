#include "io/tolerances.hpp"
#include "read_boundary.hpp"

#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr Expected kAngle = {dimension::kAngle};
constexpr Expected kPieceSize = {dimension::kLength, Sign::kPositive};

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
  if (const auto circle = make_circle(arc.center, arc.radius); !circle) {
    report(table.reading(), *table.take("radius"), describe(circle.error()));
    return std::nullopt;
  }
  const double sweep = to - arc.from;
  const double turns = std::round(sweep / (2 * kPi));
  const bool whole = std::abs(sweep - 2 * kPi * turns) < kSweepRounding;
  if (sweep > 2 * kPi + kSweepRounding || (whole && turns < 1)) {
    report(table.reading(), *table.take("to"),
           fmt::format("an arc goes counter-clockwise from `from` to `to`: {} from here to there{}",
                       turns == 0  ? "0 deg"
                       : turns < 0 ? "whole turns clockwise"
                                   : "more than a turn",
                       turns < 0 ? "; for a whole circle exchange the two" : ""));
    return std::nullopt;
  }
  // From 350 to 10 is 20 degrees.
  arc.sweep = whole ? 2 * kPi : sweep - 2 * kPi * std::floor(sweep / (2 * kPi));
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

std::optional<NamedCurve> read_arc(TableReader& table) {
  auto piece = arc_piece(table);
  if (!piece) {
    return std::nullopt;
  }
  const auto& arc = std::get<ArcPiece>(*piece);
  if (arc.sweep < 2 * kPi) {
    return curve_of(table, {{*piece}, false, 0, true});
  }
  Outline circle = {{*piece}, true, arc.radius};
  circle.whole = *make_circle(arc.center, arc.radius);
  return curve_of(table, std::move(circle));
}

std::optional<NamedCurve> read_segment(TableReader& table) {
  auto piece = segment_piece(table);
  return piece ? curve_of(table, {{*std::move(piece)}}) : std::nullopt;
}

}  // namespace higherpair::io_detail
