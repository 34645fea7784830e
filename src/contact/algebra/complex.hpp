#pragma once

#include <array>

namespace higherpair {

/// A complex number over any ring or field T: std::complex is specified for the built-in floating-point types
/// only.
template <class T>
struct Complex {
  T re{0};
  T im{0};

  Complex& operator+=(const Complex& other) { return *this = *this + other; }

  friend Complex operator+(const Complex& a, const Complex& b) { return {T(a.re + b.re), T(a.im + b.im)}; }
  friend Complex operator-(const Complex& a, const Complex& b) { return {T(a.re - b.re), T(a.im - b.im)}; }
  friend Complex operator-(const Complex& a) { return {T(-a.re), T(-a.im)}; }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {T(a.re * b.re - a.im * b.im), T(a.re * b.im + a.im * b.re)};
  }
  friend Complex operator*(const T& s, const Complex& a) { return {T(s * a.re), T(s * a.im)}; }
};

template <class T>
[[nodiscard]] Complex<T> conj(const Complex<T>& a) {
  return {a.re, T(-a.im)};
}

/// |a|²
template <class T>
[[nodiscard]] T norm(const Complex<T>& a) {
  return T(a.re * a.re + a.im * a.im);
}

/// 1/a; T must be a field and a not 0.
template <class T>
[[nodiscard]] Complex<T> inverse(const Complex<T>& a) {
  const T n = norm(a);
  return {T(a.re / n), T(-a.im / n)};
}

/// Re(conj(a) b) and Im(conj(a) b): the products a·b and a × b of plane vectors.
template <class T>
[[nodiscard]] T dot(const Complex<T>& a, const Complex<T>& b) {
  return T(a.re * b.re + a.im * b.im);
}
template <class T>
[[nodiscard]] T cross(const Complex<T>& a, const Complex<T>& b) {
  return T(a.re * b.im - a.im * b.re);
}

template <class T>
using Vector3c = std::array<Complex<T>, 3>;
template <class T>
using Matrix3c = std::array<Vector3c<T>, 3>;

/// The matrix of the entries of(i, j).
template <class T, class F>
[[nodiscard]] Matrix3c<T> matrix_of(const F& of) {
  Matrix3c<T> matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      matrix[i][j] = of(i, j);
    }
  }
  return matrix;
}

template <class T>
[[nodiscard]] Matrix3c<T> operator+(const Matrix3c<T>& a, const Matrix3c<T>& b) {
  return matrix_of<T>([&](std::size_t i, std::size_t j) { return a[i][j] + b[i][j]; });
}

template <class T>
[[nodiscard]] Matrix3c<T> operator*(const T& s, const Matrix3c<T>& a) {
  return matrix_of<T>([&](std::size_t i, std::size_t j) { return s * a[i][j]; });
}

template <class T>
[[nodiscard]] Vector3c<T> operator*(const Matrix3c<T>& a, const Vector3c<T>& v) {
  Vector3c<T> product;
  for (std::size_t i = 0; i < 3; ++i) {
    product[i] = a[i][0] * v[0] + a[i][1] * v[1] + a[i][2] * v[2];
  }
  return product;
}

template <class T>
[[nodiscard]] Complex<T> product(const Vector3c<T>& a, const Vector3c<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// a bᵀ
template <class T>
[[nodiscard]] Matrix3c<T> outer(const Vector3c<T>& a, const Vector3c<T>& b) {
  return matrix_of<T>([&](std::size_t i, std::size_t j) { return a[i] * b[j]; });
}

/// tr(a bᵀ); for two symmetric matrices the trace of their product.
template <class T>
[[nodiscard]] Complex<T> product(const Matrix3c<T>& a, const Matrix3c<T>& b) {
  return product(a[0], b[0]) + product(a[1], b[1]) + product(a[2], b[2]);
}

/// Adjugate of a symmetric matrix: a · adj(a) = det(a).
template <class T>
[[nodiscard]] Matrix3c<T> adjugate(const Matrix3c<T>& a) {
  const auto minor = [&](std::size_t i, std::size_t j) {
    const std::size_t r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return a[r][c] * a[s][d] - a[r][d] * a[s][c];
  };
  Matrix3c<T> adj;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      adj[i][j] = minor(i, j);
    }
  }
  return adj;
}

}  // namespace higherpair
