#pragma once

#include "sketch.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair::fire {

/// The groups that a random mechanism consists of.
enum class SketchKind {
  kDyad,     ///< dyads of all kinds, each on the ones before
  kTriad,    ///< ternary bodies on three legs, and closed rings of four links
  kChain,    ///< followers on a pivot or slide that touch an earlier body, with convex faces
  kRing,     ///< the same with concave faces: contacts may conform, and second contacts appear
  kCoupled,  ///< single bodies held by contacts and slots
  kClosed,   ///< several joined bodies held so
  kGeared,   ///< wheels, belts and planets with dyads on them
  kTwo,      ///< two drivers, groups of all kinds
  kCam,      ///< a follower on a cam of straight and round parts or a spline, convex or not, and dyads
  kStep,     ///< groups of all kinds; the driver is accelerated so that it turns back
  kLaw,      ///< a cam whose flank comes from a motion law
  kTeeth,    ///< two flanks of spur gears
  kFace,     ///< an open face on an ellipse
  kOffset,   ///< a roller on the offset of a cam of straight and round parts
  kEnds,     ///< dyads and followers on slides and slots whose lines end
  kTimes,    ///< two drivers in time whose accelerations differ, groups of all kinds
};

[[nodiscard]] std::vector<SketchKind> all_kinds();
[[nodiscard]] std::string_view name_of(SketchKind kind);
[[nodiscard]] std::optional<SketchKind> kind_named(std::string_view name);

/// A random mechanism. It is constructed backwards from a solution: bodies are placed first and then joined
/// where they are. Seed, kind and number give the same mechanism on every machine. Some cannot be started,
/// because their constraints are not independent.
[[nodiscard]] Sketch random_sketch(SketchKind kind, std::uint64_t seed, std::uint64_t number);

}  // namespace higherpair::fire
