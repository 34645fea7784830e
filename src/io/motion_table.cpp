#include "higherpair/io/motion_table.hpp"

#include "higherpair/contact/details.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
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
    case RowStatus::kOverlap:
      return "overlap";
    case RowStatus::kNotConverged:
      return "not_converged";
  }
  return "not_converged";
}

std::string_view name_of(EventType type) {
  switch (type) {
    case EventType::kLimitPosition:
      break;
    case EventType::kDeadPoint:
      return "dead_point";
    case EventType::kStrokeEnd:
      return "stroke_end";
    case EventType::kConforming:
      return "conforming";
    case EventType::kSecondContact:
      return "second_contact";
    case EventType::kOverlap:
      return "overlap";
  }
  return "limit_position";
}

tl::expected<MotionTable, std::string> MotionTable::make(const Profile& profile, bool timed) {
  MotionTable table;
  table.timed_ = timed;
  const Units& units = profile.units;
  table.scale_ = {from_si(dimension::kLength, units),       from_si(dimension::kAngle, units),
                  from_si(dimension::kVelocity, units),     from_si(dimension::kAngularVelocity, units),
                  from_si(dimension::kAcceleration, units), from_si(dimension::kAngularAcceleration, units)};
  table.mechanism_ = &profile.mechanism;
  for (std::size_t i = 0; i < profile.mechanism.bodies.size(); ++i) {
    table.grounded_.push_back(grounded_freedom(profile.mechanism, static_cast<int>(i)));
  }
  for (std::size_t i = 0; i < profile.mechanism.joints.size(); ++i) {
    if (!is_driven(profile.mechanism, static_cast<int>(i))) {
      table.moved_.push_back(&profile.mechanism.joints[i]);
    }
  }
  table.arc_starts_.resize(profile.mechanism.contacts.size());
  table.add_names(profile);
  std::set<std::string> seen;
  for (const Column& column : table.columns_) {
    if (!seen.insert(column.name).second) {
      return tl::unexpected("two columns would be called '" + column.name +
                            "': rename one of the bodies, points, joints or contacts that share this name");
    }
  }
  return table;
}

void MotionTable::add_names(const Profile& profile) {
  const Units& units = profile.units;
  const Mechanism& mechanism = profile.mechanism;
  const auto unit = [&](const Dimension& dimension) { return unit_text(dimension, units); };
  if (timed_) {
    columns_.push_back({"time", unit(dimension::kTime)});
  }
  for (const Driver& driver : mechanism.drivers) {
    const std::string name = driver.name.empty() ? "driver" : "driver." + driver.name;
    const bool turns = mechanism.joints[static_cast<std::size_t>(driver.joint)].type == JointType::kRevolute;
    columns_.push_back({name, unit(turns ? dimension::kAngle : dimension::kLength)});
    columns_.push_back(
        {name + ".velocity", unit(turns ? dimension::kAngularVelocity : dimension::kVelocity)});
    columns_.push_back(
        {name + ".acceleration", unit(turns ? dimension::kAngularAcceleration : dimension::kAcceleration)});
  }
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    add_body_names(mechanism.bodies[i], units);
  }
  for (const Joint* joint : moved_) {
    const bool turns = has_angle(joint->type);
    add(columns_, joint->name, {".position"}, unit(turns ? dimension::kAngle : dimension::kLength));
    add(columns_, joint->name, {".velocity"},
        unit(turns ? dimension::kAngularVelocity : dimension::kVelocity));
    add(columns_, joint->name, {".acceleration"},
        unit(turns ? dimension::kAngularAcceleration : dimension::kAcceleration));
  }
  for (const Contact& contact : mechanism.contacts) {
    add_contact_names(contact, units);
  }
  columns_.push_back({"status", ""});
  columns_.push_back({"residual", unit(dimension::kLength)});
}

void MotionTable::add_body_names(const Body& body, const Units& units) {
  const std::string length = unit_text(dimension::kLength, units);
  const std::string velocity = unit_text(dimension::kVelocity, units);
  const std::string acceleration = unit_text(dimension::kAcceleration, units);
  const std::string prefix = body.name + ".";
  add(columns_, prefix, {"x", "y"}, length);
  add(columns_, prefix, {"angle"}, unit_text(dimension::kAngle, units));
  add(columns_, prefix, {"vx", "vy"}, velocity);
  add(columns_, prefix, {"omega"}, unit_text(dimension::kAngularVelocity, units));
  add(columns_, prefix, {"ax", "ay"}, acceleration);
  add(columns_, prefix, {"alpha"}, unit_text(dimension::kAngularAcceleration, units));
  for (const NamedPoint& point : body.points) {
    add(columns_, prefix + point.name + ".", {"x", "y"}, length);
    add(columns_, prefix + point.name + ".", {"vx", "vy"}, velocity);
    add(columns_, prefix + point.name + ".", {"ax", "ay"}, acceleration);
  }
}

