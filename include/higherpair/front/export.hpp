#pragma once

#include "higherpair/front/model.hpp"
#include "higherpair/geometry/boundary.hpp"

#include <optional>
#include <string>
#include <vector>

namespace higherpair {

/// Which curves of a model are exported, and what of them.
struct ExportSettings {
  enum class Path {
    kCurve,   ///< the curve itself
    kPitch,   ///< path of the centre of the roller that touches it in a contact of the profile
    kCutter,  ///< path of the centre of a round cutter that cuts it
  };

  std::vector<std::string> curves;  ///< "BODY.CURVE"
  std::string body;                 ///< all curves of this body; if both are empty: the only curve of the
                                    ///< model
  Path path = Path::kCurve;
  double cutter = 0;  ///< kCutter: radius [m], > 0
  /// How far unbounded lines and conics extend from their point or vertex [m]; > 0.
  std::optional<double> reach;
};

/// A curve to be written, in the frame of its body.
struct ExportedCurve {
  std::string name;  ///< "BODY.CURVE", followed by "-pitch" or "-cutter" for these paths
  Boundary boundary;
};

/// The curves in the order of the settings, or of the body. Fails (kInput) for a name that does not exist, an
/// unbounded curve without a reach, a point, a curve that no roller or rollers of different radii touch
/// (kPitch), and a cutter that is too large; the message says where, and how large it may be.
[[nodiscard]] Result<std::vector<ExportedCurve>> exported_curves(const Model& model,
                                                                 const ExportSettings& settings);

/// How closely the file follows the curve.
struct ExportAccuracy {
  /// Largest distance of arcs and lines (in CSV: of lines between its points) from the curve [m]; none:
  /// kDefaultExportTolerance times the size of each curve. At least 1e-9 times that size.
  std::optional<double> tolerance;
  std::optional<int> points;  ///< CSV only: this many points, equally spaced along the curve, instead; at
                              ///< least 2
};

inline constexpr double kDefaultExportTolerance = 1e-5;

/// \name A curve as text of a file
/// Lengths in the units' length. Fail if the accuracy cannot be reached (kInput).
/// @{

/// A row for each point: `x`, `y`, the outward unit normal `nx`, `ny`, the curvature, > 0 where the material
/// is convex, and the arc length `arc` from the first point, each column with its unit. A corner or notch has
/// two rows with the normals of both sides; the curvature of a corner is an empty field.
[[nodiscard]] Result<std::string> curve_csv(const Model& model, const ExportedCurve& curve,
                                            const ExportAccuracy& accuracy, const Units& units);

/// A DXF with a layer for each curve, named after it with a dash for the dot.
[[nodiscard]] Result<std::string> curves_dxf(const Model& model, const std::vector<ExportedCurve>& curves,
                                             const ExportAccuracy& accuracy, const Units& units);

/// An SVG picture at true size.
[[nodiscard]] Result<std::string> curves_svg(const Model& model, const std::vector<ExportedCurve>& curves,
                                             const ExportAccuracy& accuracy, const Units& units);
/// @}

}  // namespace higherpair
