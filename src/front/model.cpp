#include "higherpair/front/model.hpp"

#include "higherpair/mechanism/boundaries.hpp"
#include "higherpair/mechanism/redimension.hpp"
#include "model_data.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

template <class Items, class Same>
bool alike(const Items& a, const Items& b, const Same& same) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

// The profile of a mechanism that was built, not read from text.
Profile profile_of(Mechanism mechanism, const Units& units, std::vector<DriverProgram> programs,
                   const std::string& name) {
  Profile profile;
  profile.mechanism = std::move(mechanism);
  profile.units = units;
  profile.programs = std::move(programs);
  profile.source = name;
  return profile;
}

// Whether two mechanisms differ in numbers only, so that they are solved in the same order.
bool same_structure(const Mechanism& a, const Mechanism& b) {
  const auto bodies = [](const Body& x, const Body& y) {
    return x.name == y.name && x.points.size() == y.points.size() && x.curves.size() == y.curves.size();
  };
  const auto joints = [](const Joint& x, const Joint& y) {
    return x.name == y.name && x.type == y.type && x.first == y.first && x.second == y.second &&
           x.carrier == y.carrier;
  };
  const auto contacts = [](const Contact& x, const Contact& y) {
    return x.name == y.name && x.first == y.first && x.second == y.second && x.rolling == y.rolling &&
           x.keep == y.keep && x.both_sides == y.both_sides;
  };
  const auto drivers = [](const Driver& x, const Driver& y) {
    return x.name == y.name && x.joint == y.joint;
  };
  return alike(a.bodies, b.bodies, bodies) && alike(a.joints, b.joints, joints) &&
         alike(a.contacts, b.contacts, contacts) && alike(a.drivers, b.drivers, drivers);
}

}  // namespace

std::shared_ptr<const Model::Data> planned(std::optional<ProfileDocument> document, Profile profile,
                                           const Model::Data* like) {
  auto data = std::make_shared<Model::Data>();
  data->document = std::move(document);
  data->profile = std::move(profile);
  set_travels(data->profile);
  use_boundaries(data->profile.mechanism);
  const Mechanism& mechanism = data->profile.mechanism;
  const bool known = like != nullptr && like->plan && same_structure(like->profile.mechanism, mechanism);
  data->plan = known ? plan_like(*like->plan, mechanism) : make_plan(mechanism);
  return data;
}

namespace {

Result<std::shared_ptr<const Model::Data>> read(const ProfileDocument& document,
                                                std::span<const std::string> overrides,
                                                const Model::Data* like) {
  auto changed = document.with(overrides);
  if (!changed) {
    return wrong(std::move(changed.error()));
  }
  auto profile = changed->read();
  if (!profile) {
    return wrong(std::move(profile.error()));
  }
  return planned(*std::move(changed), *std::move(profile), like);
}

Result<std::shared_ptr<const Model::Data>> read(const tl::expected<ProfileDocument, Diagnostics>& document,
                                                std::span<const std::string> overrides) {
  return document ? read(*document, overrides, nullptr) : wrong(document.error());
}

}  // namespace

RunModel run_model(const Model::Data& model) {
  const std::shared_ptr<const Model::Data> own = model.shared_from_this();
  return {{own, &own->profile.mechanism}, {own, &*own->plan}};
}

Error error_about(const Model::Data& model, ErrorKind kind, std::string message) {
  return {kind, {about(model.profile.source, std::move(message))}};
}

tl::unexpected<Error> wrong(const Model& model, std::string what) {
  return wrong(model.data(), std::move(what));
}

tl::unexpected<Error> wrong(const Model::Data& model, std::string what) {
  return wrong({about(model.profile.source, std::move(what))});
}

tl::unexpected<Error> wrong(Place place, std::string what) {
  return wrong({{std::move(place), std::move(what)}});
}

tl::unexpected<Error> wrong(Diagnostics mistakes) {
  return tl::unexpected(Error{ErrorKind::kInput, std::move(mistakes)});
}

Setting::Setting(std::string path_of_key, double number)
    : path(std::move(path_of_key)), value(fmt::format("{}", number)) {}

Result<Model> Model::open(const std::string& path, std::span<const std::string> overrides) {
  return read(ProfileDocument::open(path), overrides).map([](auto data) { return Model(std::move(data)); });
}

Result<Model> Model::from_text(std::string_view text, const std::string& name,
                               std::span<const std::string> overrides) {
  return read(ProfileDocument::parse(text, name), overrides).map([](auto data) {
    return Model(std::move(data));
  });
}

Result<Model> Model::from(Mechanism mechanism, const Units& units, std::vector<DriverProgram> programs) {
  const std::string name = mechanism.title.empty() ? "mechanism" : mechanism.title;
  undo_boundaries(mechanism);
  if (std::string fault = fault_of(mechanism); !fault.empty()) {
    return wrong({about(name, std::move(fault))});
  }
  if (std::string fault = fault_of(units); !fault.empty()) {
    return wrong({about(name, std::move(fault))});
  }
  if (programs.empty()) {
    for (const Driver& driver : mechanism.drivers) {
      programs.push_back(default_program(mechanism, driver, units));
    }
  }
  if (std::string fault = fault_of(programs, mechanism, units); !fault.empty()) {
    return wrong({about(name, std::move(fault))});
  }
  for (DriverProgram& program : programs) {
    program.place.source = name;
  }
  return Model(
      planned(std::nullopt, profile_of(std::move(mechanism), units, std::move(programs), name), nullptr));
}

Result<Model> Model::with(std::span<const Setting> settings) const {
  if (!data_->document) {
    return wrong(*data_, std::string(kNoKeys));
  }
  std::vector<std::string> overrides;
  for (const Setting& setting : settings) {
    overrides.push_back(fmt::format("{}={}", setting.path, setting.value));
  }
  return read(*data_->document, overrides, data_.get()).map([](auto data) { return Model(std::move(data)); });
}

Result<Model> Model::with_mechanism(Mechanism mechanism) const {
  undo_boundaries(mechanism);
  std::string fault = fault_of(mechanism);
  if (fault.empty() && mechanism.drivers.size() != data_->profile.programs.size()) {
    fault = fmt::format("{} drivers instead of {}: what they do would not be known", mechanism.drivers.size(),
                        data_->profile.programs.size());
  }
  if (fault.empty()) {
    fault = fault_of(data_->profile.programs, mechanism, data_->profile.units);
  }
  if (!fault.empty()) {
    return wrong(*data_, std::move(fault));
  }
  Profile profile =
      profile_of(std::move(mechanism), data_->profile.units, data_->profile.programs, data_->profile.source);
  use_boundaries(profile.mechanism);
  if (same_structure(data_->profile.mechanism, profile.mechanism)) {
    profile.limits = data_->profile.limits;
  }
  return Model(planned(std::nullopt, std::move(profile), data_.get()));
}

std::vector<Parameter> Model::parameters() const {
  std::vector<Parameter> parameters;
  if (!data_->document) {
    return parameters;
  }
  std::set<std::string, std::less<>> plain;
  data_->document->for_each_number([&](const std::string& path, double value) {
    parameters.push_back({path, value});
    plain.insert(path);
  });
  for (const ProfileDocument::Quantity& quantity : data_->document->quantities()) {
    if (!plain.contains(quantity.path)) parameters.push_back({quantity.path, quantity.value});
  }
  return parameters;
}

const Profile& Model::profile() const {
  return data_->profile;
}

Result<Motion> Model::run(const RunSettings& settings) const {
  return start(settings).map([](Analysis analysis) { return Motion(std::move(analysis)); });
}

}  // namespace higherpair
