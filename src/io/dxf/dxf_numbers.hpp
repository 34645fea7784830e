#pragma once

#include "dxf.hpp"
#include "dxf_pairs.hpp"
#include "higherpair/io/names.hpp"
#include "io/tables/csv_fields.hpp"
#include "io/tolerances.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

namespace higherpair::io_detail {

/// The numbers of an entity by their group codes. The first mistake is kept as fault(); a wrong number reads
/// as 0, so the caller can read on and check fault() at the end.
class DxfNumbers {
public:
  /// \param unit  converts its numbers to metres
  DxfNumbers(const DxfGroup& entity, const Scaling& unit) : entity_(entity), unit_(unit) {}

  [[nodiscard]] const std::optional<DxfFault>& fault() const { return fault_; }
  [[nodiscard]] const std::vector<DxfPair>& pairs() const { return entity_.pairs; }
  [[nodiscard]] const Scaling& unit() const { return unit_; }

  void refuse(int line, std::string message) {
    if (!fault_) {
      fault_ = DxfFault{line, std::move(message)};
    }
  }
  void refuse(std::string_view message) { refuse(entity_.line, fmt::format("{} {}", entity_.type, message)); }

  double value(const DxfPair& pair) { return number(pair, Scaling()); }
  /// [m]
  double length(const DxfPair& pair) { return number(pair, unit_); }

  std::optional<double> find(int code) {
    const DxfPair* pair = entity_.find(code);
    return pair == nullptr ? std::nullopt : std::optional(value(*pair));
  }

  double need(int code, std::string_view what, const Scaling& scaling = Scaling()) {
    const DxfPair* pair = entity_.find(code);
    if (pair == nullptr) refuse(fmt::format("has no {} (group {})", what, code));
    return pair == nullptr ? 0 : number(*pair, scaling);
  }

  Vector2d need_point(int code, std::string_view what) {
    const double x = need(code, what, unit_);
    return {x, need(code + 10, what, unit_)};
  }

  double need_radius() {
    const double radius = need(40, "radius", unit_);
    if (!fault_ && !(radius > 0)) refuse("has a radius that is not > 0");
    return radius;
  }

  /// Its flags (group 70), a number of 16 bits; 0 if it has none.
  unsigned flags() {
    const double bits = find(70).value_or(0);
    if (bits >= 0 && bits <= 0xFFFF && bits == std::trunc(bits)) return static_cast<unsigned>(bits);
    refuse("has flags (group 70) that are not an integer from 0 to 65535");
    return 0;
  }

  /// -1 if the entity is seen from below (its extrusion points along -z), otherwise 1.
  double facing() {
    const double z = find(230).value_or(1);
    if (std::abs(find(210).value_or(0)) > kPlanarDrawing ||
        std::abs(find(220).value_or(0)) > kPlanarDrawing || z == 0) {
      refuse("does not lie in the plane of the drawing: its extrusion is not along z");
    }
    return z < 0 ? -1 : 1;
  }

private:
  double number(const DxfPair& pair, const Scaling& scaling) {
    const auto x = number_in(pair.value);
    const double scaled = scaling.apply(x.value_or(0));
    if (x && std::abs(scaled) <= kLargestQuantity) return scaled;
    refuse(pair.line, fmt::format("\"{}\" is {} (group {} of {})", visible(pair.value.substr(0, 20)),
                                  x ? "too large, numbers go up to 1e50 in SI units" : "not a number",
                                  pair.code, entity_.type));
    return 0;
  }

  const DxfGroup& entity_;
  const Scaling& unit_;
  std::optional<DxfFault> fault_;
};

}  // namespace higherpair::io_detail
