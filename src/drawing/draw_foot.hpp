#pragma once

#include "higherpair/drawing/picture.hpp"
#include "svg_writer.hpp"

#include <span>
#include <string>
#include <vector>

namespace higherpair {

/// An arrow, given by its two ends in px: its line and its head.
void draw_arrow(SvgWriter& svg, std::span<const double> px, const std::string& style, const std::string& role,
                const std::string& name);

/// The foot of a picture: the scale of lengths, a scale for each kind of arrow drawn, and a caption.
class DrawFoot {
public:
  /// \param scale   of the picture [px/mm]
  /// \param width   of the whole picture [px]
  /// \param caption  at its right end
  DrawFoot(const Scene& scene, const DrawSettings& settings, const std::vector<Role>& layers, double scale,
           double width, const std::string& caption);

  [[nodiscard]] double height() const;  ///< [px]
  /// \param top  upper edge of the foot [px]
  void draw(SvgWriter& svg, double top) const;

private:
  struct Sample {
    std::string role;
    double length = 0;  // [px]
    double turn = 0;    // angle of the arc that is drawn instead of an arrow [rad]
    std::string text;
    double x = 0;
    int line = 0;
  };
  std::vector<Sample> samples_;
  std::string caption_;
  int caption_line_ = 0;
  double width_ = 0;

  void draw_sample(SvgWriter& svg, const Sample& sample, double y) const;
  void lay_out(double width);
};

}  // namespace higherpair
