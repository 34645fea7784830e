#include "higherpair/io/tasks.hpp"
#include "higherpair/numeric/contains.hpp"
#include "numeric/joined_words.hpp"
#include "reading.hpp"

#include <fmt/core.h>

namespace higherpair {
namespace {

using namespace io_detail;

enum class Range { kPositive, kNotNegative, kSteepness, kPoisson };

constexpr Dimension kPressure = dimension::kForce / (dimension::kLength * dimension::kLength);

// The tables that may contain a key, besides [limits] itself.
enum Scope { kContact = 1, kSlide = 2, kPivot = 4, kBody = 8 };

struct KeyRow {
  LimitKey key;
  std::string_view name;
  Dimension dimension;
  Range range;
  int scopes;
};

constexpr std::array<KeyRow, kLimitKeys> kKeys = {{
    {LimitKey::kMaxPressureAngle, "max_pressure_angle", dimension::kAngle, Range::kSteepness, kContact},
    {LimitKey::kMaxReturnPressureAngle, "max_return_pressure_angle", dimension::kAngle, Range::kSteepness,
     kContact},
    {LimitKey::kMinConvexRadius, "min_convex_radius", dimension::kLength, Range::kPositive, kContact},
    {LimitKey::kMinConcaveRadius, "min_concave_radius", dimension::kLength, Range::kPositive, kContact},
    {LimitKey::kMaxFaceWidth, "max_face_width", dimension::kLength, Range::kPositive, kContact},
    {LimitKey::kMaxSlidingSpeed, "max_sliding_speed", dimension::kVelocity, Range::kPositive, kContact},
    {LimitKey::kMinEntrainmentSpeed, "min_entrainment_speed", dimension::kVelocity, Range::kPositive,
     kContact},
    {LimitKey::kMaxContactForce, "max_contact_force", dimension::kForce, Range::kPositive, kContact},
    {LimitKey::kMinContactForce, "min_contact_force", dimension::kForce, Range::kNotNegative, kContact},
    {LimitKey::kMaxContactPressure, "max_contact_pressure", kPressure, Range::kPositive, kContact},
    {LimitKey::kMaxAcceleration, "max_acceleration", dimension::kAcceleration, Range::kPositive, kSlide},
    {LimitKey::kMaxAngularAcceleration, "max_angular_acceleration", dimension::kAngularAcceleration,
     Range::kPositive, kPivot},
    {LimitKey::kMaxJerk, "max_jerk", rate_of(dimension::kLength, 3), Range::kPositive, kSlide},
    {LimitKey::kMaxAngularJerk, "max_angular_jerk", rate_of(dimension::kAngle, 3), Range::kPositive, kPivot},
    {LimitKey::kMaxDrivingTorque, "max_driving_torque", dimension::kTorque, Range::kPositive, kPivot},
    {LimitKey::kMaxDrivingForce, "max_driving_force", dimension::kForce, Range::kPositive, kSlide},
    {LimitKey::kMinSpeedFactor, "min_speed_factor", dimension::kNumber, Range::kPositive, 0},
    {LimitKey::kElasticModulus, "elastic_modulus", kPressure, Range::kPositive, kBody},
    {LimitKey::kPoissonRatio, "poisson_ratio", dimension::kNumber, Range::kPoisson, kBody},
    {LimitKey::kWidth, "width", dimension::kLength, Range::kPositive, kContact},
}};

constexpr bool rows_follow_the_enum() {
  for (std::size_t i = 0; i < kKeys.size(); ++i) {
    if (static_cast<std::size_t>(kKeys[i].key) != i) return false;
  }
  return true;
}
static_assert(rows_follow_the_enum());

// Reads the keys that belong in one table, which is at `path`.
LimitSet read_set(TableReader& table, const std::string& path,
                  const std::function<bool(const KeyRow&)>& belongs) {
  LimitSet limits;
  for (const KeyRow& row : kKeys) {
    const auto item = belongs(row) ? table.take(std::string(row.name)) : std::nullopt;
    const auto quantity = item ? as_quantity(table.reading(), *item, {row.dimension}) : std::nullopt;
    if (!quantity) {
      continue;
    }
    if (const std::string objection = objection_to(row.key, quantity->si); !objection.empty()) {
      report(table.reading(), *item, objection);
    }
    limits[static_cast<std::size_t>(row.key)] =
        GivenLimit{quantity->si, quantity->profile, fmt::format("{}.{}", path, row.name),
                   place_of(table.reading(), item->value->mark)};
  }
  return limits;
}

int scope_of(const Joint& joint) {
  return has_angle(joint.type) ? kPivot : kSlide;
}

// Reads [limits.contacts], [limits.joints] or [limits.bodies]: a set of limits for each of the things.
template <class Thing, class ScopeOf>
std::vector<LimitSet> read_sets(TableReader& limits, const std::string& key, std::string_view kind,
                                const std::vector<Thing>& things, const ScopeOf& scope) {
  std::vector<LimitSet> sets(things.size());
  for_each_table(
      limits.reading(), limits.take(key), fmt::format("limits of a {} (a table)", kind),
      [&](const std::string& name, TableReader& table) {
        const auto index = named_thing(table, name, fmt::format("there is no {}", kind), things, key);
        if (!index) return;
        sets[*index] = read_set(table, fmt::format("limits.{}.{}", key, name),
                                [&](const KeyRow& row) { return (row.scopes & scope(things[*index])) != 0; });
        table.finish();
      });
  return sets;
}

// A limit of the contact pressure requires all that the pressure is computed from.
void require_materials(TableReader& table, const CheckLimits& limits, const Mechanism& mechanism) {
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    const GivenLimit* limit = limit_of(limits, limits.contacts, i, LimitKey::kMaxContactPressure);
    if (limit == nullptr) {
      continue;
    }
    const Contact& contact = mechanism.contacts[i];
    std::vector<std::string> missing;
    if (limit_of(limits, limits.contacts, i, LimitKey::kWidth) == nullptr) {
      missing.push_back("limits.width");
    }
    for (const LimitKey key : {LimitKey::kElasticModulus, LimitKey::kPoissonRatio}) {
      for (const int body : {contact.first.body, contact.second.body}) {
        const auto name = fmt::format("limits.{}", name_of(key));
        const bool known = limit_of(limits, limits.bodies, static_cast<std::size_t>(body), key) != nullptr;
        if (!known && !contains(missing, name)) {
          missing.push_back(name);
        }
      }
    }
    if (!missing.empty()) {
      const bool is_one = missing.size() == 1;
      table.reading().mistakes.push_back(
          {table.mark(),
           fmt::format("{}: the pressure of contacts.{} also needs {}", limit->path, contact.name,
                       joined_words(missing, " and ")),
           "", is_one ? missing : std::vector<std::string>{}});
      return;
    }
  }
}

}  // namespace

