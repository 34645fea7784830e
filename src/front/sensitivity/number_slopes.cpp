#include "number_slopes.hpp"

#include "front/tolerances.hpp"
#include "higherpair/io/coordinate.hpp"
#include "higherpair/io/profile_document.hpp"
#include "higherpair/mechanism/joint_motion.hpp"
#include "higherpair/mechanism/numbers.hpp"
#include "higherpair/numeric/stencil.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace higherpair {
namespace {

constexpr int kReach = 4;  // steps of a number to either side

using Coefficients = std::array<double, 6>;

// The coefficients of the conic that has a number among them, and the index of that number; none for other
// numbers.
std::optional<std::pair<Coefficients, std::size_t>> conic_with(const ProfileDocument& document,
                                                               const std::string& path) {
  const std::string_view list = std::string_view(path).substr(0, path.size() - 1);
  const auto index_in = [](const std::string& of) { return static_cast<std::size_t>(of.back() - '0'); };
  if (!list.ends_with(".coefficients.") || index_in(path) >= Coefficients().size()) {
    return std::nullopt;
  }
  Coefficients all{};
  document.for_each_number([&](const std::string& other, double value) {
    if (other.size() == path.size() && other.starts_with(list)) all.at(index_in(other)) = value;
  });
  return std::pair(all, index_in(path));
}

// The change of a coefficient of A x² + B y² + C x y + D x + E y + F = 0 that makes its term as large as the
// largest of the equation at the size of the conic, or at that of the mechanism if it is smaller.
double term_scale(const Coefficients& k, std::size_t index, double size) {
  constexpr std::array kPowers = {2, 2, 2, 1, 1, 0};
  const double square = std::max({std::abs(k[0]), std::abs(k[1]), std::abs(k[2])});
  const double linear = std::max(std::abs(k[3]), std::abs(k[4]));
  const double own = std::max(linear / square, std::sqrt(std::abs(k[5]) / square));
  const double length = own > 0 && own < size ? own : size;
  double largest = 0;
  for (std::size_t i = 0; i < k.size(); ++i) {
    largest = std::max(largest, std::abs(k[i]) * std::pow(length, kPowers[i]));
  }
  return largest / std::pow(length, kPowers[index]);
}

// See SensitivityNumber::scale.
double scale_of(const Model& model, const ProfileNumber& number, const NaturalScales& natural) {
  const Dimension& of = number.dimension;
  const Units& units = model.units();
  const std::string& path = number.number.paths.front();
  const double length = from_si(dimension::kLength, units).apply(natural.size);
  if (of == dimension::kLength) {
    return length;
  }
  if (of == dimension::kAngle) {
    return from_si(dimension::kAngle, units).apply(1);
  }
  double scale = std::abs(number.number.value);
  if (path.starts_with("driver") && of.time < 0) {
    const double rate = std::pow(natural.size, of.length) * std::pow(natural.rate, -of.time);
    scale = std::max(scale, from_si(of, units).apply(rate));
  } else if (const auto conic = conic_with(*model.data().document, path)) {
    scale = std::max(scale, term_scale(conic->first, conic->second, length));
  }
  return scale > 0 ? scale : 1;
}

// Whether joints differ in numbers that for_each_number leaves out.
bool joints_differ(const Mechanism& a, const Mechanism& b) {
  return !std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(), [](const Joint& p, const Joint& q) {
    const bool teeth = p.teeth.has_value() == q.teeth.has_value() &&
                       (!p.teeth || (p.teeth->pressure_angle == q.teeth->pressure_angle &&
                                     p.teeth->module == q.teeth->module));
    return teeth && p.from == q.from && p.to == q.to;
  });
}

// Whether there are contacts that may part: no column can be differentiated exactly then.
bool may_part(const Mechanism& mechanism) {
  return std::any_of(mechanism.contacts.begin(), mechanism.contacts.end(),
                     [](const Contact& contact) { return contact.keep == Keep::kGap; });
}

