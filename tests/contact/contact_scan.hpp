#pragma once

#include "higherpair/contact/contact_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/LU>

namespace higherpair::testing {

/// A tangency found by scanning both curves.
struct ScannedContact {
  double q = 0;
  Vector2d p_W = Vector2d::Zero();
  bool opposed = false;
};

/// Finds every tangency of a pair without algebra. A point of a curve and its normal n have two invariants
/// under the follower's motion: turning about the pivot keeps the point's coordinates along n and across it
/// (r·n, r·t); sliding along d keeps the direction of n and the coordinate across d. The two curves are
/// tangent where these invariants agree, that is, where two plane curves cross. The crossings are found on
/// polygons and refined.
class ContactScan {
public:
  ContactScan(const ContactPair& pair, double u, int segments = 1200)
      : pair_(pair), X_W1_(pose_at(pair.motion1, u)), segments_(segments) {}

  [[nodiscard]] std::vector<ScannedContact> run() const {
    std::vector<ScannedContact> found;
    for (const bool opposed : {true, false}) {
      const bool any_normal =
          pair_.curve1.kind == CurveKind::kPoint || pair_.curve2.kind == CurveKind::kPoint;
      if (opposed || !any_normal) {
        scan(opposed, found);
      }
    }
    return found;
  }

private:
  struct Element {
    Vector2d r;  ///< point; from the pivot, or in ground at q = 0
    double phi;  ///< angle of the outward normal
  };

  // Point of the curve at a parameter in [-1, 1], in the body's frame.
  static Element element(const Curve& curve, double s) {
    const Vector2d x_axis = curve.axis_B;
    const Vector2d y_axis = perp(x_axis);
    Vector2d local(0, 0);
    Vector2d tangent(0, 1);
    if (curve.kind == CurveKind::kPoint) {
      return {curve.vertex_B, kPi * s};
    }
    if (curve.kind == CurveKind::kLine) {
      local = {0, 200 * std::sinh(10 * s) / std::sinh(10.0)};
    } else if (curve.q == 0) {
      const double y = curve.semi_latus * std::sinh(7 * s);
      local = {y * y / (2 * curve.semi_latus), y};
      tangent = {y / curve.semi_latus, 1};
    } else {
      const auto [a, b] = semi_axes(curve);
      if (curve.q > 0) {
        local = {a * (1 - std::cos(kPi * s)), b * std::sin(kPi * s)};
        tangent = {a * std::sin(kPi * s), b * std::cos(kPi * s)};
      } else {
        local = {a * (std::cosh(7 * s) - 1), b * std::sinh(7 * s)};
        tangent = {a * std::sinh(7 * s), b * std::cosh(7 * s)};
      }
    }
    const double side = curve.side == Side::kInside ? 1 : -1;
    const Vector2d n = side * perp(tangent);
    return {curve.vertex_B + local.x() * x_axis + local.y() * y_axis,
            angle_of(n.x() * x_axis + n.y() * y_axis)};
  }

  [[nodiscard]] Element first(double s) const {
    const Element e = element(pair_.curve1, s);
    return {X_W1_ * e.r - pair_.motion2.p_WO, e.phi + std::atan2(X_W1_.R_WB.sin, X_W1_.R_WB.cos)};
  }

  [[nodiscard]] Element second(double s) const {
    const Element e = element(pair_.curve2, s);
    const Vector2d r = e.r - pair_.motion2.p_BO;
    const Rotation<double> R = pair_.motion2.turns ? Rotation<double>{} : pair_.motion2.R_WB;
    return {R * r, e.phi + std::atan2(R.sin, R.cos)};
  }

  // The two invariants; `flip` takes the opposite normal.
  [[nodiscard]] Vector2d invariants(const Element& e, bool flip) const {
    if (pair_.motion2.turns) {
      const Vector2d n = (flip ? -1 : 1) * unit_vector(e.phi);
      return {e.r.dot(n), e.r.dot(perp(n))};
    }
    return {e.phi + (flip ? kPi : 0), cross(pair_.motion2.direction_W, e.r)};
  }

  struct Vertex {
    double s;
    Vector2d at;
  };

  template <class Sample>
  [[nodiscard]] std::vector<Vertex> polygon(const Sample& sample, bool flip) const {
    std::vector<Vertex> vertices;
    for (int i = 0; i <= segments_; ++i) {
      const double s = 2.0 * i / segments_ - 1;
      Vector2d at = invariants(sample(s), flip);
      if (!pair_.motion2.turns && !vertices.empty()) {
        at.x() = nearest_turn(at.x(), vertices.back().at.x());
      }
      vertices.push_back({s, at});
    }
    return vertices;
  }

