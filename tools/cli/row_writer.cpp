#include "row_writer.hpp"

#include <charconv>
#include <cmath>

#include <fmt/format.h>
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
  columns_ = columns;
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

void RowWriter::append_json_row(const Row& row) {
  buffer_ += row.number == 0 ? "\n  [" : ",\n  [";
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    buffer_ += i > 0 ? ", " : "";
    const double value = row.values[i];
    if (std::isnan(value)) {
      buffer_ += "null";
    } else if (!columns_[i].words.empty()) {
      buffer_ += json_text(word_of(columns_[i], value));
    } else {
      char text[32];
      buffer_.append(text, std::to_chars(text, text + sizeof text, value == 0 ? 0.0 : value).ptr);
    }
  }
  buffer_ += ']';
}

void RowWriter::row(const Row& row) {
  if (format_ == Format::kCsv) {
    append_csv_row(columns_, row, buffer_);
  } else {
    append_json_row(row);
  }
  flush(1 << 16);
}

void RowWriter::end(const std::vector<Event>& events, bool good) {
  if (format_ == Format::kJson) {
    buffer_ += "],\n\"events\": [";
    for (std::size_t i = 0; i < events.size(); ++i) {
      const Event& event = events[i];
      const nlohmann::ordered_json json = {
          {"type", name_of(event.type)},
          {"driver", event.driver},
          {"time", event.time ? nlohmann::json(*event.time) : nlohmann::json()},
          {"item", event.item.empty() ? nlohmann::json() : nlohmann::json(event.item)},
          {"cause", event.cause}};
      buffer_ += (i > 0 ? ",\n  " : "\n  ") + json.dump();
    }
    buffer_ += fmt::format("],\n\"ok\": {}}}\n", good);
  }
  flush(0);
  file_->finish();
}

}  // namespace higherpair::cli
