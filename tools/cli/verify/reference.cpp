#include "verify/reference.hpp"

#include "higherpair/higherpair.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <utility>
#include <variant>

#include <fmt/core.h>
#include <tl/expected.hpp>

namespace higherpair::cli {
namespace {

constexpr double kSmallestColumn = 1e-6;  // relative to the largest value of the same unit: less is rounding

template <class T>
using Or = tl::expected<T, std::string>;

// A number, a word of a column without a unit, or an empty field.
using Wanted = std::variant<std::monostate, double, std::string>;

struct Expected {
  std::vector<std::string> head;
  std::vector<std::vector<Wanted>> rows;
};

std::string_view cut(std::string_view& text, char at) {
  const std::size_t end = std::min(text.find(at), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

std::vector<std::string_view> words_of(std::string_view line) {
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  std::vector<std::string_view> words;
  bool more = true;
  while (more) {
    more = line.find(',') != std::string_view::npos;
    words.push_back(cut(line, ','));
  }
  return words;
}

Or<Wanted> wanted(std::string_view word, const std::string& head) {
  if (word.empty()) {
    return Wanted();
  }
  if (!head.ends_with(']')) {
    return Wanted(std::string(word));
  }
  double number = 0;
  const char* end = word.data() + word.size();
  const auto [rest, status] = std::from_chars(word.data(), end, number);
  if (rest != end || status != std::errc() || !std::isfinite(number)) {
    return tl::unexpected(fmt::format("'{}' is no number", word));
  }
  return Wanted(number);
}

Or<Expected> read_table(std::string_view text) {
  Expected table;
  for (const std::string_view word : words_of(cut(text, '\n'))) {
    table.head.emplace_back(word);
  }
  while (!text.empty()) {
    const std::vector<std::string_view> words = words_of(cut(text, '\n'));
    std::vector<Wanted>& row = table.rows.emplace_back();
    if (words.size() != table.head.size()) {
      return tl::unexpected(fmt::format("table row {}: {} fields, but {} columns", table.rows.size(),
                                        words.size(), table.head.size()));
    }
    for (std::size_t i = 0; i < words.size(); ++i) {
      auto cell = wanted(words[i], table.head[i]);
      if (!cell) {
        return tl::unexpected(fmt::format("table row {}: {}", table.rows.size(), cell.error()));
      }
      row.push_back(*std::move(cell));
    }
  }
  if (table.head.size() < 2 || table.rows.empty()) {
    return tl::unexpected(std::string("the table needs a head with two columns or more, and a row"));
  }
  return table;
}

// The indices of the expected columns among those of the run.
Or<std::vector<std::size_t>> match(const Expected& expected, const std::vector<Column>& columns) {
  std::vector<std::size_t> places;
  for (const std::string& head : expected.head) {
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return csv_head(c) == head; });
    if (found == columns.end()) {
      return tl::unexpected(fmt::format("there is no column {}", head));
    }
    places.push_back(static_cast<std::size_t>(found - columns.begin()));
  }
  return places;
}

std::string first_of(const Error& error) {
  return to_string(error.diagnostics.front());
}

std::string_view unit_of(std::string_view head) {
  return head.substr(std::min(head.find('['), head.size()));
}

// The largest value of each column, but not less than a small fraction of the largest value of the same unit:
// a column may contain nothing but rounding (a joint at rest).
std::vector<double> scales(const Expected& expected) {
  std::vector<double> scale(expected.head.size(), 0);
  for (const auto& row : expected.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double* number = std::get_if<double>(&row[i]);
      scale[i] = std::max(scale[i], number == nullptr ? 0 : std::abs(*number));
    }
  }
  const std::vector<double> own = scale;
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (unit_of(expected.head[i]) == unit_of(expected.head[k])) {
        scale[i] = std::max(scale[i], kSmallestColumn * own[k]);
      }
    }
  }
  std::replace(scale.begin(), scale.end(), 0.0, 1.0);
  return scale;
}

Wanted cell_of(const Column& column, double value) {
  if (std::isnan(value)) {
    return {};
  }
  return column.words.empty() ? Wanted(value) : Wanted(std::string(word_of(column, value)));
}

std::string wanted_text(const Wanted& wanted) {
  if (const auto* number = std::get_if<double>(&wanted)) {
    return fmt::format("{}", *number);
  }
  const auto* word = std::get_if<std::string>(&wanted);
  return word == nullptr ? "empty" : *word;
}

