#include "higherpair/contact/near_places.hpp"

#include "boundary_foot.hpp"
#include "higherpair/contact/boundary_contact.hpp"
#include "higherpair/geometry/boundary_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr std::size_t kBlock = 8;            // pieces
constexpr double kSlackOfChord = 0.25;       // of a piece: how far its curve may leave the chord
constexpr double kSlackOfNormal = 0.5;       // the same of its normals
constexpr double kSamePlace = 1e-7;          // of the sizes
constexpr double kSameNormalOfPlace = 1e-3;  // [rad]
constexpr double kAtFoot = 1e-15;            // of the size

// A round cone of unit vectors, by its middle and the longest chord to it.
struct Cone {
  Vector2d middle = Vector2d::Zero();
  double chord = 0;
};

Cone cone_about(const Vector2d& sum, double slack) {
  const double norm = sum.norm();
  return norm > 0 ? Cone{sum / norm, slack} : Cone{Vector2d::UnitX(), 2};
}

bool are_opposed(const Cone& a, const Cone& b) {
  const double chords = a.chord + b.chord + 1e-9;
  return (a.middle + b.middle).squaredNorm() <= chords * chords;
}

// The boundary between two neighbouring samples, in the frame of body 1.
struct Chord {
  Vector2d from, to;
  Cone normals;
  BoundaryPlace begin, end;

  [[nodiscard]] double length() const { return (to - from).norm(); }
  [[nodiscard]] Vector2d middle() const { return (from + to) / 2; }
  // What is next to a point, along the chord.
  [[nodiscard]] double share_at(const Vector2d& p) const {
    const double squared = (to - from).squaredNorm();
    return squared > 0 ? std::clamp((p - from).dot(to - from) / squared, 0.0, 1.0) : 0.5;
  }
  [[nodiscard]] BoundaryPlace place_at(const Vector2d& p) const {
    return {begin.span, std::lerp(begin.t, end.t, share_at(p))};
  }
  [[nodiscard]] double distance_to(const Vector2d& p) const {
    return (from + share_at(p) * (to - from) - p).norm();
  }
};

struct Block {
  std::size_t begin = 0, end = 0;  // pieces
  Vector2d center = Vector2d::Zero();
  double radius = 0;
  Cone normals;
};

struct Pieces {
  std::vector<Chord> pieces;
  std::vector<Block> blocks;
};

void close_block(const std::vector<Chord>& pieces, std::size_t begin, std::vector<Block>& blocks) {
  if (begin == pieces.size()) {
    return;
  }
  Block block;
  block.begin = begin;
  block.end = pieces.size();
  Vector2d normals = Vector2d::Zero();
  for (std::size_t i = begin; i < block.end; ++i) {
    block.center += (pieces[i].from + pieces[i].to) / (2 * static_cast<double>(block.end - begin));
    normals += pieces[i].normals.middle;
  }
  block.normals = cone_about(normals, 0);
  for (std::size_t i = begin; i < block.end; ++i) {
    const Chord& piece = pieces[i];
    block.radius =
        std::max({block.radius, (piece.from - block.center).norm() + kSlackOfChord * piece.length(),
                  (piece.to - block.center).norm() + kSlackOfChord * piece.length()});
    block.normals.chord = std::max(
        block.normals.chord, (piece.normals.middle - block.normals.middle).norm() + piece.normals.chord);
  }
  blocks.push_back(block);
}

// The pieces of a boundary that are no farther from `center` than `reach`.
Pieces pieces_of(const Boundary& boundary, const Pose<double>& X_1B, const Vector2d& center, double reach) {
  Pieces all;
  std::size_t begin = 0;
  const auto& samples = boundary.samples();
  const Vector2d center_B = X_1B.inverse_times(center);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto& a = samples[i - 1];
    const auto& b = samples[i];
    if (a.place.span != b.place.span) {
      continue;
    }
    // Most are far: these are left out without roots.
    const double length2 = (b.point.p_B - a.point.p_B).squaredNorm();
    const double away2 = (a.point.p_B - center_B).squaredNorm();
    if (away2 > 2 * reach * reach + 2 * (1 + kSlackOfChord) * (1 + kSlackOfChord) * length2 ||
        std::sqrt(away2) > reach + (1 + kSlackOfChord) * std::sqrt(length2)) {
      continue;
    }
    const Vector2d from = X_1B * a.point.p_B;
    const Vector2d to = X_1B * b.point.p_B;
    const Cone normals = cone_about(a.point.n_B + b.point.n_B, 0);
    const double chord = (a.point.n_B - normals.middle).norm();
    all.pieces.push_back(
        {from, to, {X_1B.R_WB * normals.middle, (1 + kSlackOfNormal) * chord}, a.place, b.place});
    if (all.pieces.size() - begin == kBlock) {
      close_block(all.pieces, begin, all.blocks);
      begin = all.pieces.size();
    }
  }
  close_block(all.pieces, begin, all.blocks);
  return all;
}

