#include "higherpair/contact/subdivision.hpp"

#include "contact_equations.hpp"
#include "possible_contacts.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

using boost::numeric::median;
using boost::numeric::overlap;
using boost::numeric::subset;

// A closed curve is asked at any angle; its boxes stay near one turn.
constexpr double kAnyAngle = 100;

Interval any_angle() {
  return {-kAnyAngle, kAnyAngle};
}

struct Domain {
  Interval limits;
  std::vector<Interval> tiles;
  bool is_periodic = false;
};

Domain domain_of(const SupportPiece& piece) {
  if (piece.kind == PieceKind::kClosed) {
    return {any_angle(), tiles_of(piece), true};
  }
  return {to_interval(piece.phi), tiles_of(piece), false};
}

bool is_point(const SupportCurve& curve) {
  if (curve.pieces().size() != 1 || curve.pieces()[0].kind != PieceKind::kClosed) {
    return false;
  }
  const Bounds rho = curve.radius(0, {-kPi, kPi});
  return rho.low == 0 && rho.high == 0;
}

// What one search over a pair of pieces is given and where its findings go.
struct Enumeration {
  const SupportPair& pair;
  double u;
  const SubdivisionOptions& options;
  std::size_t searches_left = 0;
  double size = 0;  // of the pair [m]
  SubdivisionContacts result{};
  std::vector<PossiblePlace> places{};
  bool exhausted = false;

  // Each search may use its share of what the others left over.
  std::size_t next_budget() {
    const std::size_t left = options.max_boxes - std::min(options.max_boxes, result.boxes);
    return std::max<std::size_t>(1, left / std::max<std::size_t>(1, searches_left--));
  }

  void add(const Arrangement& a, const PieceContact& place, bool is_root) {
    const Within within = is_within(a, place, options.range);
    if (within == Within::kNo) {
      return;
    }
    if (is_root && within == Within::kYes) {
      result.contacts.push_back(contact_at(a, place));
    } else {
      places.push_back({place, a.sigma < 0});
    }
  }

  [[nodiscard]] CertifiedContact contact_at(const Arrangement& a, const PieceContact& place) const {
    const auto [i, j] = place.pieces;
    const bool face1 = a.curve1.pieces()[i].kind == PieceKind::kFace;
    const bool face2 = a.curve2.pieces()[j].kind == PieceKind::kFace;
    CertifiedContact contact = positioned(a, place, !face1 && !face2);
    contact.u = u;
    contact.opposed = a.sigma < 0;
    contact.piece1 = i;
    contact.piece2 = j;
    contact.n_W = unit_vector(median(place.psi1 + a.theta1));
    const SupportValue first = a.curve1.at(i, median(place.psi1));
    const SupportValue second = a.curve2.at(j, median(place.psi2));
    const auto point = [](const SupportValue& value, const Interval& psi, const Pose<double>& X) {
      const Vector2d n = unit_vector(median(psi));
      return Vector2d(X * Vector2d(value.h * n + value.dh * perp(n)));
    };
    contact.p_W = face1 ? point(second, place.psi2, pose_at(pair.motion2, contact.q))
                        : point(first, place.psi1, pose_at(pair.motion1, u));
    contact.rho1 = face1 ? 0 : first.rho;
    contact.rho2 = face2 ? 0 : second.rho;
    const double gap_q = contact.n_W.dot(velocity_per_q(pair.motion2, contact.p_W));
    contact.branch = !contact.opposed || gap_q == 0 ? 0 : (gap_q > 0 ? 1 : -1);
    return contact;
  }

  // The coordinate and its bounds; a turning one in (-π, π], polished for two arcs.
  [[nodiscard]] static CertifiedContact positioned(const Arrangement& a, const PieceContact& place,
                                                   bool arcs) {
    CertifiedContact contact;
    const double turns = a.turns ? std::round(median(place.q) / (2 * kPi)) : 0;
    contact.q_bounds = to_bounds(turns == 0 ? place.q : place.q - 2 * turns * half_turn());
    contact.q = median(to_interval(contact.q_bounds));
    if (a.turns && arcs) {
      const double polished = polished_turning_coordinate(a, place.pieces, median(place.psi1), contact.q);
      contact.q = std::clamp(polished, contact.q_bounds.low, contact.q_bounds.high);
    }
    if (a.turns && contact.q <= -kPi) {
      contact.q = kPi;
    }
    return contact;
  }

