#include "analysis/reference_follower.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <Eigen/Dense>

namespace higherpair::testing {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using RealVector = Eigen::Matrix<Real, 2, 1>;

constexpr Real kHalfTurn = std::numbers::pi_v<Real>;
constexpr Real kLongestStep = 0.02L;  // in radians and sizes of the mechanism
constexpr Real kShortestStep = 1e-11L;
constexpr Real kLargestBend = 0.02L;  // largest change of the unit tangent in a step
constexpr Real kSmallStep = 1e-6L;    // a step that may cross a turning point
constexpr int kMostSteps = 200000;

RealVector heading(Real angle) {
  return {std::cos(angle), std::sin(angle)};
}

RealVector left_of(const RealVector& v) {
  return {-v.y(), v.x()};
}

RealVector turned(Real angle, const RealVector& v) {
  return std::cos(angle) * v + std::sin(angle) * left_of(v);
}

// The point of y² = 2 ℓ x - q x² whose outward normal has the heading m, and the radius of curvature.
//     D² = cos² m + q sin² m,   y = ℓ sin m / D,   x = ℓ (D + cos m) / (q D),   ρ = ℓ / D³
struct ConicPoint {
  RealVector p = RealVector::Zero();
  Real rho = 0;
  bool exists = true;
};

ConicPoint conic_point(const Curve& curve, Real m) {
  ConicPoint point;
  if (curve.kind == CurveKind::kPoint) {
    return point;
  }
  const Real l = curve.semi_latus;
  const Real q = curve.q;
  const Real c = std::cos(m);
  const Real s = std::sin(m);
  const Real D2 = c * c + q * s * s;
  if (!(D2 > 0) || (q <= 0 && c >= 0)) {
    point.exists = false;
    return point;
  }
  const Real D = std::sqrt(D2);
  // D + cos m = q sin² m / (D - cos m): avoids the difference of nearly equal numbers and the division by q.
  const Real x = c < 0 ? l * s * s / (D * (D - c)) : l * (D + c) / (q * D);
  point.p = {x, l * s / D};
  point.rho = l / (D2 * D);
  return point;
}

// ∫ ρ dm by Gauss's rule of five points on short pieces.
Real arc_between(const Curve& curve, Real from, Real to) {
  constexpr std::array<Real, 3> x{0.0L, 0.538469310105683091036314420700208805L,
                                  0.906179845938663992797626878299392965L};
  constexpr std::array<Real, 3> w{0.568888888888888888888888888888888889L,
                                  0.478628670499366468041291514835638193L,
                                  0.236926885056189087514264040719917363L};
  if (!(std::abs(to - from) < 2 * kHalfTurn)) {
    return std::numeric_limits<Real>::quiet_NaN();  // a solution that diverges
  }
  const int pieces = 1 + static_cast<int>(std::abs(to - from) / 0.005L);
  const Real half = (to - from) / (2 * pieces);
  Real sum = 0;
  for (int i = 0; i < pieces; ++i) {
    const Real middle = from + (2 * i + 1) * half;
    sum += w[0] * conic_point(curve, middle).rho;
    for (std::size_t k = 1; k < 3; ++k) {
      sum += w[k] *
             (conic_point(curve, middle - x[k] * half).rho + conic_point(curve, middle + x[k] * half).rho);
    }
  }
  return sum * half;
}

// One curve of a contact.
struct Face {
  const Curve* curve = nullptr;
  int body = 0;
  Real axis = 0;      // heading of the curve's axis in the body's frame
  Real flip = 0;      // heading of the convex side's outward normal less that of the contact's normal
  Real arc_sign = 1;  // sign of the arc along the contact's tangent for a growing heading
  Real last_m =
      0;  // heading of the normal in the curve's frame at the last accepted point, and the arc there
  Real arc = 0;
};

struct Touch {
  Face first, second;
  bool rolling = false;
  Real phase = 0;  // arc of the first curve less arc of the second, at the start
  Real turns = 0;  // whole turns in the equation of a line's normal
};

Mechanism scaled(Mechanism mechanism, double size) {
  for (Body& body : mechanism.bodies) {
    body.guess_p_WB /= size;
    for (NamedPoint& point : body.points) point.p_B /= size;
    for (NamedCurve& curve : body.curves) {
      curve.curve.vertex_B /= size;
      curve.curve.semi_latus /= size;
    }
  }
  return mechanism;
}

// A power of two of the order of the mechanism's size: division by it is exact.
double size_of_points(const Mechanism& mechanism) {
  double most = 0;
  for (const Body& body : mechanism.bodies) {
    most = std::max(most, body.guess_p_WB.norm());
    for (const NamedPoint& point : body.points) most = std::max(most, point.p_B.norm());
    for (const NamedCurve& curve : body.curves) most = std::max(most, curve.curve.vertex_B.norm());
  }
  return most > 0 ? std::exp2(std::round(std::log2(most))) : 1;
}

// The conditions, their derivatives, and the point where they were evaluated last. Unknowns: x, y, θ of each
// moving body, the heading of each contact's normal, and the distance that the drivers have moved along their
// path.
class Conditions {
public:
  Conditions(const Mechanism& mechanism, const std::vector<double>& from, const std::vector<double>& to);

