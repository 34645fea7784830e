#include "extended.hpp"

#include <cmath>

namespace higherpair {

Extended::Extended(int x) : x_(x) {}

Extended::Extended(double x) : x_(x) {}

Extended::Extended(long double x) : x_(x) {}

Extended::Extended(const std::string& decimal) : x_(decimal) {}

Extended& Extended::operator+=(const Extended& b) {
  x_ += b.x_;
  return *this;
}

Extended operator+(const Extended& a, const Extended& b) {
  return Extended(a.number() + b.number());
}

Extended operator-(const Extended& a, const Extended& b) {
  return Extended(a.number() - b.number());
}

Extended operator*(const Extended& a, const Extended& b) {
  return Extended(a.number() * b.number());
}

Extended operator/(const Extended& a, const Extended& b) {
  return Extended(a.number() / b.number());
}

Extended operator-(const Extended& a) {
  return Extended(-a.number());
}

bool operator==(const Extended& a, const Extended& b) {
  return a.number() == b.number();
}

std::partial_ordering operator<=>(const Extended& a, const Extended& b) {
  return a.number() < b.number()    ? std::partial_ordering::less
         : a.number() > b.number()  ? std::partial_ordering::greater
         : a.number() == b.number() ? std::partial_ordering::equivalent
                                    : std::partial_ordering::unordered;
}

Extended abs(const Extended& x) {
  return Extended(Extended::Number(abs(x.number())));
}

Extended sqrt(const Extended& x) {
  return Extended(Extended::Number(sqrt(x.number())));
}

Extended cos(const Extended& x) {
  return Extended(Extended::Number(cos(x.number())));
}

Extended sin(const Extended& x) {
  return Extended(Extended::Number(sin(x.number())));
}

Extended atan(const Extended& x) {
  return Extended(Extended::Number(atan(x.number())));
}

double to_double(const Extended& x) {
  return x.number().convert_to<double>();
}

long double to_long_double(const Extended& x) {
  return x.number().convert_to<long double>();
}

long double magnitude(const Complex<Extended>& a) {
  return std::sqrt(to_long_double(norm(a)));
}

}  // namespace higherpair
