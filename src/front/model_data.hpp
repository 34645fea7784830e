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

#include <tl/expected.hpp>

namespace higherpair {

/// What a model holds; shared by its copies and by all that runs on it.
struct Model::Data : std::enable_shared_from_this<Model::Data> {
  std::string name;  ///< of the file or text, for messages
  /// What the profile was read from; none of a model that was built.
  std::optional<ProfileDocument> document;
  Profile profile;
  tl::expected<Plan, std::string> plan =
      tl::unexpected(std::string());  ///< or why the mechanism has none: only `mobility` is left then
};

/// A profile with its plan: that of `like` with other dimensions where only numbers differ; may be null.
[[nodiscard]] std::shared_ptr<const Model::Data> planned(std::string name,
                                                         std::optional<ProfileDocument> document,
                                                         Profile profile, const Model::Data* like);

/// What runs of a model share: its own mechanism and plan. The model must have a plan.
[[nodiscard]] RunModel run_model(const Model::Data& model);

/// An error of one diagnostic about the model as a whole.
[[nodiscard]] Error error_about(const Model::Data& model, ErrorKind kind, std::string message);

/// The same of what a user has asked of a model; then of what stands at a place, and of several mistakes.
[[nodiscard]] tl::unexpected<Error> wrong(const Model& model, std::string what);
[[nodiscard]] tl::unexpected<Error> wrong(const Model::Data& model, std::string what);
[[nodiscard]] tl::unexpected<Error> wrong(Place place, std::string what);
[[nodiscard]] tl::unexpected<Error> wrong(Diagnostics mistakes);

/// The rows of `analyze`, of which the first counts. Fails where the mechanism has no driver.
[[nodiscard]] Result<DriverSchedule> first_schedule(const Model::Data& model);

/// What is wrong with a mechanism that a program has built, as "joints.guide.first.point = 3: …"; empty if
/// nothing is.
[[nodiscard]] std::string fault_of(const Mechanism& mechanism);

}  // namespace higherpair
