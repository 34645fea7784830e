#include "fit_problem.hpp"

#include "fit_columns.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace higherpair {
namespace {

using Kind = FitUnknown::Kind;

constexpr int kPlaces = 36;  // at which an unknown zero of a driver is tried

}  // namespace

FitProblem::FitProblem(const FitData& data, const FitMotion& motion) : data_(data), motion_(motion) {
  for (std::size_t k = 0; k < data.rows(); ++k) {
    for (std::size_t c = 0; c < data.columns.size(); ++c) {
      if (!std::isnan(data.columns[c].values[k])) values_.push_back({k, c});
    }
  }
  for (const FitColumn& column : data.columns) {
    double sum = 0, count = 0, largest = 0;
    for (const double value : column.values) {
      if (std::isnan(value)) continue;
      sum += value;
      count += 1;
      largest = std::max(largest, std::abs(value));
    }
    double spread = 0;
    for (const double value : column.values) {
      if (!std::isnan(value)) spread = std::max(spread, std::abs(value - sum / count));
    }
    largest_.push_back(largest > 0 ? largest : 1);
    spreads_.push_back(spread > 1e-12 * largest ? spread : largest_.back());
  }
  add_unknowns();
}

void FitProblem::add(Kind kind, std::size_t index, std::string name, std::string unit) {
  unknowns_.push_back({kind, index, std::move(name), std::move(unit)});
}

void FitProblem::add_unknowns() {
  const std::vector<DesignTask::Variable>& variables = data_.variables->variables;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    add(Kind::kVariable, i, variables[i].name, variables[i].unit);
  }
  for (std::size_t i = 0; i < data_.where_offset.size(); ++i) {
    if (data_.where_offset[i]) {
      add(Kind::kWhere, i, "offset of " + data_.where_names[i], data_.where_unit());
    }
  }
  for (std::size_t c = 0; c < data_.columns.size(); ++c) {
    if (data_.columns[c].offset) {
      add(Kind::kOffset, c, "offset of " + data_.columns[c].name, data_.columns[c].unit);
    }
  }
  for (std::size_t f = 0; f < data_.frames.size(); ++f) {
    const FitTask::Frame& frame = data_.frames[f].task;
    const std::string& unit = data_.columns[data_.frames[f].x].unit;
    if (frame.position) {
      add(Kind::kPlaceX, f, fmt::format("frame of {}: x", frame.point), unit);
      add(Kind::kPlaceY, f, fmt::format("frame of {}: y", frame.point), unit);
    }
    if (frame.turn) {
      add(Kind::kTurn, f, fmt::format("frame of {}: angle", frame.point),
          unit_text(dimension::kAngle, data_.model.units()));
    }
    if (frame.scale) add(Kind::kScale, f, fmt::format("frame of {}: scale", frame.point), "1");
  }
  low_ = Eigen::VectorXd::Constant(size(), -kInf);
  high_ = Eigen::VectorXd::Constant(size(), kInf);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    low_(place(i)) = variables[i].range.low;
    high_(place(i)) = variables[i].range.high;
  }
}

std::optional<double> FitProblem::at(const Eigen::VectorXd& x, Kind kind, std::size_t index) const {
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (unknowns_[i].kind == kind && unknowns_[i].index == index) return x(place(i));
  }
  return std::nullopt;
}

std::vector<double> FitProblem::variables_in(const Eigen::VectorXd& x) const {
  return {x.data(), x.data() + data_.variables->variables.size()};
}

std::vector<double> FitProblem::offsets_in(const Eigen::VectorXd& x) const {
  std::vector<double> offsets;
  for (std::size_t i = 0; i < data_.where.size(); ++i) {
    offsets.push_back(at(x, Kind::kWhere, i).value_or(0));
  }
  return offsets;
}

// measured = t + s R(φ) (x, y) of a point in a frame of its own, measured = x + offset of a column.
void FitProblem::use_measurement(const Eigen::VectorXd& x, FitTable& table) const {
  const double radians = to_si(dimension::kAngle, data_.model.units()).apply(1);
  for (std::size_t f = 0; f < data_.frames.size(); ++f) {
    const FitFrame& frame = data_.frames[f];
    const double s = at(x, Kind::kScale, f).value_or(1);
    const Vector2d along = s * unit_vector(radians * at(x, Kind::kTurn, f).value_or(0));
    const Eigen::VectorXd px = table.col(place(frame.x)), py = table.col(place(frame.y));
    table.col(place(frame.x)) =
        (along.x() * px - along.y() * py).array() + at(x, Kind::kPlaceX, f).value_or(0);
    table.col(place(frame.y)) =
        (along.y() * px + along.x() * py).array() + at(x, Kind::kPlaceY, f).value_or(0);
  }
  for (std::size_t c = 0; c < data_.columns.size(); ++c) {
    table.col(place(c)).array() += at(x, Kind::kOffset, c).value_or(0);
  }
}