  [[nodiscard]] Eigen::Index body_unknowns() const {
    return 3 * static_cast<Eigen::Index>(mechanism_.bodies.size() - 1);
  }
  [[nodiscard]] Eigen::Index unknowns() const {
    return body_unknowns() + static_cast<Eigen::Index>(touches_.size()) + 1;
  }
  [[nodiscard]] Eigen::Index share_index() const { return unknowns() - 1; }
  [[nodiscard]] Real path() const { return path_; }
  [[nodiscard]] Real size() const { return size_; }
  [[nodiscard]] const Vector& posed() const { return at_; }

  /// Computes residual and Jacobian at a point; false where a curve has no point with this normal.
  bool evaluate(const Vector& at);
  /// Makes this point the one from which the arcs of rolling contacts are continued.
  void accept(const Vector& at);
  /// Determines from the first point the whole turns of angles and the phases of rolling contacts.
  void fix_turns();

  Vector residual;
  Matrix jacobian;

private:
  [[nodiscard]] static Eigen::Index column(int body) { return 3 * (static_cast<Eigen::Index>(body) - 1); }
  [[nodiscard]] RealVector origin(int body) const {
    return body == 0 ? RealVector(RealVector::Zero()) : RealVector(at_.segment<2>(column(body)));
  }
  [[nodiscard]] Real theta(int body) const { return body == 0 ? 0 : at_[column(body) + 2]; }
  [[nodiscard]] RealVector in_ground(int body, const RealVector& p_B) const {
    return origin(body) + turned(theta(body), p_B);
  }
  [[nodiscard]] RealVector point(const PointRef& ref) const {
    const Body& owner = mechanism_.bodies[ref.body];
    return in_ground(ref.body, owner.points[ref.point].p_B.cast<Real>());
  }
  [[nodiscard]] Face face_of(const CurveRef& ref, bool first) const;
  [[nodiscard]] Eigen::Index normal_column(std::size_t contact) const {
    return body_unknowns() + static_cast<Eigen::Index>(contact);
  }
  [[nodiscard]] Real heading_on(const Face& face, Real normal) const {
    return normal + face.flip - theta(face.body) - face.axis;
  }

