#include "series_conditions.hpp"

#include "higherpair/geometry/support.hpp"
#include "higherpair/mechanism/joint_motion.hpp"

namespace higherpair {
namespace {

using SeriesVector = Vector2<Series>;

SeriesVector constant(const Vector2d& v) {
  return {Series(v.x()), Series(v.y())};
}

struct BodySeries {
  Pose<Series> X_WB;
  Series theta = Series(0.0);
  SeriesVector v_WB = constant(Vector2d::Zero());
  Series omega = Series(0.0);

  [[nodiscard]] SeriesVector point(const Vector2d& p_B) const {
    return X_WB.R_WB * constant(p_B) + X_WB.p_WB;
  }
  // Of the material point at p.
  [[nodiscard]] SeriesVector velocity(const SeriesVector& p) const {
    const SeriesVector r = p - X_WB.p_WB;
    return {v_WB.x() - omega * r.y(), v_WB.y() + omega * r.x()};
  }
};

// The coefficients of one column.
Coefficients column_of(const std::vector<Eigen::VectorXd>& x, Eigen::Index column) {
  Coefficients c{};
  for (std::size_t k = 0; k < x.size(); ++k) {
    c[k] = x[k](column);
  }
  return c;
}

BodySeries body_along(const std::vector<Eigen::VectorXd>& x, Eigen::Index column, double size) {
  const Coefficients px = column_of(x, column);
  const Coefficients py = column_of(x, column + 1);
  Coefficients angle = column_of(x, column + 2);
  for (double& c : angle) {
    c /= size;
  }
  BodySeries body;
  body.theta = series_of(angle);
  body.omega = series_of(rate_of(angle));
  body.X_WB = {{cos(body.theta), sin(body.theta)}, {series_of(px), series_of(py)}};
  body.v_WB = {series_of(rate_of(px)), series_of(rate_of(py))};
  return body;
}

PlacedCurve<Series> place_series(const Curve& curve, const BodySeries& body) {
  return {body.point(curve.vertex_B), body.X_WB.R_WB * constant(curve.axis_B), curve.semi_latus, curve.q,
          curve.side == Side::kInside ? 1.0 : -1.0};
}

Series dot(const SeriesVector& a, const SeriesVector& b) {
  return a.x() * b.x() + a.y() * b.y();
}

// Collects the conditions of one mechanism.
class Collector {
public:
  Collector(const Run& run, std::vector<BodySeries> bodies) : run_(run), bodies_(std::move(bodies)) {}

  void add(const Joint& joint) {
    if (couples_turning(joint.type)) {
      const Series carrier = body(joint.carrier).theta;
      add_angle(body(joint.second.body).theta - carrier -
                joint.turning_ratio * (body(joint.first.body).theta - carrier));
      return;
    }
    const SeriesVector r = between(joint);
    if (joint.type == JointType::kRevolute) {
      values_.push_back(r.x());
      values_.push_back(r.y());
      return;
    }
    values_.push_back(dot(r, perp(direction(joint))));
    if (joint.type == JointType::kPrismatic) {
      add_angle(body(joint.second.body).theta - body(joint.first.body).theta);
    }
  }

  void add_driver(const Joint& joint, const Series& position) {
    if (joint.type == JointType::kRevolute) {
      add_angle(body(joint.second.body).theta - body(joint.first.body).theta - position);
    } else {
      values_.push_back(dot(between(joint), direction(joint)) - position);
    }
  }

  void add_idle(int index) { add_angle(body(index).theta); }

