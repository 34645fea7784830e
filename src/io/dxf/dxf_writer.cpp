#include "higherpair/io/dxf_writer.hpp"

#include "dxf_units.hpp"
#include "io/tolerances.hpp"
#include "numeric/decimal.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace higherpair {
namespace {

struct Circle {
  Vector2d center_B;
  double radius;
};

// The circle formed by a closed polyline whose arcs all lie on it, which have one centre; none for any other.
std::optional<Circle> circle_of(const ArcPolyline& line) {
  std::optional<Circle> circle;
  for (std::size_t i = 0; line.closed && i < line.vertices.size(); ++i) {
    const ArcVertex& vertex = line.vertices[i];
    const Vector2d& next = line.vertices[(i + 1) % line.vertices.size()].p_B;
    const double b = vertex.bulge;
    if (b == 0) {
      return std::nullopt;
    }
    const Vector2d chord = next - vertex.p_B;
    const Vector2d center = (vertex.p_B + next) / 2 + (1 - b * b) / (4 * b) * perp(chord);
    const double radius = chord.norm() * (1 + b * b) / (4 * std::abs(b));
    if (!circle) {
      circle = {center, radius};
    } else if ((center - circle->center_B).norm() > kOneCircle * radius) {
      return std::nullopt;
    }
  }
  return circle;
}

class Writer {
public:
  explicit Writer(Unit length) : scaling_(from_si(dimension::kLength, {.length = length})) {}

  void add(int code, std::string_view value) {
    std::string number = std::to_string(code);
    text_.append(number.size() < 3 ? 3 - number.size() : 0, ' ');
    ((text_ += number) += '\n') += value;
    text_ += '\n';
  }
  void add(int code, int value) { add(code, std::to_string(value)); }
  // Always with a decimal point, by which some programs recognise a real number.
  void number(int code, double value) {
    std::string digits;
    append_decimal(value, digits);
    if (digits.find('.') == std::string::npos) {
      digits.insert(std::min(digits.find('e'), digits.size()), ".0");
    }
    add(code, digits);
  }
  void length(int code, double metres) { number(code, scaling_.apply(metres)); }
  // A point; its height above the plane is 0.
  void place(int code, const Vector2d& p) {
    length(code, p.x());
    length(code + 10, p.y());
    number(code + 20, 0);
  }

  void variable(std::string_view name, int code, std::string_view value) {
    add(9, name);
    add(code, value);
  }

  [[nodiscard]] std::string take() { return std::move(text_); }

private:
  Scaling scaling_;
  std::string text_;
};

// Each outline's own layer.
std::vector<std::string> layers_of(const std::vector<DxfOutline>& outlines) {
  constexpr std::size_t kLongest = 31;
  std::vector<std::string> layers;
  std::set<std::string> taken;
  for (const DxfOutline& outline : outlines) {
    std::string layer = outline.layer.substr(0, kLongest);
    for (int k = 2; !taken.insert(layer).second; ++k) {
      const std::string number = "-" + std::to_string(k);
      layer = outline.layer.substr(0, kLongest - number.size()) + number;
    }
    layers.push_back(std::move(layer));
  }
  return layers;
}

void write_header(Writer& writer, const std::vector<DxfOutline>& outlines, Unit length) {
  Eigen::AlignedBox2d box;
  for (const DxfOutline& outline : outlines) box.extend(box_of(outline.line));
  writer.add(0, "SECTION");
  writer.add(2, "HEADER");
  writer.variable("$ACADVER", 1, "AC1009");
  writer.variable("$INSUNITS", 70, io_detail::dxf_unit(length));
  writer.variable("$MEASUREMENT", 70, length == Unit::kInch || length == Unit::kFoot ? "0" : "1");
  writer.add(9, "$EXTMIN");
  writer.place(10, box.min());
  writer.add(9, "$EXTMAX");
  writer.place(10, box.max());
  writer.add(0, "ENDSEC");
}

void write_layers(Writer& writer, const std::vector<std::string>& layers) {
  writer.add(0, "SECTION");
  writer.add(2, "TABLES");
  writer.add(0, "TABLE");
  writer.add(2, "LAYER");
  writer.add(70, static_cast<int>(layers.size()));
  for (const std::string& layer : layers) {
    constexpr int kBlackOrWhite = 7;
    writer.add(0, "LAYER");
    writer.add(2, layer);
    writer.add(70, 0);
    writer.add(62, kBlackOrWhite);
    writer.add(6, "CONTINUOUS");
  }
  writer.add(0, "ENDTAB");
  writer.add(0, "ENDSEC");
}

void write_outline(Writer& writer, const ArcPolyline& line, const std::string& layer) {
  if (const auto circle = circle_of(line)) {
    writer.add(0, "CIRCLE");
    writer.add(8, layer);
    writer.place(10, circle->center_B);
    writer.length(40, circle->radius);
    return;
  }
  writer.add(0, "POLYLINE");
  writer.add(8, layer);
  writer.add(66, 1);  // vertices follow
  writer.place(10, Vector2d::Zero());
  writer.add(70, line.closed ? 1 : 0);
  for (const ArcVertex& vertex : line.vertices) {
    writer.add(0, "VERTEX");
    writer.add(8, layer);
    writer.place(10, vertex.p_B);
    if (vertex.bulge != 0) {
      writer.number(42, vertex.bulge);
    }
  }
  writer.add(0, "SEQEND");
  writer.add(8, layer);
}

}  // namespace

std::string dxf_text(const std::vector<DxfOutline>& outlines, Unit length) {
  Writer writer(length);
  write_header(writer, outlines, length);
  const std::vector<std::string> layers = layers_of(outlines);
  write_layers(writer, layers);
  writer.add(0, "SECTION");
  writer.add(2, "ENTITIES");
  for (std::size_t i = 0; i < outlines.size(); ++i) write_outline(writer, outlines[i].line, layers[i]);
  writer.add(0, "ENDSEC");
  writer.add(0, "EOF");
  return writer.take();
}

}  // namespace higherpair
