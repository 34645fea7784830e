#include "higherpair/geometry/arc_polyline.hpp"

#include "higherpair/geometry/contour.hpp"
#include "higherpair/geometry/tolerances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

constexpr int kArcProbes = 16;     // of the distance, on each biarc, ...
constexpr int kStretchProbes = 4;  // ... and at least so many on every stretch of simple shape
constexpr int kArcHalvings = 24;

// An arc from a point with a tangent to another point.
class Arc {
public:
  Arc(const Vector2d& from, const Vector2d& t, const Vector2d& to) : from_(from), t_(t), chord_(to - from) {
    const double turn = angle_from_to(t, chord_);  // half of the arc's angle
    bulge_ = std::tan(turn / 2);
    kappa_ = 2 * std::sin(turn) / chord_.norm();
  }

  [[nodiscard]] double bulge() const { return std::abs(bulge_) < kStraightBulge ? 0 : bulge_; }
  [[nodiscard]] double kappa() const { return kappa_; }
  // The tangent at the start, mirrored in the chord.
  [[nodiscard]] Vector2d end_tangent() const {
    const Vector2d c = chord_.normalized();
    return 2 * t_.dot(c) * c - t_;
  }
  // Distance from its circle, also where that is nearly straight.
  [[nodiscard]] double distance(const Vector2d& p) const {
    const Vector2d r = p - from_;
    const double w = 2 * cross(t_, r) - kappa_ * r.squaredNorm();
    return std::abs(w) / (1 + std::sqrt(std::max(0.0, 1 - kappa_ * w)));
  }

private:
  Vector2d from_, t_, chord_;
  double bulge_ = 0;
  double kappa_ = 0;
};

// Where the two arcs of the biarc with tangents of equal length meet.
Vector2d middle_of_biarc(const PieceEnd& a, const PieceEnd& b) {
  const Vector2d chord = b.p_B - a.p_B;
  const double along = chord.dot(a.t_B + b.t_B);
  const double length = chord.squaredNorm();
  const double d = length / (along + std::sqrt(along * along + 2 * (1 - a.t_B.dot(b.t_B)) * length));
  return (a.p_B + b.p_B + d * (a.t_B - b.t_B)) / 2;
}

class Fitter {
public:
  Fitter(double tolerance, double size, std::vector<ArcVertex>& vertices)
      : tolerance_(tolerance), same_(std::min(kSameSpanArc * size, tolerance)), vertices_(vertices) {}

  void add(const Span& span) {
    const Bounds range = span.range();
    breaks_ = span.breaks();
    const int parts = std::max(1, static_cast<int>(std::ceil(turn_of(span) / kLongestArcTurn - kWholeParts)));
    for (int k = 0; k < parts; ++k) {
      add(span, range.low + k * (range.width() / parts), range.low + (k + 1) * (range.width() / parts), 0);
    }
  }

private:
  // The whole turning of its normal, in either sense.
  static double turn_of(const Span& span) {
    const Bounds range = span.range();
    double sum = 0;
    Vector2d n = span.at(range.low).n_B;
    const int parts = 2 * span.parts();
    for (int k = 1; k <= parts; ++k) {
      const Vector2d next = span.at(range.low + k * (range.width() / parts)).n_B;
      sum += std::abs(angle_from_to(n, next));
      n = next;
    }
    return sum;
  }

  void add(const Span& span, double from, double to, int halvings) {
    const PieceEnd a = end_at(span, from);
    const PieceEnd b = end_at(span, to);
    const Arc whole(a.p_B, a.t_B, b.p_B);
    const auto from_whole = [&](const Vector2d& p) { return whole.distance(p); };
    if ((whole.end_tangent() - b.t_B).norm() <= kSameTangent &&
        stays_within(same_, span, {from, to}, from_whole)) {
      vertices_.push_back({a.p_B, whole.bulge()});
      return;
    }
    const Vector2d middle = middle_of_biarc(a, b);
    const Arc first(a.p_B, a.t_B, middle);
    const Vector2d t = first.end_tangent();
    const Arc second(middle, t, b.p_B);
    const auto from_biarc = [&](const Vector2d& p) {
      return (p - middle).dot(t) < 0 ? first.distance(p) : second.distance(p);
    };
    const bool forward = (middle - a.p_B).dot(a.t_B) > 0 && (b.p_B - middle).dot(b.t_B) > 0;
    if (halvings == kArcHalvings ||
        (forward && stays_within(kSureShare * tolerance_, span, {from, to}, from_biarc))) {
      vertices_.push_back({a.p_B, first.bulge()});
      vertices_.push_back({middle, second.bulge()});
      return;
    }
    const double half = from + (to - from) / 2;
    add(span, from, half, halvings + 1);
    add(span, half, to, halvings + 1);
  }

