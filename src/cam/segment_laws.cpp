// The laws of segments. All except `harmonics` consist of two halves: the first is expanded about the
// beginning of the segment, the second about its end, so that whatever vanishes at an end does so exactly.
#include "law_pieces.hpp"

#include <array>

namespace higherpair {
namespace {

// A stretch of acceleration, from the end of the preceding one to the fraction `to` of the segment:
//     a = constant + cosine cos ωτ + sine sin ωτ,   τ from its beginning.
struct Stretch {
  double to = 0.5;
  double constant = 0;
  double cosine = 0;
  double sine = 0;
  double omega = 0;  // with τ as a fraction of the segment
};

// Acceleration in the first half, up to its scale; the second half is the first rotated by 180°.
std::span<const Stretch> first_half(LawType type) {
  static constexpr std::array<Stretch, 1> kParabolic = {{{0.5, 1}}};
  static constexpr std::array<Stretch, 1> kHarmonic = {{{0.5, 0, 1, 0, kPi}}};
  static constexpr std::array<Stretch, 1> kCycloidal = {{{0.5, 0, 0, 1, 2 * kPi}}};
  static constexpr std::array<Stretch, 2> kModifiedSine = {
      {{0.125, 0, 0, 1, 4 * kPi}, {0.5, 0, 1, 0, 4 * kPi / 3}}};
  static constexpr std::array<Stretch, 3> kModifiedTrapezoid = {
      {{0.125, 0, 0, 1, 4 * kPi}, {0.375, 1}, {0.5, 0, 1, 0, 4 * kPi}}};
  switch (type) {
    case LawType::kParabolic:
      return kParabolic;
    case LawType::kHarmonic:
      return kHarmonic;
    case LawType::kCycloidal:
      return kCycloidal;
    case LawType::kModifiedSine:
      return kModifiedSine;
    default:
      return kModifiedTrapezoid;
  }
}

// A part of the first half as a function f of τ, from `from` to `to` after the beginning of the segment.
struct HalfPart {
  double from = 0;
  double to = 0;
  std::vector<double> powers;
  std::vector<LawWave> waves;
};

// Integrates acceleration twice, from rest. \param scale  of acceleration \param over  length of the segment
std::vector<HalfPart> integrated(std::span<const Stretch> stretches, double over, double scale) {
  std::vector<HalfPart> parts;
  double from = 0, s = 0, v = 0;
  for (const Stretch& stretch : stretches) {
    HalfPart part{from, stretch.to * over, {s, v, scale * stretch.constant / 2}, {}};
    if (stretch.omega != 0) {
      const double omega = stretch.omega / over;
      const LawWave wave = {-scale * stretch.cosine / (omega * omega),
                            -scale * stretch.sine / (omega * omega), omega};
      part.powers[0] -= wave.cosine;
      part.powers[1] -= omega * wave.sine;
      part.waves = {wave};
    }
    LawPieces one;
    one.add({}, part.powers, part.waves);
    s = one.derivative(one.pieces.front(), 0, part.to - from);
    v = one.derivative(one.pieces.front(), 1, part.to - from);
    from = part.to;
    parts.push_back(std::move(part));
  }
  return parts;
}

double value_at_half(const std::vector<HalfPart>& parts) {
  LawPieces last;
  last.add({}, parts.back().powers, parts.back().waves);
  return last.derivative(last.pieces.front(), 0, parts.back().to - parts.back().from);
}

// The first half, and the same rotated by 180° about the middle.
void add_halves(const std::vector<HalfPart>& parts, double begin, double end, double value, double last_value,
                LawPieces& pieces) {
  for (const HalfPart& part : parts) {
    LawPiece piece{begin + part.from, begin + part.from, value};
    piece.start = part.from == 0 ? PieceStart::kSegment : PieceStart::kPart;
    pieces.add(piece, part.powers, part.waves);
  }
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    LawPiece piece{end - part->to, end - part->from, last_value};
    const bool smooth = part == parts.rbegin() && !part->waves.empty();
    piece.start = smooth ? PieceStart::kSmooth : PieceStart::kPart;
    std::vector<double> powers = part->powers;
    for (std::size_t k = 0; k < powers.size(); k += 2) {
      powers[k] = -powers[k];
    }
    std::vector<LawWave> waves = part->waves;
    for (LawWave& wave : waves) {
      wave.cosine = -wave.cosine;
    }
    pieces.add(piece, powers, waves);
  }
}

void add_by_acceleration(const LawSegment& segment, double begin, double end, double value,
                         LawPieces& pieces) {
  const std::span<const Stretch> stretches = first_half(segment.type);
  const double over = segment.over;
  const double scale = segment.rise / 2 / (value_at_half(integrated(stretches, 1, 1)) * over * over);
  add_halves(integrated(stretches, over, scale), begin, end, value, value + segment.rise, pieces);
}

// Converts the coefficients c of a polynomial in u = τ/over, times rise, to those in τ.
HalfPart half_of_polynomial(std::span<const double> c, double over, double rise) {
  HalfPart part{0, over / 2, {c.begin(), c.end()}, {}};
  double scale = rise;
  for (double& power : part.powers) {
    power *= scale;
    scale /= over;
  }
  return part;
}

double binomial(std::size_t n, std::size_t k) {
  double product = 1;
  for (std::size_t i = 1; i <= k; ++i) {
    product = product * static_cast<double>(n - k + i) / static_cast<double>(i);
  }
  return product;
}

// Powers of u of the polynomial of degree p + q - 1 with the Taylor coefficients `first` (p of them) at u = 0
// and `last` (q of them) at u = 1, less a constant: first[0] = 0. Two-point Taylor expansion:
//     s = (1-u)^q Σ A_i u^i + u^p Σ B_i (1-u)^i,
// A_i = Σ first_j C(q-1+i-j, i-j), and B_i in the same way from the derivatives by 1-u.
std::vector<double> two_point_taylor(std::span<const double> first, std::span<const double> last) {
  const std::size_t p = first.size(), q = last.size();
  std::vector<double> c(p + q, 0.0);
  const auto add = [&](double factor, std::size_t shift,
                       std::size_t exponent) {  // factor u^shift (1-u)^exponent
    for (std::size_t k = 0; k <= exponent; ++k) {
      c[shift + k] += (k % 2 == 0 ? factor : -factor) * binomial(exponent, k);
    }
  };
  for (std::size_t i = 0; i < p; ++i) {
    double a = 0;
    for (std::size_t j = 0; j <= i; ++j) {
      a += first[j] * binomial(q - 1 + i - j, i - j);
    }
    add(a, i, q);
  }
  for (std::size_t i = 0; i < q; ++i) {
    double b = 0;
    for (std::size_t j = 0; j <= i; ++j) {
      b += (j % 2 == 0 ? last[j] : -last[j]) * binomial(p - 1 + i - j, i - j);
    }
    add(b, p, i);
  }
  c.resize(p + q);
  std::copy(first.begin(), first.end(), c.begin());  // equal already, to within rounding
  return c;
}

// Taylor coefficients in u from derivatives with respect to x, without the value.
std::vector<double> taylor(const std::vector<double>& derivatives, double over) {
  std::vector<double> c = derivatives;
  double scale = 1;
  for (std::size_t k = 0; k < c.size(); ++k) {
    c[k] *= scale;
    scale *= over / static_cast<double>(k + 1);
  }
  c[0] = 0;
  return c;
}

void add_polynomial(const LawSegment& segment, double begin, double end, LawPieces& pieces) {
  const double over = segment.over;
  const double rise = segment.end.front() - segment.start.front();
  std::vector<double> first = taylor(segment.start, over);
  std::vector<double> last = taylor(segment.end, over);
  const auto half = [&](std::vector<double> here, std::vector<double> there, double change) {
    there[0] = change;
    return half_of_polynomial(two_point_taylor(here, there), over, 1);
  };
  pieces.add({begin, begin, segment.start.front()}, half(first, last, rise).powers, {});
  // Seen from the end, backwards: derivatives of odd order change sign.
  for (std::vector<double>* c : {&first, &last}) {
    for (std::size_t k = 1; k < c->size(); k += 2) {
      (*c)[k] = -(*c)[k];
    }
  }
  HalfPart backwards = half(last, first, -rise);
  for (std::size_t k = 1; k < backwards.powers.size(); k += 2) {
    backwards.powers[k] = -backwards.powers[k];
  }
  LawPiece piece{begin + over / 2, end, segment.end.front()};
  piece.start = PieceStart::kSmooth;
  pieces.add(piece, backwards.powers, {});
}

void add_harmonics(const LawSegment& segment, double begin, double end, double value, LawPieces& pieces) {
  const double over = segment.over;
  std::vector<LawWave> waves;
  double cosines = 0;
  for (std::size_t k = 0; k < std::max(segment.cosines.size(), segment.sines.size()); ++k) {
    const double cosine = k < segment.cosines.size() ? segment.cosines[k] : 0;
    const double sine = k < segment.sines.size() ? segment.sines[k] : 0;
    if (cosine != 0 || sine != 0) {
      waves.push_back({cosine, sine, 2 * kPi * static_cast<double>(k + 1) / over});
      cosines += cosine;
    }
  }
  const std::array powers = {-cosines, segment.rise / over};
  pieces.add({begin, begin, value}, powers, waves);
  LawPiece piece{begin + over / 2, end, value + segment.rise};
  piece.start = PieceStart::kSmooth;
  pieces.add(piece, powers, waves);
}

}  // namespace

