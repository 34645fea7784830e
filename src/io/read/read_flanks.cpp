#include "higherpair/cam/flank.hpp"
#include "higherpair/cam/sizing.hpp"
#include "higherpair/geometry/contour.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/boundaries.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "io/tolerances.hpp"
#include "numeric/joined_words.hpp"
#include "read_boundary.hpp"
#include "reading.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace higherpair::io_detail {
namespace {

class FlankMaker {
public:
  FlankMaker(Reading& reading, LawBook& laws, Mechanism& mechanism)
      : reading_(reading), laws_(laws), mechanism_(mechanism) {}

  void make(LateCurves::Flank& late) {
    const int body = *index_of(mechanism_.bodies, late.body);
    Body& cam = mechanism_.bodies[body];
    const auto choice = late.table.take("side", as_choice, {"inside", "outside"});
    const CurveRef own{body, static_cast<int>(late.curve)};
    const auto follower = follower_of(late, own);
    const auto cam_joint = follower ? joint_of_body(late, own.body) : std::nullopt;
    const auto follower_joint = cam_joint ? joint_of_body(late, follower->body) : std::nullopt;
    if (!follower_joint) {
      return;
    }
    const Joint& turning = mechanism_.joints[*cam_joint];
    const Joint& moved = mechanism_.joints[*follower_joint];
    const auto law = laws_.find(
        late.law, {coordinate_dimension(turning), coordinate_dimension(moved), LawUnits::kSi}, mechanism_);
    if (!law) {
      return;
    }
    const CarriedBody carried_cam = carried_body(mechanism_, turning, own.body);
    const CarriedBody carried = carried_body(mechanism_, moved, follower->body);
    const CamMotion motion{carried_cam.freedom,
                           carried_cam.sign,
                           carried.freedom,
                           carried.sign,
                           joint_motion(mechanism_, moved, posed_bodies(mechanism_)).position,
                           flank_law(laws_.made(*law), carried_cam.freedom.turns)};
    shape(late, motion, *follower, choice == 1U, cam.curves[late.curve]);
  }

private:
  // The curve on the other body of the contact.
  std::optional<CurveRef> follower_of(const LateCurves::Flank& late, const CurveRef& own) {
    const auto name = as_text(reading_, late.contact);
    if (!name) {
      return std::nullopt;
    }
    const auto index =
        named_thing(reading_, late.contact, *name, "there is no contact", mechanism_.contacts, "contacts");
    if (!index) {
      return std::nullopt;
    }
    const Contact& contact = mechanism_.contacts[*index];
    const auto is_own = [&](const CurveRef& ref) {
      return ref.body == own.body && is_or_has(mechanism_.bodies[own.body].curves, ref.curve, own.curve);
    };
    if (!is_own(contact.first) && !is_own(contact.second)) {
      report(reading_, late.contact,
             "is a contact in which this curve does not take part; name it in its `between`");
      return std::nullopt;
    }
    const CurveRef other = is_own(contact.first) ? contact.second : contact.first;
    const NamedCurve& curve = described_curve(mechanism_, other);
    if (curve.boundary || curve.curve.kind == CurveKind::kChain) {
      report(reading_, late.contact,
             "the follower of a cam has a circle, an ellipse or other conic, a line or a point as its curve");
      return std::nullopt;
    }
    return other;
  }

  std::optional<int> joint_of_body(const LateCurves::Flank& late, int body) {
    const auto joint = ground_joint(mechanism_, body);
    if (!joint) {
      report(
          reading_, late.contact,
          fmt::format("{} needs one revolute or prismatic joint to ground: a flank is shaped for a cam and a "
                      "follower that are both jointed to ground",
                      mechanism_.bodies[body].name));
    }
    return joint;
  }

  void shape(LateCurves::Flank& late, const CamMotion& motion, const CurveRef& follower, bool outer,
             NamedCurve& named) {
    const Curve& curve = curve_of(mechanism_, follower);
    auto spans = cam_flank(motion, curve, outer);
    if (!spans) {
      const FlankOrigin origin{motion, curve, outer};
      report(reading_, late.law, step_at_the_end(motion).value_or(explain(spans.error(), origin)));
      return;
    }
    auto boundary = Boundary::make(*std::move(spans), closes(motion), kFlankMeets * size_of(mechanism_));
    if (!boundary) {
      const auto jump = velocity_jump(motion);
      report(reading_, late.law, jump ? *jump : step_at_the_end(motion).value_or("the flank does not close"));
      return;
    }
    if (const auto crossing = crossing_of(*boundary, {motion, curve, outer})) {
      report(reading_, late.law, *crossing);
      return;
    }
    named.boundary = std::make_shared<const Boundary>(*std::move(boundary));
    named.curve.vertex_B = named.boundary->middle_B();
    note_missing_part(late.law, motion);
  }

