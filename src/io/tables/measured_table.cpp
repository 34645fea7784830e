#include "higherpair/io/measured_table.hpp"

#include "csv_fields.hpp"
#include "higherpair/io/names.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "io/document/encoding.hpp"
#include "io/document/text_file.hpp"
#include "io/units/unit_table.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

using io_detail::trimmed;
using io_detail::visible;

constexpr std::size_t kMostTableMistakes = 5;
constexpr std::size_t kMostColumns = 5000;

tl::unexpected<Error> refused(Diagnostics mistakes) {
  return tl::unexpected(Error{ErrorKind::kInput, std::move(mistakes)});
}

bool is_missing(std::string_view field) {
  const auto is = [&](std::string_view word) { return io_detail::same_letters(field, word); };
  return field.empty() || is("nan") || is("na") || is("null");
}

class MeasuredReader {
public:
  MeasuredReader(const std::string& source, const std::vector<std::string>& names) : names_(names) {
    table_.source = source;
  }

  void line(std::string_view text, int number) {
    const bool refused = separator_ != 0 && table_.columns.empty();  // at its header
    if (refused || mistakes_.size() >= kMostTableMistakes) return;
    if (separator_ == 0) {
      separator_ = io_detail::separator_of(trimmed(text));
      if (has_no_header(text)) {
        for (const std::string& name : names_) table_.columns.push_back({name, "", {}, {}, {}});
        row(text, number);
      } else {
        header(text, number);
      }
    } else {
      row(text, number);
    }
  }

  Result<MeasuredTable> finish() {
    if (mistakes_.empty() && table_.lines.empty()) {
      mistakes_.push_back(about(table_.source, "has no rows below a line that names the columns"));
    }
    if (!mistakes_.empty()) {
      return refused(std::move(mistakes_));
    }
    return std::move(table_);
  }

private:
  [[nodiscard]] Place place(std::string_view line, std::string_view field, int number) const {
    const std::string_view before = line.substr(0, static_cast<std::size_t>(field.data() - line.data()));
    return {table_.source, number, io_detail::mark_at(before, before.size()).column};
  }

  [[nodiscard]] bool has_no_header(std::string_view line) const {
    const std::vector<std::string_view> fields = io_detail::fields_of(line, separator_);
    return fields.size() == names_.size() &&
           std::all_of(fields.begin(), fields.end(),
                       [](std::string_view field) { return io_detail::number_in(field).has_value(); });
  }

  void fail(const Place& place, std::string message) { mistakes_.push_back({place, std::move(message)}); }

  void header(std::string_view line, int number) {
    const std::vector<std::string_view> fields = io_detail::fields_of(line, separator_);
    if (fields.size() > kMostColumns) {
      fail({table_.source, number, 1},
           fmt::format("has {} columns, and at most {} are read: leave out those that are not to be fitted",
                       fields.size(), kMostColumns));
      return;
    }
    std::set<std::string> names;
    for (const std::string_view field : fields) {
      if (mistakes_.size() >= kMostTableMistakes) return;
      const std::size_t open = field.find('[');
      MeasuredColumn column;
      column.name = trimmed(field.substr(0, open));
      column.place = place(line, field, number);
      if (io_detail::number_in(field)) {
        fail(column.place,
             fmt::format("`{}`: the first line has to name the columns, such as driver,slider.x[mm]",
                         visible(field)));
        return;
      }
      if (open != std::string_view::npos) {
        if (!field.ends_with(']')) {
          fail(column.place, fmt::format("`{}`: the unit has no closing bracket", visible(field)));
          continue;
        }
        column.unit = trimmed(field.substr(open + 1, field.size() - open - 2));
      }
      if (!names.insert(column.name).second) {
        fail(column.place, fmt::format("`{}`: two columns have this name", visible(column.name)));
      }
      table_.columns.push_back(std::move(column));
    }
  }

  void row(std::string_view line, int number) {
    const std::vector<std::string_view> fields = io_detail::fields_of(line, separator_);
    if (fields.size() != table_.columns.size()) {
      fail({table_.source, number, 1},
           fmt::format("expected {} fields, found {}{}", table_.columns.size(), fields.size(),
                       io_detail::comma_advice(separator_, fields.size(), table_.columns.size())));
      return;
    }
    table_.lines.push_back(number);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      MeasuredColumn& column = table_.columns[i];
      const auto value = io_detail::number_in(fields[i]);
      column.values.push_back(value.value_or(kNoValue));
      if (value || is_missing(fields[i]) || column.mistake) continue;
      column.mistake = {place(line, fields[i], number), io_detail::no_number(fields[i], column.name)};
    }
  }

  const std::vector<std::string>& names_;
  MeasuredTable table_;
  Diagnostics mistakes_;
  char separator_ = 0;
};

}  // namespace

Result<MeasuredTable> read_measured_text(std::string_view text, const std::string& source,
                                         const std::vector<std::string>& names) {
  if (const auto mistake = io_detail::encoding_mistake(text)) {
    return refused({{{source, mistake->mark.line, mistake->mark.column}, mistake->message}});
  }
  MeasuredReader reader(source, names);
  const std::string plain = io_detail::with_plain_blanks(text);
  io_detail::for_each_line(plain, [&](std::string_view line, int number) { reader.line(line, number); });
  return reader.finish();
}

Result<MeasuredTable> read_measured_file(const std::string& path, const std::vector<std::string>& names) {
  const auto text = io_detail::read_text_file(path, "table");
  if (!text) {
    return refused({about(path, text.error())});
  }
  return read_measured_text(*text, path, names);
}

tl::expected<double, std::string> factor_between(const std::string& header, const std::string& unit,
                                                 const Units& units) {
  const auto own = io_detail::parse_unit(unit);
  if (!own || unit_text(own->dimension, units) != unit) {
    return header == unit ? tl::expected<double, std::string>(1.0)
                          : tl::unexpected(fmt::format("expected the unit of the column, {}", unit));
  }
  return io_detail::scalings_of(header, own->dimension, units).map([](const io_detail::UnitScalings& one) {
    return one.to_profile.apply(1);
  });
}

}  // namespace higherpair
