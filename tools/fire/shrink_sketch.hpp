#pragma once

#include "sketch.hpp"

#include <functional>

namespace higherpair::fire {

/// A smaller mechanism that still fails: without bodies that are not needed, and with rounder numbers.
[[nodiscard]] Sketch shrink(Sketch sketch, const std::function<bool(const Sketch&)>& fails);

}  // namespace higherpair::fire