double add_segment(const LawSegment& segment, double begin, double end, double value, LawPieces& pieces) {
  static constexpr std::array k345 = {0.0, 0.0, 0.0, 10.0, -15.0, 6.0};
  static constexpr std::array k4567 = {0.0, 0.0, 0.0, 0.0, 35.0, -84.0, 70.0, -20.0};
  static constexpr std::array kStraight = {0.0, 1.0};
  const double last = value + segment.rise;
  const auto add_half = [&](std::span<const double> c) {
    add_halves({half_of_polynomial(c, segment.over, segment.rise)}, begin, end, value, last, pieces);
    pieces.pieces.back().start = PieceStart::kSmooth;
  };
  switch (segment.type) {
    case LawType::kDwell:
      pieces.add({begin, begin, value}, {}, {});
      return value;
    case LawType::kUniform:
      add_half(kStraight);
      return last;
    case LawType::kPolynomial345:
      add_half(k345);
      return last;
    case LawType::kPolynomial4567:
      add_half(k4567);
      return last;
    case LawType::kPolynomial:
      add_polynomial(segment, begin, end, pieces);
      return segment.end.front();
    case LawType::kHarmonics:
      add_harmonics(segment, begin, end, value, pieces);
      return last;
    default:
      add_by_acceleration(segment, begin, end, value, pieces);
      return last;
  }
}

}  // namespace higherpair
