#pragma once

#include "higherpair/geometry/pose.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace higherpair {

/// The meaning of the coefficients of an Expansion after the first.
enum class Terms {
  kPowers,    ///< 1, t, t², … of one variable, in time a motion: products of terms give higher terms
  kPartials,  ///< one variable each, to first order: products of two of them are dropped
};

/// A number together with its derivatives: a polynomial truncated after its last term. A function that is a
/// template over its scalar yields, for arguments that are expansions, its own expansion, exact to within
/// rounding: no finite differences are taken.
///     powers:   c[k] = (1/k!) dᵏf/dtᵏ,     partials:   c[k] = ∂f/∂x_k, k = 1 … N.
/// Division by, and the square root of, a number whose c[0] is 0 give infinities or NaN as with double.
/// \tparam C  type of the coefficients: double, or an expansion in other variables
/// Knuth, The Art of Computer Programming 2, 4.7; Griewank and Walther, Evaluating Derivatives, 13.2.
template <class C, int N, Terms kTerms>
struct Expansion {
  static constexpr std::size_t kLast = N;
  std::array<C, kLast + 1> c{};

  Expansion() = default;
  Expansion(double constant) { c[0] = C(constant); }  // NOLINT(google-explicit-constructor)
  Expansion(const C& constant)                        // NOLINT(google-explicit-constructor)
      requires(!std::is_same_v<C, double>) {
    c[0] = constant;
  }

  /// Adds to the k-th coefficient of a product the products of two inner terms (neither the first nor the
  /// k-th).
  template <class F>
  static void add_inner(std::size_t k, C& sum, F product) {
    if constexpr (kTerms == Terms::kPowers) {
      for (std::size_t i = 1; i < k; ++i) {
        sum += product(i, k - i);
      }
    }
  }

  Expansion& operator+=(const Expansion& b) {
    for (std::size_t k = 0; k <= kLast; ++k) {
      c[k] += b.c[k];
    }
    return *this;
  }
  Expansion& operator-=(const Expansion& b) {
    for (std::size_t k = 0; k <= kLast; ++k) {
      c[k] -= b.c[k];
    }
    return *this;
  }
  Expansion& operator*=(const Expansion& b) { return *this = *this * b; }
  Expansion& operator/=(const Expansion& b) { return *this = *this / b; }

  friend Expansion operator-(Expansion a) {
    for (C& term : a.c) {
      term = -term;
    }
    return a;
  }
  friend Expansion operator+(Expansion a, const Expansion& b) { return a += b; }
  friend Expansion operator-(Expansion a, const Expansion& b) { return a -= b; }
  friend Expansion operator*(const Expansion& a, const Expansion& b) {
    Expansion product;
    product.c[0] = a.c[0] * b.c[0];
    for (std::size_t k = 1; k <= kLast; ++k) {
      product.c[k] = a.c[0] * b.c[k] + a.c[k] * b.c[0];
      add_inner(k, product.c[k], [&](std::size_t i, std::size_t j) { return a.c[i] * b.c[j]; });
    }
    return product;
  }
  friend Expansion operator/(const Expansion& a, const Expansion& b) {
    Expansion quotient;
    quotient.c[0] = a.c[0] / b.c[0];
    for (std::size_t k = 1; k <= kLast; ++k) {
      C taken = quotient.c[0] * b.c[k];
      add_inner(k, taken, [&](std::size_t i, std::size_t j) { return quotient.c[i] * b.c[j]; });
      quotient.c[k] = (a.c[k] - taken) / b.c[0];
    }
    return quotient;
  }

  /// \name With constants.
  /// @{
  template <class S>
  static constexpr bool kIsConstant = std::is_same_v<S, double> || std::is_same_v<S, C>;
  template <class S>
  requires kIsConstant<S>
  friend Expansion operator*(const S& s, Expansion a) {
    for (C& term : a.c) {
      term *= s;
    }
    return a;
  }
  template <class S>
  requires kIsConstant<S>
  friend Expansion operator*(const Expansion& a, const S& s) { return s * a; }
  template <class S>
  requires kIsConstant<S>
  friend Expansion operator/(Expansion a, const S& s) {
    for (C& term : a.c) {
      term /= s;
    }
    return a;
  }
  template <class S>
  requires kIsConstant<S>
  friend Expansion operator+(Expansion a, const S& s) {
    a.c[0] += s;
    return a;
  }
  template <class S>
  requires kIsConstant<S>
  friend Expansion operator+(const S& s, const Expansion& a) { return a + s; }
  template <class S>
  requires kIsConstant<S>
  friend Expansion operator-(Expansion a, const S& s) {
    a.c[0] -= s;
    return a;
  }
  template <class S>
  requires kIsConstant<S>
  friend Expansion operator-(const S& s, const Expansion& a) { return -a + s; }
  /// @}

  /// Compares the values alone, but == all coefficients: a variable is not equal to a constant.
  friend bool operator<=(const Expansion& a, const Expansion& b) { return a.c[0] <= b.c[0]; }
  friend bool operator<(const Expansion& a, const Expansion& b) { return a.c[0] < b.c[0]; }
  friend bool operator>(const Expansion& a, const Expansion& b) { return b < a; }
  friend bool operator>=(const Expansion& a, const Expansion& b) { return b <= a; }
  friend bool operator==(const Expansion& a, const Expansion& b) { return a.c == b.c; }
};