std::string_view name_of(LimitKey key) {
  return kKeys[static_cast<std::size_t>(key)].name;
}

Dimension dimension_of(LimitKey key) {
  return kKeys[static_cast<std::size_t>(key)].dimension;
}

std::string objection_to(LimitKey key, double value) {
  switch (kKeys[static_cast<std::size_t>(key)].range) {
    case Range::kPositive:
      return value > 0 ? "" : "must be > 0";
    case Range::kNotNegative:
      return value >= 0 ? "" : "must be >= 0";
    case Range::kSteepness:
      return value > 0 && value < kPi / 2 ? ""
                                          : "a pressure angle is limited to more than 0 and less than 90 deg";
    case Range::kPoisson:
      break;
  }
  return value >= 0 && value <= 0.5 ? "" : "Poisson's ratio is from 0 to 0.5";
}

const GivenLimit* limit_of(const CheckLimits& limits, const std::vector<LimitSet>& own, std::size_t index,
                           LimitKey key) {
  const auto at = static_cast<std::size_t>(key);
  if (index < own.size() && own[index][at]) {
    return &*own[index][at];
  }
  return limits.all[at] ? &*limits.all[at] : nullptr;
}

namespace io_detail {

void read_limits(TableReader& root, Profile& profile) {
  auto reader = as_reader(root.reading(), root.take("limits"), "a table of limits");
  if (!reader) {
    return;
  }
  TableReader& table = *reader;
  const Mechanism& mechanism = profile.mechanism;
  auto limits = std::make_shared<CheckLimits>();
  limits->all = read_set(table, "limits", [](const KeyRow&) { return true; });
  limits->contacts =
      read_sets(table, "contacts", "contact", mechanism.contacts, [](const Contact&) { return kContact; });
  limits->joints = read_sets(table, "joints", "joint", mechanism.joints, scope_of);
  limits->bodies = read_sets(table, "bodies", "body", mechanism.bodies, [](const Body&) { return kBody; });
  table.finish();
  require_materials(table, *limits, mechanism);
  profile.limits = std::move(limits);
}

}  // namespace io_detail
}  // namespace higherpair
