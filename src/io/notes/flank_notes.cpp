#include "flank_notes.hpp"

#include "higherpair/cam/flank.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/tasks.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "io/document/document.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// The text at a path of the document.
std::optional<std::string> text_at(const Table& document, const std::string& path) {
  const Value* value = end_of_path(document, path).value;
  const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(&value->content);
  return text == nullptr ? std::nullopt : std::optional(*text);
}

std::string point_path(const Mechanism& mechanism, const PointRef& ref) {
  const Body& body = mechanism.bodies[ref.body];
  return fmt::format("bodies.{}.points.{}", body.name, body.points[ref.point].name);
}

// The paths of what a flank is cut for, except its law: the curve of the other body, and how both bodies are
// posed and joined to ground.
std::vector<std::string> cut_for(const Mechanism& mechanism, int cam, const CurveRef& follower) {
  std::vector<std::string> paths = {fmt::format("bodies.{}.curves.{}", mechanism.bodies[follower.body].name,
                                                described_curve(mechanism, follower).name)};
  for (const int body : {cam, follower.body}) {
    paths.push_back(fmt::format("bodies.{}.pose", mechanism.bodies[body].name));
    for (const Joint& joint : mechanism.joints) {
      if (joins(joint, kGround, body)) {
        paths.insert(paths.end(), {point_path(mechanism, joint.first), point_path(mechanism, joint.second),
                                   "joints." + joint.name});
      }
    }
  }
  return paths;
}

// Whether a run over these coordinates of the cam's joint is beyond an end of its flank, which goes over
// `flank` of them, or over these and any number of turns.
bool is_beyond(const Bounds& run, const Bounds& flank, bool turns) {
  const double shift = turns ? 2 * kPi * std::ceil((run.low - flank.high) / (2 * kPi)) : 0;
  return run.high <= flank.low + shift || run.low >= flank.high + shift;
}

bool is_at_or_below(std::string_view path, std::string_view above) {
  return path.starts_with(above) && (path.size() == above.size() || path[above.size()] == '.');
}

}  // namespace

std::vector<FlankNote> flank_notes(const Table& document, const Profile& profile) {
  std::vector<FlankNote> notes;
  if (!profile.tolerances) {
    return notes;
  }
  const Mechanism& mechanism = profile.mechanism;
  const auto look_at = [&](int cam, const NamedCurve& flank, const CurveRef& follower) {
    const std::vector<std::string> shaping = cut_for(mechanism, cam, follower);
    for (const Tolerance& tolerance : profile.tolerances->tolerances) {
      const auto path = std::find_if(tolerance.paths.begin(), tolerance.paths.end(), [&](const auto& one) {
        return std::any_of(shaping.begin(), shaping.end(),
                           [&](const std::string& above) { return is_at_or_below(one, above); });
      });
      if (path == tolerance.paths.end()) continue;
      const std::string curve = mechanism.bodies[cam].name + "." + flank.name;
      notes.push_back(
          {tolerance.name,
           fmt::format(
               "the flank {} is cut anew for every value of {}, so that the other body moves by the law "
               "all the same; to see what a deviation does to a flank that is cut once, `export` {} and "
               "read the file as its curve",
               curve, *path, curve)});
    }
  };
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const int cam = static_cast<int>(b);
    const Body& body = mechanism.bodies[b];
    for (std::size_t k = 0; k < body.curves.size(); ++k) {
      const std::string path = fmt::format("bodies.{}.curves.{}", body.name, body.curves[k].name);
      if (text_at(document, path + ".type") != "cam") continue;
      const auto name = text_at(document, path + ".contact");
      for (const Contact& contact : mechanism.contacts) {
        if (contact.name != name) continue;
        look_at(cam, body.curves[k], end_off(contact, cam));
      }
    }
  }
  return notes;
}

std::string unreached_flank_note(const Profile& profile, std::size_t driver) {
  const Mechanism& mechanism = profile.mechanism;
  const DriverProgram& program = profile.programs[driver];
  const Joint& joint = driven_joint(mechanism, driver);
  if (!program.end || !program.positions.empty() || program.law) {
    return "";
  }
  const Dimension of = coordinate_dimension(joint);
  const Scaling scaling = to_si(of, profile.units);
  const double start = scaling.apply(program.start), end = scaling.apply(*program.end);
  const Bounds run{std::min(start, end), std::max(start, end)};
  for (const int b : {joint.first.body, joint.second.body}) {
    const Body& body = mechanism.bodies[b];
    for (const NamedCurve& curve : body.curves) {
      const bool open = b != 0 && curve.boundary && !curve.boundary->is_closed();
      const auto origin = open ? flank_origin(*curve.boundary->spans().front()) : std::nullopt;
      const MotionLaw* law = origin ? &origin->motion.law : nullptr;
      if (law == nullptr || !is_beyond(run, {law->begin(), law->end()}, origin->motion.cam.turns)) {
        continue;
      }
      return fmt::format(
          "from {} to {} the other body never comes to the flank {}.{}, which goes from {} to {}: it stays "
          "on the edge at its end, or leaves it",
          with_unit(start, of, profile.units), with_unit(end, of, profile.units), body.name, curve.name,
          with_unit(law->begin(), of, profile.units), with_unit(law->end(), of, profile.units));
    }
  }
  return "";
}

}  // namespace higherpair::io_detail
