#include "higherpair/cam/motion_law.hpp"

#include "law_faults.hpp"
#include "law_pieces.hpp"
#include "law_search.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace higherpair {
namespace {

constexpr double kAtJoin = 8 * std::numeric_limits<double>::epsilon();

// A change of a derivative at a join that is smaller, relative to its largest size in the law, is rounding.
constexpr double kJump = 1e-9;

// Derivatives below this, relative to their largest size, are rounding.
constexpr double kNoise = 1e-13;

// Where the last repetition ends higher by less than this, relative to the largest value, it is rounding.
constexpr double kNoAdvance = 1e-14;

}  // namespace

struct MotionLaw::Data {
  LawPieces law;
  bool repeats = false;
  double first = 0;  ///< value at the begin
  double last = 0;   ///< and at the end
  std::vector<LawJoin> joins;

  [[nodiscard]] double begin() const { return law.begins.front(); }
  [[nodiscard]] double end() const { return law.begins.back(); }
  [[nodiscard]] double length() const { return end() - begin(); }
  [[nodiscard]] double advance() const { return last - first; }

  // A piece and where x is in it; no piece: beyond the ends of a law that does not repeat.
  struct Found {
    const LawPiece* piece = nullptr;
    double x = 0;
    double offset = 0;  // to the value
  };

  [[nodiscard]] Found find(double x, LawSide side) const {
    const double near = kAtJoin * std::max({std::abs(x), std::abs(begin()), std::abs(end())});
    double offset = 0;
    if (repeats && (x < begin() || x >= end())) {
      const double turns = std::floor((x - begin()) / length());
      x -= turns * length();
      offset = turns * advance();
    }
    const auto next = std::upper_bound(law.begins.begin(), law.begins.end(), x);
    auto i = static_cast<std::ptrdiff_t>(next - law.begins.begin()) - 1;
    const auto count = static_cast<std::ptrdiff_t>(law.pieces.size());
    const auto join = [&](std::ptrdiff_t k) { return law.begins[static_cast<std::size_t>(k)]; };
    if (side == LawSide::kAfter && i < count && join(i + 1) - x <= near) {
      x = join(++i);
    } else if (side == LawSide::kBefore && i >= 0 && x - join(i) <= near) {
      x = join(i--);
    } else if (side == LawSide::kBefore && i < count && join(i + 1) - x <= near) {
      x = join(i + 1);
    } else if (side == LawSide::kAfter && i >= 0 && x - join(i) <= near) {
      x = join(i);
    }
    if (repeats && i == count) {
      return {&law.pieces.front(), x - length(), offset + advance()};
    }
    if (repeats && i < 0) {
      return {&law.pieces.back(), x + length(), offset - advance()};
    }
    if (i < 0 || i >= count) {
      return {nullptr, x, i < 0 ? first : last};
    }
    return {&law.pieces[static_cast<std::size_t>(i)], x, offset};
  }

  // Calls visit(piece, from, to, offset, shift) for every piece between two coordinates, in order; from and
  // to are in the first repetition, and x is shift on. Without a piece: the law stays.
  template <class Visit>
  void for_each_piece(double from, double to, const Visit& visit) const {
    const std::size_t count = law.pieces.size();
    const auto visit_turn = [&](double turn) {
      const double shift = turn * length();
      for (std::size_t i = 0; i < count; ++i) {
        const double low = std::max(from - shift, law.begins[i]);
        const double high = std::min(to - shift, law.begins[i + 1]);
        if (low <= high) {
          visit(&law.pieces[i], low, high, turn * advance(), shift);
        }
      }
    };
    if (repeats) {
      const double last_turn = std::floor((to - begin()) / length());
      for (double turn = std::floor((from - begin()) / length()); turn <= last_turn; ++turn) {
        visit_turn(turn);
      }
      return;
    }
    if (from < begin()) {
      visit(static_cast<const LawPiece*>(nullptr), from, std::min(to, begin()), first, 0.0);
    }
    visit_turn(0);
    if (to > end()) {
      visit(static_cast<const LawPiece*>(nullptr), std::max(from, end()), to, last, 0.0);
    }
  }

  [[nodiscard]] std::vector<double> places(int k, double from, double to, double level) const;

  // A bound of the size of the k-th derivative over the whole law; infinite where that leaves the range of
  // numbers.
  [[nodiscard]] double size(int k) const {
    double largest = 0;
    for (std::size_t i = 0; i < law.pieces.size(); ++i) {
      const Bounds own = law.bounds(law.pieces[i], k, law.begins[i], law.begins[i + 1]);
      if (!std::isfinite(own.width())) {
        return std::numeric_limits<double>::infinity();
      }
      largest = std::max({largest, -own.low, own.high});
    }
    return largest;
  }
};

