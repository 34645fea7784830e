#include "higherpair/io/contact_report.hpp"

#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/row_path.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

// Significant digits of the proposed free lengths, tried in turn: a narrow range between too little and too
// much preload takes more digits.
constexpr int kDigits[] = {7, 9, 12};

// The number rounded to six digits away from 0, as a lower bound of what is needed.
double rounded_up(double value) {
  if (value == 0) {
    return 0;
  }
  const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
  return std::copysign(std::ceil(std::abs(value) / digit * (1 - kLastDigitUp)) * digit, value);
}

// The nearest multiple of 10^-decimals, as the double that its decimal text reads as.
double rounded_to_decimals(double value, int decimals) {
  const double power = std::pow(10.0, std::abs(decimals));
  return decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

const Joint* joint_of(const Preload& preload, const Mechanism& mechanism) {
  const auto index = static_cast<std::size_t>(preload.index);
  if (preload.on == Preload::On::kJoint) {
    return &mechanism.joints[index];
  }
  const std::optional<int> joint = mechanism.springs[index].joint;
  return joint ? &mechanism.joints[*joint] : nullptr;
}

bool turns(const Preload& preload, const Mechanism& mechanism) {
  const Joint* joint = joint_of(preload, mechanism);
  return joint != nullptr && has_angle(joint->type);
}

// The number that sets a preload, in the profile's units: a free length or angle, or an effort.
class PreloadNumber {
public:
  PreloadNumber(const Preload& preload, const Profile& profile) {
    const Mechanism& mechanism = profile.mechanism;
    const bool angle = turns(preload, mechanism);
    Dimension dimension = effort_dimension(angle);
    if (preload.on == Preload::On::kSpring) {
      const Spring& spring = mechanism.springs[preload.index];
      dimension = coordinate_dimension(angle);
      rate_ = -spring.stiffness;
      origin_ = spring.free;
    }
    from_si_ = from_si(dimension, profile.units);
    to_si_ = to_si(dimension, profile.units);
  }

  [[nodiscard]] double of(double addition) const { return from_si_.apply(origin_ + addition / rate_); }
  [[nodiscard]] double si(double number) const { return to_si_.apply(number); }
  [[nodiscard]] double addition(double number) const { return (si(number) - origin_) * rate_; }

  // Decimals that give the number, or its change where that is larger, this many digits.
  [[nodiscard]] int decimals(double addition, int digits) const {
    const double size = std::max(std::abs(of(addition)), std::abs(of(addition) - of(0)));
    return size > 0 ? digits - 1 - static_cast<int>(std::floor(std::log10(size))) : 0;
  }

  // Half a unit of the last decimal.
  [[nodiscard]] double margin(int decimals) const {
    const double half = 0.5 * std::pow(10.0, -decimals);
    return std::abs(rate_ * (si(half) - si(0))) * (1 + kHalfDigit);
  }

private:
  double rate_ = 1;    // change of the addition per unit of the number, in SI units
  double origin_ = 0;  // the number without addition, in SI units
  Scaling from_si_, to_si_;
};

struct Advice {
  std::vector<double> additions;
  std::vector<double> numbers;  // that produce the additions
};

// Whether no contact opens with these free lengths.
bool stays_closed(const Profile& profile, const DriverPath& path, const Run& start,
                  const std::vector<Preload>& preloads, const Advice& advice) {
  Mechanism mechanism = profile.mechanism;
  for (std::size_t k = 0; k < preloads.size(); ++k) {
    if (preloads[k].on != Preload::On::kSpring) {
      return true;
    }
    if (advice.additions[k] != 0) {
      Spring& spring = mechanism.springs[preloads[k].index];
      spring.free = PreloadNumber(preloads[k], profile).si(advice.numbers[k]);
    }
  }
  std::vector<double> positions;
  for (const DriverMotion& driver : path.at(path.knots.front())) {
    positions.push_back(driver.position);
  }
  auto run = start_run(mechanism, positions, start.tolerance);
  if (!run) {
    return false;
  }
  run->stop = start.stop;
  return follow_contact_forces(*run, path).openings.empty();
}

// The smallest preloads, as numbers short enough to be printed and checked by a run.
std::optional<Advice> advice_for(const ContactForces& forces, const Profile& profile, const DriverPath& path,
                                 const Run& start) {
  const auto exact = smallest_preloads(forces, profile.mechanism, start.plan().size);
  for (std::size_t i = 0; exact && i < std::size(kDigits) && !is_stopped(start); ++i) {
    std::vector<PreloadNumber> numbers;
    std::vector<int> decimals;
    PreloadRounding rounding;
    for (std::size_t k = 0; k < forces.preloads.size(); ++k) {
      numbers.emplace_back(forces.preloads[k], profile);
      decimals.push_back(numbers[k].decimals((*exact)[k], kDigits[i]));
      rounding.margin.push_back(numbers[k].margin(decimals[k]));
    }
    const auto rounded = [&](std::size_t k, double x) {
      return rounded_to_decimals(numbers[k].of(x), decimals[k]);
    };
    rounding.round = [&](std::size_t k, double x) { return x == 0 ? 0 : numbers[k].addition(rounded(k, x)); };
    if (auto additions = smallest_preloads(forces, profile.mechanism, start.plan().size, &rounding)) {
      Advice advice{*std::move(additions), {}};
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        advice.numbers.push_back(rounded(k, advice.additions[k]));
      }
      if (stays_closed(profile, path, start, forces.preloads, advice)) {
        return advice;
      }
    }
  }
  return std::nullopt;
}

