// Checks a mechanism that was built in C++ for what the reader of profiles ensures.
#include "demands.hpp"
#include "higherpair/cam/motion_law.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/support_chains.hpp"
#include "higherpair/io/names.hpp"
#include "higherpair/mechanism/boundaries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/pins.hpp"
#include "higherpair/mechanism/tolerances.hpp"
#include "higherpair/numeric/contains.hpp"
#include "model_data.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/core.h>

namespace higherpair {
namespace {

std::string fault(const std::string& where, const std::string& rule) {
  return where + ": " + rule;
}

template <class Items>
std::string no_such(const std::string& where, int index, const Items& items, std::string_view what) {
  const bool there = index >= 0 && index < static_cast<int>(items.size());
  return there ? ""
               : fault(fmt::format("{} = {}", where, index),
                       fmt::format("there are {} {}", items.size(), what));
}

// Finds the first error, item by item.
class Checker {
public:
  explicit Checker(const Mechanism& mechanism) : m_(mechanism) {}

  std::string run() {
    if (m_.bodies.empty()) {
      return fault("bodies", "there are none: bodies[0] is ground");
    }
    each("bodies", m_.bodies, [&](const std::string& at, const Body& body) { check(at, body); });
    each("joints", m_.joints, [&](const std::string& at, const Joint& joint) { check(at, joint); });
    check_carriers();
    each("contacts", m_.contacts, [&](const std::string& at, const Contact& contact) { check(at, contact); });
    each("drivers", m_.drivers, [&](const std::string& at, const Driver& driver) { check(at, driver); });
    each("loads", m_.loads, [&](const std::string& at, const Load& load) { check(at, load); });
    each("springs", m_.springs, [&](const std::string& at, const Spring& spring) { check(at, spring); });
    each("laws", m_.laws, [&](const std::string& at, const NamedLaw& law) { check(at, law.law); });
    expect(fits(m_.gravity_W), "gravity", kFitRule);
    return found_;
  }

private:
  template <class Items, class Check>
  void each(std::string_view room, const Items& items, const Check& check_one) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < items.size() && found_.empty(); ++i) {
      const std::string& name = items[i].name;
      const std::string at = name.empty() ? fmt::format("{}[{}]", room, i)
                                          : fmt::format("{}.{}", room, io_detail::visible(name));
      expect(name.empty() || names.insert(name).second, at, "another one has the same name");
      check_one(at, items[i]);
    }
  }

  void expect(bool holds, const std::string& where, const std::string& rule) {
    if (!holds && found_.empty()) {
      found_ = fault(where, rule);
    }
  }

  // Names are parts of those of columns, so the rule of profiles is theirs, too.
  void expect_name(const std::string& name, const std::string& where) {
    expect(!name.empty(), where, "needs a name");
    expect(io_detail::is_name(name), where, std::string(io_detail::kNameRule));
  }

  bool exists(const std::string& where, int body) {
    found_ = found_.empty() ? no_such(where, body, m_.bodies, "bodies") : found_;
    return found_.empty();
  }

  bool exists(const std::string& where, const PointRef& ref) {
    if (exists(where + ".body", ref.body)) {
      found_ = no_such(where + ".point", ref.point, m_.bodies[ref.body].points, "points on this body");
    }
    return found_.empty();
  }

  bool exists(const std::string& where, const CurveRef& ref) {
    if (exists(where + ".body", ref.body)) {
      found_ = no_such(where + ".curve", ref.curve, m_.bodies[ref.body].curves, "curves on this body");
    }
    return found_.empty();
  }

  void check(const std::string& at, const Body& body) {
    expect_name(body.name, at);
    expect(fits(body.guess_p_WB), at + ".pose", kFitRule);
    expect(is_sharp_angle(body.guess_theta), at + ".pose", "its angle must be at most 1e9 turns");
    each(at + ".points", body.points, [&](const std::string& where, const NamedPoint& point) {
      expect_name(point.name, where);
      expect(fits(point.p_B), where, kFitRule);
    });
    each(at + ".curves", body.curves,
         [&](const std::string& where, const NamedCurve& curve) { check(where, curve, body); });
    const bool rests = body.guess_p_WB.isZero(0) && body.guess_theta == 0 && !body.mass;
    expect(&body != &m_.bodies.front() || rests, at, "ground never moves: it has no pose and no mass");
    if (body.mass) {
      expect(fits(body.mass->mass) && fits(body.mass->inertia) && fits(body.mass->center_of_mass_B),
             at + ".mass", kFitRule);
      expect(body.mass->mass >= 0 && body.mass->inertia >= 0, at + ".mass", "mass and inertia must be >= 0");
    }
  }

