// Conics of least distances from points.
#include "boundary_fit.hpp"
#include "higherpair/geometry/tolerances.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/least_squares.hpp"
#include "numeric/singular_values.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace higherpair {
namespace {

using boundary_fit::Coefficients;
using boundary_fit::monomials;
using boundary_fit::Normalised;
using boundary_fit::slope;

std::array<double, 6> array_of(const Coefficients& conic) {
  std::array<double, 6> result{};
  Eigen::Map<Coefficients>(result.data()) = conic;
  return result;
}

CurveKind kind_of(ConicForm form) {
  return form == ConicForm::kEllipse    ? CurveKind::kEllipse
         : form == ConicForm::kParabola ? CurveKind::kParabola
                                        : CurveKind::kHyperbola;
}

// A family of conics, given by parameters.
struct Family {
  // The coefficients for parameters, and their derivatives.
  std::function<Coefficients(const Eigen::VectorXd&)> conic;
  std::function<Eigen::Matrix<double, 6, Eigen::Dynamic>(const Eigen::VectorXd&)> derivatives;
};

LeastSquaresFit least_distances(const std::vector<Vector2d>& points, const Family& family,
                                const Eigen::VectorXd& start) {
  const auto n = static_cast<Eigen::Index>(points.size());
  LeastSquaresProblem problem;
  problem.residuals = [&](const Eigen::VectorXd& x, Eigen::VectorXd& r) {
    const Coefficients conic = family.conic(x);
    if (!conic.allFinite()) return false;
    r.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Vector2d& p = points[i];
      const double distance = (p - nearest_on_conic(array_of(conic), p)).norm();
      r(i) = std::copysign(distance, monomials(p).dot(conic));
    }
    return r.allFinite();
  };
  problem.jacobian = [&](const Eigen::VectorXd& x, Eigen::MatrixXd& J) {
    const Coefficients conic = family.conic(x);
    const auto by_x = family.derivatives(x);
    J.resize(n, x.size());
    for (Eigen::Index i = 0; i < n; ++i) {
      const Vector2d foot = nearest_on_conic(array_of(conic), points[i]);
      J.row(i) = monomials(foot).transpose() * by_x / slope(conic, foot).norm();
    }
    return J.allFinite();
  };
  LeastSquaresOptions options;
  options.rounding = kFitRounding;
  return least_squares(problem, start, options);
}

// All conics near one: its coefficients and any change of them other than a common factor.
Family near(const Coefficients& conic) {
  const SingularValues svd = singular_values(conic.transpose());
  Eigen::Matrix<double, 6, Eigen::Dynamic> basis = svd.V.rightCols(5);
  return {[=](const Eigen::VectorXd& x) -> Coefficients { return conic + basis * x; },
          [=](const Eigen::VectorXd&) { return basis; }};
}

// v² = 4 f u with u along the axis from the vertex, x = {vertex, angle of the axis, 2 f}.
Coefficients parabola_at(const Eigen::VectorXd& x) {
  const Vector2d axis = unit_vector(x(2));
  const Vector2d vertex = x.head<2>();
  const double c = axis.x(), s = axis.y();
  const double v0 = cross(axis, vertex), u0 = axis.dot(vertex);
  Coefficients conic;
  conic << s * s, c * c, -2 * s * c, 2 * s * v0 - 2 * x(3) * c, -2 * c * v0 - 2 * x(3) * s,
      v0 * v0 + 2 * x(3) * u0;
  return conic;
}

Family parabolas() {
  return {[](const Eigen::VectorXd& x) { return parabola_at(x); },
          [](const Eigen::VectorXd& x) {
            const Vector2d axis = unit_vector(x(2));
            const Vector2d across = perp(axis), vertex = x.head<2>();
            const double v0 = across.dot(vertex), u0 = axis.dot(vertex);
            // F = v² - 2 ℓ u, v = across·(p - vertex), u = axis·(p - vertex), as a polynomial in p.
            const auto product = [](const Eigen::Vector3d& f, const Eigen::Vector3d& g) {
              Coefficients m;
              m << f(0) * g(0), f(1) * g(1), f(0) * g(1) + f(1) * g(0), f(0) * g(2) + f(2) * g(0),
                  f(1) * g(2) + f(2) * g(1), f(2) * g(2);
              return m;
            };
            const Eigen::Vector3d one(0, 0, 1), u(axis.x(), axis.y(), -u0), v(across.x(), across.y(), -v0);
            Eigen::Matrix<double, 6, Eigen::Dynamic> by(6, 4);
            by.col(0) = product(-2 * across.x() * v + 2 * x(3) * axis.x() * one, one);
            by.col(1) = product(-2 * across.y() * v + 2 * x(3) * axis.y() * one, one);
            by.col(2) = product(-2 * v, u) - 2 * x(3) * product(v, one);
            by.col(3) = -2 * product(u, one);
            return by;
          }};
}

