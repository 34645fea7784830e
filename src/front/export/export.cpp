#include "higherpair/front/export.hpp"

#include "front/demands.hpp"
#include "front/model_data.hpp"
#include "higherpair/cam/cutter_path.hpp"
#include "higherpair/geometry/support_chains.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/mechanism/boundaries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using FlankPath = ExportSettings::Path;

std::string length_text(const Model& model, double metres) {
  return with_unit(metres, dimension::kLength, model.units());
}

// The length rounded down to a few digits, so that it can be used as given.
std::string length_below(const Model& model, double metres) {
  const double value = from_si(dimension::kLength, model.units()).apply(metres);
  constexpr double kDigits = 4;
  const double unit = std::pow(10, std::floor(std::log10(value)) + 1 - kDigits);
  return fmt::format("{:.4g} {}", std::floor(value / unit) * unit, name_of(model.units().length));
}

std::string point_text(const Model& model, const Vector2d& p) {
  const Scaling scaling = from_si(dimension::kLength, model.units());
  return fmt::format("({:.6g}, {:.6g})", scaling.apply(p.x()), scaling.apply(p.y()));
}

struct NamedRef {
  std::string name;
  CurveRef ref;
};

// The curves of the profile, without the copies made for contacts.
std::vector<NamedRef> all_curves(const Model& model) {
  std::vector<NamedRef> curves;
  const auto& bodies = model.mechanism().bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t c = 0; c < bodies[b].curves.size(); ++c) {
      const NamedCurve& curve = bodies[b].curves[c];
      if (curve.copy_of < 0) {
        curves.push_back(
            {fmt::format("{}.{}", bodies[b].name, curve.name), {static_cast<int>(b), static_cast<int>(c)}});
      }
    }
  }
  return curves;
}

std::vector<std::string> names_of(const std::vector<NamedRef>& curves) {
  std::vector<std::string> names;
  for (const NamedRef& curve : curves) {
    names.push_back(curve.name);
  }
  return names;
}

// All curves of a body that can be exported; a knife edge only as the path of a cutter around it.
Result<std::vector<NamedRef>> curves_of_body(const Model& model, const std::string& name, FlankPath path) {
  std::vector<std::string> bodies;
  for (const Body& body : model.mechanism().bodies) {
    bodies.push_back(body.name);
  }
  const auto found = std::find(bodies.begin(), bodies.end(), name);
  if (found == bodies.end()) {
    return wrong(model, fmt::format("there is no body {}; {}", name, suggestion(name, bodies)));
  }
  std::vector<NamedRef> curves = all_curves(model);
  std::erase_if(curves, [&](const NamedRef& curve) {
    return curve.ref.body != found - bodies.begin() ||
           (path == FlankPath::kCurve && is_point(described_curve(model.mechanism(), curve.ref).curve));
  });
  if (curves.empty()) {
    return wrong(model, fmt::format("the body {} has no curves to draw", name));
  }
  return curves;
}

Result<std::vector<NamedRef>> wanted_curves(const Model& model, const ExportSettings& settings) {
  const std::vector<NamedRef> all = all_curves(model);
  std::vector<NamedRef> wanted;
  for (const std::string& name : settings.curves) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const NamedRef& curve) { return curve.name == name; });
    if (found == all.end()) {
      return wrong(model, fmt::format("there is no curve {}; {}", name, suggestion(name, names_of(all))));
    }
    wanted.push_back(*found);
  }
  if (!settings.body.empty()) {
    const auto more = curves_of_body(model, settings.body, settings.path);
    if (!more) {
      return tl::unexpected(more.error());
    }
    wanted.insert(wanted.end(), more->begin(), more->end());
  }
  if (wanted.empty() && all.size() == 1) {
    wanted = all;
  }
  if (wanted.empty()) {
    return wrong(model, all.empty() ? "there are no curves"
                                    : "name the curve to export: " + joined_words(names_of(all)));
  }
  return wanted;
}

Result<Boundary> boundary_of(const Model& model, const NamedRef& wanted, const ExportSettings& settings) {
  const NamedCurve& curve = described_curve(model.mechanism(), wanted.ref);
  if (curve.boundary) {
    return *curve.boundary;
  }
  if (is_point(curve.curve) && settings.path == FlankPath::kCurve) {
    return wrong(model, fmt::format("{} is a point, of which there is nothing to draw; the path of a cutter "
                                    "around it can be",
                                    wanted.name));
  }
  if (curve.curve.support != nullptr && support_chains(*curve.curve.support, 1).empty()) {
    return wrong(model, fmt::format("{} has cusps: it bounds no body", wanted.name));
  }
  const bool has_ends = is_point(curve.curve) || curve.curve.support != nullptr ||
                        curve.curve.kind == CurveKind::kCircle || curve.curve.kind == CurveKind::kEllipse;
  if (!has_ends && !settings.reach) {
    return wrong(model, fmt::format("{} has no ends: say with a reach how far from its {} it is to go",
                                    wanted.name, is_line(curve.curve) ? "point" : "vertex"));
  }
  return higherpair::boundary_of(curve.curve, settings.reach.value_or(1));
}

