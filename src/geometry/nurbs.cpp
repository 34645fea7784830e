#include "higherpair/geometry/spline_span.hpp"
#include "numeric/b_splines.hpp"
#include "polynomial_span.hpp"

#include <cassert>

namespace higherpair {
namespace {

constexpr auto kMostTerms = static_cast<std::size_t>(kHighestNurbsDegree) + 1;

Eigen::MatrixXd powers_between(const NurbsCurve& curve, std::size_t k) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  const bool rational = !curve.weights.empty();
  const auto b = b_splines_between<kMostTerms>(curve.knots, degree, k);
  Eigen::MatrixXd powers = Eigen::MatrixXd::Zero(curve.degree + 1, rational ? 3 : 2);
  for (std::size_t j = 0; j <= degree; ++j) {
    const std::size_t i = k - degree + j;
    const double weight = rational ? curve.weights[i] : 1;
    for (Eigen::Index power = 0; power <= curve.degree; ++power) {
      const double factor = weight * b[j][power];
      powers(power, 0) += factor * curve.control[i].x();
      powers(power, 1) += factor * curve.control[i].y();
      if (rational) {
        powers(power, 2) += factor;
      }
    }
  }
  return powers;
}

// Neighbouring intervals across which the curvature is continuous.
struct Stretch {
  std::vector<double> breaks;
  std::vector<Eigen::MatrixXd> powers;
};

Vector2d value(const Eigen::MatrixXd& powers, double t) {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(powers.cols());
  for (Eigen::Index k = powers.rows() - 1; k >= 0; --k) {
    sum = (sum * t + powers.row(k)).eval();
  }
  const double w = powers.cols() == 3 ? sum(2) : 1;
  return {sum(0) / w, sum(1) / w};
}

void close(const Stretch& stretch, int degree, std::vector<SpanPtr>& spans) {
  if (stretch.powers.empty()) {
    return;
  }
  if (degree == 1) {
    const auto& breaks = stretch.breaks;
    const Vector2d from = value(stretch.powers.front(), 0);
    const Vector2d to = value(stretch.powers.front(), breaks[1] - breaks[0]);
    if (from != to) {
      spans.push_back(face_span(from, to));
    }
    return;
  }
  const Eigen::Index terms = stretch.powers.front().rows();
  Eigen::MatrixXd all(terms * static_cast<Eigen::Index>(stretch.powers.size()),
                      stretch.powers.front().cols());
  for (std::size_t i = 0; i < stretch.powers.size(); ++i) {
    all.middleRows(static_cast<Eigen::Index>(i) * terms, terms) = stretch.powers[i];
  }
  spans.push_back(polynomial_span(stretch.breaks, all));
}

}  // namespace

// A knot of multiplicity m leaves degree - m derivatives continuous; a continuous curvature needs two.
std::vector<SpanPtr> nurbs_spans(const NurbsCurve& curve) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::size_t count = curve.control.size();
  assert(curve.degree >= 1 && curve.degree <= kHighestNurbsDegree && count > degree &&
         curve.knots.size() == count + degree + 1);
  std::vector<SpanPtr> spans;
  Stretch stretch;
  int multiplicity = 0;
  for (std::size_t k = degree; k < count; ++k) {
    ++multiplicity;
    if (!(curve.knots[k + 1] > curve.knots[k])) {
      continue;
    }
    if (curve.degree - multiplicity < 2) {
      close(stretch, curve.degree, spans);
      stretch = {};
    }
    multiplicity = 0;
    if (stretch.breaks.empty()) {
      stretch.breaks.push_back(curve.knots[k]);
    }
    stretch.breaks.push_back(curve.knots[k + 1]);
    stretch.powers.push_back(powers_between(curve, k));
  }
  close(stretch, curve.degree, spans);
  return spans;
}

}  // namespace higherpair
