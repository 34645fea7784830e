#include "higherpair/io/motion_table.hpp"

#include "higherpair/contact/details.hpp"

#include <charconv>
#include <cmath>
#include <set>

namespace higherpair {
namespace {

void add(std::vector<Column>& columns, const std::string& prefix, std::initializer_list<const char*> names,
         const std::string& unit) {
  for (const char* name : names) {
    columns.push_back({prefix + name, unit});
  }
}

void append_number(double value, std::string& out) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value == 0 ? 0.0 : value).ptr;
  out.append(text, end);
}

}  // namespace

std::string_view name_of(RowStatus status) {
  switch (status) {
    case RowStatus::kOk:
      return "ok";
    case RowStatus::kNotAssemblable:
      return "not_assemblable";
    case RowStatus::kSingular:
      return "singular";
    case RowStatus::kNotConverged:
      return "not_converged";
  }
  return "not_converged";
}

tl::expected<MotionTable, std::string> MotionTable::make(const Profile& profile, const Plan& plan,
                                                         bool timed) {
  MotionTable table;
  table.timed_ = timed;
  const Units& units = profile.units;
  table.scale_ = {from_si(dimension::kLength, units),       from_si(dimension::kAngle, units),
                  from_si(dimension::kVelocity, units),     from_si(dimension::kAngularVelocity, units),
                  from_si(dimension::kAcceleration, units), from_si(dimension::kAngularAcceleration, units)};
  table.add_names(profile, plan);
  std::set<std::string> seen;
  for (const Column& column : table.columns_) {
    if (!seen.insert(column.name).second) {
      return tl::unexpected("two columns would be called '" + column.name +
                            "': rename one of the bodies, points, joints or contacts that share this name");
    }
  }
  return table;
}

void MotionTable::add_names(const Profile& profile, const Plan& plan) {
  const Units& units = profile.units;
  const auto unit = [&](const Dimension& dimension) { return unit_text(dimension, units); };
  const std::string length = unit(dimension::kLength), angle = unit(dimension::kAngle);
  const std::string velocity = unit(dimension::kVelocity), omega = unit(dimension::kAngularVelocity);
  const std::string acceleration = unit(dimension::kAcceleration),
                    alpha = unit(dimension::kAngularAcceleration);
  if (timed_) {
    columns_.push_back({"time", unit(dimension::kTime)});
  }
  const bool turns = plan.driver.freedom.turns;
  columns_.push_back({"driver", turns ? angle : length});
  columns_.push_back({"driver.velocity", turns ? omega : velocity});
  columns_.push_back({"driver.acceleration", turns ? alpha : acceleration});
  for (std::size_t i = 1; i < profile.mechanism.bodies.size(); ++i) {
    const Body& body = profile.mechanism.bodies[i];
    const std::string prefix = body.name + ".";
    add(columns_, prefix, {"x", "y"}, length);
    add(columns_, prefix, {"angle"}, angle);
    add(columns_, prefix, {"vx", "vy"}, velocity);
    add(columns_, prefix, {"omega"}, omega);
    add(columns_, prefix, {"ax", "ay"}, acceleration);
    add(columns_, prefix, {"alpha"}, alpha);
    for (const NamedPoint& point : body.points) {
      add(columns_, prefix + point.name + ".", {"x", "y"}, length);
      add(columns_, prefix + point.name + ".", {"vx", "vy"}, velocity);
      add(columns_, prefix + point.name + ".", {"ax", "ay"}, acceleration);
    }
  }
  if (plan.group) {
    const GroundedBody& follower = plan.group->follower;
    const std::string joint = profile.mechanism.joints[static_cast<std::size_t>(follower.joint)].name + ".";
    add(columns_, joint, {"position"}, follower.freedom.turns ? angle : length);
    add(columns_, joint, {"velocity"}, follower.freedom.turns ? omega : velocity);
    add(columns_, joint, {"acceleration"}, follower.freedom.turns ? alpha : acceleration);
    const std::string k =
        profile.mechanism.contacts[static_cast<std::size_t>(plan.group->contact)].name + ".";
    add(columns_, k, {"x", "y"}, length);
    add(columns_, k, {"normal"}, angle);
    add(columns_, k, {"rho1", "rho2", "c1x", "c1y", "c2x", "c2y"}, length);
    add(columns_, k, {"linkage"}, "");
    add(columns_, k, {"r1", "r2", "r3", "r4"}, length);
    add(columns_, k, {"sliding"}, velocity);
    add(columns_, k, {"arc1", "arc2"}, length);
    add(columns_, k, {"pressure", "transmission"}, angle);
  }
  columns_.push_back({"status", ""});
  columns_.push_back({"residual", length});
}

void MotionTable::number(double value) {
  if (std::isfinite(value)) {
    cells_.emplace_back(value);
  } else {
    cells_.emplace_back();
  }
}

void MotionTable::length(std::optional<double> value) {
  if (value) {
    number(scale_.length.apply(*value));
  } else {
    cells_.emplace_back();
  }
}

