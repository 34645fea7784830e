#include "higherpair/geometry/boundary_arcs.hpp"

#include "higherpair/geometry/boundary_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// Half of the nodes and weights on (-1, 1), which are symmetric.
constexpr std::array<std::pair<double, double>, 4> kGauss = {{{0.18343464249564980, 0.36268378337836198},
                                                              {0.52553240991632899, 0.31370664587788729},
                                                              {0.79666647741362674, 0.22238103445337447},
                                                              {0.96028985649753623, 0.10122853629037626}}};

}  // namespace

double arc_between(const Span& span, double from, double to) {
  const double half = (to - from) / 2;
  const double middle = from + half;
  double sum = 0;
  for (const auto& [place, weight] : kGauss) {
    sum += weight * (span.at(middle - half * place).speed + span.at(middle + half * place).speed);
  }
  return half * sum;
}

BoundaryArcs::BoundaryArcs(std::shared_ptr<const Boundary> own)
    : boundary_(std::move(own)),
      samples_of_(boundary_->spans().size()),
      chains_of_(boundary_->spans().size()) {
  const Boundary& boundary = *boundary_;
  const auto& samples = boundary.samples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto& [place, point] = samples[i];
    const bool in_span = i > 0 && samples[i - 1].place.span == place.span;
    const bool in_chain =
        in_span || (i > 0 && place.span > 0 && boundary.next_span(place.span, false) == place.span - 1);
    if (!in_chain) {
      chains_.emplace_back();
    }
    marks_.push_back(in_span ? mark_of(place, i - 1)
                     : in_chain
                         ? Mark{marks_.back().arc, nearest_turn(angle_of(point.n_B), marks_.back().normal)}
                         : Mark{0, angle_of(point.n_B)});
    if (!in_span) {
      samples_of_[place.span] = i;
      chains_of_[place.span] = chains_.size() - 1;
    }
    chains_.back().length = marks_.back().arc;
    const int first = boundary.next_span(place.span, true);
    if (first <= place.span && boundary.joint_after(place.span) != SpanJoint::kEnd) {
      const Mark& begin = marks_[samples_of_[first]];
      chains_.back().turn = nearest_turn(begin.normal, marks_.back().normal) - begin.normal;
    }
  }
}

BoundaryArcs::Mark BoundaryArcs::mark_of(const BoundaryPlace& place, std::size_t sample) const {
  const Mark& before = marks_[sample];
  const Span& span = *boundary_->spans()[place.span];
  const double arc = span.is_corner() ? 0 : arc_between(span, boundary_->samples()[sample].place.t, place.t);
  return {before.arc + arc, nearest_turn(angle_of(span.at(place.t).n_B), before.normal)};
}

double BoundaryArcs::at(const BoundaryPlace& place, double normal) const {
  const Bounds range = range_of(*boundary_, place.span);
  const int parts = boundary_->spans()[place.span]->parts();
  const double part = std::floor((place.t - range.low) / range.width() * parts);
  const auto before = samples_of_[place.span] + static_cast<std::size_t>(std::clamp(part, 0.0, parts - 1.0));
  const Mark here = mark_of(place, before);
  const Chain& chain = chains_[chains_of_[place.span]];
  const double rounds = chain.turn == 0 ? 0 : std::round((normal - here.normal) / chain.turn);
  return here.arc + rounds * chain.length;
}

}  // namespace higherpair
