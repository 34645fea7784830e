#pragma once

#include "higherpair/geometry/pose.hpp"

// Vector operations by components: Eigen's expressions require more of their scalar type than a pack
// provides.

namespace higherpair {

template <class T>
[[nodiscard]] inline T dot(const Vector2<T>& a, const Vector2<T>& b) {
  return a.x() * b.x() + a.y() * b.y();
}
template <class T>
[[nodiscard]] inline Vector2<T> left_of(const Vector2<T>& v) {
  return Vector2<T>(-v.y(), v.x());
}
template <class T>
[[nodiscard]] inline Vector2<T> sum(const Vector2<T>& a, const Vector2<T>& b) {
  return Vector2<T>(a.x() + b.x(), a.y() + b.y());
}
template <class T>
[[nodiscard]] inline Vector2<T> less(const Vector2<T>& a, const Vector2<T>& b) {
  return Vector2<T>(a.x() - b.x(), a.y() - b.y());
}
template <class T>
[[nodiscard]] inline Vector2<T> times(const T& factor, const Vector2<T>& v) {
  return Vector2<T>(factor * v.x(), factor * v.y());
}

}  // namespace higherpair
