#include "higherpair/io/diagnostic.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "io/dxf/dxf.hpp"
#include "io/tables/named_file.hpp"
#include "io/tolerances.hpp"
#include "numeric/joined_words.hpp"
#include "read_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr std::size_t kMostEndsCompared = 5000;  // takes time ~ their square

struct Drawing {
  DxfDrawing content;  // of the wanted layer only
  Item file;
  std::string name;  // of the file, as the profile has it
};

// Reads the drawing, or only the layer that the table names.
std::optional<Drawing> read_drawing(TableReader& table) {
  Reading& reading = table.reading();
  const auto item = table.need("file", "the name of a DXF file");
  const auto unit = read_file_unit(table);
  const auto layer = table.take("layer");
  const auto name = layer ? as_text(reading, *layer) : std::nullopt;
  const auto file = item ? read_named_file(table, *item, "drawing") : std::nullopt;
  if (!file || (layer && !name)) {
    return std::nullopt;
  }
  auto read = read_dxf(*file, unit, reading.units.length);
  if (!read) {
    report_in_file(table, *item, read.error().line, read.error().message);
    return std::nullopt;
  }
  const std::string name_of_file = std::get<std::string>(item->value->content);
  if (!name) {
    return Drawing{*std::move(read), *item, name_of_file};
  }
  const auto& layers = read->layers;
  const auto found = std::find(layers.begin(), layers.end(), *name);
  if (found == layers.end()) {
    report(reading, *layer,
           layers.empty()
               ? "the drawing has no lines or curves on any layer"
               : fmt::format("no line or curve is on this layer; there are {}", joined_words(layers)));
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(found - layers.begin());
  std::erase_if(read->pieces, [&](const DxfPiece& piece) { return piece.layer != index; });
  std::erase_if(read->strangers, [&](const DxfStranger& stranger) { return stranger.layer != index; });
  return Drawing{*std::move(read), *item, name_of_file};
}

double distance(const Contour& contour, const Vector2d& p) {
  double least = kInf;
  for (const SpanPtr& span : spans_of(contour.pieces)) {
    const Bounds range = span->range();
    constexpr int kParts = 16;
    for (int k = 0; k <= kParts; ++k) {
      least = std::min(least, (span->at(range.low + range.width() * k / kParts).p_B - p).norm());
    }
  }
  return least;
}

// Two ends of contours that are near each other, but do not meet.
struct NearEnds {
  Vector2d p_B, q_B;
  int p_line = 0, q_line = 0;
  double distance = kInf;
};

// The nearest ends of two open contours, if they are near enough to be meant to meet: those of this contour
// and another one, or of any.
std::optional<NearEnds> near_ends(const Drawing& drawing, const std::vector<Contour>& contours,
                                  std::optional<std::size_t> only = std::nullopt) {
  struct End {
    std::size_t contour;
    Vector2d p_B;
    int line;
  };
  std::vector<End> ends;
  std::vector<ContourPiece> pieces;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Contour& contour = contours[i];
    pieces.insert(pieces.end(), contour.pieces.begin(), contour.pieces.end());
    if (contour.closed) continue;
    const auto line = [&](int source) { return drawing.content.pieces[source].line; };
    ends.push_back({i, begin_of(contour.pieces.front()).p_B, line(contour.sources.front())});
    ends.push_back({i, end_of(contour.pieces.back()).p_B, line(contour.sources.back())});
  }
  NearEnds nearest;
  for (std::size_t i = 0; i < ends.size() && ends.size() <= kMostEndsCompared; ++i) {
    for (std::size_t k = i + 1; k < ends.size(); ++k) {
      const bool wanted = !only || ends[i].contour == *only || ends[k].contour == *only;
      const double apart = (ends[i].p_B - ends[k].p_B).norm();
      if (wanted && ends[i].contour != ends[k].contour && apart < nearest.distance) {
        nearest = {ends[i].p_B, ends[k].p_B, ends[i].line, ends[k].line, apart};
      }
    }
  }
  return nearest.distance <= kNearEnds * size_of(pieces) ? std::optional(nearest) : std::nullopt;
}

