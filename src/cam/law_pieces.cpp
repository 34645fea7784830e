#include "law_pieces.hpp"

#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// k (k-1) … (k-n+1)
double falling(std::size_t k, int n) {
  double product = 1;
  for (int i = 0; i < n; ++i) {
    product *= static_cast<double>(k) - i;
  }
  return product;
}

}  // namespace

void LawPieces::add(LawPiece piece, std::span<const double> c, std::span<const LawWave> own_waves) {
  piece.first_power = static_cast<std::uint32_t>(powers.size());
  piece.powers = static_cast<std::uint32_t>(c.size());
  piece.first_wave = static_cast<std::uint32_t>(waves.size());
  piece.waves = static_cast<std::uint32_t>(own_waves.size());
  powers.insert(powers.end(), c.begin(), c.end());
  waves.insert(waves.end(), own_waves.begin(), own_waves.end());
  begins.push_back(piece.begin);
  pieces.push_back(piece);
}

void LawPieces::expand(const LawPiece& piece, double x, std::span<double> out) const {
  const double t = x - piece.origin;
  std::fill(out.begin(), out.end(), 0.0);
  const double* c = powers.data() + piece.first_power;
  for (std::size_t i = piece.powers; i-- > 0;) {
    for (std::size_t k = std::min(out.size(), piece.powers - i); k-- > 1;) {
      out[k] = out[k] * t + out[k - 1];
    }
    out[0] = out[0] * t + c[i];
  }
  for (const LawWave& wave : std::span(waves).subspan(piece.first_wave, piece.waves)) {
    const double angle = wave.frequency * t;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    double even = wave.cosine * cosine + wave.sine * sine;  // the wave
    double odd = wave.sine * cosine - wave.cosine * sine;   // its derivative with respect to the angle
    double factor = 1;
    for (std::size_t k = 0; k < out.size(); ++k) {
      out[k] += factor * even;
      const double next = -even;
      even = odd;
      odd = next;
      factor *= wave.frequency / static_cast<double>(k + 1);
    }
  }
  out[0] += piece.base;
}

double LawPieces::derivative(const LawPiece& piece, int k, double x) const {
  const double t = x - piece.origin;
  double sum = 0;
  const double* c = powers.data() + piece.first_power;
  for (std::size_t i = piece.powers; i-- > static_cast<std::size_t>(k);) {
    sum = sum * t + falling(i, k) * c[i];
  }
  for (const LawWave& wave : std::span(waves).subspan(piece.first_wave, piece.waves)) {
    const double cosine = std::cos(wave.frequency * t);
    const double sine = std::sin(wave.frequency * t);
    const double value =
        k % 2 == 0 ? wave.cosine * cosine + wave.sine * sine : wave.sine * cosine - wave.cosine * sine;
    sum += std::pow(wave.frequency, k) * (k % 4 < 2 ? value : -value);
  }
  return k == 0 ? sum + piece.base : sum;
}

namespace {

// Bounds of a function within `half` of a place, by two enclosures that are summed term by term. The first
// consists of the value and the size of all other terms; the second keeps the slope separately as well, since
// slopes may cancel.
struct Enclosure {
  double half = 0;
  double low = 0, high = 0;                 // first enclosure, of the sum
  double value = 0, slope = 0, beyond = 0;  // second one: value + slope d ± beyond
  double size = 0;                          // of the numbers that it was computed from

  // The n-th term of a Taylor polynomial; `largest`: the sum of the sizes of the numbers it is computed from.
  void add_power(int n, double c, double power, double largest) {
    size += largest * power;
    if (n == 0) {
      value += c;
      low += c;
      high += c;
      return;
    }
    low -= std::abs(c) * power;
    high += std::abs(c) * power;
    (n == 1 ? slope : beyond) += n == 1 ? c : std::abs(c) * power;
  }

  // p cos ωd + q sin ωd
  void add_wave(double p, double q, double omega, double largest) {
    const double turn = std::abs(omega) * half;
    size += largest;
    value += p;
    slope += q * omega;
    beyond += std::abs(p) * (turn < kPi ? 1 - std::cos(turn) : 2) + std::abs(q) * (turn - std::sin(turn));
    if (turn >= kPi / 2) {
      low -= std::hypot(p, q);
      high += std::hypot(p, q);
    } else {
      const double least = p * std::cos(turn);
      const double aside = std::abs(q) * std::sin(turn);
      low += std::min(p, least) - aside;
      high += std::max(p, least) + aside;
    }
  }

  [[nodiscard]] Bounds bounds() const {
    const double around = std::abs(slope) * half + beyond;
    const double rounding = kLawBoundsRounding * size;
    return {std::max(low, value - around) - rounding, std::min(high, value + around) + rounding};
  }
};

}  // namespace

Bounds LawPieces::bounds(const LawPiece& piece, int k, double from, double to) const {
  const double middle = (from + to) / 2 - piece.origin;
  Enclosure all{(to - from) / 2};
  const double reach = std::abs(middle) + all.half;
  if (k == 0) {
    all.add_power(0, piece.base, 1, std::abs(piece.base));
  }
  const auto degree = static_cast<int>(piece.powers) - 1;
  double power = 1;
  for (int n = 0; n + k <= degree; ++n) {
    double term = 0;
    double largest = 0;
    for (int i = degree; i >= n + k; --i) {
      const double c = falling(static_cast<std::size_t>(i), n + k) *
                       powers[piece.first_power + static_cast<std::size_t>(i)];
      term = term * middle + c;
      largest = largest * reach + std::abs(c);
    }
    all.add_power(n, term, power, largest);
    power *= all.half / (n + 1);
  }
  for (const LawWave& wave : std::span(waves).subspan(piece.first_wave, piece.waves)) {
    const double c = k % 2 == 0 ? wave.cosine : wave.sine;
    const double s = k % 2 == 0 ? wave.sine : -wave.cosine;
    const double scale = (k % 4 < 2 ? 1 : -1) * std::pow(wave.frequency, k);
    const double cosine = std::cos(wave.frequency * middle);
    const double sine = std::sin(wave.frequency * middle);
    all.add_wave(scale * (c * cosine + s * sine), scale * (s * cosine - c * sine), wave.frequency,
                 std::hypot(c, s) * std::abs(scale) * (1 + std::abs(wave.frequency) * reach));
  }
  return all.bounds();
}

bool LawPieces::vanishes(const LawPiece& piece, int k) const {
  const auto c = std::span(powers).subspan(piece.first_power, piece.powers);
  return piece.waves == 0 && (k > 0 || piece.base == 0) &&
         std::all_of(c.begin() + std::min(k, static_cast<int>(c.size())), c.end(),
                     [](double coefficient) { return coefficient == 0; });
}

}  // namespace higherpair
