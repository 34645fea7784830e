#include "design_pins.hpp"

#include "design_direct.hpp"
#include "front/tolerances.hpp"
#include "higherpair/io/row_path.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "numeric/eigen_index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
std::optional<PinnedRows> PinnedRows::of(const DesignSetup& setup) {
  if (!setup.numbers.is_linear()) {
    return std::nullopt;
  }
  const Model& model = setup.numbers.model();
  auto linkage = PinLinkage::of(model.mechanism(), *model.data().plan);
  return linkage ? std::optional(PinnedRows(setup, *std::move(linkage))) : std::nullopt;
}

PinnedRows::PinnedRows(const DesignSetup& setup, PinLinkage linkage)
    : setup_(&setup), linkage_(std::move(linkage)) {
  const DesignTask& task = setup.numbers.task();
  for (const DesignTask::PointPath* path : task.paths()) points_.push_back(path->ref);
  for (const DesignTask::Transmission* one : task.transmissions()) {
    transmissions_.push_back(linkage_.dyad_at(one->joint).value_or(0));
  }
  add_places(setup);
  largest_.resize(linkage_.dyads());
  for (auto& gaps : before_) gaps.resize(linkage_.dyads());
  last_assembled_.resize(place_of_row_.size());
  least_transmission_.resize(transmissions_.size());
}

void PinnedRows::add_places(const DesignSetup& setup) {
  std::vector<DriverMotion> last;
  std::vector<double> step;
  const auto add_part = [&](const std::vector<DriverMotion>& next, bool to_row) {
    const int parts = last.empty() ? 1 : closure_parts(setup, last, next);
    for (int part = 1; part <= parts; ++part) {
      Place& place = places_.emplace_back();
      if (to_row && part == parts) {
        place.row = place_of_row_.size();
        place_of_row_.push_back(places_.size() - 1);
      }
      bool even = places_.size() > 2;
      for (std::size_t i = 0; i < next.size(); ++i) {
        const double to = next[i].position;
        const double from = last.empty() ? to : last[i].position;
        turns_.push_back(Rotation<double>::from_angle(std::lerp(from, to, double(part) / parts)));
        const double stride = (to - from) / parts;
        if (step.size() < next.size()) step.push_back(stride);
        even = even && std::abs(stride - step[i]) <= kEvenStep * std::abs(stride);
        step[i] = stride;
      }
      place.even = even;
    }
    last = next;
  };
  for (std::int64_t k = 0; k < setup.schedule.size(); ++k) {
    const std::vector<DriverMotion> at_row = drivers_in(setup.schedule, k);
    for_each_part(setup.schedule, k, at_row,
                  [&](const std::vector<DriverMotion>& drivers, double /*from*/, double to) {
                    add_part(drivers, to == 1);
                  });
    positions_.push_back(at_row.front().position);
  }
}

bool PinnedRows::go_to(std::size_t place) {
  const std::size_t drivers = turns_.size() / places_.size();
  return linkage_.place(std::span(turns_).subspan(place * drivers, drivers));
}

void PinnedRows::work_out(std::span<const double> x, int branch, DesignRows& rows) {
  setup_->numbers.fill_numbers(x, numbers_);
  linkage_.set_numbers(numbers_);
  branch_ = branch;
  linkage_.set_branch(branch);
  rows.restart();
  rows.positions = positions_;
  rows.points.resize(points_.size());
  rows.transmissions.assign(transmissions_.size(), 1);
  largest_.assign(linkage_.dyads(), {-kInf, 0, false});
  for (auto& gaps : before_) std::fill(gaps.begin(), gaps.end(), kNoValue);
  std::optional<std::size_t> last_assembled;
  std::size_t not_good = 0;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const bool placed = go_to(k);
    note_gaps(k);
    if (!places_[k].row) continue;
    const std::size_t row = *places_[k].row;
    if (placed) {
      last_assembled = k;
      rows.started = true;
      note_transmissions(row, rows);
    }
    not_good += placed ? 0 : 1;
    last_assembled_[row] = last_assembled;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      auto& points = rows.points[i];
      points.push_back(placed || row == 0 ? linkage_.place_of(points_[i]) : points.back());
    }
  }
  bool closes = true;
  for (const Largest& largest : largest_) {
    rows.gaps.push_back(largest.gap);
    closes = closes && setup_->closes(largest.gap);
  }
  rows.missing =
      (static_cast<double>(not_good) + (closes ? 0 : 0.5)) / static_cast<double>(positions_.size());
}