std::string refusal(const std::vector<Preload>& preloads, const Mechanism& mechanism) {
  const bool springs = preloads.front().on == Preload::On::kSpring;
  const auto index = static_cast<std::size_t>(preloads.front().index);
  if (preloads.size() > 1) {
    return fmt::format("; no preload of the {} keeps every contact closed on the whole path",
                       springs ? "springs" : "joints that carry the bodies in contact");
  }
  return springs
             ? fmt::format("; no preload of springs.{} keeps every contact closed on the whole path",
                           mechanism.springs[index].name)
             : fmt::format("; no constant effort on joints.{} keeps every contact closed on the whole path",
                           mechanism.joints[index].name);
}

std::string advice_text(const ContactForces& forces, const Profile& profile, const DriverPath& path,
                        const Run& start) {
  if (forces.preloads.empty()) {
    return "";
  }
  const auto advice = advice_for(forces, profile, path, start);
  if (!advice) {
    return refusal(forces.preloads, profile.mechanism);
  }
  std::string text;
  for (std::size_t k = 0; k < forces.preloads.size(); ++k) {
    if (advice->additions[k] != 0) {
      text += (text.empty() ? "" : " and ") + describe(forces.preloads[k], advice->additions[k], profile);
    }
  }
  return "; every contact stays closed on the whole path if " + text;
}

const char* what_happens(ContactOpening::Kind kind) {
  switch (kind) {
    case ContactOpening::Kind::kRoot:
      return "from here on the contact would have to pull";
    case ContactOpening::Kind::kPole:
      return "the contact force grows beyond all bounds here and changes its sign: a change point, "
             "beyond which the contact would have to pull";
    case ContactOpening::Kind::kPulled:
      break;
  }
  return "the contact would have to pull here already";
}

}  // namespace

std::string describe(const Preload& preload, double addition, const Profile& profile) {
  const Mechanism& mechanism = profile.mechanism;
  const Joint* joint = joint_of(preload, mechanism);
  const bool angle = turns(preload, mechanism);
  const Dimension dimension = effort_dimension(angle);
  const double amount = rounded_up(from_si(dimension, profile.units).apply(addition));
  const std::string unit = unit_text(dimension, profile.units);
  if (preload.on == Preload::On::kJoint) {
    return fmt::format("a constant {} of {:.6g} {} acts on joints.{}", angle ? "torque" : "force", amount,
                       unit, joint->name);
  }
  const Spring& spring = mechanism.springs[preload.index];
  const PreloadNumber number(preload, profile);
  const std::string size = fmt::format("{:.6g} {}", std::abs(amount), unit);
  const std::string other =
      fmt::format("({0} {1:.12g} {3} instead of {2:.12g} {3})", angle ? "free_angle" : "free_length",
                  number.of(addition), number.of(0), unit_text(coordinate_dimension(angle), profile.units));
  if (joint == nullptr) {
    return fmt::format("springs.{} {} by {} more {}", spring.name, addition > 0 ? "pulls" : "pushes", size,
                       other);
  }
  return fmt::format("springs.{} {} by {} more towards {} coordinates {}", spring.name,
                     angle ? "turns" : "pushes", size, addition > 0 ? "smaller" : "larger", other);
}

ContactForceReport report_contacts(const Profile& profile, const DriverSchedule& schedule, const Run& start) {
  if (profile.mechanism.contacts.empty()) {
    return {};  // nothing can open: no need to follow the forces along the path
  }
  const RowPath rows = path_of(schedule);
  ContactForces forces =
      follow_contact_forces(start, rows.path, preloads_of(profile.mechanism, start.plan()));
  ContactForceReport report;
  const std::string advice = forces.openings.empty() ? "" : advice_text(forces, profile, rows.path, start);
  for (const ContactOpening& opening : forces.openings) {
    report.openings.push_back({opening, rows.row(opening.at), what_happens(opening.kind) + advice});
  }
  report.highest_speed = highest_speed(forces);
  report.lowest = std::move(forces.lowest);
  return report;
}

}  // namespace higherpair
