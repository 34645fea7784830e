#pragma once

#include "front/model_data.hpp"
#include "higherpair/analysis/boundary_derivatives.hpp"
#include "higherpair/front/model.hpp"
#include "higherpair/io/design_task.hpp"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// Whether no body has a curve made of parts, such as a chain, a spline or a flank.
[[nodiscard]] bool has_whole_curves(const Mechanism& mechanism);

/// Whether the drivers move alike.
[[nodiscard]] bool same_programs(const std::vector<DriverProgram>& a, const std::vector<DriverProgram>& b);

/// The values of the variables in the profile.
[[nodiscard]] std::vector<double> start_values(const DesignTask& task);

/// Maps the variables of a design to the mechanism. If every number of the mechanism is a linear function of
/// the variables, as with coordinates of points, lengths and radii, it is computed from them; otherwise the
/// profile is read again.
class DesignNumbers {
public:
  /// \pre the task belongs to the model's profile, and the start values of the variables give a mechanism
  DesignNumbers(Model model, const DesignTask& task);

  /// The model with these values of the variables; null where the profile is invalid with them.
  [[nodiscard]] std::shared_ptr<const Model::Data> data_of(std::span<const double> x) const;
  /// The same by reading the profile, which gives error messages.
  [[nodiscard]] Result<Model> model_of(std::span<const double> x) const;

  [[nodiscard]] bool is_linear() const { return linear_; }
  /// The derivative of the mechanism by a variable; none where it is not smooth there, or where the drivers
  /// depend on the variable.
  [[nodiscard]] std::optional<MechanismDerivative> derivative(std::size_t variable,
                                                              std::span<const double> x) const;
  /// The size of change of a variable that makes a substantially different mechanism.
  [[nodiscard]] double scale(std::size_t variable) const;
  /// The mechanism alone. \pre is_linear
  [[nodiscard]] Mechanism mechanism_of(std::span<const double> x) const;
  /// The mechanism's numbers in the order of for_each_number, and their derivatives. \pre is_linear
  void fill_numbers(std::span<const double> x, std::vector<double>& numbers) const;
  [[nodiscard]] std::span<const double> slopes(std::size_t variable) const { return slopes_[variable]; }

  /// The paths of all variables in the profile, one after the other, and the numbers there.
  [[nodiscard]] std::vector<std::string> paths() const;
  [[nodiscard]] std::vector<double> values_of(std::span<const double> x) const;

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const DesignTask& task() const { return *task_; }

private:
  [[nodiscard]] Mechanism linear_derivative(std::size_t variable) const;
  [[nodiscard]] Result<ModelVariants> variants() const;
  [[nodiscard]] bool find_slopes();
  [[nodiscard]] std::optional<std::vector<double>> numbers_at(std::span<const double> x) const;

  Model model_;
  const DesignTask* task_;
  bool linear_ = false;
  std::vector<double> start_, base_;               // of the variables; the mechanism's numbers there
  std::vector<std::vector<double>> slopes_;        // derivatives of those numbers by each variable
  std::vector<std::vector<std::size_t>> changed_;  // for each variable: numbers with nonzero slope
};

}  // namespace higherpair
