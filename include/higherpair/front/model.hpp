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
  double value = 0;  ///< as written
};

/// A mechanism that can be analysed: its description, units and drivers, and the order in which it is solved.
/// Never changes once made; cheap to copy; any number of threads may analyse one model at once.
class Model {
public:
  /// Reads a profile from a file; all mistakes of meaning are in the error, of syntax the first.
  /// \param overrides  "PATH=VALUE" each, as of the option --set
  [[nodiscard]] static Result<Model> open(const std::string& path,
                                          std::span<const std::string> overrides = {});

  /// The same for a text, UTF-8.
  /// \param name  what messages call it
  [[nodiscard]] static Result<Model> from_text(std::string_view text, const std::string& name = "profile",
                                               std::span<const std::string> overrides = {});

  /// A mechanism built in C++ (mechanism/build.hpp helps). Fails where an index refers to nothing or a number
  /// is not finite; the message names it.
  /// \param units     of columns and of `programs`; the mechanism itself is in SI units and radians
  /// \param programs  what each driver does; empty: default_program for each
  [[nodiscard]] static Result<Model> from(Mechanism mechanism, const Units& units = {},
                                          std::vector<DriverProgram> programs = {});

  /// The same model with other numbers or keys. Where only numbers differ the order of solution is kept and
  /// its dimensions are filled in anew. For models that were read; with_mechanism() is for
  /// those that were built.
  [[nodiscard]] Result<Model> with(std::span<const Setting> settings) const;
  [[nodiscard]] Result<Model> with(std::initializer_list<Setting> settings) const {
    return with(std::span(settings.begin(), settings.size()));
  }

  /// The same units and drivers with another mechanism, such as mechanism() with other dimensions.
  [[nodiscard]] Result<Model> with_mechanism(Mechanism mechanism) const;

  /// Every number of the profile, in the order of the file; none of a model that was built.
  [[nodiscard]] std::vector<Parameter> parameters() const;

  [[nodiscard]] const Profile& profile() const;
  [[nodiscard]] const Mechanism& mechanism() const { return profile().mechanism; }
  [[nodiscard]] const Units& units() const { return profile().units; }
  /// What in the profile is probably a slip although it may be meant.
  [[nodiscard]] const Diagnostics& notes() const { return profile().notes; }

  /// The run of this model at the drivers' positions, or in time: all rows at once, or one after the other.
  /// Fails for settings that are wrong (kInput), a mechanism that cannot be started (kMechanism), and where
  /// it is stopped before the first row.
  [[nodiscard]] Result<Motion> run(const RunSettings& settings = {}) const;
  [[nodiscard]] Result<Analysis> start(const RunSettings& settings = {}) const;

  struct Data;
  /// For the library itself; no part of what stays the same from version to version.
  [[nodiscard]] const Data& data() const { return *data_; }

private:
  friend class ModelVariants;
  explicit Model(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

  std::shared_ptr<const Data> data_;
};

/// One model again and again with other numbers: Model::with for loops of many variants. No text is taken
/// apart, and nothing is noted that may be a slip. One thread at a time may use it; models that it has made
/// are independent of it.
class ModelVariants {
public:
  /// \param paths  of numbers of the profile, as of a Setting. Fails for one that leads to none, and for a
  ///               model that was built
  [[nodiscard]] static Result<ModelVariants> of(const Model& model, std::span<const std::string> paths);
  ModelVariants(ModelVariants&& other) noexcept;
  ModelVariants& operator=(ModelVariants&& other) noexcept;
  ~ModelVariants();

  /// The model with these numbers, in the profile's units, at the paths. Fails where the profile would be
  /// wrong.
  [[nodiscard]] Result<Model> with(std::span<const double> values);

private:
  struct Impl;
  explicit ModelVariants(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace higherpair