// Whether both are numbers, or the same word, or both undefined.
bool is_alike(const Wanted& cell, const Wanted& wanted) {
  return std::holds_alternative<std::string>(wanted) ? cell == wanted : cell.index() == wanted.index();
}

// Compares a row; returns the reason if its cells are not even of the same kind.
std::string compare(const Expected& expected, const std::vector<double>& scale, std::size_t k,
                    const std::vector<Wanted>& cells, std::vector<ColumnCheck>& checks) {
  const double* key = std::get_if<double>(&cells.front());
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const Wanted& wanted = expected.rows[k][i];
    if (!is_alike(cells[i], wanted)) {
      return fmt::format("row {}: {} is {}, expected {}", k + 1, expected.head[i], wanted_text(cells[i]),
                         wanted_text(wanted));
    }
    if (const double* number = std::get_if<double>(&cells[i])) {
      const double right = std::get<double>(wanted);
      const double error = std::abs(*number - right) / scale[i];
      if (checks[i].column.empty() || !(error <= checks[i].error)) {
        checks[i] = {expected.head[i], key == nullptr ? 0 : *key, *number, right, error};
      }
    }
  }
  return "";
}

Or<std::vector<ColumnCheck>> compare(const Expected& expected, Analysis& analysis) {
  const auto places = match(expected, analysis.columns());
  if (!places) {
    return tl::unexpected(places.error());
  }
  if (analysis.size() != static_cast<std::int64_t>(expected.rows.size())) {
    return tl::unexpected(fmt::format("{} rows, expected {}", analysis.size(), expected.rows.size()));
  }
  const std::vector<double> scale = scales(expected);
  const bool says_status =
      std::find(expected.head.begin(), expected.head.end(), "status") != expected.head.end();
  std::vector<ColumnCheck> checks(expected.head.size());
  Row row;
  for (std::size_t k = 0; analysis.next(row); ++k) {
    if (!says_status && row.status != RowStatus::kOk) {
      return tl::unexpected(fmt::format("row {} is {}", k + 1, name_of(row.status)));
    }
    std::vector<Wanted> cells;
    for (const std::size_t place : *places) {
      cells.push_back(cell_of(analysis.columns()[place], row.values[place]));
    }
    if (std::string reason = compare(expected, scale, k, cells, checks); !reason.empty()) {
      return tl::unexpected(std::move(reason));
    }
  }
  // Residuals are rounding errors, which differ between machines; words have no error.
  std::erase_if(checks, [](const ColumnCheck& check) {
    return check.column.empty() || check.column.starts_with("residual[");
  });
  return checks;
}

Or<std::vector<ColumnCheck>> compare(const Model& model, std::string_view table) {
  const auto expected = read_table(table);
  if (!expected) {
    return tl::unexpected(expected.error());
  }
  RunSettings settings;
  settings.in_time = std::any_of(expected->head.begin(), expected->head.end(),
                                 [](const std::string& head) { return head.starts_with("time["); });
  auto analysis = model.start(settings);
  if (!analysis) {
    return tl::unexpected(first_of(analysis.error()));
  }
  return compare(*expected, *analysis);
}

}  // namespace

const ColumnCheck& Verdict::worst() const {
  return *std::max_element(columns.begin(), columns.end(),
                           [](const auto& a, const auto& b) { return a.error < b.error; });
}

bool Verdict::holds(double bound) const {
  return failure.empty() && !columns.empty() &&
         std::all_of(columns.begin(), columns.end(), [&](const auto& c) { return c.error <= bound; });
}

Verdict verify(const Reference& reference) {
  Verdict verdict;
  const auto start = std::chrono::steady_clock::now();
  const auto model = Model::from_text(reference.profile, std::string(reference.name));
  if (!model) {
    verdict.title = reference.name;
    verdict.failure = first_of(model.error());
    return verdict;
  }
  verdict.title = model->mechanism().title.empty() ? reference.name : model->mechanism().title;
  verdict.source = model->mechanism().description;
  auto columns = compare(*model, reference.table);
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!columns) {
    verdict.failure = columns.error();
    return verdict;
  }
  verdict.columns = *std::move(columns);
  return verdict;
}

}  // namespace higherpair::cli
