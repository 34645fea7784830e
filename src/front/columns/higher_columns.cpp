// Columns of jerk and of higher derivatives, each kind as one block, since its columns are computed together.
#include "column_set.hpp"
#include "higherpair/analysis/derivatives.hpp"
#include "higherpair/analysis/jerk.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/group_traits.hpp"
#include "path_columns.hpp"

#include <fmt/core.h>

namespace higherpair {
namespace {

double* put_known(const std::optional<Vector2d>& v, double* out) {
  if (v) {
    out[0] = v->x();
    out[1] = v->y();
  }
  return out + 2;
}

std::vector<HigherRates> higher_rates(const RowSource& source) {
  std::vector<HigherRates> rates;
  for (const DriverState& driver : source.drivers) {
    rates.push_back(driver.higher_si);
  }
  return rates;
}

// Jerk of the drivers that follow a law; that of the others is 0.
void add_driver_jerks(ColumnSet& set, const Profile& profile) {
  for (std::size_t i = 0; i < profile.programs.size(); ++i) {
    if (!profile.programs[i].law) {
      continue;
    }
    const Driver& driver = profile.mechanism.drivers[i];
    set.add({{driver_name(driver) + ".jerk", rate_of(driver_dimension(profile.mechanism, i), 3)}},
            [i](const RowSource& source, double* out) { *out = source.drivers[i].higher_si[0]; });
  }
}

double* put_body(const Run& run, const JerkRow& jerks, std::size_t index, double* out) {
  const std::optional<BodyJerk>& jerk = jerks.bodies[index];
  out = put_known(jerk ? std::optional(jerk->j_WB) : std::nullopt, out);
  if (jerk) {
    *out = jerk->angular;
  }
  ++out;
  for (const NamedPoint& point : run.mechanism().bodies[index].points) {
    out = put_known(jerk ? std::optional(point_jerk(run.row.bodies[index], *jerk, point.p_B)) : std::nullopt,
                    out);
  }
  return out;
}

}  // namespace

void add_jerk_columns(ColumnSet& set, const Profile& profile, const Plan& plan) {
  const Mechanism& mechanism = profile.mechanism;
  add_driver_jerks(set, profile);
  const Dimension linear = rate_of(dimension::kLength, 3);
  const Dimension angular = rate_of(dimension::kAngle, 3);
  std::vector<NewColumn> columns;
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    columns.push_back({body.name + ".jx", linear});
    columns.push_back({body.name + ".jy", linear});
    columns.push_back({body.name + ".jerk", angular});
    for (const NamedPoint& point : body.points) {
      columns.push_back({body.name + "." + point.name + ".jx", linear});
      columns.push_back({body.name + "." + point.name + ".jy", linear});
    }
  }
  std::vector<std::optional<int>> joints;
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    joints.push_back(moved_joint(plan, static_cast<int>(i)));
    const bool slides = joints[i] && mechanism.joints[*joints[i]].type != JointType::kRevolute;
    for (const char* name : {".jerk", ".jerk_linkage"}) {
      columns.push_back({mechanism.contacts[i].name + name, slides ? linear : angular});
    }
  }
  set.add(columns, [joints](const RowSource& source, double* out) {
    const JerkRow jerks = jerks_of(source.run, higher_rates(source));
    for (std::size_t i = 1; i < jerks.bodies.size(); ++i) {
      out = put_body(source.run, jerks, i, out);
    }
    for (const std::optional<int>& joint : joints) {
      for (const auto* bodies : {&jerks.bodies, &jerks.linkage}) {
        const auto jerk = joint ? joint_jerk(source.run, *joint, *bodies) : std::nullopt;
        *out = jerk.value_or(*out);
        ++out;
      }
    }
  });
}

void add_derivative_columns(ColumnSet& set, const Mechanism& mechanism, int order) {
  std::vector<NewColumn> columns;
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    const Body& body = mechanism.bodies[i];
    for (int k = 3; k <= order; ++k) {
      const Dimension linear = rate_of(dimension::kLength, k);
      columns.push_back({fmt::format("{}.d{}x", body.name, k), linear});
      columns.push_back({fmt::format("{}.d{}y", body.name, k), linear});
      columns.push_back({fmt::format("{}.d{}angle", body.name, k), rate_of(dimension::kAngle, k)});
      for (const NamedPoint& point : body.points) {
        columns.push_back({fmt::format("{}.{}.d{}x", body.name, point.name, k), linear});
        columns.push_back({fmt::format("{}.{}.d{}y", body.name, point.name, k), linear});
      }
    }
  }
  set.add(columns, [order](const RowSource& source, double* out) {
    const auto bodies = derivatives_of(source.run, motions_of(source.drivers), order, higher_rates(source));
    for (std::size_t i = 1; bodies && i < bodies->size(); ++i) {
      const BodyDerivatives& body = (*bodies)[i];
      for (int k = 3; k <= order; ++k) {
        const auto at = static_cast<std::size_t>(k);
        out = put_known(body.p_WB[at], out);
        *out++ = body.theta[at];
        for (const NamedPoint& point : source.run.mechanism().bodies[i].points) {
          out = put_known(point_derivative(body, point.p_B, k), out);
        }
      }
    }
  });
}

}  // namespace higherpair
