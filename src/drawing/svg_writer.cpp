#include "svg_writer.hpp"

#include <cassert>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {

std::string svg_number(double value) {
  assert(std::isfinite(value));
  constexpr int kDecimals = 5;
  char text[400];  // the largest double has 309 digits before the point
  char* end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, kDecimals).ptr;
  while (*(end - 1) == '0') {
    --end;
  }
  if (*(end - 1) == '.') {
    --end;
  }
  const std::string_view number(text, static_cast<std::size_t>(end - text));
  return std::string(number == "-0" ? "0" : number);
}

std::string xml_escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        const bool allowed = static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n';
        out += allowed ? std::string_view(&c, 1) : "\xEF\xBF\xBD";
    }
  }
  return out;
}

SvgPath& SvgPath::add(char command, std::initializer_list<double> numbers) {
  text_ += command;
  const char* separator = "";
  for (const double number : numbers) {
    text_ += separator;
    text_ += svg_number(number);
    separator = " ";
  }
  return *this;
}

SvgPath& SvgPath::move_to(double x, double y) {
  return add('M', {x, y});
}

SvgPath& SvgPath::line_to(double x, double y) {
  return add('L', {x, y});
}

SvgPath& SvgPath::arc_to(double radius, bool large, bool sweep, double x, double y) {
  return add('A', {radius, radius, 0, large ? 1.0 : 0.0, sweep ? 1.0 : 0.0, x, y});
}

SvgPath& SvgPath::close() {
  text_ += 'Z';
  return *this;
}

SvgPath& SvgPath::polyline(std::span<const double> xy, bool closed) {
  bool begun = false;
  for (std::size_t i = 0; i + 1 < xy.size(); i += 2) {
    if (std::isnan(xy[i]) || std::isnan(xy[i + 1])) {
      if (begun && closed) close();
      begun = false;
    } else {
      add(begun ? 'L' : 'M', {xy[i], xy[i + 1]});
      begun = true;
    }
  }
  if (begun && closed) close();
  return *this;
}

SvgWriter::SvgWriter(const Header& header, Attributes more) {
  const std::string width = svg_number(header.width);
  const std::string height = svg_number(header.height);
  out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  out_ += fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{0}" height="{1}" viewBox="0 0 {0} {1}")",
      width, height);
  for (const SvgAttribute& attribute : more) {
    out_ += fmt::format(R"( {}="{}")", attribute.name, attribute.value);
  }
  out_ += ">\n";
  open_.emplace_back("svg");
  element("title", {}, header.title);
  if (!header.style.empty()) {
    element("style", {}, header.style);
  }
}

void SvgWriter::begin_tag(std::string_view name, Attributes attributes) {
  (out_ += '<') += name;
  for (const SvgAttribute& attribute : attributes) {
    if (attribute.value.empty()) continue;
    (((out_ += ' ') += attribute.name) += "=\"") += attribute.value;
    out_ += '"';
  }
}

void SvgWriter::open(std::string_view name, Attributes attributes) {
  begin_tag(name, attributes);
  out_ += ">\n";
  open_.emplace_back(name);
}

void SvgWriter::close() {
  assert(open_.size() > 1);
  out_ += fmt::format("</{}>\n", open_.back());
  open_.pop_back();
}

void SvgWriter::element(std::string_view name, Attributes attributes) {
  begin_tag(name, attributes);
  out_ += "/>\n";
}

void SvgWriter::element(std::string_view name, Attributes attributes, std::string_view content) {
  begin_tag(name, attributes);
  (out_ += '>') += xml_escaped(content);
  ((out_ += "</") += name) += ">\n";
}

void SvgWriter::text(Attributes attributes, const std::vector<Run>& runs) {
  begin_tag("text", attributes);
  out_ += " xml:space=\"preserve\">";
  double down = 0;
  for (const Run& run : runs) {
    begin_tag("tspan", {{"dy", run.down - std::exchange(down, run.down)}, {"font-size", run.size}});
    if (run.apart > 0) out_ += fmt::format(" dx=\"{}\"", svg_number(run.apart));
    ((out_ += '>') += xml_escaped(run.text)) += "</tspan>";
  }
  out_ += "</text>\n";
}

std::string SvgWriter::finish() && {
  while (!open_.empty()) {
    out_ += fmt::format("</{}>\n", open_.back());
    open_.pop_back();
  }
  return std::move(out_);
}

}  // namespace higherpair