  // A law that lacks little of a turn.
  void note_missing_part(const Item& law, const CamMotion& motion) {
    const double over = motion.law.end() - motion.law.begin();
    if (!motion.cam.turns || closes(motion)) return;
    const auto note = [&](std::string_view how) {
      reading_.notes.push_back(
          {law.value->mark, fmt::format("{}: the law goes over {} of the cam, and the flank ends there; {}",
                                        path_of(reading_, law), cam_coordinate(motion, over), how)});
    };
    if (motion.law.repeats()) {
      note(
          "it repeats on the cam where a whole number of repetitions makes a turn, each as high as the "
          "first");
    } else if (over > kNearlyATurn * 2 * kPi) {
      note(fmt::format("over {} it would be closed", cam_coordinate(motion, 2 * kPi)));
    }
  }

  [[nodiscard]] std::string cam_coordinate(const CamMotion& motion, double x) const {
    return with_unit(x, coordinate_dimension(motion.cam.turns), reading_.units);
  }

  // Explains that a law over a whole turn ends at another value than it begins with.
  [[nodiscard]] std::optional<std::string> step_at_the_end(const CamMotion& motion) const {
    if (!closes(motion) || std::abs(motion.law.advance()) <= kFlankMeets * size_of(mechanism_)) {
      return std::nullopt;
    }
    return fmt::format(
        "the flank does not close: over the turn of the cam the law ends {} off the value with which "
        "it begins",
        with_unit(motion.law.advance(), coordinate_dimension(motion.follower.turns), reading_.units));
  }

  // Explains where the law's velocity jumps: there the flank has a gap for any follower but a knife edge,
  // whatever its size. None if the velocity does not jump.
  [[nodiscard]] std::optional<std::string> velocity_jump(const CamMotion& motion) const {
    const auto& joins = motion.law.joins();
    const auto jump = std::find_if(joins.begin(), joins.end() - 1, [&](const LawJoin& join) {
      return (closes(motion) || &join != &joins.front()) && !join.jumps(0) && join.jumps(1);
    });
    if (jump == joins.end() - 1) {
      return std::nullopt;
    }
    return fmt::format(
        "at {} of the cam the law's velocity jumps: this follower would go on at another "
        "place of its curve, with a gap in the flank; a knife edge (type = \"point\") "
        "can follow it, or else let the segments meet with one velocity",
        cam_coordinate(motion, jump->x));
  }

  [[nodiscard]] std::string explain(const FlankFault& fault, const FlankOrigin& cam) const {
    const CamMotion& motion = cam.motion;
    const std::string at = cam_coordinate(motion, fault.coordinate);
    switch (fault.kind) {
      case FlankFault::Kind::kStandstill:
        return "at " + at + " of the cam the follower does not move against the cam: no flank shapes that";
      case FlankFault::Kind::kNoEffect:
        return motion.follower.turns ? "the follower turns about the centre of its own curve, which stays "
                                       "where it is: this law "
                                       "shapes nothing; put the curve at the end of an arm"
                                     : "the follower slides along its own face, which stays where it is: "
                                       "this law shapes nothing; "
                                       "turn the face, or the guide";
      case FlankFault::Kind::kNoNormal:
        return "at " + at +
               " of the cam no point of the follower's curve could touch a flank; use a curve that "
               "goes farther round, or another pose";
      case FlankFault::Kind::kTooLong:
        return "the law goes over more than a turn of the cam, whose flank would cross itself";
      case FlankFault::Kind::kUndercut:
        break;
    }
    const auto jump = velocity_jump(motion);
    if (jump) {
      return *jump;
    }
    if (is_line(cam.curve) && can_be_cut(turned_over(cam))) {
      const Vector2d& n_B = cam.curve.axis_B;  // an axis points into the material
      return fmt::format(
          "the follower's face points away from the cam: its normal points out of the follower's "
          "material, to the flank; write normal = [{:.6g}, {:.6g}]",
          n_B.x() + 0.0, n_B.y() + 0.0);
    }
    const auto largest = has_roller(cam) ? largest_follower(cam, 0) : std::nullopt;
    return "from " + at + " of the cam on the flank would be undercut: " +
           remedies(cam, smallest_for_radius(cam, {}), largest ? largest->value : 0);
  }

  // The same for a face with the other normal.
  static FlankOrigin turned_over(FlankOrigin cam) {
    cam.curve.axis_B = -cam.curve.axis_B;
    return cam;
  }

  // Whether a flank can be made that closes and does not cross itself.
  [[nodiscard]] bool can_be_cut(const FlankOrigin& cam) const {
    auto spans = cam_flank(cam.motion, cam.curve, cam.outer);
    if (!spans) {
      return false;
    }
    const auto boundary =
        Boundary::make(*std::move(spans), closes(cam.motion), kFlankMeets * size_of(mechanism_));
    return boundary && !find_self_crossing(*boundary);
  }

