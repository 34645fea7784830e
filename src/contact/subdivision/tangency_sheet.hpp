#pragma once

#include "higherpair/contact/boundary_contact.hpp"

namespace higherpair {

/// A point of a boundary, with its body at the coordinate 0.
struct SheetPlace {
  Vector2d p_W = Vector2d::Zero();  ///< [m]
  /// Outward unit normal; of body 2 the inward one for tangencies of equal outward normals.
  Vector2d n_W = Vector2d::UnitX();
  double along = 0;  ///< dp/dt = along·t, t = n turned +90° [m per unit of the parameter]
  double turn = 0;   ///< d(angle of n)/dt [rad per unit of the parameter]
  bool corner = false;
};

/// Enclosure of the points along a stretch of a span.
struct SheetStretch {
  SheetPlace middle;
  double half = 0;     ///< half the width of its parameter interval
  double reach = 0;    ///< largest distance of its points from the middle one [m]
  double tilt = 0;     ///< largest angle between its normals and the middle one [rad]
  Bounds along, turn;  ///< of SheetPlace::along and turn
};

/// What is known about F in the cell of two stretches.
struct SheetRange {
  bool zero = true;            ///< F may reach the given level
  int slope1 = 0, slope2 = 0;  ///< sign of ∂F by the parameter throughout; 0: unknown or not constant
};

/// A tangency of the pair; vectors in ground W.
struct SheetPoint : TangentPosition {
  double gap_q = 0;          ///< n·(velocity of body 2 per q): 0 at a fold
  double gap_u = 0;          ///< n·(velocity of body 1 per u): 0 where the follower turns back
  double curvature_sum = 0;  ///< κ1 + κ2 [1/m], +1 with a corner on one side, 0 with corners on both
};

/// All tangencies of two moving boundaries, as the zeros of one function of the two places.
///
/// Opposed normals and a common point are three equations in u, q and the two places, from which u and q are
/// eliminated in closed form. With m the points relative to the pivots O, d the directions of slides, d⊥ = d
/// turned +90°:
///
///     driver, follower   u, q                                             F [m]
///     turns, turns       q - u = ψ turns n2 into -n1; R(u) w = O2 - O1    (w² - O1O2²)/(2 O1O2)
///                        with w = m1 - R(ψ) m2
///     turns, slides      u turns n1 into -n2; q = (O1 + R(u) m1 - p2)·d   (O1 + R(u) m1 - p2)·d⊥
///     slides, turns      q turns n2 into -n1; u = (O2 + R(q) m2 - p1)·d   (O2 + R(q) m2 - p1)·d⊥
///     slides, slides     u d1 - q d2 = p2 - p1                            (n1 × n2) size()
///
/// F and its slopes are continuous across joints of spans, and have no singularity at folds, at conforming
/// contacts, on faces or on corners.
class TangencySheet {
public:
  /// \param opposed  false: the tangencies of equal outward normals
  TangencySheet(const BoundaryPair& pair, bool opposed);

  /// Whether the places determine u and q: not with one pivot for both bodies, or parallel slides.
  [[nodiscard]] bool is_regular() const;
  [[nodiscard]] bool opposed() const { return side2_ > 0; }
  [[nodiscard]] const BoundaryPair& pair() const { return pair_; }
  /// Order of magnitude of F [m].
  [[nodiscard]] double size() const { return size_; }

  [[nodiscard]] SheetPlace place1(const BoundaryPlace& at) const;
  [[nodiscard]] SheetPlace place2(const BoundaryPlace& at) const;

  /// For a span that gives no bounds, by its values at the middle and both ends: not proven.
  [[nodiscard]] SheetStretch stretch1(int span, const Bounds& t) const;
  [[nodiscard]] SheetStretch stretch2(int span, const Bounds& t) const;

  /// F [m].
  [[nodiscard]] double value(const SheetPlace& one, const SheetPlace& two) const;
  /// Derivatives of F by the parameters of the two places.
  [[nodiscard]] Vector2d slopes(const SheetPlace& one, const SheetPlace& two) const;
  /// Whether F - level may be 0 in a cell, and the signs of its slopes, from the values at its middle.
  /// Rounding is not included: a zero that only rounding would make is not reported.
  /// \pre 0 <= level < size()/100
  [[nodiscard]] SheetRange range(const SheetStretch& one, const SheetStretch& two, double level) const;
  /// Whether a zero is a tangency of these normals: between two slides F vanishes also where they are
  /// reversed.
  [[nodiscard]] bool faces(const SheetPlace& one, const SheetPlace& two) const;
  /// The tangency at a zero; angles in (-π, π], q of two turning bodies in (-2π, 2π]. \pre is_regular()
  [[nodiscard]] SheetPoint point(const SheetPlace& one, const SheetPlace& two) const;

private:
  BoundaryPair pair_;
  double side2_ = 1;
  double size_ = 0;
  Pose<double> X_W1_, X_W2_;  // at the coordinates 0
  Vector2d O12_;              // from O1 to O2
};

}  // namespace higherpair