  template <int N, class Expand, class PlaceOf>
  void search(const Arrangement& a, SearchProblem<N> problem, const Expand& expand, const PlaceOf& place_of) {
    problem.finest = {options.tolerance, options.tolerance * size, kLeastWidth};
    problem.budget = next_budget();
    const SearchResult<N> found = search_boxes<N>(problem, expand);
    result.boxes += found.boxes;
    exhausted = exhausted || found.exhausted;
    for (const Root<N>& root : found.roots) add(a, place_of(root.at), true);
    for (const Box<N>& box : found.undecided) add(a, place_of(box), false);
  }

  void turning_arcs(const Arrangement& a, const PiecePair& pieces) {
    const Domain first = domain_of(a.curve1.pieces()[pieces.first]);
    const Domain second = domain_of(a.curve2.pieces()[pieces.second]);
    SearchProblem<2> problem{
        {}, {first.limits, second.limits}, {first.is_periodic, second.is_periodic}, {}, 0};
    for (const Interval& x : first.tiles) {
      for (const Interval& y : second.tiles) problem.start.push_back({x, y});
    }
    if (first.is_periodic && second.is_periodic) {
      search<2>(
          a, problem, [&](const Box<2>& X) { return expand_closed(a, pieces, X); },
          [&](const Box<2>& X) {
            return PieceContact{pieces, X[0], turning_partner(a, X[0], X[1]), X[1]};
          });
    } else {
      search<2>(
          a, problem, [&](const Box<2>& X) { return expand_arcs(a, pieces, X); },
          [&](const Box<2>& X) {
            return PieceContact{pieces, X[0], X[1], turning_partner(a, X[0], X[1])};
          });
    }
  }

  void turning_face(const Arrangement& a, const PiecePair& pieces, bool face_is_first) {
    const SupportPiece& piece1 = a.curve1.pieces()[pieces.first];
    const SupportPiece& piece2 = a.curve2.pieces()[pieces.second];
    const Interval face = to_interval(face_is_first ? piece1.phi : piece2.phi);
    const Domain domain = domain_of(face_is_first ? piece2 : piece1);
    SearchProblem<1> problem{{}, {domain.limits}, {domain.is_periodic}, {}, 0};
    for (const Interval& x : domain.tiles) problem.start.push_back({x});
    search<1>(
        a, problem, [&](const Box<1>& X) { return expand_face(a, pieces, face_is_first, X); },
        [&](const Box<1>& X) {
          const Interval& psi1 = face_is_first ? face : X[0];
          const Interval& psi2 = face_is_first ? X[0] : face;
          return PieceContact{pieces, psi1, psi2, turning_partner(a, psi1, psi2)};
        });
  }

  void sliding_domain(const Arrangement& a, const PiecePair& pieces, const Interval& turn,
                      const Domain& domain) {
    SearchProblem<1> problem{{}, {domain.limits}, {domain.is_periodic}, {}, 0};
    for (const Interval& x : domain.tiles) problem.start.push_back({x});
    search<1>(
        a, problem, [&](const Box<1>& X) { return expand_slide(a, pieces, turn, X); },
        [&](const Box<1>& X) {
          return PieceContact{pieces, X[0], X[0] + turn, sliding_coordinate(a, pieces, turn, X[0])};
        });
  }

  // The second curve's normals are the first one's turned: on its piece for some of them.
  void sliding_arcs(const Arrangement& a, const PiecePair& pieces) {
    const SupportPiece& piece1 = a.curve1.pieces()[pieces.first];
    const SupportPiece& piece2 = a.curve2.pieces()[pieces.second];
    if (piece2.kind == PieceKind::kClosed) {
      return sliding_domain(a, pieces, a.turn, domain_of(piece1));
    }
    const Interval part = to_interval(piece2.phi) - a.turn;
    if (piece1.kind == PieceKind::kClosed) {
      return sliding_domain(a, pieces, a.turn, {part, tiles_of(part), false});
    }
    const long first_turn = std::lround(std::ceil((piece1.phi.low - part.upper()) / (2 * kPi) - 1e-9));
    const long last_turn = std::lround(std::floor((piece1.phi.high - part.lower()) / (2 * kPi) + 1e-9));
    for (long k = first_turn; k <= last_turn; ++k) {
      const Interval whole_turns = 2.0 * static_cast<double>(k) * half_turn();
      const Interval moved = part + whole_turns;
      if (overlap(moved, to_interval(piece1.phi))) {
        const Interval both = intersect(moved, to_interval(piece1.phi));
        sliding_domain(a, pieces, a.turn - whole_turns, {both, tiles_of(both), false});
      }
    }
  }