  void row(Real value) {
    residual.conservativeResize(count_ + 1);
    residual[count_++] = value;
  }
  void by(Eigen::Index index, Real value) { jacobian(count_ - 1, index) += value; }
  void by_angle(int body, Real value) {
    if (body != 0) by(column(body) + 2, value);
  }
  void by_point(int body, const RealVector& p_W, const RealVector& e, Real sign) {
    if (body == 0) return;
    by(column(body), sign * e.x());
    by(column(body) + 1, sign * e.y());
    by_angle(body, sign * e.dot(left_of(p_W - origin(body))));
  }
  void by_foot(const Face& face, const RealVector& p_W, Real rho, Real normal, Eigen::Index index,
               const RealVector& e, Real sign);
  void add_along(const Joint& joint, bool along, Real target, Real by_share);
  void add_angle(const Joint& joint, Real target, Real by_share);
  void add_joint(std::size_t index);
  void add_driver(std::size_t index);
  void add_meeting(const Touch& touch, Real normal, Eigen::Index index);
  void add_face(const Touch& touch, Real normal, Eigen::Index index, bool line_first);
  void add_rolling(const Touch& touch, Real normal, Eigen::Index index);
  [[nodiscard]] RealVector foot(const Face& face, const ConicPoint& at) const {
    return in_ground(face.body, face.curve->vertex_B.cast<Real>() + turned(face.axis, at.p));
  }
  [[nodiscard]] Real miss(const Touch& touch, Real normal) const;
  void guess_normal(std::size_t contact);

  Mechanism mechanism_;
  std::vector<Real> from_, change_;
  std::vector<Touch> touches_;
  std::vector<Real> turns_, driver_turns_;  // whole turns in the angles of joints and drivers
  Real size_ = 1;
  Real path_ = 0;
  bool exists_ = true;
  Vector at_;
  Eigen::Index count_ = 0;
  std::vector<Eigen::Index> rolling_rows_;
};

Conditions::Conditions(const Mechanism& mechanism, const std::vector<double>& from,
                       const std::vector<double>& to)
    : mechanism_(scaled(mechanism, size_of_points(mechanism))), size_(size_of_points(mechanism)) {
  for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) {
    const Joint& joint = mechanism_.joints[mechanism_.drivers[i].joint];
    const Real unit = joint.type == JointType::kRevolute ? 1 : size_;
    from_.push_back(static_cast<Real>(from[i]) / unit);
    change_.push_back((static_cast<Real>(to[i]) - static_cast<Real>(from[i])) / unit);
    path_ = std::hypot(path_, change_.back());
  }
  for (const Contact& contact : mechanism_.contacts) {
    touches_.push_back({face_of(contact.first, true), face_of(contact.second, false), contact.rolling});
  }
  rolling_rows_.resize(touches_.size());
  turns_.resize(mechanism_.joints.size());
  driver_turns_.resize(from_.size());
  at_ = Vector::Zero(unknowns());
  for (std::size_t i = 1; i < mechanism_.bodies.size(); ++i) {
    const Body& body = mechanism_.bodies[i];
    at_.segment<3>(column(static_cast<int>(i))) << body.guess_p_WB.x(), body.guess_p_WB.y(), body.guess_theta;
  }
  for (std::size_t i = 0; i < touches_.size(); ++i) guess_normal(i);
}

Face Conditions::face_of(const CurveRef& ref, bool first) const {
  const Curve& curve = mechanism_.bodies[ref.body].curves[ref.curve].curve;
  const bool outside = curve.side == Side::kOutside;
  Face face;
  face.curve = &curve;
  face.body = ref.body;
  face.axis = std::atan2(static_cast<Real>(curve.axis_B.y()), static_cast<Real>(curve.axis_B.x()));
  face.flip = first == outside ? kHalfTurn : 0;
  // Positive along the contact's tangent where the convex side's normal is the contact's normal, else
  // negative.
  face.arc_sign = first == outside ? -1 : 1;
  return face;
}

