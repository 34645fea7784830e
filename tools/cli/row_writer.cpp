#include "row_writer.hpp"

#include "json_text.hpp"

#include <charconv>
#include <cmath>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace higherpair::cli {

RowWriter::RowWriter(const std::string& path, Format format, const std::string& title,
                     const std::vector<Column>& columns)
    : format_(format), file_(std::make_unique<OutputFile>(path)), columns_(columns) {
  begin(title);
}

void RowWriter::begin(const std::string& title) {
  std::string head;
  if (format_ == Format::kCsv) {
    append_csv_header(columns_, head);
    file_->write(head);
    return;
  }
  head += "{\"format\": 1, \"title\": " + text_of(title) + ",\n\"columns\": [";
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const std::string unit = columns_[i].unit.empty() ? "null" : text_of(columns_[i].unit);
    head += (i > 0 ? ",\n  " : "\n  ") + ("{\"name\": " + text_of(columns_[i].name)) + ", \"unit\": " + unit +
            "}";
  }
  file_->write(head + "],\n\"rows\": [");
}

void RowWriter::append_json_row(const RowBlock& block, std::size_t row, std::string& out) const {
  const auto values = block.row(row);
  out += block.first == 0 && row == 0 ? "\n  [" : ",\n  [";
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    out += i > 0 ? ", " : "";
    const double value = values[i];
    if (std::isnan(value)) {
      out += "null";
    } else if (!columns_[i].words.empty()) {
      out += text_of(word_of(columns_[i], value));
    } else {
      char text[32];
      out.append(text, std::to_chars(text, text + sizeof text, value == 0 ? 0.0 : value).ptr);
    }
  }
  out += ']';
}

void RowWriter::append_text(const RowBlock& block, std::string& out) const {
  if (format_ == Format::kCsv) {
    append_csv_rows(columns_, block, out);
    return;
  }
  for (std::size_t row = 0; row < block.size(); ++row) {
    append_json_row(block, row, out);
  }
}

void RowWriter::end(const std::vector<Event>& events, bool good) {
  if (format_ == Format::kJson) {
    std::string tail = "],\n\"events\": [";
    for (std::size_t i = 0; i < events.size(); ++i) {
      const Event& event = events[i];
      const nlohmann::ordered_json json = {
          {"type", name_of(event.type)},
          {"driver", event.driver},
          {"time", event.time ? nlohmann::json(*event.time) : nlohmann::json()},
          {"item", event.item.empty() ? nlohmann::json() : nlohmann::json(event.item)},
          {"cause", event.cause}};
      tail += (i > 0 ? ",\n  " : "\n  ") + text_of(json);
    }
    file_->write(tail + fmt::format("],\n\"ok\": {}}}\n", good));
  }
  file_->finish();
}

}  // namespace higherpair::cli