const std::vector<Cell>& MotionTable::cells(const Run& run, const MotionRow& row, const DriverState& driver,
                                            double time) {
  cells_.clear();
  if (timed_) {
    number(time);
  }
  number(driver.profile.position);
  number(driver.profile.velocity);
  number(driver.profile.acceleration);
  if (row.status != RowStatus::kNotAssemblable) {
    add_bodies(run, row);
    if (run.plan.group) {
      add_joints(run, row);
      add_contact(run, row);
    }
  }
  cells_.resize(columns_.size() - 2);
  cells_.emplace_back(name_of(row.status));
  length(row.residual);
  return cells_;
}

void MotionTable::add_bodies(const Run& run, const MotionRow& row) {
  const auto vector = [&](const Scaling& scale, const Vector2d& v, bool defined) {
    for (const double component : {v.x(), v.y()}) {
      defined ? number(scale.apply(component)) : void(cells_.emplace_back());
    }
  };
  for (std::size_t i = 1; i < row.bodies.size(); ++i) {
    const BodyMotion& body = row.bodies[i];
    const bool rates = row.status != RowStatus::kSingular || static_cast<int>(i) == run.plan.driver.body;
    const auto rate = [&](const Scaling& scale, double value) {
      rates ? number(scale.apply(value)) : void(cells_.emplace_back());
    };
    vector(scale_.length, body.X_WB.p_WB, true);
    number(scale_.angle.apply(body.theta));
    vector(scale_.velocity, body.v_WB, rates);
    rate(scale_.angular_velocity, body.omega);
    vector(scale_.acceleration, body.a_WB, rates);
    rate(scale_.angular_acceleration, body.alpha);
    for (const NamedPoint& point : run.mechanism.bodies[i].points) {
      const PointMotion motion = point_motion(body, point.p_B);
      vector(scale_.length, motion.p_W, true);
      vector(scale_.velocity, motion.v_W, rates);
      vector(scale_.acceleration, motion.a_W, rates);
    }
  }
}

void MotionTable::add_joints(const Run& run, const MotionRow& row) {
  const bool turns = run.plan.group->follower.freedom.turns;
  number((turns ? scale_.angle : scale_.length).apply(row.joint_position));
  if (row.status == RowStatus::kSingular) {
    cells_.resize(cells_.size() + 2);
    return;
  }
  number((turns ? scale_.angular_velocity : scale_.velocity).apply(row.joint_velocity));
  number((turns ? scale_.angular_acceleration : scale_.acceleration).apply(row.joint_acceleration));
}

void MotionTable::add_contact(const Run& run, const MotionRow& row) {
  // Columns are those of the first and second body of the file; seen from the other body n and t turn round.
  const bool swap = !run.plan.group->driver_is_first;
  const ContactPosition& at = row.contact;
  const ContactDetails details = details_of(run.plan.group->pair, at, row.normal_angle);
  const ContactSide& first = swap ? details.side2 : details.side1;
  const ContactSide& second = swap ? details.side1 : details.side2;
  const Vector2d p = (at.p1_W + at.p2_W) / 2;
  length(p.x());
  length(p.y());
  number(scale_.angle.apply(row.normal_angle + (swap ? kPi : 0)));
  length(first.rho);
  length(second.rho);
  for (const ContactSide* side : {&first, &second}) {
    length(side->center_W ? std::optional(side->center_W->x()) : std::nullopt);
    length(side->center_W ? std::optional(side->center_W->y()) : std::nullopt);
  }
  cells_.emplace_back(details.linkage);
  const bool four_bar = run.plan.group->pair.motion1.turns && run.plan.group->pair.motion2.turns;
  auto lengths = details.lengths;
  if (swap && four_bar) {
    std::swap(lengths[1], lengths[3]);
  }
  for (const auto& side : lengths) {
    length(side);
  }
  if (row.status == RowStatus::kSingular) {
    cells_.emplace_back();
  } else {
    number(scale_.velocity.apply(row.sliding));
  }
  const double sense = swap ? -1 : 1;
  const std::array<double, 2> arcs = {sense * first.arc, sense * second.arc};
  if (!arc_start_) {
    arc_start_ = arcs;
  }
  length(arcs[0] - (*arc_start_)[0]);
  length(arcs[1] - (*arc_start_)[1]);
  number(scale_.angle.apply(swap ? details.pressure1 : details.pressure2));
  const auto& transmission = swap ? details.transmission1 : details.transmission2;
  if (transmission) {
    number(scale_.angle.apply(*transmission));
  } else {
    cells_.emplace_back();
  }
}

void append_csv_header(const std::vector<Column>& columns, std::string& out) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0) {
      out += ',';
    }
    out += columns[i].name;
    if (!columns[i].unit.empty()) {
      out += '[' + columns[i].unit + ']';
    }
  }
  out += '\n';
}

void append_csv_row(const std::vector<Cell>& cells, std::string& out) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) {
      out += ',';
    }
    if (const auto* number = std::get_if<double>(&cells[i])) {
      append_number(*number, out);
    }
    if (const auto* word = std::get_if<std::string_view>(&cells[i])) {
      out += *word;
    }
  }
  out += '\n';
}

}  // namespace higherpair