  // The normals are given by a face, and so is q.
  void sliding_face(const Arrangement& a, const PiecePair& pieces) {
    const SupportPiece& piece1 = a.curve1.pieces()[pieces.first];
    const SupportPiece& piece2 = a.curve2.pieces()[pieces.second];
    const bool face1 = piece1.kind == PieceKind::kFace;
    const SupportPiece& other = face1 ? piece2 : piece1;
    Interval psi = face1 ? to_interval(piece1.phi) + a.turn : to_interval(piece2.phi) - a.turn;
    bool certain = true;
    if (other.kind != PieceKind::kClosed) {
      const double away = median(to_interval(other.phi)) - median(psi);
      psi += 2 * std::round(away / (2 * kPi)) * half_turn();
      if (!overlap(psi, to_interval(other.phi))) {
        return;
      }
      certain = other.kind == PieceKind::kArc && subset(psi, to_interval(other.phi));
    }
    const Interval psi1 = face1 ? to_interval(piece1.phi) : psi;
    const Interval psi2 = face1 ? psi : to_interval(piece2.phi);
    const Interval q = sliding_coordinate_of_face(a, pieces, psi1, psi2);
    const bool along = !std::isfinite(boost::numeric::width(q));
    if (!along || may_touch(a, pieces, psi1, psi2)) {
      add(a, {pieces, psi1, psi2, q}, certain && !along);
    }
  }

  void turning_faces(const Arrangement& a, const PiecePair& pieces) {
    const Interval psi1 = to_interval(a.curve1.pieces()[pieces.first].phi);
    const Interval psi2 = to_interval(a.curve2.pieces()[pieces.second].phi);
    if (may_touch(a, pieces, psi1, psi2)) {
      add(a, {pieces, psi1, psi2, turning_partner(a, psi1, psi2)}, false);
    }
  }

  void enumerate(const Arrangement& a, const PiecePair& pieces) {
    const bool face1 = a.curve1.pieces()[pieces.first].kind == PieceKind::kFace;
    const bool face2 = a.curve2.pieces()[pieces.second].kind == PieceKind::kFace;
    if (a.turns) {
      if (face1 && face2) return turning_faces(a, pieces);
      if (face1 || face2) return turning_face(a, pieces, face1);
      return turning_arcs(a, pieces);
    }
    return face1 || face2 ? sliding_face(a, pieces) : sliding_arcs(a, pieces);
  }
};

}  // namespace

SubdivisionContacts find_contacts_by_subdivision(const SupportPair& pair, double u,
                                                 const SubdivisionOptions& options) {
  assert(std::isfinite(u) && options.tolerance > 0 && options.max_boxes > 0);
  assert(options.range.low <= options.range.high);
  const std::size_t count1 = pair.curve1.pieces().size();
  const std::size_t count2 = pair.curve2.pieces().size();
  const bool only_opposed = is_point(pair.curve1) || is_point(pair.curve2);
  Enumeration enumeration{pair, u, options, (only_opposed ? 1 : 2) * count1 * count2,
                          size_of(make_arrangement(pair, u, true))};
  for (const bool opposed : {true, false}) {
    const Arrangement a = make_arrangement(pair, u, opposed);
    for (std::size_t i = 0; i < count1 && (opposed || !only_opposed); ++i) {
      for (std::size_t j = 0; j < count2; ++j) enumeration.enumerate(a, {i, j});
    }
  }
  SubdivisionContacts& result = enumeration.result;
  result.possible = merge_places(pair, make_arrangement(pair, u, true).theta1, enumeration.places,
                                 options.range, options.tolerance);
  std::sort(result.contacts.begin(), result.contacts.end(),
            [](const CertifiedContact& a, const CertifiedContact& b) { return a.q < b.q; });
  result.status = result.possible.empty() ? SubdivisionStatus::kComplete
                  : enumeration.exhausted ? SubdivisionStatus::kExhausted
                                          : SubdivisionStatus::kUndecided;
  return std::move(result);
}

SubdivisionContacts find_contacts_by_subdivision(const ContactPair& pair, double u, double reach,
                                                 const SubdivisionOptions& options) {
  const auto made = [&](const Curve& curve) {
    return curve.support == nullptr ? make_support_curve(curve, reach) : nullptr;
  };
  const auto conic1 = made(pair.curve1);
  const auto conic2 = made(pair.curve2);
  const SupportPair curves{conic1 ? *conic1 : *pair.curve1.support, pair.motion1,
                           conic2 ? *conic2 : *pair.curve2.support, pair.motion2};
  return find_contacts_by_subdivision(curves, u, options);
}

}  // namespace higherpair
