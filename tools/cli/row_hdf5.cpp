#include "row_hdf5.hpp"

#include <limits>
#include <utility>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

// An attribute is limited to 64 KiB; the tables contain all events.
constexpr std::size_t kLongestAttribute = 60000;

std::string attribute_of(const std::vector<std::string>& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (text.size() + lines[i].size() > kLongestAttribute) {
      return text + fmt::format("and {} more\n", lines.size() - i);
    }
    text += lines[i] + "\n";
  }
  return text;
}

}  // namespace

RowHdf5::RowHdf5(const std::string& path, RowTitle title, const std::vector<Column>& columns,
                 std::int64_t rows)
    : title_(std::move(title)),
      file_(std::make_unique<OutputFile>(path)),
      data_(create_hdf5(file_->place())) {
  data_->set_attribute("title", title_.title);
  data_->set_attribute("profile", title_.profile);
  rows_ = data_->add_table("", {columns, {}, {}, rows});
  check();
}

void RowHdf5::check() {
  if (file_->good() && !data_->error().empty()) file_->fail_because(data_->error());
}

void RowHdf5::write(const RowBlock& block) {
  data_->append(rows_, block.values, {});
  check();
}

void RowHdf5::end(const std::vector<Event>& events, const std::vector<std::string>& lines, bool good) {
  data_->set_attribute("ok", good ? "yes" : "no");
  data_->set_attribute("events", attribute_of(lines));
  const std::vector<Column> columns = {
      {"driver", title_.driver_unit, {}}, {"time", title_.time_unit, {}}, {"row", "1", {}}};
  const std::size_t table = data_->add_table(
      "events", {columns, {"row"}, {"type", "item", "cause"}, static_cast<std::int64_t>(events.size())});
  std::vector<double> values;
  std::vector<std::string> types;
  std::vector<std::string> items;
  std::vector<std::string> causes;
  for (const Event& event : events) {
    values.insert(values.end(), {event.driver, event.time.value_or(std::numeric_limits<double>::quiet_NaN()),
                                 static_cast<double>(event.row)});
    types.emplace_back(name_of(event.type));
    items.push_back(event.item);
    causes.push_back(event.cause);
  }
  data_->append(table, values, {types, items, causes});
  data_->close();
  check();
  file_->finish();
}

}  // namespace higherpair::cli
