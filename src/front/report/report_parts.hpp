#pragma once

#include "json_writer.hpp"
#include "report_data.hpp"

namespace higherpair {

/// Significant digits of positions in the picture.
inline constexpr int kPlaceDigits = 8;

// Parts of the JSON object that a report's page is made from: each writes members of it, with their keys.

/// `scene`, `lengthPerUnit`, `joints`, `closed`, `count`, `places` and `moving`: shapes, and their positions
/// in every row, in a unit of length of which some hundred are across the picture.
void write_scene(JsonWriter& json, const Model& model, const ReportData& data);

/// `polygons`: those of velocities, accelerations and forces in every row.
void write_polygons(JsonWriter& json, const Model& model, const ReportData& data);

/// `maps`: the configuration spaces of the contacts as pictures, and the position of every row in them; empty
/// once `stop` is true.
void write_maps(JsonWriter& json, const Model& model, const ReportData& data, const std::atomic<bool>* stop);

}  // namespace higherpair
