#include "higherpair/geometry/spline_span.hpp"
#include "io/tables/named_file.hpp"
#include "io/tolerances.hpp"
#include "numeric/decimal.hpp"
#include "read_boundary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr Expected kTolerance = {dimension::kLength, Sign::kNotNegative};

// Points as they were given, and where.
struct Given {
  std::vector<Vector2d> points;
  std::vector<Item> items;
  std::vector<std::string> names;  // "points.3", "line 4"
  double rounding = 0;             // of the coordinates, guessed from their digits [m]
};

std::optional<Given> points_inline(TableReader& table, const Item& item) {
  Reading& reading = table.reading();
  const auto items = as_items(reading, item, "a list of points, [[x, y], …]", 0);
  if (!items) {
    return std::nullopt;
  }
  Given given;
  given.items = *items;
  int decimals = 0;
  for (const Item& entry : *items) {
    const auto point = as_vector(reading, entry, dimension::kLength);
    if (!point) {
      return std::nullopt;
    }
    given.points.push_back(*point);
    given.names.push_back(fmt::format("points.{}", given.names.size()));
    for (const Value& number : std::get<Array>(entry.value->content)) {
      if (const auto* x = std::get_if<double>(&number.content)) {
        decimals = std::max(decimals, decimals_of(shortest_digits(*x)));
      }
    }
  }
  given.rounding = std::pow(10.0, -decimals) * to_si(dimension::kLength, reading.units).apply(1);
  return given;
}

std::optional<Given> points_in_file(TableReader& table, const Item& item) {
  const auto read = read_place_file(table, item);
  if (!read) {
    return std::nullopt;
  }
  Given given;
  for (const auto& [x, y] : read->points) {
    given.points.emplace_back(x.si, y.si);
  }
  for (const int line : read->lines) {
    given.items.push_back(item);
    given.names.push_back(fmt::format("line {}", line));
  }
  given.rounding = std::max(std::pow(10.0, -read->decimals[0]) * read->unit[0],
                            std::pow(10.0, -read->decimals[1]) * read->unit[1]);
  return given;
}

std::optional<Given> given_points(TableReader& table) {
  const auto points = table.take("points");
  const auto file = table.take("file");
  if (!file) {
    table.refuse("units", "is that of a file; these points are in the profile's unit of length");
  }
  if (points && file) {
    table.refuse("file", "the points are given already by `points`: one of the two");
    table.knows({"units"});
    return std::nullopt;
  }
  if (file) {
    return points_in_file(table, *file);
  }
  const auto list = table.need("points", "[[x, y], …] (or a `file` with them)");
  return list ? points_inline(table, *list) : std::nullopt;
}

SplineOptions read_options(TableReader& table, bool closed) {
  Reading& reading = table.reading();
  SplineOptions options;
  options.closed = closed;
  const auto degree = table.take("degree");
  const auto value = degree ? as_integer(reading, *degree) : std::nullopt;
  if (value && *value != 3 && *value != 5) {
    report(reading, *degree, "expected 3 or 5: with 5 the curvature is smooth, with 3 it has kinks");
  } else if (value) {
    options.degree = static_cast<int>(*value);
  }
  options.smoothing = table.quantity("smoothing", kTolerance);
  const auto choice = table.take("parameter", as_choice, {"arc", "centripetal"});
  options.parameter = choice == 1U ? SplineParameter::kCentripetal : SplineParameter::kArc;
  for (const auto& [key, tangent] :
       {std::pair{"first_tangent", &options.first_tangent}, {"last_tangent", &options.last_tangent}}) {
    if (closed) {
      table.refuse(key, "a closed spline has no ends");
    } else if (options.smoothing > 0) {
      table.refuse(key, "holds for a spline through its points: without `smoothing`");
    } else {
      *tangent = table.take(key, as_direction);
    }
  }
  return options;
}