Eigen::VectorXd FitProblem::residuals_of(const FitTable& fitted, int* missing) const {
  Eigen::VectorXd r(place(values_.size()));
  if (missing != nullptr) *missing = 0;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Value& value = values_[i];
    const double own = fitted(place(value.row), place(value.column));
    r(place(i)) =
        std::isfinite(own) ? data_.columns[value.column].values[value.row] - own : spread(value.column);
    if (missing != nullptr && !std::isfinite(own)) ++*missing;
  }
  return r;
}

std::optional<Eigen::VectorXd> FitProblem::residuals(const Eigen::VectorXd& x, int* missing) const {
  auto table = motion_.table(variables_in(x), offsets_in(x));
  if (!table) return std::nullopt;
  use_measurement(x, *table);
  return residuals_of(*table, missing);
}

std::optional<Eigen::MatrixXd> FitProblem::jacobian(const Eigen::VectorXd& x) const {
  const std::vector<double> variables = variables_in(x), offsets = offsets_in(x);
  const auto table = motion_.table(variables, offsets);
  auto by_motion = motion_.derivatives(variables, offsets);
  if (!table || !by_motion) return std::nullopt;
  const double radians = to_si(dimension::kAngle, data_.model.units()).apply(1);
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(place(values_.size()), size());
  std::size_t moved = 0;  // unknowns that the motion depends on come first
  for (std::size_t p = 0; p < unknowns_.size(); ++p) {
    const FitUnknown& unknown = unknowns_[p];
    FitTable by;
    if (unknown.kind == Kind::kVariable || unknown.kind == Kind::kWhere) {
      by = std::move((*by_motion)[moved++]);
      // Of these, frames turn and scale what points do; places and offsets have no part in it.
      Eigen::VectorXd unplaced = x;
      for (std::size_t q = 0; q < unknowns_.size(); ++q) {
        const Kind kind = unknowns_[q].kind;
        if (kind == Kind::kPlaceX || kind == Kind::kPlaceY || kind == Kind::kOffset) unplaced(place(q)) = 0;
      }
      use_measurement(unplaced, by);
    } else {
      by = FitTable::Zero(table->rows(), table->cols());
      if (unknown.kind == Kind::kOffset) by.col(place(unknown.index)).setOnes();
      if (unknown.kind != Kind::kOffset) {
        const FitFrame& frame = data_.frames[unknown.index];
        const double s = at(x, Kind::kScale, unknown.index).value_or(1);
        const Vector2d turned = unit_vector(radians * at(x, Kind::kTurn, unknown.index).value_or(0));
        const auto px = table->col(place(frame.x)), py = table->col(place(frame.y));
        if (unknown.kind == Kind::kPlaceX) by.col(place(frame.x)).setOnes();
        if (unknown.kind == Kind::kPlaceY) by.col(place(frame.y)).setOnes();
        if (unknown.kind == Kind::kTurn) {
          by.col(place(frame.x)) = radians * s * (-turned.y() * px - turned.x() * py);
          by.col(place(frame.y)) = radians * s * (turned.x() * px - turned.y() * py);
        }
        if (unknown.kind == Kind::kScale) {
          by.col(place(frame.x)) = turned.x() * px - turned.y() * py;
          by.col(place(frame.y)) = turned.y() * px + turned.x() * py;
        }
      }
    }
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double slope = by(place(values_[i].row), place(values_[i].column));
      const bool there = std::isfinite((*table)(place(values_[i].row), place(values_[i].column)));
      J(place(i), place(p)) = there && std::isfinite(slope) ? -slope : 0;
    }
  }
  return J;
}

std::vector<double> FitProblem::unwrapped(std::size_t column, const Eigen::VectorXd& x) const {
  std::vector<double> values = data_.columns[column].values;
  const double turn = from_si(dimension::kAngle, data_.model.units()).apply(2 * kPi);
  const auto r = residuals(x);
  if (data_.columns[column].unit != unit_text(dimension::kAngle, data_.model.units()) || !r) return values;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (values_[i].column != column) continue;
    const double off = std::remainder((*r)(place(i)), turn);
    if (!(std::abs(off) <= turn / 4)) return data_.columns[column].values;
    values[values_[i].row] += off - (*r)(place(i));
  }
  return values;
}