bool is_zero(const Mechanism& derivative, const Mechanism& mechanism, double change) {
  double largest = 0, changed = 0;
  for_each_number(mechanism, [&](double number) { largest = std::max(largest, std::abs(number)); });
  for_each_number(derivative, [&](double slope) { changed = std::max(changed, std::abs(slope) * change); });
  return changed <= kNoNumberChange * largest;
}

}  // namespace

NaturalScales natural_scales(const PathColumns& columns) {
  const DriverSchedule& schedule = columns.drivers().schedule();
  NaturalScales natural{columns.start().plan().size, columns.rate()};
  for (std::int64_t row = 0; row < schedule.size(); ++row) {
    for (std::size_t i = 0; i < schedule.driver_count(); ++i) {
      const double unit = driver_turns(columns.start().mechanism(), i) ? 1 : natural.size;
      natural.rate =
          std::max(natural.rate, std::sqrt(std::abs(schedule.state(row, i).si.acceleration) / unit));
    }
  }
  return natural;
}

Result<NumberModels> NumberModels::of(const Model& model, const ProfileNumber& number,
                                      const NaturalScales& natural) {
  return ModelVariants::of(model, number.number.paths).map([&](ModelVariants variants) {
    return NumberModels(std::move(variants), number.number.paths.size(), number.number.value,
                        scale_of(model, number, natural));
  });
}

Result<Model> NumberModels::at(double h) {
  const std::vector<double> values(paths_, value_ + h);
  return variants_.with(values);
}

Result<std::vector<std::unique_ptr<NumberModels>>> models_by(const Model& model,
                                                             const std::vector<ProfileNumber>& numbers,
                                                             const NaturalScales& natural) {
  std::vector<std::unique_ptr<NumberModels>> all;
  for (const ProfileNumber& number : numbers) {
    auto models = NumberModels::of(model, number, natural);
    if (!models) return tl::unexpected(std::move(models.error()));
    all.push_back(std::make_unique<NumberModels>(*std::move(models)));
  }
  return all;
}

bool has_exact_slope(const Column& column) {
  return !column.name.ends_with(".arc1") && !column.name.ends_with(".arc2");
}

NumberSlopes::NumberSlopes(const PathColumns& columns, NumberModels& models) : columns_(columns) {
  const Mechanism& mechanism = columns.start().mechanism();
  const auto derivative = mechanism_derivative(
      [&](double h) -> std::optional<Mechanism> {
        const auto model = models.at(h);
        return model ? std::optional(model->mechanism()) : std::nullopt;
      },
      models.scale());
  if (!derivative) {
    return;
  }
  step_ = derivative->step;
  const auto beside = models.at(step_);
  if (!beside || joints_differ(mechanism, beside->mechanism())) {
    return;
  }
  if (!find_drivers(models)) {
    return;
  }
  if (may_part(mechanism)) {
    return;
  }
  const bool same = !derivative->boundaries && is_zero(derivative->numbers, mechanism, step_);
  if (same && !drivers_change()) {
    state_ = State::kNoInfluence;
    return;
  }
  const DriverSlopes first = drivers_at({0, columns.path().path.knots.front()});
  std::vector<double> positions;
  for (const DriverState& driver : first.drivers) positions.push_back(driver.si.position);
  by_ = Sensitivity::at_start(columns.start(), *derivative, positions);
  state_ = by_ ? State::kExact : State::kOther;
}

// False where there is no schedule, or, with the state set, where the number of rows changes.
bool NumberSlopes::find_drivers(NumberModels& models) {
  const DriverSchedule& own = columns_.drivers().schedule();
  for (int k = -kReach; k <= kReach; ++k) {
    const auto model = models.at(k * step_);
    const auto schedule = model ? schedule_of(model->data(), columns_.settings())
                                : Result<DriverSchedule>(tl::unexpected(model.error()));
    if (!schedule) {
      return false;
    }
    if (schedule->size() != own.size()) {
      state_ = State::kRows;
      return false;
    }
    drivers_.emplace_back(model->profile(), *schedule);
  }
  return true;
}