  // Changes that would avoid an undercut or a crossing, as far as they are changes of what the flank has.
  // \param size, radius  beyond which there is no undercut; 0: no radius is known. From there on sizes are
  // searched for at which the flank does not cross itself either
  [[nodiscard]] std::string remedies(const FlankOrigin& cam, std::optional<CamSize> size,
                                     double radius) const {
    const auto cuts = [&](const FlankOrigin& other) { return can_be_cut(other); };
    const auto here = size_of(cam);
    std::vector<std::string> changes, tried;
    if (here && size) {
      const CamSize from = size->base_radius > here->base_radius ? *size : *here;
      size = reading_.advises ? smallest_that_can_be_cut(cam, from, cuts) : from;
      if (!size) {
        tried.push_back("no base circle up to " +
                        length_text(reading_, largest_tried(cam, from).base_radius));
      } else if (size->base_radius > here->base_radius) {
        changes.push_back(base_circle_text(cam, *here, *size));
      }
    }
    const double own = cam.curve.semi_latus;
    if (radius > 0 && is_roller(cam)) {
      const double from = std::min(radius, own);
      const auto found = reading_.advises ? largest_that_can_be_cut(cam, from, cuts) : from;
      if (!found) {
        tried.push_back("no roller down to " + length_text(reading_, smallest_radius_tried(from)));
      } else if (*found < own) {
        changes.push_back("a roller of less than " + length_text(reading_, *found));
      }
    }
    const std::string none = tried.empty() ? "" : joined_words(tried, " and ") + " would do";
    if (changes.empty()) {
      return none.empty() ? "it takes " + changes_of(cam) : none + "; it takes a longer segment of the law";
    }
    return fmt::format("it takes {}, or a longer segment of the law{}", fmt::join(changes, ", "),
                       none.empty() ? "" : " (" + none + ")");
  }

  [[nodiscard]] std::string base_circle_text(const FlankOrigin& cam, const CamSize& here,
                                             const CamSize& size) const {
    const bool turns = cam.motion.follower.turns;
    return fmt::format(
        "a base circle of more than {} instead of {} (the follower's pose {} by {})",
        length_text(reading_, size.base_radius), length_text(reading_, here.base_radius),
        turns ? "turned" : "moved",
        with_unit(size.rest - cam.motion.follower_rest, coordinate_dimension(turns), reading_.units));
  }

  static bool has_roller(const FlankOrigin& cam) {
    return is_conic(cam.curve) && cam.curve.side == Side::kInside;
  }

  static bool is_roller(const FlankOrigin& cam) {
    return has_roller(cam) && cam.curve.kind == CurveKind::kCircle;
  }

  // The same without numbers.
  static std::string changes_of(const FlankOrigin& cam) {
    std::vector<std::string> changes;
    if (cam.motion.cam.turns) {
      changes.emplace_back("a larger base circle (the follower's pose farther from the cam's pivot)");
    }
    if (has_roller(cam)) {
      changes.emplace_back("a smaller roller");
    }
    changes.emplace_back("a longer segment of the law");
    return joined_words(changes, " or ");
  }

  // Explains where the flank passes through itself.
  [[nodiscard]] std::optional<std::string> crossing_of(const Boundary& flank, const FlankOrigin& cam) const {
    const auto crossing = find_self_crossing(flank);
    if (!crossing) {
      return std::nullopt;
    }
    const auto coordinate = [&](const BoundaryPlace& place) {
      return flank_coordinate(*flank.spans()[static_cast<std::size_t>(place.span)], place.t).value();
    };
    const auto [first, second] = std::minmax({coordinate(crossing->first), coordinate(crossing->second)});
    return fmt::format(
        "the flank crosses itself: at {} and at {} of the cam it passes through {}, and what is shaped there "
        "for the one is cut away for the other; {}",
        cam_coordinate(cam.motion, first), cam_coordinate(cam.motion, second),
        point_text(reading_, crossing->p_B),
        reading_.advises ? remedies(cam, size_of(cam), cam.curve.semi_latus) : "it takes " + changes_of(cam));
  }

  Reading& reading_;
  LawBook& laws_;
  Mechanism& mechanism_;
};

}  // namespace

void make_late_curves(Reading& reading, LateCurves& late, LawBook& laws, Mechanism& mechanism) {
  if (!reading.mistakes.empty()) {
    return;  // the flanks are made from joints, contacts and laws, which may be wrong
  }
  FlankMaker maker(reading, laws, mechanism);
  for (LateCurves::Flank& flank : late.flanks) {
    maker.make(flank);
  }
  for (LateCurves::Offset& offset : late.offsets) {
    Body& body = mechanism.bodies[*index_of(mechanism.bodies, offset.body)];
    if (!body.curves[offset.source].boundary) {
      continue;  // its mistake has been reported
    }
    if (auto curve = read_offset(offset.table, offset.by, body.curves[offset.source])) {
      curve->name = body.curves[offset.curve].name;
      body.curves[offset.curve] = *std::move(curve);
    }
  }
}

}  // namespace higherpair::io_detail