  // \param phi  angle of the normal out of the first body; unused where a body is flat
  void add(const Contact& contact, const Series& phi) {
    const Curve& curve1 = curve_of(run_.mechanism, contact.first);
    const Curve& curve2 = curve_of(run_.mechanism, contact.second);
    const PlacedCurve<Series> first = place_series(curve1, body(contact.first.body));
    const PlacedCurve<Series> second = place_series(curve2, body(contact.second.body));
    SeriesVector n{cos(phi), sin(phi)};
    if (is_line(curve1)) {
      n = -first.axis_W;
    } else if (is_line(curve2)) {
      n = second.axis_W;
    }
    const SeriesVector t = perp(n);
    const SeriesVector p1 = is_line(curve1) ? first.vertex_W : support_point(first, n).p_W;
    const SeriesVector p2 = is_line(curve2) ? second.vertex_W : support_point(second, SeriesVector(-n)).p_W;
    const SeriesVector apart = p2 - p1;
    values_.push_back(dot(apart, n));
    if (!is_line(curve1) && !is_line(curve2)) {
      values_.push_back(dot(apart, t));
    }
    if (contact.rolling) {
      const SeriesVector& p = is_line(curve1) ? p2 : p1;
      const SeriesVector slip = body(contact.second.body).velocity(p) - body(contact.first.body).velocity(p);
      values_.push_back(integral_of(dot(slip, t)));
    }
  }

  [[nodiscard]] const std::vector<Series>& values() const { return values_; }

private:
  [[nodiscard]] const BodySeries& body(int index) const { return bodies_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] SeriesVector between(const Joint& joint) const {
    return body(joint.second.body).point(point_of(run_.mechanism, joint.second)) -
           body(joint.first.body).point(point_of(run_.mechanism, joint.first));
  }
  [[nodiscard]] SeriesVector direction(const Joint& joint) const {
    return body(joint.first.body).X_WB.R_WB * constant(joint.direction_A);
  }
  void add_angle(const Series& angle) { values_.push_back(run_.plan.size * angle); }

  const Run& run_;
  std::vector<BodySeries> bodies_;
  std::vector<Series> values_;
};

}  // namespace

SeriesConditions::SeriesConditions(const Run& run, const std::vector<DriverMotion>& drivers)
    : run_(run), drivers_(drivers) {
  columns_ = 3 * (static_cast<Eigen::Index>(run.mechanism.bodies.size()) - 1);
  for (const Contact& contact : run.mechanism.contacts) {
    const bool flat =
        is_line(curve_of(run.mechanism, contact.first)) || is_line(curve_of(run.mechanism, contact.second));
    normals_.push_back(flat ? -1 : columns_++);
  }
}

Eigen::VectorXd SeriesConditions::start() const {
  const double size = run_.plan.size;
  Eigen::VectorXd x(columns_);
  for (std::size_t i = 1; i < run_.row.bodies.size(); ++i) {
    const BodyMotion& body = run_.row.bodies[i];
    const auto column = 3 * (static_cast<Eigen::Index>(i) - 1);
    x.segment<3>(column) << body.X_WB.p_WB, size * body.theta;
  }
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    if (normals_[i] >= 0) {
      x(normals_[i]) = size * angle_of(run_.row.contacts[i].at.n_W);
    }
  }
  return x;
}

std::vector<Series> SeriesConditions::along(const std::vector<Eigen::VectorXd>& x, bool driven) const {
  const Mechanism& mechanism = run_.mechanism;
  std::vector<BodySeries> bodies(1);
  bodies[0].X_WB = {{Series(1.0), Series(0.0)}, constant(Vector2d::Zero())};
  for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
    bodies.push_back(body_along(x, 3 * (static_cast<Eigen::Index>(i) - 1), run_.plan.size));
  }
  Collector collector(run_, std::move(bodies));
  for (const Joint& joint : mechanism.joints) {
    collector.add(joint);
  }
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    const DriverMotion& at = drivers_[i];
    const Coefficients moving{at.position, at.velocity, at.acceleration / 2};
    collector.add_driver(mechanism.joints[static_cast<std::size_t>(mechanism.drivers[i].joint)],
                         series_of(driven ? moving : Coefficients{at.position}));
  }
  for (const int idle : run_.plan.idle_bodies) {
    collector.add_idle(idle);
  }
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    Coefficients phi{};
    if (normals_[i] >= 0) {
      phi = column_of(x, normals_[i]);
      for (double& c : phi) {
        c /= run_.plan.size;
      }
    }
    collector.add(mechanism.contacts[i], series_of(phi));
  }
  return collector.values();
}

}  // namespace higherpair