// The similarity, or what of it is free, that takes a point's path nearest to the measured one.
void FitProblem::place_frames(const FitTable& table, Eigen::VectorXd& x) const {
  const double per_radian = from_si(dimension::kAngle, data_.model.units()).apply(1);
  for (std::size_t f = 0; f < data_.frames.size(); ++f) {
    const FitFrame& frame = data_.frames[f];
    std::vector<std::pair<std::complex<double>, std::complex<double>>> pairs;  // of the model, measured
    std::complex<double> from, to;
    for (std::size_t k = 0; k < data_.rows(); ++k) {
      const std::complex<double> own(table(place(k), place(frame.x)), table(place(k), place(frame.y)));
      const std::complex<double> seen(data_.columns[frame.x].values[k], data_.columns[frame.y].values[k]);
      if (!std::isfinite(std::abs(own)) || !std::isfinite(std::abs(seen))) continue;
      pairs.emplace_back(own, seen);
      from += own;
      to += seen;
    }
    const double count = std::max<double>(1, static_cast<double>(pairs.size()));
    from = frame.task.position ? from / count : 0;
    to = frame.task.position ? to / count : 0;
    std::complex<double> product;
    double square = 0;
    for (const auto& [own, seen] : pairs) {
      product += std::conj(own - from) * (seen - to);
      square += std::norm(own - from);
    }
    const double angle = frame.task.turn ? std::arg(product) : 0;
    const double projected = (product * std::polar(1.0, -angle)).real();
    const double s = frame.task.scale && square > 0 && projected > 0 ? projected / square : 1;
    const std::complex<double> t = to - std::polar(s, angle) * from;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      if (unknowns_[i].index != f) continue;
      if (unknowns_[i].kind == Kind::kPlaceX) x(place(i)) = t.real();
      if (unknowns_[i].kind == Kind::kPlaceY) x(place(i)) = t.imag();
      if (unknowns_[i].kind == Kind::kTurn) x(place(i)) = per_radian * angle;
      if (unknowns_[i].kind == Kind::kScale) x(place(i)) = s;
    }
  }
}

void FitProblem::place_offsets(const FitTable& table, Eigen::VectorXd& x) const {
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (unknowns_[i].kind != Kind::kOffset) continue;
    std::vector<double> off;
    for (std::size_t k = 0; k < data_.rows(); ++k) {
      const double difference =
          data_.columns[unknowns_[i].index].values[k] - table(place(k), place(unknowns_[i].index));
      if (std::isfinite(difference)) off.push_back(difference);
    }
    if (off.empty()) continue;
    std::nth_element(off.begin(), off.begin() + std::ssize(off) / 2, off.end());
    x(place(i)) = off[off.size() / 2];
  }
}

Eigen::VectorXd FitProblem::start() const {
  std::vector<double> variables;
  for (const DesignTask::Variable& variable : data_.variables->variables) {
    variables.push_back(variable.range.start);
  }
  if (auto x = start_from(variables)) return *std::move(x);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(size());
  std::copy(variables.begin(), variables.end(), x.begin());
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (unknowns_[i].kind == Kind::kScale) x(place(i)) = 1;
  }
  return x;
}

std::optional<Eigen::VectorXd> FitProblem::start_from(std::span<const double> variables) const {
  std::optional<Eigen::VectorXd> best;
  double least = kInf;
  const auto try_at = [&](double share) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(size());
    std::copy(variables.begin(), variables.end(), x.begin());
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      if (unknowns_[i].kind == Kind::kScale) x(place(i)) = 1;
      if (unknowns_[i].kind != Kind::kWhere) continue;
      const std::vector<double>& where = data_.where[unknowns_[i].index];
      const auto [first, last] = std::minmax_element(where.begin(), where.end());
      const bool turns = !data_.in_time() && driver_turns(data_.model.mechanism(), unknowns_[i].index);
      x(place(i)) =
          share * (turns ? from_si(dimension::kAngle, data_.model.units()).apply(2 * kPi) : *last - *first);
    }
    auto table = motion_.table(variables_in(x), offsets_in(x));
    if (!table) return;
    place_frames(*table, x);
    place_offsets(*table, x);
    use_measurement(x, *table);
    const Eigen::VectorXd r = residuals_of(*table, nullptr);
    double sum = 0;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      sum += std::pow(r(place(i)) / spread(values_[i].column), 2);
    }
    if (sum < least) {
      least = sum;
      best = x;
    }
  };
  try_at(0);
  const bool unknown_zero = std::any_of(unknowns_.begin(), unknowns_.end(),
                                        [](const FitUnknown& u) { return u.kind == Kind::kWhere; });
  for (int k = 1; unknown_zero && k < kPlaces; ++k) {
    try_at((k % 2 == 0 ? 0.5 : -0.5) * (k + 1) / kPlaces);
  }
  return best;
}

}  // namespace higherpair