std::string text_of(const Reading& reading, const NearEnds& ends) {
  return fmt::format("{} (line {}) and {} (line {}) are {} apart: a `tolerance` above that joins them",
                     point_text(reading, ends.p_B), ends.p_line, point_text(reading, ends.q_B), ends.q_line,
                     length_text(reading, ends.distance));
}

// The only contour, or of several the one nearest to `near`.
std::optional<std::size_t> choose(TableReader& table, const Drawing& drawing,
                                  const std::vector<Contour>& contours) {
  const Reading& reading = table.reading();
  const auto point = table.take("near", as_vector, dimension::kLength);
  if (contours.size() == 1 || point) {
    std::vector<double> distances;
    for (const Contour& contour : contours) {
      distances.push_back(point ? distance(contour, *point) : 0);
    }
    return static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) - distances.begin());
  }
  std::set<std::string> layers;
  std::vector<std::string> places;
  for (const Contour& contour : contours) {
    const DxfPiece& first = drawing.content.pieces[contour.sources.front()];
    layers.insert(drawing.content.layers[first.layer]);
    constexpr std::size_t kShown = 4;
    if (places.size() < kShown) {
      places.push_back(
          fmt::format("{} (line {})", point_text(reading, begin_of(contour.pieces.front()).p_B), first.line));
    }
  }
  const auto ends = near_ends(drawing, contours);
  report_whole(
      table,
      fmt::format("the drawing has {} contours, from {}{}; {}say which one with {}`near = [x, y]`",
                  contours.size(), joined_words(places), contours.size() > places.size() ? ", …" : "",
                  ends ? fmt::format("the ends {}; else ", text_of(reading, *ends)) : "",
                  layers.size() > 1 ? fmt::format("`layer` ({}) or ",
                                                  joined_words(std::vector(layers.begin(), layers.end())))
                                    : ""));
  return std::nullopt;
}

// Trailing zeros may have been left out, so that the piece with the most decimals shows how many were kept.
DxfDecimals joint_decimals(const DxfDecimals& a, const DxfDecimals& b) {
  return {std::max(a.lengths, b.lengths), std::max(a.bulges, b.bulges), std::max(a.angles, b.angles)};
}

// Of the pieces that have ends to join: a full circle is a contour of its own.
DxfDecimals end_decimals(const DxfDrawing& drawing) {
  DxfDecimals decimals;
  for (const DxfPiece& piece : drawing.pieces) {
    decimals = piece.whole ? decimals : joint_decimals(decimals, piece.decimals);
  }
  return decimals;
}

DxfDecimals contour_decimals(const DxfDrawing& drawing, const Contour& contour) {
  DxfDecimals decimals;
  for (const int source : contour.sources) {
    decimals = joint_decimals(decimals, drawing.pieces[source].decimals);
  }
  return decimals;
}

// The step to which coordinates are rounded [m]; 0 if they have so few decimals that they may be meant as
// they are, or more than a drawing program rounds to.
double rounding_of(const DxfDrawing& drawing, const DxfDecimals& decimals) {
  const bool rounded = decimals.lengths >= kLeastRoundedDecimals && decimals.lengths <= kMostRoundedDecimals;
  return rounded ? std::pow(10, -decimals.lengths) * drawing.unit : 0;
}

void undo_rounding(const DxfDrawing& drawing, Contour& contour) {
  const DxfDecimals decimals = contour_decimals(drawing, contour);
  const double step = rounding_of(drawing, decimals);
  if (step == 0) {
    return;
  }
  const auto rounding_of_sweep = [&](int source) -> SweepRounding {
    switch (drawing.pieces[source].sweep) {
      case DxfSweep::kBulge:  // half a step of tan(sweep / 4)
        return {2 * std::pow(10, -decimals.bulges), false};
      case DxfSweep::kAngles:  // half a step of both angles
        return {std::pow(10, -decimals.angles) * kPi / 180, true};
      case DxfSweep::kNone:
        break;
    }
    return {};
  };
  std::vector<SweepRounding> sweeps(contour.sources.size());
  std::transform(contour.sources.begin(), contour.sources.end(), sweeps.begin(), rounding_of_sweep);
  higherpair::undo_rounding(contour.pieces, contour.closed, step, sweeps);
}

