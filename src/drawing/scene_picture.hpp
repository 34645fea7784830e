#pragma once

#include "higherpair/drawing/picture.hpp"
#include "labels.hpp"
#include "svg_writer.hpp"

#include <vector>

namespace higherpair {

/// Maps millimetres of the mechanism to px.
struct Screen {
  double scale = 1;  ///< [px/mm]
  Vector2d origin;   ///< position of ground's origin [px]

  [[nodiscard]] Vector2d operator()(const Vector2d& p_mm) const {
    return {origin.x() + scale * p_mm.x(), origin.y() - scale * p_mm.y()};
  }
};

/// Draws scenes of one mechanism into a picture.
class ScenePicture {
public:
  /// All arguments must outlive this. \param length  unit of the lengths in labels
  ScenePicture(SvgWriter& svg, const Screen& screen, const std::vector<Role>& layers,
               const PictureUnit& length)
      : svg_(svg), screen_(screen), layers_(layers), length_(length) {}

  /// \param ghost  the outlines alone of what moves, without labels
  void draw(const Scene& scene, bool ghost);
  /// Marks points of ground [mm].
  void draw_targets(const std::vector<Vector2d>& targets);
  /// Draws the labels of the scenes drawn, clear of their lines. \param size  of the picture [px]
  void draw_labels(const Vector2d& size);

private:
  [[nodiscard]] bool is_shown(const Shape& shape, bool ghost) const;
  void draw(const Scene& scene, const Shape& shape, bool ghost);
  void add_label(const Shape& shape, const std::vector<double>& px);
  void add_ink(const Shape& shape, std::vector<double> px);

  SvgWriter& svg_;
  const Screen& screen_;
  const std::vector<Role>& layers_;
  const PictureUnit& length_;
  std::vector<Label> labels_;
  std::vector<Vector2d> ink_;  // points on the lines drawn [px]
};

}  // namespace higherpair