void PinnedRows::note_gaps(std::size_t place) {
  for (std::size_t g = 0; g < largest_.size(); ++g) {
    const double gap = g < linkage_.known_gaps() ? linkage_.gap(g) : kNoValue;
    const auto vertex = places_[place].even ? vertex_of(before_[0][g], before_[1][g], gap) : std::nullopt;
    const double largest = vertex ? vertex->value : gap;
    if (largest > largest_[g].gap) largest_[g] = {largest, place, vertex.has_value()};
    before_[0][g] = before_[1][g];
    before_[1][g] = gap;
  }
}

void PinnedRows::note_transmissions(std::size_t row, DesignRows& rows) {
  for (std::size_t k = 0; k < transmissions_.size(); ++k) {
    const double sine = std::abs(linkage_.transmission(transmissions_[k]));
    if (sine < rows.transmissions[k]) {
      rows.transmissions[k] = sine;
      least_transmission_[k] = place_of_row_[row];
    }
  }
}

void PinnedRows::add_gap_slopes(std::size_t gap, double factor, Eigen::MatrixXd& J, Eigen::Index row) {
  const Largest& largest = largest_[gap];
  if (!std::isfinite(largest.gap)) {
    return;
  }
  const auto add = [&](std::size_t place, double weight) {
    (void)go_to(place);
    for (Eigen::Index i = 0; i < J.cols(); ++i) {
      linkage_.differentiate(setup_->numbers.slopes(static_cast<std::size_t>(i)));
      J(row, i) += weight * linkage_.gap_slope(gap);
    }
  };
  if (!largest.vertex) {
    add(largest.place, factor);
    return;
  }
  std::array<double, 3> gaps{};
  for (std::size_t k = 0; k < 3; ++k) {
    (void)go_to(largest.place + k - 2);
    gaps[k] = linkage_.gap(gap);
  }
  const GapVertex vertex = vertex_of(gaps[0], gaps[1], gaps[2]).value_or(GapVertex{0, {0, 1, 0}});
  for (std::size_t k = 0; k < 3; ++k) add(largest.place + k - 2, factor * vertex.weights[k]);
}

void PinnedRows::add_transmission_slopes(std::size_t transmission, double factor, Eigen::MatrixXd& J,
                                         Eigen::Index row) {
  const std::size_t dyad = transmissions_[transmission];
  (void)go_to(least_transmission_[transmission]);
  const double sign = linkage_.transmission(dyad) < 0 ? -factor : factor;
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    linkage_.differentiate(setup_->numbers.slopes(static_cast<std::size_t>(i)));
    J(row, i) += sign * linkage_.transmission_slope(dyad);
  }
}

const Eigen::Matrix2Xd& PinnedRows::slopes_here(const PointRef& point) {
  const std::size_t count = setup_->numbers.task().variables.size();
  point_slopes_.resize(2, eigen_index(count));
  for (std::size_t i = 0; i < count; ++i) {
    linkage_.differentiate(setup_->numbers.slopes(i));
    point_slopes_.col(eigen_index(i)) = linkage_.place_slope(point);
  }
  return point_slopes_;
}

const Eigen::Matrix2Xd& PinnedRows::point_slopes(const PointRef& point, std::size_t row) {
  if (!last_assembled_[row]) linkage_.set_branch(branch_);
  (void)go_to(last_assembled_[row].value_or(place_of_row_.front()));
  return slopes_here(point);
}

const Eigen::Matrix2Xd& PinnedRows::point_slopes_at(const PointRef& point, double driver) {
  const Rotation<double> turn = Rotation<double>::from_angle(driver);
  (void)linkage_.place(std::span(&turn, 1));
  return slopes_here(point);
}

}  // namespace higherpair
