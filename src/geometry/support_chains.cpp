#include "higherpair/geometry/support_chains.hpp"

#include "higherpair/geometry/tolerances.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace higherpair {
namespace {

// By the angle of the outward normal; on a concave piece, where the angle decreases along t, by minus the
// angle.
class SupportSpan final : public Span {
public:
  SupportSpan(const SupportCurve& curve, std::size_t piece, const Bounds& phi, double sense)
      : curve_(curve), piece_(piece), phi_(phi), sense_(sense) {}

  [[nodiscard]] SpanPoint at(double t) const override {
    const double phi = sense_ * t;
    const SupportValue value = curve_.at(piece_, phi);
    const Vector2d n = unit_vector(phi);
    const double kappa = 1 / value.rho;
    return {value.h * n + value.dh * perp(n), n, kappa, -value.drho * kappa * kappa * kappa,
            sense_ * value.rho};
  }
  [[nodiscard]] Bounds range() const override { return with_sense(phi_); }
  [[nodiscard]] std::optional<SpanBounds> bounds(const Bounds& t) const override {
    return SpanBounds{with_sense(curve_.radius(piece_, with_sense(t))), {sense_, sense_}};
  }

private:
  [[nodiscard]] Bounds with_sense(const Bounds& x) const { return sense_ > 0 ? x : -x; }

  const SupportCurve& curve_;
  std::size_t piece_;
  Bounds phi_;
  double sense_;
};

SpanPtr span_of(const SupportCurve& curve, std::size_t index, double reach) {
  const SupportPiece& piece = curve.pieces()[index];
  if (piece.kind == PieceKind::kFace) {
    const double phi = (piece.phi.low + piece.phi.high) / 2;
    const Vector2d n = unit_vector(phi);
    const Vector2d foot = curve.at(index, phi).h * n;
    return face_span(foot, perp(n), {std::max(piece.along.low, -reach), std::min(piece.along.high, reach)});
  }
  const Bounds phi = normals_of(piece);
  const Bounds rho = curve.radius(index, phi);
  if (rho.low == 0 && rho.high == 0) {
    const SupportValue value = curve.at(index, phi.low);
    const Vector2d n = unit_vector(phi.low);
    return corner_span(value.h * n + value.dh * perp(n), phi.low, phi.high);
  }
  return std::make_shared<SupportSpan>(curve, index, phi, rho.high < 0 ? -1 : 1);
}

Vector2d first_point(const Span& span) {
  return span.at(span.range().low).p_B;
}

Vector2d last_point(const Span& span) {
  return span.at(span.range().high).p_B;
}

}  // namespace

std::vector<Boundary> support_chains(const SupportCurve& curve, double reach) {
  std::vector<std::vector<SpanPtr>> parts;
  const double near = kSameSupportEnd * reach;
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    SpanPtr span = span_of(curve, i, reach);
    if (parts.empty() || (last_point(*parts.back().back()) - first_point(*span)).norm() > near) {
      parts.emplace_back();
    }
    parts.back().push_back(std::move(span));
  }
  std::vector<Boundary> chains;
  for (std::vector<SpanPtr>& spans : parts) {
    const bool closed = (last_point(*spans.back()) - first_point(*spans.front())).norm() <= near;
    auto chain = Boundary::make(std::move(spans), closed, near);
    if (!chain) {
      return {};
    }
    chains.push_back(*std::move(chain));
  }
  return chains;
}

}  // namespace higherpair
