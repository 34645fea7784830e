#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <cmath>

namespace higherpair {
namespace {

constexpr int kHalvings = 12;

// The locus of the centres of circles of one radius that are tangent to a piece on one side: a line or a
// circle.
struct Track {
  bool straight = true;
  Vector2d p = Vector2d::Zero();  // a point of the line, or the centre
  Vector2d t = Vector2d::UnitX();
  double radius = 0;
};

// The locus on the left (side = 1) or right (-1) of a piece.
Track track(const ContourPiece& piece, double radius, double side) {
  if (const auto* line = std::get_if<LinePiece>(&piece)) {
    const Vector2d t = (line->to - line->from).normalized();
    return {true, line->from + side * radius * perp(t), t, 0};
  }
  const auto& arc = std::get<ArcPiece>(piece);
  return {false, arc.center, Vector2d::UnitX(), arc.radius - side * std::copysign(radius, arc.sweep)};
}

std::vector<Vector2d> on_line(const Track& line, const Track& circle) {
  const Vector2d foot = line.p + (circle.p - line.p).dot(line.t) * line.t;
  const double square = circle.radius * circle.radius - (circle.p - foot).squaredNorm();
  if (!(square >= 0)) {
    return {};
  }
  return {foot + std::sqrt(square) * line.t, foot - std::sqrt(square) * line.t};
}

std::vector<Vector2d> common_points(const Track& a, const Track& b) {
  if (a.straight && b.straight) {
    const double sine = cross(a.t, b.t);
    return {a.p + cross(Vector2d(b.p - a.p), b.t) / sine * a.t};
  }
  if ((!a.straight && !(a.radius > 0)) || (!b.straight && !(b.radius > 0))) {
    return {};
  }
  if (a.straight || b.straight) {
    return a.straight ? on_line(a, b) : on_line(b, a);
  }
  const Vector2d between = b.p - a.p;
  const double distance = between.norm();
  if (!(distance > 0)) {
    return {};
  }
  const double along = (distance + (a.radius - b.radius) * (a.radius + b.radius) / distance) / 2;
  const Vector2d t = between / distance;
  return on_line({true, a.p + along * t, perp(t), 0}, a);
}

// Fraction of a piece at which a circle about `center` is tangent to it.
double part_at(const ContourPiece& piece, const Vector2d& center) {
  if (const auto* line = std::get_if<LinePiece>(&piece)) {
    const Vector2d all = line->to - line->from;
    return (center - line->from).dot(all) / all.squaredNorm();
  }
  const auto& arc = std::get<ArcPiece>(piece);
  const double middle = arc.from + arc.sweep / 2;
  return (nearest_turn(angle_of(center - arc.center), middle) - arc.from) / arc.sweep;
}

ContourPiece cut(const ContourPiece& piece, double from, double to) {
  if (const auto* line = std::get_if<LinePiece>(&piece)) {
    const Vector2d all = line->to - line->from;
    return LinePiece{line->from + from * all, to == 1 ? line->to : Vector2d(line->from + to * all)};
  }
  const auto& arc = std::get<ArcPiece>(piece);
  return ArcPiece{arc.center, arc.radius, arc.from + from * arc.sweep, (to - from) * arc.sweep};
}

bool is_plain(const ContourPiece& piece) {
  return !std::holds_alternative<SpanPtr>(piece);
}

struct Rounding {
  ContourPiece before;
  ArcPiece arc;
  ContourPiece after;
};

std::optional<Rounding> rounding(const ContourPiece& a, const ContourPiece& b, double turn, double radius) {
  const double side = turn > 0 ? 1 : -1;
  std::optional<Rounding> best;
  double most = -1;
  for (const Vector2d& center : common_points(track(a, radius, side), track(b, radius, side))) {
    const double end = part_at(a, center);
    const double begin = part_at(b, center);
    // The one nearest to the corner cuts the least off.
    if (end > kLengthRounding && end < 1 && begin > 0 && begin < 1 - kLengthRounding && end - begin > most) {
      most = end - begin;
      const ContourPiece before = cut(a, 0, end);
      const ContourPiece after = cut(b, begin, 1);
      const double from = angle_of(end_of(before).p_B - center);
      const double to = angle_of(begin_of(after).p_B - center);
      const double sweep = std::remainder(to - from, 2 * kPi);
      best =
          Rounding{before, {center, radius, from, sweep * side > 0 ? sweep : sweep + side * 2 * kPi}, after};
    }
  }
  return best;
}

}  // namespace

tl::expected<Contour, FilletFault> with_fillets(const std::vector<ContourPiece>& pieces, bool closed,
                                                double radius) {
  std::vector<ContourPiece> cut_pieces = pieces;
  const std::size_t count = pieces.size();
  std::vector<std::optional<ArcPiece>> arcs(count);
  for (std::size_t i = 0; i < (closed ? count : count - 1); ++i) {
    ContourPiece& a = cut_pieces[i];
    ContourPiece& b = cut_pieces[(i + 1) % count];
    const PieceEnd end = end_of(pieces[i]);
    const Vector2d t = begin_of(pieces[(i + 1) % count]).t_B;
    const double turn = angle_from_to(end.t_B, t);
    const auto fault = [&](FilletFault::Kind kind) {
      return tl::unexpected(FilletFault{kind, static_cast<int>(i), end.p_B});
    };
    if (std::abs(turn) <= kNoTurn) {
      continue;
    }
    if (std::abs(turn) > kTurnBack) {
      return fault(FilletFault::Kind::kCusp);
    }
    if (!is_plain(a) || !is_plain(b) || &a == &b) {
      return fault(FilletFault::Kind::kOther);
    }
    const auto round = rounding(a, b, turn, radius);
    if (!round) {
      return fault(FilletFault::Kind::kTooLarge);
    }
    a = round->before;
    b = round->after;
    arcs[i] = round->arc;
  }
  Contour all;
  all.closed = closed;
  for (std::size_t i = 0; i < count; ++i) {
    all.pieces.push_back(cut_pieces[i]);
    all.sources.push_back(static_cast<int>(i));
    if (arcs[i]) {
      all.pieces.emplace_back(*arcs[i]);
      all.sources.push_back(static_cast<int>(i));
    }
  }
  return all;
}

double largest_fillet(const std::vector<ContourPiece>& pieces, bool closed, double radius) {
  double fits = 0;
  double fits_not = radius;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (fits + fits_not) / 2;
    (with_fillets(pieces, closed, middle) ? fits : fits_not) = middle;
  }
  return fits;
}

}  // namespace higherpair
