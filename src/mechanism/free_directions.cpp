#include "free_directions.hpp"

#include "higherpair/mechanism/analyse_mobility.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "numeric/product.hpp"
#include "numeric/singular_values.hpp"

#include <algorithm>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

constexpr int kShorterMoves = 3;  // most tries, each a quarter as long as the one before
constexpr int kCombinations = 3;  // number of moves along several basis vectors at once

std::vector<Eigen::VectorXd> directions_in(const Eigen::MatrixXd& basis) {
  std::vector<Eigen::VectorXd> directions;
  for (Eigen::Index i = 0; i < basis.cols(); ++i) {
    directions.emplace_back(basis.col(i));
  }
  std::mt19937 random(2718281);
  for (int k = 0; k < kCombinations; ++k) {
    Eigen::VectorXd weights(basis.cols());
    for (Eigen::Index i = 0; i < weights.size(); ++i) {
      weights(i) = static_cast<double>(random()) / 2147483648.0 - 1;
    }
    directions.emplace_back(basis * weights.normalized());
  }
  return directions;
}

struct Move {
  MechanismPosition to;
  Eigen::VectorXd reached;  // within the null space, in units of the intended step

  [[nodiscard]] bool leads_away() const { return reached.norm() >= kLeadsAway; }
};

// A move along a direction of the null space at the start. Newton's method loses its way beside a change
// point where conditions repeat each other, the damped one is slow beside a shaky position.
std::optional<Move> move_along(const SizedMechanism& sized, const MechanismPosition& start,
                               const Eigen::MatrixXd& basis, const Eigen::VectorXd& direction) {
  double step = kFreeMove * sized.size / direction.cwiseAbs().maxCoeff();
  for (int i = 0; i < kShorterMoves; ++i, step /= 4) {
    MechanismPosition beside = start;
    add_step(sized, step * direction, beside);
    const auto move_to = [&](std::optional<MechanismPosition> closed) -> std::optional<Move> {
      if (!closed) {
        return std::nullopt;
      }
      Eigen::VectorXd reached = basis.transpose() * (step_between(sized, start, *closed) / step);
      return Move{*std::move(closed), std::move(reached)};
    };
    auto move = move_to(assemble_from(sized, {}, beside));
    if (!move || !move->leads_away()) {
      auto damped = move_to(assemble_beside(sized, std::move(beside)));
      if (damped && damped->leads_away()) {
        move = std::move(damped);
      }
    }
    if (move) {
      return move;
    }
  }
  return std::nullopt;
}

}  // namespace

NullSpaces null_spaces(const Eigen::MatrixXd& J, double floor) {
  if (J.rows() == 0 || J.cols() == 0) {
    return {0, Eigen::MatrixXd::Identity(J.cols(), J.cols()), Eigen::MatrixXd::Identity(J.rows(), J.rows())};
  }
  const SingularValues svd = singular_values(J);
  int rank = 0;
  while (rank < svd.values.size() && svd.values(rank) > floor * std::max(1.0, svd.values(0))) {
    ++rank;
  }
  return {rank, svd.V.rightCols(J.cols() - rank), svd.U.rightCols(J.rows() - rank)};
}

Moves explore(const SizedMechanism& sized, const MechanismPosition& start) {
  Moves moves;
  moves.here = null_spaces(conditions_at(sized, {}, start).J);
  moves.best = start;
  moves.at_best = moves.here;
  const Eigen::MatrixXd& basis = moves.here.right;
  if (basis.cols() == 0) {
    moves.real = basis;
    return moves;
  }
  const std::vector<Eigen::VectorXd> directions = directions_in(basis);
  Eigen::MatrixXd reached = Eigen::MatrixXd::Zero(basis.cols(), static_cast<Eigen::Index>(directions.size()));
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto move = move_along(sized, start, basis, directions[i]);
    if (!move || !move->leads_away()) {
      continue;
    }
    reached.col(static_cast<Eigen::Index>(i)) = move->reached;
    ++moves.positions;
    NullSpaces there = null_spaces(conditions_at(sized, {}, move->to).J);
    const bool first_off_start = moves.positions == 2 && there.rank >= moves.at_best.rank;
    if (there.rank > moves.at_best.rank || first_off_start) {
      moves.best = move->to;
      moves.at_best = std::move(there);
    }
  }
  const SingularValues svd = singular_values(reached);
  Eigen::Index real = 0;
  while (real < svd.values.size() && svd.values(real) > kLeadsAway) {
    ++real;
  }
  moves.real = product(basis, svd.U.leftCols(real));
  return moves;
}

}  // namespace higherpair
