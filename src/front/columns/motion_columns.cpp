#include "column_set.hpp"
#include "higherpair/analysis/unit_motion.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/io/column_dimension.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include <fmt/core.h>

namespace higherpair {
namespace {

constexpr std::array<std::string_view, 8> kLinkages = {"four-bar",    "slider-crank", "inverted slider-crank",
                                                       "scotch yoke", "rapson slide", "double slider",
                                                       "wedge",       "link"};

// Dimensions of a coordinate and its rates.
struct Coordinate {
  Dimension position, velocity, acceleration;
};

Coordinate coordinate_of(const Joint& joint) {
  const Dimension of = coordinate_dimension(joint);
  return {of, rate_of(of), rate_of(of, 2)};
}

double* put_vector(const Vector2d& v, double* out) {
  *out++ = v.x();
  *out++ = v.y();
  return out;
}

void add_time(ColumnSet& set, const Profile& profile, const Units& units) {
  if (units == profile.units) {
    set.add(
        {{"time", dimension::kTime, true}}, [](const RowSource& source, double* out) { *out = source.time; },
        true);
    return;
  }
  set.add(
      {{"time", dimension::kTime}},
      [scale = to_si(dimension::kTime, profile.units)](const RowSource& source, double* out) {
        *out = scale.apply(source.time);
      },
      true);
}

void add_drivers(ColumnSet& set, const Profile& profile, const Units& units) {
  const bool as_given = units == profile.units;  // the positions of the profile, unchanged
  for (std::size_t i = 0; i < profile.mechanism.drivers.size(); ++i) {
    const std::string name = driver_name(profile.mechanism.drivers[i]);
    const Coordinate of = coordinate_of(driven_joint(profile.mechanism, i));
    set.add(
        {{name, of.position, as_given},
         {name + ".velocity", of.velocity, as_given},
         {name + ".acceleration", of.acceleration, as_given}},
        [i, as_given](const RowSource& source, double* out) {
          const DriverMotion& values = as_given ? source.drivers[i].profile : source.drivers[i].si;
          out[0] = values.position;
          out[1] = values.velocity;
          out[2] = values.acceleration;
        },
        true);
  }
}

std::vector<NewColumn> motion_columns_of(const std::string& owner, bool is_body) {
  std::vector<NewColumn> columns;
  for (std::size_t k = 0; k < kMotionEndings.size(); ++k) {
    if (!is_body && MotionEnding::is_of_angle(k)) continue;
    columns.push_back({fmt::format("{}.{}", owner, kMotionEndings[k].name), kMotionEndings[k].dimension});
  }
  return columns;
}

void add_point(ColumnSet& set, std::size_t body, const std::string& name, const Vector2d& p_B) {
  set.add(motion_columns_of(name, false), [body, p_B](const RowSource& source, double* out) {
    const PointMotion motion = point_motion(source.run.row.bodies[body], p_B);
    out = put_vector(motion.p_W, out);
    if (source.run.row.has_rates[body]) {
      put_vector(motion.a_W, put_vector(motion.v_W, out));
    }
  });
}

void add_body(ColumnSet& set, std::size_t index, const Body& body) {
  set.add(motion_columns_of(body.name, true), [index](const RowSource& source, double* out) {
    const BodyMotion& motion = source.run.row.bodies[index];
    out = put_vector(motion.X_WB.p_WB, out);
    *out++ = motion.theta;
    if (source.run.row.has_rates[index]) {
      out = put_vector(motion.v_WB, out);
      *out++ = motion.omega;
      out = put_vector(motion.a_WB, out);
      *out = motion.alpha;
    }
  });
  for (const NamedPoint& point : body.points) {
    add_point(set, index, body.name + "." + point.name, point.p_B);
  }
}

void add_joint(ColumnSet& set, std::size_t index, const Joint& joint) {
  const Coordinate of = coordinate_of(joint);
  set.add({{joint.name + ".position", of.position},
           {joint.name + ".velocity", of.velocity},
           {joint.name + ".acceleration", of.acceleration}},
          [index](const RowSource& source, double* out) {
            const Mechanism& mechanism = source.run.mechanism();
            const MotionRow& row = source.run.row;
            const Joint& own = mechanism.joints[index];
            const JointMotion motion = joint_motion(mechanism, own, row.bodies);
            out[0] = motion.position;
            const auto has_rates = [&](int body) { return row.has_rates[body]; };
            if (has_rates(own.first.body) && has_rates(own.second.body) && has_rates(own.carrier)) {
              out[1] = motion.velocity;
              out[2] = motion.acceleration;
            }
          });
}

// The motion of a body, or where it is at rest, as the only driver is, that per unit of the driver: the
// direction in which its points can move is then the same.
const BodyMotion& directed_motion(const Run& run, int body, State& scratch) {
  const BodyMotion& motion = run.row.bodies[body];
  const bool at_rest = motion.omega == 0 && motion.v_WB.isZero(0);
  return at_rest && run.row.has_rates[body] && run.mechanism().drivers.size() == 1
             ? unit_motion(run, 0, scratch)[body]
             : motion;
}

// The two bodies of a contact with their freedoms on joints to ground, where they have one.
struct Sides {
  std::optional<OneFreedom> first, second;

