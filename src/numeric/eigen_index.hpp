#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace higherpair {

/// An index as Eigen's index type.
[[nodiscard]] inline Eigen::Index eigen_index(std::size_t i) {
  return static_cast<Eigen::Index>(i);
}

}  // namespace higherpair