  void check(const std::string& at, const NamedCurve& named, const Body& body) {
    const Curve& curve = named.curve;
    if (named.parts.empty()) expect_name(named.name, at);
    expect(fits(curve.vertex_B) && fits(curve.semi_latus) && std::isfinite(curve.q) &&
               std::isfinite(curve.slope),
           at, kFitRule);
    expect(std::abs(curve.axis_B.norm() - 1) <= kUnitDirection, at + ".axis_B", "must be a unit vector");
    expect(curve.kind >= CurveKind::kCircle && curve.kind <= CurveKind::kChain, at + ".kind",
           "is no kind of curve");
    expect(named.parts.empty() || curve.kind == CurveKind::kChain, at, "has parts and must be a chain");
    switch (curve.kind) {
      case CurveKind::kChain:
        expect(named.boundary || !named.parts.empty(), at, "is a chain and needs a boundary");
        break;
      case CurveKind::kSupport:
        expect(curve.support != nullptr && curve.piece < curve.support->pieces().size(), at,
               "is given by its support and needs one that has its piece");
        for (std::size_t k = 0; found_.empty() && !named.boundary && k < curve.support->pieces().size();
             ++k) {
          check_support(at, *curve.support, k);
        }
        break;
      case CurveKind::kLine:
      case CurveKind::kPoint:
        break;
      default:
        expect(curve.semi_latus > 0, at + ".semi_latus", "must be > 0");
    }
    check_references(at, named, body.curves);
    for (std::size_t k = 0; named.boundary && found_.empty() && k < named.boundary->spans().size(); ++k) {
      const std::string rule = fault_of(*named.boundary->spans()[k]);
      expect(rule.empty(), fmt::format("{}, span {}", at, k), rule);
    }
  }

  // Values that are no numbers, or bounds that do not hold, would keep every search from ending.
  void check_support(const std::string& at, const SupportCurve& support, std::size_t k) {
    const SupportPiece& piece = support.pieces()[k];
    const Bounds phi = piece.kind == PieceKind::kClosed ? Bounds{-kPi, kPi} : piece.phi;
    const Bounds radius = support.radius(k, phi);
    for (int i = 0; i <= kSupportSamples && found_.empty(); ++i) {
      const double at_phi = phi.low + i * phi.width() / kSupportSamples;
      const SupportValue value = support.at(k, at_phi);
      const bool finite = std::isfinite(value.h) && std::isfinite(value.dh) && std::isfinite(value.rho) &&
                          std::isfinite(value.drho) && std::isfinite(value.error);
      const double rounding = kSupportRounding * (std::abs(value.rho) + std::abs(value.h));
      const bool bounded = piece.kind == PieceKind::kFace ||
                           (radius.low <= value.rho + rounding && value.rho - rounding <= radius.high);
      if (finite && bounded) continue;
      found_ = fault(fmt::format("{}, piece {} at {:.4g} rad", at, k, at_phi),
                     finite ? "its radius of curvature is not within the bounds that it gives"
                            : "its support has to be finite");
    }
  }

  void check_references(const std::string& at, const NamedCurve& named,
                        const std::vector<NamedCurve>& curves) {
    const auto refer = [&](const std::string& where, int index) {
      found_ = found_.empty() ? no_such(where, index, curves, "curves on this body") : found_;
    };
    if (named.copy_of != -1) refer(at + ".copy_of", named.copy_of);
    for (const int part : named.parts) {
      refer(at + ".parts", part);
      expect(!found_.empty() || curves[part].parts.empty(), at + ".parts", "must have no parts themselves");
    }
  }

  void check(const std::string& at, const Joint& joint) {
    expect_name(joint.name, at);
    if (!exists(at + ".first", joint.first) || !exists(at + ".second", joint.second)) {
      return;
    }
    expect(joint.first.body != joint.second.body, at, "joins a body with itself");
    expect(joint.type >= JointType::kRevolute && joint.type <= JointType::kBelt, at + ".type",
           "is no type of joint");
    expect(joint.type == JointType::kRevolute || couples_turning(joint.type) ||
               std::abs(joint.direction_A.norm() - 1) <= kUnitDirection,
           at + ".direction_A", "must be a unit vector");
    expect(fits(joint.from.value_or(0)), at + ".from", kFitRule);
    expect(fits(joint.to.value_or(0)), at + ".to", kFitRule);
    expect(!joint.from || !joint.to || *joint.from < *joint.to, at + ".from", "must be below `to`");
    expect(is_sharp_angle(joint.relative_angle), at + ".relative_angle", "must be at most 1e9 turns");
    if (couples_turning(joint.type) && exists(at + ".carrier", joint.carrier)) {
      const double ratio = std::abs(joint.turning_ratio);
      expect(ratio >= 1 / kLargestGearRatio && ratio <= kLargestGearRatio, at + ".turning_ratio",
             fmt::format("{}, with either sign", kGearRatioRule));
    }
    if (joint.teeth) {
      expect(joint.type == JointType::kGears && joint.turning_ratio != 1, at + ".teeth",
             "only gears have teeth, and no inner gears of ratio 1");
      expect(joint.teeth->pressure_angle > 0 && joint.teeth->pressure_angle < kPi / 2,
             at + ".teeth.pressure_angle", "must be between 0 and 90 degrees");
      expect(joint.teeth->module >= 0 && std::isfinite(joint.teeth->module), at + ".teeth.module",
             "must be finite and not negative");
    }
  }

