#pragma once

#include "chain_rows.hpp"
#include "numeric/arctangent.hpp"
#include "numeric/pack.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

// Angles of the bodies of a chain; their rotations give them only up to whole turns.

namespace higherpair::chain_loop {

// The angle of a turning body, in (-π, π].
template <class T>
[[nodiscard]] inline T raw_angle(const ChainTurning& turning, const ChainBody<T>* bodies) {
  const Rotation<T>& R = bodies[turning.body].R_WB;
  return arctangent(R.sin, R.cos);
}

// A body's angle; that of a turning body only up to whole turns, see unwind().
template <class T>
[[nodiscard]] inline T angle_of_rows(const ChainAngle& angle, std::span<const ChainTurning> turnings,
                                     const T& position, const ChainBody<T>* bodies) {
  if (angle.turning >= 0) {
    return raw_angle(turnings[angle.turning], bodies);
  }
  return T(angle.factor) * position + T(angle.offset);
}

// Adds whole turns to angles in (-π, π], given that the body turns by less than half a turn from row to row.
class Winding {
public:
  /// \param first  the angle of the first row
  void begin(double first, ChainTurning& turning) {
    last_ = first;
    turning.first_angle = nearest_turn(first, turning.posed_angle);
    turns_ = turning.first_angle - first;
  }

  /// Unwinds the next kChainRows rows.
  template <class T, std::size_t kPacks>
  void unwind(std::array<T, kPacks>& angles) {
    // All rows within a quarter turn of the one before them are within half a turn of each other.
    auto close = abs(angles[0] - T(last_)) <= T(kPi / 2);
    for (std::size_t i = 1; i < kPacks; ++i) {
      close = close & (abs(angles[i] - T(last_)) <= T(kPi / 2));
    }
    if (!holds_everywhere(close)) {
      unwind_one_by_one(angles);
      return;
    }
    last_ = last_lane(angles[kPacks - 1]);
    for (T& angle : angles) {
      angle = angle + T(turns_);
    }
  }

private:
  template <class T, std::size_t kPacks>
  void unwind_one_by_one(std::array<T, kPacks>& angles) {
    for (T& angle : angles) {
      std::array<double, T::kLanes> rows;
      angle.store(rows.data());
      for (double& row : rows) {
        const double rise = row - last_;
        if (std::abs(rise) > kPi) {
          turns_ -= std::copysign(2 * kPi, rise);
        }
        last_ = row;
        row += turns_;
      }
      angle = T::load(rows.data());
    }
  }

  double last_;   // angle of the row before, in (-π, π]
  double turns_;  // to be added to last_ [rad]
};

// Unwinds the angles of a column and adds its offset.
template <class T>
inline void unwind(ChainTask& task, ChainTurning& turning) {
  std::array<T, kChainRows / T::kLanes> angles;
  Winding winding;
  winding.begin(task.values[0], turning);
  for (std::size_t k = 0; k < task.values.size(); k += kChainRows) {
    double* rows = &task.values[k];
    for (std::size_t i = 0; i < angles.size(); ++i) {
      angles[i] = T::load(rows + i * T::kLanes);
    }
    winding.unwind(angles);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      (angles[i] + T(task.angle.offset)).store(rows + i * T::kLanes);
    }
  }
}

// Unwound angles of the turning bodies that torsion springs act on, for kPacks packs of rows.
template <class T, std::size_t kPacks>
inline void turn_springs(std::span<ChainTurning> turnings, const ChainBody<T>* bodies, std::size_t stride,
                         bool begins, Winding* windings, T* angles) {
  for (std::size_t t = 0; t < turnings.size(); ++t) {
    if (!turnings[t].sprung) {
      continue;
    }
    std::array<T, kPacks> turned;
    for (std::size_t i = 0; i < kPacks; ++i) {
      turned[i] = raw_angle(turnings[t], bodies + i * stride);
    }
    if (begins) {
      windings[t].begin(first_lane(turned[0]), turnings[t]);
    }
    windings[t].unwind(turned);
    for (std::size_t i = 0; i < kPacks; ++i) {
      angles[i * turnings.size() + t] = turned[i];
    }
  }
}

}  // namespace higherpair::chain_loop