std::string text_of(const Reading& reading, const Given& given, const SplineFault& fault, int degree) {
  const auto name = [&](int i) { return given.names[i]; };
  const auto place = [&](int i) { return point_text(reading, given.points[i]); };
  switch (fault.kind) {
    case SplineFault::Kind::kTooFew:
      return fmt::format("{} points are too few: degree {} takes at least {}{}", given.points.size(), degree,
                         degree + 1, degree == 5 ? ", `degree = 3` at least 4" : "");
    case SplineFault::Kind::kRepeated:
      return fmt::format("{} and {} are the same point {}: leave one out{}", name(fault.first),
                         name(fault.second), place(fault.first),
                         fault.second == 0 ? "" : " (of a corner make a chain of several splines)");
    case SplineFault::Kind::kTurnsBack:
      return fmt::format(
          "the curve reverses its direction at {}, {}: are the points in their order along the curve?",
          name(fault.first), place(fault.first));
    case SplineFault::Kind::kOpen:
      return fmt::format(
          "does not close: from {}, {}, back to {}, {}, it is {}, {:.3g} times the largest "
          "step; points are missing, or closed = false",
          name(fault.first), place(fault.first), name(0), place(0), length_text(reading, fault.distance),
          fault.factor);
    case SplineFault::Kind::kCusp:
      break;
  }
  return fmt::format(
      "the spline stops or turns back behind {}, {}: too few points for so sharp a bend, or "
      "not in their order",
      name(fault.first), place(fault.first));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Coordinates rounded to δ at points h apart: a spline of degree 5 through them has curvature errors of up to
// about 3.5 δ/h².
void note_noise(TableReader& table, const Given& given, const Span& span, double rounding, double smoothing) {
  constexpr double kAmplification = 3.5;
  constexpr std::size_t kTable = 24;  // fewer points are probably meant exactly
  if (given.points.size() < kTable || smoothing >= rounding / 2) {
    return;
  }
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < given.points.size(); ++i) {
    steps.push_back((given.points[i + 1] - given.points[i]).norm());
  }
  const double h = median(steps);
  std::vector<double> curvatures;
  constexpr int kProbes = 200;
  for (int i = 0; i <= kProbes; ++i) {
    curvatures.push_back(std::abs(span.at(span.range().low + span.range().width() * i / kProbes).kappa));
  }
  const double own = median(curvatures);
  const double noise = kAmplification * rounding / (h * h);
  if (noise < kCurvatureWorthANote * own) {
    return;
  }
  const Reading& reading = table.reading();
  const double unit = to_si(dimension::kLength, reading.units).apply(1);
  const std::string smooth = fmt::format("{:.3g}", rounding / unit);
  note_whole(
      table,
      fmt::format("points rounded to {0} {1}, {2:.3g} {1} apart, put noise of up to {3:.2g} 1/{1} into a "
                  "curvature of {4:.2g} 1/{1}, and as large a part into accelerations; `smoothing = {0}` "
                  "takes most of it away (`rounding` says how exact they are)",
                  smooth, name_of(reading.units.length), h / unit, noise * unit, own * unit));
}

struct SplineReading {
  SpanPtr span;
  Given given;
};

std::optional<SplineReading> read(TableReader& table, bool closed) {
  Reading& reading = table.reading();
  const Mistakes mistakes(reading);
  auto given = given_points(table);
  const SplineOptions options = read_options(table, closed);
  const double stated = table.quantity("rounding", kTolerance, -1);
  if (!given || !mistakes.none()) {
    return std::nullopt;
  }
  auto span = spline_span(given->points, options);
  if (!span) {
    const SplineFault& fault = span.error();
    const Mark& mark =
        fault.kind == SplineFault::Kind::kTooFew ? table.mark() : given->items[fault.first].value->mark;
    reading.mistakes.push_back(
        {mark, fmt::format("{}: {}", table.path(), text_of(reading, *given, fault, options.degree))});
    return std::nullopt;
  }
  note_noise(table, *given, **span, stated >= 0 ? stated : given->rounding, options.smoothing);
  return SplineReading{*std::move(span), *std::move(given)};
}

}  // namespace

std::optional<ContourPiece> spline_piece(TableReader& table, bool closed) {
  auto spline = read(table, closed);
  return spline ? std::optional<ContourPiece>(std::move(spline->span)) : std::nullopt;
}

std::optional<NamedCurve> read_spline(TableReader& table) {
  const bool closed = table.flag("closed", true);
  auto spline = read(table, closed);
  if (!spline) {
    return std::nullopt;
  }
  Outline outline;
  outline.closed = closed;
  outline.pieces.emplace_back(spline->span);
  outline.tolerance = kDefaultGap * size_of(outline.pieces);
  outline.points = std::move(spline->given.points);
  outline.point_names = std::move(spline->given.names);
  return curve_of(table, std::move(outline));
}

}  // namespace higherpair::io_detail
