#pragma once

#include "fit_data.hpp"

namespace higherpair {

/// The task of [fit], overridden by the settings where these are given. Here and below, errors are added to
/// `mistakes`.
[[nodiscard]] FitTask with_settings(FitTask task, const FitSettings& settings, Diagnostics& mistakes);

/// Applies the task's settings to columns, drivers and time: deviations, weights, unknown zeros.
void apply_columns(FitData& data, Diagnostics& mistakes);

/// Finds the columns of the points that were measured in frames of their own.
void find_frames(FitData& data, Diagnostics& mistakes);

/// Checks that there are at least as many values as unknowns. \param table  place of the values, for messages
void check_count(const FitData& data, const Place& table, Diagnostics& mistakes);

}  // namespace higherpair
