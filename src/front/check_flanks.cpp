// The flanks of a mechanism that laws have shaped: where their laws have breaks, and how large they must be.
#include "check_parts.hpp"
#include "higherpair/cam/sizing.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

const NamedCurve& curve_named(const Mechanism& mechanism, const CurveRef& ref) {
  return mechanism.bodies[static_cast<std::size_t>(ref.body)].curves[static_cast<std::size_t>(ref.curve)];
}

// The only driver where it moves the cam of a flank, and the sign of its rate.
bool drives(const Mechanism& mechanism, int body) {
  if (mechanism.drivers.size() != 1) {
    return false;
  }
  const Joint& joint = driven_joint(mechanism);
  return (joint.first.body == 0 && joint.second.body == body) ||
         (joint.second.body == 0 && joint.first.body == body);
}

struct ShapedFlank {
  std::size_t contact = 0;
  CurveRef ref;
  FlankOrigin origin;
};

// Both curves of a contact; of several that it takes as one each.
std::vector<CurveRef> curves_of(const Mechanism& mechanism, const Contact& contact) {
  std::vector<CurveRef> curves;
  for (const CurveRef& ref : {contact.first, contact.second}) {
    const std::vector<int>& parts = curve_named(mechanism, ref).parts;
    if (parts.empty()) {
      curves.push_back(ref);
    }
    for (const int part : parts) {
      curves.push_back({ref.body, part});
    }
  }
  return curves;
}

// Each once, with the first contact that it takes part in.
std::vector<ShapedFlank> flanks_of(const Mechanism& mechanism) {
  std::vector<ShapedFlank> flanks;
  std::vector<const NamedCurve*> seen;
  for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
    for (const CurveRef& ref : curves_of(mechanism, mechanism.contacts[i])) {
      const NamedCurve* named = &named_curve(mechanism, ref);
      auto origin = flank_of(mechanism, ref);
      if (origin && std::find(seen.begin(), seen.end(), named) == seen.end()) {
        seen.push_back(named);
        flanks.push_back({i, ref, *std::move(origin)});
      }
    }
  }
  return flanks;
}

// Parameters of a straight path at which its driver comes to a coordinate of its joint, turns added.
void add_passages(const DriverPath& path, double coordinate, bool turns, std::vector<double>& breaks) {
  std::vector<DriverMotion> first, last;
  path.motion(path.knots.front(), first);
  path.motion(path.knots.back(), last);
  const double from = first.front().position, way = last.front().position - from;
  const double low = std::min(from, from + way), high = std::max(from, from + way);
  const double period = turns ? 2 * kPi : 1;
  double x = turns ? coordinate + std::ceil((low - coordinate) / period) * period : coordinate;
  for (; x <= high; x += period) {
    if (x >= low) {
      breaks.push_back(std::lerp(path.knots.front(), path.knots.back(), (x - from) / way));
    }
    if (!turns) {
      return;
    }
  }
}

}  // namespace

const NamedCurve& named_curve(const Mechanism& mechanism, const CurveRef& ref) {
  const NamedCurve& curve = curve_named(mechanism, ref);
  return curve.copy_of < 0 || !curve.parts.empty() ? curve
                                                   : curve_named(mechanism, {ref.body, curve.copy_of});
}

std::string name_of_curve(const Mechanism& mechanism, const CurveRef& ref) {
  const std::string& body = mechanism.bodies[static_cast<std::size_t>(ref.body)].name;
  const NamedCurve& curve = named_curve(mechanism, ref);
  return curve.parts.empty() ? fmt::format("{}.{}", body, curve.name) : body;
}

std::optional<FlankOrigin> flank_of(const Mechanism& mechanism, const CurveRef& ref) {
  const auto& boundary = named_curve(mechanism, ref).boundary;
  return boundary && named_curve(mechanism, ref).parts.empty() ? flank_origin(*boundary->spans().front())
                                                               : std::nullopt;
}

PathLook look_at(const CheckedPath& checked, const DriverPath& path) {
  const Mechanism& mechanism = checked.start.mechanism();
  PathLook look;
  const bool straight =
      !checked.schedule.is_timed() && !checked.schedule.is_listed() && path.knots.size() == 2;
  for (const ShapedFlank& flank : flanks_of(mechanism)) {
    const MotionLaw& law = flank.origin.motion.law;
    look.parts = std::max(look.parts, static_cast<double>(law.breaks(law.begin(), law.end()).size()));
    if (straight && drives(mechanism, flank.ref.body)) {
      for (const LawJoin& join : law.joins()) {
        add_passages(path, join.x, flank.origin.motion.cam.turns, look.breaks);
      }
    }
  }
  std::sort(look.breaks.begin(), look.breaks.end());
  const double same = path.knots.empty() ? 0 : kSameBreak * (path.knots.back() - path.knots.front());
  look.breaks.erase(
      std::unique(look.breaks.begin(), look.breaks.end(), [&](double a, double b) { return b - a <= same; }),
      look.breaks.end());
  for (const Body& body : mechanism.bodies) {
    for (const NamedCurve& curve : body.curves) {
      double parts = 0;
      for (std::size_t i = 0; curve.boundary && i < curve.boundary->spans().size(); ++i) {
        parts += curve.boundary->spans()[i]->parts();
      }
      look.parts = std::max(look.parts, parts);
    }
  }
  return look;
}

