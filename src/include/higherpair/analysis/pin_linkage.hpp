#pragma once

#include "higherpair/mechanism/plan.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// The positions of a linkage with pins only (bodies driven about pins, and dyads of two links), for many
/// sets of dimensions: in closed form, without tables, angles or allocation; and the exact derivatives of the
/// positions with respect to any parameter of the dimensions. What happens between two positions remains
/// unknown; the poses are those of a branch (branch_run.hpp).
///
/// For a dyad A, C, B with r_a = C - A, r_b = C - B, and h the rate at which the ends at C would separate if
/// both links kept their angles, h = ∂C along b - ∂C along a:
///     ∂θ_a r_a^⊥ - ∂θ_b r_b^⊥ = h,   ∂θ_a = h·r_b/(r_a × r_b),   ∂θ_b = h·r_a/(r_a × r_b).
class PinLinkage {
public:
  /// None where the plan has other groups, or surplus conditions.
  [[nodiscard]] static std::optional<PinLinkage> of(const Mechanism& mechanism, const Plan& plan);

  /// \param numbers  all numbers of the mechanism, in the order of for_each_number (numbers.hpp)
  void set_numbers(std::span<const double> numbers);
  /// The branch on which bodies are placed; 0 at first. From then on bodies have the poses that they were
  /// given.
  void set_branch(int branch);

  /// Places all bodies. False where a dyad does not reach; it and the bodies after it keep their last poses.
  /// \param drivers  cosine and sine of the angle of each driver
  bool place(std::span<const Rotation<double>> drivers);

  [[nodiscard]] const Pose<double>& pose(int body) const { return poses_[body]; }
  /// Position of a point in ground [m].
  [[nodiscard]] Vector2d place_of(const PointRef& point) const { return in_ground(end_of(point)); }

  [[nodiscard]] std::size_t dyads() const { return dyads_.size(); }
  /// Number of dyads, in the order of solution, whose gap is known: up to the first that does not reach.
  [[nodiscard]] std::size_t known_gaps() const { return known_; }
  /// closure_gap of a dyad [m]. \pre dyad < known_gaps()
  [[nodiscard]] double gap(std::size_t dyad) const { return dyads_[dyad].gap; }
  /// The dyad whose two links this joint connects.
  [[nodiscard]] std::optional<std::size_t> dyad_at(int joint) const;
  /// transmission_sine of a dyad that has been placed.
  [[nodiscard]] double transmission(std::size_t dyad) const;

  /// \name Derivatives with respect to a parameter, at the last place()
  /// @{
  /// \param slopes  derivative of every number
  void differentiate(std::span<const double> slopes);
  /// Derivative of place_of(point).
  [[nodiscard]] Vector2d place_slope(const PointRef& point) const { return slope_of(end_of(point)); }
  [[nodiscard]] double gap_slope(std::size_t dyad) const;
  [[nodiscard]] double transmission_slope(std::size_t dyad) const;
  /// @}

private:
  // A point of a body; `number` is the index of its x among the numbers, y follows.
  struct End {
    int body = 0;
    std::size_t number = 0;
  };
  struct Driven {
    int body = 0;
    int driver = 0;
    double sense = 1;  // -1: the joint names the known body second
    End known, own;
  };
  struct Dyad {
    int link_a = 0, link_b = 0;
    int pin_C = -1;  // the joint of the two links
    End A, a_A, a_C, b_C, b_B, B;
    Vector2d along_a = Vector2d::Zero(), along_b = along_a;  // from A (B) to C, in the link
    double a = 0, b = 0;                                     // their lengths
    double sigma = 1;                                        // assembly mode
    double gap = 0;
    Vector2d A_W = along_a, B_W = along_a, C_W = along_a;
  };
  struct Step {
    bool is_dyad = false;
    std::size_t index = 0;
  };
  struct PoseSlope {
    Vector2d p_W = Vector2d::Zero();
    double theta = 0;
  };

  PinLinkage() = default;
  [[nodiscard]] bool add(const Mechanism& mechanism, const Group& group);
  [[nodiscard]] bool add_dyad(const Mechanism& mechanism, const Group& group, const RrrDyad& dyad);
  void place(const Driven& driven, std::span<const Rotation<double>> drivers);
  [[nodiscard]] bool place(Dyad& dyad);
  void differentiate(const Driven& driven);
  void differentiate(const Dyad& dyad);

  [[nodiscard]] End end_of(const PointRef& point) const {
    return {point.body, point_numbers_[point.body] + 2 * static_cast<std::size_t>(point.point)};
  }
  [[nodiscard]] Vector2d in_body(const End& end) const {
    return {numbers_[end.number], numbers_[end.number + 1]};
  }
  [[nodiscard]] Vector2d in_ground(const End& end) const { return pose(end.body) * in_body(end); }
  [[nodiscard]] Vector2d slope_in_body(const End& end) const {
    return {slopes_[end.number], slopes_[end.number + 1]};
  }
  [[nodiscard]] Vector2d slope_of(const End& end) const;
  // Derivative of a link's point relative to another one that is known, without the rotation of the link.
  [[nodiscard]] Vector2d fixed_slope(int link, const End& from, const End& to) const;

  std::vector<std::size_t> point_numbers_;  // for each body: index of x of its first point
  std::vector<Step> steps_;
  std::vector<Driven> driven_;
  std::vector<Dyad> dyads_;
  std::vector<double> numbers_;
  std::vector<Pose<double>> posed_, poses_;
  std::size_t known_ = 0, placed_ = 0;  // numbers of known gaps and of placed steps
  std::vector<double> slopes_;
  std::vector<PoseSlope> pose_slopes_;
};

}  // namespace higherpair
