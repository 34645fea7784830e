#include "design_gradient.hpp"

#include "numeric/eigen_index.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

class Gradient {
public:
  Gradient(const DesignSetup& setup, DesignCandidates& candidates, const EvaluatedCandidate& candidate,
           double unit, DesignJacobian& jacobian)
      : setup_(setup),
        task_(setup.numbers.task()),
        candidates_(candidates),
        pins_(candidates.pins()),
        candidate_(candidate),
        rows_(candidate.rows),
        unit_(unit),
        jacobian_(jacobian) {}

  bool fill() {
    const bool assembles = rows_.started && rows_.missing == 0;
    const bool has_room = has_any<DesignTask::Grashof>(setup_.quantities);
    if (!assembles && (pins_ == nullptr || has_room)) {
      return false;
    }
    if (pins_ == nullptr || (assembles && !setup_.quantities.empty())) {
      slopes_ = candidates_.slopes(candidate_.x, candidate_.branch, slope_places());
      if (!slopes_) return false;
    }
    set_sizes();
    add_objectives();
    add_constraints();
    return true;
  }

private:
  void set_sizes() {
    const auto variables = eigen_index(candidate_.x.size());
    jacobian_.cost.setZero(variables);
    jacobian_.residuals.setZero(setup_.residuals, variables);
    jacobian_.constraints.setZero(setup_.constraints, variables);
  }

  // The places of paths at which a run has to be differentiated; none with pins.
  [[nodiscard]] std::vector<std::vector<SlopePlace>> slope_places() const {
    std::vector<std::vector<SlopePlace>> places;
    if (pins_ != nullptr) return places;
    for (const DesignTask::PointPath* path : task_.paths()) {
      auto& of_path = places.emplace_back();
      for (const PathMiss& miss : candidate_.places[places.size() - 1]) {
        const bool is_row = miss.row.has_value();
        of_path.push_back({path->ref, is_row ? *miss.row : row_near(miss.driver),
                           is_row ? std::nullopt : std::optional(miss.driver)});
      }
    }
    return places;
  }

  [[nodiscard]] std::size_t row_near(double driver) const {
    const auto far = [&](double position) { return std::abs(position - driver); };
    const auto nearest = std::min_element(rows_.positions.begin(), rows_.positions.end(),
                                          [&](double a, double b) { return far(a) < far(b); });
    return static_cast<std::size_t>(nearest - rows_.positions.begin());
  }

  // Derivatives of the k-th number of the quantity of an objective or constraint.
  template <class Place>
  [[nodiscard]] auto slope(const Place& place, std::size_t k = 0) const {
    return slopes_->measured.row(eigen_index(setup_.quantities[place.quantity].first + k));
  }

  void add_objectives() {
    for (std::size_t k = 0; k < task_.objectives.size(); ++k) {
      const DesignTask::Objective& objective = task_.objectives[k];
      const ObjectivePlace& place = setup_.objective_places[k];
      const double root = std::sqrt(objective.weight);
      if (const auto* path = objective.path()) {
        if (rows_.started) add_path(*path, place.path, root / unit_, place.residual);
      } else if (!slopes_) {
        continue;
      } else if (const auto* followed = objective.followed()) {
        add_followed(*followed, place, root);
      } else if (objective.target) {
        jacobian_.residuals.row(place.residual) = root * slope(place);
      } else {
        jacobian_.cost += objective.weight * slope(place);
      }
    }
  }

  void add_followed(const DesignTask::Followed& followed, const ObjectivePlace& place, double root) {
    for (std::size_t k = 0; k < followed.values.size(); ++k) {
      auto row = jacobian_.residuals.row(place.residual + eigen_index(k));
      row = root * slope(place, k);
      if (followed.change) row -= root * slope(place);
    }
  }

