#pragma once

#include "json_writer.hpp"
#include "report_data.hpp"

namespace higherpair {

/// Significant digits of places in the picture.
inline constexpr int kPlaceDigits = 8;

// Parts of the object that a report's page is made from: members of it, each with its key.

/// `scene`, `closed`, `count`, `places` and `moving`: shapes, and where they are in every row.
void write_scene(JsonWriter& json, const Model& model, const ReportData& data);

/// `polygons`: those of velocities, accelerations and forces in every row.
void write_polygons(JsonWriter& json, const Model& model, const ReportData& data);

/// `maps`: the configuration spaces of the contacts as pictures, and where in them every row is; none once
/// `stop` is true.
void write_maps(JsonWriter& json, const Model& model, const ReportData& data, const std::atomic<bool>* stop);

}  // namespace higherpair