// Distance of the two points that have this normal; for a line, the deviation of its own normal from it.
Real Conditions::miss(const Touch& touch, Real normal) const {
  for (const Face* face : {&touch.first, &touch.second}) {
    if (face->curve->kind == CurveKind::kLine) {
      return std::abs(std::sin((heading_on(*face, normal) - kHalfTurn) / 2));
    }
  }
  const ConicPoint one = conic_point(*touch.first.curve, heading_on(touch.first, normal));
  const ConicPoint two = conic_point(*touch.second.curve, heading_on(touch.second, normal));
  return one.exists && two.exists ? (foot(touch.first, one) - foot(touch.second, two)).norm()
                                  : std::numeric_limits<Real>::infinity();
}

// The normal for which the curves come nearest to each other in the poses.
void Conditions::guess_normal(std::size_t contact) {
  const Touch& touch = touches_[contact];
  constexpr int kTries = 7200;
  Real spacing = 2 * kHalfTurn / kTries;
  Real best = 0;
  for (int i = 1; i < kTries; ++i) {
    best = miss(touch, spacing * i) < miss(touch, best) ? spacing * i : best;
  }
  // Refined to full precision, because the arcs of rolling contacts begin there.
  for (; spacing > 1e-19L; spacing *= 0.7L) {
    for (const Real next : {best - spacing, best + spacing}) {
      best = miss(touch, next) < miss(touch, best) ? next : best;
    }
  }
  at_[normal_column(contact)] = best;
}

// Residual e·(P2 - P1), with e along the joint's line or to its left.
void Conditions::add_along(const Joint& joint, bool along, Real target, Real by_share) {
  const int A = joint.first.body;
  const RealVector direction = turned(theta(A), joint.direction_A.cast<Real>());
  const RealVector e = along ? direction : left_of(direction);
  const RealVector p1 = point(joint.first);
  const RealVector p2 = point(joint.second);
  row(e.dot(p2 - p1) - target);
  by_point(joint.second.body, p2, e, 1);
  by_point(A, p1, e, -1);
  by_angle(A, left_of(e).dot(p2 - p1));
  by(share_index(), -by_share);
}

void Conditions::add_angle(const Joint& joint, Real target, Real by_share) {
  row(theta(joint.second.body) - theta(joint.first.body) - target);
  by_angle(joint.second.body, 1);
  by_angle(joint.first.body, -1);
  by(share_index(), -by_share);
}

void Conditions::add_joint(std::size_t index) {
  const Joint& joint = mechanism_.joints[index];
  switch (joint.type) {
    case JointType::kRevolute: {
      const RealVector p1 = point(joint.first);
      const RealVector p2 = point(joint.second);
      for (const RealVector& e : {RealVector(1, 0), RealVector(0, 1)}) {
        row(e.dot(p2 - p1));
        by_point(joint.second.body, p2, e, 1);
        by_point(joint.first.body, p1, e, -1);
      }
      return;
    }
    case JointType::kPrismatic:
      add_angle(joint, static_cast<Real>(joint.relative_angle) + turns_[index], 0);
      [[fallthrough]];
    case JointType::kSlot:
      add_along(joint, false, 0, 0);
      return;
    case JointType::kGears:
    case JointType::kBelt:
      break;
  }
  const Real ratio = joint.turning_ratio;
  row(theta(joint.second.body) - theta(joint.carrier) -
      ratio * (theta(joint.first.body) - theta(joint.carrier)) - joint.relative_angle - turns_[index]);
  by_angle(joint.second.body, 1);
  by_angle(joint.first.body, -ratio);
  by_angle(joint.carrier, ratio - 1);
}

void Conditions::add_driver(std::size_t index) {
  const Joint& joint = mechanism_.joints[mechanism_.drivers[index].joint];
  const Real rate = path_ > 0 ? change_[index] / path_ : 0;
  const Real target = from_[index] + rate * at_[share_index()];
  if (joint.type == JointType::kRevolute) {
    add_angle(joint, target + driver_turns_[index], rate);
  } else {
    add_along(joint, true, target, rate);
  }
}

