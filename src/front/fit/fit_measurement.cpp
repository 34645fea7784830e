#include "fit_measurement.hpp"

#include "numeric/similarity.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using Kind = FitUnknown::Kind;

}  // namespace

void FitMeasurement::add(Kind kind, std::size_t index, std::string name, std::string unit) {
  unknowns_.push_back({kind, index, std::move(name), std::move(unit)});
}

FitMeasurement::FitMeasurement(const FitData& data) : data_(data) {
  const std::vector<DesignTask::Variable>& variables = data_.variables->variables;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    add(Kind::kVariable, i, variables[i].name, variables[i].unit);
  }
  for (std::size_t i = 0; i < data_.where.size(); ++i) {
    if (data_.where[i].offset) {
      add(Kind::kWhere, i, "offset of " + data_.where[i].name, data_.where[i].unit);
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
}

std::optional<double> FitMeasurement::at(const Eigen::VectorXd& x, Kind kind, std::size_t index) const {
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (unknowns_[i].kind == kind && unknowns_[i].index == index) return x(eigen_index(i));
  }
  return std::nullopt;
}

std::vector<double> FitMeasurement::variables_in(const Eigen::VectorXd& x) const {
  return {x.data(), x.data() + data_.variables->variables.size()};
}

std::vector<double> FitMeasurement::offsets_in(const Eigen::VectorXd& x) const {
  std::vector<double> offsets;
  for (std::size_t i = 0; i < data_.where.size(); ++i) {
    offsets.push_back(at(x, Kind::kWhere, i).value_or(0));
  }
  return offsets;
}

void FitMeasurement::show(const Eigen::VectorXd& x, FitTable& table) const {
  const double radians = to_si(dimension::kAngle, data_.model.units()).apply(1);
  for (std::size_t f = 0; f < data_.frames.size(); ++f) {
    const FitFrame& frame = data_.frames[f];
    const double s = at(x, Kind::kScale, f).value_or(1);
    const Vector2d along = s * unit_vector(radians * at(x, Kind::kTurn, f).value_or(0));
    const Eigen::VectorXd px = table.col(eigen_index(frame.x)), py = table.col(eigen_index(frame.y));
    table.col(eigen_index(frame.x)) =
        (along.x() * px - along.y() * py).array() + at(x, Kind::kPlaceX, f).value_or(0);
    table.col(eigen_index(frame.y)) =
        (along.y() * px + along.x() * py).array() + at(x, Kind::kPlaceY, f).value_or(0);
  }
  for (std::size_t c = 0; c < data_.columns.size(); ++c) {
    table.col(eigen_index(c)).array() += at(x, Kind::kOffset, c).value_or(0);
  }
}

FitTable FitMeasurement::change_shown(const Eigen::VectorXd& x, FitTable change) const {
  Eigen::VectorXd unplaced = x;
  for (std::size_t q = 0; q < unknowns_.size(); ++q) {
    const Kind kind = unknowns_[q].kind;
    if (kind == Kind::kPlaceX || kind == Kind::kPlaceY || kind == Kind::kOffset) unplaced(eigen_index(q)) = 0;
  }
  show(unplaced, change);
  return change;
}

FitTable FitMeasurement::derivative(const Eigen::VectorXd& x, const FitTable& table,
                                    const FitUnknown& unknown) const {
  FitTable by = FitTable::Zero(table.rows(), table.cols());
  if (unknown.kind == Kind::kOffset) {
    by.col(eigen_index(unknown.index)).setOnes();
    return by;
  }
  const double radians = to_si(dimension::kAngle, data_.model.units()).apply(1);
  const FitFrame& frame = data_.frames[unknown.index];
  const double s = at(x, Kind::kScale, unknown.index).value_or(1);
  const Vector2d turned = unit_vector(radians * at(x, Kind::kTurn, unknown.index).value_or(0));
  const auto px = table.col(eigen_index(frame.x)), py = table.col(eigen_index(frame.y));
  auto by_x = by.col(eigen_index(frame.x)), by_y = by.col(eigen_index(frame.y));
  switch (unknown.kind) {
    case Kind::kPlaceX:
      by_x.setOnes();
      break;
    case Kind::kPlaceY:
      by_y.setOnes();
      break;
    case Kind::kTurn:
      by_x = radians * s * (-turned.y() * px - turned.x() * py);
      by_y = radians * s * (turned.x() * px - turned.y() * py);
      break;
    case Kind::kScale:
      by_x = turned.x() * px - turned.y() * py;
      by_y = turned.y() * px + turned.x() * py;
      break;
    case Kind::kVariable:
    case Kind::kWhere:
    case Kind::kOffset:
      break;
  }
  return by;
}

void FitMeasurement::place_nearest(const FitTable& table, Eigen::VectorXd& x) const {
  place_frames(table, x);
  place_offsets(table, x);
}

// Finds the similarity, or its free part, that brings a point's path nearest to the measured one.
void FitMeasurement::place_frames(const FitTable& table, Eigen::VectorXd& x) const {
  const double per_radian = from_si(dimension::kAngle, data_.model.units()).apply(1);
  for (std::size_t f = 0; f < data_.frames.size(); ++f) {
    const FitFrame& frame = data_.frames[f];
    std::vector<std::pair<std::complex<double>, std::complex<double>>> pairs;  // place in the model, measured
                                                                               // place
    std::complex<double> from, to;
    for (std::size_t k = 0; k < data_.rows(); ++k) {
      const std::complex<double> own(table(eigen_index(k), eigen_index(frame.x)),
                                     table(eigen_index(k), eigen_index(frame.y)));
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
    std::complex<double> z = best_similarity(product, square, frame.task.turn, frame.task.scale);
    if (z == 0.0) z = 1;  // a point could not grow again
    const std::complex<double> t = to - z * from;
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      if (unknowns_[i].index != f) continue;
      if (unknowns_[i].kind == Kind::kPlaceX) x(eigen_index(i)) = t.real();
      if (unknowns_[i].kind == Kind::kPlaceY) x(eigen_index(i)) = t.imag();
      if (unknowns_[i].kind == Kind::kTurn) x(eigen_index(i)) = per_radian * std::arg(z);
      if (unknowns_[i].kind == Kind::kScale) x(eigen_index(i)) = std::abs(z);
    }
  }
}

void FitMeasurement::place_offsets(const FitTable& table, Eigen::VectorXd& x) const {
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    if (unknowns_[i].kind != Kind::kOffset) continue;
    std::vector<double> off;
    for (std::size_t k = 0; k < data_.rows(); ++k) {
      const double difference = data_.columns[unknowns_[i].index].values[k] -
                                table(eigen_index(k), eigen_index(unknowns_[i].index));
      if (std::isfinite(difference)) off.push_back(difference);
    }
    if (off.empty()) continue;
    std::nth_element(off.begin(), off.begin() + std::ssize(off) / 2, off.end());
    x(eigen_index(i)) = off[off.size() / 2];
  }
}

}  // namespace higherpair