// Radii of the rollers and edges that touch a curve, by the names of their contacts.
std::vector<std::pair<std::string, double>> rollers_of(const Model& model, const CurveRef& curve) {
  std::vector<std::pair<std::string, double>> rollers;
  const auto is_it = [&](const CurveRef& ref) {
    const auto& curves = model.mechanism().bodies[curve.body].curves;
    return ref.body == curve.body && (is_or_has(curves, ref.curve, curve.curve) ||
                                      described_curve(model.mechanism(), ref).copy_of == curve.curve);
  };
  for (const Contact& contact : model.mechanism().contacts) {
    for (const auto& [own, other] :
         {std::pair(contact.first, contact.second), std::pair(contact.second, contact.first)}) {
      const Curve& roller = described_curve(model.mechanism(), other).curve;
      const bool round =
          is_point(roller) || (roller.kind == CurveKind::kCircle && roller.side == Side::kInside);
      if (is_it(own) && round) {
        rollers.emplace_back(contact.name, roller.semi_latus);
      }
    }
  }
  return rollers;
}

// Radius of the one roller that touches a curve.
Result<double> roller_of(const Model& model, const NamedRef& wanted) {
  const auto rollers = rollers_of(model, wanted.ref);
  if (rollers.empty()) {
    return wrong(model,
                 fmt::format("no circle or knife edge touches {}, whose path would be the pitch curve: "
                             "give the radius of a cutter instead",
                             wanted.name));
  }
  std::vector<std::string> texts;
  for (const auto& [contact, radius] : rollers) {
    texts.push_back(fmt::format("{}: {}", contact, length_text(model, radius)));
  }
  if (std::any_of(rollers.begin(), rollers.end(),
                  [&](const auto& roller) { return roller.second != rollers.front().second; })) {
    return wrong(model, fmt::format("rollers of different radii touch {} ({}): give the one that is meant as "
                                    "the radius of a cutter",
                                    wanted.name, joined_words(texts)));
  }
  return rollers.front().second;
}

std::string text_of(const Model& model, const std::string& name, double radius, const CutterFault& fault) {
  const std::string place = point_text(model, fault.at_B);
  std::string text =
      fmt::format("a cutter or roller of radius {} is too large for {}: ", length_text(model, radius), name);
  switch (fault.kind) {
    case CutterFault::Kind::kNotch:
      return fmt::format("{} has a hollow corner at {}, which no round cutter can cut: round it first", name,
                         place);
    case CutterFault::Kind::kHollow:
      text += fmt::format("at {} it is concave with a smaller radius", place);
      break;
    case CutterFault::Kind::kCrossing:
      text += fmt::format("its path crosses itself at {}, where it cuts into another part", place);
      break;
  }
  return fault.largest > 0
             ? fmt::format("{}; anything below {} can", text, length_below(model, fault.largest))
             : text;
}

Result<Boundary> path_of(const Model& model, const NamedRef& wanted, const ExportSettings& settings) {
  auto boundary = boundary_of(model, wanted, settings);
  if (!boundary || settings.path == FlankPath::kCurve) {
    return boundary;
  }
  const Result<double> radius =
      settings.path == FlankPath::kPitch ? roller_of(model, wanted) : Result<double>(settings.cutter);
  if (!radius) {
    return tl::unexpected(radius.error());
  }
  if (*radius == 0) {
    return boundary;  // of a knife edge
  }
  auto path = cutter_path(*boundary, *radius);
  if (!path) {
    return wrong(model, text_of(model, wanted.name, *radius, path.error()));
  }
  return *std::move(path);
}

std::string with_suffix(std::string name, FlankPath path) {
  return std::move(name) + (path == FlankPath::kPitch    ? "-pitch"
                            : path == FlankPath::kCutter ? "-cutter"
                                                         : "");
}

}  // namespace

Result<std::vector<ExportedCurve>> exported_curves(const Model& model, const ExportSettings& settings) {
  const double cutter = settings.path == FlankPath::kCutter ? settings.cutter : 1;
  if (std::string fault = first_unmet(
          {positive("setting cutter", cutter), positive("setting reach", settings.reach.value_or(1))});
      !fault.empty()) {
    return wrong(model, std::move(fault));
  }
  const auto wanted = wanted_curves(model, settings);
  if (!wanted) {
    return tl::unexpected(wanted.error());
  }
  std::vector<ExportedCurve> curves;
  for (const NamedRef& one : *wanted) {
    auto path = path_of(model, one, settings);
    if (!path) {
      return tl::unexpected(path.error());
    }
    curves.push_back({with_suffix(one.name, settings.path), *std::move(path)});
  }
  return curves;
}

}  // namespace higherpair
