#pragma once

#include "higherpair/mechanism/description.hpp"

#include <cstddef>
#include <string>

namespace higherpair::io_detail {

// Notes on joints and contacts that are given twice: the motion is the same without one of them, but how they
// share their reaction is undefined. Each names an earlier one that gives the same condition; empty if there
// is none.
// \param size  of the mechanism, size_of() [m]

[[nodiscard]] std::string repeated_joint_note(const Mechanism& mechanism, double size, std::size_t joint);
[[nodiscard]] std::string repeated_contact_note(const Mechanism& mechanism, std::size_t contact);

}  // namespace higherpair::io_detail