// Derivative of e·p, where p is the point of a curve that has the contact's normal: by the body's motion and
// along the curve.
void Conditions::by_foot(const Face& face, const RealVector& p_W, Real rho, Real normal, Eigen::Index index,
                         const RealVector& e, Real sign) {
  by_point(face.body, p_W, e, sign);
  const Real along = sign * rho * e.dot(left_of(heading(normal + face.flip)));
  by(index, along);
  by_angle(face.body, -along);
}

void Conditions::add_meeting(const Touch& touch, Real normal, Eigen::Index index) {
  std::array<RealVector, 2> p_W;
  std::array<Real, 2> rho{};
  const std::array<const Face*, 2> faces{&touch.first, &touch.second};
  for (std::size_t i = 0; i < 2; ++i) {
    const Face& face = *faces[i];
    const ConicPoint at = conic_point(*face.curve, heading_on(face, normal));
    exists_ = exists_ && at.exists;
    p_W[i] = foot(face, at);
    rho[i] = at.rho;
  }
  for (const RealVector& e : {RealVector(1, 0), RealVector(0, 1)}) {
    row(e.dot(p_W[1] - p_W[0]));
    by_foot(touch.second, p_W[1], rho[1], normal, index, e, 1);
    by_foot(touch.first, p_W[0], rho[0], normal, index, e, -1);
  }
}

// The line determines the normal, and the other curve's point with this normal lies on the line.
void Conditions::add_face(const Touch& touch, Real normal, Eigen::Index index, bool line_first) {
  const Face& line = line_first ? touch.first : touch.second;
  const Face& other = line_first ? touch.second : touch.first;
  row(heading_on(line, normal) - kHalfTurn - touch.turns);
  by(index, 1);
  by_angle(line.body, -1);
  const ConicPoint at = conic_point(*other.curve, heading_on(other, normal));
  exists_ = exists_ && at.exists;
  const RealVector p_W = foot(other, at);
  const RealVector foot_W = in_ground(line.body, line.curve->vertex_B.cast<Real>());
  const RealVector e = heading(theta(line.body) + line.axis);
  row(e.dot(p_W - foot_W));
  by_foot(other, p_W, at.rho, normal, index, e, 1);
  by_point(line.body, foot_W, e, -1);
  by_angle(line.body, left_of(e).dot(p_W - foot_W));
}

// The arcs along both curves grow equally, along the tangent (the normal turned by +90°). On a line the arc
// is the coordinate of the contact point along it.
void Conditions::add_rolling(const Touch& touch, Real normal, Eigen::Index index) {
  const auto is_line = [](const Face& face) { return face.curve->kind == CurveKind::kLine; };
  row(-touch.phase);
  for (const Face* face : {&touch.first, &touch.second}) {
    const Real sign = face == &touch.first ? 1 : -1;
    if (is_line(*face)) {
      const Face& other = face == &touch.first ? touch.second : touch.first;
      const ConicPoint at = conic_point(*other.curve, heading_on(other, normal));
      const RealVector p_W = foot(other, at);
      const RealVector foot_W = in_ground(face->body, face->curve->vertex_B.cast<Real>());
      // The outward normal of a line is opposite to its axis; that of the second body is opposite to the
      // contact's.
      const RealVector t = left_of(heading(theta(face->body) + face->axis + (sign > 0 ? kHalfTurn : 0)));
      residual[count_ - 1] += sign * t.dot(p_W - foot_W);
      by_foot(other, p_W, at.rho, normal, index, t, sign);
      by_point(face->body, foot_W, t, -sign);
      by_angle(face->body, sign * left_of(t).dot(p_W - foot_W));
      continue;
    }
    const Real m = heading_on(*face, normal);
    const Real rho = conic_point(*face->curve, m).rho;
    residual[count_ - 1] += sign * (face->arc + face->arc_sign * arc_between(*face->curve, face->last_m, m));
    by(index, sign * face->arc_sign * rho);
    by_angle(face->body, -sign * face->arc_sign * rho);
  }
}

