#pragma once

#include "sketch.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::fire {

/// What the groups of a random mechanism are.
enum class SketchKind {
  kDyad,     ///< dyads of all kinds, one on the other
  kTriad,    ///< ternary bodies on three legs, and closed rings of four links
  kChain,    ///< followers on a pivot or slide that touch the body before, with convex faces
  kRing,     ///< the same with faces that are concave: contacts may conform and others appear
  kCoupled,  ///< one body that contacts and slots hold together
  kClosed,   ///< several of them
  kGeared,   ///< wheels, belts and planets with dyads on them
  kTwo,      ///< two drivers, groups of all kinds
  kCam,      ///< a follower on a cam of straight and round parts or a spline, convex or not, and dyads
  kStep,     ///< groups of all kinds, the driver accelerated so that it turns back
  kLaw,      ///< a cam whose flank comes from a motion law
  kTeeth,    ///< two flanks of spur gears
  kFace,     ///< an open face on an ellipse
  kOffset,   ///< a roller on the offset of a cam of straight and round parts
};

[[nodiscard]] std::vector<SketchKind> all_kinds();
[[nodiscard]] std::string_view name_of(SketchKind kind);
[[nodiscard]] std::optional<SketchKind> kind_named(std::string_view name);

/// A random mechanism, drawn from the answer: bodies are placed first, then joined where they are. The same
/// for a seed, kind and number on every machine. Some cannot be started: their conditions are not
/// independent.
[[nodiscard]] Sketch random_sketch(SketchKind kind, std::uint64_t seed, std::uint64_t number);

}  // namespace higherpair::fire