  // Bounding box of one or several edges of a polygon. Boxes nearer to each other than a tenth of their
  // longest edges count as meeting, because the curves themselves may cross there.
  struct Box {
    Vector2d low, high, longest;  // componentwise, of the edges
    std::size_t begin, end;       // indices of the vertices

    [[nodiscard]] bool meets(const Box& other, double shift) const {
      for (int k = 0; k < 2; ++k) {
        const double by = k == 0 ? shift : 0;
        const double margin = 0.1 * (longest[k] + other.longest[k]) + 1e-12;
        if (high[k] + margin < other.low[k] + by || other.high[k] + by + margin < low[k]) return false;
      }
      return true;
    }
  };

  // Boxes of `count` edges each.
  static std::vector<Box> boxes(const std::vector<Vertex>& polygon, std::size_t count) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
      const Vector2d a = polygon[i].at, b = polygon[i + 1].at, edge = (a - b).cwiseAbs();
      if (i % count == 0) boxes.push_back({a, a, edge, i, i});
      Box& box = boxes.back();
      box = {box.low.cwiseMin(a).cwiseMin(b), box.high.cwiseMax(a).cwiseMax(b), box.longest.cwiseMax(edge),
             box.begin, i + 1};
    }
    return boxes;
  }

  void scan(bool opposed, std::vector<ScannedContact>& found) const {
    const auto one = polygon([&](double s) { return first(s); }, false);
    const auto two = polygon([&](double s) { return second(s); }, opposed);
    const std::vector<Box> edges1 = boxes(one, 1), edges2 = boxes(two, 1), parts2 = boxes(two, 30);
    const int turns = pair_.motion2.turns ? 0 : 2;
    const auto for_each_meeting = [&](const Box& a, const Box& b, auto what) {
      for (int turn = -turns; turn <= turns; ++turn) {
        if (a.meets(b, 2 * kPi * turn)) what();
      }
    };
    for (const Box& a : edges1) {
      for (const Box& part : parts2) {
        bool near = false;
        for_each_meeting(a, part, [&] { near = true; });
        for (std::size_t j = part.begin; near && j < part.end; ++j) {
          for_each_meeting(a, edges2[j], [&] {
            refine((one[a.begin].s + one[a.end].s) / 2, (two[j].s + two[j + 1].s) / 2, opposed, found);
          });
        }
      }
    }
  }

  [[nodiscard]] Vector2d difference(double s1, double s2, bool opposed) const {
    Vector2d d = invariants(first(s1), false) - invariants(second(s2), opposed);
    if (!pair_.motion2.turns) {
      d.x() = nearest_turn(d.x(), 0);
    }
    return d;
  }

  void refine(double s1, double s2, bool opposed, std::vector<ScannedContact>& found) const {
    const double start1 = s1;
    const double start2 = s2;
    Eigen::Vector2d step(1, 1);
    for (int i = 0; i < 30 && step.norm() > 1e-11; ++i) {
      constexpr double h = 1e-6;
      Eigen::Matrix2d J;
      J.col(0) = (difference(s1 + h, s2, opposed) - difference(s1 - h, s2, opposed)) / (2 * h);
      J.col(1) = (difference(s1, s2 + h, opposed) - difference(s1, s2 - h, opposed)) / (2 * h);
      step = J.fullPivLu().solve(difference(s1, s2, opposed));
      s1 -= step.x();
      s2 -= step.y();
      const double near = 4.0 / segments_;
      if (!(std::abs(s1 - start1) < near && std::abs(s2 - start2) < near)) {
        return;
      }
    }
    if (!(step.norm() <= 1e-9)) {
      return;
    }
    const Element e1 = first(s1);
    const Element e2 = second(s2);
    ScannedContact contact;
    contact.opposed = opposed;
    contact.p_W = e1.r + pair_.motion2.p_WO;
    contact.q = pair_.motion2.turns ? nearest_turn(e1.phi - e2.phi + (opposed ? kPi : 0), 0)
                                    : (e1.r - e2.r).dot(pair_.motion2.direction_W);
    const bool known = std::any_of(found.begin(), found.end(), [&](const ScannedContact& other) {
      return std::abs(std::remainder(other.q - contact.q, pair_.motion2.turns ? 2 * kPi : 1e300)) < 1e-7 &&
             (other.p_W - contact.p_W).norm() < 1e-6 * (1 + contact.p_W.norm()) && other.opposed == opposed;
    });
    if (!known) {
      found.push_back(contact);
    }
  }

  const ContactPair& pair_;
  Pose<double> X_W1_;
  int segments_;
};

}  // namespace higherpair::testing