// Whether two pieces may hold points of a common normal, not farther from each other than `reach`.
bool may_face(const Chord& a, const Chord& b, double reach) {
  if (!are_opposed(a.normals, b.normals)) {
    return false;
  }
  const double lengths = a.length() + b.length();
  const Vector2d apart = b.middle() - a.middle();
  // Over the cones of normals the tangent turns, and what is along the normal comes to count along it.
  const double turned = a.normals.chord + b.normals.chord;
  const double along = std::abs(apart.dot(perp(a.normals.middle)));
  return apart.norm() <= reach + lengths && along <= (0.5 + kSlackOfChord) * lengths + turned * apart.norm();
}

template <class F>
void for_each_facing(const Pieces& one, const Pieces& two, double reach, const F& found) {
  for (const Block& a : one.blocks) {
    for (const Block& b : two.blocks) {
      const double most = reach + a.radius + b.radius;
      if ((b.center - a.center).squaredNorm() > most * most || !are_opposed(a.normals, b.normals)) {
        continue;
      }
      for (std::size_t i = a.begin; i < a.end; ++i) {
        for (std::size_t k = b.begin; k < b.end; ++k) {
          if (may_face(one.pieces[i], two.pieces[k], reach)) {
            found(one.pieces[i].place_at(two.pieces[k].middle()),
                  two.pieces[k].place_at(one.pieces[i].middle()));
          }
        }
      }
    }
  }
}

double curvature_of(double rho) {
  return std::isinf(rho) ? 0 : 1 / rho;
}

// Whether the gap along a common normal is less than beside it.
bool is_least(const CommonNormal& at) {
  const double g = at.gap();
  if (at.rho1 == 0 || at.rho2 == 0) {
    return 1 + g * curvature_of(at.rho1 == 0 ? at.rho2 : at.rho1) > 0;
  }
  const double kappa1 = curvature_of(at.rho1);
  const double kappa2 = curvature_of(at.rho2);
  return kappa1 + kappa2 + g * kappa1 * kappa2 > 0;
}

std::optional<NearPlace> common_normal_near(const Boundary& boundary1, const Pose<double>& X_W1,
                                            const Boundary& boundary2, const Pose<double>& X_W2,
                                            const BoundaryPlace& place1, const BoundaryPlace& place2) {
  const auto found = find_boundary_normal(boundary1, X_W1, boundary2, X_W2, place1, place2);
  if (!found || !is_least(found->at)) {
    return std::nullopt;
  }
  return NearPlace{found->at, found->place1, found->place2, 0};
}

// Whether an end is an edge on which an outward normal lies: then it is touched at a common normal.
bool is_on_edge(const Boundary& boundary, const BoundaryPlace& end, const Vector2d& n_B) {
  if (!boundary.is_corner(end)) {
    return false;
  }
  const Bounds range = range_of(boundary, end.span);
  return std::abs(nearest_turn(angle_of(n_B) - (range.low + range.high) / 2, 0)) <= range.width() / 2;
}

// An end of boundary `end` over the other boundary.
struct EndOver {
  const Boundary* own;
  const Pose<double>* X_WO;
  const Boundary* other;
  const Pose<double>* X_WC;
  int end;
};

