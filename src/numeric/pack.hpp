#pragma once

#include <cstring>

#include <Eigen/Core>

// Several doubles at once, for the kernels that are templates over their scalar (numeric/scalar.hpp). Every
// operation is that on doubles in each lane, with the same rounding: the results of a kernel for a pack are
// bit for bit those for its lanes, whatever their number, provided that nothing is contracted
// (-ffp-contract=off).

namespace higherpair {

namespace pack_detail {

// Specialisations, since the attribute is lost where it depends on a template argument.
template <int W>
struct Lanes;
template <>
struct Lanes<2> {
  using Doubles = double __attribute__((vector_size(2 * sizeof(double))));
  using Bits = long long __attribute__((vector_size(2 * sizeof(double))));
};
template <>
struct Lanes<4> {
  using Doubles = double __attribute__((vector_size(4 * sizeof(double))));
  using Bits = long long __attribute__((vector_size(4 * sizeof(double))));
};
template <>
struct Lanes<8> {
  using Doubles = double __attribute__((vector_size(8 * sizeof(double))));
  using Bits = long long __attribute__((vector_size(8 * sizeof(double))));
};

// GCC fills lanes one by one if written in any other way. Not returned by value: how vectors are returned
// depends on the machine.
template <int W>
[[gnu::always_inline]] inline void set_all(double value, typename Lanes<W>::Doubles& lanes) {
#ifdef __clang__
  lanes = value - typename Lanes<W>::Doubles{};
#else
  lanes = __builtin_shuffle(typename Lanes<W>::Doubles{value}, typename Lanes<W>::Bits{});
#endif
}

}  // namespace pack_detail

/// The lanes of a pack in which a condition holds: all bits or none.
template <int W>
struct PackMask {
  mutable typename pack_detail::Lanes<W>::Bits bits;
};

/// `W` doubles, 2, 4 or 8: preferably as many as fit into a register of the machine. Members are mutable
/// because GCC keeps constants of other classes in memory.
template <int W>
struct Pack {
  using Doubles = typename pack_detail::Lanes<W>::Doubles;
  using Bits = typename pack_detail::Lanes<W>::Bits;
  static constexpr int kLanes = W;

  mutable Doubles lanes;

  Pack() = default;
  [[gnu::always_inline]] explicit Pack(double value) { pack_detail::set_all<W>(value, lanes); }
  [[gnu::always_inline]] explicit Pack(const Doubles& values) : lanes(values) {}

  [[gnu::always_inline]] static Pack load(const double* from) {
    Pack pack;
    std::memcpy(&pack.lanes, from, sizeof pack.lanes);
    return pack;
  }
  [[gnu::always_inline]] void store(double* to) const { std::memcpy(to, &lanes, sizeof lanes); }
};

/// The lanes of a pair in which a condition holds.
template <int W>
struct PairMask {
  PackMask<W> low, high;
};

/// Two packs side by side: while one waits for its own results, the other can proceed.
template <int W>
struct PackPair {
  static constexpr int kLanes = 2 * W;

  Pack<W> low, high;

  PackPair() = default;
  [[gnu::always_inline]] explicit PackPair(double value) : low(value), high(value) {}
  [[gnu::always_inline]] PackPair(const Pack<W>& first, const Pack<W>& second) : low(first), high(second) {}