void report_open(TableReader& table, const Drawing& drawing, const std::vector<Contour>& contours,
                 std::size_t index, double tolerance) {
  const Reading& reading = table.reading();
  const Contour& contour = contours[index];
  const auto line = [&](int piece) { return drawing.content.pieces[piece].line; };
  const Vector2d begin = begin_of(contour.pieces.front()).p_B;
  const Vector2d end = end_of(contour.pieces.back()).p_B;
  const auto ends = near_ends(drawing, contours, index);
  report_in_file(
      table, drawing.file, line(contour.sources.back()),
      fmt::format("the contour does not close: nothing goes on at {} (line {}), and it begins at {} "
                  "(line {}), {} away; ends within `tolerance` ({}) meet{}",
                  point_text(reading, end), line(contour.sources.back()), point_text(reading, begin),
                  line(contour.sources.front()), length_text(reading, (end - begin).norm()),
                  length_text(reading, tolerance),
                  ends ? fmt::format("; the ends {}", text_of(reading, *ends)) : ""));
}

void report_join(TableReader& table, const Drawing& drawing, const JoinFault& fault) {
  std::vector<int> lines;
  for (const int piece : fault.pieces) {
    lines.push_back(drawing.content.pieces[piece].line);
  }
  std::sort(lines.begin(), lines.end());
  std::vector<std::string> numbers;
  for (const int line : lines) {
    numbers.push_back(std::to_string(line));
  }
  report_in_file(
      table, drawing.file, lines.front(),
      fmt::format("more than two ends meet at {} (lines {}): a contour goes on in one way only; put "
                  "it on a layer of its own, and draw nothing twice",
                  point_text(table.reading(), fault.at_B), joined_words(numbers)));
}

void report_nothing(TableReader& table, const Drawing& drawing) {
  const auto& strangers = drawing.content.strangers;
  report_whole(table,
               strangers.empty()
                   ? "the drawing has no lines or curves here"
                   : fmt::format("the drawing has no lines or curves here, but {} on line {}, which is not "
                                 "read: take it apart (explode) in the drawing program",
                                 strangers.front().type, strangers.front().line));
}

}  // namespace

std::optional<NamedCurve> read_dxf_curve(TableReader& table) {
  const double given = table.quantity("tolerance", {dimension::kLength, Sign::kNotNegative}, -1);
  const auto drawing = read_drawing(table);
  if (!drawing) {
    table.knows({"near"});
    return std::nullopt;
  }
  std::vector<ContourPiece> pieces;
  for (const DxfPiece& piece : drawing->content.pieces) {
    pieces.push_back(piece.piece);
  }
  if (pieces.empty()) {
    report_nothing(table, *drawing);
    return std::nullopt;
  }
  const double size = size_of(pieces);
  const double rounding =
      std::min(kGapInSteps * rounding_of(drawing->content, end_decimals(drawing->content)),
               kLargestRoundingGap * size);
  const double tolerance = given >= 0 ? given : std::max(kDefaultGap * size, rounding);
  auto contours = join(pieces, tolerance);
  if (!contours) {
    report_join(table, *drawing, contours.error());
    return std::nullopt;
  }
  const auto index = choose(table, *drawing, *contours);
  if (!index) {
    return std::nullopt;
  }
  Contour& contour = (*contours)[*index];
  if (!contour.closed) {
    report_open(table, *drawing, *contours, *index, tolerance);
    return std::nullopt;
  }
  undo_rounding(drawing->content, contour);
  Outline outline = {std::move(contour.pieces), true, tolerance};
  const auto piece_at = [&](int source) -> const DxfPiece& { return drawing->content.pieces[source]; };
  for (const int source : contour.sources) {
    outline.names.push_back(
        fmt::format("the {} on line {} of {}", piece_at(source).type, piece_at(source).line, drawing->name));
  }
  if (contour.sources.size() == 1) {
    outline.whole = piece_at(contour.sources.front()).whole;
  }
  return curve_of(table, std::move(outline));
}

}  // namespace higherpair::io_detail