std::optional<NearPlace> end_near(const EndOver& over, const BoundaryPlace& end, const BoundaryPlace& near) {
  const Vector2d p_W = *over.X_WO * over.own->at(end).p_B;
  const auto foot = foot_near(*over.other, over.X_WC->inverse_times(p_W), near, kAtFoot);
  if (!foot) {
    return std::nullopt;
  }
  const SpanPoint point = over.other->at(*foot);
  if (is_on_edge(*over.own, end, over.X_WO->R_WB.inverse() * Vector2d(-(over.X_WC->R_WB * point.n_B)))) {
    return std::nullopt;
  }
  const double rho = radius_of(point, over.other->is_corner(*foot));
  const NearPlace place{{-(over.X_WC->R_WB * point.n_B), p_W, *over.X_WC * point.p_B, 0, rho}, end, *foot, 1};
  if (over.end == 1) {
    return place;
  }
  return NearPlace{place.at.exchanged(), place.place2, place.place1, 2};
}

// The place of the pieces that is next to a point, along their chords; none where all are farther than
// `reach`.
std::optional<BoundaryPlace> nearest_place(const Pieces& all, const Vector2d& p, double reach) {
  std::optional<BoundaryPlace> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const Block& block : all.blocks) {
    if ((block.center - p).norm() - block.radius > std::min(reach, least)) {
      continue;
    }
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const double distance = all.pieces[i].distance_to(p);
      if (distance < least) {
        least = distance;
        nearest = all.pieces[i].place_at(p);
      }
    }
  }
  return nearest;
}

// The ends of an open boundary that are near the other one. \param others  pieces of that, in the frame of
// body 1
void add_ends(const EndOver& over, const Pose<double>& X_1O, const Pieces& others, double reach,
              std::vector<NearPlace>& places) {
  const Boundary& own = *over.own;
  const auto add = [&](const BoundaryPlace& end) {
    const auto nearest = nearest_place(others, X_1O * own.at(end).p_B, reach);
    const auto place = nearest ? end_near(over, end, *nearest) : std::nullopt;
    if (place && std::abs(place->at.gap()) <= reach) {
      places.push_back(*place);
    }
  };
  for (int span = 0; span < static_cast<int>(own.spans().size()); ++span) {
    if (own.joint_after(span) == SpanJoint::kEnd) {
      add(end_of(own, span, true));
    }
    if (own.joint_after(own.next_span(span, false)) == SpanJoint::kEnd) {
      add(end_of(own, span, false));
    }
  }
}

}  // namespace

std::vector<NearPlace> near_places(const Boundary& boundary1, const Pose<double>& X_W1,
                                   const Boundary& boundary2, const Pose<double>& X_W2, double reach) {
  const Pose<double> identity;
  const Pose<double> X_12{X_W1.R_WB.inverse() * X_W2.R_WB, X_W1.inverse_times(X_W2.p_WB)};
  const Pieces one = pieces_of(boundary1, identity, X_12 * boundary2.middle_B(), boundary2.size() + reach);
  const Pieces two = pieces_of(boundary2, X_12, boundary1.middle_B(), boundary1.size() + reach);
  const double same = kSamePlace * (boundary1.size() + boundary2.size());
  std::vector<NearPlace> places;
  for_each_facing(one, two, reach, [&](const BoundaryPlace& place1, const BoundaryPlace& place2) {
    const auto found = common_normal_near(boundary1, X_W1, boundary2, X_W2, place1, place2);
    if (!found || std::abs(found->at.gap()) > reach) {
      return;
    }
    const bool known = std::any_of(places.begin(), places.end(), [&](const NearPlace& other) {
      return (other.at.p1_W - found->at.p1_W).norm() + (other.at.p2_W - found->at.p2_W).norm() <= same &&
             (other.at.n_W - found->at.n_W).norm() <= kSameNormalOfPlace;
    });
    if (!known) {
      places.push_back(*found);
    }
  });
  add_ends({&boundary1, &X_W1, &boundary2, &X_W2, 1}, identity, two, reach, places);
  add_ends({&boundary2, &X_W2, &boundary1, &X_W1, 2}, X_12, one, reach, places);
  return places;
}

std::optional<NearPlace> moved_place(const Boundary& boundary1, const Pose<double>& X_W1,
                                     const Boundary& boundary2, const Pose<double>& X_W2,
                                     const NearPlace& before) {
  switch (before.end) {
    case 1:
      return end_near({&boundary1, &X_W1, &boundary2, &X_W2, 1}, before.place1, before.place2);
    case 2:
      return end_near({&boundary2, &X_W2, &boundary1, &X_W1, 2}, before.place2, before.place1);
    default:
      return common_normal_near(boundary1, X_W1, boundary2, X_W2, before.place1, before.place2);
  }
}

}  // namespace higherpair