template <class C, int N>
using PowerSeries = Expansion<C, N, Terms::kPowers>;
template <class C, int N>
using Partials = Expansion<C, N, Terms::kPartials>;

/// A number that depends on one parameter.
/// \param slope  its derivative by the parameter
[[nodiscard]] inline Partials<double, 1> parametric(double value, double slope) {
  Partials<double, 1> number(value);
  number.c[1] = slope;
  return number;
}

/// The value alone, without its derivatives.
[[nodiscard]] inline double value_of(double x) {
  return x;
}
template <class C, int N, Terms kTerms>
[[nodiscard]] double value_of(const Expansion<C, N, kTerms>& x) {
  return value_of(x.c[0]);
}

/// f(x) from f at the value of x and its derivative f'(x) as an expansion:  k f_k = Σ i x_i f'_{k-i}.
template <class C, int N, Terms kTerms>
[[nodiscard]] Expansion<C, N, kTerms> integrated(const C& start, const Expansion<C, N, kTerms>& derivative,
                                                 const Expansion<C, N, kTerms>& x) {
  Expansion<C, N, kTerms> f;
  f.c[0] = start;
  for (std::size_t k = 1; k <= f.kLast; ++k) {
    C inner(0.0);
    f.add_inner(k, inner,
                [&](std::size_t i, std::size_t j) { return double(i) * (x.c[i] * derivative.c[j]); });
    f.c[k] = x.c[k] * derivative.c[0] + inner / double(k);
  }
  return f;
}

/// The root, from root² = x term by term. \pre x.c[0] > 0
template <class C, int N, Terms kTerms>
[[nodiscard]] Expansion<C, N, kTerms> sqrt(const Expansion<C, N, kTerms>& x) {
  using std::sqrt;
  Expansion<C, N, kTerms> root;
  root.c[0] = sqrt(x.c[0]);
  for (std::size_t k = 1; k <= root.kLast; ++k) {
    C taken(0.0);
    root.add_inner(k, taken, [&](std::size_t i, std::size_t j) { return root.c[i] * root.c[j]; });
    root.c[k] = (x.c[k] - taken) / (2.0 * root.c[0]);
  }
  return root;
}

/// A cosine and a sine; each is, up to sign, the derivative of the other.
template <class E>
struct CosineAndSine {
  E cosine, sine;
};

/// Sets the k-th coefficients of cosine and sine of x from those before, k > 0.
template <class C, int N, Terms kTerms>
void set_coefficient(std::size_t k, const Expansion<C, N, kTerms>& x, Expansion<C, N, kTerms>& cosine,
                     Expansion<C, N, kTerms>& sine) {
  C c_inner(0.0), s_inner(0.0);
  x.add_inner(k, c_inner, [&](std::size_t i, std::size_t j) { return double(i) * (x.c[i] * sine.c[j]); });
  x.add_inner(k, s_inner, [&](std::size_t i, std::size_t j) { return double(i) * (x.c[i] * cosine.c[j]); });
  cosine.c[k] = -(x.c[k] * sine.c[0] + c_inner / double(k));
  sine.c[k] = x.c[k] * cosine.c[0] + s_inner / double(k);
}

/// Cosine and sine of x, from those of its first coefficient.
template <class C, int N, Terms kTerms>
[[nodiscard]] CosineAndSine<Expansion<C, N, kTerms>> cosine_and_sine(const Expansion<C, N, kTerms>& x,
                                                                     const C& cosine_at, const C& sine_at) {
  CosineAndSine<Expansion<C, N, kTerms>> r;
  r.cosine.c[0] = cosine_at;
  r.sine.c[0] = sine_at;
  for (std::size_t k = 1; k <= x.kLast; ++k) set_coefficient(k, x, r.cosine, r.sine);
  return r;
}

template <class C, int N, Terms kTerms>
[[nodiscard]] Expansion<C, N, kTerms> cos(const Expansion<C, N, kTerms>& x) {
  using std::cos;
  using std::sin;
  return cosine_and_sine(x, C(cos(x.c[0])), C(sin(x.c[0]))).cosine;
}

template <class C, int N, Terms kTerms>
[[nodiscard]] Expansion<C, N, kTerms> sin(const Expansion<C, N, kTerms>& x) {
  using std::cos;
  using std::sin;
  return cosine_and_sine(x, C(cos(x.c[0])), C(sin(x.c[0]))).sine;
}

/// The angle of a vector from the x axis [rad]; its value is in (-π, π].
template <int N>
[[nodiscard]] Partials<double, N> angle_of(const Vector2<Partials<double, N>>& v) {
  const Vector2d at(value_of(v.x()), value_of(v.y()));
  return (at.x() * v.y() - at.y() * v.x()) / at.squaredNorm() + angle_of(at);
}

}  // namespace higherpair

/// \cond
template <class C, int N, higherpair::Terms kTerms>
struct Eigen::NumTraits<higherpair::Expansion<C, N, kTerms>> : Eigen::NumTraits<double> {
  using Real = higherpair::Expansion<C, N, kTerms>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = N + 1,
    AddCost = N + 1,
    MulCost = 3 * N
  };
};
/// \endcond
