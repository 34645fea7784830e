#pragma once

#include <string>

// What the module higherpair-pictures exports. Both throw std::runtime_error if the picture cannot be
// converted.
extern "C" {

/// Appends an SVG picture as PDF, with 1 px = 1/96 inch.
void higherpair_pdf_of(const std::string& svg, std::string& pdf);
/// Appends an SVG picture as PNG, with two pixels per px.
void higherpair_png_of(const std::string& svg, std::string& png);
}
