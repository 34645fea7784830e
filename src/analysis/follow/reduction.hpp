#pragma once

#include "path_events.hpp"

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace higherpair {

/// The conditions of one group, reduced to a single equation where they lose their rank (Lyapunov and
/// Schmidt; Golubitsky and Schaeffer, Singularities and Groups in Bifurcation Theory I, ch. VII).
///
/// F(x, s) = 0 are the conditions of the group's joints, contacts and drivers: x its bodies' coordinates and
/// the angles of its contacts' normals, s the path's coordinate (the groups before follow from s). At a limit
/// or a change point J = ∂F/∂x is singular and Newton's method fails. The bordered system
///     F(x, s) + ε b = 0,     c·(x - x₀) = λ
/// is regular there, with b and c the left and right singular vectors of the least singular value of J. It
/// gives x and ε as smooth functions of (λ, s), and the positions of the group are the zeros of ε(λ, s):
///     ε = ε_λ = 0, ε_s ≠ 0         limit: the positions turn back in s
///     ε_λ = ε_s = 0, ε = 0         change point: two branches cross
///     ε_λ = ε_s = 0, ε ≠ 0         the branches come near each other, but do not meet.
class Reduction {
public:
  /// At run.at.state, which is at s on the path. The groups before g are solved in run.work.trial, which
  /// changes.
  Reduction(Run& run, const Path& path, std::size_t g, double s);

  struct Point {
    double lambda = 0;  ///< [m]
    double ahead = 0;   ///< s less that of run.at.state
    double value = 0;   ///< ε [m]
    double per_lambda = 0;
    double per_s = 0;
    bool is_saddle = false;    ///< at a change point: two branches cross (else isolated)
    Eigen::VectorXd x;         ///< bodies' (x, y, size·θ), then size·φ of contacts [m]
    Eigen::VectorXd x_lambda;  ///< ∂x/∂λ
    Eigen::VectorXd x_s;       ///< ∂x/∂s
  };

  /// A limit ahead of run.at.state in the sense of `h`, on its own branch: the branch up to it is a parabola
  /// in λ to within a few per cent. None if there is no such limit near.
  [[nodiscard]] std::optional<Point> limit_ahead(double h);

  /// The change point within the step h from run.at.state; none if there is none, as where the branches come
  /// near each other but do not cross.
  [[nodiscard]] std::optional<Point> crossing_within(double h);

  /// The positions at `ahead` from run.at.state that are near it: two where branches cross or turn back
  /// there.
  [[nodiscard]] std::vector<Point> positions_at(double ahead);

  /// The change point or limit within `distance` of run.at.state on the path, where the group is all but
  /// singular.
  [[nodiscard]] std::optional<Point> singular_point(double distance);

  /// Places the group in run.work.trial at a point; the last solution has already placed the groups before it
  /// there.
  void place(const Point& point);

  /// Places all groups in run.work.trial at a limit: this one, and as far as possible those after it.
  /// \param at  s of the limit, or of a row there
  void place_limit(const Point& limit, double at);

private:
  [[nodiscard]] bool make_border();
  [[nodiscard]] bool stays_on_faces() const;
  [[nodiscard]] bool system_at(double ahead, const Eigen::VectorXd& x);
  [[nodiscard]] std::optional<Point> solve(const Point& guess, double lambda, double ahead);
  struct Second {
    double lambda_lambda = 0, lambda_s = 0, s_s = 0;
  };
  [[nodiscard]] std::optional<Point> here();
  enum class Kind { kLimit, kCrossing };
  [[nodiscard]] std::optional<Point> root_of(Kind kind, const Point& from, double farthest);
  [[nodiscard]] std::optional<Second> second_derivatives(const Point& at);

  Run& run_;
  const Path& path_;
  std::size_t g_;
  double s_;
  double unit_;  // one unit of s
  bool usable_ = false;
  Eigen::VectorXd start_;    // x of run.at.state
  Eigen::VectorXd b_, c_;    // border
  Eigen::VectorXd F_, F_s_;  // conditions and their rate by s at fixed x, of the last system_at
  Eigen::MatrixXd J_;
};

}  // namespace higherpair
