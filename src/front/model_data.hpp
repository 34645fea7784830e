#pragma once

#include "higherpair/analysis/run.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile.hpp"
#include "higherpair/io/profile_document.hpp"
#include "higherpair/mechanism/plan.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

/// The contents of a model; shared by its copies and by everything that runs on it.
struct Model::Data : std::enable_shared_from_this<Model::Data> {
  /// What the profile was read from; none for a model that was built in C++.
  std::optional<ProfileDocument> document;
  Profile profile;
  tl::expected<Plan, std::string> plan =
      tl::unexpected(std::string());  ///< or the reason why there is none: only `mobility` is possible then
};

/// A profile with its plan: the plan of `like` with other dimensions if only numbers differ, else a new one.
/// `like` may be null.
[[nodiscard]] std::shared_ptr<const Model::Data> planned(std::optional<ProfileDocument> document,
                                                         Profile profile, const Model::Data* like);

/// What all runs of a model share: its mechanism and plan. \pre the model has a plan
[[nodiscard]] RunModel run_model(const Model::Data& model);

/// Why a model has no keys to be set.
inline constexpr std::string_view kNoKeys =
    "was built, or made by ModelVariants or with_mechanism(), and has no keys to set: change a copy of its "
    "mechanism()";

/// An error of one diagnostic about the model as a whole.
[[nodiscard]] Error error_about(const Model::Data& model, ErrorKind kind, std::string message);

/// The same for errors in what a user asked of a model; then for what is written at a place, and for several
/// errors.
[[nodiscard]] tl::unexpected<Error> wrong(const Model& model, std::string what);
[[nodiscard]] tl::unexpected<Error> wrong(const Model::Data& model, std::string what);
[[nodiscard]] tl::unexpected<Error> wrong(Place place, std::string what);
[[nodiscard]] tl::unexpected<Error> wrong(Diagnostics mistakes);

/// The schedule of the rows of `analyze`; its first row is the start. Fails where the mechanism has no
/// driver.
[[nodiscard]] Result<DriverSchedule> first_schedule(const Model::Data& model);

/// Sets Driver::travel of every driver that slides, from the rows of `analyze`.
void set_travels(Profile& profile);

/// The first error in a mechanism that was built by a program, as "joints.guide.first.point = 3: …"; empty if
/// there is none.
[[nodiscard]] std::string fault_of(const Mechanism& mechanism);

/// The same in the motions of its drivers, one each, as "driver.velocity = nan: …". \pre the mechanism has no
/// fault
[[nodiscard]] std::string fault_of(const std::vector<DriverProgram>& programs, const Mechanism& mechanism,
                                   const Units& units);

/// The first of the units that is one of another quantity, as "Units::angle = m: …"; empty if there is none.
[[nodiscard]] std::string fault_of(const Units& units);

/// What is wrong with the values of a span, looked at in a few places: "its values must be finite"; empty if
/// nothing is.
[[nodiscard]] std::string fault_of(const Span& span);

}  // namespace higherpair
