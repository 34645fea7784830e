#include "dxf.hpp"

#include "dxf_entities.hpp"
#include "dxf_units.hpp"
#include "higherpair/numeric/contains.hpp"
#include "io/document/encoding.hpp"
#include "io/tables/point_table.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// Entities that contain curves but are not read.
constexpr std::array<std::string_view, 6> kStrangers = {"INSERT", "3DFACE", "MLINE",
                                                        "BODY",   "REGION", "3DSOLID"};

DxfSweep sweep_of(std::string_view type) {
  return type == "ARC" ? DxfSweep::kAngles : type.ends_with("POLYLINE") ? DxfSweep::kBulge : DxfSweep::kNone;
}

void count_decimals(const DxfGroup& group, DxfSweep sweep, DxfDecimals& decimals) {
  for (const auto& [code, value, line] : group.pairs) {
    const bool length = (code >= 10 && code < 30) || code == 40;
    const bool bulge = sweep == DxfSweep::kBulge && code == 42;
    const bool angle = sweep == DxfSweep::kAngles && (code == 50 || code == 51);
    if (!length && !bulge && !angle) continue;
    int& most = length ? decimals.lengths : bulge ? decimals.bulges : decimals.angles;
    most = std::max(most, decimals_of(value));
  }
}

std::string_view value_of(const DxfGroup& group, int code, std::string_view otherwise) {
  const DxfPair* pair = group.find(code);
  return pair == nullptr ? otherwise : pair->value;
}

class DxfReader {
public:
  DxfReader(std::string_view text, std::optional<Unit> unit, Unit otherwise)
      : pairs_(text), unit_(unit), otherwise_(otherwise) {}

  tl::expected<DxfDrawing, DxfFault> read() {
    while (step() && pair_ && pair_->code == 999) {
    }
    if (!head_) {
      fail(1, "a drawing begins with the group 0 SECTION: is this an ASCII DXF?");
    }
    bool has_entities = false;
    bool has_end = false;
    while (head_ && !fault_ && !has_end) {
      const DxfGroup group = take_group();
      has_end = group.type == "EOF";
      const std::string_view name = group.type == "SECTION" ? value_of(group, 2, "") : "";
      if (name == "HEADER") {
        header(group);
      } else if (name == "ENTITIES") {
        has_entities = true;
        entities();
      }
    }
    if (!fault_ && !has_end) {
      fail(pairs_.line(), "the drawing ends without EOF: is it cut off?");
    }
    if (!fault_ && !has_entities) {
      fail(pairs_.line(), "the drawing has no section ENTITIES");
    }
    if (fault_) {
      return tl::unexpected(*fault_);
    }
    return std::move(drawing_);
  }

private:
  void fail(int line, std::string message) {
    if (!fault_) fault_ = DxfFault{line, std::move(message)};
  }

  // Reads the next pair into pair_; head_ tells whether it begins a new group.
  bool step() {
    pair_ = pairs_.next();
    head_ = pair_ && pair_->code == 0;
    if (!pairs_.mistake().empty()) {
      fail(pairs_.line(), pairs_.mistake());
    }
    return !fault_.has_value();
  }

  // The group that begins here, up to the beginning of the next one, without comments (code 999).
  DxfGroup take_group() {
    DxfGroup group = {pair_->value, pair_->line, {}};
    while (step() && pair_ && !head_) {
      if (pair_->code != 999) group.pairs.push_back(*pair_);
    }
    return group;
  }

  // Header variables are pairs of the header's own group: code 9 with the name, then the value.
  void header(const DxfGroup& group) {
    for (std::size_t i = 0; i + 1 < group.pairs.size(); ++i) {
      if (group.pairs[i].code != 9 || group.pairs[i].value != "$INSUNITS" || unit_) {
        continue;
      }
      const DxfPair& value = group.pairs[i + 1];
      if (const auto known = unit_of_dxf(value.value)) {
        unit_ = known;
      } else if (value.value != "0") {
        fail(value.line,
             fmt::format("$INSUNITS = {} is no unit of profiles: say what its numbers are in with `units`",
                         value.value));
      }
    }
  }

  void entities() {
    const Units units = {.length = unit_.value_or(otherwise_)};
    const Scaling scaling = to_si(dimension::kLength, units);
    drawing_.unit = scaling.apply(1);
    while (head_ && !fault_ && pair_->value != "ENDSEC") {
      if (pair_->value == "SECTION" || pair_->value == "EOF") {
        fail(pair_->line, "the section ENTITIES has no ENDSEC: is the drawing damaged?");
        return;
      }
      const DxfGroup entity = take_group();
      std::vector<DxfGroup> vertices;
      while (entity.type == "POLYLINE" && head_ && pair_->value == "VERTEX") {
        vertices.push_back(take_group());
      }
      if (!fault_ && value_of(entity, 67, "0") != "1") {  // 1: in paper space
        add(entity, vertices, scaling);
      }
    }
  }

  void add(const DxfGroup& entity, const std::vector<DxfGroup>& vertices, const Scaling& unit) {
    const bool stranger = contains(kStrangers, entity.type);
    if (!stranger && !is_dxf_curve(entity.type)) {
      return;
    }
    const std::size_t layer = layer_of(entity);
    if (stranger) {
      drawing_.strangers.push_back({std::string(entity.type), layer, entity.line});
      return;
    }
    auto shape = dxf_shape(entity, vertices, unit);
    if (!shape) {
      fault_ = shape.error();
      return;
    }
    const DxfSweep sweep = sweep_of(entity.type);
    DxfDecimals decimals;
    count_decimals(entity, sweep, decimals);
    for (const DxfGroup& vertex : vertices) count_decimals(vertex, sweep, decimals);
    for (ContourPiece& piece : shape->pieces) {
      drawing_.pieces.push_back(
          {std::move(piece), shape->whole, layer, entity.line, sweep, std::string(entity.type), decimals});
    }
  }

  std::size_t layer_of(const DxfGroup& entity) {
    const std::string_view name = value_of(entity, 8, "0");
    const auto [layer, is_new] = layers_.try_emplace(name, drawing_.layers.size());
    if (is_new) drawing_.layers.emplace_back(name);
    return layer->second;
  }

  DxfPairs pairs_;
  std::optional<Unit> unit_;
  Unit otherwise_;
  std::optional<DxfPair> pair_;
  bool head_ = false;
  std::optional<DxfFault> fault_;
  DxfDrawing drawing_;
  std::map<std::string_view, std::size_t> layers_;  // indices of drawing_.layers; names are in the text
};

}  // namespace

tl::expected<DxfDrawing, DxfFault> read_dxf(std::string_view text, std::optional<Unit> unit, Unit otherwise) {
  text = without_bom(text);
  if (text.starts_with("AutoCAD Binary DXF")) {
    return tl::unexpected(DxfFault{1, "this is a binary DXF: save the drawing as ASCII"});
  }
  if (text.starts_with("AC10")) {
    return tl::unexpected(DxfFault{1, "this is a DWG: save the drawing as ASCII DXF"});
  }
  if (is_wide(text)) {
    return tl::unexpected(
        DxfFault{1, "this is in UTF-16 or UTF-32: save the drawing as ASCII DXF, or as UTF-8"});
  }
  return DxfReader(text, unit, otherwise).read();
}

}  // namespace higherpair::io_detail
