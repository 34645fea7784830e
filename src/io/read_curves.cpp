#include "reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair::io_detail {
namespace {

constexpr Expected kAnyAngle = {dimension::kAngle};
constexpr Expected kSize = {dimension::kLength, Sign::kPositive};

// A curve from its table; an error of the curve as a whole concerns the item at `key_of_error`.
struct CurveReading {
  CurveResult result;
  std::string key_of_error;
};

std::array<double, 2> read_semi_axes(TableReader& table) {
  const auto item = table.need("semi_axes", "[a, b]");
  const auto list = item ? as_list(table.reading(), *item, kSize, 2) : std::nullopt;
  return list ? std::array{(*list)[0].si, (*list)[1].si} : std::array{1.0, 1.0};
}

CurveReading read_circle(TableReader& table, Side side) {
  const Vector2d center = table.need_vector("center", dimension::kLength);
  return {make_circle(center, table.need_quantity("radius", kSize), side), "radius"};
}

CurveReading read_ellipse(TableReader& table, Side side) {
  const Vector2d center = table.need_vector("center", dimension::kLength);
  const auto axes = read_semi_axes(table);
  return {make_ellipse(center, axes, table.quantity("rotation", kAnyAngle), side), "semi_axes"};
}

CurveReading read_parabola(TableReader& table, Side side) {
  const Vector2d vertex = table.need_vector("vertex", dimension::kLength);
  const double focal_length = table.need_quantity("focal_length", kSize);
  return {make_parabola(vertex, focal_length, table.quantity("rotation", kAnyAngle), side), "focal_length"};
}

CurveReading read_hyperbola(TableReader& table, Side side) {
  const Vector2d center = table.need_vector("center", dimension::kLength);
  const auto axes = read_semi_axes(table);
  return {make_hyperbola(center, axes, table.quantity("rotation", kAnyAngle), side), "semi_axes"};
}

// x and y of the equation are in the profile's length unit L: with metres, and the whole times L²,
//   A x² + B y² + C x y + L (D x + E y) + L² F = 0.
// A power of two first, so that neither end of the range of a double is met.
std::array<double, 6> coefficients_in_metres(std::array<double, 6> k, const Units& units) {
  const double largest = std::max({std::abs(k[0]), std::abs(k[1]), std::abs(k[2])});
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  const Scaling linear = to_si(dimension::kLength, units);
  const Scaling square = to_si(dimension::kLength * dimension::kLength, units);
  for (double& value : k) {
    value = std::ldexp(value, -exponent);
  }
  k[3] = linear.apply(k[3]);
  k[4] = linear.apply(k[4]);
  k[5] = square.apply(k[5]);
  return k;
}

CurveReading read_conic(TableReader& table, Side side) {
  Reading& reading = table.reading();
  const auto item = table.need("coefficients", "[A, B, C, D, E, F]");
  const auto list = item ? as_list(reading, *item, {dimension::kNumber}, 6) : std::nullopt;
  const auto near_item = table.take("near");
  const auto near_B = near_item ? as_vector(reading, *near_item, dimension::kLength) : std::nullopt;
  std::array<double, 6> k = {1, 1, 0, 0, 0, -1};
  for (std::size_t i = 0; list && i < k.size(); ++i) {
    k[i] = (*list)[i].value;
  }
  return {make_conic(coefficients_in_metres(k, reading.units), side, near_B), "coefficients"};
}

CurveReading read_line(TableReader& table, Side /*side*/) {
  const Vector2d point = table.need_vector("point", dimension::kLength);
  const auto item = table.need("normal", "the outward normal, [nx, ny] or an angle");
  const auto normal = item ? as_direction(table.reading(), *item) : std::nullopt;
  return {make_line(point, normal.value_or(Vector2d::UnitX())), "normal"};
}

CurveReading read_point(TableReader& table, Side /*side*/) {
  return {make_point(table.need_vector("at", dimension::kLength)), "at"};
}

struct CurveType {
  std::string_view name;
  CurveReading (*read)(TableReader& table, Side side);
  bool has_sides;
};

constexpr std::array<CurveType, 7> kCurveTypes = {{
    {"conic", read_conic, true},
    {"circle", read_circle, true},
    {"ellipse", read_ellipse, true},
    {"parabola", read_parabola, true},
    {"hyperbola", read_hyperbola, true},
    {"line", read_line, false},
    {"point", read_point, false},
}};

std::vector<std::string> curve_type_names() {
  std::vector<std::string> names;
  names.reserve(kCurveTypes.size());
  for (const CurveType& type : kCurveTypes) {
    names.emplace_back(type.name);
  }
  return names;
}

Side read_side(TableReader& table, const CurveType& type) {
  if (!type.has_sides) {
    table.refuse("side", "a line or point has no sides to choose from");
    return Side::kInside;
  }
  const auto item = table.take("side");
  const auto choice = item ? as_choice(table.reading(), *item, {"inside", "outside"}) : std::nullopt;
  return choice == 1U ? Side::kOutside : Side::kInside;
}

std::optional<Curve> read_curve(TableReader& table) {
  Reading& reading = table.reading();
  const auto item = table.need("type", "a kind of curve, such as \"circle\"");
  const auto choice = item ? as_choice(reading, *item, curve_type_names()) : std::nullopt;
  if (!choice) {
    return std::nullopt;  // which keys belong here is unknown
  }
  const CurveType& type = kCurveTypes[*choice];
  const std::size_t mistakes_before = reading.mistakes.size();
  const Side side = read_side(table, type);
  const CurveReading curve = type.read(table, side);
  const bool parts_are_right = reading.mistakes.size() == mistakes_before;
  table.finish();
  if (!parts_are_right) {
    return std::nullopt;
  }
  if (!curve.result) {
    report(reading, *table.take(curve.key_of_error), describe(curve.result.error()));
    return std::nullopt;
  }
  return *curve.result;
}

}  // namespace

void read_curves(Reading& reading, const Item& item, Body& body) {
  const Curve placeholder = {CurveKind::kCircle};
  for_each_table(reading, item, "a curve (a table)", [&](const std::string& name, TableReader& table) {
    body.curves.push_back({name, read_curve(table).value_or(placeholder)});
  });
}

}  // namespace higherpair::io_detail