namespace {

std::array<double, 4> derivatives(const MotionLaw& law, double x, LawSide side) {
  std::array<double, 4> c{};
  law.expand(x, side, c);
  return {c[0], c[1], 2 * c[2], 6 * c[3]};
}

std::vector<LawJoin> joins_of(const MotionLaw& law, const LawPieces& pieces) {
  std::array<double, 4> scale{};
  for (int k = 1; k < 4; ++k) {
    scale[static_cast<std::size_t>(k)] = std::abs(law.extremes(k).peak());
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
      join.is_jump[k] = std::abs(join.after[k] - join.before[k]) > kJump * scale[k];
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

std::vector<double> MotionLaw::breaks(double from, double to) const {
  std::vector<double> found;
  const auto visit = [&](const LawPiece* piece, double low, double high, double, double shift) {
    const bool breaks = piece == nullptr || (piece->start != PieceStart::kSmooth && low == piece->begin);
    const bool ends = high == end();
    for (const double x : {breaks ? low + shift : from, ends ? high + shift : from}) {
      if (x > from && x < to && (found.empty() || x > found.back())) {
        found.push_back(x);
      }
    }
  };
  data_->for_each_piece(from, to, visit);
  return found;
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

Bounds MotionLaw::bounds(int k, double from, double to) const {
  assert(from <= to);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Bounds all{kInfinity, -kInfinity};
  const double near = kAtJoin * std::max(std::abs(from), std::abs(to));
  data_->for_each_piece(from - near, to + near,
                        [&](const LawPiece* piece, double low, double high, double offset, double) {
                          Bounds own = piece ? data_->law.bounds(*piece, k, low, high) : Bounds{};
                          if (k == 0) {
                            own.low += offset;
                            own.high += offset;
                          }
                          all.low = std::min(all.low, own.low);
                          all.high = std::max(all.high, own.high);
                        });
  return all;
}

LawExtremes MotionLaw::extremes(int k, double from, double to) const {
  assert(from <= to);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  LawExtremes best{kInfinity, 0, -kInfinity, 0};
  const auto consider = [&](double value, double x) {
    if (value < best.least) {
      best.least = value;
      best.least_at = x;
    }
    if (value > best.greatest) {
      best.greatest = value;
      best.greatest_at = x;
    }
  };
  const LawPieces& law = data_->law;
  const double negligible = kNoise * data_->size(k + 1);
  const auto value = [&](const LawPiece* piece, double x, double offset) {
    return (piece ? law.derivative(*piece, k, x) : 0) + (k == 0 ? offset : 0);
  };
  const auto at_ends = [&](const LawPiece* piece, double low, double high, double offset, double shift) {
    consider(value(piece, low, offset), low + shift);
    consider(value(piece, high, offset), high + shift);
  };
  const auto within = [&](const LawPiece* piece, double low, double high, double offset, double shift) {
    if (piece == nullptr) {
      return;
    }
    const Bounds own = law.bounds(*piece, k, low, high);
    const double base = k == 0 ? offset : 0;
    if (own.low + base < best.least || own.high + base > best.greatest) {
      for (const double x : zeros_of(law, *piece, k + 1, low, high, negligible)) {
        consider(value(piece, x, offset), x + shift);
      }
    }
  };
  data_->for_each_piece(from, to, at_ends);
  data_->for_each_piece(from, to, within);
  return best;
}

// Where the k-th derivative is `level`, which is 0 but for k = 0.
std::vector<double> MotionLaw::Data::places(int k, double from, double to, double level) const {
  std::vector<double> found;
  const auto add = [&](double x) {
    if (found.empty() || x > found.back()) {
      found.push_back(x);
    }
  };
  const double negligible = kNoise * size(k);
  double before = 0;  // sign at the end of the piece before
  const auto visit = [&](const LawPiece* piece, double low, double high, double offset, double shift) {
    const double higher_by = k == 0 ? offset - level : 0;
    const auto value = [&](double x) { return (piece ? law.derivative(*piece, k, x) : 0) + higher_by; };
    const double at_low = value(low);
    if (before * at_low < 0) {
      add(low + shift);
    }
    before = value(high);
    if (piece == nullptr) {
      return;
    }
    // The piece by itself, higher by so much.
    LawPieces own;
    LawPiece raised = *piece;
    raised.base += higher_by;
    own.add(raised, std::span(law.powers).subspan(piece->first_power, piece->powers),
            std::span(law.waves).subspan(piece->first_wave, piece->waves));
    if (own.vanishes(own.pieces.front(), k)) {
      return;
    }
    if (std::abs(at_low) <= negligible) {
      add(low + shift);
    }
    for (const double x : zeros_of(own, own.pieces.front(), k, low, high, negligible)) {
      add(x + shift);
    }
    if (std::abs(before) <= negligible) {
      add(high + shift);
    }
  };
  for_each_piece(from, to, visit);
  return found;
}

std::vector<double> MotionLaw::zeros(int k, double from, double to) const {
  return data_->places(k, from, to, 0);
}

std::vector<double> MotionLaw::places(double value, double from, double to) const {
  return data_->places(0, from, to, value);
}

}  // namespace higherpair