  [[gnu::always_inline]] static PackPair load(const double* from) {
    return {Pack<W>::load(from), Pack<W>::load(from + W)};
  }
  [[gnu::always_inline]] void store(double* to) const {
    low.store(to);
    high.store(to + W);
  }
};

// NOLINTBEGIN(bugprone-macro-parentheses)
#define HIGHERPAIR_PACK_OPERATOR(op)                                                                  \
  template <int W>                                                                                    \
  [[gnu::always_inline]] inline Pack<W> operator op(const Pack<W>& a, const Pack<W>& b) {             \
    return Pack<W>(typename Pack<W>::Doubles(a.lanes op b.lanes));                                    \
  }                                                                                                   \
  template <int W>                                                                                    \
  [[gnu::always_inline]] inline PackPair<W> operator op(const PackPair<W>& a, const PackPair<W>& b) { \
    return {a.low op b.low, a.high op b.high};                                                        \
  }
#define HIGHERPAIR_PACK_COMPARISON(op)                                                                \
  template <int W>                                                                                    \
  [[gnu::always_inline]] inline PackMask<W> operator op(const Pack<W>& a, const Pack<W>& b) {         \
    return {a.lanes op b.lanes};                                                                      \
  }                                                                                                   \
  template <int W>                                                                                    \
  [[gnu::always_inline]] inline PairMask<W> operator op(const PackPair<W>& a, const PackPair<W>& b) { \
    return {a.low op b.low, a.high op b.high};                                                        \
  }
// NOLINTEND(bugprone-macro-parentheses)
HIGHERPAIR_PACK_OPERATOR(+)
HIGHERPAIR_PACK_OPERATOR(-)
HIGHERPAIR_PACK_OPERATOR(*)
HIGHERPAIR_PACK_OPERATOR(/)
HIGHERPAIR_PACK_COMPARISON(<)
HIGHERPAIR_PACK_COMPARISON(>)
HIGHERPAIR_PACK_COMPARISON(<=)
HIGHERPAIR_PACK_COMPARISON(>=)
HIGHERPAIR_PACK_COMPARISON(==)
#undef HIGHERPAIR_PACK_OPERATOR
#undef HIGHERPAIR_PACK_COMPARISON

template <int W>
[[gnu::always_inline]] inline Pack<W> operator-(const Pack<W>& a) {
  return Pack<W>(typename Pack<W>::Doubles(-a.lanes));
}

template <int W>
[[gnu::always_inline]] inline Pack<W> select(const PackMask<W>& mask, const Pack<W>& a, const Pack<W>& b) {
  return Pack<W>(typename Pack<W>::Doubles(mask.bits ? a.lanes : b.lanes));
}

template <int W>
[[gnu::always_inline]] inline PackMask<W> operator&(const PackMask<W>& a, const PackMask<W>& b) {
  return {a.bits & b.bits};
}

/// Whether the condition holds in every lane.
template <int W>
[[gnu::always_inline]] inline bool holds_everywhere(const PackMask<W>& mask) {
  long long all = mask.bits[0];
  for (int i = 1; i < W; ++i) {
    all &= mask.bits[i];
  }
  return all != 0;
}

template <int W>
[[gnu::always_inline]] inline Pack<W> sqrt(const Pack<W>& a) {
  typename Pack<W>::Doubles roots = a.lanes;
  for (int i = 0; i < W; ++i) {
    roots[i] = __builtin_sqrt(roots[i]);
  }
  return Pack<W>(roots);
}

template <int W>
[[gnu::always_inline]] inline Pack<W> abs(const Pack<W>& a) {
  using Bits = typename Pack<W>::Bits;
  return Pack<W>(
      reinterpret_cast<typename Pack<W>::Doubles>(reinterpret_cast<Bits>(a.lanes) & 0x7fffffffffffffffLL));
}

/// `a` with the sign of `b`.
template <int W>
[[gnu::always_inline]] inline Pack<W> copysign(const Pack<W>& a, const Pack<W>& b) {
  using Bits = typename Pack<W>::Bits;
  constexpr long long kMagnitude = 0x7fffffffffffffffLL;
  return Pack<W>(reinterpret_cast<typename Pack<W>::Doubles>(
      (reinterpret_cast<Bits>(a.lanes) & kMagnitude) | (reinterpret_cast<Bits>(b.lanes) & ~kMagnitude)));
}

/// The larger of both; `b` where one of them is not a number.
template <int W>
[[gnu::always_inline]] inline Pack<W> max(const Pack<W>& a, const Pack<W>& b) {
  return Pack<W>(typename Pack<W>::Doubles(a.lanes > b.lanes ? a.lanes : b.lanes));
}

template <int W>
[[gnu::always_inline]] inline double first_lane(const Pack<W>& a) {
  return a.lanes[0];
}

template <int W>
[[gnu::always_inline]] inline double last_lane(const Pack<W>& a) {
  return a.lanes[W - 1];
}

template <int W>
[[gnu::always_inline]] inline double sum_of_lanes(const Pack<W>& a) {
  double sum = a.lanes[0];
  for (int i = 1; i < W; ++i) {
    sum += a.lanes[i];
  }
  return sum;
}

/// The largest lane; lanes that are NaN are ignored, except the first.
template <int W>
[[gnu::always_inline]] inline double largest_lane(const Pack<W>& a) {
  double largest = a.lanes[0];
  for (int i = 1; i < W; ++i) {
    largest = a.lanes[i] > largest ? a.lanes[i] : largest;
  }
  return largest;
}

/// \name The same for pairs.
/// @{
template <int W>
[[gnu::always_inline]] inline PackPair<W> operator-(const PackPair<W>& a) {
  return {-a.low, -a.high};
}
template <int W>
[[gnu::always_inline]] inline PackPair<W> select(const PairMask<W>& mask, const PackPair<W>& a,
                                                 const PackPair<W>& b) {
  return {select(mask.low, a.low, b.low), select(mask.high, a.high, b.high)};
}
template <int W>
[[gnu::always_inline]] inline PairMask<W> operator&(const PairMask<W>& a, const PairMask<W>& b) {
  return {a.low & b.low, a.high & b.high};
}
template <int W>
[[gnu::always_inline]] inline bool holds_everywhere(const PairMask<W>& mask) {
  return holds_everywhere(mask.low & mask.high);
}
template <int W>
[[gnu::always_inline]] inline PackPair<W> sqrt(const PackPair<W>& a) {
  return {sqrt(a.low), sqrt(a.high)};
}
template <int W>
[[gnu::always_inline]] inline PackPair<W> abs(const PackPair<W>& a) {
  return {abs(a.low), abs(a.high)};
}
template <int W>
[[gnu::always_inline]] inline PackPair<W> copysign(const PackPair<W>& a, const PackPair<W>& b) {
  return {copysign(a.low, b.low), copysign(a.high, b.high)};
}
template <int W>
[[gnu::always_inline]] inline PackPair<W> max(const PackPair<W>& a, const PackPair<W>& b) {
  return {max(a.low, b.low), max(a.high, b.high)};
}
template <int W>
[[gnu::always_inline]] inline double first_lane(const PackPair<W>& a) {
  return first_lane(a.low);
}
template <int W>
[[gnu::always_inline]] inline double last_lane(const PackPair<W>& a) {
  return last_lane(a.high);
}
template <int W>
[[gnu::always_inline]] inline double sum_of_lanes(const PackPair<W>& a) {
  return sum_of_lanes(a.low + a.high);
}
template <int W>
[[gnu::always_inline]] inline double largest_lane(const PackPair<W>& a) {
  return largest_lane(max(a.low, a.high));
}
/// @}

}  // namespace higherpair

// Eigen would align vectors of packs to 16 bytes, which Clang rejects where a pack requires more.
template <int W, int Size>
struct Eigen::internal::compute_default_alignment<higherpair::Pack<W>, Size> {
  enum { value = 0 };
};
template <int W, int Size>
struct Eigen::internal::compute_default_alignment<higherpair::PackPair<W>, Size> {
  enum { value = 0 };
};