bool Conditions::evaluate(const Vector& at) {
  at_ = at;
  exists_ = true;
  count_ = 0;
  residual.resize(0);
  jacobian =
      Matrix::Zero(4 * static_cast<Eigen::Index>(mechanism_.joints.size() + touches_.size() + 1), unknowns());
  for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) add_joint(i);
  for (std::size_t i = 0; i < from_.size(); ++i) add_driver(i);
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    const Touch& touch = touches_[i];
    const Eigen::Index index = normal_column(i);
    const bool line_first = touch.first.curve->kind == CurveKind::kLine;
    if (line_first || touch.second.curve->kind == CurveKind::kLine) {
      add_face(touch, at[index], index, line_first);
    } else {
      add_meeting(touch, at[index], index);
    }
    rolling_rows_[i] = count_;
    if (touch.rolling) add_rolling(touch, at[index], index);
  }
  jacobian.conservativeResize(count_, Eigen::NoChange);
  return exists_ && residual.allFinite() && jacobian.allFinite();
}

void Conditions::accept(const Vector& at) {
  at_ = at;
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    for (Face* face : {&touches_[i].first, &touches_[i].second}) {
      const Real m = heading_on(*face, at[normal_column(i)]);
      if (touches_[i].rolling && face->curve->kind != CurveKind::kLine) {
        face->arc += face->arc_sign * arc_between(*face->curve, face->last_m, m);
      }
      face->last_m = m;
    }
  }
}

void Conditions::fix_turns() {
  const auto whole = [](Real angle) { return 2 * kHalfTurn * std::round(angle / (2 * kHalfTurn)); };
  for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
    const Joint& joint = mechanism_.joints[i];
    if (joint.type == JointType::kPrismatic) {
      turns_[i] = whole(theta(joint.second.body) - theta(joint.first.body) - joint.relative_angle);
    } else if (couples_turning(joint.type)) {
      turns_[i] = theta(joint.second.body) - theta(joint.carrier) -
                  joint.turning_ratio * (theta(joint.first.body) - theta(joint.carrier)) -
                  joint.relative_angle;
      turns_[i] = whole(turns_[i]);
    }
  }
  for (std::size_t i = 0; i < from_.size(); ++i) {
    const Joint& joint = mechanism_.joints[mechanism_.drivers[i].joint];
    driver_turns_[i] = whole(theta(joint.second.body) - theta(joint.first.body) - from_[i]);
  }
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    Touch& touch = touches_[i];
    const Real normal = at_[normal_column(i)];
    for (Face* face : {&touch.first, &touch.second}) {
      face->last_m = heading_on(*face, normal);
      if (face->curve->kind == CurveKind::kLine) touch.turns = whole(face->last_m - kHalfTurn);
    }
  }
  const Vector start = at_;
  evaluate(start);
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    if (touches_[i].rolling) touches_[i].phase = residual[rolling_rows_[i]];
  }
}

// Follows the solution curve in steps of its arc length.
class Follower {
public:
  Follower(const Mechanism& mechanism, const std::vector<double>& from, const std::vector<double>& to)
      : conditions_(mechanism, from, to) {}

  ReferenceMotion run(const std::vector<double>& stations);

private:
  struct Point {
    Vector at;
    Vector tangent;     // unit
    Real bordered = 0;  // determinant of the Jacobian bordered by the tangent: 0 where branches cross
    [[nodiscard]] Real forward() const { return tangent[tangent.size() - 1]; }
  };

  bool assemble();
  bool set_tangent(Point& point, const Vector& near);
  std::optional<Point> stepped(const Point& from, Real length);
  std::optional<Vector> solved(const Vector& guess, const Vector& across);
  [[nodiscard]] Real share(const Point& point) const {
    return point.at[conditions_.share_index()] / conditions_.path();
  }
  Real turning_point(const Point& from, Real length);
  bool keep_stations(const std::vector<double>& stations, const Point& from, const Point& to, Real length);
  void keep(const Vector& at);
  ReferenceMotion gave_up(const std::string& why) {
    result_.end = ReferenceMotion::End::kGaveUp;
    result_.why = why;
    return result_;
  }

