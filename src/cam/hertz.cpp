#include "higherpair/cam/hertz.hpp"

#include "higherpair/geometry/pose.hpp"

#include <cmath>

namespace higherpair {

double contact_modulus(const ElasticMaterial& first, const ElasticMaterial& second) {
  const auto compliance = [](const ElasticMaterial& of) {
    return (1 - of.poisson * of.poisson) / of.modulus;
  };
  return 1 / (compliance(first) + compliance(second));
}

double line_pressure(double load, double curvature, double modulus) {
  return load > 0 ? std::sqrt(load * modulus * curvature / kPi) : 0;
}

}  // namespace higherpair