  // Derivatives of x and y of each place of a path, at a fixed position of the driver: to first order its
  // distance does not change when a place slides along the path.
  [[nodiscard]] Eigen::MatrixXd place_slopes(const DesignTask::PointPath& path, std::size_t k) {
    if (pins_ == nullptr) {
      return slopes_->paths[k];
    }
    const std::vector<PathMiss>& places = candidate_.places[k];
    Eigen::MatrixXd slopes(2 * eigen_index(places.size()), jacobian_.cost.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      slopes.middleRows<2>(2 * eigen_index(i)) = places[i].row
                                                     ? pins_->point_slopes(path.ref, *places[i].row)
                                                     : pins_->point_slopes_at(path.ref, places[i].driver);
    }
    return slopes;
  }

  void add_path(const DesignTask::PointPath& path, std::size_t k, double scale, Eigen::Index row) {
    const Eigen::MatrixXd slopes = place_slopes(path, k);
    const std::vector<PathMiss>& places = candidate_.places[k];
    if (path.is_free() && !path.timed) {
      jacobian_.residuals.middleRows(row, miss_count(path)) =
          scale * placement_of(path, places).distance_slopes(tangents_of(places), slopes);
    } else if (path.is_free()) {
      jacobian_.residuals.middleRows(row, slopes.rows()) =
          scale * placement_of(path, places).miss_slopes(slopes);
    } else if (path.timed) {
      jacobian_.residuals.middleRows(row, slopes.rows()) = scale * slopes;
    } else {
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto index = eigen_index(i);
        const Vector2d off = places[i].p_W - places[i].compared_with(path.through[i]);
        const double factor = places[i].shared ? places[i].shared->factor : 1;
        const Vector2d outward =
            places[i].along.isZero() ? Vector2d(off.stableNormalized()) : perp(places[i].along);
        jacobian_.residuals.row(row + index) =
            scale * factor * outward.transpose() * slopes.middleRows<2>(2 * index);
      }
    }
  }

  void add_constraints() {
    Eigen::MatrixXd& J = jacobian_.constraints;
    Eigen::Index row = 0;
    for (std::size_t g = 0; g < rows_.gaps.size(); ++g, ++row) {
      if (pins_ != nullptr) {
        pins_->add_gap_slopes(g, 1 / setup_.size, J, row);
      } else {
        J.row(row) = slopes_->gaps.row(row) / setup_.size;
      }
    }
    // The path is either good or not: its derivatives are 0.
    for (std::size_t k = 0; k < task_.constraints.size(); ++k) {
      const ConstraintPlace& place = setup_.constraint_places[k];
      const auto add = [&](double sign, Eigen::Index at) {
        if (!task_.constraints[k].transmission()) {
          if (slopes_) J.row(at) = sign / setup_.scales[k] * slope(place);
        } else if (pins_ != nullptr && rows_.started) {
          pins_->add_transmission_slopes(place.transmission, sign, J, at);
        } else if (slopes_) {
          J.row(at) = sign * slopes_->transmissions.row(eigen_index(place.transmission));
        }
      };
      if (place.above) add(-1, *place.above);
      if (place.below) add(1, *place.below);
    }
  }

  const DesignSetup& setup_;
  const DesignTask& task_;
  const DesignCandidates& candidates_;
  PinnedRows* pins_;
  const EvaluatedCandidate& candidate_;
  const DesignRows& rows_;
  double unit_;
  DesignJacobian& jacobian_;
  std::optional<DesignSlopes> slopes_;
};

}  // namespace

Eigen::Index residual_count(const DesignTask::Objective& objective) {
  if (const auto* path = objective.path()) return miss_count(*path);
  if (const auto* followed = objective.followed()) return eigen_index(followed->values.size());
  return objective.target ? 1 : 0;
}

bool add_gradient(const DesignSetup& setup, DesignCandidates& candidates, const EvaluatedCandidate& candidate,
                  double unit, DesignJacobian& jacobian) {
  return Gradient(setup, candidates, candidate, unit, jacobian).fill();
}

}  // namespace higherpair
