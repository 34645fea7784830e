#pragma once

#include "higherpair/geometry/pose.hpp"
#include "higherpair/linkage/four_bar.hpp"
#include "higherpair/linkage/slider_crank_stroke.hpp"
#include "higherpair/mechanism/description.hpp"

#include <vector>

namespace higherpair {

/// Four bodies in a loop of four pins, anywhere in a mechanism, as a four-bar: its frame is the body closest
/// to ground, its link 2 that one of the frame's two neighbours which is closer to ground, a driven joint
/// counting half. Of bodies equally close to ground it is the one closer to a driven joint, then the shorter.
struct FourBarInMechanism {
  int ground = 0;  ///< the frame of the loop; it moves if it is not body 0
  int crank = 0;
  int coupler = 0;
  int rocker = 0;
  FourBar linkage;  ///< lengths; theta1 = 0
};

/// Which link of a slider-crank is at rest.
enum class SliderCrankInversion {
  kGuide,    ///< the guide of the slider: crank and slider
  kCrank,    ///< the link with two pins next to the guide: a turning guide (Whitworth)
  kCoupler,  ///< the link with two pins next to the slider: a rocking guide (oscillating cylinder)
  kMoving,   ///< none of them is ground
};

/// Three pins and a slide, or two pins and a slot, in a loop.
struct SliderCrankInMechanism {
  int guide = 0;    ///< the body that carries the line
  int crank = 0;    ///< pinned to the guide
  int coupler = 0;  ///< pinned to the crank, and to the slider (or itself in the slot)
  int slider = -1;  ///< -1: a slot
  int joint = 0;    ///< the slide or slot
  SliderCrankInversion inversion = SliderCrankInversion::kGuide;
  SliderCrank linkage;  ///< theta1 = 0: along the joint's line
  double at_foot = 0;   ///< the joint's coordinate where the slider's pin is level with the crank's [m]
  Vector2d along_G = Vector2d::UnitX();    ///< that direction in the frame of the guide
  Vector2d coupler_AC = Vector2d::Zero();  ///< from the crank to the slider, in the coupler's frame [m]
};

/// The assembly mode of a slider-crank at a position, driven by its crank.
/// \param bodies  of the mechanism
[[nodiscard]] AssemblyMode mode_of(const SliderCrankInMechanism& loop, const std::vector<BodyMotion>& bodies);

/// All loops of four bodies and four pins, without links of zero length, in the order of their bodies.
[[nodiscard]] std::vector<FourBarInMechanism> find_four_bars(const Mechanism& mechanism);

/// All slider-cranks, in the order of their slides. Of the two bodies of a slide the one closer to ground is
/// the guide.
[[nodiscard]] std::vector<SliderCrankInMechanism> find_slider_cranks(const Mechanism& mechanism);

}  // namespace higherpair