// The curve of a conic; of a hyperbola, the branch on which most points lie.
std::optional<Curve> curve_near(const Coefficients& conic, const std::vector<Vector2d>& points) {
  std::optional<Curve> best;
  double nearest = kInf;
  for (const Vector2d& p : {points.front(), points[points.size() / 2], points.back()}) {
    const auto curve = make_conic(array_of(conic), Side::kInside, nearest_on_conic(array_of(conic), p));
    if (!curve) continue;
    if (curve->kind != CurveKind::kHyperbola) return *curve;
    double far = 0;
    for (const Vector2d& q : points) {
      far += curve->axis_B.dot(q - center(*curve)) > 0 ? 0 : 1;
    }
    if (far < nearest) {
      nearest = far;
      best = *curve;
    }
  }
  return best;
}

double half_turn(double angle) {
  const double turned = std::remainder(angle, kPi);
  return turned <= -kPi / 2 ? turned + kPi : turned;
}

// BoundaryFit::parameters of a curve.
Eigen::VectorXd parameters_of(const Curve& curve) {
  if (curve.kind == CurveKind::kParabola) {
    return Eigen::Vector4d(curve.vertex_B.x(), curve.vertex_B.y(), curve.semi_latus / 2,
                           angle_of(curve.axis_B));
  }
  const std::array<double, 2> axes = semi_axes(curve);
  const Vector2d at = center(curve);
  Eigen::VectorXd parameters(5);
  if (curve.kind == CurveKind::kHyperbola) {
    // axis_B points from the vertex to the focus, in which direction the branch opens.
    parameters << at, axes[0], axes[1], angle_of(curve.axis_B);
    return parameters;
  }
  const bool along = axes[0] >= axes[1];
  parameters << at, std::max(axes[0], axes[1]), std::min(axes[0], axes[1]),
      half_turn(angle_of(along ? curve.axis_B : perp(curve.axis_B)));
  return parameters;
}

// A circle is an ellipse with any axis.
bool is_form(CurveKind kind, ConicForm form) {
  return form == ConicForm::kAny || kind == kind_of(form) ||
         (form == ConicForm::kEllipse && kind == CurveKind::kCircle);
}

// Derivatives of the natural parameters by those of the family, by differences.
Eigen::MatrixXd natural_derivatives(const Family& family, const Eigen::VectorXd& x,
                                    const std::vector<Vector2d>& points, const Eigen::VectorXd& natural) {
  Eigen::MatrixXd by(natural.size(), x.size());
  const bool has_direction = natural.size() >= 4;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const auto at = [&](double h) {
      Eigen::VectorXd moved = x;
      moved(k) += h;
      const auto curve = curve_near(family.conic(moved), points);
      Eigen::VectorXd parameters = Eigen::VectorXd::Constant(natural.size(), kNoValue);
      if (curve && parameters_of(*curve).size() == natural.size()) parameters = parameters_of(*curve);
      const Eigen::Index last = natural.size() - 1;
      if (has_direction) {
        parameters(last) = natural(last) + std::remainder(parameters(last) - natural(last), kPi);
      }
      return parameters;
    };
    by.col(k) = (at(kCoefficientDifference) - at(-kCoefficientDifference)) / (2 * kCoefficientDifference);
  }
  return by;
}

