#include "higherpair/mechanism/condition_system.hpp"

#include <utility>

namespace higherpair {
namespace {

// \param number  makes a D from a number of the curve and the same number of its derivative
template <class D, class F>
CurveDimensions<D> curve_dimensions(const Curve& c, const Curve& dc, F number) {
  const auto vector = [&](const Vector2d& v, const Vector2d& dv) {
    return Vector2<D>(number(v.x(), dv.x()), number(v.y(), dv.y()));
  };
  CurveDimensions<D> of{c.kind,
                        c.side == Side::kInside ? 1.0 : -1.0,
                        vector(c.vertex_B, dc.vertex_B),
                        vector(c.axis_B, dc.axis_B),
                        number(c.semi_latus, dc.semi_latus),
                        number(c.q, dc.q)};
  if (c.slope != 0) {
    of.bent = true;
    of.bend[0] = number(c.kappa, dc.kappa) / D(-2);
    of.bend[1] = number(c.slope, dc.slope) / D(-6);
  }
  return of;
}

// \param number  as above
template <class D, class F>
Dimensions<D> make_dimensions(const Mechanism& mechanism, const Mechanism& derivative, F number) {
  const auto curve = [&](const CurveRef& ref) {
    return curve_dimensions<D>(curve_of(mechanism, ref), curve_of(derivative, ref), number);
  };
  Dimensions<D> dimensions;
  dimensions.bodies = mechanism.bodies.size();
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const auto of = joint_dimensions<D>(mechanism, joint, derivative, derivative.joints[i], number);
    dimensions.joints.push_back({joint.first.body, joint.second.body, joint.carrier, of});
  }
  for (const Contact& contact : mechanism.contacts) {
    dimensions.contacts.push_back({contact.first.body, contact.second.body, curve(contact.first),
                                   curve(contact.second), contact.rolling});
  }
  for (const Driver& driver : mechanism.drivers) {
    dimensions.drivers.push_back(driver.joint);
  }
  return dimensions;
}

// Columns of J for the derivatives by the coordinates of up to three bodies, and by φ.
struct Columns {
  std::array<Eigen::Index, 3> bodies;  // -1: none
  Eigen::Index phi = -1;
};

// Appends conditions of a system to its residual and Jacobian.
class Rows {
public:
  Rows(const ConditionSystem& system, const Dimensions<double>& dimensions, const Coordinates<double>& at,
       Eigen::VectorXd& values, Eigen::MatrixXd& J)
      : system_(system), dimensions_(dimensions), at_(at), values_(values), J_(J) {}

  void add_joint(int index) {
    const auto& joint = dimensions_.joints[index];
    const Columns columns{{column(joint.first), column(joint.second), column(joint.carrier)}};
    if (couples_turning(joint.of.type)) {
      append(joint_conditions(joint.of, variable<9>(body(joint.first), 1), variable<9>(body(joint.second), 4),
                              variable<9>(body(joint.carrier), 7), system_.size()),
             columns);
    } else {
      const auto first = variable<6>(body(joint.first), 1);
      append(joint_conditions(joint.of, first, variable<6>(body(joint.second), 4), first, system_.size()),
             columns);
    }
  }

  void add_contact(int index) {
    using T = Partials<double, 7>;
    const auto i = static_cast<std::size_t>(index);
    const auto& contact = dimensions_.contacts[i];
    T phi(at_.phi[i]);
    phi.c[7] = 1;
    append(contact_conditions(contact.curve1, variable<7>(body(contact.first), 1), contact.curve2,
                              variable<7>(body(contact.second), 4), phi,
                              contact.rolling ? std::optional<T>(at_.arcs[i]) : std::nullopt, system_.size()),
           {{column(contact.first), column(contact.second), -1}, system_.contact_column(index)});
  }

  void add_driver(int index) {
    using T = Partials<double, 6>;
    const auto i = static_cast<std::size_t>(index);
    const auto& joint = dimensions_.joints[dimensions_.drivers[i]];
    ConditionValues<T> value;
    value.add(driver_condition(joint.of, variable<6>(body(joint.first), 1),
                               variable<6>(body(joint.second), 4), T(at_.drivers[i]), system_.size()));
    append(value, {{column(joint.first), column(joint.second), -1}});
  }

