#pragma once

#include "higherpair/front/motion.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/profile.hpp"

#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace higherpair {

/// The version of the library, as "1.2.3".
[[nodiscard]] std::string_view version();

/// A key of a profile and its new value: `path` as of the option --set
/// ("bodies.cam.curves.disc.radius"; items of lists by number from 0, "bodies.crank.points.A.0"), a number in
/// the profile's units, or TOML text ("25.4 mm").
struct Setting {
  Setting(std::string path_of_key, double number);
  Setting(std::string path_of_key, std::string text) : path(std::move(path_of_key)), value(std::move(text)) {}

  std::string path;
  std::string value;
};

/// A number of a profile that a Setting can change.
struct Parameter {
  std::string path;
  double value = 0;  ///< in the profile's units; as written, if it has no unit of its own
};

/// A mechanism that can be analysed: its description, units and drivers, and the order in which it is solved.
/// Immutable and cheap to copy; any number of threads may analyse one model at once.
class Model {
public:
  /// Reads a profile from a file; the error holds all semantic mistakes, but only the first syntax error.
  /// \param overrides  "PATH=VALUE" each, as of the option --set
  [[nodiscard]] static Result<Model> open(const std::string& path,
                                          std::span<const std::string> overrides = {});

  /// The same for a text, UTF-8.
  /// \param name  its name in messages
  [[nodiscard]] static Result<Model> from_text(std::string_view text, const std::string& name = "profile",
                                               std::span<const std::string> overrides = {});

  /// A mechanism built in C++, for example with the functions of mechanism/description.hpp. Fails if an index
  /// refers to nothing, a name is missing, illegal or not unique among its kind, or a number is not finite,
  /// beyond kLargestQuantity, or not as its member says (a unit vector, > 0); the message names it.
  /// \param units     of columns and of `programs`; the mechanism itself is in SI units and radians
  /// \param programs  the motion of each driver; empty: default_program for each
  [[nodiscard]] static Result<Model> from(Mechanism mechanism, const Units& units = {},
                                          std::vector<DriverProgram> programs = {});

  /// The same model with other numbers or keys. If only numbers differ, the order of solution is reused with
  /// the new dimensions. Fails for a model built in C++, for which there is with_mechanism().
  [[nodiscard]] Result<Model> with(std::span<const Setting> settings) const;
  [[nodiscard]] Result<Model> with(std::initializer_list<Setting> settings) const {
    return with(std::span(settings.begin(), settings.size()));
  }

  /// The same units and drivers with another mechanism, such as mechanism() with other dimensions or curves.
  /// What a Model sets in a description is made anew. It counts as built in C++: no text with keys belongs to
  /// it.
  [[nodiscard]] Result<Model> with_mechanism(Mechanism mechanism) const;

  /// Every number of the profile: in the order of the file those without a unit of their own, then those with
  /// one ("20 mm"). None for a model built in C++.
  [[nodiscard]] std::vector<Parameter> parameters() const;

  [[nodiscard]] const Profile& profile() const;
  [[nodiscard]] const Mechanism& mechanism() const { return profile().mechanism; }
  [[nodiscard]] const Units& units() const { return profile().units; }
  /// Notes on what is valid in the profile but probably a slip.
  [[nodiscard]] const Diagnostics& notes() const { return profile().notes; }

  /// Runs this model at the drivers' positions, or in time: run() computes all rows, start() lets them be
  /// taken one after the other. Fails for invalid settings (kInput) and for a mechanism that cannot be
  /// started (kMechanism). A run that is stopped before its first row has none, and says that it was stopped.
  [[nodiscard]] Result<Motion> run(const RunSettings& settings = {}) const;
  [[nodiscard]] Result<Analysis> start(const RunSettings& settings = {}) const;

  struct Data;
  /// For the library's own use; not part of the stable interface.
  [[nodiscard]] const Data& data() const { return *data_; }

private:
  friend class ModelVariants;
  explicit Model(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  std::shared_ptr<const Data> data_;
};

/// Makes many variants of one model that differ in numbers: a fast Model::with for loops. No text is parsed
/// again. The variants have no notes, and of the tasks [sweep], [design] and [tolerances] only those that a
/// path leads into; they count as built in C++, so that their own with() fails and parameters() is empty. One
/// thread at a time may use it; the models that it makes are independent of it.
class ModelVariants {
public:
  /// \param paths  of numbers that the profile has, as in a Setting. Fails for one that leads to no
  ///               number, and for a model built in C++
  [[nodiscard]] static Result<ModelVariants> of(const Model& model, std::span<const std::string> paths);
  ModelVariants(ModelVariants&& other) noexcept;
  ModelVariants& operator=(ModelVariants&& other) noexcept;
  ~ModelVariants();

  /// The model with these numbers, in the profile's units, at the paths, one each. Fails if the profile would
  /// be invalid.
  [[nodiscard]] Result<Model> with(std::span<const double> values);

private:
  struct Impl;
  explicit ModelVariants(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace higherpair
