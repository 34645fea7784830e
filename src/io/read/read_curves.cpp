#include "read_boundary.hpp"
#include "reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace higherpair::io_detail {
namespace {

constexpr Expected kAnyAngle = {dimension::kAngle};
constexpr Expected kSize = {dimension::kLength, Sign::kPositive};

// A curve as read from its table; an error of the curve as a whole is reported at the item `key_of_error`.
struct CurveReading {
  CurveResult result;
  std::string key_of_error;
};

std::array<double, 2> read_semi_axes(TableReader& table) {
  const auto list = table.need("semi_axes", "[a, b]", as_list, kSize, 2);
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

// x and y of the equation are in the profile's length unit L. With x and y in metres, and the equation
// multiplied by L²:
//   A x² + B y² + C x y + L (D x + E y) + L² F = 0.
// Scaling by a power of two first avoids overflow and underflow.
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
  const auto list = table.need("coefficients", "[A, B, C, D, E, F]", as_list, {dimension::kNumber}, 6);
  const auto near_B = table.take("near", as_vector, dimension::kLength);
  std::array<double, 6> k = {1, 1, 0, 0, 0, -1};
  for (std::size_t i = 0; list && i < k.size(); ++i) {
    k[i] = (*list)[i].value;
  }
  return {make_conic(coefficients_in_metres(k, table.reading().units), side, near_B), "coefficients"};
}

CurveReading read_line(TableReader& table, Side /*side*/) {
  const Vector2d point = table.need_vector("point", dimension::kLength);
  const auto normal = table.need("normal", "the outward normal, [nx, ny] or an angle", as_direction);
  return {make_line(point, normal.value_or(Vector2d::UnitX())), "normal"};
}

CurveReading read_point(TableReader& table, Side /*side*/) {
  return {make_point(table.need_vector("at", dimension::kLength)), "at"};
}

struct ConicType {
  std::string_view name;
  CurveReading (*read)(TableReader& table, Side side);
  bool has_sides;
};

constexpr std::array<ConicType, 7> kConicTypes = {{
    {"conic", read_conic, true},
    {"circle", read_circle, true},
    {"ellipse", read_ellipse, true},
    {"parabola", read_parabola, true},
    {"hyperbola", read_hyperbola, true},
    {"line", read_line, false},
    {"point", read_point, false},
}};

struct BoundaryType {
  std::string_view name;
  std::optional<NamedCurve> (*read)(TableReader& table);
};

constexpr std::array<BoundaryType, 7> kBoundaryTypes = {{
    {"arc", read_arc},
    {"segment", read_segment},
    {"chain", read_chain},
    {"spline", read_spline},
    {"involute", read_involute},
    {"gear", read_gear},
    {"dxf", read_dxf_curve},
}};

// Types whose curve depends on a contact and a law, or on another curve.
constexpr std::string_view kCam = "cam";
constexpr std::string_view kOffset = "offset";

std::vector<std::string> curve_type_names() {
  std::vector<std::string> names;
  for (const ConicType& type : kConicTypes) {
    names.emplace_back(type.name);
  }
  for (const BoundaryType& type : kBoundaryTypes) {
    names.emplace_back(type.name);
  }
  names.emplace_back(kCam);
  names.emplace_back(kOffset);
  return names;
}

Side read_side(TableReader& table, const ConicType& type) {
  if (!type.has_sides) {
    table.refuse("side", "a line or point has no sides to choose from");
    return Side::kInside;
  }
  return table.take("side", as_choice, {"inside", "outside"}) == 1U ? Side::kOutside : Side::kInside;
}

std::optional<NamedCurve> read_conic_curve(TableReader& table, const ConicType& type) {
  Reading& reading = table.reading();
  const Mistakes mistakes(reading);
  const Side side = read_side(table, type);
  const CurveReading curve = type.read(table, side);
  if (!mistakes.none()) {
    return std::nullopt;
  }
  if (!curve.result) {
    report(reading, *table.take(curve.key_of_error), describe(curve.result.error()));
    return std::nullopt;
  }
  return NamedCurve{"", *curve.result};
}

// Reads the curves of one body. An offset waits until its source curve is known.
class CurvesReader {
public:
  CurvesReader(Reading& reading, Body& body, LateCurves& late)
      : reading_(reading), body_(body), late_(late) {}

