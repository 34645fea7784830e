#include "profile_notes.hpp"

#include "condition_notes.hpp"
#include "contact_notes.hpp"
#include "flank_notes.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/mechanism/boundaries.hpp"
#include "higherpair/mechanism/driver_name.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/joint_sides.hpp"
#include "higherpair/mechanism/plan.hpp"
#include "io/tolerances.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

constexpr double kEarth = 9.80665;  // [m/s²]

// A number that is written without a unit of its own.
std::optional<double> plain_number(const Value* value) {
  return value == nullptr ? std::nullopt : number_in(*value);
}

bool is_near(double a, double b, double relative) {
  return std::abs(a - b) <= relative * std::abs(b);
}

bool is_whole(double x) {
  return std::abs(x - std::round(x)) <= kWholeNumber * std::max(1.0, std::abs(x)) && std::abs(x) >= 0.5;
}

// A whole number or a whole part of 1.
bool is_even(double x) {
  return is_whole(x) || is_whole(1 / x);
}

// Whether three decimal digits are enough to write the number.
bool is_short(double x) {
  return x != 0 && is_whole(x * std::pow(10, 2 - std::floor(std::log10(std::abs(x)))));
}

class Notes {
public:
  Notes(const Reading& reading, const Value& document, const Profile& profile)
      : reading_(reading),
        document_(std::get<Table>(document.content)),
        profile_(profile),
        mechanism_(profile.mechanism) {}

  Diagnostics all() {
    found_ = reading_.notes;
    gravity();
    size();
    ground();
    for (std::size_t i = 1; i < mechanism_.bodies.size(); ++i) {
      body(mechanism_.bodies[i], static_cast<int>(i));
    }
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
      curves(mechanism_.bodies[i], static_cast<int>(i));
    }
    for (const Contact& contact : mechanism_.contacts) {
      if (const std::string text = contact_note(mechanism_, contact, profile_.units); !text.empty()) {
        add("contacts." + contact.name, text, ".between");
      }
    }
    repeated("joints", mechanism_.joints, [&, size = size_of(mechanism_)](std::size_t i) {
      return repeated_joint_note(mechanism_, size, i);
    });
    repeated("contacts", mechanism_.contacts,
             [&](std::size_t i) { return repeated_contact_note(mechanism_, i); });
    for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) {
      driver(i, profile_.programs[i]);
    }
    for (const FlankNote& note : flank_notes(document_, profile_)) {
      add("tolerances." + note.tolerance, note.text);
    }
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Mistake& a, const Mistake& b) { return a.mark < b.mark; });
    Diagnostics notes;
    for (const Mistake& note : found_) {
      notes.push_back({place_of(reading_, note.mark), note.message});
    }
    return notes;
  }