void MotionTable::add_contact_names(const Contact& contact, const Units& units) {
  const std::string length = unit_text(dimension::kLength, units);
  const std::string angle = unit_text(dimension::kAngle, units);
  const std::string prefix = contact.name + ".";
  add(columns_, prefix, {"x", "y"}, length);
  add(columns_, prefix, {"normal"}, angle);
  add(columns_, prefix, {"rho1", "rho2", "c1x", "c1y", "c2x", "c2y"}, length);
  add(columns_, prefix, {"linkage"}, "");
  add(columns_, prefix, {"r1", "r2", "r3", "r4"}, length);
  add(columns_, prefix, {"sliding"}, unit_text(dimension::kVelocity, units));
  add(columns_, prefix, {"arc1", "arc2"}, length);
  add(columns_, prefix, {"pressure", "transmission"}, angle);
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

void MotionTable::optional_angle(std::optional<double> value) {
  if (value) {
    number(scale_.angle.apply(*value));
  } else {
    cells_.emplace_back();
  }
}

void MotionTable::vector(const Scaling& scale, const Vector2d& v, bool defined) {
  for (const double component : {v.x(), v.y()}) {
    defined ? number(scale.apply(component)) : void(cells_.emplace_back());
  }
}

const std::vector<Cell>& MotionTable::cells(const MotionRow& row, const std::vector<DriverState>& drivers,
                                            double time) {
  cells_.clear();
  if (timed_) {
    number(time);
  }
  for (const DriverState& driver : drivers) {
    number(driver.profile.position);
    number(driver.profile.velocity);
    number(driver.profile.acceleration);
  }
  if (row.status != RowStatus::kNotAssemblable) {
    for (std::size_t i = 1; i < row.bodies.size(); ++i) {
      add_body(row, i);
    }
    for (const Joint* joint : moved_) {
      add_joint(row, *joint);
    }
    for (std::size_t i = 0; i < row.contacts.size(); ++i) {
      add_contact(row, i);
    }
  } else {
    broken_ = true;
  }
  cells_.resize(columns_.size() - 2);
  cells_.emplace_back(name_of(row.status));
  length(row.residual);
  return cells_;
}

void MotionTable::add_body(const MotionRow& row, std::size_t index) {
  const BodyMotion& body = row.bodies[index];
  const bool rates = row.has_rates[index];
  const auto rate = [&](const Scaling& scale, double value) {
    rates ? number(scale.apply(value)) : void(cells_.emplace_back());
  };
  vector(scale_.length, body.X_WB.p_WB, true);
  number(scale_.angle.apply(body.theta));
  vector(scale_.velocity, body.v_WB, rates);
  rate(scale_.angular_velocity, body.omega);
  vector(scale_.acceleration, body.a_WB, rates);
  rate(scale_.angular_acceleration, body.alpha);
  for (const NamedPoint& point : mechanism_->bodies[index].points) {
    const PointMotion motion = point_motion(body, point.p_B);
    vector(scale_.length, motion.p_W, true);
    vector(scale_.velocity, motion.v_W, rates);
    vector(scale_.acceleration, motion.a_W, rates);
  }
}

void MotionTable::add_joint(const MotionRow& row, const Joint& joint) {
  const bool turns = has_angle(joint.type);
  const JointMotion motion = joint_motion(*mechanism_, joint, row.bodies);
  number((turns ? scale_.angle : scale_.length).apply(motion.position));
  const auto has_rates = [&](int body) { return row.has_rates[static_cast<std::size_t>(body)]; };
  if (!has_rates(joint.first.body) || !has_rates(joint.second.body) || !has_rates(joint.carrier)) {
    cells_.resize(cells_.size() + 2);
    return;
  }
  number((turns ? scale_.angular_velocity : scale_.velocity).apply(motion.velocity));
  number((turns ? scale_.angular_acceleration : scale_.acceleration).apply(motion.acceleration));
}

void MotionTable::add_contact(const MotionRow& row, std::size_t index) {
  const Contact& contact = mechanism_->contacts[index];
  const ContactMotion& motion = row.contacts[index];
  const auto body_of = [&](const CurveRef& ref) {
    const auto body = static_cast<std::size_t>(ref.body);
    return ContactBody{curve_of(*mechanism_, ref), row.bodies[body],
                       grounded_[body] ? &*grounded_[body] : nullptr};
  };
  const ContactDetails details =
      details_of(body_of(contact.first), body_of(contact.second), motion.at, motion.phi);
  vector(scale_.length, (motion.at.p1_W + motion.at.p2_W) / 2, true);
  number(scale_.angle.apply(motion.phi));
  length(details.side1.rho);
  length(details.side2.rho);
  for (const ContactSide* side : {&details.side1, &details.side2}) {
    length(side->center_W ? std::optional(side->center_W->x()) : std::nullopt);
    length(side->center_W ? std::optional(side->center_W->y()) : std::nullopt);
  }
  cells_.emplace_back(details.linkage);
  for (const auto& side : details.lengths) {
    length(side);
  }
  const bool rates = row.has_rates[static_cast<std::size_t>(contact.first.body)] &&
                     row.has_rates[static_cast<std::size_t>(contact.second.body)];
  rates ? number(scale_.velocity.apply(motion.rates.sliding)) : void(cells_.emplace_back());
  add_arcs(details, row.arcs_hold[index], index);
  optional_angle(details.pressure);
  optional_angle(details.transmission);
}

void MotionTable::add_arcs(const ContactDetails& details, bool hold, std::size_t index) {
  auto& start = arc_starts_[index];
  if (broken_ || !hold) {
    // The way since the first row has a gap.
    cells_.resize(cells_.size() + 2);
    return;
  }
  if (!start) {
    start = {details.side1.arc, details.side2.arc};
  }
  length(details.side1.arc - (*start)[0]);
  length(details.side2.arc - (*start)[1]);
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