BoundaryFitResult finished(const Normalised& from, const Family& family, const LeastSquaresFit& found,
                           ConicForm form) {
  const auto fail = [](BoundaryFitError error) { return tl::unexpected(error); };
  const Coefficients conic = family.conic(found.x);
  const auto made_parabola = [&]() -> std::optional<Curve> {
    const auto parabola = make_parabola(found.x.head<2>(), found.x(3) / 2, found.x(2));
    return parabola ? std::optional(*parabola) : std::nullopt;
  };
  const auto curve = form == ConicForm::kParabola ? made_parabola() : curve_near(conic, from.points);
  if (!curve) return fail(BoundaryFitError::kDegenerate);
  if (!is_form(curve->kind, form)) return fail(BoundaryFitError::kOtherForm);
  const Eigen::VectorXd natural = parameters_of(*curve);
  const Eigen::Index axes = curve->kind == CurveKind::kParabola ? 1 : 2;
  if (!natural.allFinite() || natural.cwiseAbs().maxCoeff() > kFarPoint ||
      natural.segment(2, axes).minCoeff() < 1 / kFarPoint) {
    return fail(BoundaryFitError::kDegenerate);
  }
  BoundaryFit fit;
  fit.parameters.assign(natural.begin(), natural.end());
  const Eigen::MatrixXd square = boundary_fit::inverse_of_square(found.J);
  Eigen::MatrixXd by = Eigen::MatrixXd::Zero(4, 4);
  if (form == ConicForm::kParabola) {  // {vertex, angle, 2 f} to {vertex, f, angle}
    by(0, 0) = by(1, 1) = by(3, 2) = 1;
    by(2, 3) = 0.5;
  } else {
    by = natural_derivatives(family, found.x, from.points, natural);
  }
  fit.covariance = by * square * by.transpose();
  const bool center_is_negative = monomials(natural.head<2>()).dot(conic) < 0;
  std::vector<double> distances(found.r.begin(), found.r.end());
  // Distances are > 0 outside; the centre of an ellipse is inside, that of a hyperbola outside.
  const bool turn =
      (curve->kind == CurveKind::kHyperbola) == center_is_negative && curve->kind != CurveKind::kParabola;
  if (turn) {
    for (double& distance : distances) distance = -distance;
  }
  std::vector<bool> lengths(fit.parameters.size(), true);
  lengths.back() = false;
  to_own_frame(from, distances, static_cast<std::size_t>(found.x.size()), lengths, fit);
  const Vector2d at(fit.parameters[0], fit.parameters[1]);
  const double rotation = fit.parameters.back();
  const auto own = curve->kind == CurveKind::kParabola ? make_parabola(at, fit.parameters[2], rotation)
                   : curve->kind == CurveKind::kHyperbola
                       ? make_hyperbola(at, {fit.parameters[2], fit.parameters[3]}, rotation)
                       : make_ellipse(at, {fit.parameters[2], fit.parameters[3]}, rotation);
  if (!own) return fail(BoundaryFitError::kDegenerate);
  fit.curve = *own;
  return fit;
}

}  // namespace

BoundaryFitResult fit_conic(std::span<const Vector2d> points, ConicForm form) {
  const auto from = boundary_fit::normalised(points, form == ConicForm::kParabola ? 4 : 5);
  if (!from) {
    return tl::unexpected(from.error());
  }
  const Eigen::VectorXd spread = boundary_fit::spread_of(from->points).values;
  if (spread(1) <= kSpreadNearLine * spread(0)) {
    return tl::unexpected(BoundaryFitError::kOneLine);
  }
  if (form == ConicForm::kParabola) {
    const Family family = parabolas();
    const LeastSquaresFit found =
        least_distances(from->points, family, boundary_fit::algebraic_parabola(from->points));
    if (found.end != LeastSquaresEnd::kConverged || !(found.x(3) > 0)) {
      return tl::unexpected(BoundaryFitError::kNotConverged);
    }
    return finished(*from, family, found, form);
  }
  const auto ellipse =
      form == ConicForm::kEllipse ? boundary_fit::direct_ellipse(from->points) : std::nullopt;
  const Family family = near(ellipse ? *ellipse : boundary_fit::taubin_conic(from->points));
  const LeastSquaresFit found = least_distances(from->points, family, Eigen::VectorXd::Zero(5));
  if (found.end != LeastSquaresEnd::kConverged) {
    return tl::unexpected(found.end == LeastSquaresEnd::kUndefined ? BoundaryFitError::kDegenerate
                                                                   : BoundaryFitError::kNotConverged);
  }
  return finished(*from, family, found, form);
}

}  // namespace higherpair