private:
  [[nodiscard]] const Value* at(const std::string& path) const { return end_of_path(document_, path).value; }

  // \param key  the key of the table at `path` where the note is located
  void add(const std::string& path, const std::string& text, const char* key = "") {
    const Value* value = at(path + key);
    found_.push_back({value == nullptr ? Mark{} : value->mark, path + ": " + text});
  }

  // \pre there is a value at the path
  void add_with_value(const std::string& path, const std::string& text) {
    const Value& value = *at(path);
    found_.push_back({value.mark, fmt::format("{} = {}: {}", path, text_of(value), text)});
  }

  [[nodiscard]] std::string length(double metres) const {
    return with_unit(metres, dimension::kLength, profile_.units, 3);
  }

  // Gravity of 9.81 although lengths are in millimetres.
  void gravity() {
    const Value* value = at("gravity");
    const auto* items = value == nullptr ? nullptr : std::get_if<Array>(&value->content);
    if (items == nullptr || items->size() != 2) return;
    const auto x = plain_number(&(*items)[0]);
    const auto y = plain_number(&(*items)[1]);
    if (!x || !y) return;
    const double written = std::hypot(*x, *y);
    const double share = mechanism_.gravity_W.norm() / kEarth;
    constexpr double kNumbers[] = {kEarth, 100 * kEarth, 1000 * kEarth, kEarth / 0.3048, kEarth / 0.0254};
    const bool is_earths = std::any_of(std::begin(kNumbers), std::end(kNumbers), [&](double number) {
      return is_near(written, number, kEarthsNumber);
    });
    if (is_earths && !is_near(share, 1, kEarthsGravity)) {
      add_with_value(
          "gravity",
          fmt::format("{:.3g} times the earth's: numbers here are in {}, in which the earth's is {:.6g}; or "
                      "write it with its unit, \"9.81 m/s^2\"",
                      share, unit_text(dimension::kAcceleration, profile_.units),
                      from_si(dimension::kAcceleration, profile_.units).apply(kEarth)));
    }
  }

  // A drawing's numbers in millimetres, read as metres; or numbers in metres, read as millimetres.
  void size() {
    const double metres = size_of(mechanism_);
    const bool is_fraction = from_si(dimension::kLength, profile_.units).apply(metres) < 1;
    if (!mechanism_.joints.empty() &&
        (metres > kLargeMechanism || (metres < kSmallMechanism && is_fraction))) {
      add("units.length", fmt::format("the mechanism is {} large: are its numbers in \"{}\"?", length(metres),
                                      name_of(profile_.units.length)));
    }
  }

  // Whether a joint or a contact is on the body.
  [[nodiscard]] bool is_held(int body) const {
    const auto concerns = [&](const auto& element) { return has_end_on(element, body); };
    return std::any_of(mechanism_.joints.begin(), mechanism_.joints.end(), concerns) ||
           std::any_of(mechanism_.contacts.begin(), mechanism_.contacts.end(), concerns);
  }

  void ground() {
    if (!is_held(kGround)) {
      add("joints",
          "nothing is joined to ground: the frame is the body `ground`, give it points and join bodies to "
          "them");
    }
  }

  void body(const Body& body, int index) {
    if (!is_held(index)) {
      add("bodies." + body.name, "no joint and no contact holds this body");
    }
    angle_unit("bodies." + body.name + ".pose.angle");
    if (body.mass && body.mass->mass > 0) {
      center_of_mass(body);
      if (body.mass->inertia > 0) inertia(body);
    }
  }

  // Far outside of everything.
  void center_of_mass(const Body& body) {
    const double size = size_of(mechanism_), off = body.mass->center_of_mass_B.norm();
    const std::string path = "bodies." + body.name + ".center_of_mass";
    if (off > kFarCenterOfMass * size && at(path) != nullptr) {
      add_with_value(
          path, fmt::format("{} from the body's origin, in a mechanism of {}", length(off), length(size)));
    }
  }

  // A wrong unit of length shows as a radius of gyration that is wrong by a large factor.
  void inertia(const Body& body) {
    const Vector2d& center_B = body.mass->center_of_mass_B;
    double extent = 0;
    for (const NamedPoint& point : body.points) {
      extent = std::max(extent, (point.p_B - center_B).norm());
    }
    for (const NamedCurve& curve : body.curves) {
      extent = std::max(extent, (curve.curve.vertex_B - center_B).norm());
      for (std::size_t k = 0; curve.boundary && k < curve.boundary->spans().size(); ++k) {
        const Span& span = *curve.boundary->spans()[k];
        extent = std::max(extent, (span.at(span.range().low).p_B - center_B).norm());
      }
    }
    const double gyration = std::sqrt(body.mass->inertia / body.mass->mass);
    if (extent > 0 && (gyration > kGyrationOff * extent || gyration < extent / kGyrationOff)) {
      add_with_value(
          "bodies." + body.name + ".inertia",
          fmt::format("a radius of gyration of {} in a body of {}: numbers here are in {}", length(gyration),
                      length(extent), unit_text(dimension::kInertia, profile_.units)));
    }
  }

  void curves(const Body& body, int index) {
    for (std::size_t k = 0; k < body.curves.size(); ++k) {
      const auto is_this = [&](const CurveRef& ref) {
        return ref.body == index && is_or_has(body.curves, ref.curve, static_cast<int>(k));
      };
      const bool used = std::any_of(
          mechanism_.contacts.begin(), mechanism_.contacts.end(),
          [&](const Contact& contact) { return is_this(contact.first) || is_this(contact.second); });
      const std::string& name = body.curves[k].name;
      const bool is_drawn = at(fmt::format("drawing.{}.curves.{}", body.name, name)) != nullptr;
      if (!used && !is_drawn && !has_offset(body, name)) {
        add(fmt::format("bodies.{}.curves.{}", body.name, name), "no contact names this curve");
      }
    }
  }

  template <class Items, class NoteOf>
  void repeated(const std::string& room, const Items& items, const NoteOf& note_of) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (const std::string text = note_of(i); !text.empty()) {
        add(room + "." + items[i].name, text, ".between");
      }
    }
  }

  // Whether another curve of the body is an offset of this one.
  [[nodiscard]] bool has_offset(const Body& body, const std::string& name) const {
    return std::any_of(body.curves.begin(), body.curves.end(), [&](const NamedCurve& other) {
      const Value* of = at(fmt::format("bodies.{}.curves.{}.of", body.name, other.name));
      const auto* text = of == nullptr ? nullptr : std::get_if<std::string>(&of->content);
      return text != nullptr && *text == name;
    });
  }

  // Degrees read as radians or turns, and the reverse.
  void angle_unit(const std::string& path) {
    const auto number = plain_number(at(path));
    if (!number) return;
    const Unit unit = profile_.units.angle;
    const double least = unit == Unit::kRevolution ? 90 : 30;  // that many turns may well be meant
    const bool could_be_degrees = std::abs(*number) >= least && is_whole(*number / (least == 90 ? 90 : 15));
    const double quarters = *number / (kPi / 2);
    const bool could_be_radians = std::abs(quarters) >= 0.5 &&
                                  std::abs(*number - std::round(quarters) * kPi / 2) <= kRoundedPi &&
                                  std::abs(quarters) < 9;
    const double turns = to_si(dimension::kAngle, profile_.units).apply(*number) / (2 * kPi);
    if (unit != Unit::kDegree && could_be_degrees) {
      add_with_value(
          path, fmt::format("{:.4g} turns, for angles here are in {}; write \"{:g} deg\" if that is meant",
                            turns, name_of(unit), *number));
    } else if (unit == Unit::kDegree && could_be_radians) {
      add_with_value(
          path, fmt::format("{:.3g} turns, for angles here are in deg; write \"{:g} rad\" if that is meant",
                            turns, *number));
    }
  }

  void driver(std::size_t i, const DriverProgram& program) {
    const std::string path = driver_path(mechanism_.drivers[i]);
    const bool turns = driven_joint(mechanism_, i).type == JointType::kRevolute;
    if (turns) {
      angle_unit(path + ".start");
      angle_unit(path + ".end");
      if (!program.positions.empty()) {
        const auto farthest = std::max_element(program.positions.begin(), program.positions.end(),
                                               [](double a, double b) { return std::abs(a) < std::abs(b); });
        angle_unit(fmt::format("{}.positions.{}", path, farthest - program.positions.begin()));
      }
    }
    if (program.law) {
      // The law gives the motion in time: `end` and `samples` do not matter.
    } else if (!program.positions.empty()) {
      for (const char* key : {".end", ".samples"}) {
        if (at(path + key) != nullptr) add_with_value(path + key, "not used, for `positions` are given");
      }
    } else if (has_law()) {
      if (at(path + ".end") != nullptr) {
        add_with_value(path + ".end",
                       "not used, for another driver follows a law: all move in time, this one with its "
                       "`velocity` and `acceleration`");
      }
    } else if (program.end && *program.end == program.start && !has_duration()) {
      add_with_value(path + ".end", "the start: the driver stays there, and all rows are alike");
    } else if (!turns && !program.end && !has_duration()) {
      add(path + ".joint", "this joint slides, and without an `end` it stays at its start");
    } else {
      spacing(path + ".samples", program, turns);
    }
    if (const std::string text = unreached_flank_note(profile_, i); !text.empty()) {
      add(path, text, ".start");
    }
    if (program.time_step && program.duration && *program.time_step > *program.duration) {
      add_with_value(path + ".time_step", "longer than the duration");
    }
  }

  // Whether the drivers move in time: one of them gives the duration for all.
  [[nodiscard]] bool has_duration() const {
    return std::any_of(profile_.programs.begin(), profile_.programs.end(),
                       [](const DriverProgram& program) { return program.duration.has_value(); });
  }

  // Whether a driver follows a law.
  [[nodiscard]] bool has_law() const {
    return std::any_of(profile_.programs.begin(), profile_.programs.end(),
                       [](const DriverProgram& program) { return program.law.has_value(); });
  }

  // 360 samples over 360 degrees although both ends are rows.
  void spacing(const std::string& path, const DriverProgram& program, bool turns) {
    if (!program.samples || *program.samples < 10) return;
    const double span = program.end ? *program.end - program.start : turns ? full_turn(profile_.units) : 0;
    const auto rows = static_cast<double>(*program.samples);
    const double apart = span / (rows - 1);
    if (span != 0 && is_even(span / rows) && !is_even(apart) && !is_short(apart)) {
      const std::string_view unit = name_of(turns ? profile_.units.angle : profile_.units.length);
      add_with_value(path,
                     fmt::format("both ends are rows, so they are {:.6g} {} apart; {} rows are {:g} {} apart",
                                 std::abs(apart), unit, *program.samples + 1, std::abs(span) / rows, unit));
    }
  }

  const Reading& reading_;
  const Table& document_;
  const Profile& profile_;
  const Mechanism& mechanism_;
  std::vector<Mistake> found_;
};

}  // namespace

Diagnostics profile_notes(const Reading& reading, const Value& document, const Profile& profile) {
  return Notes(reading, document, profile).all();
}

}  // namespace higherpair::io_detail