  // Whether a part of the span is no farther than this from its replacement, at probes of each stretch.
  template <class Distance>
  bool stays_within(double limit, const Span& span, const Bounds& part, const Distance& distance) const {
    const auto first = std::upper_bound(breaks_.begin(), breaks_.end(), part.low);
    const auto last = std::lower_bound(first, breaks_.end(), part.high);
    const auto stretches = static_cast<int>(last - first) + 1;
    const int probes = std::max(kStretchProbes, (kArcProbes + stretches - 1) / stretches);
    double low = part.low;
    for (auto next = first;; ++next) {
      const double high = next == last ? part.high : *next;
      for (int k = 1; k < probes + (next == last ? 0 : 1); ++k) {
        if (!(distance(span.at(low + (high - low) * k / probes).p_B) <= limit)) {
          return false;
        }
      }
      if (next == last) {
        return true;
      }
      low = high;
    }
  }

  double tolerance_;
  double same_;
  std::vector<ArcVertex>& vertices_;
  std::vector<double> breaks_;  // of the span that is added
};

// The extremes of an arc within it. Each is the starting point p moved outwards by r (1 - cos φ), φ being the
// angle from p to the extreme: without cancellation also for flat arcs.
void extend_by_arc(Eigen::AlignedBox2d& box, Vector2d p, Vector2d q, double bulge) {
  if (bulge < 0) {
    std::swap(p, q);
    bulge = -bulge;
  }
  const Vector2d chord = q - p;
  const double square = bulge * bulge;
  const double radius = chord.norm() * (1 + square) / (4 * bulge);
  const Rotation<double> half_back = {(1 - square) / (1 + square), -2 * bulge / (1 + square)};
  const Vector2d n_B = -perp(Vector2d(half_back * chord.normalized()));  // outwards at p
  for (const Vector2d& e : {Vector2d(1, 0), Vector2d(0, 1), Vector2d(-1, 0), Vector2d(0, -1)}) {
    const double sine = cross(n_B, e);
    const double cosine = n_B.dot(e);
    const double angle = std::atan2(sine, cosine);
    if (angle != 0 && (angle > 0 ? angle : angle + 2 * kPi) < 4 * std::atan(bulge)) {
      box.extend(Vector2d(p + radius * (cosine < 0 ? 1 - cosine : sine * sine / (1 + cosine)) * e));
    }
  }
}

}  // namespace

double finest_tolerance(const Boundary& boundary) {
  const double largest = boundary.middle_B().norm() + boundary.size();
  return std::max({kFinestTolerance * boundary.size(), kFinestPlace * largest, kFinestLength});
}

ArcPolyline arc_polyline(const Boundary& boundary, double tolerance) {
  assert(tolerance >= finest_tolerance(boundary));
  assert(finest_tolerance(boundary) <= kCoarsestShape * boundary.size());
  ArcPolyline line;
  line.closed = boundary.is_closed();
  Fitter fitter(tolerance, boundary.size(), line.vertices);
  for (const SpanPtr& span : boundary.spans()) {
    if (!span->is_corner()) {
      fitter.add(*span);
    }
  }
  if (!line.closed && !line.vertices.empty()) {
    const Span& last = *boundary.spans().back();
    line.vertices.push_back({last.at(last.range().high).p_B, 0});
  }
  return line;
}

Eigen::AlignedBox2d box_of(const ArcPolyline& line) {
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < line.vertices.size(); ++i) {
    const ArcVertex& vertex = line.vertices[i];
    box.extend(vertex.p_B);
    const bool ends = i + 1 == line.vertices.size() && !line.closed;
    const Vector2d& next = line.vertices[(i + 1) % line.vertices.size()].p_B;
    if (!ends && vertex.bulge != 0 && next != vertex.p_B) {
      extend_by_arc(box, vertex.p_B, next, vertex.bulge);
    }
  }
  return box;
}

}  // namespace higherpair