  Conditions conditions_;
  ReferenceMotion result_;
  Vector start_;
};

// Newton's method at the start with the smallest change: the poses need not satisfy the conditions.
bool Follower::assemble() {
  conditions_.fix_turns();
  start_ = conditions_.posed();
  const Eigen::Index n = conditions_.unknowns() - 1;
  for (int i = 0; i < 40; ++i) {
    if (!conditions_.evaluate(start_) || conditions_.residual.size() != n) return false;
    Eigen::ColPivHouseholderQR<Matrix> qr(conditions_.jacobian.leftCols(n));
    qr.setThreshold(1e-9L);
    if (qr.rank() < n) return false;
    const Vector change = qr.solve(-conditions_.residual);
    start_.head(n) += change;
    if (change.norm() < 1e-17L) break;
  }
  return conditions_.evaluate(start_) && conditions_.residual.norm() < 1e-15L;
}

bool Follower::set_tangent(Point& point, const Vector& near) {
  if (!conditions_.evaluate(point.at)) return false;
  const Eigen::Index n = conditions_.unknowns();
  Matrix bordered(n, n);
  bordered << conditions_.jacobian, near.transpose();
  const Eigen::PartialPivLU<Matrix> lu(bordered);
  Vector right = Vector::Zero(n);
  right[n - 1] = 1;
  point.tangent = lu.solve(right).normalized();
  point.bordered = lu.determinant();
  return point.tangent.allFinite();
}

// Newton's method in the plane through the guess that is perpendicular to `across`.
std::optional<Vector> Follower::solved(const Vector& guess, const Vector& across) {
  const Eigen::Index n = conditions_.unknowns();
  Vector at = guess;
  Real last = std::numeric_limits<Real>::infinity();
  for (int i = 0; i < 12; ++i) {
    if (!conditions_.evaluate(at)) return std::nullopt;
    Matrix bordered(n, n);
    bordered << conditions_.jacobian, across.transpose();
    Vector right(n);
    right << -conditions_.residual, across.dot(guess - at);
    const Vector change = Eigen::PartialPivLU<Matrix>(bordered).solve(right);
    const Real size = change.norm();
    if (!(size < 2 * last) || !(size < 0.1L)) return std::nullopt;
    at += change;
    if (size < 1e-17L) return at;
    last = size;
  }
  return last < 1e-15L ? std::optional(at) : std::nullopt;
}

std::optional<Follower::Point> Follower::stepped(const Point& from, Real length) {
  const Vector guess = from.at + length * from.tangent;
  const auto at = solved(guess, from.tangent);
  if (!at || (*at - guess).norm() > 0.05L * length) return std::nullopt;
  Point to;
  to.at = *at;
  if (!set_tangent(to, from.tangent)) return std::nullopt;
  return to;
}

// The distance from `from`, at most `length`, at which the drivers turn back.
Real Follower::turning_point(const Point& from, Real length) {
  Real low = 0;
  Real high = length;
  for (int i = 0; i < 80 && high - low > 1e-18L; ++i) {
    const Real middle = (low + high) / 2;
    const auto to = stepped(from, middle);
    (to && to->forward() > 0 ? low : high) = middle;
  }
  return low;
}

void Follower::keep(const Vector& at) {
  std::vector<double> places;
  for (Eigen::Index i = 0; i < conditions_.body_unknowns(); i += 3) {
    places.push_back(static_cast<double>(at[i] * conditions_.size()));
    places.push_back(static_cast<double>(at[i + 1] * conditions_.size()));
    places.push_back(static_cast<double>(at[i + 2]));
  }
  result_.places.push_back(places);
}

