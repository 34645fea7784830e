#include "column_set.hpp"

#include "higherpair/front/motion.hpp"
#include "higherpair/io/diagnostic.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "number_texts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/core.h>

namespace higherpair {
namespace {

void append_number(double value, std::string& out) {
  std::array<char, NumberTexts::kLongest> text;
  out.append(text.data(), put_shortest(value == 0 ? 0.0 : value, text.data()));
}

}  // namespace

const std::string* repeated(const std::vector<std::string>& names) {
  std::vector<const std::string*> sorted;
  for (const std::string& name : names) {
    sorted.push_back(&name);
  }
  const auto less = [](const std::string* a, const std::string* b) { return *a < *b; };
  std::stable_sort(sorted.begin(), sorted.end(), less);
  const auto found = std::adjacent_find(sorted.begin(), sorted.end(),
                                        [](const std::string* a, const std::string* b) { return *a == *b; });
  return found == sorted.end() ? nullptr : *found;
}

bool matches(std::string_view glob, std::string_view name) {
  std::size_t star = std::string_view::npos;  // the last `*` met, and the end of the text it matches
  std::size_t star_end = 0;
  std::size_t g = 0;
  std::size_t n = 0;
  while (n < name.size()) {
    if (g < glob.size() && glob[g] == '*') {
      star = g++;
      star_end = n;
    } else if (g < glob.size() && (glob[g] == '?' || glob[g] == name[n])) {
      ++g;
      ++n;
    } else if (star != std::string_view::npos) {
      g = star + 1;
      n = ++star_end;
    } else {
      return false;
    }
  }
  return glob.find_first_not_of('*', g) == std::string_view::npos;
}

ColumnSet::ColumnSet(const Units& units, std::vector<std::string> globs)
    : units_(units), globs_(std::move(globs)), glob_matches_(globs_.size(), false) {}

void ColumnSet::add(const std::vector<NewColumn>& columns, Fill fill, bool anywhere) {
  Block block{std::move(fill), anywhere, names_.size(), names_.size() + columns.size(), false};
  for (const NewColumn& column : columns) {
    bool chosen = globs_.empty();
    for (std::size_t i = 0; i < globs_.size(); ++i) {
      if (matches(globs_[i], column.name)) {
        glob_matches_[i] = true;
        chosen = true;
      }
    }
    if (chosen) {
      const bool plain = column.in_profile_units || !column.words.empty();
      block.chosen = true;
      dimensions_.push_back(column.dimension);
      places_.push_back({names_.size(), plain ? Scaling() : from_si(column.dimension, units_)});
      columns_.push_back({column.name,
                          column.words.empty() ? std::string(unit_text(column.dimension, units_)) : "",
                          column.words});
    }
    names_.push_back(column.name);
  }
  if (block.chosen) {
    blocks_.push_back(std::move(block));
  }
}

tl::expected<void, Diagnostic> ColumnSet::finish(const std::string& source) {
  if (const std::string* name = repeated(names_)) {
    return tl::unexpected(
        about(source, "two columns would be called '" + *name +
                          "': rename one of the bodies, points, joints, contacts or drivers that share this "
                          "name"));
  }
  const auto unmatched = std::find(glob_matches_.begin(), glob_matches_.end(), false);
  if (unmatched != glob_matches_.end()) {
    const std::string& glob = globs_[unmatched - glob_matches_.begin()];
    const bool is_end = std::any_of(names_.begin(), names_.end(),
                                    [&](const std::string& name) { return name.ends_with("." + glob); });
    return tl::unexpected(about("setting columns " + glob,
                                "no column of this run has such a name; " +
                                    (is_end ? "did you mean `*." + glob + "`?" : suggestion(glob, names_))));
  }
  buffer_.resize(names_.size());
  return {};
}

void ColumnSet::fill(const RowSource& source, std::vector<double>& values) {
  const bool assembled = source.run.row.status != RowStatus::kNotAssemblable;
  for (const Block& block : blocks_) {
    std::fill(buffer_.begin() + static_cast<std::ptrdiff_t>(block.begin),
              buffer_.begin() + static_cast<std::ptrdiff_t>(block.end), kNoValue);
    if (assembled || block.anywhere) {
      block.fill(source, buffer_.data() + block.begin);
    }
  }
  values.resize(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double value = places_[i].scale.apply(buffer_[places_[i].slot]);
    values[i] = std::isfinite(value) ? value : kNoValue;
  }
}

std::string_view word_of(const Column& column, double value) {
  const bool is_word = value >= 0 && value < static_cast<double>(column.words.size());
  return is_word ? column.words[static_cast<std::size_t>(value)] : std::string_view();
}

std::size_t column_slot(const std::vector<Column>& columns, std::string_view name) {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
  return static_cast<std::size_t>(found - columns.begin());
}

std::string csv_head(const Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{}[{}]", column.name, column.unit);
}

void append_csv_text(std::string_view text, std::string& out) {
  if (text.find_first_of(",\"\n\r") == std::string_view::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    out += c;
    if (c == '"') out += c;
  }
  out += '"';
}

void append_csv_header(const std::vector<Column>& columns, std::string& out) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    out += i > 0 ? "," : "";
    out += csv_head(columns[i]);
  }
  out += '\n';
}

void append_csv_cells(std::span<const Column> columns, std::span<const double> values, std::string& out) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0) {
      out += ',';
    }
    if (!columns[i].words.empty()) {
      out += word_of(columns[i], values[i]);
    } else if (!std::isnan(values[i])) {
      append_number(values[i], out);
    }
  }
}

void append_csv_rows(const std::vector<Column>& columns, const RowBlock& block, std::string& out) {
  NumberTexts numbers;
  std::size_t longest = 1;  // of a line
  for (const Column& column : columns) {
    std::size_t cell = NumberTexts::kLongest;
    for (const std::string_view word : column.words) cell = std::max(cell, word.size());
    longest += cell + 1;
  }
  std::string line(longest + NumberTexts::kLongest, '\0');
  for (std::size_t i = 0; i < block.size(); ++i) {
    const std::span<const double> values = block.row(i);
    char* end = line.data();
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (!columns[k].words.empty()) {
        const std::string_view word = word_of(columns[k], values[k]);
        end = std::copy(word.begin(), word.end(), end);
      } else if (!std::isnan(values[k])) {
        end = numbers.put(values[k], end);
      }
      *end++ = k + 1 < columns.size() ? ',' : '\n';
    }
    out.append(line.data(), end);
  }
}

void append_csv_row(const std::vector<Column>& columns, const Row& row, std::string& out) {
  append_csv_cells(columns, row.values, out);
  out += '\n';
}

}  // namespace higherpair