  // Of gears and belts, once all joints are known to refer to points that there are.
  void check_carriers() {
    const auto couples = [](const Joint& joint) { return couples_turning(joint.type); };
    if (!found_.empty() || std::none_of(m_.joints.begin(), m_.joints.end(), couples)) return;
    const std::vector<Pin> pins = find_pins(m_);
    each("joints", m_.joints, [&](const std::string& at, const Joint& joint) {
      expect(!couples(joint) || contains(carriers_of(m_, joint, pins), joint.carrier), at + ".carrier",
             "expected a body that carries both wheels on pins at these points");
    });
  }

  void check(const std::string& at, const Contact& contact) {
    expect_name(contact.name, at);
    if (exists(at + ".first", contact.first) && exists(at + ".second", contact.second)) {
      expect(contact.first.body != contact.second.body, at, "is of a body with itself");
      const Curve& first = curve_of(m_, contact.first);
      const Curve& second = curve_of(m_, contact.second);
      const std::string_view objection = why_no_contact(first, second);
      expect(objection.empty(), at, std::string(objection));
      expect(!contact.rolling || (contact.keep == Keep::kTouching && first.kind != CurveKind::kChain &&
                                  second.kind != CurveKind::kChain),
             at + ".rolling", "curves with ends, of several parts, or that may part slip");
      if (needs_boundaries(m_, contact)) {
        expect_no_cusps(at + ".first", contact.first);
        expect_no_cusps(at + ".second", contact.second);
      }
    }
  }

  // In a contact with a boundary, a curve given by its support function is used as a boundary too: it must
  // have no cusps.
  void expect_no_cusps(const std::string& where, const CurveRef& ref) {
    const Body& body = m_.bodies[ref.body];
    const std::vector<int>& parts = body.curves[ref.curve].parts;
    for (const int index : parts.empty() ? std::vector{ref.curve} : parts) {
      const NamedCurve& curve = body.curves[index];
      const SupportCurve* support = curve.boundary ? nullptr : curve.curve.support;
      expect(support == nullptr || !support_chains(*support, 1).empty(), where,
             fmt::format("{}.{} has cusps, for its radius of curvature h + h'' changes sign: it bounds no "
                         "body; a larger constant part of h takes them out",
                         body.name, curve.name));
    }
  }

  void check(const std::string& at, const Driver& driver) {
    found_ = found_.empty() ? no_such(at + ".joint", driver.joint, m_.joints, "joints") : found_;
    if (!found_.empty()) {
      return;
    }
    const Joint& joint = m_.joints[driver.joint];
    expect(can_be_driven(joint.type), at, "a driver needs a revolute or prismatic joint");
    const auto same = std::count_if(m_.drivers.begin(), m_.drivers.end(),
                                    [&](const Driver& other) { return other.joint == driver.joint; });
    expect(same == 1, at, "another driver drives joints." + joint.name + " already");
    expect(m_.drivers.size() == 1 || !driver.name.empty(), at, "each of several drivers needs a name");
    expect(driver.name.empty() || io_detail::is_name(driver.name), at, std::string(io_detail::kNameRule));
  }

  void check(const std::string& at, const Load& load) {
    expect_name(load.name, at);
    (void)exists(at + ".body", load.body);
    expect(fits(load.p_B) && fits(load.force) && fits(load.torque), at, kFitRule);
  }

  void check(const std::string& at, const Spring& spring) {
    expect_name(spring.name, at);
    if (spring.joint) {
      found_ = found_.empty() ? no_such(at + ".joint", *spring.joint, m_.joints, "joints") : found_;
      expect(!found_.empty() || !couples_turning(m_.joints[*spring.joint].type), at + ".joint",
             "gears and belts have no spring");
    } else if (exists(at + ".first", spring.first)) {
      (void)exists(at + ".second", spring.second);
    }
    expect(fits(spring.stiffness) && fits(spring.free) && fits(spring.damping), at, kFitRule);
    expect(spring.stiffness >= 0 && spring.damping >= 0, at, "stiffness and damping must be >= 0");
    expect(spring.joint || spring.free >= 0, at + ".free", "a length must be >= 0");
  }

  void check(const std::string& at, const LawDescription& law) {
    const auto made = MotionLaw::make(law);
    if (!made && found_.empty()) {
      const LawFault& fault = made.error();
      const std::string part = fault.segment ? fmt::format(".segments.{}", *fault.segment)
                               : fault.point ? fmt::format(".points.{}", *fault.point)
                                             : "";
      found_ = at + part + (fault.key.empty() ? " " : "." + fault.key + " ") + fault.rule;
    }
  }

  const Mechanism& m_;
  std::string found_;
};

}  // namespace

std::string fault_of(const Mechanism& mechanism) {
  return Checker(mechanism).run();
}

}  // namespace higherpair
