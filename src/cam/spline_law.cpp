#include "law_pieces.hpp"
#include "numeric/spline.hpp"

namespace higherpair {

void add_spline(const LawDescription& description, LawPieces& pieces) {
  const std::vector<Vector2d>& points = description.points;
  const bool periodic = description.ends == SplineEnds::kPeriodic;
  // The last point is the first one, a period later.
  const bool closing = periodic && description.period == 0;
  SplineTask task;
  task.degree = description.degree;
  task.smoothing = description.smoothing;
  const double period = closing ? points.back().x() - points.front().x() : description.period;
  task.period = periodic ? period : 0;
  // The spline is the deviation from a straight line, along which every repetition begins at a higher value.
  const double slope = closing ? (points.back().y() - points.front().y()) / period : 0;
  const std::size_t count = points.size() - (closing ? 1 : 0);
  task.values.resize(static_cast<Eigen::Index>(count), 1);
  for (std::size_t i = 0; i < count; ++i) {
    task.x.push_back(points[i].x());
    task.values(static_cast<Eigen::Index>(i), 0) =
        points[i].y() - slope * (points[i].x() - points.front().x());
  }
  const Eigen::MatrixXd powers = spline_powers(task);
  const Eigen::Index terms = task.degree + 1;
  std::vector<double> c(static_cast<std::size_t>(terms));
  for (Eigen::Index i = 0; i < powers.rows() / terms; ++i) {
    Eigen::Map<Eigen::VectorXd>(c.data(), terms) = powers.col(0).segment(i * terms, terms);
    const double x = task.x[i];
    LawPiece piece{x, x, c[0] + slope * (x - points.front().x())};
    piece.start = i == 0 ? PieceStart::kSegment : PieceStart::kKnot;
    c[0] = 0;
    c[1] += slope;
    pieces.add(piece, c, {});
  }
  pieces.set_end(periodic ? points.front().x() + period : points.back().x());
}

}  // namespace higherpair
