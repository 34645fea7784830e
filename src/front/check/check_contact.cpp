// The geometry and the speeds of one contact along the path.
#include "check_parts.hpp"
#include "front/columns/path_columns.hpp"
#include "front/tolerances.hpp"
#include "higherpair/analysis/touching_places.hpp"
#include "higherpair/contact/details.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/numeric/contains.hpp"

#include <array>
#include <cmath>
#include <memory>

namespace higherpair {
namespace {

using Bound = CheckFigures::Bound;

// Whether the body that a contact moves, the later one in the order of solution, is its second one. Ground
// comes before all others.
bool moves_second(const Run& run, int index) {
  const Contact& contact = run.mechanism().contacts[index];
  if (contact.first.body == kGround || contact.second.body == kGround) {
    return contact.first.body == kGround;
  }
  for (const Group& group : run.plan().groups) {
    if (contains(group.bodies, contact.first.body)) {
      return true;
    }
    if (contains(group.bodies, contact.second.body)) {
      return false;
    }
  }
  return true;
}

// A body that carries a round one on a pin at its centre: of a roller, what holds its pin.
std::optional<int> carrier_of_roller(const Mechanism& mechanism, const CurveRef& ref) {
  const auto center = round_center(named_curve(mechanism, ref).curve);
  for (const Joint& joint : mechanism.joints) {
    const bool first = joint.first.body == ref.body;
    if (!center || joint.type != JointType::kRevolute || (!first && joint.second.body != ref.body)) {
      continue;
    }
    const Vector2d pin_B = point_of(mechanism, first ? joint.first : joint.second);
    if ((pin_B - *center).norm() <= kPinAtCenter * size_of(mechanism)) {
      return first ? joint.second.body : joint.first.body;
    }
  }
  return std::nullopt;
}

// One contact: its geometry and its speeds.
class CheckedContact {
public:
  /// \param split  whether pressure angles of the return stroke have a limit of their own
  CheckedContact(const Run& run, std::size_t index, bool split)
      : index_(index),
        split_(split),
        second_(moves_second(run, static_cast<int>(index))),
        contact_(run.mechanism().contacts[index]),
        follower_(second_ ? contact_.second : contact_.first),
        other_(second_ ? contact_.first : contact_.second),
        freedom_(grounded_freedom(run.mechanism(), follower_.body)),
        size_(run.plan().size) {
    const auto& idle = run.plan().idle_bodies;
    idle_ = contains(idle, follower_.body) || contains(idle, other_.body);
    idle_follower_ = contains(idle, follower_.body);
    const Curve& curve = named_curve(run.mechanism(), follower_).curve;
    swings_roller_ = freedom_ && freedom_->turns && round_center(curve) && !is_point(curve);
    if (const auto carrier = freedom_ ? std::nullopt : carrier_of_roller(run.mechanism(), follower_)) {
      roller_center_B_ = round_center(curve);
      freedom_ = grounded_freedom(run.mechanism(), *carrier);
    }
    for (const std::size_t side : {0U, 1U}) {
      const CurveRef& ref = ref_of(contact_, side);
      const Curve& own = named_curve(run.mechanism(), ref).curve;
      names_[side] = name_of_curve(run.mechanism(), ref);
      flat_[side] = is_line(own);
      point_[side] = is_point(own);
    }
  }

  // One for each Quantity, in its order.
  // \param speed  the drivers' rate times the size of the mechanism
  [[nodiscard]] std::vector<Sought> sought(double speed) const {
    const auto above = [](Sought sought, double noise) {
      sought.noise = noise;
      return sought;
    };
    const Sought angle = above(kGreatest, kNoAngle);
    const Sought curvature = above(kBoth, kNoCurvature / size_);
    const double rounding = kSlidingRounding * speed;
    return {angle,
            angle,
            angle,
            angle,
            curvature,
            curvature,
            kGreatest,
            kGreatest,
            above(kBoth, rounding),
            above(kBoth, rounding),
            above(kLeast, rounding),
            kBoth,
            kBoth};
  }

  void fill(const Run& run, std::span<double> out) const {
    const MotionRow& row = run.row;
    const ContactMotion& motion = row.contacts[index_];
    if (!motion.touches) {
      return;
    }
    fill_shape(run, motion, out);
    if (row.has_rates[contact_.first.body] && row.has_rates[contact_.second.body]) {
      out[kSliding] = motion.rates.sliding;
      // The surface of a freely turning roller moves with that of the other body.
      const double along = second_ == idle_follower_ ? motion.rates.along1 : motion.rates.along2;
      out[kEntrainment] = idle_ ? along : (motion.rates.along1 + motion.rates.along2) / 2;
      out[kLeastEntrainment] = std::abs(out[kEntrainment]);
    }
  }