  Sides(const Mechanism& mechanism, const Contact& contact)
      : first(grounded_freedom(mechanism, contact.first.body)),
        second(grounded_freedom(mechanism, contact.second.body)) {}

  [[nodiscard]] ContactDetails details(const Run& run, std::size_t index) const {
    const Contact& contact = run.mechanism().contacts[index];
    State scratch;
    const auto side = [&](const CurveRef& ref, const std::optional<OneFreedom>& grounded) {
      return ContactBody{curve_of(run.mechanism(), ref),
                         grounded ? run.row.bodies[ref.body] : directed_motion(run, ref.body, scratch),
                         grounded ? &*grounded : nullptr};
    };
    const ContactMotion& motion = run.row.contacts[index];
    return details_of(side(contact.first, first), side(contact.second, second), motion.at, motion.phi);
  }
};

void put_linkage(const ContactDetails& details, double* out) {
  put(details.side1.rho, out++);
  put(details.side2.rho, out++);
  for (const ContactSide* side : {&details.side1, &details.side2}) {
    if (side->center_W) {
      put_vector(*side->center_W, out);
    }
    out += 2;
  }
  *out++ =
      static_cast<double>(std::find(kLinkages.begin(), kLinkages.end(), details.linkage) - kLinkages.begin());
  for (const std::optional<double>& length : details.lengths) {
    put(length, out++);
  }
}

void put_arcs(const RowSource& source, std::size_t contact, const ContactDetails& details,
              const ContactArcs& arcs, double* out) {
  const ArcPoint* start = source.history != nullptr ? source.history->start_of(source.run, contact) : nullptr;
  if (start != nullptr) {
    const auto arc_lengths = arcs.between(*start, arc_point(source.run, contact, details));
    std::copy(arc_lengths.begin(), arc_lengths.end(), out);
  }
}

void add_contact(ColumnSet& set, std::size_t index, const Mechanism& mechanism) {
  const Contact& contact = mechanism.contacts[index];
  const std::string& name = contact.name;
  set.add({{name + ".x", dimension::kLength},
           {name + ".y", dimension::kLength},
           {name + ".normal", dimension::kAngle}},
          [index](const RowSource& source, double* out) {
            const ContactMotion& motion = source.run.row.contacts[index];
            if (!motion.touches) return;
            *put_vector(motion.at.p_W(), out) = motion.phi;
          });
  std::vector<NewColumn> columns;
  for (const char* length : {"rho1", "rho2", "c1x", "c1y", "c2x", "c2y"}) {
    columns.push_back({name + "." + length, dimension::kLength});
  }
  columns.push_back({name + ".linkage", dimension::kNumber, false, kLinkages});
  for (const char* length : {"r1", "r2", "r3", "r4"}) {
    columns.push_back({name + "." + length, dimension::kLength});
  }
  columns.push_back({name + ".sliding", dimension::kVelocity});
  columns.push_back({name + ".arc1", dimension::kLength});
  columns.push_back({name + ".arc2", dimension::kLength});
  columns.push_back({name + ".pressure", dimension::kAngle});
  columns.push_back({name + ".transmission", dimension::kAngle});
  const auto arcs = std::make_shared<const ContactArcs>(mechanism, contact);
  set.add(columns, [index, arcs, sides = Sides(mechanism, contact)](const RowSource& source, double* out) {
    const MotionRow& row = source.run.row;
    if (!row.contacts[index].touches) {
      return;
    }
    const ContactDetails details = sides.details(source.run, index);
    put_linkage(details, out);
    const Contact& own = source.run.mechanism().contacts[index];
    if (row.has_rates[own.first.body] && row.has_rates[own.second.body]) {
      out[11] = row.contacts[index].rates.sliding;
    }
    put_arcs(source, index, details, *arcs, out + 12);
    // A body that touches ground moves along it: its own direction says nothing about what drives it.
    if (own.first.body != kGround) put(details.pressure, out + 14);
    put(details.transmission, out + 15);
  });
}

}  // namespace

void add_motion_columns(ColumnSet& set, const Profile& profile, const Units& units, bool in_time) {
  const Mechanism& mechanism = profile.mechanism;
  if (in_time) {
    add_time(set, profile, units);
  }
  add_drivers(set, profile, units);
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    add_body(set, i, mechanism.bodies[i]);
  }
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    if (!is_driven(mechanism, static_cast<int>(i))) {
      add_joint(set, i, mechanism.joints[i]);
    }
  }
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    add_contact(set, i, mechanism);
  }
}

void add_status_columns(ColumnSet& set) {
  static const auto kStatuses = [] {
    std::array<std::string_view, static_cast<std::size_t>(RowStatus::kContactOpen) + 1> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = name_of(static_cast<RowStatus>(i));
    return names;
  }();
  set.add(
      {{"status", dimension::kNumber, false, kStatuses}, {"residual", dimension::kLength}},
      [](const RowSource& source, double* out) {
        out[0] = static_cast<double>(source.status());
        out[1] = source.run.row.residual;
      },
      true);
}

}  // namespace higherpair
