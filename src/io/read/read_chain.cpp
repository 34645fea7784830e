#include "io/tolerances.hpp"
#include "read_boundary.hpp"

#include <algorithm>
#include <array>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

struct PieceType {
  std::string name;
  std::optional<ContourPiece> (*read)(TableReader& table);
  bool either_way;  // its direction is not the user's choice but follows from its neighbours
};

const std::array<PieceType, 4>& piece_types() {
  static const std::array<PieceType, 4> kTypes = {
      {{"arc", arc_piece, true},
       {"segment", segment_piece, false},
       {"spline", [](TableReader& table) { return spline_piece(table, false); }, false},
       {"involute", involute_piece, true}}};
  return kTypes;
}

struct ChainPiece {
  ContourPiece piece;
  bool either_way = false;
};

std::optional<ChainPiece> read_piece(TableReader& table) {
  std::vector<std::string> names;
  for (const PieceType& type : piece_types()) {
    names.push_back(type.name);
  }
  const auto choice = table.need_type("a kind of span, such as \"arc\"", names);
  if (!choice) {
    return std::nullopt;
  }
  for (const char* key : {"side", "material"}) {
    table.refuse(key, "belongs to the chain as a whole, not to one of its spans");
  }
  const PieceType& type = piece_types()[*choice];
  auto piece = type.read(table);
  table.finish();
  return piece ? std::optional(ChainPiece{*std::move(piece), type.either_way}) : std::nullopt;
}

std::optional<std::vector<ChainPiece>> read_pieces(TableReader& table, const Item& item) {
  Reading& reading = table.reading();
  const auto items = as_items(reading, item, "a list of spans, [{ type = \"arc\", … }, …]");
  std::vector<ChainPiece> pieces;
  for (const Item& entry : items.value_or(std::vector<Item>{})) {
    auto reader = as_reader(reading, entry, "a span (a table)");
    auto piece = reader ? read_piece(*reader) : std::nullopt;
    if (piece) pieces.push_back(*std::move(piece));
  }
  return items && pieces.size() == items->size() ? std::optional(std::move(pieces)) : std::nullopt;
}

double gap(const ContourPiece& a, const ContourPiece& b) {
  return (begin_of(b).p_B - end_of(a).p_B).norm();
}

// Directs arcs and involutes so that each begins as near as possible to the end of the piece before it, and
// the first one ends as near as possible to the second.
std::vector<ContourPiece> put_in_line(const std::vector<ChainPiece>& given) {
  std::vector<ContourPiece> pieces;
  for (const ChainPiece& one : given) {
    pieces.push_back(one.piece);
  }
  const auto least = [&](const ContourPiece& first) {
    const double straight = gap(first, pieces[1]);
    return given[1].either_way ? std::min(straight, gap(first, reversed(pieces[1]))) : straight;
  };
  if (pieces.size() > 1 && given[0].either_way && least(reversed(pieces[0])) < least(pieces[0])) {
    pieces[0] = reversed(pieces[0]);
  }
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const ContourPiece back = reversed(pieces[i]);
    if (given[i].either_way && gap(pieces[i - 1], back) < gap(pieces[i - 1], pieces[i])) {
      pieces[i] = back;
    }
  }
  return pieces;
}

void report_fillet(TableReader& table, const Outline& outline, const FilletFault& fault, double radius) {
  const Reading& reading = table.reading();
  const auto piece = static_cast<std::size_t>(fault.piece);
  const std::string corner =
      fmt::format("the corner at {} between {} and {}", point_text(reading, fault.at_B), outline.names[piece],
                  outline.names[(piece + 1) % outline.names.size()]);
  std::string rule;
  if (fault.kind == FilletFault::Kind::kOther) {
    rule = fmt::format("rounds corners between segments and arcs only: not {}", corner);
  } else if (fault.kind == FilletFault::Kind::kCusp) {
    rule = fmt::format("the curve reverses its direction, there is no rounding {}", corner);
  } else {
    const double largest = largest_fillet(outline.pieces, outline.closed, radius);
    rule = fmt::format("is too large for {}; {}", corner,
                       largest > 0 ? fmt::format("up to {} fits everywhere",
                                                 with_unit(largest, dimension::kLength, reading.units, 3))
                                   : "no smaller one fits either");
  }
  report(table.reading(), *table.take("fillet"), rule);
}

}  // namespace

std::optional<NamedCurve> read_chain(TableReader& table) {
  const auto item = table.need("spans", "a list of spans, [{ type = \"arc\", … }, …]");
  const double fillet = table.quantity("fillet", {dimension::kLength, Sign::kNotNegative});
  Outline outline;
  outline.has_fillet = true;
  outline.closed = table.flag("closed", true);
  const double tolerance = table.quantity("tolerance", {dimension::kLength, Sign::kNotNegative}, -1);
  const auto pieces = item ? read_pieces(table, *item) : std::nullopt;
  if (!pieces) {
    return std::nullopt;
  }
  outline.pieces = put_in_line(*pieces);
  outline.tolerance = tolerance >= 0 ? tolerance : kDefaultGap * size_of(outline.pieces);
  for (std::size_t i = 0; i < pieces->size(); ++i) {
    outline.names.push_back(fmt::format("spans.{}", i));
  }
  if (fillet == 0 || report_gaps(table, outline)) {
    return fillet == 0 ? curve_of(table, std::move(outline)) : std::nullopt;
  }
  close_gaps(outline.pieces, outline.closed);
  auto rounded = with_fillets(outline.pieces, outline.closed, fillet);
  if (!rounded) {
    report_fillet(table, outline, rounded.error(), fillet);
    return std::nullopt;
  }
  outline.pieces = std::move(rounded->pieces);
  std::vector<std::string> names;
  for (const int source : rounded->sources) {
    names.push_back(outline.names[source]);
  }
  outline.names = std::move(names);
  return curve_of(table, std::move(outline));
}

}  // namespace higherpair::io_detail