  void read(const PathRanges& ranges, CheckFigures& figures) const {
    figures.about("contacts." + contact_.name);
    read_pressure(ranges, figures);
    read_speeds(ranges, figures);
  }

  void read_curves(const PathRanges& ranges, CheckFigures& figures) const {
    for (const std::size_t side : {0U, 1U}) {
      figures.about("contacts." + contact_.name, names_[side]);
      read_curvature(side, ranges[kCurvature1 + side], ranges[kCorner1 + side], figures);
      if (flat_[side]) {
        read_face(ranges[kFace1 + side], figures);
      }
    }
  }

private:
  // Those of the two curves follow each other.
  enum Quantity : std::size_t {
    kOut,
    kBack,
    kCenterOut,
    kCenterBack,
    kCurvature1,
    kCurvature2,
    kCorner1,  // 1 on a corner, 0 otherwise
    kCorner2,
    kSliding,
    kEntrainment,
    kLeastEntrainment,
    kFace1,
    kFace2,
  };

  void fill_shape(const Run& run, const ContactMotion& motion, std::span<double> out) const {
    const MotionRow& row = run.row;
    const CommonNormal at = second_ ? motion.at : motion.at.exchanged();
    const BodyMotion& follower = row.bodies[follower_.body];
    const BodyMotion& other = row.bodies[other_.body];
    const ContactDetails details =
        details_of({curve_of(run.mechanism(), other_), other, nullptr},
                   {curve_of(run.mechanism(), follower_), follower, freedom_ ? &*freedom_ : nullptr}, at,
                   second_ ? motion.phi : motion.phi + kPi);
    const bool back = split_ && goes_back(row, at);
    // A body that touches ground moves along it: its own direction says nothing about what drives it.
    const auto pressure = other_.body == kGround ? std::nullopt
                          : roller_center_B_     ? pressure_of_roller(follower, at)
                                                 : details.pressure;
    if (pressure) {
      out[back ? kBack : kOut] = *pressure;
    }
    if (details.transmission) {
      out[back ? kCenterBack : kCenterOut] = kPi / 2 - *details.transmission;
    }
    for (const std::size_t side : {0U, 1U}) {
      const double rho = side == 0 ? motion.at.rho1 : motion.at.rho2;
      const CurveRef& ref = ref_of(contact_, side);
      if (flat_[side]) {
        const BodyMotion& body = row.bodies[ref.body];
        const Vector2d along = perp(named_curve(run.mechanism(), ref).curve.axis_B);
        out[kFace1 + side] = along.dot(body.X_WB.inverse_times(motion.at.p_W()));
        continue;
      }
      out[kCorner1 + side] = rho == 0 ? 1 : 0;
      if (rho != 0) {
        out[kCurvature1 + side] = 1 / rho;
      }
    }
  }

  // At the centre of a roller on a pin, whose rolling does not move the follower.
  [[nodiscard]] std::optional<double> pressure_of_roller(const BodyMotion& roller,
                                                         const CommonNormal& at) const {
    const Vector2d center_W = roller.X_WB * *roller_center_B_;
    return pressure_angle(roller, freedom_ ? &*freedom_ : nullptr, center_W, at.n_W);
  }

  // Whether the follower moves back, against the outward normal of the other body, faster than rounding.
  [[nodiscard]] bool goes_back(const MotionRow& row, const CommonNormal& at) const {
    if (!row.has_rates[follower_.body]) {
      return false;
    }
    const Vector2d v = velocity_at(row.bodies[follower_.body], at.p_W());
    const Vector2d v_other = velocity_at(row.bodies[other_.body], at.p_W());
    return v.dot(at.n_W) < -kRestingContact * (v.norm() + v_other.norm());
  }

  void read_pressure(const PathRanges& ranges, CheckFigures& figures) const {
    const auto* most = figures.of_contact(index_, LimitKey::kMaxPressureAngle);
    const auto* most_back = figures.of_contact(index_, LimitKey::kMaxReturnPressureAngle);
    const auto read = [&](const std::string& name, std::size_t out, std::size_t back, bool limited) {
      const auto add = [&](const std::string& quantity, const std::optional<PathExtreme>& extreme,
                           const GivenLimit* limit) {
        if (extreme) {
          mark_growing(figures.add(quantity, dimension::kAngle, extreme->value, extreme->driver,
                                   limited ? limit : nullptr, Bound::kMost),
                       *extreme, figures);
        }
      };
      add(name, ranges[out].greatest, most);
      add("return_" + name, ranges[back].greatest, most_back);
    };
    if (swings_roller_) {
      read("pressure_angle", kCenterOut, kCenterBack, true);
      read("pressure_angle_at_contact", kOut, kBack, false);
    } else {
      read("pressure_angle", kOut, kBack, true);
    }
  }

