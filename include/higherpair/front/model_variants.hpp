#pragma once

#include "higherpair/front/model.hpp"

#include <memory>
#include <span>
#include <string>

namespace higherpair {

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