namespace {

class SizeReader {
public:
  SizeReader(const Profile& profile, const ShapedFlank& flank, CheckFigures& figures)
      : profile_(profile), flank_(flank), cam_(flank.origin), figures_(figures) {
    driven_ = drives(profile.mechanism, flank.ref.body);
    const bool backwards = driven_ && profile.programs.front().velocity < 0;
    sense_ = backwards ? -1 : 1;
  }

  void read() {
    const auto size = size_of(cam_);
    figures_.about(name_of_curve(profile_.mechanism, flank_.ref));
    if (!size) {
      return;
    }
    if (!is_line(cam_.curve)) {
      figures_.add("prime_circle", dimension::kLength, size->radius, std::nullopt);
    }
    figures_.add("base_circle", dimension::kLength, size->base_radius, std::nullopt);
    read_pressure();
    read_radius();
  }

private:
  [[nodiscard]] const GivenLimit* limit(LimitKey key) const {
    return figures_.of_contact(flank_.contact, key);
  }

  // Of the cam's joint; the driver's where that is the same.
  [[nodiscard]] std::optional<double> place(double at) const {
    return driven_ ? std::optional(at) : std::nullopt;
  }

  [[nodiscard]] std::string rest_text(double rest) const {
    const Dimension of = coordinate_dimension(cam_.motion.follower.turns);
    return fmt::format(
        "the follower's pose {} by {:.10g} {}", cam_.motion.follower.turns ? "turned" : "moved",
        from_si(of, profile_.units).apply(rest - cam_.motion.follower_rest), unit_text(of, profile_.units));
  }

  void add_size(const std::string& quantity, const std::optional<CamSize>& size) {
    if (size && size->radius > kNoFlankSize * size_of(cam_)->radius) {
      const bool flat = is_line(cam_.curve);
      figures_.add(quantity, dimension::kLength, flat ? size->base_radius : size->radius, place(size->at),
                   rest_text(size->rest));
    }
  }

  void read_pressure() {
    const GivenLimit* most = limit(LimitKey::kMaxPressureAngle);
    if (most == nullptr || is_line(cam_.curve)) {
      return;
    }
    const GivenLimit* back = limit(LimitKey::kMaxReturnPressureAngle);
    const PressureLimits limits{most->value, (back != nullptr ? back : most)->value, sense_};
    const auto here = smallest_for_pressure(cam_, limits);
    add_size("prime_circle_for_pressure_angle", here);
    const auto size = smallest_with_offset(cam_, limits);
    if (size && !(here && here->radius <= size->radius * (1 + kNoFlankSize))) {
      figures_.add("prime_circle_with_offset", dimension::kLength, size->radius, std::nullopt,
                   fmt::format("with the guide {:.10g} {} to the side of the cam's pivot",
                               from_si(dimension::kLength, profile_.units).apply(size->offset),
                               unit_text(dimension::kLength, profile_.units)));
    }
  }

  void read_radius() {
    const GivenLimit* convex = limit(LimitKey::kMinConvexRadius);
    const GivenLimit* concave = limit(LimitKey::kMinConcaveRadius);
    const RadiusLimits limits{convex != nullptr ? convex->value : 0, concave != nullptr ? concave->value : 0};
    const bool limited = convex != nullptr || concave != nullptr;
    const std::string why = limited ? "for_radius" : "without_undercut";
    add_size((is_line(cam_.curve) ? "base_circle_" : "prime_circle_") + why,
             smallest_for_radius(cam_, limits));
    const bool roller = !is_line(cam_.curve) && !is_point(cam_.curve) && cam_.curve.side == Side::kInside;
    const auto largest = roller ? largest_follower(cam_, limits.convex) : std::nullopt;
    if (largest && largest->value > 0) {
      figures_.add("roller_" + why, dimension::kLength, largest->value, place(largest->at));
    }
  }

  const Profile& profile_;
  const ShapedFlank& flank_;
  const FlankOrigin& cam_;
  CheckFigures& figures_;
  bool driven_ = false;
  double sense_ = 1;
};

}  // namespace

void add_size_figures(const Profile& profile, CheckFigures& figures) {
  for (const ShapedFlank& flank : flanks_of(profile.mechanism)) {
    SizeReader(profile, flank, figures).read();
  }
}

}  // namespace higherpair
