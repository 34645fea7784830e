#include "design_row_reader.hpp"

#include "higherpair/mechanism/group_traits.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <cmath>

namespace higherpair {

RowReader::RowReader(const DesignSetup& setup, const Mechanism& mechanism, const Plan& plan, DesignRows& rows)
    : quantities_(setup.quantities),
      paths_(setup.numbers.task().paths()),
      transmissions_(setup.numbers.task().transmissions()),
      mechanism_(mechanism),
      plan_(plan),
      rows_(rows) {
  for (const Group& group : plan.groups) {
    modes_.push_back(rows_.gaps.size());
    if (traits_of(group).two_modes) rows_.gaps.push_back(-kInf);
  }
  rows_.gap_rows.resize(rows_.gaps.size());
  rows_.transmissions.assign(transmissions_.size(), 1);
  rows_.points.resize(paths_.size());
  for (const DesignQuantity& quantity : quantities_) {
    if (const auto* extent = quantity.as<DesignTask::Extent>()) rows_.extents.push_back(terms_of(*extent));
  }
}

void RowReader::take(const std::vector<BodyMotion>& bodies, bool assembled, double driver, RowStatus status) {
  rows_.positions.push_back(driver);
  not_good_ += status == RowStatus::kOk ? 0 : 1;
  if (assembled) {
    take_transmissions(bodies);
    take_extents(bodies);
  }
  for (std::size_t k = 0; k < paths_.size(); ++k) {
    const PointRef& ref = paths_[k]->ref;
    std::vector<Vector2d>& points = rows_.points[k];
    points.push_back(assembled || points.empty() ? bodies[ref.body].X_WB * point_of(mechanism_, ref)
                                                 : points.back());
  }
}

void RowReader::take_gaps(const std::vector<std::optional<double>>& gaps) {
  const std::size_t row = rows_.positions.size() - 1;
  for (std::size_t g = 0; g < plan_.groups.size(); ++g) {
    if (gaps[g]) take_gap(g, *gaps[g], {{row, 1}});
  }
}

void RowReader::take_gap(std::size_t group, double gap, const std::vector<WeightedRow>& rows) {
  const std::size_t mode = modes_[group];
  if (traits_of(plan_.groups[group]).two_modes && gap > rows_.gaps[mode]) {
    rows_.gaps[mode] = gap;
    rows_.gap_rows[mode] = rows;
  }
}

void RowReader::take_gaps(const std::vector<BodyMotion>& bodies) {
  std::vector<std::optional<double>> gaps;
  for (const Group& group : plan_.groups) gaps.push_back(closure_gap(group, bodies));
  take_gaps(gaps);
}

void RowReader::finish(int limits) {
  rows_.missing = (not_good_ + 0.5 * limits) / static_cast<double>(rows_.positions.size());
}

void RowReader::take_transmissions(const std::vector<BodyMotion>& bodies) {
  rows_.transmission_rows.resize(transmissions_.size());
  for (std::size_t k = 0; k < transmissions_.size(); ++k) {
    const double sine = std::abs(transmission_sine(plan_, transmissions_[k]->joint, bodies).value_or(0));
    if (sine < rows_.transmissions[k]) {
      rows_.transmissions[k] = sine;
      rows_.transmission_rows[k] = rows_.positions.size() - 1;
    }
  }
}

void RowReader::take_extents(const std::vector<BodyMotion>& bodies) {
  std::size_t k = 0;
  for (const DesignQuantity& quantity : quantities_) {
    const auto* extent = quantity.as<DesignTask::Extent>();
    if (extent == nullptr) continue;
    for (ExtentTerm& term : rows_.extents[k++]) {
      const double far = far_along(*extent, term.direction_W, mechanism_, bodies);
      if (far > term.far) {
        term.far = far;
        term.row = rows_.positions.size() - 1;
      }
    }
  }
}

}  // namespace higherpair
