#include "higherpair/cam/motion_law.hpp"

#include "law_data.hpp"
#include "law_faults.hpp"
#include "tolerances.hpp"

#include <cassert>

namespace higherpair {
namespace {

std::array<double, 4> derivatives(const MotionLaw& law, double x, LawSide side) {
  std::array<double, 4> c{};
  law.expand(x, side, c);
  return {c[0], c[1], 2 * c[2], 6 * c[3]};
}

std::vector<LawJoin> joins_of(const MotionLaw& law, const LawPieces& pieces) {
  std::array<double, 4> scale{};
  for (int k = 1; k < 4; ++k) {
    scale[k] = std::abs(law.extremes(k).peak());
  }
  std::vector<LawJoin> joins;
  for (std::size_t i = 0; i < pieces.begins.size(); ++i) {
    const bool is_end = i == pieces.pieces.size();
    if (!is_end && pieces.pieces[i].start > PieceStart::kPart) {
      continue;
    }
    LawJoin join{pieces.begins[i], {}, {}, {}};
    join.before = derivatives(law, join.x, LawSide::kBefore);
    join.after = derivatives(law, join.x, LawSide::kAfter);
    for (std::size_t k = 1; k < scale.size(); ++k) {
      join.is_jump[k] = std::abs(join.after[k] - join.before[k]) > kNoLawJump * scale[k];
    }
    if (is_end || pieces.pieces[i].start == PieceStart::kSegment || join.lowest_jump() > 0) {
      joins.push_back(join);
    }
  }
  return joins;
}

LawPieces pieces_of(const LawDescription& description) {
  LawPieces law;
  if (!description.points.empty()) {
    add_spline(description, law);
    return law;
  }
  double length = 0;
  double value = description.start;
  if (description.segments.front().type == LawType::kPolynomial) {
    value = description.segments.front().start.front();
  }
  double begin = description.origin;
  for (const LawSegment& segment : description.segments) {
    length += segment.over;
    const double end = description.origin + length;
    value = add_segment(segment, begin, end, value, law);
    begin = end;
  }
  law.set_end(begin);
  return law;
}

}  // namespace

tl::expected<MotionLaw, LawFault> MotionLaw::make(const LawDescription& description) {
  if (auto fault = fault_of(description)) {
    return tl::unexpected(*std::move(fault));
  }
  auto data = std::make_shared<Data>();
  data->law = pieces_of(description);
  data->repeats = description.repeats;
  const std::vector<double>& begins = data->law.begins;
  if (!std::is_sorted(begins.begin(), begins.end(), [](double a, double b) { return a <= b; })) {
    return tl::unexpected(LawFault{{}, {}, "origin", "is so large that segments vanish beside it"});
  }
  data->first = data->law.derivative(data->law.pieces.front(), 0, data->begin());
  data->last = data->law.derivative(data->law.pieces.back(), 0, data->end());
  if (std::abs(data->advance()) <= kNoAdvance * data->size(0)) {
    data->last = data->first;
  }
  if (!std::isfinite(data->size(0)) || !std::isfinite(data->size(4))) {
    return tl::unexpected(LawFault{{}, {}, "", "leaves the range of numbers"});
  }
  const MotionLaw law(data);
  data->joins = joins_of(law, data->law);
  return law;
}

double MotionLaw::begin() const {
  return data_->begin();
}

double MotionLaw::end() const {
  return data_->end();
}

bool MotionLaw::repeats() const {
  return data_->repeats;
}

double MotionLaw::advance() const {
  return data_->advance();
}

const std::vector<LawJoin>& MotionLaw::joins() const {
  return data_->joins;
}

MotionLaw MotionLaw::repeated(int count) const {
  assert(repeats() && count >= 1);
  auto data = std::make_shared<Data>(*data_);
  LawPieces& law = data->law;
  for (int turn = 1; turn < count; ++turn) {
    law.begins.pop_back();
    for (LawPiece piece : data_->law.pieces) {
      piece.begin += turn * data_->length();
      piece.origin += turn * data_->length();
      piece.base += turn * advance();
      law.begins.push_back(piece.begin);
      law.pieces.push_back(piece);
    }
    law.set_end(data_->begin() + (turn + 1) * data_->length());
  }
  data->last = data_->first + count * advance();
  MotionLaw law_of_all(data);
  data->joins = joins_of(law_of_all, law);
  return law_of_all;
}

void MotionLaw::expand(double x, LawSide side, std::span<double> out) const {
  const Data::Found found = data_->find(x, side);
  if (found.piece == nullptr) {
    std::fill(out.begin(), out.end(), 0.0);
  } else {
    data_->law.expand(*found.piece, found.x, out);
  }
  out[0] += found.offset;
}

double MotionLaw::derivative(int k, double x, LawSide side) const {
  const Data::Found found = data_->find(x, side);
  const double own = found.piece == nullptr ? 0 : data_->law.derivative(*found.piece, k, found.x);
  return k == 0 ? own + found.offset : own;
}

}  // namespace higherpair
