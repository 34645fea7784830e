#pragma once

#include "higherpair/linkage/rrr_dyad.hpp"

#include <optional>

namespace higherpair {

/// Motion of a dyad between two moving points.
struct RrrMotion {
  struct Rates {
    double omega_a = 0;  ///< [rad/s]
    double omega_b = 0;
    double alpha_a = 0;  ///< [rad/s²]
    double alpha_b = 0;
    Vector2d v_WC = Vector2d::Zero();  ///< of the joint C [m/s]
    Vector2d a_WC = Vector2d::Zero();  ///< [m/s²]
  };
  LinkageStatus status = LinkageStatus::kNotAssemblable;
  Reach<double> reach;               ///< [m²]; holds with every status
  Rotation<double> u_a;              ///< unit direction from A to C
  Rotation<double> u_b;              ///< unit direction from B to C
  Vector2d p_WC = Vector2d::Zero();  ///< the joint [m]
  std::optional<Rates> rates;        ///< with kOk only
};

/// Links of lengths a (from A) and b (from B) [m] that meet at C. kSingular: their directions are parallel to
/// within rounding, or A and B coincide (then one of infinitely many positions is returned). Near a change
/// point this is less precise than `four_bar.hpp`, because only |AB| is compared with a ± b.
/// \pre a > 0, b > 0.
[[nodiscard]] RrrMotion rrr_dyad(const PointMotion& A, const PointMotion& B, double a, double b,
                                 AssemblyMode mode);

}  // namespace higherpair
