#pragma once

#include "higherpair/analysis/boundary_derivatives.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/design_task.hpp"
#include "model_data.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace higherpair {

/// Whether no curve of any body is one of several parts: chains, splines, flanks and the like.
[[nodiscard]] bool has_whole_curves(const Mechanism& mechanism);

/// From the variables of a design to the mechanism. Where every number of the mechanism is a linear function
/// of them, as of the coordinates of points, lengths and radii, it is worked out so; else the profile is read
/// anew.
class DesignNumbers {
public:
  /// \pre the task is of the model's profile, and every variable at its start is a mechanism
  DesignNumbers(Model model, const DesignTask& task);

  /// What the profile is with these numbers; none where it has a mistake with them.
  [[nodiscard]] std::shared_ptr<const Model::Data> data_of(std::span<const double> x) const;
  /// The same read as any profile is, for messages.
  [[nodiscard]] Result<Model> model_of(std::span<const double> x) const;

  [[nodiscard]] bool is_linear() const { return linear_; }
  /// The derivative of the mechanism by a variable; none where it is not smooth there, or the drivers depend
  /// on the variable.
  [[nodiscard]] std::optional<MechanismDerivative> derivative(std::size_t variable,
                                                              std::span<const double> x) const;
  /// A change of a variable that makes another mechanism.
  [[nodiscard]] double scale(std::size_t variable) const;
  /// Where is_linear: the mechanism alone.
  [[nodiscard]] Mechanism mechanism_of(std::span<const double> x) const;
  /// Where is_linear, in the order of for_each_number: its numbers, and their derivatives.
  void fill_numbers(std::span<const double> x, std::vector<double>& numbers) const;
  [[nodiscard]] std::span<const double> slopes(std::size_t variable) const { return slopes_[variable]; }

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const DesignTask& task() const { return *task_; }

private:
  [[nodiscard]] Mechanism linear_derivative(std::size_t variable) const;
  [[nodiscard]] std::vector<Setting> settings_of(std::span<const double> x) const;
  [[nodiscard]] Result<ModelVariants> variants() const;
  [[nodiscard]] std::vector<double> values_of(std::span<const double> x) const;
  [[nodiscard]] bool find_slopes();
  [[nodiscard]] std::optional<std::vector<double>> numbers_at(std::span<const double> x) const;

  Model model_;
  const DesignTask* task_;
  bool linear_ = false;
  std::vector<double> start_, base_;               // of the variables, and the mechanism's numbers there
  std::vector<std::vector<double>> slopes_;        // of those, by each variable
  std::vector<std::vector<std::size_t>> changed_;  // the numbers whose slopes are not 0
};

}  // namespace higherpair
