#pragma once

#include "higherpair/front/model.hpp"

#include <string>
#include <vector>

namespace higherpair::cli {

/// The unit of the first driver's position.
[[nodiscard]] std::string driver_unit(const Model& model);

/// Events as CSV, and each as a line of text.
[[nodiscard]] std::string events_csv(const std::vector<Event>& events, const Model& model);
[[nodiscard]] std::vector<std::string> event_lines(const std::vector<Event>& events, const Model& model);

/// Prints the events of a path on standard error.
void print_events(const std::vector<Event>& events, const Model& model);
/// Prints on standard error the events passed before the position drawn, if there are any.
void print_passed(const std::vector<Event>& passed, const Model& model);

}  // namespace higherpair::cli