  void add_idle(int index) {
    values_(row_) = system_.size() * (body(index).theta - at_.held_angles[index]);
    if (const Eigen::Index first = column(index); first >= 0) {
      J_(row_, first + 2) = 1;
    }
    ++row_;
  }

  /// Whether each curve has a point with its contact's normal.
  [[nodiscard]] bool exist() const { return exist_; }

private:
  [[nodiscard]] const BodyAt<double>& body(int index) const { return at_.bodies[index]; }
  [[nodiscard]] Eigen::Index column(int index) const { return system_.body_column(index); }

  template <class T>
  void append(const ConditionValues<T>& some, const Columns& columns) {
    exist_ = exist_ && some.exist;
    for (int i = 0; i < some.count; ++i) {
      write(some.value[i], columns);
    }
  }

  template <class T>
  void write(const T& value, const Columns& columns) {
    values_(row_) = value.c[0];
    for (std::size_t i = 0; 3 * i + 3 <= T::kLast; ++i) {
      if (const Eigen::Index x = columns.bodies[i]; x >= 0) {
        J_(row_, x) += value.c[3 * i + 1];
        J_(row_, x + 1) += value.c[3 * i + 2];
        J_(row_, x + 2) += value.c[3 * i + 3] / system_.size();
      }
    }
    if (columns.phi >= 0) {
      J_(row_, columns.phi) = value.c[T::kLast] / system_.size();
    }
    ++row_;
  }

  const ConditionSystem& system_;
  const Dimensions<double>& dimensions_;
  const Coordinates<double>& at_;
  Eigen::VectorXd& values_;
  Eigen::MatrixXd& J_;
  Eigen::Index row_ = 0;
  bool exist_ = true;
};

}  // namespace

Dimensions<double> dimensions_of(const Mechanism& mechanism) {
  return make_dimensions<double>(mechanism, mechanism, [](double x, double /*dx*/) { return x; });
}

CurveDimensions<double> dimensions_of(const Curve& curve) {
  return curve_dimensions<double>(curve, curve, [](double x, double /*dx*/) { return x; });
}

Dimensions<Partials<double, 1>> dimensions_of(const Mechanism& mechanism, const Mechanism& derivative) {
  return make_dimensions<Partials<double, 1>>(mechanism, derivative, parametric);
}

std::optional<CommonNormal> facing_at(const Dimensions<double>::Contact& contact, const BodyAt<double>& first,
                                      const BodyAt<double>& second, double phi) {
  const FacingPoints<double> at = facing_points(contact.curve1, first, contact.curve2, second, phi);
  if (!at.exist) {
    return std::nullopt;
  }
  CommonNormal touch{at.n_W, at.p1_W, at.p2_W, at.rho1, at.rho2};
  const double gap = touch.gap();
  if (contact.curve1.kind == CurveKind::kLine) {
    touch.p1_W = at.p2_W - gap * at.n_W;
  } else if (contact.curve2.kind == CurveKind::kLine) {
    touch.p2_W = at.p1_W + gap * at.n_W;
  }
  return touch;
}

ConditionSystem::ConditionSystem(Dimensions<double> dimensions, ConditionSet set, double size)
    : set_(std::move(set)),
      dimensions_(std::move(dimensions)),
      size_(size),
      body_columns_(dimensions_.bodies, -1),
      contact_columns_(dimensions_.contacts.size(), -1) {
  for (const int body : set_.bodies) {
    body_columns_[body] = columns_;
    columns_ += 3;
  }
  for (const int joint : set_.joints) {
    rows_ += condition_count(dimensions_.joints[joint].of.type);
  }
  for (const int contact : set_.contacts) {
    contact_columns_[contact] = columns_++;
    rows_ += dimensions_.contacts[contact].rolling ? 3 : 2;
  }
  rows_ += static_cast<Eigen::Index>(set_.drivers.size() + set_.idle_bodies.size());
}

bool ConditionSystem::evaluate(const Coordinates<double>& at, Eigen::VectorXd& values,
                               Eigen::MatrixXd& J) const {
  values.resize(row_count());
  J.setZero(row_count(), columns_);
  Rows rows(*this, dimensions_, at, values, J);
  for (const int joint : set_.joints) rows.add_joint(joint);
  for (const int contact : set_.contacts) rows.add_contact(contact);
  for (const int driver : set_.drivers) rows.add_driver(driver);
  for (const int body : set_.idle_bodies) rows.add_idle(body);
  return rows.exist();
}

}  // namespace higherpair