bool NumberSlopes::drivers_change() const {
  const DriverSchedule& own = columns_.drivers().schedule();
  for (const std::int64_t row : {std::int64_t{0}, own.size() / 2, own.size() - 1}) {
    for (std::size_t i = 0; i < own.driver_count(); ++i) {
      for (const DriverPlaces& other : drivers_) {
        const DriverMotion a = own.state(row, i).si, b = other.schedule().state(row, i).si;
        if (a.position != b.position || a.velocity != b.velocity || a.acceleration != b.acceleration ||
            own.time(row) != other.schedule().time(row)) {
          return true;
        }
      }
    }
  }
  return false;
}

NumberSlopes::DriverSlopes NumberSlopes::drivers_at(const PathPlace& place) const {
  const auto slope = [&](auto number_of) {
    return eighth_order_difference(
        [&](double step) {
          const auto k = static_cast<std::size_t>(std::lround(step / step_) + kReach);
          return number_of(drivers_[k]);
        },
        step_);
  };
  DriverSlopes slopes;
  slopes.time = slope([&](const DriverPlaces& places) { return places.time(place); });
  for (std::size_t i = 0; i < drivers_.front().schedule().driver_count(); ++i) {
    DriverState state;
    const auto of = [&](auto part) {
      return slope([&](const DriverPlaces& places) { return part(places.at(place)[i]); });
    };
    for (auto member : {&DriverState::profile, &DriverState::si}) {
      (state.*member).position = of([&](const DriverState& s) { return (s.*member).position; });
      (state.*member).velocity = of([&](const DriverState& s) { return (s.*member).velocity; });
      (state.*member).acceleration = of([&](const DriverState& s) { return (s.*member).acceleration; });
    }
    for (std::size_t k = 0; k < state.higher_si.size(); ++k) {
      state.higher_si[k] = of([&](const DriverState& s) { return s.higher_si[k]; });
    }
    slopes.drivers.push_back(state);
  }
  return slopes;
}

RatesAsked rates_to_ask(const PathColumns& columns, const Run& run, const PathPlace& place) {
  return meets_change_point(run, motions_of(columns.drivers().at(place))) ? RatesAsked::kAll
                                                                          : RatesAsked::kRegular;
}

tl::expected<std::vector<SidedSlope>, NoSensitivity> NumberSlopes::at(const Run& run, const PathPlace& place,
                                                                      RatesAsked rates) const {
  const std::vector<DriverState> states = columns_.drivers().at(place);
  const double time = columns_.drivers().time(place);
  const DriverSlopes slopes = drivers_at(place);
  const auto of_row = by_->of_row(run, motions_of(states), motions_of(slopes.drivers), rates);
  if (!of_row) {
    return tl::unexpected(of_row.error());
  }
  Model::Data like = columns_.data();
  const auto displaced = [&](DriverMotion values, const DriverMotion& slope, double h) {
    return DriverMotion{values.position + h * slope.position, values.velocity + h * slope.velocity,
                        values.acceleration + h * slope.acceleration};
  };
  return slopes_along(run, *by_, *of_row, [&](const Run& other, double h) {
    std::vector<DriverState> drivers = states;
    for (std::size_t i = 0; i < drivers.size(); ++i) {
      drivers[i].profile = displaced(states[i].profile, slopes.drivers[i].profile, h);
      drivers[i].si = displaced(states[i].si, slopes.drivers[i].si, h);
      for (std::size_t k = 0; k < drivers[i].higher_si.size(); ++k) {
        drivers[i].higher_si[k] += h * slopes.drivers[i].higher_si[k];
      }
    }
    return columns_of_run(like, columns_.settings(), other, drivers, time + h * slopes.time);
  });
}

}  // namespace higherpair
