#include "higherpair/io/column_dimension.hpp"

#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/tasks.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/group_traits.hpp"

#include <algorithm>
#include <charconv>
#include <initializer_list>

namespace higherpair {
namespace {

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Of a coordinate: "position", "velocity", ...
std::optional<Dimension> coordinate_column(const Dimension& position, std::string_view last) {
  if (last == "position") return position;
  if (last == "velocity") return rate_of(position, 1);
  if (last == "acceleration") return rate_of(position, 2);
  return std::nullopt;
}

std::optional<Dimension> driver_column(const Mechanism& mechanism, std::size_t driver,
                                       std::string_view rest) {
  const Dimension position = driver_dimension(mechanism, driver);
  if (rest.empty()) return position;
  if (rest == ".jerk") return rate_of(position, 3);
  if (is_one_of(rest, {".effort", ".effort_check"})) {
    return effort_dimension(position == dimension::kAngle);
  }
  return is_one_of(rest, {".velocity", ".acceleration"}) ? coordinate_column(position, rest.substr(1))
                                                         : std::nullopt;
}

// "d4x", "d4y", "d4angle".
std::optional<Dimension> derivative_column(std::string_view last) {
  int order = 0;
  if (!last.starts_with('d')) return std::nullopt;
  const auto [end, status] = std::from_chars(last.data() + 1, last.data() + last.size(), order);
  const std::string_view of(end, static_cast<std::size_t>(last.data() + last.size() - end));
  if (status != std::errc() || !(order >= 3 && order <= 99)) return std::nullopt;
  if (of == "angle") return rate_of(dimension::kAngle, order);
  return is_one_of(of, {"x", "y"}) ? std::optional(rate_of(dimension::kLength, order)) : std::nullopt;
}

// Of the joint on which the contact moves a body; of an angle where it moves none by itself.
std::optional<Dimension> contact_jerk(const Mechanism& mechanism, const Contact& contact) {
  const auto plan = make_plan(mechanism);
  if (!plan) return std::nullopt;
  const auto joint = moved_joint(*plan, static_cast<int>(&contact - mechanism.contacts.data()));
  return rate_of(joint ? coordinate_dimension(mechanism.joints[*joint]) : dimension::kAngle, 3);
}

// What the last part of a name alone says.
std::optional<Dimension> column_by_last(std::string_view last) {
  for (const MotionEnding& ending : kMotionEndings) {
    if (last == ending.name) return ending.dimension;
  }
  if (is_one_of(last, {"rho1", "rho2", "c1x", "c1y", "c2x", "c2y", "r1", "r2", "r3", "r4", "arc1", "arc2"})) {
    return dimension::kLength;
  }
  if (is_one_of(last, {"normal", "pressure", "transmission"})) return dimension::kAngle;
  if (last == "sliding") return dimension::kVelocity;
  if (is_one_of(last, {"jx", "jy"})) return rate_of(dimension::kLength, 3);
  if (is_one_of(last, {"fx", "fy", "force", "friction"})) return dimension::kForce;
  if (last == "m") return dimension::kTorque;
  return derivative_column(last);
}

template <class Things>
auto find_named(const Things& things, std::string_view name) {
  const auto found =
      std::find_if(things.begin(), things.end(), [&](const auto& thing) { return thing.name == name; });
  return found == things.end() ? nullptr : &*found;
}

}  // namespace

std::optional<Dimension> column_dimension(const Mechanism& mechanism, std::string_view column) {
  if (column == "time") return dimension::kTime;
  if (column == "residual") return dimension::kLength;
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    const std::string name = driver_name(mechanism.drivers[i]);
    if (mechanism.drivers[i].joint < 0 || !column.starts_with(name)) continue;
    if (const auto found = driver_column(mechanism, i, column.substr(name.size()))) return found;
  }
  const std::size_t dot = column.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const std::string_view owner = column.substr(0, dot);
  const std::string_view last = column.substr(dot + 1);
  if (last == "jerk" && find_named(mechanism.bodies, owner) != nullptr) return rate_of(dimension::kAngle, 3);
  if (is_one_of(last, {"jerk", "jerk_linkage"})) {
    const Contact* contact = find_named(mechanism.contacts, owner);
    return contact == nullptr ? std::nullopt : contact_jerk(mechanism, *contact);
  }
  if (const Joint* joint = find_named(mechanism.joints, owner)) {
    if (const auto found = coordinate_column(coordinate_dimension(*joint), last)) return found;
  }
  return column_by_last(last);
}

std::optional<Dimension> figure_dimension(const Mechanism& mechanism, std::string_view item,
                                          std::string_view quantity) {
  if (is_one_of(quantity, {"acceleration", "jerk"})) {
    const Joint* joint = find_named(mechanism.joints, item.substr(std::min(item.find('.') + 1, item.size())));
    return joint == nullptr
               ? std::nullopt
               : std::optional(rate_of(coordinate_dimension(*joint), quantity == "jerk" ? 3 : 2));
  }
  for (std::size_t k = 0; k < kLimitKeys; ++k) {
    const auto key = static_cast<LimitKey>(k);
    const std::string_view name = name_of(key);  // "max_pressure_angle" limits the figure "pressure_angle"
    if (is_one_of(name.substr(0, 4), {"max_", "min_"}) && name.substr(4) == quantity)
      return dimension_of(key);
  }
  if (quantity.starts_with("least_")) return figure_dimension(mechanism, item, quantity.substr(6));
  if (quantity == "contact_ratio") return dimension::kNumber;
  if (quantity == "pressure_angle_at_contact") return dimension::kAngle;
  const bool is_size = quantity.starts_with("prime_circle") || quantity.starts_with("base_circle") ||
                       quantity.starts_with("roller_");
  return is_size ? std::optional(dimension::kLength) : std::nullopt;
}

}  // namespace higherpair
