#include "row_writer.hpp"

#include <charconv>

#include <nlohmann/json.hpp>

namespace higherpair::cli {
namespace {

std::string json_text(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

RowWriter::RowWriter(const std::string& path, Format format)
    : format_(format), file_(std::make_unique<OutputFile>(path)) {}

void RowWriter::flush(std::size_t limit) {
  if (buffer_.size() < limit) {
    return;
  }
  file_->write(buffer_);
  buffer_.clear();
}

void RowWriter::begin(const std::string& title, const std::vector<Column>& columns) {
  if (format_ == Format::kCsv) {
    append_csv_header(columns, buffer_);
    return;
  }
  buffer_ += "{\"format\": 1, \"title\": " + json_text(title) + ",\n\"columns\": [";
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string unit = columns[i].unit.empty() ? "null" : json_text(columns[i].unit);
    buffer_ += (i > 0 ? ",\n  " : "\n  ") + ("{\"name\": " + json_text(columns[i].name)) +
               ", \"unit\": " + unit + "}";
  }
  buffer_ += "],\n\"rows\": [";
}

void RowWriter::append_json_row(const std::vector<Cell>& cells) {
  buffer_ += first_row_ ? "\n  [" : ",\n  [";
  first_row_ = false;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) {
      buffer_ += ", ";
    }
    if (const auto* number = std::get_if<double>(&cells[i])) {
      char text[32];
      buffer_.append(text, std::to_chars(text, text + sizeof text, *number == 0 ? 0.0 : *number).ptr);
    } else if (const auto* word = std::get_if<std::string_view>(&cells[i])) {
      buffer_ += json_text(*word);
    } else {
      buffer_ += "null";
    }
  }
  buffer_ += ']';
}

void RowWriter::row(const std::vector<Cell>& cells) {
  if (format_ == Format::kCsv) {
    append_csv_row(cells, buffer_);
  } else {
    append_json_row(cells);
  }
  flush(1 << 16);
}

void RowWriter::end(const std::vector<Event>& events) {
  if (format_ == Format::kJson) {
    buffer_ += "],\n\"events\": [";
    for (std::size_t i = 0; i < events.size(); ++i) {
      const Event& event = events[i];
      const nlohmann::ordered_json json = {
          {"type", event.type},
          {"driver", event.driver},
          {"time", event.time ? nlohmann::json(*event.time) : nlohmann::json()},
          {"item", event.item.empty() ? nlohmann::json() : nlohmann::json(event.item)},
          {"cause", event.cause}};
      buffer_ += (i > 0 ? ",\n  " : "\n  ") + json.dump();
    }
    buffer_ += "]}\n";
  }
  flush(0);
  file_->finish();
}

}  // namespace higherpair::cli
