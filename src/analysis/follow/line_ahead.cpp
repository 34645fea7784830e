#include "line_ahead.hpp"

#include "analysis/tolerances.hpp"
#include "step.hpp"

#include <cmath>

namespace higherpair {

LineAhead::LineAhead(const Run& run, const std::vector<double>& from, const std::vector<double>& to)
    : begin_(run.at.lost.at) {
  aim(run, to);
  const std::vector<double> on_line = at(x_of(from));
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double off = std::abs(from[i] - on_line[i]);
    is_from_limit_ = is_from_limit_ && off <= kOnLineAhead * (input_scale(run, i) + std::abs(from[i]));
  }
  if (!is_from_limit_) {
    begin_ = from;
    aim(run, to);
  }
}

void LineAhead::aim(const Run& run, const std::vector<double>& to) {
  leading_ = leading_input(run, begin_, to);
  scale_ = input_scale(run, leading_);
  sense_ = to[leading_] < begin_[leading_] ? -1 : 1;
  slope_.resize(to.size());
  for (std::size_t i = 0; i < to.size(); ++i) {
    slope_[i] = i == leading_ ? 1 : (to[i] - begin_[i]) / (to[leading_] - begin_[leading_]);
  }
}

std::vector<double> LineAhead::at(double x) const {
  std::vector<double> inputs(begin_.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs[i] = i == leading_ ? x : begin_[i] + (x - begin_[leading_]) * slope_[i];
  }
  return inputs;
}

}  // namespace higherpair