  void read(const Item& item) {
    for_each_table(reading_, item, "a curve (a table)", [&](const std::string& name, TableReader& table) {
      body_.curves.push_back({name, {CurveKind::kCircle}});
      states_.push_back(State::kKnown);
      read_one(table, body_.curves.size() - 1);
    });
    // In each round at least one more offset can be resolved, unless the rest depend on each other in a
    // circle.
    for (std::size_t round = 0; round < offsets_.size(); ++round) {
      for (Offset& offset : offsets_) {
        resolve(offset);
      }
    }
    for (const Offset& offset : offsets_) {
      if (states_[offset.curve] == State::kWaiting) {
        report(reading_, offset.of, "an offset cannot be of itself, directly or through other offsets");
      }
    }
  }

private:
  enum class State { kKnown, kWaiting, kLate, kWrong };

  struct Offset {
    std::size_t curve = 0;
    Item of;
    std::optional<double> by;
    TableReader table;
  };

  void set(std::size_t index, std::optional<NamedCurve> curve) {
    states_[index] = curve ? State::kKnown : State::kWrong;
    if (curve) {
      curve->name = body_.curves[index].name;
      body_.curves[index] = *std::move(curve);
    }
  }

  void read_one(TableReader& table, std::size_t index) {
    const auto choice = table.need_type("a kind of curve, such as \"circle\"", curve_type_names());
    if (!choice) {
      states_[index] = State::kWrong;
      return;  // it is not known which keys belong here
    }
    if (*choice < kConicTypes.size()) {
      set(index, read_conic_curve(table, kConicTypes[*choice]));
      table.finish();
    } else if (*choice - kConicTypes.size() < kBoundaryTypes.size()) {
      table.knows({"side", "material"});
      set(index, kBoundaryTypes[*choice - kConicTypes.size()].read(table));
      table.finish();
    } else if (*choice == kConicTypes.size() + kBoundaryTypes.size()) {
      read_cam(table, index);
    } else {
      states_[index] = State::kWrong;
      const auto of = table.need("of", "the name of another curve of this body");
      const auto by = read_offset_distance(table);
      if (of) {
        states_[index] = State::kWaiting;
        offsets_.push_back({index, *of, by, table});
      }
    }
  }

  void read_cam(TableReader& table, std::size_t index) {
    states_[index] = State::kWrong;
    const auto law = table.need("law", "the name of one of [laws], which the follower is to move by");
    const auto contact = table.need("contact", "the name of the contact with the follower");
    table.knows({"side"});
    table.finish();
    if (law && contact) {
      states_[index] = State::kLate;
      Curve& curve = body_.curves[index].curve;
      curve = Curve{CurveKind::kChain};
      curve.q = 0;
      late_.flanks.push_back({body_.name, index, *law, *contact, table});
    }
  }

  // Makes an offset once its source is known; it is wrong if its source is.
  void resolve(Offset& offset) {
    if (states_[offset.curve] != State::kWaiting) {
      return;
    }
    const auto name = as_text(reading_, offset.of);
    const auto index = name ? named_thing(reading_, offset.of, *name, has_no(body_.name, "curve"),
                                          body_.curves, fmt::format("bodies.{}.curves", body_.name))
                            : std::nullopt;
    const auto source = static_cast<std::size_t>(index.value_or(0));
    if (!index || !offset.by || states_[source] == State::kWrong) {
      states_[offset.curve] = State::kWrong;
    } else if (states_[source] == State::kLate) {
      states_[offset.curve] = State::kLate;
      body_.curves[offset.curve].curve = body_.curves[source].curve;
      late_.offsets.push_back({body_.name, offset.curve, source, *offset.by, offset.table});
    } else if (states_[source] == State::kKnown) {
      set(offset.curve, read_offset(offset.table, *offset.by, body_.curves[source]));
    }
  }

  Reading& reading_;
  Body& body_;
  LateCurves& late_;
  std::vector<State> states_;
  std::vector<Offset> offsets_;
};

}  // namespace

void read_curves(Reading& reading, const Item& item, Body& body, LateCurves& late) {
  CurvesReader(reading, body, late).read(item);
}

}  // namespace higherpair::io_detail