// Records the stations within a step. Each is found by the step length that leads to its fraction of the path
// (Illinois method).
bool Follower::keep_stations(const std::vector<double>& stations, const Point& from, const Point& to,
                             Real length) {
  for (; result_.places.size() < stations.size();) {
    const Real wanted = stations[result_.places.size()];
    Real low = 0;
    Real high = length;
    Real miss_low = share(from) - wanted;
    Real miss_high = share(to) - wanted;
    if (miss_high < 0) return true;
    Vector at = miss_high == 0 ? to.at : from.at;
    Real miss = miss_high == 0 ? 0 : miss_low;
    for (int i = 0; i < 60 && std::abs(miss) > 1e-18L; ++i) {
      const Real middle = (low * miss_high - high * miss_low) / (miss_high - miss_low);
      const auto found = solved(from.at + middle * from.tangent, from.tangent);
      if (!found) return false;
      at = *found;
      const bool again = miss * (at[conditions_.share_index()] / conditions_.path() - wanted) > 0;
      miss = at[conditions_.share_index()] / conditions_.path() - wanted;
      (miss < 0 ? low : high) = middle;
      (miss < 0 ? miss_low : miss_high) = miss;
      if (again && i > 0) (miss < 0 ? miss_high : miss_low) /= 2;
    }
    keep(at);
  }
  return true;
}

ReferenceMotion Follower::run(const std::vector<double>& stations) {
  if (!(conditions_.path() > 0)) return gave_up("the drivers do not move");
  if (!assemble()) return gave_up("not regular at the start");
  conditions_.accept(start_);
  Point here{start_, {}, 0};
  Vector forward = Vector::Zero(conditions_.unknowns());
  forward[conditions_.share_index()] = 1;
  if (!set_tangent(here, forward)) return gave_up("no tangent at the start");
  keep_stations(stations, here, here, 0);
  Real length = 1e-4L;
  for (int i = 0; i < kMostSteps; ++i) {
    const auto to = stepped(here, length);
    const Real bend = to ? (to->tangent - here.tangent).norm() : 1;
    const bool slow = to && std::abs(to->forward() - here.forward()) <= 0.25L * here.forward();
    if (bend > kLargestBend || (!slow && length > kSmallStep)) {
      length *= 0.5L;
      if (length < kShortestStep) return gave_up("steps became too short");
      continue;
    }
    if (to->forward() <= 0) {
      const auto limit = stepped(here, turning_point(here, length));
      result_.end = ReferenceMotion::End::kLimit;
      result_.share = static_cast<double>(share(limit ? *limit : here));
      return result_;
    }
    if (!keep_stations(stations, here, *to, length)) return gave_up("no solution at a station");
    // set_tangent borders with the previous tangent: this determinant keeps its sign where no branches cross.
    if (i > 0 && (to->bordered > 0) != (here.bordered > 0)) {
      result_.crossings.push_back(static_cast<double>(share(*to)));
    }
    here = *to;
    conditions_.accept(here.at);
    if (share(here) >= 1) {
      result_.end = ReferenceMotion::End::kReached;
      result_.share = 1;
      return result_;
    }
    // Longer steps where something is far away: a slide nearly parallel to another one moves by hundreds of
    // sizes.
    const Real far = std::max<Real>(1, here.at.cwiseAbs().maxCoeff() / 8);
    length = std::min(far * kLongestStep, bend < 0.5L * kLargestBend ? 1.5L * length : length);
  }
  result_.share = static_cast<double>(share(here));
  return gave_up("too many steps");
}

}  // namespace

ReferenceMotion reference_motion(const Mechanism& mechanism, const std::vector<double>& from,
                                 const std::vector<double>& to, const std::vector<double>& stations) {
  return Follower(mechanism, from, to).run(stations);
}

}  // namespace higherpair::testing