  void read_curvature(std::size_t side, const PathRange& range, const PathRange& corner,
                      CheckFigures& figures) const {
    if (flat_[side] || point_[side]) {
      return;
    }
    const double straight = kStraightContact / size_;
    if (corner.greatest && corner.greatest->value > 0) {
      figures.add("convex_radius", dimension::kLength, 0.0, corner.greatest->driver,
                  figures.of_contact(index_, LimitKey::kMinConvexRadius), Bound::kLeast);
    } else if (range.greatest && range.greatest->value > straight) {
      mark_growing(
          figures.add("convex_radius", dimension::kLength, 1 / range.greatest->value, range.greatest->driver,
                      figures.of_contact(index_, LimitKey::kMinConvexRadius), Bound::kLeast),
          *range.greatest, figures, Bound::kLeast);
    }
    if (range.least && range.least->value < -straight) {
      mark_growing(
          figures.add("concave_radius", dimension::kLength, -1 / range.least->value, range.least->driver,
                      figures.of_contact(index_, LimitKey::kMinConcaveRadius), Bound::kLeast),
          *range.least, figures, Bound::kLeast);
    }
  }

  void read_face(const PathRange& range, CheckFigures& figures) const {
    if (!range.least || !range.greatest) {
      return;
    }
    CheckFigure& figure = figures.add("face_width", dimension::kLength,
                                      range.greatest->value - range.least->value, range.greatest->driver,
                                      figures.of_contact(index_, LimitKey::kMaxFaceWidth), Bound::kMost);
    mark_growing_elsewhere(figure, *range.least, figures, "it");
    mark_growing(figure, *range.greatest, figures);
  }

  void read_speeds(const PathRanges& ranges, CheckFigures& figures) const {
    const auto sliding = peak_of(ranges[kSliding]);
    if (sliding && !idle_) {
      mark_growing(
          figures.add("sliding_speed", dimension::kVelocity, std::abs(sliding->value), sliding->driver,
                      figures.of_contact(index_, LimitKey::kMaxSlidingSpeed), Bound::kMost),
          ranges[kSliding], figures);
    }
    const auto fastest = peak_of(ranges[kEntrainment]);
    const auto& slowest = ranges[kLeastEntrainment].least;
    if (!fastest || !slowest) {
      return;
    }
    mark_growing(
        figures.add("entrainment_speed", dimension::kVelocity, std::abs(fastest->value), fastest->driver),
        ranges[kEntrainment], figures);
    const auto& [least, greatest] = ranges[kEntrainment];
    const bool reverses = least->value < 0 && greatest->value > 0;
    const bool none = reverses || slowest->value < kNoEntrainment * std::abs(fastest->value);
    CheckFigure& figure = figures.add(
        "least_entrainment_speed", dimension::kVelocity, none ? 0 : slowest->value, slowest->driver,
        figures.of_contact(index_, LimitKey::kMinEntrainmentSpeed), Bound::kLeast);
    if (!none) mark_growing(figure, *slowest, figures, Bound::kLeast);
  }

  std::size_t index_;
  bool split_;
  bool second_;  // the follower is the contact's second body
  Contact contact_;
  CurveRef follower_, other_;
  std::optional<OneFreedom> freedom_;  // of the follower; of what carries it, if it is a roller on a pin
  std::optional<Vector2d> roller_center_B_;
  double size_;                       // of the mechanism
  std::array<std::string, 2> names_;  // of the curves
  bool idle_ = false;                 // one of the bodies turns freely
  bool idle_follower_ = false;
  bool swings_roller_ = false;
  std::array<bool, 2> flat_{}, point_{};
};

}  // namespace

ContactCheck contact_check(const CheckedPath& checked, std::size_t index, bool split) {
  const Run& start = checked.start;
  const auto contact = std::make_shared<CheckedContact>(start, index, split);
  ContactCheck check;
  check.quantities = {contact->sought(largest_rate(checked.schedule, start) * start.plan().size),
                      [contact](const Run& run, double, std::span<double> out) { contact->fill(run, out); }};
  check.read = [contact, index, places = touching_places(start, index)](const PathRanges& ranges,
                                                                        CheckFigures& figures) {
    contact->read(ranges, figures);
    if (const auto ratio = mean_of_places(places, index, figures.events())) {
      figures.add("contact_ratio", dimension::kNumber, *ratio, std::nullopt);
    }
  };
  check.read_curves = [contact](const PathRanges& ranges, CheckFigures& figures) {
    contact->read_curves(ranges, figures);
  };
  return check;
}

}  // namespace higherpair
