#pragma once

#include "higherpair/drawing/xml.hpp"

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace higherpair {

/// A number in SVG notation: at most 5 decimals, no trailing zeros, never an exponent.
/// \pre  finite
[[nodiscard]] std::string svg_number(double value);

/// A width that a picture can have, near the one that was asked for [px].
[[nodiscard]] inline double picture_width(double asked) {
  return asked > 200 ? std::min(asked, 1e5) : 200;
}

/// The `d` of a path, in px.
class SvgPath {
public:
  SvgPath& move_to(double x, double y);
  SvgPath& line_to(double x, double y);
  /// A circular arc to x, y.
  /// \param sweep  clockwise as seen on the screen
  SvgPath& arc_to(double radius, bool large, bool sweep, double x, double y);
  SvgPath& close();

  /// Adds lines through x, y, x, y, …; separate pieces are divided by a pair of NaN.
  SvgPath& polyline(std::span<const double> xy, bool closed = false);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool empty() const { return text_.empty(); }

private:
  SvgPath& add(char command, std::initializer_list<double> numbers);

  std::string text_;
};

/// An attribute of an element; its value is formatted and escaped here. An attribute with an empty value is
/// omitted.
struct SvgAttribute {
  SvgAttribute(std::string_view name_of_it, double number) : name(name_of_it), value(svg_number(number)) {}
  SvgAttribute(std::string_view name_of_it, std::string_view text)
      : name(name_of_it), value(xml_escaped(text)) {}
  SvgAttribute(std::string_view name_of_it, const SvgPath& path) : name(name_of_it), value(path.text()) {}

  std::string_view name;  ///< refers to the caller's text
  std::string value;
};

/// Writes one SVG picture as text, element by element, in px. The result is well-formed XML whatever the
/// texts contain; elements that are still open at the end are closed.
///
///     SvgWriter svg({.width = 200, .height = 100, .title = "A cam", .style = ".body { fill: #ddd; }"});
///     svg.open("g", {{"data-role", "body"}, {"data-name", name}});
///     svg.element("circle", {{"cx", 50}, {"cy", 50}, {"r", 20}});
///     svg.close();
///     svg.text({{"x", 50}, {"y", 90}}, "r = 20 mm");
///     const std::string file = std::move(svg).finish();
class SvgWriter {
public:
  using Attributes = std::initializer_list<SvgAttribute>;

  struct Header {
    double width = 0;   ///< [px]
    double height = 0;  ///< [px]
    std::string title;  ///< read aloud by screen readers; not drawn
    std::string style;  ///< CSS of the whole picture
  };

  /// \param more  attributes of the top element
  explicit SvgWriter(const Header& header, Attributes more = {});

  void open(std::string_view name, Attributes attributes = {});  ///< needs a close()
  void close();                                                  ///< closes the element opened last
  void element(std::string_view name, Attributes attributes);    ///< without content
  /// An element whose only content is text.
  void element(std::string_view name, Attributes attributes, std::string_view content);
  void text(Attributes attributes, std::string_view content) { element("text", attributes, content); }

  /// A piece of a text, with its own font size [px].
  struct Run {
    std::string text;
    double down = 0;  ///< from the baseline of the text
    double size = 12;
    double apart = 0;  ///< from the run before
  };
  void text(Attributes attributes, const std::vector<Run>& runs);

  [[nodiscard]] std::string finish() &&;

private:
  void begin_tag(std::string_view name, Attributes attributes);

  std::string out_;
  std::vector<std::string> open_;
};

}  // namespace higherpair
