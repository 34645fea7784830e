#pragma once

#include "fit_data.hpp"

namespace higherpair {

/// [fit] with what the settings have in the place of its keys. Mistakes are added to `mistakes`, here and
/// below.
[[nodiscard]] FitTask with_settings(FitTask task, const FitSettings& settings, Diagnostics& mistakes);

/// Gives columns, drivers and time what the task says of them: deviations, weights, unknown zeros.
void apply_columns(FitData& data, Diagnostics& mistakes);

/// Finds the columns of points that were measured in frames of their own.
void find_frames(FitData& data, Diagnostics& mistakes);

/// Whether there are as many values as numbers are looked for. \param table  what has the values
void check_count(const FitData& data, const Place& table, Diagnostics& mistakes);

}  // namespace higherpair
