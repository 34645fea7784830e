#include "higherpair/front/model.hpp"
#include "higherpair/io/profile_variants.hpp"
#include "model_data.hpp"

#include <string>
#include <utility>

#include <fmt/core.h>

namespace higherpair {

struct ModelVariants::Impl {
  Model like;  // whose plan is used again
  ProfileVariants profiles;
  std::size_t paths;
};

ModelVariants::ModelVariants(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ModelVariants::ModelVariants(ModelVariants&& other) noexcept = default;
ModelVariants& ModelVariants::operator=(ModelVariants&& other) noexcept = default;
ModelVariants::~ModelVariants() = default;

Result<ModelVariants> ModelVariants::of(const Model& model, std::span<const std::string> paths) {
  if (!model.data().document) {
    return wrong(model, std::string(kNoKeys));
  }
  auto profiles = ProfileVariants::of(*model.data().document, paths);
  if (!profiles) {
    return wrong(std::move(profiles.error()));
  }
  return ModelVariants(std::make_unique<Impl>(Impl{model, *std::move(profiles), paths.size()}));
}

Result<Model> ModelVariants::with(std::span<const double> values) {
  if (values.size() != impl_->paths) {
    return wrong(impl_->like,
                 fmt::format("{} values for {} paths: each path needs its own", values.size(), impl_->paths));
  }
  auto profile = impl_->profiles.read(values);
  if (!profile) {
    return wrong(std::move(profile.error()));
  }
  const Model::Data& like = impl_->like.data();
  return Model(planned(std::nullopt, *std::move(profile), &like));
}

}  // namespace higherpair
